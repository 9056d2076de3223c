//! The entry points of the narrow phase.
//!
//! | module | holds |
//! |---|---|
//! | [`workspace`] | what is kept from call to call |
//! | [`separation`] | the separation of two shapes |
//! | [`manifold`] | all contacts of two shapes |
//! | [`convex_method`] | the separation of two convex shapes by a chosen method |
//! | `coherence` | what a search leaves for the next one |
//! | [`pair_memory`] | the contacts of a pair, with what is remembered of it |

pub(crate) mod coherence;
pub mod convex_method;
pub mod manifold;
pub mod pair_memory;
pub mod separation;
pub mod workspace;
