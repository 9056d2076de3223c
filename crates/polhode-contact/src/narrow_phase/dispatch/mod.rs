//! The entry points of the narrow phase.
//!
//! | module | holds |
//! |---|---|
//! | [`workspace`] | buffers, kept from call to call |
//! | [`separation`] | the separation of two shapes |
//! | [`manifold`] | all contacts of two shapes |
//! | [`convex_method`] | the separation of two convex shapes by a chosen method |
//! | `coherence` | which axes need not be searched at a nearby pose |
//! | [`passing`] | the contacts of two bodies that pass each other along a face |
//! | [`pair_memory`] | the contacts of a pair, found faster with the memory of the last query |

pub(crate) mod coherence;
pub mod convex_method;
pub mod manifold;
pub mod pair_memory;
pub mod passing;
pub mod separation;
pub mod workspace;
