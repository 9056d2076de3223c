//! How long a ring stays clear of a convex body when no plane separates the two: a bound arc by arc.
//!
//! When the body is in the hole of the ring, or touches the inner side of the tube, no plane separates it from the
//! whole ring. But for every short arc of the ring's centre circle there is a separating plane. An arc of less than
//! half a turn lies in the triangle of its two ends and the intersection of the tangents there, and this triangle moves
//! with the ring.
//!
//! Along any direction, the triangle (inflated by the radius of the tube) and the hull of the body stay separated for
//! the time given by the bounds of `impact_bounds.rs`. The direction used is that from the body's closest point to the
//! middle of the arc. It is tried in three ways:
//!
//! - rotating with the body, so that the rotation of the body causes no loss of first order. A ring that slides over a
//!   face or an edge and slowly separates from it is then clear for a time comparable to the time since the touch;
//! - staying perpendicular to the tangent at the middle of the arc and to the body's line, where the closest feature of
//!   the body is straight;
//! - fixed in the world, which is better for a ring that spins above a corner.
//!
//! The arc with the shortest time is cut in two (`arc_cuts.rs`). The gap of the chord is smaller than the gap of the
//! arc by an eighth of the radius times the square of the angle. So the arcs must shrink in proportion to the distance
//! from touch, and the number of cuts is about the number of binary digits of this ratio.

use crate::impact::arc_cuts::{ClearPart, Cuts};
use crate::impact::impact_bounds::Window;
use crate::narrow_phase::axis::ring::Ring;
use crate::narrow_phase::feature::element::Element;
use crate::shape::round::Hull;
use crate::{Shape, Side};
use glam::DVec3;
use polhode_spatial::Pose;
use std::f64::consts::TAU;

/// Initial number of arcs.
const ARCS: u32 = 12;

/// A ring and another convex shape at one time.
pub(crate) struct RingArcs<'a> {
    ring: Ring<'a>,
    tube: f64,
    /// From the other body's frame to the ring's.
    to_ring: Pose,
    other: &'a Shape,
    other_pose: Pose,
    of: Side,
}

impl<'a> RingArcs<'a> {
    /// For a ring and a convex shape; `None` for other pairs.
    pub(crate) fn new([shape_a, shape_b]: [&'a Shape; 2], [pose_a, pose_b]: [Pose; 2]) -> Option<Self> {
        let convex = |shape: &Shape| {
            matches!(
                shape,
                Shape::Convex(_) | Shape::Sphere(_) | Shape::Capsule(_) | Shape::Cylinder(_) | Shape::Cone(_)
            )
        };
        let (of, shape, pose, other, other_pose) = match (shape_a, shape_b) {
            (Shape::Torus(_), other) if convex(other) => (Side::A, shape_a, pose_a, other, pose_b),
            (other, Shape::Torus(_)) if convex(other) => (Side::B, shape_b, pose_b, other, pose_a),
            _ => return None,
        };
        let ring = Ring::new(shape, &other_pose.relative(&pose), other)?;
        let Shape::Torus(torus) = shape else { return None };
        Some(Self { ring, tube: torus.minor, to_ring: pose.relative(&other_pose), other, other_pose, of })
    }

    /// How long all arcs certainly stay clear, s; at most the length of the window.
    pub(crate) fn clear(&self, window: &mut Window<'_>, cuts: &mut Cuts) -> f64 {
        let step = TAU / f64::from(ARCS);
        let mut arcs = Vec::with_capacity(2 * ARCS as usize);
        for k in 0..ARCS {
            arcs.push(self.arc(window, step * f64::from(k), step * f64::from(k + 1)));
        }
        let length = window.length();
        cuts.clear(arcs, length, |&(from, to), arcs| {
            let middle = 0.5 * (from + to);
            arcs.push(self.arc(window, from, middle));
            arcs.push(self.arc(window, middle, to));
        })
    }

    /// The arc between two angles, and how long it stays clear.
    fn arc(&self, window: &mut Window<'_>, from: f64, to: f64) -> ClearPart<(f64, f64)> {
        let middle = 0.5 * (from + to);
        let nearest = self.ring.nearest(self.ring.place(middle));
        let away = self.other_pose.rotation.rotate(nearest.normal);
        let direction = if self.of == Side::A { away } else { -away };
        let corners = self.ring.corners(from, to).map(|corner| self.to_ring.transform_point(corner));
        let own = Hull::of_points(&corners, self.tube);
        let other = Hull::of(self.other);
        let across = |line: DVec3| self.other_pose.rotation.rotate(line).cross(direction).try_normalize();
        let element = Element::of(self.other, nearest.feature, &Pose::IDENTITY);
        let line = element.and_then(|element| element.straight_direction(nearest.normal)).and_then(across);
        let lines = [across(self.ring.tangent(middle)), line];
        let lines = if self.of == Side::A { lines } else { [lines[1], lines[0]] };
        let turns =
            [window.turn_of(self.of.other(), direction), window.turn_with(lines).unwrap_or_default(), DVec3::ZERO];
        let mut clear: f64 = 0.0;
        for turn in turns {
            let (hull_a, hull_b) = if self.of == Side::A { (&own, &other) } else { (&other, &own) };
            clear = clear.max(window.along_turning(direction, turn, hull_a, hull_b));
            if clear >= window.length() {
                break;
            }
        }
        ClearPart { part: (from, to), clear }
    }
}
