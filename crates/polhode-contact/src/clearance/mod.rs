//! The tolerances of a pair, each relative to its size.
//!
//! They are made of two lengths. The *joint size* is the smaller of the two sizes: features that differ by a small part
//! of it must be distinguished. The *scale* is the sum of the lengths in the arithmetic: lengths below its rounding
//! cannot be distinguished. The coincidence of features of a compound is decided with the size of its smallest part
//! (`compound_pair.rs`).
//!
//! | module | holds |
//! |---|---|
//! | `pair_tolerance` | the tolerances of a pair of shapes |
//! | `place_tolerance` | tolerances of coincident features, parallel directions and equal separations |

mod pair_tolerance;
mod place_tolerance;

pub use pair_tolerance::{joint_size, resolution, scale, touch_tolerance};
pub use place_tolerance::{COINCIDENCE, PARALLEL_SINE, RESOLUTION_ULPS};
pub(crate) use place_tolerance::{FLUSH_COSINE, ONE_PLACE, SIEVE_SLACK};

pub(crate) use place_tolerance::{place_tolerance, place_tolerance_of_sizes};
