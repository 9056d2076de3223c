//! Meshes in the frames that their mass properties give: about the centre of mass, along the principal axes.

use crate::triangle_mesh::{MeshError, TriangleMesh};
use glam::DVec3;
use polhode_spatial::{MassProperties, Pose};

/// The mesh with the centre of mass of `body` as origin; axes as they are.
///
/// # Errors
/// [`MeshError::NotFinite`] when a coordinate overflows.
pub fn recentered(mesh: &TriangleMesh, body: &MassProperties) -> Result<TriangleMesh, MeshError> {
    mesh.translated(-body.center_of_mass())
}

/// The mesh with the centre of mass of `body` as origin and its principal axes as axes: moments ascending from x to z,
/// right-handed, with the signs of [`PrincipalAxes`](polhode_spatial::PrincipalAxes).
///
/// ```
/// use polhode_mesh::{DVec3, Density, SolidMesh, box_mesh, in_principal_axes, solid_mass_properties};
/// let (mesh, density) = (box_mesh(DVec3::new(1.0, 2.0, 3.0))?, Density::new(1.0)?);
/// let turned = in_principal_axes(mesh.mesh(), &solid_mass_properties(&mesh, density)?)?;
/// let body = solid_mass_properties(&SolidMesh::new(turned)?, density)?;
/// assert!((body.inertia().matrix().x_axis.x - 2.5).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`recentered`].
pub fn in_principal_axes(mesh: &TriangleMesh, body: &MassProperties) -> Result<TriangleMesh, MeshError> {
    // Moved first and turned then: the other way round would round at the size of the distance from the origin.
    let turn = Pose::new(body.principal_axes().rotation().inverse(), DVec3::ZERO);
    recentered(mesh, body)?.in_frame(&turn)
}
