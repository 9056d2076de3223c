//! Gears: coordinates of two joints that move together.
//!
//! With the coordinates `q_1` and `q_2` (rad of an angle, m otherwise), measured from the start, a gear keeps
//! `q_1 = r q_2`. Of two hinges `r` is the ratio of their rates: that of two wheels in mesh is `-n_2/n_1` with their
//! numbers of teeth, that of two pulleys under one belt `n_2/n_1`. Of a slider and a hinge (rack and pinion) it is a
//! length, the displacement for each radian; of two ropes -1 is one rope over a pulley without mass. The forces of a
//! gear act along both coordinates, `f` along the first one and `-r f` along the second one, do no work together, and
//! may have either sign: there is no play.
//!
//! Sources: Featherstone 2008, chapter 3 (constraints between joint coordinates). The convention, the first coordinate
//! from the second one, is that of MuJoCo (`equality/joint`), URDF (`mimic`) and Drake (`AddCouplerConstraint`).

use super::Coordinate;
use crate::identity::joint_id::JointId;
use thiserror::Error;

/// Why a gear is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum GearError {
    /// Its ratio is zero or not finite.
    #[error(
        "ratio of a gear is {0}: a finite number other than 0 is needed; with 0 the first joint would not move, which \
         a fixed joint says"
    )]
    Ratio(f64),
}

/// A gear: a coordinate of one joint that moves by a ratio times a coordinate of another one.
///
/// ```
/// use polhode::mesh::Cylinder;
/// use polhode::prelude::*;
/// use polhode::scene::Gear;
/// use polhode::spatial::Velocity;
/// // A wheel with 20 teeth drives one with 60 teeth: it turns three times as fast, the other way round.
/// let wheel = |name: &str, radius: f64, rate: f64| -> Result<Body, Box<dyn std::error::Error>> {
///     let body = Body::movable(name, Cylinder::new(radius, 0.02)?.solid(Mass::new(1.0)?)?);
///     Ok(body.velocity(Velocity::new(DVec3::ZERO, DVec3::Z * rate)))
/// };
/// let mut scene = Scene::builder("gear");
/// let small = scene.add_body(wheel("small", 0.1, 3.0)?);
/// let large = scene.add_body(wheel("large", 0.3, -1.0)?.pose(Pose::from_translation(DVec3::X * 0.4)));
/// let first = scene.add_joint(Joint::hinge(small, DVec3::ZERO, UnitVector::Z));
/// let second = scene.add_joint(Joint::hinge(large, DVec3::X * 0.4, UnitVector::Z));
/// let scene = scene.gear(Gear::new(first, second, -3.0)?).no_contact([small, large]).build()?;
/// let mut simulation = Simulation::new(&scene)?;
/// simulation.advance_to(1.0)?;
/// assert!((simulation.body(small).velocity.angular.z - 3.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gear {
    first: GearEnd,
    second: GearEnd,
    ratio: f64,
}

/// A coordinate of a joint that a gear takes hold of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GearEnd {
    pub(crate) joint: JointId,
    /// None for the only one that the joint has.
    pub(crate) coordinate: Option<Coordinate>,
}

impl Gear {
    /// The first joint moves by `ratio` times what the second one moves: rad of hinges, m of sliders and ropes.
    ///
    /// # Errors
    /// When the ratio is zero or not finite.
    pub fn new(first: JointId, second: JointId, ratio: f64) -> Result<Self, GearError> {
        if ratio == 0.0 || !ratio.is_finite() {
            return Err(GearError::Ratio(ratio));
        }
        let end = |joint| GearEnd { joint, coordinate: None };
        Ok(Self { first: end(first), second: end(second), ratio })
    }

    /// The same between these coordinates of the joints: a cylindrical joint has two.
    pub const fn between(mut self, first: Coordinate, second: Coordinate) -> Self {
        self.first.coordinate = Some(first);
        self.second.coordinate = Some(second);
        self
    }

    /// What the first coordinate moves for each unit of the second one.
    pub const fn ratio(&self) -> f64 {
        self.ratio
    }

    /// The joints.
    pub const fn joints(&self) -> [JointId; 2] {
        [self.first.joint, self.second.joint]
    }

    /// The coordinates that were named; none for the only one of a joint.
    pub const fn coordinates(&self) -> [Option<Coordinate>; 2] {
        [self.first.coordinate, self.second.coordinate]
    }

    /// The same between these coordinates, with its ratio times a factor other than 0.
    pub(crate) const fn between_ends(self, [first, second]: [GearEnd; 2], factor: f64) -> Self {
        Self { first, second, ratio: self.ratio * factor }
    }

    pub(crate) const fn ends(&self) -> [GearEnd; 2] {
        [self.first, self.second]
    }
}
