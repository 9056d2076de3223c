//! Triangles, normals and sharp edges of every shape.
//!
//! A body is drawn as parts: a mesh of a standard size, scaled, turned and moved into its place, so that many bodies
//! share few meshes. Round shapes are inscribed in the true ones.
//!
//! | module | holds |
//! |---|---|
//! | [`detail`] | how fine round shapes are |
//! | [`revolution`] | surfaces of revolution |
//! | [`round`] | sphere, cylinder, cone, capsule and torus |
//! | [`polyhedron`] | convex polyhedra |
//! | [`triangles`] | surfaces of triangles, smooth where they bend little |
//! | [`tube`] | tubes along a line |
//! | [`points`] | sets of points |
//! | [`part`], [`parts`] | a part, and the parts of any shape |

pub mod detail;
pub mod part;
pub mod parts;
pub mod points;
pub mod polyhedron;
pub mod revolution;
pub mod round;
pub mod triangles;
pub mod tube;

pub use detail::Detail;
pub use part::Part;
pub use parts::{Parts, ShownPoint, parts_of};
