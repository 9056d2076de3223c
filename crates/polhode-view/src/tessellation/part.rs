//! A part of a body: a mesh in its place.

use polhode::spatial::{DVec3, Rotation};

/// A mesh of a [`MeshLibrary`](crate::MeshLibrary), scaled along its axes, then turned, then moved, in the body's
/// frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Number of the mesh in its library.
    pub mesh: usize,
    /// Where the mesh's origin goes, m.
    pub position: DVec3,
    /// From the mesh's axes to the body's.
    pub orientation: Rotation,
    /// Factors along the mesh's axes.
    pub scale: DVec3,
}

impl Part {
    /// A mesh as it is.
    pub fn of(mesh: usize) -> Self {
        Self { mesh, position: DVec3::ZERO, orientation: Rotation::IDENTITY, scale: DVec3::ONE }
    }

    /// A point of the mesh in the body's frame.
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.position + self.orientation.rotate(point * self.scale)
    }

    /// A unit normal of the mesh in the body's frame: a surface that is stretched tilts its normals the other way.
    pub fn normal(&self, normal: DVec3) -> DVec3 {
        self.orientation.rotate((normal / self.scale).normalize_or_zero())
    }
}
