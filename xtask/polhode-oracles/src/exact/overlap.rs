//! The overlap of two plane faces that lie on each other: its vertices, decided without rounding.
//!
//! Both faces are looked at along the first one's exact normal. On which side of a line a vertex lies is the sign of a
//! determinant, taken in f64 where that is certain and exactly elsewhere. The vertices of the overlap are those of
//! either polygon inside the other and the proper crossings of edges. Rounded coordinates make clusters of vertices and
//! slivers where the meant ones coincide: those within a tolerance count once, and none counts that lies on the line of
//! its neighbours within it.

use super::dyadic::Dyadic;
use super::pair::{ExactPair, Pair};
use glam::DVec3;

/// Determinants in f64 smaller than this times the square of the scale are computed exactly: a thousand roundings.
const CERTAIN: f64 = 1e-12;

/// Two polygons seen along the normal of the first.
struct Polygons<'a> {
    pair: &'a Pair<'a>,
    exact: &'a ExactPair<'a>,
    loops: [&'a [usize]; 2],
    /// Unit normal of the first face.
    normal: DVec3,
    exact_normal: super::dyadic::ExactVector,
}

/// A vertex of one of the polygons: body and place in its loop.
type Corner = (usize, usize);

impl Polygons<'_> {
    fn vertex(&self, (body, k): Corner) -> usize {
        self.loops[body][k % self.loops[body].len()]
    }

    fn place(&self, corner: Corner) -> DVec3 {
        self.pair.vertices[corner.0][self.vertex(corner)]
    }

    fn exact_side(&self, [p, q, r]: [Corner; 3]) -> Dyadic {
        let at = |corner: Corner| &self.exact.vertices[corner.0][self.vertex(corner)];
        (at(q) - at(p)).cross(&(at(r) - at(p))).dot(&self.exact_normal)
    }

    /// Sign of the area of a triangle of corners: 1 when it is anticlockwise.
    fn side(&self, [p, q, r]: [Corner; 3]) -> i32 {
        let value = (self.place(q) - self.place(p)).cross(self.place(r) - self.place(p)).dot(self.normal);
        if value.abs() > CERTAIN * self.pair.scale * self.pair.scale {
            return if value > 0.0 { 1 } else { -1 };
        }
        self.exact_side([p, q, r]).signum()
    }

    /// The edge of a polygon from one of its corners, in the anticlockwise sense of the first polygon: the second one,
    /// whose normal points the other way, is walked backwards.
    const fn edge(body: usize, k: usize) -> [Corner; 2] {
        let next = k + 1;
        if body == 0 { [(0, k), (0, next)] } else { [(1, next), (1, k)] }
    }

    fn is_inside(&self, corner: Corner) -> bool {
        let other = 1 - corner.0;
        (0..self.loops[other].len()).all(|k| {
            let [from, to] = Self::edge(other, k);
            self.side([from, to, corner]) >= 0
        })
    }

    /// Where edge `i` of the first polygon properly crosses edge `j` of the second.
    fn crossing(&self, i: usize, j: usize) -> Option<DVec3> {
        let ([a, b], [c, d]) = (Self::edge(0, i), Self::edge(1, j));
        if self.side([c, d, a]) * self.side([c, d, b]) >= 0 || self.side([a, b, c]) * self.side([a, b, d]) >= 0 {
            return None;
        }
        let (start, end) = (self.exact_side([c, d, a]), self.exact_side([c, d, b]));
        let part = start.over_root_less(&(&start - &end).square(), 0.0).abs();
        Some(self.place(a) + (self.place(b) - self.place(a)) * part)
    }
}

/// Vertices of the overlap of a face of A and a face of B, m, in axes of the world from A's origin, on A's face;
/// `tolerance` (m) merges what rounding has split.
pub fn vertices(pair: &Pair<'_>, exact: &ExactPair<'_>, faces: [usize; 2], tolerance: f64) -> Vec<DVec3> {
    let loops = [0, 1].map(|body: usize| pair.bodies[body].faces.get(faces[body]).map_or(&[][..], |f| &f.vertices));
    let polygons = Polygons {
        pair,
        exact,
        loops,
        normal: pair.face_normal(0, faces[0]),
        exact_normal: exact.face_normal(0, faces[0]),
    };
    let mut found = Vec::new();
    for body in [0, 1] {
        let inside = (0..loops[body].len()).map(|k| (body, k)).filter(|&corner| polygons.is_inside(corner));
        found.extend(inside.map(|corner| polygons.place(corner)));
    }
    for i in 0..loops[0].len() {
        found.extend((0..loops[1].len()).filter_map(|j| polygons.crossing(i, j)));
    }
    // On A's face, so that places compare: the bodies are a gap apart.
    let origin = loops[0].first().map_or(DVec3::ZERO, |_| polygons.place((0, 0)));
    let normal = polygons.normal;
    let flat = found.into_iter().map(|p| p - normal * normal.dot(p - origin)).collect();
    without_collinear(in_order(merged(flat, tolerance), normal), tolerance)
}

/// One point for each cluster.
fn merged(points: Vec<DVec3>, tolerance: f64) -> Vec<DVec3> {
    let mut kept: Vec<DVec3> = Vec::new();
    for point in points {
        if kept.iter().all(|k| k.distance(point) > tolerance) {
            kept.push(point);
        }
    }
    kept
}

/// The corners of a convex polygon, anticlockwise.
fn in_order(mut points: Vec<DVec3>, normal: DVec3) -> Vec<DVec3> {
    let center = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
    let (u, v) = normal.any_orthonormal_pair();
    let angle = |p: &DVec3| libm::atan2((*p - center).dot(v), (*p - center).dot(u));
    points.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
    points
}

/// Leaves out the corners that lie within the tolerance of the line between their neighbours, one after the other.
fn without_collinear(mut points: Vec<DVec3>, tolerance: f64) -> Vec<DVec3> {
    let mut k = 0;
    while k < points.len() && points.len() > 2 {
        let count = points.len();
        let (before, at, after) = (points[(k + count - 1) % count], points[k], points[(k + 1) % count]);
        let along = (after - before).normalize_or_zero();
        let beside = (at - before) - along * along.dot(at - before);
        if beside.length() <= tolerance {
            points.remove(k);
            k = k.saturating_sub(1);
        } else {
            k += 1;
        }
    }
    points
}
