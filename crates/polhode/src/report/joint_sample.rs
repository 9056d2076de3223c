//! A joint at one time, as programs and observers see it: its coordinates, what acts along them and by which cause,
//! what it bears, and the power that it gives.

use crate::identity::joint_id::JointId;
use crate::report::frame::JointView;
use crate::report::joint_efforts::Efforts;
use crate::scene::Coordinate;
use polhode_spatial::DVec3;

/// A joint at one time.
///
/// ```
/// use polhode::mesh::solid_box;
/// use polhode::prelude::*;
/// use polhode::scene::{Drive, Freedom, Motor};
/// // A motor holds an arm of 1 m and 2 kg level: its torque is told although nothing moves.
/// let mut scene = Scene::builder("arm");
/// let arm = Body::movable("arm", solid_box(DVec3::new(1.0, 0.1, 0.1), Mass::new(2.0)?)?);
/// let arm = scene.add_body(arm.pose(Pose::from_translation(DVec3::X * 0.5)));
/// let motor = Motor::new(Drive::Effort(-0.5 * 2.0 * 9.81))?;
/// let hinge = Joint::hinge(arm, DVec3::ZERO, UnitVector::Y);
/// scene.add_joint(hinge.along(Coordinate::Angle, Freedom::default().with_motor(motor)));
/// let joint = &Simulation::new(&scene.build()?)?.joints()[0];
/// assert!((joint.efforts[0].1.drive + 9.81).abs() < 1e-12);
/// // What the joint keeps gives the force, along its axis and across it; the drive has all of the moment.
/// let reaction = joint.reaction.ok_or("no reaction")?;
/// assert!((reaction.force_n.length() - 2.0 * 9.81).abs() < 1e-12 && reaction.moment_n_m.length() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct JointSample {
    /// The joint.
    pub joint: JointId,
    /// Its coordinates: which, and their values and rates.
    pub coordinates: Vec<(Coordinate, CoordinateSample)>,
    /// What acts along each of them, by its cause, in the same order.
    pub efforts: Vec<(Coordinate, Efforts)>,
    /// What it does to its first body; none in a tier that does not compute it.
    pub load: Option<JointView>,
    /// What it keeps by: the load without what acts along its coordinates; none in a tier that does not compute it.
    pub reaction: Option<Reaction>,
    /// What it gives to its bodies, W: by motors and prescribed motions, springs, dampers and friction, and as a part
    /// of a gear. Zero of a joint that only holds. None in a tier that does not compute its load.
    pub power_w: Option<f64>,
}

/// What a joint keeps by, on its first body at its anchor, in the joint's own axes.
///
/// The axes are fixed in the second body, or in the world where there is none. The first is the axis of the joint (of a
/// planar joint its normal, of a universal joint the second axis), the others are at right angles to it, the second of
/// them where an angle is zero at the start. Of a rod, a rope and a track the first is their line now. Joints without
/// an axis have the axes of the world at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Reaction {
    /// Force along the axes, N.
    pub force_n: DVec3,
    /// Moment about the anchor, about the axes, N m.
    pub moment_n_m: DVec3,
    /// The axes now, unit vectors, world.
    pub axes: [DVec3; 3],
}

/// A coordinate of a joint at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CoordinateSample {
    /// Its value, rad or m; an angle with all its revolutions, if it has no limits.
    pub value: f64,
    /// Its rate, rad/s or m/s.
    pub rate: f64,
}
