//! Triangle meshes as ground: surfaces, open or closed, of a body that does not move.

use super::error::{ShapeError, check_point};
use super::point_cloud::largest_distance;
use glam::DVec3;
use polhode_spatial::Pose;

/// A surface of triangles. Vertices, triangles (as faces) and edges are numbered as given and found.
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleMesh {
    pub(crate) vertices: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    size: f64,
}

impl TriangleMesh {
    /// From vertices in the body's frame (m) and triangles, anticlockwise seen from outside.
    ///
    /// # Errors
    /// When there is no triangle, one names a vertex that does not exist, or a coordinate is not finite.
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, ShapeError> {
        if triangles.is_empty() {
            return Err(ShapeError::NoPart { what: "triangles" });
        }
        let most = vertices.len().max(triangles.len());
        if u32::try_from(most).is_err() {
            return Err(ShapeError::TooManyPoints { count: most, limit: u32::MAX as usize });
        }
        vertices.iter().try_for_each(|&vertex| check_point("vertex", vertex))?;
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices.len()) {
                return Err(ShapeError::NoSuchVertex { triangle, vertex, vertices: vertices.len() });
            }
        }
        let size = largest_distance(&vertices);
        Ok(Self { vertices, triangles, size })
    }

    /// Vertices in the body's frame, m.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Corners of every triangle, anticlockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        let vertices = self.vertices.iter().map(|&vertex| pose.transform_point(vertex)).collect();
        Self::new(vertices, self.triangles.clone())
    }

    pub(super) const fn size(&self) -> f64 {
        self.size
    }
}
