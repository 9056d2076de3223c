//! Convex polyhedra with faces of any number of vertices.
//!
//! A face is an anticlockwise loop of vertices (seen from outside) with its outward unit normal and the offset of its
//! plane, `normal . x = offset`. An edge has two vertices and two faces: `faces[0]` is the one whose loop runs from
//! `vertices[0]` to `vertices[1]`, so that `n_0 x n_1` points along the edge.

use crate::shape::lists::Lists;
use glam::DVec3;

/// A face, borrowed from its polyhedron.
#[derive(Debug, Clone, Copy)]
pub struct Face<'a> {
    /// The vertices, anticlockwise seen from outside.
    pub vertices: &'a [u32],
    /// The edges: `edges[i]` joins `vertices[i]` to the next one.
    pub edges: &'a [u32],
    /// Outward unit normal.
    pub normal: DVec3,
    /// `normal . x` of the face's points, m.
    pub offset: f64,
    /// For each edge the unit vector in the face's plane, perpendicular to the edge and out of the face.
    pub(crate) sides: &'a [DVec3],
}

/// An edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Its two vertices.
    pub vertices: [u32; 2],
    /// Its two faces; the loop of the first runs along the edge, that of the second against it.
    pub faces: [u32; 2],
    /// Unit vector from the first vertex to the second.
    pub direction: DVec3,
    /// Length, m.
    pub length: f64,
    /// Midpoint, m.
    pub(crate) middle: DVec3,
    /// A direction out of the body.
    pub(crate) outward: DVec3,
}

/// The stored data of a face.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FaceRecord {
    pub(crate) first: usize,
    pub(crate) count: usize,
    pub(crate) normal: DVec3,
    pub(crate) offset: f64,
}

/// A convex polyhedron.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexPolyhedron {
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) faces: Vec<FaceRecord>,
    pub(crate) edges: Vec<Edge>,
    /// Vertex, edge and outward side of every corner of every face, face after face.
    pub(crate) corner_vertices: Vec<u32>,
    pub(crate) corner_edges: Vec<u32>,
    pub(crate) corner_sides: Vec<DVec3>,
    pub(crate) faces_at: Lists,
    pub(crate) edges_at: Lists,
    pub(crate) size: f64,
}

impl ConvexPolyhedron {
    /// Vertices in the body's frame, m.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Largest signed distance of a point from the planes of the faces, m: negative inside, and outside at most the
    /// distance from the body.
    pub(crate) fn outside(&self, x: DVec3) -> f64 {
        self.faces.iter().map(|f| f.normal.dot(x) - f.offset).fold(f64::NEG_INFINITY, f64::max)
    }

    /// How many faces there are.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// A face by its index.
    pub fn face(&self, index: usize) -> Option<Face<'_>> {
        self.faces.get(index).map(|record| self.view(record))
    }

    /// All faces.
    pub fn faces(&self) -> impl Iterator<Item = Face<'_>> {
        self.faces.iter().map(|record| self.view(record))
    }

    /// All edges.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Largest distance between two vertices, m (for more than 1024 vertices the diagonal of the bounding box).
    pub const fn size(&self) -> f64 {
        self.size
    }

    fn view(&self, record: &FaceRecord) -> Face<'_> {
        let corners = record.first..record.first + record.count;
        Face {
            vertices: &self.corner_vertices[corners.clone()],
            edges: &self.corner_edges[corners.clone()],
            normal: record.normal,
            offset: record.offset,
            sides: &self.corner_sides[corners],
        }
    }
}
