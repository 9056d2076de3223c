//! The tier `accurate`.
//!
//! Bodies in flight follow their flight records in closed form. Bodies with held contacts are integrated by DOP853
//! with the contact forces solved for at every stage, under error control. Time advances from event to event: an
//! impact (a pair closes), or a change of contacts (a force reaches zero, a corner passes an edge). Each is located,
//! and everything that happens at that instant is resolved before time goes on.

mod engine;
mod hold;
mod impact_search;
mod locate;
mod progress;
mod projection;
mod resolve;
mod sinking;
mod start;
pub(crate) mod stepped;
mod system;
mod trial;

pub(crate) use engine::Engine;
