//! The normal that a file of STL gives each of its triangles.

use glam::DVec3;

/// Unit normal of a triangle, 0 for one without area.
pub(super) fn unit_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}
