//! Shapes that can touch.
//!
//! The coordinates of a shape are in a frame of its body. The engine uses the central frame, whose origin is the centre
//! of mass; [`Shape::translated`] moves a shape into it. Values are checked when a shape is made ("parse, don't
//! validate"), so that the algorithms need not check them again: all numbers are finite, convex polyhedra are closed
//! and convex, triangles have an area, tori have a hole.
//!
//! | module | holds |
//! |---|---|
//! | `kinds` | [`Shape`] and [`Compound`], which contain each other |
//! | `construction`, `compound`, `solid` | constructors of shapes, and shapes moved within a body |
//! | [`polyhedron`] | convex polyhedra |
//! | `topology`, `hull`, `polyhedron_construction` | the same from faces, from points, all constructors |
//! | `triangle_mesh`, `triangle`, `point_cloud` | triangles and points |
//! | `sphere`, `half_space`, `capsule`, `cylinder`, `cone`, `torus` | the shape of that name |
//! | `circle`, [`round`], `support`, `extent` | circles, shapes made of them, support points, extents of shapes |
//! | `lists` | lists of unequal length in one array |
//! | `needle` | normals of very narrow faces |
//! | `nearer_point` | which of two points is nearer, also when the distances are equal to rounding |
//! | [`mirror`] | whether a shape is its own mirror image |
//! | `mirrored` | the mirror image of a shape |
//! | [`prism`] | whether a shape is the same in all planes across an axis |
//! | [`mod@approximate_decomposition`] | approximate convex parts of a solid |
//! | `error` | why a shape cannot be made |

pub mod approximate_decomposition;
mod capsule;
pub(crate) mod circle;
mod compound;
mod cone;
mod construction;
mod cylinder;
mod error;
pub(crate) mod extent;
mod half_space;
pub(crate) mod hull;
mod kinds;
pub(crate) mod lists;
pub mod mirror;
mod mirrored;
pub(crate) mod nearer_point;
mod needle;
mod point_cloud;
pub mod polyhedron;
mod polyhedron_construction;
pub mod prism;
pub mod round;
mod solid;
mod sphere;
pub(crate) mod support;
pub(crate) mod topology;
mod torus;
pub(crate) mod triangle;
pub(crate) mod triangle_mesh;

pub use capsule::Capsule;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use error::{LARGEST_LENGTH, SMALLEST_LENGTH, ShapeError};
pub use half_space::HalfSpace;
pub use kinds::{Compound, Shape};
pub use point_cloud::PointCloud;
pub use sphere::Sphere;
pub use torus::Torus;
pub use triangle_mesh::TriangleMesh;

pub(crate) use kinds::FirstElements;
