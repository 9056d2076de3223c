//! Planes that faces lie in and pieces are cut along.

use glam::DVec3;

/// An oriented plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    /// Unit normal.
    pub(super) normal: DVec3,
    /// A point of it, m.
    pub(super) origin: DVec3,
}

impl Plane {
    /// Through the corners of a triangle, with its normal; none for a triangle without area. Lengths are taken in units
    /// of the longest edge, so that nothing over- or underflows.
    pub(super) fn of_triangle([a, b, c]: [DVec3; 3]) -> Option<Self> {
        let longest = (b - a).abs().max((c - a).abs()).max_element();
        let normal = ((b - a) / longest).cross((c - a) / longest).try_normalize()?;
        Some(Self { normal, origin: a })
    }

    /// Through a point, along an edge, halfway between two planes with these outward normals that meet in the edge.
    pub(super) fn halfway(origin: DVec3, along: DVec3, first: DVec3, second: DVec3) -> Option<Self> {
        let normal = (first - second).reject_from(along.try_normalize()?).try_normalize()?;
        Some(Self { normal, origin })
    }

    /// Signed distance of a point, m; positive in front.
    pub(super) fn distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.origin)
    }
}
