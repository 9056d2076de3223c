//! The pair of edges of two convex polyhedra whose common perpendicular separates them best.
//!
//! Only pairs whose arcs cross on the Gauss map are candidates (`separating_axis.rs`). Most edges are excluded before.
//! If a point `q` of the other body lies below the planes of both faces of an edge by more than `t > 0`, the separation
//! along every direction of the edge's arc is below `-t`: the directions `u` with `u . (q - p) < -t` (`p` a vertex of
//! the edge) form a spherical cap smaller than a hemisphere, which contains the whole arc when it contains both ends of
//! it, and `u . (q - p)` is an upper bound of the separation along `u`. Such an edge cannot be better than a face whose
//! separation is `-t` or more.
//!
//! The edges of the best face itself are excluded when the lowest point `q` above it, at height `s`, projects onto the
//! face. On the arc from its normal `n` to that of a neighbour, `u = n cos phi + t sin phi` with `t` the outward side
//! of the edge, and `u . (q - p) = s cos phi + t . (q - p) sin phi`. For `s >= 0` that is at most `s` when
//! `t . (q - p) <= 0`; for `s < 0` it is when `q` is no higher above the neighbour than above the face, again by the
//! argument of the cap.

use crate::clearance::PARALLEL_SINE;
use crate::clearance::SIEVE_SLACK;
use crate::narrow_phase::axis::axes::{Axes, EdgeAxis, FaceAxis};
use crate::narrow_phase::axis::axis_search::{AxisSearch, EdgeBuffers, lowest, plane_of_b, range};
use crate::shape::polyhedron::{ConvexPolyhedron, Edge};
use crate::shape::support::farthest;
use glam::DVec3;
use polhode_spatial::Pose;
use polhode_spatial::rounding;

/// Rounding of the separation along an edge axis, in units of epsilon times the lever arm over the sine of the angle
/// between the edges, from the uncertainty of the direction of their cross product.
pub(crate) const AXIS_ULPS: f64 = 8.0;

/// Edges are nearly parallel up to this sine of their angle: the rounding of the separation along their common
/// perpendicular is then not small compared with the tolerated penetration.
const NEARLY_PARALLEL_SINE: f64 = 0.03;

impl AxisSearch {
    /// Selects the edges whose arcs may contain a direction with a separation of at least the limit of their body
    /// (negative). The faces must have been searched.
    pub(crate) fn select_edges(
        &mut self,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        [limit_a, limit_b]: [f64; 2],
    ) {
        let EdgeBuffers { heights_a, heights_b, of_a, of_b, .. } = &mut self.edges;
        let normals = &self.normals;
        let row = |face: usize| heights_a.chunks_exact(b.vertices.len()).nth(face).unwrap_or(&[]);
        select(of_a, &a.edges, limit_a, &self.along_faces_a, |face| (row(face), a.faces[face].offset));
        let row = |face: usize| heights_b.chunks_exact(a.vertices.len()).nth(face).unwrap_or(&[]);
        let plane = |face: usize| plane_of_b(b, face, normals[face], x_ab);
        select(of_b, &b.edges, limit_b, &self.along_faces_b, |face| (row(face), plane(face)));
    }

    /// Finds the pair of selected edges that separates better than the faces, if there is one, and the separation of
    /// all vertices along the perpendiculars of nearly parallel edges.
    pub(crate) fn deciding_edges(
        &mut self,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        x_ab: &Pose,
        axes: &mut Axes,
        stop: f64,
    ) {
        let over = OverBestFaces::new(self, a, x_ab, axes);
        self.edges.of_a.retain(|&i| !over.excludes_a(a, i));
        if self.edges.of_a.is_empty() {
            return;
        }
        let mut of_b = std::mem::take(&mut self.edges.of_b);
        of_b.retain(|&j| !over.excludes_b(self, b, j));
        self.edges.of_b = of_b;
        self.best_edges(a, b, axes, stop);
    }

    /// Finds the pair of selected edges with the largest separation among those whose arcs cross; pairs with a
    /// separation up to the threshold of the faces may be omitted.
    pub(crate) fn best_edges(&self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, axes: &mut Axes, stop: f64) {
        let (edges, threshold) = (&self.edges, axes.edge_threshold(stop));
        axes.edges = None;
        for &i in &edges.of_a {
            let edge_a = &a.edges[i as usize];
            let of_a = edge_a.faces.map(|f| a.faces[f as usize].normal);
            for &j in &edges.of_b {
                let edge_b = &b.edges[j as usize];
                // The arcs (n1, n2) of A and (-m1, -m2) of B cross when m1 and m2 are on opposite sides of A's arc, n1
                // and n2 on opposite sides of B's, and both arcs in one hemisphere.
                let [x, y] = edge_b.faces.map(|f| self.normals[f as usize].dot(edge_a.direction));
                if x * y >= 0.0 {
                    continue;
                }
                let direction = self.directions[j as usize];
                let [z, w] = of_a.map(|normal| -normal.dot(direction));
                if z * w >= 0.0 || x * w <= 0.0 {
                    continue;
                }
                let pair = [i as usize, j as usize];
                let Some(along) = self.along_edges(a, b, pair, threshold) else { continue };
                let is_nearly_parallel = along.sine <= NEARLY_PARALLEL_SINE;
                if is_nearly_parallel && along.separation > axes.face_separation() + axes.rounding {
                    let v = self.perpendicular(a, pair);
                    // From A's highest vertex to B's lowest.
                    let apart = lowest(&self.vertices, v) - range(&a.vertices, v).1;
                    if apart > axes.along_nearly_parallel.0 {
                        axes.along_nearly_parallel = (apart, v);
                    }
                }
                if along.sine <= PARALLEL_SINE {
                    continue;
                }
                let separation = along.separation - along.rounding;
                if axes.edges.is_none_or(|best| separation > best.separation) {
                    if !self.are_outermost(a, b, pair, axes.tolerance) {
                        continue;
                    }
                    axes.edges = Some(EdgeAxis { separation, edge_a: i, edge_b: j });
                }
                if separation > stop {
                    return;
                }
            }
        }
    }

    /// The unit common perpendicular of two edges, out of A. For nearly parallel edges the cross product has an error
    /// along the edges and one perpendicular to them. The first is projected out; the second hardly matters.
    fn perpendicular(&self, a: &ConvexPolyhedron, [i, j]: [usize; 2]) -> DVec3 {
        let edge_a = &a.edges[i];
        let cross = edge_a.direction.cross(self.directions[j]).normalize();
        let across = (cross - edge_a.direction * cross.dot(edge_a.direction)).normalize();
        if across.dot(edge_a.outward) >= 0.0 { across } else { -across }
    }

    /// Whether two edges contain the support points of their bodies along their common perpendicular. Where an edge of
    /// one body is parallel to a face of the other, the signs of the test for crossing arcs are rounding error, and an
    /// edge on the far side of a body could be accepted.
    fn are_outermost(&self, a: &ConvexPolyhedron, b: &ConvexPolyhedron, [i, j]: [usize; 2], tolerance: f64) -> bool {
        let (edge_a, edge_b) = (&a.edges[i], &b.edges[j]);
        let v = self.perpendicular(a, [i, j]);
        let highest = a.vertices[edge_a.vertices[0] as usize].dot(v) + tolerance;
        let lowest = self.vertices[edge_b.vertices[0] as usize].dot(v) - tolerance;
        a.vertices.iter().all(|p| p.dot(v) <= highest) && self.vertices.iter().all(|p| p.dot(v) >= lowest)
    }

    /// Separation along the common perpendicular of two edges. None when they are parallel to rounding; it may also be
    /// none when the separation is at most `threshold` (at most 0).
    fn along_edges(
        &self,
        a: &ConvexPolyhedron,
        b: &ConvexPolyhedron,
        [i, j]: [usize; 2],
        threshold: f64,
    ) -> Option<Along> {
        let (edge_a, edge_b) = (&a.edges[i], &b.edges[j]);
        let cross = edge_a.direction.cross(self.directions[j]);
        let between = self.vertices[edge_b.vertices[0] as usize] - a.vertices[edge_a.vertices[0] as usize];
        let rounding_at = |sine: f64| AXIS_ULPS * f64::EPSILON * between.length() * (1.0 / sine - 1.0);
        if cross.length_squared() <= NEARLY_PARALLEL_SINE * NEARLY_PARALLEL_SINE {
            let sine = cross.length();
            if sine <= rounding::DOZEN_TERMS {
                return None;
            }
            let separation = between.dot(self.perpendicular(a, [i, j]));
            return (separation > threshold).then(|| Along { separation, rounding: rounding_at(sine), sine });
        }
        let upward = cross.dot(edge_a.outward) >= 0.0;
        // The separation is `lever` over the sine. Most pairs are far from the threshold, which a comparison of squares
        // shows.
        let lever = if upward { between.dot(cross) } else { -between.dot(cross) };
        if lever <= 0.0 && lever * lever >= threshold * threshold * cross.length_squared() * (1.0 + SIEVE_SLACK) {
            return None;
        }
        let sine = cross.length();
        (!sine.is_nan()).then(|| Along { separation: lever / sine, rounding: rounding_at(sine), sine })
    }
}

/// A separation along the common perpendicular of two edges.
struct Along {
    /// m.
    separation: f64,
    /// Error from the uncertainty of the direction, m.
    rounding: f64,
    /// Sine of the angle between the edges.
    sine: f64,
}

/// The lowest vertex above the best face of each body. It excludes the edges of that face on whose inner side it lies:
/// none of these separates better than the face.
struct OverBestFaces {
    tolerance: f64,
    a: OverFace,
    b: OverFace,
    /// From A's origin to B's, A's frame.
    translation: DVec3,
}

/// The lowest vertex above a face.
struct OverFace {
    face: usize,
    normal: DVec3,
    separation: f64,
    point: DVec3,
}

impl OverBestFaces {
    fn new(search: &AxisSearch, a: &ConvexPolyhedron, x_ab: &Pose, axes: &Axes) -> Self {
        let over = |FaceAxis { separation, face }: FaceAxis, normal: DVec3, points: &[DVec3]| OverFace {
            face: face as usize,
            normal,
            separation,
            point: farthest(points, -normal),
        };
        let normal_a = a.faces[axes.face_a.face as usize].normal;
        let normal_b = search.normals[axes.face_b.face as usize];
        Self {
            tolerance: axes.tolerance,
            a: over(axes.face_a, normal_a, &search.vertices),
            b: over(axes.face_b, normal_b, &a.vertices),
            translation: x_ab.translation,
        }
    }

    fn excludes_a(&self, a: &ConvexPolyhedron, edge: u32) -> bool {
        let edge = &a.edges[edge as usize];
        self.a.excludes(edge, edge.direction, a.vertices[edge.vertices[0] as usize], self.tolerance, |face, point| {
            a.faces[face].normal.dot(point) - a.faces[face].offset
        })
    }

    fn excludes_b(&self, search: &AxisSearch, b: &ConvexPolyhedron, index: u32) -> bool {
        let edge = &b.edges[index as usize];
        let (direction, from) = (search.directions[index as usize], search.vertices[edge.vertices[0] as usize]);
        self.b.excludes(edge, direction, from, self.tolerance, |face, point| {
            let normal = search.normals[face];
            normal.dot(point) - (normal.dot(self.translation) + b.faces[face].offset)
        })
    }
}

impl OverFace {
    /// Whether an edge is excluded. `height` gives the height of a point above a face of the same body.
    fn excludes(
        &self,
        edge: &Edge,
        direction: DVec3,
        from: DVec3,
        tolerance: f64,
        height: impl Fn(usize, DVec3) -> f64,
    ) -> bool {
        let Some((turn, beside)) = sides_of(edge, self.face) else { return false };
        let outside = (direction.cross(self.normal) * turn).dot(self.point - from);
        is_over(outside, || height(beside, self.point), self.separation, tolerance)
    }
}

/// Whether a point is clearly over a face, for one of its edges: from its signed distance outside the edge, its height
/// above the neighbour across the edge and its height above the face itself (`separation`), m.
fn is_over(outside: f64, height: impl FnOnce() -> f64, separation: f64, tolerance: f64) -> bool {
    outside <= -tolerance && (separation >= 0.0 || height() <= separation - tolerance)
}

/// For an edge of a face: 1 when the face's loop has the direction of the edge and -1 when the opposite one, and the
/// face across the edge.
fn sides_of(edge: &Edge, face: usize) -> Option<(f64, usize)> {
    let [first, second] = edge.faces.map(|f| f as usize);
    if first == face { Some((1.0, second)) } else { (second == face).then_some((-1.0, first)) }
}

/// Selects the edges for which no point of the other body lies below both adjacent faces by more than the limit.
/// `heights_over` gives the coordinates of these points along a face's normal, and the offset of its plane.
fn select<'a>(
    chosen: &mut Vec<u32>,
    edges: &[Edge],
    limit: f64,
    along_faces: &[f64],
    heights_over: impl Fn(usize) -> (&'a [f64], f64),
) {
    chosen.clear();
    for (index, edge) in edges.iter().enumerate() {
        let [left, right] = edge.faces.map(|face| face as usize);
        let below = along_faces[left] < limit && along_faces[right] < limit && {
            let ((over_left, plane_left), (over_right, plane_right)) = (heights_over(left), heights_over(right));
            let mut points = over_left.iter().zip(over_right);
            points.any(|(l, r)| l - plane_left < limit && r - plane_right < limit)
        };
        if !below {
            chosen.push(index as u32);
        }
    }
}
