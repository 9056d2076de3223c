//! A planar joint: a point of one body stays in a plane of the other, and both keep one normal. Free are displacements
//! in the plane and the rotation about the normal.

use super::kept::Kept;
use polhode_spatial::{DVec3, Rotation};

/// What a planar joint with this normal (unit vector, world) keeps between bodies with these attitudes.
pub(crate) fn kept(normal: DVec3, attitudes: (Rotation, Rotation)) -> Kept {
    let (first, second) = normal.any_orthonormal_pair();
    Kept::along([normal], attitudes.1).with_rotation([(normal, first), (normal, second)], attitudes)
}
