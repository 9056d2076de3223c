//! The tier `thesis`: section 3.5 to the letter, with what it does to a stack.
//!
//! Fixed steps. Each: detect penetrations; apply impulses by propagation until nothing approaches; take contacts that
//! part slowly as resting; find their forces by the linear programme of least total force with the guesses of
//! vanishing contacts; integrate one step by RK4 with these forces. Nothing is located and nothing is projected, so
//! bodies sink and vibrate by what they move in a step, and the certificate says by how much the forces are wrong.

mod engine;
mod system;

pub(crate) use engine::ThesisEngine;
