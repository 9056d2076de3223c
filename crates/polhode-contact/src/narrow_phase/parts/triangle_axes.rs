//! Separating axes of a mesh triangle and a convex polyhedron.
//!
//! A triangle is a flat convex body. Its axes are the two normals of its plane, the face normals of the polyhedron, and
//! the common perpendiculars of a triangle edge and a polyhedron edge. On the Gauss map, the arc of a triangle edge is
//! a half circle: it runs from one normal of the plane, over the in-plane direction out of the triangle, to the other
//! normal.
//!
//! All axes together decide whether the two bodies are separated. For contacts, only those axes are valid that the
//! whole surface allows at the feature of the triangle ([`TriangleMesh::supports_at_edge`]).

use crate::clearance::PARALLEL_SINE;
use crate::clearance::SIEVE_SLACK;
use crate::narrow_phase::axis::axes::AXIS_SLACK;
use crate::narrow_phase::axis::axis_search::{AxisSearch, range};
use crate::narrow_phase::axis::edge_axes::AXIS_ULPS;
use crate::shape::TriangleMesh;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::triangle::TriangleFeature;
use glam::DVec3;

/// A triangle and its plane in the mesh's frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Triangle {
    pub(crate) index: u32,
    pub(crate) corners: [DVec3; 3],
    /// Normal of its patch.
    pub(crate) normal: DVec3,
    pub(crate) offset: f64,
}

impl Triangle {
    pub(crate) fn new(mesh: &TriangleMesh, index: u32) -> Self {
        let patch = mesh.patches[mesh.patch_of[index as usize] as usize];
        Self { index, corners: mesh.corners(index), normal: patch.normal, offset: patch.offset }
    }

    /// Normal of its outer (0) or inner (1) side.
    pub(crate) fn outward(&self, side: u32) -> DVec3 {
        if side == 0 { self.normal } else { -self.normal }
    }
}

/// The axis that decides the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Decision {
    /// The triangle's outer (0) or inner (1) side.
    Side(u32),
    /// A face of the polyhedron.
    Face(u32),
    /// The triangle's edge from this corner to the next, an edge of the polyhedron, and the unit vector along their
    /// common perpendicular, out of the mesh.
    Edges(usize, u32, DVec3),
}

/// The best axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TriangleAxes {
    /// Over all axes, m; positive when the bodies are separated.
    pub(crate) separation: f64,
    /// Over the axes that the whole surface allows at the triangle, m.
    pub(crate) supported: f64,
    pub(crate) decision: Decision,
}

/// Searches the axes; the polyhedron must have been placed in the mesh's frame, `offsets` are those of its faces there.
/// Ends early, with the best axis so far, when the separation exceeds `stop`.
pub(crate) fn triangle_axes(
    search: &AxisSearch,
    buffers: &mut TriangleBuffers,
    offsets: &[f64],
    mesh: &TriangleMesh,
    triangle: &Triangle,
    polyhedron: &ConvexPolyhedron,
    (tolerance, stop): (f64, f64),
) -> TriangleAxes {
    let (low, high) = range(&search.vertices, triangle.normal);
    let sides = [low - triangle.offset, triangle.offset - high];
    let outer = sides[0] >= sides[1] - tolerance;
    let best = if outer { sides[0] } else { sides[1] };
    let mut axes = TriangleAxes { separation: best, supported: best, decision: Decision::Side(u32::from(!outer)) };
    if axes.separation > stop {
        return axes;
    }
    buffers.over_faces.clear();
    // Most triangles are separated from the body: the surface around them is not needed.
    for (&normal, &offset) in search.normals.iter().zip(offsets) {
        let heights = triangle.corners.map(|c| c.dot(normal));
        let separation = least_of(heights) - offset;
        axes.separation = if separation > axes.separation { separation } else { axes.separation };
        if axes.separation > stop {
            break;
        }
        buffers.over_faces.push(heights);
    }
    if axes.separation <= stop {
        for (face, (&heights, &offset)) in buffers.over_faces.iter().zip(offsets).enumerate() {
            let separation = least_of(heights) - offset;
            let outward = search.normals[face];
            if separation > axes.supported + tolerance && rests_on(mesh, triangle, -outward, heights, tolerance) {
                axes.supported = separation;
                axes.decision = Decision::Face(face as u32);
            }
        }
        let rounding = AXIS_SLACK * (polyhedron.size + search.x_ab.translation.length());
        buffers.select(polyhedron, offsets, axes.wanted(tolerance).min(0.0) - rounding);
        search_edges(search, buffers, mesh, triangle, polyhedron, (tolerance, stop), &mut axes);
    }
    axes
}

/// Buffers that the search reuses from call to call.
#[derive(Debug, Clone, Default)]
pub(crate) struct TriangleBuffers {
    /// `normal . corner` of the triangle's corners for every face of the polyhedron, m.
    over_faces: Vec<[f64; 3]>,
    /// For each face of the polyhedron, which corners lie below it by more than a limit: one bit for each corner.
    below: Vec<u8>,
    /// Edges of the polyhedron that can still be the deciding edge.
    edges: Vec<u32>,
    /// Components of an edge of the triangle along the face normals of the polyhedron.
    along_normals: Vec<f64>,
}

impl TriangleBuffers {
    /// Chooses the edges that can give a separation above the limit (negative). An edge is excluded when a corner of
    /// the triangle lies below both of its faces by more than the limit (`edge_axes.rs`).
    fn select(&mut self, polyhedron: &ConvexPolyhedron, offsets: &[f64], limit: f64) {
        self.below.clear();
        self.below.extend(self.over_faces.iter().zip(offsets).map(|([a, b, c], offset)| {
            let level = limit + offset;
            u8::from(*a < level) | u8::from(*b < level) << 1 | u8::from(*c < level) << 2
        }));
        self.edges.clear();
        for (index, edge) in polyhedron.edges.iter().enumerate() {
            let [left, right] = edge.faces.map(|face| self.below[face as usize]);
            if left & right == 0 {
                self.edges.push(index as u32);
            }
        }
    }
}

impl TriangleAxes {
    /// An axis with a separation up to this does not change the result, m.
    fn wanted(&self, tolerance: f64) -> f64 {
        self.separation.min(self.supported + tolerance)
    }
}

/// Written with comparisons, as in [`range`].
fn least_of([a, b, c]: [f64; 3]) -> f64 {
    let least = if b < a { b } else { a };
    if c < least { c } else { least }
}

/// Whether the whole surface allows the normal `v` at those corners of a triangle that are lowest over a face.
fn rests_on(mesh: &TriangleMesh, triangle: &Triangle, v: DVec3, heights: [f64; 3], tolerance: f64) -> bool {
    let least = least_of(heights);
    let low = heights.map(|h| h <= least + tolerance);
    let lowest = match low {
        [true, true, true] => TriangleFeature::Face,
        [true, true, false] => TriangleFeature::Edge(0),
        [false, true, true] => TriangleFeature::Edge(1),
        [true, false, true] => TriangleFeature::Edge(2),
        _ => TriangleFeature::Corner(low.iter().position(|l| *l).unwrap_or(0)),
    };
    mesh.supports_at(triangle.index, lowest, v, tolerance, 0.0)
}

/// Tests the chosen edges of the polyhedron against the edges of the triangle.
fn search_edges(
    search: &AxisSearch,
    TriangleBuffers { edges, along_normals, .. }: &mut TriangleBuffers,
    mesh: &TriangleMesh,
    triangle: &Triangle,
    polyhedron: &ConvexPolyhedron,
    (tolerance, stop): (f64, f64),
    axes: &mut TriangleAxes,
) {
    let own = mesh.edges_of[triangle.index as usize];
    for k in 0..3 {
        let (from, to) = (triangle.corners[k], triangle.corners[(k + 1) % 3]);
        let along = (to - from) / mesh.edges[own[k] as usize].length;
        let out = mesh.sides[triangle.index as usize][k];
        along_normals.clear();
        along_normals.extend(search.normals.iter().map(|normal| along.dot(*normal)));
        for j in edges.iter().map(|&j| j as usize) {
            let edge = &polyhedron.edges[j];
            let [first, second] = edge.faces.map(|f| along_normals[f as usize]);
            // The negated arc of the polyhedron's edge crosses the half circle of the triangle's edge.
            if first * second >= 0.0 {
                continue;
            }
            let direction = search.directions[j];
            if first * direction.dot(triangle.normal) <= 0.0 {
                continue;
            }
            let cross = along.cross(direction);
            let between = search.vertices[edge.vertices[0] as usize] - from;
            let upward = cross.dot(out) >= 0.0;
            let wanted = axes.wanted(tolerance);
            if is_clearly_below(if upward { between.dot(cross) } else { -between.dot(cross) }, cross, between, wanted) {
                continue;
            }
            let sine = cross.length();
            if sine.is_nan() || sine <= PARALLEL_SINE {
                continue;
            }
            let v = if upward { cross / sine } else { -cross / sine };
            let rounding = AXIS_ULPS * f64::EPSILON * between.length() * (1.0 / sine - 1.0);
            let separation = between.dot(v) - rounding;
            if separation <= wanted {
                continue;
            }
            // When an edge lies in the triangle's plane, rounding decides the signs above. So both edges must also
            // contain the support points along the axis.
            let (level, base) =
                (search.vertices[edge.vertices[0] as usize].dot(v) - tolerance, from.dot(v) + tolerance);
            let behind = |p: &DVec3| p.dot(v) < level;
            if search.vertices.iter().any(behind) || triangle.corners.iter().any(|c| c.dot(v) > base) {
                continue;
            }
            axes.separation = axes.separation.max(separation);
            if axes.separation > stop {
                return;
            }
            if separation > axes.supported + tolerance && mesh.supports_at_edge(own[k], v, tolerance, 0.0) {
                axes.supported = separation;
                axes.decision = Decision::Edges(k, j as u32, v);
            }
        }
    }
}

/// Whether the separation `lever / |cross|` (m) is below a given one by more than the rounding of both. It need not be
/// computed then.
fn is_clearly_below(lever: f64, cross: DVec3, between: DVec3, wanted: f64) -> bool {
    let wanted = wanted.min(0.0);
    let square = wanted * wanted * (1.0 + SIEVE_SLACK) + AXIS_SLACK * AXIS_SLACK * between.length_squared();
    lever < 0.0 && lever * lever > square * cross.length_squared()
}
