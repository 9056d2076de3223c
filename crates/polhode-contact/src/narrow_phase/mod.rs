//! Narrow phase: whether, where and how two shapes touch.
//!
//! The folders are layers: each uses those below it in this table and none above.
//!
//! | folder | holds |
//! |---|---|
//! | `dispatch` | the entry points: the algorithm by the kinds of the shapes, and what is kept from step to step |
//! | `parts` | compounds and triangle meshes: the results of pairs of their parts, combined |
//! | `pair` | two shapes without parts: their separation and their contacts |
//! | `region` | where two bodies touch: two faces on each other, or the neighbourhood of a common normal |
//! | `axis` | the axis of largest separation of two bodies |
//! | `terms` | one contact of named features: its geometry and the time derivatives of its separation |
//! | `common_normal` | the pairs of points of two elements whose connecting line is normal to both |
//! | `feature` | features of shapes: elements, borders, numbers of parts, the one nearest to a point |

pub(crate) mod axis;
pub(crate) mod common_normal;
pub(crate) mod dispatch;
pub(crate) mod feature;
pub(crate) mod pair;
pub(crate) mod parts;
pub(crate) mod region;
pub(crate) mod terms;

pub use dispatch::{convex_method, manifold, pair_memory, passing, separation, workspace};
pub use feature::counterpart;
pub use pair::clipped_boxes;
pub use terms::{evaluate, open_face, tangential};
