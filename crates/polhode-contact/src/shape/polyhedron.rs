//! Convex polyhedra with faces of any number of vertices.
//!
//! A face is an anticlockwise loop of vertices (seen from outside) with its outward unit normal and the offset of its
//! plane, `normal . x = offset`. An edge knows its two vertices and its two faces: `faces[0]` is the one whose loop
//! runs from `vertices[0]` to `vertices[1]`, so that `n_0 x n_1` points along the edge.

use crate::shape::topology;
use crate::shape::{ShapeError, check_length, check_point};
use glam::DVec3;
use polhode_mesh::SolidMesh;
use polhode_spatial::Rotation;

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
    /// Unit vectors in the face's plane, outward across each edge.
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
    /// Middle of its ends, m.
    pub(crate) middle: DVec3,
    /// A direction out of the body.
    pub(crate) outward: DVec3,
}

/// What a polyhedron keeps of a face.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FaceRecord {
    pub(crate) first: usize,
    pub(crate) count: usize,
    pub(crate) normal: DVec3,
    pub(crate) offset: f64,
}

/// Lists of unequal length, one after the other: the faces or the edges that meet at each vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Neighbours {
    pub(crate) starts: Vec<usize>,
    pub(crate) items: Vec<u32>,
}

impl Neighbours {
    /// The list of one vertex.
    pub(crate) fn of(&self, vertex: usize) -> &[u32] {
        &self.items[self.starts[vertex]..self.starts[vertex + 1]]
    }
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
    pub(crate) faces_at: Neighbours,
    pub(crate) edges_at: Neighbours,
    pub(crate) size: f64,
}

impl ConvexPolyhedron {
    /// A box about the origin with full edge lengths, m. Vertex `i` is at `+x` when bit 0 of `i` is set, `+y` bit 1,
    /// `+z` bit 2; the faces are -x, +x, -y, +y, -z, +z. Normals are exact.
    ///
    /// # Errors
    /// When a length is not positive and finite.
    pub fn cuboid(size: DVec3) -> Result<Self, ShapeError> {
        for (what, length) in [("size along x", size.x), ("size along y", size.y), ("size along z", size.z)] {
            check_length(what, length)?;
        }
        let h = 0.5 * size;
        let sign = |i: u32, bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let vertices = (0..8).map(|i| DVec3::new(sign(i, 0) * h.x, sign(i, 1) * h.y, sign(i, 2) * h.z)).collect();
        let loops = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        topology::build(vertices, loops.iter().map(|l| l.to_vec()).collect())
    }

    /// The convex hull of some points, m; points inside it or inside a face are left out.
    ///
    /// # Errors
    /// When there are fewer than four points, they are flat, a coordinate is not finite, or the hull fails its checks.
    pub fn from_points(points: &[DVec3]) -> Result<Self, ShapeError> {
        crate::shape::hull::from_points(points)
    }

    /// From a closed mesh that is convex; coplanar triangles become one face.
    ///
    /// # Errors
    /// When the mesh is not convex, or flat.
    pub fn from_mesh(mesh: &SolidMesh) -> Result<Self, ShapeError> {
        let mesh = mesh.mesh();
        crate::shape::hull::from_triangles(mesh.vertices(), mesh.triangles())
    }

    /// From vertices (m) and faces, each an anticlockwise loop of vertex indices seen from outside.
    ///
    /// # Errors
    /// When the faces do not close a surface, are not plane, or the body is not convex.
    pub fn from_faces(vertices: Vec<DVec3>, faces: Vec<Vec<u32>>) -> Result<Self, ShapeError> {
        topology::build(vertices, faces)
    }

    /// The same polyhedron turned about the frame's origin.
    pub fn rotated(&self, rotation: Rotation) -> Self {
        let mut turned = self.clone();
        turned.vertices.iter_mut().for_each(|vertex| *vertex = rotation.rotate(*vertex));
        turned.faces.iter_mut().for_each(|face| face.normal = rotation.rotate(face.normal));
        turned.edges.iter_mut().for_each(|edge| edge.direction = rotation.rotate(edge.direction));
        turned.corner_sides.iter_mut().for_each(|side| *side = rotation.rotate(*side));
        topology::complete_edges(&mut turned);
        turned
    }

    /// The same polyhedron moved by a vector, m.
    ///
    /// # Errors
    /// When a coordinate becomes too large or is not finite.
    pub fn translated(&self, by: DVec3) -> Result<Self, ShapeError> {
        let mut moved = self.clone();
        for vertex in &mut moved.vertices {
            *vertex += by;
            check_point("vertex", *vertex)?;
        }
        for face in &mut moved.faces {
            face.offset += face.normal.dot(by);
        }
        topology::complete_edges(&mut moved);
        Ok(moved)
    }

    /// Vertices in the body's frame, m.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Signed distance of a place from the planes of the faces, m: negative inside, and no more than the distance outside.
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
