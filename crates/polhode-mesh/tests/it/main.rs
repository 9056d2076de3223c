//! What polhode-mesh promises: exact mass properties, a diagnosis that is right, a reader that never fails silently.

#![allow(
    clippy::unwrap_used,
    clippy::unreadable_literal,
    reason = "a test that cannot go on fails; reference values are copied digit by digit"
)]

mod convexity;
mod diagnosis;
mod exact_values;
mod invariance;
mod obj;
mod obj_errors;
mod primitives;
mod real_meshes;
mod shapes;
