//! Depth of penetration of two convex bodies known by their support functions: the expanding polytope algorithm.
//!
//! A polytope inside the difference A - B grows until its face nearest to the origin is a face of the difference: the
//! distance of that face bounds the depth from below, the support along its normal from above. The origin need not lie
//! inside the polytope at the start: distances of faces are signed, and a face with the origin outside is the nearest of
//! all. Source: docs/REFERENCES.md, Van den Bergen 2001.

use crate::query::simplex::Difference;
use crate::shape::support::unit;
use glam::DVec3;

/// Most points that are added.
const MAX_POINTS: usize = 400;

/// The bounds have met when they differ by this many epsilon of the extent.
const MET_ULPS: f64 = 16.0;

/// A point must stand this many epsilon of the extent above a face to see it.
const VISIBLE_ULPS: f64 = 4.0;

/// What was found.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Epa {
    /// Least support over the directions tried, m: an upper bound of the depth.
    pub(crate) upper: f64,
    /// Distance of the nearest face, m: a lower bound.
    pub(crate) lower: f64,
    /// Unit vector out of the difference along which it is `upper` deep.
    pub(crate) outward: DVec3,
    /// Points of the two bodies at the nearest face.
    pub(crate) witnesses: (DVec3, DVec3),
}

#[derive(Debug, Clone, Copy)]
struct Facet {
    corners: [usize; 3],
    normal: DVec3,
    offset: f64,
}

/// The polytope.
struct Polytope {
    points: Vec<Difference>,
    facets: Vec<Facet>,
    extent: f64,
}

/// Depth of two overlapping bodies; nothing when their difference is flat. `support` is as for GJK: farthest of A along,
/// farthest of B against a direction. `hints` are directions worth trying, as normals of flat faces.
pub(crate) fn epa(support: &dyn Fn(DVec3) -> (DVec3, DVec3), hints: &[DVec3]) -> Option<Epa> {
    let farthest = |direction: DVec3| {
        let (a, b) = support(direction);
        Difference::new(a, b)
    };
    let mut polytope = Polytope::start(&farthest)?;
    let mut found = Epa {
        upper: f64::INFINITY,
        lower: f64::NEG_INFINITY,
        outward: DVec3::Z,
        witnesses: (DVec3::ZERO, DVec3::ZERO),
    };
    for &hint in hints {
        let along = hint.dot(farthest(hint).w);
        if along < found.upper {
            (found.upper, found.outward) = (along, hint);
        }
    }
    for _ in 0..MAX_POINTS {
        let nearest = *polytope.facets.iter().min_by(|f, g| f.offset.total_cmp(&g.offset))?;
        found.lower = nearest.offset;
        found.witnesses = polytope.witnesses(&nearest);
        let next = farthest(nearest.normal);
        let along = nearest.normal.dot(next.w);
        if along < found.upper {
            (found.upper, found.outward) = (along, nearest.normal);
        }
        if found.upper - found.lower <= MET_ULPS * f64::EPSILON * polytope.extent || !polytope.grow(&nearest, next) {
            break;
        }
    }
    Some(found)
}

impl Polytope {
    /// Four support points that are not in a plane.
    fn start(farthest: &dyn Fn(DVec3) -> Difference) -> Option<Self> {
        let longest = [DVec3::X, DVec3::Y, DVec3::Z]
            .map(|axis| (farthest(axis), farthest(-axis)))
            .into_iter()
            .max_by(|p, q| (p.0.w - p.1.w).length().total_cmp(&(q.0.w - q.1.w).length()))?;
        let (p, q) = longest;
        let along = unit(p.w - q.w);
        let side = along.any_orthonormal_vector();
        let up = along.cross(side);
        let across = |d: &Difference| ((d.w - p.w) - along * along.dot(d.w - p.w)).length();
        let r = [side, -side, up, -up].map(farthest).into_iter().max_by(|a, b| across(a).total_cmp(&across(b)))?;
        let normal = unit((q.w - p.w).cross(r.w - p.w));
        let height = |d: &Difference| normal.dot(d.w - p.w);
        let (above, below) = (farthest(normal), farthest(-normal));
        let s = if height(&above) >= -height(&below) { above } else { below };
        let extent = (p.w - q.w).length();
        if height(&s).abs() <= VISIBLE_ULPS * f64::EPSILON * extent {
            return None;
        }
        let mut polytope = Self { points: vec![p, q, r, s], facets: Vec::new(), extent };
        let base = if height(&s) > 0.0 { [0, 2, 1] } else { [0, 1, 2] };
        let [i, j, k] = base;
        for corners in [base, [j, i, 3], [k, j, 3], [i, k, 3]] {
            polytope.facets.push(polytope.facet(corners)?);
        }
        Some(polytope)
    }

    /// A facet whose corners stand anticlockwise seen from outside; nothing when it has no area.
    fn facet(&self, corners: [usize; 3]) -> Option<Facet> {
        let [p, q, r] = corners.map(|i| self.points[i].w);
        let normal = unit((q - p).cross(r - p));
        (normal != DVec3::ZERO).then(|| Facet {
            corners,
            normal,
            offset: normal.dot(p).min(normal.dot(q)).min(normal.dot(r)),
        })
    }

    /// Adds a point that stands above a facet: the facets that it sees give way. False when nothing can be gained.
    fn grow(&mut self, seen_first: &Facet, point: Difference) -> bool {
        let tolerance = VISIBLE_ULPS * f64::EPSILON * self.extent;
        let sees = |f: &Facet| f.normal.dot(point.w) > f.offset + tolerance;
        if !sees(seen_first) || self.points.iter().any(|p| p.w == point.w) {
            return false;
        }
        // Only facets joined to the first one through edges, so that the hole is one patch whatever rounding does.
        let mut patch: Vec<Facet> = vec![*seen_first];
        self.facets.retain(|f| f.corners != seen_first.corners);
        let mut front = 0;
        while front < patch.len() {
            for [from, to] in directed_edges(patch[front].corners) {
                let beyond =
                    self.facets.iter().position(|f| directed_edges(f.corners).contains(&[to, from]) && sees(f));
                if let Some(index) = beyond {
                    patch.push(self.facets.swap_remove(index));
                }
            }
            front += 1;
        }
        let edges: Vec<[usize; 2]> = patch.iter().flat_map(|f| directed_edges(f.corners)).collect();
        let apex = self.points.len();
        self.points.push(point);
        for &[from, to] in edges.iter().filter(|[from, to]| !edges.contains(&[*to, *from])) {
            let Some(facet) = self.facet([from, to, apex]) else { return false };
            self.facets.push(facet);
        }
        true
    }

    /// Points of the two bodies where the origin's foot stands on a facet.
    fn witnesses(&self, facet: &Facet) -> (DVec3, DVec3) {
        let [p, q, r] = facet.corners.map(|i| self.points[i]);
        let foot = facet.normal * facet.offset;
        let area = |a: DVec3, b: DVec3| (a - foot).cross(b - foot).dot(facet.normal).max(0.0);
        let weights = [area(q.w, r.w), area(r.w, p.w), area(p.w, q.w)];
        let total: f64 = weights.iter().sum();
        let [x, y, z] = if total > 0.0 { weights.map(|w| w / total) } else { [1.0, 0.0, 0.0] };
        (p.a * x + q.a * y + r.a * z, p.b * x + q.b * y + r.b * z)
    }
}

fn directed_edges([p, q, r]: [usize; 3]) -> [[usize; 2]; 3] {
    [[p, q], [q, r], [r, p]]
}
