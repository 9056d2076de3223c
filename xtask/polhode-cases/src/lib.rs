//! Validation cases, and the rows that they give.
//!
//! | module | holds |
//! |---|---|
//! | [`atlas`] | published results beside what the engine gives |
//! | [`cases`] | the cases, one file per group |
//! | [`calibration`] | errors that runs tell beside their true errors |
//! | [`row`] | one result |
//! | [`mod@reference`] | the values that cases are compared with |
//! | [`mod@cargo`] | programs that a case builds and runs |
//! | [`snapshot_environment`] | what insta is told by its environment |
//! | [`elastic_table`] | the command: impacts of elastic rectangles, and to how many digits |
//! | [`rigid_ipc`] | the command: scenes of the Rigid IPC suite in our format |
//! | [`scene_units`] | a scene file in other units |

pub mod atlas;
pub mod calibration;
pub mod cargo;
pub mod cases;
pub mod elastic_table;
pub mod reference;
pub mod rigid_ipc;
pub mod row;
pub mod scene_units;
pub mod snapshot_environment;

pub use cases::{ALL, Amount, CaseResult, Company, Context, QUICK, Run, company, guarded, random_scenes, tiers_agree};
