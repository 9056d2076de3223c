//! What is shown against what was simulated.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod chunks;
mod page;
mod tessellation;
