//! Mass properties of primitives in closed form, and meshes of them at a chosen refinement.
//!
//! The origin of a primitive's frame is the centre of mass of the solid; bodies of revolution stand along z.
//!
//! | file | body | parameters, m |
//! |---|---|---|
//! | `cuboid` | [`Cuboid`]: a box | full edges |
//! | `sphere` | [`Sphere`] | radius |
//! | `ellipsoid` | [`Ellipsoid`] | semi-axes |
//! | `cylinder` | [`Cylinder`] | radius, height |
//! | `cone` | [`Cone`], apex towards +z, origin a quarter of the height above the base | radius, height |
//! | `capsule` | [`Capsule`] | radius, height without the caps |
//! | `torus` | [`Torus`] | radius of the ring, radius of the tube |
//! | `half_ball` | [`HalfBall`], dome towards +z, origin 3/8 of the radius above its flat face | radius |
//! | `surface_moments` | second moments of an ellipsoid's surface, for which there is no elementary form | |
//! | `refinement` | [`Refinement`]: how fine a mesh is | |
//! | `revolution`, `icosphere` | meshes of bodies of revolution and of the sphere | |
//!
//! A hollow primitive has all its mass in its surface, uniform per area, flat faces included; its centre of mass is
//! then not the origin where the solid is not symmetric (cone, half-ball).
//!
//! A mesh inscribed in a curved body lacks matter where it counts most for the inertia, at the surface (thesis 3.2).
//! The error falls with the square of the edge: by 4 from one [`Refinement`] to the next. Whoever knows the body
//! exactly takes the exact values and leaves the mesh to collision, as the thesis advises: mass properties are a value
//! beside the mesh, not a property of it (in a scene: the keys `mass` and `inertia` of the body).
//!
//! ```
//! use polhode_mesh::{Density, Refinement, Torus, solid_mass_properties};
//! let (torus, density) = (Torus::new(1.0, 0.25)?, Density::new(1.0)?);
//! let exact = torus.solid(density)?;
//! let error = |level: u32| -> Result<f64, Box<dyn std::error::Error>> {
//!     let mesh = torus.mesh(Refinement::new(level)?)?;
//!     Ok(1.0 - solid_mass_properties(&mesh, density)?.inertia().matrix().z_axis.z / exact.inertia().matrix().z_axis.z)
//! };
//! assert!(error(1)? > 0.03 && (error(2)? / error(3)? - 4.0).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Sources: docs/REFERENCES.md, Goldstein 5.3 for solids; surfaces by the same integrals over their parts; all are
//! checked against the integrals over meshes of rising refinement.

mod capsule;
mod cone;
mod cuboid;
mod cylinder;
mod ellipsoid;
mod half_ball;
mod icosphere;
mod refinement;
mod revolution;
mod sphere;
mod surface_moments;
mod torus;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cuboid::{Cuboid, box_mesh, hollow_box, solid_box};
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use half_ball::HalfBall;
pub use refinement::Refinement;
pub use sphere::{Sphere, hollow_sphere, solid_sphere};
pub use torus::Torus;

use crate::triangle_mesh::MeshError;
use crate::{Amount, SolidMesh};
use glam::DVec3;
use polhode_spatial::{Inertia, MassProperties, MassPropertiesError};
use thiserror::Error;

/// Why a primitive, its mass properties or its mesh does not exist.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PrimitiveError {
    /// An edge is not positive and finite.
    #[error("the edges of a box must be positive and finite, found ({}, {}, {}) m", .0.x, .0.y, .0.z)]
    Size(DVec3),
    /// The radius is not positive and finite.
    #[error("a radius must be positive and finite, found {0} m")]
    Radius(f64),
    /// The height is not positive and finite.
    #[error("a height must be positive and finite, found {0} m")]
    Height(f64),
    /// A semi-axis is not positive and finite.
    #[error("the semi-axes of an ellipsoid must be positive and finite, found ({}, {}, {}) m", .0.x, .0.y, .0.z)]
    SemiAxes(DVec3),
    /// The tube closes the hole.
    #[error("the tube of a torus (radius {minor} m) must be thinner than its ring (radius {major} m)")]
    Tube {
        /// Radius of the ring, m.
        major: f64,
        /// Radius of the tube, m.
        minor: f64,
    },
    /// More refined than memory holds.
    #[error("a mesh can be refined {} times at the most, found {}", Refinement::FINEST, .0)]
    Refinement(u32),
    /// Mass or inertia over- or underflow.
    #[error(transparent)]
    MassProperties(#[from] MassPropertiesError),
    /// The primitive is so thin that its mesh is flat to rounding.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Any of the primitives.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Primitive {
    /// A box.
    Box(Cuboid),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid.
    Ellipsoid(Ellipsoid),
    /// A cylinder.
    Cylinder(Cylinder),
    /// A cone.
    Cone(Cone),
    /// A capsule.
    Capsule(Capsule),
    /// A torus.
    Torus(Torus),
    /// Half a ball.
    HalfBall(HalfBall),
}

/// The same call for every kind.
macro_rules! each {
    ($primitive:expr, $body:ident => $call:expr) => {
        match $primitive {
            Primitive::Box($body) => $call,
            Primitive::Sphere($body) => $call,
            Primitive::Ellipsoid($body) => $call,
            Primitive::Cylinder($body) => $call,
            Primitive::Cone($body) => $call,
            Primitive::Capsule($body) => $call,
            Primitive::Torus($body) => $call,
            Primitive::HalfBall($body) => $call,
        }
    };
}

impl Primitive {
    /// The word for its kind, as scene files write it.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Box(_) => "box",
            Self::Sphere(_) => "sphere",
            Self::Ellipsoid(_) => "ellipsoid",
            Self::Cylinder(_) => "cylinder",
            Self::Cone(_) => "cone",
            Self::Capsule(_) => "capsule",
            Self::Torus(_) => "torus",
            Self::HalfBall(_) => "half-ball",
        }
    }

    /// Filled with matter, from its density (kg/m^3) or mass.
    ///
    /// # Errors
    /// [`PrimitiveError::MassProperties`] when mass or inertia over- or underflow.
    pub fn solid(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        each!(self, body => body.solid(amount))
    }

    /// All its mass in its surface, from its density (kg/m^2) or mass.
    ///
    /// # Errors
    /// As [`Primitive::solid`].
    pub fn hollow(&self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        each!(self, body => body.hollow(amount))
    }

    /// A mesh with its vertices on the surface. That of a box is the box, whatever the refinement.
    ///
    /// # Errors
    /// [`PrimitiveError::Mesh`] when the body is so thin that its mesh is flat to rounding.
    pub fn mesh(&self, refinement: Refinement) -> Result<SolidMesh, PrimitiveError> {
        each!(self, body => body.mesh(refinement))
    }
}

/// A uniform body whose amount of matter is still to be said; its axes are principal.
#[derive(Debug, Clone, Copy)]
struct Uniform {
    /// Volume (m^3) of a solid, area (m^2) of a hollow body.
    measure: f64,
    /// Height of the centre of mass above the origin, along z, m.
    center_z: f64,
    /// Moments about the centre of mass per mass, m^2.
    moments: DVec3,
}

impl Uniform {
    /// A body whose centre of mass is the origin.
    const fn centered(measure: f64, moments: DVec3) -> Self {
        Self { measure, center_z: 0.0, moments }
    }

    fn body(self, amount: impl Into<Amount>) -> Result<MassProperties, PrimitiveError> {
        let mass = amount.into().mass(self.measure)?;
        let inertia = Inertia::from_diagonal(mass.get() * self.moments).map_err(MassPropertiesError::from)?;
        Ok(MassProperties::new(mass, DVec3::Z * self.center_z, inertia))
    }
}

/// Moments of a body of revolution: twice about the axes across, once about its own.
fn across_and_along(across: f64, along: f64) -> DVec3 {
    DVec3::new(across, across, along)
}

/// Whether a length is one.
fn is_length(length: f64) -> bool {
    length > 0.0 && length.is_finite()
}

fn checked_radius(radius: f64) -> Result<f64, PrimitiveError> {
    if is_length(radius) { Ok(radius) } else { Err(PrimitiveError::Radius(radius)) }
}

fn checked_height(height: f64) -> Result<f64, PrimitiveError> {
    if is_length(height) { Ok(height) } else { Err(PrimitiveError::Height(height)) }
}
