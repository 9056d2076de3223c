//! A hinge: a point and an axis of two bodies that stay one. Free is the rotation about the axis.

use super::kept::Kept;
use polhode_spatial::{DVec3, Rotation};

/// What a hinge with this axis (unit vector, world) keeps between bodies with these attitudes.
pub(crate) fn kept(axis: DVec3, attitudes: (Rotation, Rotation)) -> Kept {
    let (first, second) = axis.any_orthonormal_pair();
    Kept::point().with_rotation([(axis, first), (axis, second)], attitudes)
}
