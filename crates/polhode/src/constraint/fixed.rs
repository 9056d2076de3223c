//! A fixed joint: two bodies that move as one. Nothing is free.

use super::kept::Kept;
use polhode_spatial::{DVec3, Rotation};

/// What a fixed joint keeps between bodies with these attitudes.
pub(crate) fn kept(attitudes: (Rotation, Rotation)) -> Kept {
    Kept::point().with_rotation(attitude(DVec3::AXES), attitudes)
}

/// Pairs of three axes at right angles, of A and of B, that stay perpendicular where bodies do not turn on each other:
/// their rows are about the three axes.
pub(crate) fn attitude([x, y, z]: [DVec3; 3]) -> [(DVec3, DVec3); 3] {
    [(y, z), (z, x), (x, y)]
}
