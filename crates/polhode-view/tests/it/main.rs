//! What is shown against what was simulated.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod animations;
mod chunks;
mod models;
mod page;
mod plots;
mod stills;
mod tessellation;
