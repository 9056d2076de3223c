//! Heights of boxes above a half-space: which parts of a body can be near it.
//!
//! The lowest point of a box along a normal `n` has the height `sum_i min(n_i low_i, n_i high_i) - offset`.

use super::aabb::{Aabb, ROUNDING_ULPS};
use crate::Shape;
use glam::DVec3;
use polhode_spatial::Pose;

/// A half-space in the frame in which the boxes are given.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Floor {
    /// Outward unit normal.
    normal: DVec3,
    /// Signed distance of the surface from the frame's origin along the normal, m.
    offset: f64,
    /// Lengths that the offset was computed from, m: its rounding is relative to them.
    lengths: f64,
}

impl Floor {
    /// A half-space at a pose; none for other shapes.
    pub(crate) fn of(shape: &Shape, pose: &Pose) -> Option<Self> {
        let Shape::HalfSpace(half_space) = shape else { return None };
        let normal = pose.rotation.rotate(half_space.normal());
        let offset = half_space.offset() + normal.dot(pose.translation);
        Some(Self { normal, offset, lengths: half_space.offset().abs() + pose.translation.abs().element_sum() })
    }

    /// A lower bound of the height of a box above the surface, m; negative where the box may overlap the half-space.
    pub(crate) fn height(&self, of: &Aabb) -> f64 {
        let lowest = (self.normal * of.min).min(self.normal * of.max).element_sum();
        let lengths = self.lengths + of.min.abs().max(of.max.abs()).element_sum();
        lowest - self.offset - ROUNDING_ULPS * f64::EPSILON * lengths
    }
}

#[cfg(test)]
mod tests {
    //! The height of a box bounds that of its corners, also where the box is turned against the surface and far away.

    use super::*;
    use polhode_spatial::{Rotation, UnitVector};

    #[test]
    fn the_height_of_a_box_is_that_of_its_lowest_corner() {
        let half_space = Shape::half_space(UnitVector::Z);
        for (angle, away) in [(0.0, 0.0), (0.3, 2.0), (1.2, 1e6), (2.5, -7.0)] {
            let rotation = Rotation::from_rotation_vector(DVec3::new(angle, 0.5 * angle, -angle));
            let pose = Pose { rotation, translation: DVec3::new(1.0, away, 0.25) };
            let floor = Floor::of(&half_space, &pose).expect("a half-space");
            let bounds = Aabb { min: DVec3::new(-1.0, 2.0, 0.5), max: DVec3::new(1.5, 2.25, 3.0) };
            let normal = rotation.rotate(DVec3::Z);
            let corner = |i: u32| {
                let pick = |bit: u32, low: f64, high: f64| if i >> bit & 1 == 1 { high } else { low };
                let [l, h] = [bounds.min, bounds.max];
                DVec3::new(pick(0, l.x, h.x), pick(1, l.y, h.y), pick(2, l.z, h.z))
            };
            let lowest = (0..8).map(|i| normal.dot(corner(i) - pose.translation)).fold(f64::INFINITY, f64::min);
            let height = floor.height(&bounds);
            assert!(height <= lowest, "{height} above {lowest}");
            assert!(lowest - height <= 64.0 * f64::EPSILON * (20.0 + away.abs()), "{height} far below {lowest}");
        }
    }
}
