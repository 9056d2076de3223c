//! The axis of largest separation of two bodies.
//!
//! | module | holds |
//! |---|---|
//! | `axes` | the result of a search over the axes of two polyhedra |
//! | `axis_search` | two polyhedra in the frame of the search |
//! | `edge_axes` | the pair of edges that separates best |
//! | `separating_axis` | the search over all faces and edges |
//! | `drift` | bounds of the change of separations along face normals between two poses |
//! | `half_space` | the height above a half-space |
//! | `body` | a convex body, for pairs of which at least one is round |
//! | `sieve` | exclusion of elements that cannot have the best axis |
//! | `gap` | the axis of two convex bodies, at least one of them round |
//! | `ring_samples` | samples of a circle that isolate its local minima |
//! | `ring` | tori |

pub(crate) mod axes;
pub(crate) mod axis_search;
pub(crate) mod body;
pub(crate) mod drift;
pub(crate) mod edge_axes;
pub(crate) mod gap;
pub(crate) mod half_space;
pub(crate) mod ring;
pub(crate) mod ring_samples;
pub(crate) mod separating_axis;
pub(crate) mod sieve;
