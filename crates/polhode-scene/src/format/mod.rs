//! The scene format, version 1, as it is written in a file.
//!
//! Plain data with the keys, and nothing but the keys, of docs/scene-format.md: what is not a member here is refused
//! by name. The engine's own types are in [`polhode`] and are not the file format; [`crate::load()`] goes from one to
//! the other. SI units throughout; quaternions are `[w, x, y, z]`.
//!
//! | module | holds |
//! |---|---|
//! | `scene` | the document: [`SceneFile`], [`OutputEntry`], [`MaterialEntry`], [`PairEntry`], [`NoContactEntry`] |
//! | `method` | [`MethodEntry`] and the members of each knob |
//! | `body` | [`BodyEntry`], [`ShapeEntry`], [`InertiaEntry`] |
//! | `exactly` | [`Exactly`]: arrays of an exact length |
//! | `planned` | members that are designed but not built, refused as `not yet available` |

mod body;
mod exactly;
mod method;
pub(crate) mod planned;
mod scene;

pub use body::{BodyEntry, BoxEntry, FileEntry, HalfSpaceEntry, InertiaEntry, PointsEntry, ShapeEntry, SphereEntry};
pub use exactly::{Exactly, Vector};
pub use method::{ContactName, ImpactName, IntegratorName, MethodEntry, OrientationName, ResponseName, TierName};
pub use scene::{MaterialEntry, NoContactEntry, OutputEntry, PairEntry, SceneFile};

/// Version of the format that this crate reads.
pub const VERSION: u32 = 1;

/// Kinds of shape, for messages.
pub(crate) const SHAPES: &str = "box, sphere, half_space, points, convex or mesh";
