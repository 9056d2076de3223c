//! What is drawn of joints, springs and tracks.
//!
//! | kind | drawn as |
//! |---|---|
//! | hinge, universal | a pin along each axis, longer than the body is thick there |
//! | ball | a ball at the anchor |
//! | slider | a rail along the axis, with a plate at each stop |
//! | cylindrical, screw | a round rail |
//! | planar | a disc in the plane |
//! | limits of an angle | an arc from stop to stop |
//! | track | a tube, with a ball where it holds a body |
//! | rod, rope, spring | a rod, a line that sags where it is slack, a coil |
//!
//! They are parts of bodies, or of the world, as bodies have parts: what is in front hides them. Their thickness
//! follows from the size of the smaller body.

use crate::mesh_library::{MeshKey, MeshLibrary};
use crate::shown_body::{JointEnd, ShownBody};
use crate::tessellation::tube::tube;
use crate::tessellation::{Detail, Part, parts};
use polhode::scene::{Attachment, Coordinate, Force, Joint, JointKind};
use polhode::spatial::{DVec3, Pose};
use polhode::{BodyId, Scene};
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

/// Radius of a pin, as a fraction of the size of the smaller body of the joint.
const PIN: f64 = 0.03;
/// How far a pin stands out of a body, in its radii.
const OVERHANG: f64 = 1.5;
/// Half the length of a pin at the most, and radius of the arc between stops, as fractions of the size of the body.
const LONGEST_PIN: f64 = 0.6;
const ARC: f64 = 0.3;
/// Half the length of a rail without stops, in sizes of the body.
const RAIL: f64 = 1.5;
/// Size of a body of which none is known, m.
const UNKNOWN_SIZE_M: f64 = 1.0;
/// Joints of a scene that are drawn at the most.
const MOST_JOINTS: usize = 5000;
/// Pieces of an arc of a half turn.
const ARC_PIECES: f64 = 24.0;
/// Pieces of a rope that sags; turns of a spring, and pieces of a turn.
const ROPE_PIECES: u32 = 16;
const SPRING_TURNS: u32 = 8;
const TURN_PIECES: u32 = 10;
/// Straight part of a spring at each end, and radius of its coil, as fractions of its length without force.
const SPRING_END: f64 = 0.1;
const COIL: f64 = 0.08;

/// Something that is drawn as a part of a body, or of the world.
#[derive(Debug, Clone)]
pub struct Fixture {
    /// Number of the body; none of the world.
    pub body: Option<usize>,
    /// What is drawn, in its frame.
    pub part: Part,
}

/// What stretches between two ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinkKind {
    /// A rod.
    Rod,
    /// A rope.
    Rope,
    /// A spring.
    Spring,
}

impl LinkKind {
    /// Its name in pages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rod => "rod",
            Self::Rope => "rope",
            Self::Spring => "spring",
        }
    }
}

/// A rod, a rope or a spring.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// Which.
    pub kind: LinkKind,
    /// Its ends.
    pub ends: [JointEnd; 2],
    /// Radius of what is drawn, m.
    pub radius_m: f64,
    /// Length of a rope that is taut, or of a spring without force, m.
    pub length_m: f64,
}

impl Link {
    /// Points along it from end to end (m); `up` points against gravity.
    pub fn points(&self, [a, b]: [DVec3; 2], up: DVec3) -> Vec<DVec3> {
        match self.kind {
            LinkKind::Rod => vec![a, b],
            LinkKind::Rope => {
                let apart = a.distance(b);
                // A parabola of sag h is longer than its chord d by 8 h^2 / (3 d).
                let sag = (0.375 * apart * (self.length_m - apart).max(0.0)).sqrt().min(0.5 * self.length_m);
                let pieces = if sag > 0.0 { ROPE_PIECES } else { 1 };
                let at = |t: f64| a + (b - a) * t - up * (4.0 * sag * t * (1.0 - t));
                (0..=pieces).map(|piece| at(f64::from(piece) / f64::from(pieces))).collect()
            }
            LinkKind::Spring => {
                let along = (b - a).try_normalize().unwrap_or(DVec3::Z);
                let across = along.any_orthonormal_vector();
                let other = along.cross(across);
                let pieces = SPRING_TURNS * TURN_PIECES;
                let coil = (0..=pieces).map(|piece| {
                    let share = f64::from(piece) / f64::from(pieces);
                    let angle = TAU * f64::from(SPRING_TURNS) * share;
                    let middle = a + (b - a) * (SPRING_END + (1.0 - 2.0 * SPRING_END) * share);
                    middle + (across * libm::cos(angle) + other * libm::sin(angle)) * (COIL * self.length_m)
                });
                std::iter::once(a).chain(coil).chain(std::iter::once(b)).collect()
            }
        }
    }
}

/// Joints, tracks and springs of a scene as they are drawn.
#[derive(Debug, Clone, Default)]
pub struct Fixtures {
    /// Parts of bodies and of the world.
    pub parts: Vec<Fixture>,
    /// What stretches between two ends.
    pub links: Vec<Link>,
    /// Places of the world that are drawn: anchors, ends of springs, points of tracks, m.
    pub places: Vec<DVec3>,
}

impl Fixtures {
    /// Those of a scene with these bodies; their meshes go into the library.
    pub(crate) fn new(scene: &Scene, bodies: &[ShownBody], library: &mut MeshLibrary) -> Self {
        let detail = Detail::for_bodies(bodies.len());
        let mut builder = Builder { scene, bodies, library, detail, made: Self::default(), tracks: BTreeSet::new() };
        for joint in scene.joints().iter().take(MOST_JOINTS) {
            builder.add_joint(joint);
        }
        for force in scene.forces() {
            if let Force::Spring { a, b, rest_length, .. } = force {
                builder.add_spring([*a, *b], *rest_length);
            }
        }
        builder.made
    }
}

struct Builder<'a> {
    scene: &'a Scene,
    bodies: &'a [ShownBody],
    library: &'a mut MeshLibrary,
    detail: Detail,
    made: Fixtures,
    /// Tracks that are drawn, and in which body they are.
    tracks: BTreeSet<(usize, Option<usize>)>,
}

impl Builder<'_> {
    fn add_joint(&mut self, joint: &Joint) {
        let (body, other) = (joint.body().index(), joint.other().map(BodyId::index));
        let size = self.size_of(std::iter::once(body).chain(other));
        let (anchor, r) = (joint.anchor(), PIN * size);
        if other.is_none() {
            self.made.places.push(joint.other_anchor());
        }
        match joint.kind() {
            JointKind::Hinge { axis } => {
                self.add_pin(body, anchor, axis.get(), r);
                self.add_arc(joint, axis.get(), size);
            }
            JointKind::Universal { axes } => {
                for axis in axes {
                    let half = axis.get() * (3.0 * r);
                    self.add_rod(Some(body), [anchor - half, anchor + half], r);
                }
            }
            JointKind::Ball => self.add_ball(Some(body), anchor, 1.5 * r),
            JointKind::Slider { axis } | JointKind::Cylindrical { axis } | JointKind::Screw { axis, .. } => {
                self.add_rail(joint, axis.get(), size);
            }
            JointKind::Planar { normal } => {
                let half = normal.get() * (0.2 * r);
                self.add_rod(other, [anchor - half, anchor + half], 4.0 * r);
            }
            JointKind::Rod { .. } => self.add_link(joint, LinkKind::Rod, 0.6 * r),
            JointKind::Rope { .. } => self.add_link(joint, LinkKind::Rope, 0.35 * r),
            JointKind::Track { track, .. } => {
                self.add_track(track.index(), other, r);
                self.add_ball(Some(body), anchor, 2.0 * r);
            }
            _ => {}
        }
    }

    /// Size of the smallest of some bodies, m.
    fn size_of(&self, bodies: impl Iterator<Item = usize>) -> f64 {
        let sizes = bodies.filter_map(|body| Some(self.bodies.get(body)?.size_m())).filter(|size| *size > 0.0);
        let least = sizes.fold(f64::INFINITY, f64::min);
        if least.is_finite() { least } else { UNKNOWN_SIZE_M }
    }

    fn pose(&self, body: Option<usize>) -> Pose {
        body.and_then(|body| self.bodies.get(body)).map_or(Pose::IDENTITY, |body| body.initial)
    }

    fn add_part(&mut self, body: Option<usize>, part: Part) {
        self.made.parts.push(Fixture { body, part });
    }

    /// A rod between two places of the world at the start.
    fn add_rod(&mut self, body: Option<usize>, ends: [DVec3; 2], radius_m: f64) {
        let pose = self.pose(body);
        let ends = ends.map(|end| pose.inverse_transform_point(end));
        let part = parts::rod(ends, radius_m, self.detail, self.library);
        self.add_part(body, part);
    }

    fn add_ball(&mut self, body: Option<usize>, place: DVec3, radius_m: f64) {
        let place = self.pose(body).inverse_transform_point(place);
        let part = parts::ball(place, radius_m, self.detail, self.library);
        self.add_part(body, part);
    }

    /// A pin along an axis, which stands out of the body.
    fn add_pin(&mut self, body: usize, anchor: DVec3, axis: DVec3, r: f64) {
        let (pose, shown) = (self.pose(Some(body)), &self.bodies[body]);
        let [place, along] = [pose.inverse_transform_point(anchor), pose.rotation.inverse().rotate(axis)];
        let reach = |along: DVec3| {
            let corners = shown.bounds.into_iter().flat_map(crate::extent::box_corners);
            let far = corners.map(|corner| (corner - place).dot(along)).fold(0.0, f64::max);
            (far + OVERHANG * r).clamp(2.0 * r, LONGEST_PIN * r / PIN)
        };
        let (back, ahead) = (reach(-along), reach(along));
        self.add_rod(Some(body), [anchor - axis * back, anchor + axis * ahead], r);
    }

    /// The arc of an angle between its stops, from where the body stands at the start.
    fn add_arc(&mut self, joint: &Joint, axis: DVec3, size: f64) {
        let Some(limits) = joint.freedom(Coordinate::Angle).and_then(|freedom| freedom.limits()) else { return };
        let [from, to] = [limits.lower().max(-PI), limits.upper().min(PI)];
        let body = &self.bodies[joint.body().index()];
        let arm = body.initial.transform_point(body.center_of_mass) - joint.anchor();
        let out = (arm - axis * arm.dot(axis)).try_normalize().unwrap_or(axis.any_orthonormal_vector());
        let side = axis.cross(out);
        let at = |angle: f64| joint.anchor() + (out * libm::cos(angle) + side * libm::sin(angle)) * (ARC * size);
        let pieces = (ARC_PIECES * (to - from) / PI).ceil().max(1.0) as u32;
        let points: Vec<DVec3> =
            (0..=pieces).map(|piece| at(from + (to - from) * f64::from(piece) / f64::from(pieces))).collect();
        let other = joint.other().map(BodyId::index);
        self.add_tube(other, &points, 0.25 * PIN * size);
        for (end, is_stop) in [(from, limits.lower() > -PI), (to, limits.upper() < PI)] {
            if is_stop {
                self.add_ball(other, at(end), 0.7 * PIN * size);
            }
        }
    }

    /// A rail, from stop to stop, with a plate at each stop.
    fn add_rail(&mut self, joint: &Joint, axis: DVec3, size: f64) {
        let limits = joint.freedom(Coordinate::Displacement).and_then(|freedom| freedom.limits());
        let (anchor, r, other) = (joint.anchor(), PIN * size, joint.other().map(BodyId::index));
        let lower = limits.map_or(f64::NEG_INFINITY, |limits| limits.lower());
        let upper = limits.map_or(f64::INFINITY, |limits| limits.upper());
        let [from, to] =
            [if lower.is_finite() { lower } else { -RAIL * size }, if upper.is_finite() { upper } else { RAIL * size }];
        let ends = [anchor + axis * (from - 0.5 * size), anchor + axis * (to + 0.5 * size)];
        self.add_rod(other, ends, 0.6 * r);
        if other.is_none() && limits.is_some() {
            self.made.places.extend(ends);
        }
        for (stop, outwards) in [(lower, -axis), (upper, axis)] {
            if stop.is_finite() {
                let place = anchor + axis * stop + outwards * (0.5 * size);
                self.add_rod(other, [place, place + outwards * (0.7 * r)], 3.0 * r);
            }
        }
    }

    fn add_tube(&mut self, body: Option<usize>, points: &[DVec3], radius_m: f64) {
        let pose = self.pose(body);
        let points: Vec<DVec3> = points.iter().map(|&point| pose.inverse_transform_point(point)).collect();
        let numbers = points.iter().flat_map(DVec3::to_array).chain(std::iter::once(radius_m));
        let mesh = self.library.number_of(MeshKey::new("tube", numbers), || tube(&points, radius_m));
        self.add_part(body, Part::of(mesh));
    }

    fn add_track(&mut self, track: usize, other: Option<usize>, r: f64) {
        let Some(curve) = self.scene.tracks().get(track) else { return };
        if !self.tracks.insert((track, other)) {
            return;
        }
        let points = curve.polyline();
        self.add_tube(other, &points, r);
        if other.is_none() {
            self.made.places.extend(points);
        }
    }

    fn add_link(&mut self, joint: &Joint, kind: LinkKind, radius_m: f64) {
        let (a, b) = (joint.anchor(), joint.other_anchor());
        let limits = joint.freedom(Coordinate::Distance).and_then(|freedom| freedom.limits());
        let length_m = limits.map(|limits| limits.upper()).filter(|upper| upper.is_finite()).unwrap_or(a.distance(b));
        let other = joint.other().map(BodyId::index);
        let ends = [self.end(Some(joint.body().index()), a), self.end(other, b)];
        self.made.links.push(Link { kind, ends, radius_m, length_m });
    }

    fn end(&self, body: Option<usize>, place: DVec3) -> JointEnd {
        JointEnd { body, point: self.pose(body).inverse_transform_point(place) }
    }

    fn add_spring(&mut self, ends: [Attachment; 2], rest_m: f64) {
        let ends = ends.map(|end| match end {
            Attachment::World(point) => JointEnd { body: None, point },
            Attachment::Body { body, point } => JointEnd { body: Some(body.index()), point },
        });
        let size = self.size_of(ends.iter().filter_map(|end| end.body));
        let [a, b] = ends.map(|end| self.pose(end.body).transform_point(end.point));
        self.made.places.extend(ends.iter().filter(|end| end.body.is_none()).map(|end| end.point));
        let length_m = if rest_m > 0.0 { rest_m } else { a.distance(b) };
        self.made.links.push(Link { kind: LinkKind::Spring, ends, radius_m: 0.4 * PIN * size.min(length_m), length_m });
    }
}
