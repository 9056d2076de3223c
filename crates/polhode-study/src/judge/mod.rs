//! A trajectory of any engine, judged by the laws of a scene.
//!
//! | law | is broken when |
//! |---|---|
//! | energy | it changes by more than contacts, joints and fields of the scene can take or give |
//! | momentum | a body changes its motion by an impulse that nothing in the scene gives |
//! | penetration | bodies overlap |
//! | floating | a body stays above another one, and nothing holds it there |
//! | friction | a force outside the cone is needed, or a contact slides though friction would hold it (Coulomb) |
//! | contact | a contact pulls, or pushes while the bodies are apart (Signorini) |
//! | joints | bodies leave what joints and pivots keep |
//! | motion | a body that the scene moves is elsewhere |
//! | velocities | velocities are not the rates of the poses |
//! | truth | bodies are farther from a run of tier `accurate` than that is known |
//!
//! Nothing is integrated but the run that distances are measured from. Between two samples the impulse that each body
//! needs is the change of its momentum without that of gravity and fields. It must lie in the cone of what contacts and
//! joints at both samples give (`reactions`). All limits are the tolerance, relative to sizes, energies and speeds, and
//! what sampling and rounding hide (`interval`).
//!
//! | module | holds |
//! |---|---|
//! | `given` | [`Given`]: the trajectory, and velocities where it has none |
//! | `start` | units and orders of quaternions that are not those of the scene |
//! | `observed` | what the scene says of each sample |
//! | `interval` | what must have acted between two samples |
//! | `reactions` | impulses of contacts and joints, by their laws |
//! | `law` | [`Law`], [`Finding`] |
//! | `truth` | how far bodies are from a run of the scene |
//! | `judgement` | [`Judgement`]: all of it |
//! | `json` | the same as one object |
//! | `error` | [`JudgeError`] |

mod error;
mod given;
mod interval;
mod json;
mod judgement;
mod law;
mod observed;
mod reactions;
mod start;
mod truth;

/// What counts as nothing unless it is asked otherwise, of sizes, speeds and energies (no unit, 1e-15 to 1e-2).
pub const TOLERANCE: f64 = 1e-9;

pub use error::JudgeError;
pub use given::{Given, VelocitySource};
pub use judgement::{Judgement, Question, judge};
pub use law::{Finding, Law};
pub use truth::{Truth, TruthAt, truth_of};
