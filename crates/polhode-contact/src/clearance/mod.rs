//! The tolerances of a pair, each relative to its size.
//!
//! Two lengths decide: the *joint size*, the smaller of the two sizes, which says how finely features must be told
//! apart, and the *scale*, the largest length that enters the arithmetic, which says how finely they can be.
//! Of a compound the size of its smallest part counts for places (`compound_pair.rs`).

mod pair_tolerance;
mod place_tolerance;

pub use pair_tolerance::{joint_size, resolution, scale, touch_tolerance};
pub use place_tolerance::{COINCIDENCE, PARALLEL_SINE, RESOLUTION_ULPS};

pub(crate) use place_tolerance::place_tolerance;
