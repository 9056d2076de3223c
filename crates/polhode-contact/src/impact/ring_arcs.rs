//! How long a ring stays clear of a convex body that it is not apart from as a whole: arc by arc.
//!
//! A ring that has a body in its hole, or touches it with the inner side of its tube, has no plane that keeps all of it
//! away. Every short arc of its middle line has one: an arc of less than half a turn lies in the triangle of its two ends
//! and the place where the tangents there meet, which moves with the ring as the arc does. Along any direction that
//! triangle, blown up by the tube, and the hull of the body stay apart for as long as the bounds of `impact_bounds.rs`
//! say; the direction is that of the body's nearest place to the middle of the arc. Held still it serves a ring that
//! spins over a corner; turning with the body it loses nothing of first order to the body's own turning, so that a ring
//! which slides over a face or an edge and parts slowly from it is clear for a time of the order of that since the touch.
//!
//! The arc that fails first is cut in two (`arc_cuts.rs`). The gap of a chord is short of that of its arc by an eighth of
//! the radius times the square of its angle, so that arcs shrink in proportion to their distance from a touch: as many cuts
//! as that ratio has binary digits.

use crate::impact::arc_cuts::{Cuts, Piece};
use crate::impact::impact_bounds::Window;
use crate::narrow_phase::axis::ring::Ring;
use crate::shape::round::{Circles, Hull, HullPoints};
use crate::{Shape, Side};
use glam::DVec3;
use polhode_spatial::Pose;
use std::f64::consts::TAU;

/// Arcs at first.
const ARCS: u32 = 12;

/// A ring and another convex shape at one moment.
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
    /// Of a pair of which one is a ring and the other convex; nothing for other pairs.
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

    /// How long all arcs stay clear, s: at most the length of the window.
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

    /// An arc between two angles.
    fn arc(&self, window: &mut Window<'_>, from: f64, to: f64) -> Piece<(f64, f64)> {
        let middle = 0.5 * (from + to);
        let nearest = self.ring.nearest(self.ring.place(middle));
        let away = self.other_pose.rotation.rotate(nearest.normal);
        let direction = if self.of == Side::A { away } else { -away };
        let corners = self.ring.corners(from, to).map(|corner| self.to_ring.transform_point(corner));
        let own = Hull { points: HullPoints::Listed(&corners), circles: Circles::NONE, ball: self.tube };
        let other = Hull::of(self.other);
        let across = |line: DVec3| self.other_pose.rotation.rotate(line).cross(direction).try_normalize();
        let line = nearest.along(self.other).and_then(across);
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
        Piece { part: (from, to), clear }
    }
}
