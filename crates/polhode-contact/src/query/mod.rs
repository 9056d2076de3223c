//! Queries on shapes at poses: distance, ray casts, overlap, containment, and the same for many bodies.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@distance`] | [`distance()`]: Euclidean distance, closest points, depth of penetration |
//! | [`mod@closest_point`] | [`closest_point()`], [`contains()`]: one point against a shape |
//! | [`mod@ray_cast`] | [`Ray`], [`ray_cast()`]: the first point at which a ray hits a shape |
//! | [`mod@overlap`] | [`overlap()`]: whether two shapes share a point |
//! | [`scene`] | [`QueryScene`]: queries against many bodies, with a tree |
//! | `piece`, `pieces` | the cores with a radius that a shape consists of, and the search over them |
//! | `found`, `roots` | the result for two cores; bisection |
//! | `signed_distance`, `sweep`, `lines` | distances of a core from a point, segment or circle, and of two segments |
//! | `gjk`, `simplex`, `polytopes`, `nearest_pair`, `curved` | the distance of two cores that are apart |
//! | `penetration`, `spanned_feature` | the depth of two cores that overlap, along the axes of the narrow phase |
//! | `error` | why a query has no result |
//! | `feature` | the feature of a body that a query found |
//!
//! All lengths are in metres, poses and results in the world. Distances are Euclidean.
//! [`separation`](crate::separation()) differs: it is the largest separation over the candidate axes, a lower bound of
//! the distance where an edge or a vertex is nearest.

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
