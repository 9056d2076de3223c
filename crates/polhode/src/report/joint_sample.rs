//! A joint at one time, as programs and observers see it: its coordinates, what it bears, and the power that it gives.

use crate::identity::joint_id::JointId;
use crate::report::frame::JointView;
use crate::scene::Coordinate;

/// A joint at one time.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct JointSample {
    /// The joint.
    pub joint: JointId,
    /// Its coordinates: which, and their values and rates.
    pub coordinates: Vec<(Coordinate, CoordinateSample)>,
    /// What it does to its first body; none in a tier that does not compute it.
    pub load: Option<JointView>,
    /// What it gives to its bodies, W: by motors and prescribed motions, springs, dampers and friction, and as a part
    /// of a gear. Zero of a joint that only holds. None in a tier that does not compute its load.
    pub power_w: Option<f64>,
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
