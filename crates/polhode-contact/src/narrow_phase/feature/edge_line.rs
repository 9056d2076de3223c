//! An edge of a polyhedron or of a triangle mesh, in its body's frame.

use crate::{ConvexPolyhedron, Edge, Shape, TriangleMesh};
use glam::DVec3;

/// An edge in its body's frame.
pub(crate) struct EdgeLine {
    pub(crate) middle: DVec3,
    pub(crate) direction: DVec3,
    pub(crate) length: f64,
    /// A direction out of the body. For a polyhedron: the sum of the normals of the two faces and of the directions out
    /// of them perpendicular to the edge. For a mesh: the sum of the directions out of the triangles at the edge.
    pub(crate) outward: DVec3,
}

impl EdgeLine {
    #[inline]
    pub(crate) const fn of_edge(edge: &Edge) -> Self {
        Self { middle: edge.middle, direction: edge.direction, length: edge.length, outward: edge.outward }
    }

    #[inline]
    pub(crate) fn of_polyhedron(polyhedron: &ConvexPolyhedron, index: u32) -> Option<Self> {
        polyhedron.edges.get(index as usize).map(Self::of_edge)
    }

    pub(crate) fn of_mesh(mesh: &TriangleMesh, index: u32) -> Option<Self> {
        let edge = mesh.edges.get(index as usize)?;
        let [from, to] = edge.vertices.map(|v| mesh.vertices[v as usize]);
        let middle = 0.5 * (from + to);
        Some(Self { middle, direction: edge.direction, length: edge.length, outward: edge.outward })
    }
}

impl Shape {
    /// An edge by its number; none where the shape has no such edge.
    pub(crate) fn edge_line(&self, index: u32) -> Option<EdgeLine> {
        match self {
            Self::Convex(polyhedron) => EdgeLine::of_polyhedron(polyhedron, index),
            Self::TriangleMesh(mesh) => EdgeLine::of_mesh(mesh, index),
            _ => None,
        }
    }
}
