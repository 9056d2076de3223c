//! What polhode-spatial promises: the laws of rotations, poses and inertia, on named cases and on random input.

#![allow(
    clippy::unwrap_used,
    clippy::unreadable_literal,
    reason = "a test that cannot go on fails; reference values are copied digit by digit"
)]

mod compensated_sum;
mod curves;
mod inertia;
mod mass_properties;
mod motions;
mod pose;
mod principal_axes;
mod random;
mod rotation;
mod unit_vector;
mod velocity_and_motion;
