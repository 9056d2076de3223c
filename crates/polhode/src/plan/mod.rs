//! The plan of a run: which effects are simulated, by which methods, and the measured facts that decide.
//!
//! | module | holds |
//! |---|---|
//! | [`decisions`] | [`Plan`](crate::Plan): the decision about each [`Effect`](crate::Effect), with its reason |
//! | `free_method` | the integrator of bodies without active contacts |
//! | `planar` | the bodies whose motion stays in a plane |
//! | `mirror_image` | how far a body is from being its own mirror image in a plane |
//! | `pivots` | how bodies are held at a point: rows, or a reduction to rotation |

pub mod decisions;
pub(crate) mod free_method;
mod mirror_image;
pub(crate) mod pivots;
pub(crate) mod planar;
