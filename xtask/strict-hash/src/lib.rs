//! The strict hash of a run, and the program that prints it for scene files.
//!
//! A strict hash is taken over all bits of all samples and events of a run, so that a change of a single bit shows. The
//! golden trajectories in `fixtures/golden` hold one each. The program
//!
//! ```text
//! strict-hash [--repeat-steps] SCENE.toml...
//! ```
//!
//! runs scene files and prints a line for each. It needs the library crates and the standard library alone, and no
//! threads, processes, clock or temporary files, so that it can be built for, and run on, every platform that these
//! support; `cargo xtask cross` does so and compares its hashes with the golden ones.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@hash`] | the hash |
//! | [`run`] | the run of a scene file: each step once, or twice from its snapshot |
//! | [`line`](mod@line) | what the program prints, and reads back |

pub mod hash;
pub mod line;
pub mod run;

pub use hash::{hash_words, strict_hash};
pub use line::Line;
pub use run::{Failure, Repeat, record_of};
