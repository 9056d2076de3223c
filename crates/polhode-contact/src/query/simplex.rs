//! The point of a simplex (one to four points) that is nearest to the origin.
//!
//! The nearest point is computed for every sub-simplex (points, edges, triangles and the whole), and the nearest one
//! with non-negative barycentric weights is taken. So a nearly flat simplex gives one of its faces, never a wrong
//! sub-simplex. This is the backup procedure of docs/REFERENCES.md, Gilbert, Johnson and Keerthi 1988, used always;
//! weights are ratios of signed lengths, areas and volumes (docs/REFERENCES.md, Montanari 2017). There is no tolerance.
//! The direction is the perpendicular of the sub-simplex, which stays accurate where the distance vanishes.

use crate::shape::support::unit;
use glam::DVec3;

/// A point `w = a - b` of the Minkowski difference of two bodies, with its two witness points.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Difference {
    pub(crate) a: DVec3,
    pub(crate) b: DVec3,
    pub(crate) w: DVec3,
}

impl Difference {
    pub(crate) fn new(a: DVec3, b: DVec3) -> Self {
        Self { a, b, w: a - b }
    }
}

/// One to four points and the barycentric weights of the point nearest to the origin.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Simplex {
    points: [Difference; 4],
    weights: [f64; 4],
    count: usize,
}

/// Nearest point of a sub-simplex.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    members: [usize; 4],
    weights: [f64; 4],
    count: usize,
    /// Perpendicular from the origin to the sub-simplex, of any length.
    direction: DVec3,
    norm: f64,
}

/// The nearest point and its direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NearestPoint {
    /// The point.
    pub(crate) point: DVec3,
    /// Unit vector towards it, perpendicular to its sub-simplex; zero when the perpendicular vanishes.
    pub(crate) direction: DVec3,
    /// Whether the origin lies inside four points.
    pub(crate) encloses: bool,
}

impl Simplex {
    pub(crate) fn of(point: Difference) -> Self {
        let mut simplex = Self::default();
        simplex.push(point);
        simplex.weights[0] = 1.0;
        simplex
    }

    /// Adds a point; a fifth is ignored.
    pub(crate) fn push(&mut self, point: Difference) {
        if self.count < 4 {
            self.points[self.count] = point;
            self.count += 1;
        }
    }

    pub(crate) fn points(&self) -> &[Difference] {
        &self.points[..self.count]
    }

    /// Witness points: the points of the two bodies whose difference is the nearest point.
    pub(crate) fn witnesses(&self) -> (DVec3, DVec3) {
        let members = self.points().iter().zip(&self.weights);
        members.fold((DVec3::ZERO, DVec3::ZERO), |(a, b), (p, &l)| (a + p.a * l, b + p.b * l))
    }

    /// Reduces the simplex to the sub-simplex that contains the point nearest to the origin.
    pub(crate) fn reduce(&mut self) -> NearestPoint {
        if let Some(weights) = self.enclosing_weights() {
            self.weights = weights;
            return NearestPoint { point: DVec3::ZERO, direction: DVec3::ZERO, encloses: true };
        }
        let mut best: Option<Candidate> = None;
        for mask in 1_usize..(1 << self.count) {
            let mut members = [0; 4];
            let mut count = 0;
            for i in (0..self.count).filter(|i| mask >> i & 1 == 1) {
                members[count] = i;
                count += 1;
            }
            let candidate = match count {
                1 => Some(self.vertex(members)),
                2 => self.edge(members),
                3 => self.triangle(members),
                _ => None,
            };
            if let Some(candidate) = candidate.filter(|c| best.is_none_or(|b| c.norm < b.norm)) {
                best = Some(candidate);
            }
        }
        let Some(best) = best else {
            return NearestPoint { point: self.points[0].w, direction: DVec3::ZERO, encloses: false };
        };
        let kept = self.points;
        for k in 0..best.count {
            self.points[k] = kept[best.members[k]];
        }
        self.count = best.count;
        self.weights = best.weights;
        let point = self.points().iter().zip(&self.weights).map(|(p, &l)| p.w * l).sum();
        NearestPoint { point, direction: unit(best.direction), encloses: false }
    }

    fn vertex(&self, members: [usize; 4]) -> Candidate {
        let w = self.points[members[0]].w;
        Candidate { members, weights: [1.0, 0.0, 0.0, 0.0], count: 1, direction: w, norm: w.length() }
    }

    fn edge(&self, members: [usize; 4]) -> Option<Candidate> {
        let [p, q] = [0, 1].map(|k| self.points[members[k]].w);
        let along = q - p;
        let (from, to) = (-p.dot(along), q.dot(along));
        // Each weight is computed from the other end, and is exact where that end is nearest.
        if !(from > 0.0 && to > 0.0) {
            return None;
        }
        let total = from + to;
        let weights = [to / total, from / total, 0.0, 0.0];
        // The perpendicular, computed from the nearer end, where rounding is least.
        let start = if from < to { p } else { q };
        let direction = start - along * (start.dot(along) / along.length_squared());
        let norm = (p * weights[0] + q * weights[1]).length();
        Some(Candidate { members, weights, count: 2, direction, norm })
    }

    fn triangle(&self, members: [usize; 4]) -> Option<Candidate> {
        let [p, q, r] = [0, 1, 2].map(|k| self.points[members[k]].w);
        let normal = (q - p).cross(r - p);
        let square = normal.length_squared();
        let areas = [q.cross(r).dot(normal), r.cross(p).dot(normal), p.cross(q).dot(normal)];
        if !(square > 0.0 && areas.iter().all(|&area| area > 0.0)) {
            return None;
        }
        let total = areas[0] + areas[1] + areas[2];
        let weights = [areas[0] / total, areas[1] / total, areas[2] / total, 0.0];
        let height = normal.dot(p);
        let direction = if height < 0.0 { -normal } else { normal };
        let norm = (p * weights[0] + q * weights[1] + r * weights[2]).length();
        Some(Candidate { members, weights, count: 3, direction, norm })
    }

    /// Weights of the origin, when it lies inside four points.
    fn enclosing_weights(&self) -> Option<[f64; 4]> {
        if self.count < 4 {
            return None;
        }
        let [p, q, r, s] = self.points.map(|point| point.w);
        let volume = |a: DVec3, b: DVec3, c: DVec3| a.cross(b).dot(c);
        let parts = [volume(q, s, r), volume(p, r, s), volume(p, s, q), volume(p, q, r)];
        let total: f64 = parts.iter().sum();
        let inside = parts.iter().all(|&v| v > 0.0) || parts.iter().all(|&v| v < 0.0);
        (inside && total != 0.0).then(|| parts.map(|v| v / total))
    }
}
