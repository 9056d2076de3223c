//! Triangle meshes: readers and writers, a diagnosis that says what is wrong and where, and exact mass properties.
//!
//! The mass properties of a mesh are exact: a solid of uniform density bounded by triangles has polynomial integrals,
//! which are summed here with errors of a few units in the last place, also for a mesh that is not convex, has voids,
//! or lies far from the origin of its file (thesis 3.2). SI units, f64, right-handed; triangles run anticlockwise
//! seen from outside. Nothing here reads a file, prints or panics.
//!
//! | module | holds |
//! |---|---|
//! | [`triangle_mesh`] | [`TriangleMesh`]: vertices and triangles that are known to be readable; [`MeshError`] |
//! | [`mod@format`] | [`MeshFormat`]: which format a file is in; reading and writing any of them |
//! | [`obj`], [`stl`], [`off`], [`ply`] | the formats, in f64, errors with line or byte and the value: [`ReadError`] |
//! | [`diagnosis`] | [`diagnose`]: open edges, wrong winding, inside out, ... each with count, place and repair |
//! | [`mod@repair`] | [`repair()`]: weld, flip, fill holes, drop what is degenerate, with a report |
//! | [`mod@weld`] | [`weld()`]: merges vertices within a tolerance |
//! | [`solid_mesh`] | [`SolidMesh`]: a mesh that is known to bound a solid |
//! | [`volume_integrals`] | volume, centroid and second moment of a solid |
//! | [`surface_integrals`] | area, centroid and second moment of a surface |
//! | [`mass_properties`] | [`solid_mass_properties`], [`hollow_mass_properties`] from an [`Amount`] |
//! | [`primitives`] | box, sphere, ellipsoid, cylinder, cone, capsule, torus, half-ball |
//! | | solid and hollow in closed form, and as meshes |
//! | [`mod@prism`] | [`prism()`], [`wedge`]: solids over a polygon, and stones of an arch; [`PrismError`] |
//! | [`frames`] | meshes about their centre of mass, along their principal axes |
//! | [`monte_carlo`] | [`MonteCarlo`]: seeded estimates with standard errors, to set beside the exact values |
//! | [`reference_point`] | what the thesis's choices of a reference point cost in accuracy |
//! | [`mod@convexity`] | [`convexity()`]: how far a solid is from convex |
//! | [`convex_solid`] | [`ConvexSolid`]: a solid known to be convex, and the half-space test |
//! | [`convex_hull`] | [`ConvexHull`] of points, exact for their coordinates |
//! | [`decomposition`] | [`convex_decomposition`]: convex parts that fill a solid exactly |
//! | [`point_location`] | [`PointLocator`]: inside, on the surface or outside, exactly |
//! | [`mod@winding_number`] | [`winding_number()`]: the generalised one, also of open surfaces |
//! | `defect` | what is wrong with a mesh, by kind |
//! | `mend` | the mends that repair knows |
//! | `mesh_builder` | a mesh that is being read |
//! | `decimal` | decimal numbers from bytes, to the nearest f64 |
//! | `words` | words of a text file, with their lines |
//! | `polygon` | polygons to triangles |
//! | `nesting` | which components of a mesh face the wrong way, given which lie inside which |
//! | `predicates` | exact signs of determinants, by the crate `robust` |
//! | `triangle_tree` | a tree of bounding boxes over the triangles of a mesh, for lines along z |
//! | `write_error` | why a mesh cannot be written |
//!
//! This crate is all that a program needs to name: what its signatures speak of is here too, the rest of
//! polhode-spatial under [`spatial`]. Programs of ten lines stand in the folder `examples` of the crate:
//! `mesh_in_a_file` (read, diagnose, weigh) and `compose` (a body of parts).
//!
//! ```
//! use polhode_mesh::{Density, SolidMesh, obj, solid_mass_properties};
//!
//! let file = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
//! let solid = SolidMesh::new(obj::read(file)?)?;
//! let properties = solid_mass_properties(&solid, Density::new(6.0)?)?;
//! assert!((properties.mass() - 1.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Stages
//!
//! In the order of the calls, from a file to mass properties and convex parts; paths are in `src`.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | read | recognises the format | `format.rs` |
//! | | reads vertices and triangles | `obj.rs`, `stl.rs`, `off.rs`, `ply.rs` |
//! | mesh | checks that coordinates are finite and that triangles name vertices | `triangle_mesh.rs` |
//! | diagnosis | finds what keeps the mesh from bounding a solid, and where | `diagnosis.rs`, `topology.rs` |
//! | repair | mends what can be mended safely, and reports it | `repair.rs`, `weld.rs` |
//! | solid | accepts a mesh without such defects and with positive volume | `solid_mesh.rs` |
//! | integrals | sums volume, centroid, second moment about a local point | `volume_integrals.rs`, `moment_sums.rs` |
//! | mass properties | scales them by a mass or a density | `mass_properties.rs` |
//! | convexity | measures how far the solid is from convex | `convexity.rs` |
//! | decomposition | cuts it into convex parts along planes | `decomposition.rs`, `convex_hull.rs` |

pub mod convex_hull;
pub mod convex_solid;
pub mod convexity;
pub mod decomposition;
pub mod diagnosis;
pub mod format;
pub mod frames;
pub mod mass_properties;
pub mod monte_carlo;
pub mod obj;
pub mod off;
pub mod ply;
pub mod point_location;
pub mod primitives;
pub mod prism;
pub mod read_error;
pub mod reference_point;
pub mod repair;
pub mod solid_mesh;
pub mod stl;
pub mod surface_integrals;
pub mod triangle_mesh;
pub mod volume_integrals;
pub mod weld;
pub mod winding_number;

mod decimal;
mod defect;
mod mend;
mod mesh_builder;
mod mesh_error;
mod mesh_format;
mod moment_sums;
mod nesting;
mod polygon;
mod predicates;
mod topology;
mod triangle_tree;
mod words;
mod write_error;

pub use convex_hull::{ConvexHull, HullError};
pub use convex_solid::{ConvexSolid, NotConvexError};
pub use convexity::{Convexity, convexity};
pub use decomposition::{Decomposition, DecompositionError, DecompositionSettings, convex_decomposition};
pub use diagnosis::{Defect, DefectKind, Diagnosis, Location, diagnose};
pub use format::{Encoding, MeshFormat, WriteError};
pub use frames::{in_principal_axes, recentered};
pub use mass_properties::{Amount, hollow_mass_properties, solid_mass_properties};
pub use monte_carlo::{Estimate, MonteCarlo, MonteCarloError, MonteCarloEstimate};
pub use point_location::{PointLocation, PointLocator};
pub use primitives::{
    Capsule, Cone, Cuboid, Cylinder, Ellipsoid, HalfBall, Primitive, PrimitiveError, Refinement, Sphere, Torus,
    box_mesh, hollow_box, hollow_sphere, solid_box, solid_sphere,
};
pub use prism::{PrismError, prism, wedge};
pub use read_error::{Place, ReadError, ReadErrorKind};
pub use reference_point::{
    ReferencePoint, ReferencePointCost, compare_reference_points, compare_reference_points_hollow,
    plain_volume_integrals,
};
pub use repair::{Repair, RepairOptions, RepairReport, RepairStep, repair};
pub use solid_mesh::SolidMesh;
pub use surface_integrals::SurfaceIntegrals;
pub use triangle_mesh::{Bounds, MeshError, TriangleMesh};
pub use volume_integrals::VolumeIntegrals;
pub use weld::{Welded, weld};
pub use winding_number::winding_number;

pub use polhode_spatial as spatial;
pub use spatial::{
    DMat3, DVec3, Density, Inertia, InertiaError, Mass, MassProperties, MassPropertiesError, Pose, PrincipalAxes,
    Rotation,
};

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
