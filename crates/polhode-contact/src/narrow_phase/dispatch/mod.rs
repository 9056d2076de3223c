//! The entry points of the narrow phase.
//!
//! | module | holds |
//! |---|---|
//! | [`workspace`] | what is kept from call to call |
//! | [`separation`] | the separation of two shapes |
//! | [`manifold`] | all contacts of two shapes |
//! | [`convex_method`] | the separation of two convex shapes by a chosen method |
//! | `coherence` | what a search leaves for the next one |
//! | [`persistent`] | the contacts of many bodies from step to step |

pub(crate) mod coherence;
pub mod convex_method;
pub mod manifold;
pub mod persistent;
pub mod separation;
pub mod workspace;
