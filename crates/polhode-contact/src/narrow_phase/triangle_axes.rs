//! Separating axes of a triangle of a mesh and a convex polyhedron.
//!
//! A triangle is a flat convex body: its axes are the two normals of its plane, the normals of the polyhedron's faces and
//! the common perpendiculars of its edges with the polyhedron's, whose arcs on the Gauss map run from one normal over
//! the direction out of the triangle to the other. They tell whether the triangle is apart. For contacts only those
//! axes count that the surface has at the triangle's feature ([`TriangleMesh::supports_at_edge`]).

use crate::clearance::PARALLEL_SINE;
use crate::narrow_phase::edge_axes::AXIS_ULPS;
use crate::narrow_phase::separating_axis::Workspace;
use crate::shape::TriangleMesh;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;

/// A triangle and its plane, the mesh's frame.
#[derive(Clone, Copy)]
pub(crate) struct Triangle {
    pub(crate) index: u32,
    pub(crate) corners: [DVec3; 3],
    /// Of its patch.
    pub(crate) normal: DVec3,
    pub(crate) offset: f64,
}

impl Triangle {
    pub(crate) fn new(mesh: &TriangleMesh, index: u32) -> Self {
        let patch = mesh.patches[mesh.patch_of[index as usize] as usize];
        Self { index, corners: mesh.corner_places(index), normal: patch.normal, offset: patch.offset }
    }
}

/// What decides how a triangle and a polyhedron stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Decision {
    /// The triangle's outer (0) or inner (1) side.
    Side(u32),
    /// A face of the polyhedron.
    Face(u32),
    /// The triangle's edge from this corner to the next, and an edge of the polyhedron; the unit vector from the mesh.
    Edges(usize, u32, DVec3),
}

/// The best axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TriangleAxes {
    /// Along all axes, m: above zero when the triangle is apart.
    pub(crate) separation: f64,
    /// Along the axes that the surface has at the triangle, m.
    pub(crate) supported: f64,
    pub(crate) decision: Decision,
}

/// Searches the axes; the polyhedron must have been placed in the mesh's frame, `offsets` are those of its faces there.
/// Ends early with what it has when the triangle is apart by more than `stop`.
pub(crate) fn triangle_axes(
    workspace: &Workspace,
    offsets: &[f64],
    mesh: &TriangleMesh,
    triangle: &Triangle,
    polyhedron: &ConvexPolyhedron,
    (tolerance, stop): (f64, f64),
) -> TriangleAxes {
    let (low, high) = workspace
        .vertices
        .iter()
        .map(|v| v.dot(triangle.normal))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
    let sides = [low - triangle.offset, triangle.offset - high];
    let outer = sides[0] >= sides[1] - tolerance;
    let best = if outer { sides[0] } else { sides[1] };
    let mut axes = TriangleAxes { separation: best, supported: best, decision: Decision::Side(u32::from(!outer)) };
    if axes.separation > stop {
        return axes;
    }
    for (face, (&normal, &offset)) in workspace.normals.iter().zip(offsets).enumerate() {
        let heights = triangle.corners.map(|c| c.dot(normal));
        let separation = heights[0].min(heights[1]).min(heights[2]) - offset;
        axes.separation = axes.separation.max(separation);
        if axes.separation > stop {
            return axes;
        }
        if separation > axes.supported + tolerance && rests_on(mesh, triangle, -normal, heights, tolerance) {
            axes.supported = separation;
            axes.decision = Decision::Face(face as u32);
        }
    }
    search_edges(workspace, mesh, triangle, polyhedron, (tolerance, stop), &mut axes);
    axes
}

/// Whether the surface has the normal `v` at the corners of a triangle that lie lowest on a face.
fn rests_on(mesh: &TriangleMesh, triangle: &Triangle, v: DVec3, heights: [f64; 3], tolerance: f64) -> bool {
    let least = heights[0].min(heights[1]).min(heights[2]);
    let low = heights.map(|h| h <= least + tolerance);
    let index = triangle.index as usize;
    match low {
        [true, true, true] => true,
        [true, true, false] => mesh.supports_at_edge(mesh.edges_of[index][0], v, tolerance, 0.0),
        [false, true, true] => mesh.supports_at_edge(mesh.edges_of[index][1], v, tolerance, 0.0),
        [true, false, true] => mesh.supports_at_edge(mesh.edges_of[index][2], v, tolerance, 0.0),
        _ => {
            let corner = low.iter().position(|l| *l).unwrap_or(0);
            mesh.supports_at_vertex(mesh.joined[index][corner], v, tolerance, 0.0)
        }
    }
}

fn search_edges(
    workspace: &Workspace,
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
        for (j, edge) in polyhedron.edges.iter().enumerate() {
            let direction = workspace.directions[j];
            let [first, second] = edge.faces.map(|f| along.dot(workspace.normals[f as usize]));
            // The arc of the polyhedron's edge, turned round, crosses the half circle of the triangle's.
            let tilt = direction.dot(triangle.normal);
            if first * second >= 0.0 || first * tilt <= 0.0 {
                continue;
            }
            let cross = along.cross(direction);
            let sine = cross.length();
            if sine.is_nan() || sine <= PARALLEL_SINE {
                continue;
            }
            let v = if cross.dot(out) >= 0.0 { cross / sine } else { -cross / sine };
            let between = workspace.vertices[edge.vertices[0] as usize] - from;
            let rounding = AXIS_ULPS * f64::EPSILON * between.length() * (1.0 / sine - 1.0);
            let separation = between.dot(v) - rounding;
            if separation <= axes.separation.min(axes.supported + tolerance) {
                continue;
            }
            // Where an edge lies in the triangle's plane, rounding decides the signs above: both edges must be
            // outermost along the axis.
            let (level, base) =
                (workspace.vertices[edge.vertices[0] as usize].dot(v) - tolerance, from.dot(v) + tolerance);
            let behind = |p: &DVec3| p.dot(v) < level;
            if workspace.vertices.iter().any(behind) || triangle.corners.iter().any(|c| c.dot(v) > base) {
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
