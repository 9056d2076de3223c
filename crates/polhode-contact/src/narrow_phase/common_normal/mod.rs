//! Common normals: lines that are normal to two elements. In this folder a place is such a line with its point on each.
//!
//! | module | holds |
//! |---|---|
//! | `place` | a common normal |
//! | `minima` | all local minima of a height function over the angle about an axis |
//! | `curves` | the common normals of a circle and a line, and of two circles |
//! | `places` | the common normals of all pairs of elements |
//! | `branch_offset` | which of two places of a circle a contact names |
//! | `chosen_place` | the common normal that a contact names |

pub(crate) mod branch_offset;
pub(crate) mod chosen_place;
pub(crate) mod curves;
pub(crate) mod minima;
pub(crate) mod place;
pub(crate) mod places;
