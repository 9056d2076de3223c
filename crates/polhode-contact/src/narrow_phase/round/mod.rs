//! Capsules, cylinders, cones and tori against everything: gaps and contacts element by element.
//!
//! | module | holds |
//! |---|---|
//! | `element` | the parts of surfaces that touch |
//! | `pairs` | places where two elements stand over each other: closed forms, a circle and a cone |
//! | `curves` | the same for a circle and a line, and for two circles |
//! | `minima` | the angles once around a circle or cone at which a height is least |
//! | `branch` | which of two places of a circle is meant |
//! | `stationary` | separation and its time derivatives at such a place |
//! | `gap` | the separating axis of two convex bodies |
//! | `sieve` | which elements of a polyhedron can decide |
//! | `region` | all contacts of the region in which they touch |
//! | `ring` | tori |
//! | `ring_samples` | where a circle is sampled to tell its minima apart |

mod branch;
pub(crate) mod curves;
pub(crate) mod element;
pub(crate) mod gap;
mod minima;
pub(crate) mod pairs;
pub(crate) mod region;
pub(crate) mod ring;
mod ring_samples;
pub(crate) mod sieve;
pub(crate) mod stationary;
