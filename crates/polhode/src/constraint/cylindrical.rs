//! A cylindrical joint: an axis of two bodies that stays one. Free are the rotation about it and the displacement along
//! it.

use super::kept::Kept;
use polhode_spatial::{DVec3, Rotation};

/// What a cylindrical joint with this axis (unit vector, world) keeps between bodies with these attitudes.
pub(crate) fn kept(axis: DVec3, attitudes: (Rotation, Rotation)) -> Kept {
    let (first, second) = axis.any_orthonormal_pair();
    Kept::along([first, second], attitudes.1).with_rotation([(axis, first), (axis, second)], attitudes)
}
