//! The entry points of the narrow phase, which choose by the kinds of the shapes.

pub(crate) mod coherence;
pub mod manifold;
pub mod persistent;
pub mod separation;
