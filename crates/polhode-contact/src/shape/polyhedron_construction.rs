//! Constructors of convex polyhedra (boxes, points, meshes, faces), rotation and translation.

use super::error::{ShapeError, check_length, check_point};
use super::polyhedron::ConvexPolyhedron;
use super::{hull, topology};
use glam::DVec3;
use polhode_mesh::SolidMesh;
use polhode_spatial::Rotation;

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

    /// The convex hull of some points, m; points inside it or inside a face are omitted.
    ///
    /// # Errors
    /// When there are fewer than four points, they are flat, a coordinate is not finite, or the hull fails its checks.
    pub fn from_points(points: &[DVec3]) -> Result<Self, ShapeError> {
        hull::from_points(points)
    }

    /// From a closed mesh that is convex; coplanar triangles become one face.
    ///
    /// # Errors
    /// When the mesh is not convex, or flat.
    pub fn from_mesh(mesh: &SolidMesh) -> Result<Self, ShapeError> {
        let mesh = mesh.mesh();
        hull::from_triangles(mesh.vertices(), mesh.triangles())
    }

    /// From vertices (m) and faces, each an anticlockwise loop of vertex indices seen from outside.
    ///
    /// # Errors
    /// When the faces do not close a surface, are not plane, or the body is not convex.
    pub fn from_faces(vertices: Vec<DVec3>, faces: Vec<Vec<u32>>) -> Result<Self, ShapeError> {
        topology::build(vertices, faces)
    }

    /// The same polyhedron rotated about the frame's origin.
    pub fn rotated(&self, rotation: Rotation) -> Self {
        let mut turned = self.clone();
        turned.vertices.iter_mut().for_each(|vertex| *vertex = rotation.rotate(*vertex));
        turned.faces.iter_mut().for_each(|face| face.normal = rotation.rotate(face.normal));
        turned.edges.iter_mut().for_each(|edge| edge.direction = rotation.rotate(edge.direction));
        turned.corner_sides.iter_mut().for_each(|side| *side = rotation.rotate(*side));
        topology::complete_edges(&mut turned);
        turned
    }

    /// The same polyhedron translated by a vector, m.
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
}
