//! Studies of a scene: the same motion by many methods and steps, each with its error and its cost.
//!
//! A scene is run by many candidates, each a change of its settings. The error of a candidate is its distance from the
//! exact solution, or from the finest one where there is none; its cost is time as a ratio, measured in interleaved
//! rounds, or instructions. Both are told with what is known about them: no error below that of the reference itself
//! is claimed, and a candidate that is refused or fails is listed with its reason.
//!
//! Time is a cost, so that this crate reads a clock, which the crates of the simulation do not.
//!
//! | module | holds |
//! |---|---|
//! | [`candidate`] | a candidate; combinations of what is varied |
//! | [`ladder`] | the candidates when none are asked for |
//! | [`options`] | what is asked of a study |
//! | [`host`] | what the program that asks does for a study |
//! | [`source`] | the scene, loaded with changes and run |
//! | [`mod@reference`] | the exact or the finest solution, and how well it is known |
//! | [`difference`] | how far a run is from the reference |
//! | [`law`] | the law of contact of a method, which is no part of its error |
//! | [`timing`] | what a run costs |
//! | [`threads`] | threads for what a simulation computes side by side |
//! | `front` | the Pareto front, and the cheapest that reaches a target |
//! | `runs` | all runs of a study |
//! | [`study`] | all of it together |
//! | [`json`] | the same as one JSON object |
//! | [`stands`] | whether bodies stand, how firmly, and what moves first |
//! | [`sweep`] | many runs with other values, and what is measured of each |
//! | [`mod@drop`] | on which faces a body comes to rest, how often, and how hard it is struck |
//! | [`mod@judge`] | a trajectory of any engine, judged by the laws of a scene |
//! | [`play`] | a scene that runs while somebody pulls at its bodies, and goes back to any time |
//! | [`error`] | [`StudyError`] |

pub mod candidate;
pub mod difference;
pub mod drop;
pub mod error;
pub mod host;
pub mod json;
pub mod judge;
pub mod ladder;
pub mod law;
pub mod options;
pub mod play;
pub mod reference;
pub mod source;
pub mod stands;
pub mod study;
pub mod sweep;
pub mod threads;
pub mod timing;

mod front;
mod runs;

pub use candidate::{Axis, Candidate};
pub use error::StudyError;
pub use host::{Alone, Host};
pub use options::{Counting, Options};
pub use runs::Solver;
pub use source::Source;
pub use study::Study;
pub use threads::Threads;

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
