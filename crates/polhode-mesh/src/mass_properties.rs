//! Mass properties of uniform bodies given by meshes.
//!
//! With the second moment S about the centre of mass, the inertia is `I = rho (tr S 1 - S)` (thesis 3.2,
//! equation 1); its diagonal is formed as `rho (Syy + Szz)`, without the difference, so that a needle keeps the digits
//! of its small moment. A hollow body is its surface with a uniform mass per area: a wall that is thin beside the body.

use crate::triangle_mesh::{MeshError, TriangleMesh};
use crate::{SolidMesh, SurfaceIntegrals};
use glam::{DMat3, DVec3};
use polhode_spatial::{Density, Inertia, Mass, MassProperties, MassPropertiesError};

/// How much matter a body holds: so much per volume (or area), or so much in all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// kg/m^3 of a solid, kg/m^2 of a hollow body.
    Density(Density),
    /// Of the whole body.
    Mass(Mass),
}

impl From<Density> for Amount {
    fn from(density: Density) -> Self {
        Self::Density(density)
    }
}

impl From<Mass> for Amount {
    fn from(mass: Mass) -> Self {
        Self::Mass(mass)
    }
}

impl Amount {
    /// Mass of a body of this volume (m^3) or, if hollow, area (m^2), kg.
    pub(crate) fn mass(self, measure: f64) -> Result<Mass, MassPropertiesError> {
        match self {
            Self::Density(density) => Mass::new(density.get() * measure),
            Self::Mass(mass) => Ok(mass),
        }
    }
}

/// Mass properties of a solid of uniform density, from its [`Density`] (kg/m^3) or its [`Mass`]; the centre of mass is
/// in the frame of the mesh, the inertia about the centre of mass in the axes of the mesh.
///
/// ```
/// use polhode_mesh::{DVec3, Mass, box_mesh, solid_mass_properties};
/// let brick = solid_mass_properties(&box_mesh(DVec3::new(1.0, 2.0, 3.0))?, Mass::new(6.0)?)?;
/// assert!((brick.inertia().matrix().x_axis.x - 6.5).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`MeshError::MassProperties`] when mass or inertia over- or underflow.
pub fn solid_mass_properties(solid: &SolidMesh, amount: impl Into<Amount>) -> Result<MassProperties, MeshError> {
    let integrals = solid.volume_integrals();
    Ok(from_moments(integrals.volume, integrals.centroid, &integrals.second_moment, amount.into())?)
}

/// Mass properties of a hollow body: all its mass in the surface, uniform per area, from its [`Density`] (kg/m^2) or
/// its [`Mass`]. The mesh may be open.
///
/// # Errors
/// [`MeshError::NoArea`] when every triangle is degenerate, [`MeshError::MassProperties`] when mass or inertia over-
/// or underflow.
pub fn hollow_mass_properties(mesh: &TriangleMesh, amount: impl Into<Amount>) -> Result<MassProperties, MeshError> {
    let integrals = SurfaceIntegrals::of(mesh);
    if !(integrals.area > 0.0 && integrals.area.is_finite()) {
        return Err(MeshError::NoArea(integrals.area));
    }
    Ok(from_moments(integrals.area, integrals.centroid, &integrals.second_moment, amount.into())?)
}

/// From volume (m^3) or area (m^2), centroid and the second moment S about it.
fn from_moments(
    measure: f64,
    centroid: DVec3,
    s: &DMat3,
    amount: Amount,
) -> Result<MassProperties, MassPropertiesError> {
    let mass = amount.mass(measure)?;
    if !centroid.is_finite() {
        return Err(MassPropertiesError::CenterOfMass);
    }
    let (xx, yy, zz) = (s.x_axis.x, s.y_axis.y, s.z_axis.z);
    let (xy, xz, yz) = (s.y_axis.x, s.z_axis.x, s.z_axis.y);
    let tr_s_minus_s =
        DMat3::from_cols(DVec3::new(yy + zz, -xy, -xz), DVec3::new(-xy, xx + zz, -yz), DVec3::new(-xz, -yz, xx + yy));
    // The mass may be given, so the density is their quotient; for a given density it is that to one rounding.
    let inertia = Inertia::new(tr_s_minus_s * (mass.get() / measure))?;
    Ok(MassProperties::new(mass, centroid, inertia))
}
