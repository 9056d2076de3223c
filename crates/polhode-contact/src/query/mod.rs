//! Questions about shapes in their places: how far apart, what a ray meets, what overlaps what, and the same for many.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@distance`] | [`distance()`]: Euclidean distance, closest points, depth of penetration |
//! | [`mod@closest_point`] | [`closest_point()`], [`contains()`]: one point against a shape |
//! | [`mod@ray_cast`] | [`Ray`], [`ray_cast()`]: where a ray meets a shape |
//! | [`mod@overlap`] | [`overlap()`]: whether two shapes share a point |
//! | [`scene`] | [`QueryScene`]: the same questions to many bodies, by a tree |
//! | `piece`, `pieces` | the convex cores with a radius that a shape consists of, and those that may answer |
//! | `signed_distance`, `sweep`, `lines` | a core from a point, from a segment or a circle, and two segments |
//! | `gjk`, `simplex`, `polytopes`, `nearest_pair`, `curved` | two cores that are apart |
//! | `penetration`, `spanned_feature` | two cores that overlap, along the axes of the narrow phase |
//!
//! All lengths are in metres, poses and results in the world. Distances are Euclidean: unlike
//! [`separation`](crate::separation()), which looks along axes that may separate and is a lower bound where an edge or a
//! vertex is nearest.

pub mod closest_point;
mod curved;
pub mod distance;
mod error;
mod feature;
mod found;
mod gjk;
mod lines;
mod nearest_pair;
pub mod overlap;
mod penetration;
mod piece;
mod pieces;
mod polytopes;
pub mod ray_cast;
mod roots;
pub mod scene;
mod signed_distance;
pub(crate) mod simplex;
mod spanned_feature;
mod sweep;

pub use closest_point::{SurfacePoint, closest_point, contains};
pub use distance::{ClosestPoints, distance};
pub use error::QueryError;
pub use feature::QueryFeature;
pub use overlap::overlap;
pub use ray_cast::{Ray, RayHit, ray_cast};
pub use scene::QueryScene;
