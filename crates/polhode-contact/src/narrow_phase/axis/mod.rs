//! The axis along which two bodies separate best.
//!
//! | module | holds |
//! |---|---|
//! | `axes` | what a search over the axes of two polyhedra found |
//! | `axis_search` | two polyhedra as the search looks at them |
//! | `edge_axes` | the pair of edges that separates best |
//! | `separating_axis` | the search over all faces and edges |
//! | `drift` | how far heights above faces may have changed between two poses |
//! | `half_space` | the height above a half-space |
//! | `body` | a convex body of which at least one of a pair is round |
//! | `sieve` | which elements of a polyhedron can decide |
//! | `gap` | the axis of two convex bodies, at least one of them round |
//! | `ring_samples` | where a circle is sampled to tell its minima apart |
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
