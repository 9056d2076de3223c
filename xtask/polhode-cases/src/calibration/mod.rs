//! Errors that runs tell beside their true errors, over scenes whose motion is known.
//!
//! A scene is run by every tier that takes it. The true error of a run is the largest distance of any point of a body
//! from where it belongs, of the size of the body, over all samples for which the truth is known and before the horizon
//! that the run tells. The told error is what the report says.
//!
//! | module | holds |
//! |---|---|
//! | `known` | a scene whose motion is known |
//! | `sources` | all such scenes |
//! | `closed` | scenes of contact and friction in closed form |
//! | `published` | scenes of the validation cases in closed form, and those in which nothing moves |
//! | `mechanisms` | pendulums, chains, loops and tops whose motion is known |
//! | `oracles` | motions of pendulums and chains from their own equations |
//! | `by_runs` | scenes known from the tier `accurate` at its tightest |
//! | `answers` | closed forms of scenes that were reported as wrong |
//! | `chaotic` | twenty scenes whose motion is chaotic |
//! | `horizons` | when a difference of rounding has grown to a hundredth of a body |
//! | `setting` | a scene in a tier, and at the tightest |
//! | `trial` | one run |
//! | `told` | what a run tells of its error |
//! | `truth` | the true motion at samples, and how well it is known |
//! | `distance` | how far bodies are from their places |
//! | `judged` | what came of a scene in its tiers |
//! | `all_cores` | all scenes, on all processors |
//! | `summary` | shares that are told too low or too high |
//! | `table` | what is printed |

mod all_cores;
mod answers;
mod by_runs;
mod chaotic;
pub(crate) mod closed;
mod distance;
mod horizons;
mod judged;
mod known;
mod mechanisms;
mod oracles;
mod published;
mod setting;
mod sources;
mod summary;
mod table;
mod told;
mod trial;
mod truth;

pub use all_cores::judge_all;
pub use horizons::{Horizon, WITHIN, horizons};
pub use judged::{Compared, Finding, Judged, ROUNDING};
pub use known::Known;
pub use sources::all;
pub use summary::{FAR_TOO_LOW, GOALS, Shares, TOO_HIGH, TOO_LOW, tiers, worst};
pub use table::{SHARE_COLUMNS, json, share_rows, summary};
