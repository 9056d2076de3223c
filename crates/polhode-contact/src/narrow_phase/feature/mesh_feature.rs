//! Faces, edges and vertices of a triangle mesh: their borders, and the normals that contacts on them may have.
//!
//! A face has the normal of its patch (triangles that lie in one plane). An edge or a vertex has the normals `v` for
//! which all its triangles lie below the plane with normal `v`, `v . (w - x) <= 0` for their corners `w`: the arc
//! between the neighbours' normals at a convex edge, the cone at a convex vertex, none at a concave edge and none but
//! the patch's own within a patch.

use crate::bounding::aabb::Aabb;
use crate::clearance::COINCIDENCE;
use crate::shape::TriangleMesh;
use crate::shape::triangle::{TriangleFeature, from_triangle};
use glam::DVec3;

/// Signed distance of a point in a face's plane from the border of its patch, m. Inside: the distance from the border
/// edges of the triangles that contain the point (infinite when they have none). Outside: minus the distance from the
/// nearest triangle. Beyond a concave edge, at which the surface rises, it is zero: a body that penetrates there is
/// below both faces, and touches both.
pub(crate) fn patch_margin(mesh: &TriangleMesh, face: u32, y: DVec3) -> f64 {
    let patch = face / 2;
    let slack = COINCIDENCE * mesh.bounds_size();
    let mut inside: Option<f64> = None;
    mesh.tree.overlaps(&Aabb::of_point(y).widened(4.0 * slack), &mut |triangle| {
        if mesh.patch_of[triangle as usize] != patch {
            return;
        }
        let mut margin = f64::INFINITY;
        for (k, corner) in mesh.corners(triangle).into_iter().enumerate() {
            let within = mesh.sides[triangle as usize][k].dot(corner - y);
            let flat = mesh.edges[mesh.edges_of[triangle as usize][k] as usize].flat;
            if within < -slack || (within < 0.0 && !flat) {
                return;
            }
            margin = if flat { margin } else { margin.min(within) };
        }
        inside = Some(inside.map_or(margin, |other| other.min(margin)));
    });
    if let Some(margin) = inside {
        return margin;
    }
    let here = Aabb::of_point(y);
    let near = |bounds: &Aabb| bounds.distance(&here);
    let mut nearest = (f64::INFINITY, None);
    let distance = mesh.tree.least(f64::INFINITY, 0.0, &near, &mut |triangle, _| {
        if mesh.patch_of[triangle as usize] != patch {
            return f64::INFINITY;
        }
        let (away, part) = from_triangle(&mesh.corners(triangle), y);
        let distance = away.length();
        if distance < nearest.0 {
            nearest = (distance, Some((triangle, part)));
        }
        distance
    });
    match nearest.1 {
        Some((triangle, TriangleFeature::Edge(k))) if mesh.rises_at(mesh.edges_of[triangle as usize][k], face) => 0.0,
        _ => -distance,
    }
}

impl TriangleMesh {
    /// Whether the surface rises above the face at an edge of the face's patch (a concave edge).
    fn rises_at(&self, edge: u32, face: u32) -> bool {
        let Some(plane) = self.face_plane(face) else { return false };
        let height = COINCIDENCE * self.bounds_size();
        let others = self.at_edge.of(edge as usize).iter().filter(|&&t| self.patch_of[t as usize] != face / 2);
        others.flat_map(|&t| self.corners(t)).any(|w| plane.normal.dot(w) - plane.offset > height)
    }

    /// Unit vectors out of the triangles at an edge, in their planes.
    pub(crate) fn sides_at_edge(&self, edge: u32) -> impl Iterator<Item = DVec3> + '_ {
        self.at_edge.of(edge as usize).iter().filter_map(move |&t| {
            let k = self.edges_of[t as usize].iter().position(|&e| e == edge)?;
            Some(self.sides[t as usize][k])
        })
    }

    /// The other corners of the triangles at a vertex; some occur twice.
    pub(crate) fn neighbours(&self, vertex: u32) -> impl Iterator<Item = DVec3> + '_ {
        let others = self.at_vertex.of(vertex as usize).iter().flat_map(|&t| self.joined[t as usize]);
        others.filter(move |&v| v != vertex).map(|v| self.vertices[v as usize])
    }

    /// Length of the first edge at a vertex, m: the scale of the triangles there.
    pub(crate) fn first_edge_length(&self, vertex: u32) -> f64 {
        let x = self.vertices.get(vertex as usize).copied().unwrap_or_default();
        self.neighbours(vertex).next().map_or(0.0, |w| w.distance(x))
    }

    pub(crate) fn bounds_size(&self) -> f64 {
        let bounds = self.bounds();
        (bounds.max - bounds.min).length()
    }

    /// Whether the mesh may have the normal `v` at an edge: its triangles rise above the plane by no more than `height`
    /// (m) plus `slope` times their width.
    pub(crate) fn supports_at_edge(&self, edge: u32, v: DVec3, height: f64, slope: f64) -> bool {
        let Some(line) = self.edges.get(edge as usize) else { return false };
        let x = self.vertices[line.vertices[0] as usize];
        self.all_fall_away(self.at_edge.of(edge as usize), |w| falls_away(w - x, v, height, slope))
    }

    /// The same at a vertex.
    pub(crate) fn supports_at_vertex(&self, vertex: u32, v: DVec3, height: f64, slope: f64) -> bool {
        let Some(&x) = self.vertices.get(vertex as usize) else { return false };
        // The step to the vertex itself is zero, and passes.
        self.all_fall_away(self.at_vertex.of(vertex as usize), |w| falls_away(w - x, v, height, slope))
    }

    /// The same at a feature of a triangle; the face has its own normal.
    pub(crate) fn supports_at(&self, triangle: u32, at: TriangleFeature, v: DVec3, height: f64, slope: f64) -> bool {
        match at {
            TriangleFeature::Face => true,
            TriangleFeature::Edge(k) => self.supports_at_edge(self.edges_of[triangle as usize][k], v, height, slope),
            TriangleFeature::Corner(k) => self.supports_at_vertex(self.joined[triangle as usize][k], v, height, slope),
        }
    }

    fn all_fall_away(&self, triangles: &[u32], falls: impl Fn(DVec3) -> bool) -> bool {
        triangles.iter().all(|&triangle| self.corners(triangle).into_iter().all(&falls))
    }

    /// Whether the surface around a vertex lies in the plane perpendicular to `v`: all of it, along a line, or not.
    /// Heights up to `tolerance` (m) count as zero.
    pub(crate) fn flatness(&self, vertex: u32, v: DVec3, tolerance: f64) -> Flatness {
        let Some(&x) = self.vertices.get(vertex as usize) else { return Flatness::Corner };
        let level = |w: DVec3| (w - x).dot(v).abs() <= tolerance;
        let around = self.at_vertex.of(vertex as usize);
        let mut straight = None;
        for &t in around {
            let others = self.joined[t as usize].map(|n| self.vertices[n as usize]);
            for w in others.into_iter().filter(|w| *w != x && level(*w)) {
                let d = (w - x).normalize_or_zero();
                if straight.is_none() && around.iter().any(|&u| self.contains_direction(u, vertex, -d, v, tolerance)) {
                    straight = Some(d);
                }
            }
        }
        let Some(along) = straight else { return Flatness::Corner };
        // The vertex is inside its patch when every edge at it lies between two coplanar triangles.
        let inner = around.iter().all(|&t| {
            let own = self.joined[t as usize];
            self.edges_of[t as usize].iter().enumerate().all(|(k, &edge)| {
                let meets = own[k] == vertex || own[(k + 1) % 3] == vertex;
                !meets || self.edges[edge as usize].flat
            })
        });
        if inner { Flatness::Inner } else { Flatness::Straight(along) }
    }

    /// Whether a triangle at a vertex contains the direction `d` of the plane perpendicular to `v`.
    fn contains_direction(&self, triangle: u32, vertex: u32, d: DVec3, v: DVec3, tolerance: f64) -> bool {
        let own = self.joined[triangle as usize];
        let Some(k) = own.iter().position(|&n| n == vertex) else { return false };
        let at = |i: usize| self.vertices[own[(k + i) % 3] as usize];
        let (p, q) = ((at(1) - at(0)), (at(2) - at(0)));
        let along =
            |e: DVec3| e.dot(v).abs() <= tolerance && e.dot(d) > 0.0 && (e - d * e.dot(d)).length() <= tolerance;
        if along(p) || along(q) {
            return true;
        }
        let level = |e: DVec3| e.dot(v).abs() <= tolerance;
        let normal = p.cross(q);
        level(p) && level(q) && p.cross(d).dot(normal) > 0.0 && d.cross(q).dot(normal) > 0.0
    }
}

/// How much of the surface around a vertex lies in a plane through it.
pub(crate) enum Flatness {
    /// All of it.
    Inner,
    /// The vertex lies on a straight border or ridge along this direction.
    Straight(DVec3),
    Corner,
}

fn falls_away(step: DVec3, v: DVec3, height: f64, slope: f64) -> bool {
    let rise = v.dot(step);
    // The slope is zero in most calls, which saves the square root.
    rise <= height || (slope > 0.0 && rise <= height + slope * step.length())
}
