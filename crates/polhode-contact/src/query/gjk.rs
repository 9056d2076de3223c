//! Distance of two convex bodies known by their support functions: the algorithm of Gilbert, Johnson and Keerthi.
//!
//! A simplex of at most four points of the Minkowski difference is moved towards the origin: `v` is its point nearest
//! to the origin, and the next point is the support point along `-v`. `|v|` bounds the distance from above, the
//! separation along `v` from below. The iteration ends when the two bounds agree to rounding, when the simplex contains
//! the origin, when `|v|` no longer decreases, or after [`MAX_ITERATIONS`]. Lengths are compared only with the extent
//! of the simplex, so that the result does not depend on units. Sources: docs/REFERENCES.md, Gilbert, Johnson and
//! Keerthi 1988, Montanari 2017.

use crate::query::simplex::{Difference, Simplex};
use crate::shape::support::unit;
use glam::DVec3;

/// Most support points. Polytopes take about ten; curved bodies that nearly touch up to a hundred.
const MAX_ITERATIONS: usize = 256;

/// The bounds agree when they differ by at most this many epsilon of the extent of the difference.
const MET_ULPS: f64 = 4.0;

/// Bodies nearer than this many epsilon of the extent touch or overlap: the sign is below rounding.
const TOUCH_ULPS: f64 = 16.0;

/// The result of the iteration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gjk {
    /// Whether the bodies overlap, or touch to rounding.
    pub(crate) touching: bool,
    /// Largest separation along the directions tried, m: a lower bound of the distance.
    pub(crate) lower: f64,
    /// Length of `v`, m: an upper bound of the distance.
    pub(crate) upper: f64,
    /// Unit vector from B to A: the direction of the lower bound.
    pub(crate) normal: DVec3,
    pub(crate) simplex: Simplex,
}

/// Distance of two bodies. `support` gives, for a direction, the support point of A along it and that of B against it;
/// `start` is any point of the difference A - B.
pub(crate) fn gjk(support: &dyn Fn(DVec3) -> (DVec3, DVec3), start: DVec3) -> Gjk {
    let begin = if start == DVec3::ZERO { DVec3::X } else { unit(start) };
    let (a, b) = support(-begin);
    let mut simplex = Simplex::of(Difference::new(a, b));
    let mut found = Gjk { touching: false, lower: f64::NEG_INFINITY, upper: f64::INFINITY, normal: begin, simplex };
    let mut extent: f64 = 0.0;
    for _ in 0..MAX_ITERATIONS {
        let nearest = simplex.reduce();
        // The rounding of the points depends on both bodies' own coordinates.
        extent = simplex.points().iter().fold(extent, |e, p| e.max(p.w.length()).max(p.a.length()).max(p.b.length()));
        let length = nearest.point.length();
        if nearest.encloses || length <= TOUCH_ULPS * f64::EPSILON * extent {
            found.upper = found.upper.min(length);
            return Gjk { touching: true, simplex, ..found };
        }
        if length >= found.upper {
            return found;
        }
        found.upper = length;
        found.simplex = simplex;
        let direction = if nearest.direction == DVec3::ZERO { unit(nearest.point) } else { nearest.direction };
        let (a, b) = support(-direction);
        let next = Difference::new(a, b);
        let along = direction.dot(next.w);
        if along > found.lower {
            found.lower = along;
            found.normal = direction;
        }
        if found.upper - found.lower <= MET_ULPS * f64::EPSILON * extent {
            return found;
        }
        if simplex.points().iter().any(|p| p.w == next.w) {
            return found;
        }
        simplex.push(next);
    }
    found
}
