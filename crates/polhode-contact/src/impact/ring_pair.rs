//! How long two rings (tori) stay clear of each other when no plane separates them: a bound for pairs of arcs.
//!
//! No plane separates linked rings, or rings that nearly touch. But a plane separates two short arcs of their centre
//! circles (`ring_arcs.rs`). Its normal is the line between their closest points, which alternating projections find.
//! Near touch, such planes need shorter and shorter arcs. There the method uses another property: the distance
//! `D(s, u)` of the points of two arcs (arc lengths s and u) is convex. With `lambda` the least eigenvalue of its
//! second derivatives over both arcs, `g` its gradient at one pair of points, and `L` the largest change, per length
//! along the arcs, of the rate `nu = n.(v_A - v_B)` at which two material points separate,
//!
//! `D(t + tau) >= D + g.d + lambda d^2/2 + (nu - L |d|) tau - c tau^2/2`
//!
//! for the pair at the displacement `d` from it, and at least, for any `d`,
//!
//! `D(t + tau) >= D + nu tau - (|g| + L tau)^2/(2 lambda) - c tau^2/2`
//!
//! `c` is a bound of the points' relative acceleration. The bound for each pair of points uses the current direction
//! between them. The second derivatives are those at one pair, minus their largest change over the arcs.
//!
//! The pair of arcs with the shortest time is cut (`arc_cuts.rs`): both arcs in two, or the longer one.

use crate::impact::arc_cuts::{ClearPart, Cuts};
use crate::impact::impact_bounds::Window;
use crate::impact::quadratic_bound::Quadratic;
use crate::narrow_phase::axis::ring::Ring;
use crate::shape::round::Hull;
use crate::{Shape, Side};
use glam::DVec3;
use polhode_spatial::Pose;
use std::f64::consts::TAU;

/// Initial number of arcs of each ring.
const ARCS: u32 = 8;

/// Number of alternating projections that find the closest points of two arcs.
const ALTERNATIONS: usize = 4;

/// An arc shorter than this fraction of the other is not cut when the other is.
const MUCH_SHORTER: f64 = 0.5;

/// For arcs longer than this fraction of their distance only separating planes are used.
const NEAR: f64 = 0.5;

/// An arc between two angles.
#[derive(Debug, Clone, Copy)]
struct Arc {
    from: f64,
    to: f64,
}

impl Arc {
    const fn middle(self) -> f64 {
        0.5 * (self.from + self.to)
    }

    fn halves(self) -> [Self; 2] {
        [Self { to: self.middle(), ..self }, Self { from: self.middle(), ..self }]
    }

    /// The angle of the arc that is nearest to an angle.
    fn nearest(self, angle: f64) -> f64 {
        let half = 0.5 * (self.to - self.from);
        let off = (angle - self.middle() + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
        self.middle() + off.clamp(-half, half)
    }
}

/// A point of an arc, in world axes.
#[derive(Debug, Clone, Copy)]
struct ArcPoint {
    /// From the body's centre of mass, m.
    arm: DVec3,
    tangent: DVec3,
    /// Unit vector away from the circle's centre.
    radial: DVec3,
    radius: f64,
    /// Arc lengths to the two ends, backwards and forwards, m.
    to_ends: [f64; 2],
}

impl ArcPoint {
    /// Arc length to the farther end, m.
    fn farther_end(&self) -> f64 {
        self.to_ends[0].max(self.to_ends[1])
    }

    /// Bounds of the decrease of the distance along the arc: a constant (m), and a slope that acts over the whole arc.
    /// One of the two is zero: where the distance decreases towards a near end, its decrease up to that end is used.
    fn loss(&self, slope: f64, stiffness: f64) -> (f64, f64) {
        let at_end = slope.abs() * if slope > 0.0 { self.to_ends[0] } else { self.to_ends[1] };
        if at_end <= 0.5 * slope * slope / stiffness { (at_end, 0.0) } else { (0.0, slope) }
    }
}

/// Two rings at one time.
pub(crate) struct RingPair<'a> {
    /// Each in its own body's frame.
    rings: [Ring<'a>; 2],
    tubes: [f64; 2],
    poses: [Pose; 2],
}

impl<'a> RingPair<'a> {
    /// `None` for other pairs.
    pub(crate) fn new([a, b]: [&'a Shape; 2], poses: [Pose; 2]) -> Option<Self> {
        let (Shape::Torus(torus_a), Shape::Torus(torus_b)) = (a, b) else { return None };
        let rings = [Ring::new(a, &Pose::IDENTITY, b)?, Ring::new(b, &Pose::IDENTITY, a)?];
        Some(Self { rings, tubes: [torus_a.minor, torus_b.minor], poses })
    }

    /// How long all arcs stay clear, s: at most the length of the window.
    pub(crate) fn clear(&self, window: &mut Window<'_>, cuts: &mut Cuts) -> f64 {
        let step = TAU / f64::from(ARCS);
        let arcs = || (0..ARCS).map(|k| Arc { from: step * f64::from(k), to: step * f64::from(k + 1) });
        let mut pairs = Vec::with_capacity((ARCS * ARCS) as usize);
        for arc_a in arcs() {
            pairs.extend(arcs().map(|arc_b| self.pair(window, [arc_a, arc_b])));
        }
        let length = window.length();
        cuts.clear(pairs, length, |&[a, b], pairs| {
            let long = |of: usize, arc: Arc| self.rings[of].radius() * (arc.to - arc.from);
            let (long_a, long_b) = (long(0, a), long(1, b));
            let (halves_a, halves_b) = (a.halves(), b.halves());
            let parts_a = if long_a < MUCH_SHORTER * long_b { &[a][..] } else { &halves_a };
            let parts_b = if long_b < MUCH_SHORTER * long_a { &[b][..] } else { &halves_b };
            for &part_a in parts_a {
                pairs.extend(parts_b.iter().map(|&part_b| self.pair(window, [part_a, part_b])));
            }
        })
    }

    /// Two arcs, and how long they stay clear.
    fn pair(&self, window: &mut Window<'_>, arcs: [Arc; 2]) -> ClearPart<[Arc; 2]> {
        let [a, b] = &self.rings;
        let [pose_a, pose_b] = &self.poses;
        // B's centre of mass relative to A's, in world axes.
        let between = pose_b.translation - pose_a.translation;
        let mut angles = arcs.map(Arc::middle);
        for _ in 0..ALTERNATIONS {
            let from_a = pose_a.rotation.rotate(a.place(angles[0])) - between;
            angles[1] = arcs[1].nearest(b.angle_of(pose_b.rotation.inverse_rotate(from_a)));
            let from_b = pose_b.rotation.rotate(b.place(angles[1])) + between;
            angles[0] = arcs[0].nearest(a.angle_of(pose_a.rotation.inverse_rotate(from_b)));
        }
        let on = [0, 1].map(|k| self.point_at(k, arcs[k], angles[k]));
        let apart = on[0].arm - on[1].arm - between;
        let Some(direction) = apart.try_normalize() else { return ClearPart { part: arcs, clear: 0.0 } };
        let clear = self.beside_plane(window, arcs, direction);
        let clear = if clear < window.length() { clear.max(self.convex(window, &on, apart)) } else { clear };
        ClearPart { part: arcs, clear }
    }

    fn point_at(&self, which: usize, arc: Arc, angle: f64) -> ArcPoint {
        let (ring, pose) = (&self.rings[which], &self.poses[which]);
        let radius = ring.radius();
        let place = ring.place(angle);
        ArcPoint {
            arm: pose.rotation.rotate(place),
            tangent: pose.rotation.rotate(ring.tangent(angle)),
            radial: pose.rotation.rotate((place - ring.center()) / radius),
            radius,
            to_ends: [angle - arc.from, arc.to - angle].map(|way| radius * way.max(0.0)),
        }
    }

    /// How long the two arcs stay on either side of a plane, s.
    fn beside_plane(&self, window: &mut Window<'_>, arcs: [Arc; 2], direction: DVec3) -> f64 {
        let corners = [0, 1].map(|k| self.rings[k].corners(arcs[k].from, arcs[k].to));
        let hull = |k: usize| Hull::of_points(&corners[k], self.tubes[k]);
        let still = window.along_direction(direction, &hull(0), &hull(1));
        if still >= window.length() {
            return still;
        }
        still.max(window.along_turning(direction, window.turn_of(Side::A, direction), &hull(0), &hull(1)))
    }

    /// How long the distances of all pairs of points, which are convex over both arcs, stay positive, s; 0 where the
    /// arcs are too long for this bound.
    fn convex(&self, window: &Window<'_>, [a, b]: &[ArcPoint; 2], apart: DVec3) -> f64 {
        let distance = apart.length();
        let way = a.farther_end() + b.farther_end();
        if distance.is_nan() || way > NEAR * distance {
            return 0.0;
        }
        let n = apart / distance;
        // Bound of the rotation of the direction over the arcs.
        let aside = way / (distance - way);
        let stiffness = least_stiffness([a, b], apart, way, aside) / (distance + way);
        if stiffness.is_nan() || stiffness <= 0.0 {
            return 0.0;
        }
        let slopes = [n.dot(a.tangent), -n.dot(b.tangent)];
        let [(lost_a, slope_a), (lost_b, slope_b)] = [a.loss(slopes[0], stiffness), b.loss(slopes[1], stiffness)];
        let slope = libm::hypot(slope_a, slope_b);
        let [of_a, of_b] = window.velocities();
        let velocity = (of_a.linear - of_b.linear) + of_a.angular.cross(a.arm) - of_b.angular.cross(b.arm);
        let (spin_a, spin_b) = (of_a.angular.length(), of_b.angular.length());
        // Derivatives of `n.v` along the arcs: exact at the pair, and a bound of their change.
        let first = (a.tangent - n * slopes[0]).dot(velocity) / distance + n.dot(of_a.angular.cross(a.tangent));
        let second = (b.tangent + n * slopes[1]).dot(velocity) / distance + n.dot(of_b.angular.cross(b.tangent));
        let (speed, least) = (velocity.length() + spin_a * a.farther_end() + spin_b * b.farther_end(), distance - way);
        let bends = 1.0 / a.radius + 1.0 / b.radius;
        let change = speed / least * (3.0 / least + bends)
            + 2.0 * (spin_a + spin_b) / least
            + spin_a / a.radius
            + spin_b / b.radius;
        let steepest = libm::hypot(first, second) + 2.0 * change * way;
        let gap = Quadratic {
            value: distance - self.tubes[0] - self.tubes[1] - lost_a - lost_b - 0.5 * slope * slope / stiffness,
            rate: n.dot(velocity) - slope * steepest / stiffness,
            curvature: steepest * steepest / stiffness,
        };
        let arms = [0, 1].map(|k: usize| self.rings[k].center().length() + self.rings[k].radius());
        window.between_points(gap, n, aside, arms)
    }
}

/// Least eigenvalue of the second derivatives of the distance of two points, times the distance, over arcs along which
/// the vector between them changes by at most `way` (m) and its direction by at most `aside`.
fn least_stiffness([a, b]: [&ArcPoint; 2], apart: DVec3, way: f64, aside: f64) -> f64 {
    let distance = apart.length();
    let n = apart / distance;
    let (x_a, x_b) = (n.dot(a.tangent), n.dot(b.tangent));
    let (turn_a, turn_b) = (a.farther_end() / a.radius, b.farther_end() / b.radius);
    let (change_a, change_b) = (aside + turn_a, aside + turn_b);
    let of_square = |x: f64, change: f64| change * (2.0 * x.abs() + change);
    let of_bend = |on: &ArcPoint, turn: f64| (way + (distance + way) * turn) / on.radius;
    let aa = 1.0 - apart.dot(a.radial) / a.radius - x_a * x_a;
    let bb = 1.0 + apart.dot(b.radial) / b.radius - x_b * x_b;
    let ab = x_a * x_b - a.tangent.dot(b.tangent);
    let change_aa = of_bend(a, turn_a) + of_square(x_a, change_a);
    let change_bb = of_bend(b, turn_b) + of_square(x_b, change_b);
    let change_ab = turn_a + turn_b + change_a * (x_b.abs() + change_b) + x_a.abs() * change_b;
    let least = 0.5 * (aa + bb) - libm::hypot(0.5 * (aa - bb), ab);
    least - change_aa.max(change_bb) - change_ab
}
