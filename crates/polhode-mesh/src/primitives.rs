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
//! | `primitive` | [`Primitive`]: any of them | |
//! | `uniform` | a body of uniform density by its measure and moments per mass | |
//! | `error` | [`PrimitiveError`], checks of lengths | |
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
mod error;
mod half_ball;
mod icosphere;
mod primitive;
mod refinement;
mod revolution;
mod sphere;
mod surface_moments;
mod torus;
mod uniform;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cuboid::{Cuboid, box_mesh, hollow_box, solid_box};
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use error::PrimitiveError;
pub use half_ball::HalfBall;
pub use primitive::Primitive;
pub use refinement::Refinement;
pub use sphere::{Sphere, hollow_sphere, solid_sphere};
pub use torus::Torus;
