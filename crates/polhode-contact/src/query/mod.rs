//! Questions about shapes in their places: how far apart, what a ray meets, what overlaps what, and the same for many.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@distance`] | [`distance()`]: Euclidean distance, closest points, depth of penetration |
//! | [`mod@closest_point`] | [`closest_point()`], [`contains()`]: one point against a shape |
//! | [`mod@ray_cast`] | [`Ray`], [`ray_cast()`]: where a ray meets a shape |
//! | [`mod@overlap`] | [`overlap()`]: whether two shapes share a point |
//! | [`scene`] | [`QueryScene`]: the same questions to many bodies, by a tree |
//!
//! All lengths are in metres, poses and results in the world. Distances are Euclidean: unlike
//! [`separation`](crate::separation()), which looks along axes that may separate and is a lower bound where an edge or a
//! vertex is nearest.

pub mod closest_point;
mod curved;
pub mod distance;
mod element;
mod epa;
mod gjk;
mod lines;
mod nearest_pair;
pub mod overlap;
mod penetration;
mod pieces;
mod polytopes;
mod quartic;
pub mod ray_cast;
pub mod scene;
mod signed_distance;
pub(crate) mod simplex;
mod sweep;

pub use closest_point::{SurfacePoint, closest_point, contains};
pub use distance::{ClosestPoints, distance};
pub use overlap::overlap;
pub use ray_cast::{Ray, RayHit, ray_cast};
pub use scene::QueryScene;

use thiserror::Error;

/// The part of a body that a query met. Vertices, edges and faces are numbered as in the shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QueryFeature {
    /// Part of a compound, triangle of a mesh, point of a cloud; 0 for other shapes.
    pub part: u32,
    /// What of that part.
    pub kind: FeatureKind,
}

/// A vertex, an edge, a face or a curved surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum FeatureKind {
    /// A face of a polyhedron; a half-space is face 0, a triangle too; the base of a cone is face 0, the caps of a
    /// cylinder 0 (against its axis) and 1.
    Face(u32),
    /// An edge of a polyhedron; edge `i` of a triangle runs from its corner `i` to the next; the rims of a cylinder are
    /// numbered as its caps, that of a cone is edge 0.
    Edge(u32),
    /// A vertex of a polyhedron, a corner of a triangle, the apex of a cone (vertex 0).
    Vertex(u32),
    /// A curved surface: of a sphere, capsule or torus, the side of a cylinder or cone.
    Surface,
}

/// Why a question has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum QueryError {
    /// A pose or a coordinate is NaN or infinite.
    #[error("{what} is not finite: give finite coordinates")]
    NotFinite {
        /// What it is.
        what: &'static str,
    },
    /// Two half-spaces, which overlap without bound unless they face each other exactly.
    #[error("two half-spaces have no distance: one of the two must be bounded")]
    Unbounded,
    /// A box without volume.
    #[error("the box is flat or unbounded: every side must have a length that a shape may have")]
    FlatBox,
    /// More bodies than indices.
    #[error("{count} bodies are given, at most {limit} are possible")]
    TooManyBodies {
        /// How many were given.
        count: usize,
        /// How many are possible.
        limit: usize,
    },
}
