//! Joints: what holds two bodies, or a body and the world, together.
//!
//! A joint is given by a point of the world at the start, its anchor, which stays one point of both bodies. A joint
//! between bodies that no force moves, or of a body with itself, is refused. One of two bodies may be kinematic: it
//! drives the other one, and its work is in the ledger. Jointed bodies do not collide with each other.

use super::freedom::{Coordinate, Freedom, Limits, LimitsError};
use super::strength::Strength;
use super::track::{TrackEnds, TrackHold, TrackId};
use crate::identity::body_id::BodyId;
use polhode_spatial::{DVec3, UnitVector};

/// What a joint leaves free.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum JointKind {
    /// All rotations about the anchor.
    Ball,
    /// Rotation about one axis through the anchor.
    Hinge {
        /// The axis at the start, world.
        axis: UnitVector,
    },
    /// Rotations about two axes through the anchor, at right angles: a Cardan joint.
    Universal {
        /// The axes at the start, world: the first is fixed in the body, the second in the other one or in the world.
        axes: [UnitVector; 2],
    },
    /// Nothing: the bodies move as one.
    Fixed,
    /// Displacement along an axis through the anchor.
    Slider {
        /// The axis at the start, world, fixed in the other body or in the world.
        axis: UnitVector,
    },
    /// Rotation about an axis through the anchor and displacement along it.
    Cylindrical {
        /// The axis at the start, world, fixed in the other body or in the world.
        axis: UnitVector,
    },
    /// Rotation about an axis through the anchor, with a displacement along it that goes with the rotation.
    Screw {
        /// The axis at the start, world, fixed in the other body or in the world.
        axis: UnitVector,
        /// The displacement for each revolution, m: positive for a right-handed thread.
        lead: f64,
    },
    /// Displacements in a plane through the anchor and rotation about its normal.
    Planar {
        /// The normal of the plane at the start, world. The plane is fixed in the other body or in the world.
        normal: UnitVector,
    },
    /// All motions that keep the distance of the anchor of the body from one of the other body, or of the world: a rod
    /// without mass.
    Rod {
        /// The anchor of the other body at the start, world, m.
        to: DVec3,
    },
    /// All motions. What limits the distance of its anchors ([`Coordinate::Distance`]) is a rope without mass.
    Rope {
        /// The anchor of the other body at the start, world, m.
        to: DVec3,
    },
    /// Displacement along a curve that is fixed in the other body or in the world, and all rotations about the anchor.
    Track {
        /// The curve, world at the start.
        track: TrackId,
        /// How it holds the anchor.
        hold: TrackHold,
        /// What happens at its ends, if it is open.
        ends: TrackEnds,
    },
}

impl JointKind {
    /// Its name in scene files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ball => "ball",
            Self::Hinge { .. } => "hinge",
            Self::Universal { .. } => "universal",
            Self::Fixed => "fixed",
            Self::Slider { .. } => "slider",
            Self::Cylindrical { .. } => "cylindrical",
            Self::Screw { .. } => "screw",
            Self::Planar { .. } => "planar",
            Self::Rod { .. } => "rod",
            Self::Rope { .. } => "rope",
            Self::Track { .. } => "track",
        }
    }

    /// Whether a track holds the anchor.
    pub(crate) const fn is_on_track(self) -> bool {
        matches!(self, Self::Track { .. })
    }

    /// The axis of its coordinates at the start, world.
    pub(crate) const fn axis(self) -> Option<UnitVector> {
        match self {
            Self::Hinge { axis } | Self::Slider { axis } | Self::Cylindrical { axis } | Self::Screw { axis, .. } => {
                Some(axis)
            }
            _ => None,
        }
    }

    /// The coordinates along which it leaves its bodies free, those that can have limits.
    pub const fn coordinates(self) -> &'static [Coordinate] {
        match self {
            Self::Hinge { .. } | Self::Screw { .. } => &[Coordinate::Angle],
            Self::Slider { .. } | Self::Track { .. } => &[Coordinate::Displacement],
            Self::Cylindrical { .. } => &[Coordinate::Angle, Coordinate::Displacement],
            Self::Rope { .. } => &[Coordinate::Distance],
            Self::Ball | Self::Universal { .. } | Self::Fixed | Self::Planar { .. } | Self::Rod { .. } => &[],
        }
    }
}

/// A joint of a body with the world or with another body.
///
/// ```
/// use polhode::mesh::solid_box;
/// use polhode::scene::Joint;
/// use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
/// use polhode::{Body, Scene, Simulation};
/// // Two rods of 1 m hang at each other, the upper one at the origin, and are let go level: a double pendulum.
/// let rod = |name: &str, x: f64| -> Result<Body, Box<dyn std::error::Error>> {
///     let size = DVec3::new(1.0, 0.02, 0.02);
///     Ok(Body::movable(name, solid_box(size, Mass::new(1.0)?)?).pose(Pose::from_translation(DVec3::X * x)))
/// };
/// let mut builder = Scene::builder("double pendulum");
/// let [upper, lower] = [builder.add_body(rod("upper", 0.5)?), builder.add_body(rod("lower", 1.5)?)];
/// let scene = builder
///     .joint(Joint::hinge(upper, DVec3::ZERO, UnitVector::Y))
///     .joint(Joint::hinge(upper, DVec3::X, UnitVector::Y).with(lower))
///     .build()?;
/// let mut simulation = Simulation::new(&scene)?;
/// simulation.advance_to(0.5)?;
/// assert!(simulation.body(upper).pose.translation.z < -0.4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    kind: JointKind,
    body: BodyId,
    other: Option<BodyId>,
    anchor: DVec3,
    freedoms: Freedoms,
    strength: Option<Strength>,
}

/// What acts along the coordinates of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Freedoms {
    angle: Option<Freedom>,
    displacement: Option<Freedom>,
    distance: Option<Freedom>,
}

impl Freedoms {
    const NONE: Self = Self { angle: None, displacement: None, distance: None };
}

impl Joint {
    /// A joint of this kind of a body with the world, at a point of the world (m) at the start.
    pub const fn new(kind: JointKind, body: BodyId, anchor: DVec3) -> Self {
        Self { kind, body, other: None, anchor, freedoms: Freedoms::NONE, strength: None }
    }

    /// A ball joint of a body with the world, at a point of the world (m) at the start.
    pub const fn ball(body: BodyId, anchor: DVec3) -> Self {
        Self::new(JointKind::Ball, body, anchor)
    }

    /// A hinge of a body with the world, through a point (m) along an axis, both world, at the start.
    pub const fn hinge(body: BodyId, anchor: DVec3, axis: UnitVector) -> Self {
        Self::new(JointKind::Hinge { axis }, body, anchor)
    }

    /// A rope of this length (m) from a point of a body to a point of the world (m), at the start. It holds them when
    /// taut.
    ///
    /// # Errors
    /// When the length is not positive.
    pub fn rope(body: BodyId, anchor: DVec3, to: DVec3, length: f64) -> Result<Self, LimitsError> {
        let limits = Limits::new(f64::NEG_INFINITY, length)?;
        Ok(Self::new(JointKind::Rope { to }, body, anchor).with_limits(Coordinate::Distance, limits))
    }

    /// The same joint with limits of one of its coordinates ([`JointKind::coordinates`]).
    pub fn with_limits(self, coordinate: Coordinate, limits: Limits) -> Self {
        let freedom = self.freedom(coordinate).unwrap_or_default();
        self.along(coordinate, freedom.with_limits(limits))
    }

    /// The same joint with what acts along one of its coordinates ([`JointKind::coordinates`]).
    pub const fn along(mut self, coordinate: Coordinate, freedom: Freedom) -> Self {
        match coordinate {
            Coordinate::Angle => self.freedoms.angle = Some(freedom),
            Coordinate::Displacement => self.freedoms.displacement = Some(freedom),
            Coordinate::Distance => self.freedoms.distance = Some(freedom),
        }
        self
    }

    /// What acts along a coordinate, if anything does.
    pub const fn freedom(&self, coordinate: Coordinate) -> Option<Freedom> {
        match coordinate {
            Coordinate::Angle => self.freedoms.angle,
            Coordinate::Displacement => self.freedoms.displacement,
            Coordinate::Distance => self.freedoms.distance,
        }
    }

    /// The same joint, which breaks at a load.
    pub const fn breaking_at(self, strength: Strength) -> Self {
        Self { strength: Some(strength), ..self }
    }

    /// The load at which it breaks, if any does.
    pub const fn strength(&self) -> Option<Strength> {
        self.strength
    }

    /// The limits of a coordinate, if it has any.
    pub(crate) fn limits(&self, coordinate: Coordinate) -> Option<Limits> {
        self.freedom(coordinate)?.limits()
    }

    /// The point of the world at which it holds the other body, or the world, at the start, m.
    pub const fn other_anchor(&self) -> DVec3 {
        match self.kind {
            JointKind::Rod { to } | JointKind::Rope { to } => to,
            _ => self.anchor,
        }
    }

    /// The same joint with another body in the place of the world.
    pub const fn with(self, other: BodyId) -> Self {
        Self { other: Some(other), ..self }
    }

    /// The same joint of these bodies, of one with the world where there is no other.
    pub const fn of(self, body: BodyId, other: Option<BodyId>) -> Self {
        Self { body, other, ..self }
    }

    /// The same joint at another point of the world at the start, m.
    pub(crate) const fn at(self, anchor: DVec3) -> Self {
        Self { anchor, ..self }
    }

    /// What it leaves free.
    pub const fn kind(&self) -> JointKind {
        self.kind
    }

    /// The body that it holds.
    pub const fn body(&self) -> BodyId {
        self.body
    }

    /// The other body; none for the world.
    pub const fn other(&self) -> Option<BodyId> {
        self.other
    }

    /// The point of the world at which it holds them at the start, m.
    pub const fn anchor(&self) -> DVec3 {
        self.anchor
    }

    /// The bodies that it holds together, but for the world.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = usize> {
        std::iter::once(self.body).chain(self.other).map(BodyId::index)
    }

    /// Whether it holds these two bodies together.
    pub(crate) fn joins(&self, a: usize, b: usize) -> bool {
        let (a, b) = (BodyId::new(a), BodyId::new(b));
        self.other.is_some_and(|other| (self.body, other) == (a, b) || (self.body, other) == (b, a))
    }
}
