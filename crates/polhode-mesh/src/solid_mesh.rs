//! Solid meshes: triangle meshes that are known to bound a solid.

use crate::VolumeIntegrals;
use crate::defect::{Defect, DefectKind};
use crate::diagnosis::diagnose;
use crate::surface_integrals::triangle_area;
use crate::triangle_mesh::{MeshError, TriangleMesh};
use crate::volume_integrals::volume_rounding;
use crate::weld::weld;
use polhode_spatial::Handedness;

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
    /// [`MeshError::Seams`] with those defects where merging doubled vertices would mend them, [`MeshError::NotSolid`]
    /// where it would not, [`MeshError::NoVolume`] when the surface is flat or its volume
    /// over- or underflows.
    pub fn new(mesh: TriangleMesh) -> Result<Self, MeshError> {
        let mut defects = diagnose(&mesh).defects;
        defects.retain(|defect| defect.kind.prevents_solid());
        if !defects.is_empty() {
            return Err(match seams(&mesh, &defects) {
                Some(distance_m) => MeshError::Seams { defects, distance_m },
                None => MeshError::NotSolid(defects),
            });
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

    /// The image in a mirror in the plane x = 0, with its triangles turned over.
    ///
    /// # Errors
    /// As [`SolidMesh::new`].
    pub fn mirrored(&self) -> Result<Self, MeshError> {
        let vertices = self.mesh.vertices().iter().map(|&vertex| Handedness::Mirrored.vector(vertex)).collect();
        Self::new(TriangleMesh::new(vertices, self.mesh.triangles().to_vec())?.flipped())
    }

    /// Gives the mesh back.
    pub fn into_mesh(self) -> TriangleMesh {
        self.mesh
    }
}

/// Distances within which doubled vertices are looked for, in powers of ten of the mesh's diagonal: from the rounding
/// of numbers of ten digits to the thickness of a line in a drawing of the mesh. Larger ones would merge what is drawn
/// apart.
const SEAM_POWERS: std::ops::RangeInclusive<i32> = -10..=-4;

/// The distance (m) within which vertices must be merged to make a solid of an open mesh; none where that does not mend
/// it.
fn seams(mesh: &TriangleMesh, defects: &[Defect]) -> Option<f64> {
    if !defects.iter().any(|defect| defect.kind == DefectKind::OpenEdge) {
        return None;
    }
    let bounds = mesh.bounds();
    // The next power of ten, so that the distance reads well.
    let power = libm::ceil(libm::log10((bounds.max - bounds.min).length())) as i32;
    let distances = SEAM_POWERS.filter_map(|below| format!("1e{}", power.saturating_add(below)).parse().ok());
    std::iter::once(0.0).chain(distances).find(|&distance| {
        weld(mesh, distance).is_ok_and(|welded| {
            let found = diagnose(&welded.mesh);
            let is_flat = found.defects.iter().any(|defect| defect.kind == DefectKind::DegenerateTriangle);
            welded.merged > 0 && found.is_solid() && !is_flat
        })
    })
}
