//! Tests of polhode-dynamics: closed forms, conservation, orders of convergence, equivalence of methods, invariance.
#![allow(clippy::unwrap_used, reason = "a test that cannot set itself up fails")]
#![allow(
    clippy::excessive_precision,
    clippy::unreadable_literal,
    reason = "reference values with the digits of their source"
)]

mod elliptic_against_taylor;
mod energy_and_momentum;
mod flight;
mod free_rotation;
mod integrated_motion;
mod invariance;
mod oracle;
mod rigid_body;
mod runge_kutta;
mod special_functions;
mod support;
