//! A slider: two bodies that do not turn on each other, and a line of one that passes through a point of the other.
//! Free is the displacement along the line.

use super::fixed::attitude;
use super::kept::Kept;
use polhode_spatial::{DVec3, Rotation};

/// What a slider with this axis (unit vector, world) keeps between bodies with these attitudes.
pub(crate) fn kept(axis: DVec3, attitudes: (Rotation, Rotation)) -> Kept {
    let (first, second) = axis.any_orthonormal_pair();
    Kept::along([first, second], attitudes.1).with_rotation(attitude([axis, first, second]), attitudes)
}
