//! A universal joint (Cardan): a point that stays one, and an axis of each body that stay perpendicular. Free are the
//! rotations about both axes.

use super::kept::Kept;
use polhode_spatial::{DVec3, Rotation};

/// What a universal joint with these axes (unit vectors, world, perpendicular), the first fixed in A and the second in
/// B, keeps between bodies with these attitudes.
pub(crate) fn kept(axes: (DVec3, DVec3), attitudes: (Rotation, Rotation)) -> Kept {
    Kept::point().with_rotation([axes], attitudes)
}
