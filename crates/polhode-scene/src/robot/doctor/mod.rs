//! Whether what a robot file says fits together.

use super::assemble::Placement;
use super::finding::{Finding, Findings};
use super::model::Robot;

/// Examines a robot.
pub fn examine(_robot: &Robot, _placement: &Placement) -> Vec<Finding> {
    Findings::default().into_sorted()
}
