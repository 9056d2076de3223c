//! Tests of polhode-dynamics: closed forms, conservation, orders of convergence, equivalence of methods, invariance.
#![allow(clippy::unwrap_used, reason = "a test that cannot set itself up fails")]
#![allow(
    clippy::excessive_precision,
    clippy::unreadable_literal,
    reason = "reference values with the digits of their source"
)]

mod adaptive_exact;
mod conservation;
mod elliptic_against_taylor;
mod energy_and_momentum;
mod events;
mod exact_and_dop853;
mod exact_flow;
mod fields;
mod fixed_point;
mod flight;
mod forced_motion;
mod free_rotation;
mod hard_rotations;
mod heavy_top;
mod integrated_motion;
mod integrator_orders;
mod invariance;
mod lagrange_top;
mod methods;
mod oracle;
mod orientation;
mod pivoted;
mod random_bodies;
mod random_rotations;
mod rigid_body;
mod runge_kutta;
mod saved_variables;
mod special_functions;
mod stepping;
mod support;
mod work_precision;
