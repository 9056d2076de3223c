//! Solid meshes: triangle meshes that are known to bound a solid.

use crate::VolumeIntegrals;
use crate::diagnosis::diagnose;
use crate::surface_integrals::triangle_area;
use crate::triangle_mesh::{MeshError, TriangleMesh};
use crate::volume_integrals::volume_rounding;

/// A closed, consistently wound mesh that faces outward and encloses a positive volume.
///
/// It may consist of several parts, be non-convex, have holes like a torus and closed voids inside (their surfaces face
/// the void). What is not checked: whether the surface crosses itself, or parts overlap without one holding the other.
/// Degenerate triangles are allowed, because they change no integral.
#[derive(Debug, Clone, PartialEq)]
pub struct SolidMesh {
    mesh: TriangleMesh,
    integrals: VolumeIntegrals,
}

impl SolidMesh {
    /// Takes a mesh that has none of the defects that [`DefectKind::prevents_solid`](crate::DefectKind::prevents_solid)
    /// names.
    ///
    /// # Errors
    /// [`MeshError::NotSolid`] with those defects, [`MeshError::NoVolume`] when the surface is flat or its volume
    /// over- or underflows.
    pub fn new(mesh: TriangleMesh) -> Result<Self, MeshError> {
        let mut defects = diagnose(&mesh).defects;
        defects.retain(|defect| defect.kind.prevents_solid());
        if !defects.is_empty() {
            return Err(MeshError::NotSolid(defects));
        }
        let integrals = VolumeIntegrals::of(&mesh);
        let area = mesh.corner_positions().map(triangle_area).sum();
        let rounding = volume_rounding(area, mesh.bounds().largest_coordinate());
        // Written so that NaN fails too.
        if !(integrals.volume > rounding && integrals.volume.is_finite()) {
            return Err(MeshError::NoVolume { volume: integrals.volume, area });
        }
        Ok(Self { mesh, integrals })
    }

    /// The mesh.
    pub const fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// Volume, centroid and second moment of the solid.
    pub const fn volume_integrals(&self) -> &VolumeIntegrals {
        &self.integrals
    }

    /// Gives the mesh back.
    pub fn into_mesh(self) -> TriangleMesh {
        self.mesh
    }
}
