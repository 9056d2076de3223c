//! The native part of the Python package `polhode`: Python asks, the library answers.
//!
//! | module | holds |
//! |---|---|
//! | `loaded` | a scene that has been read |
//! | `recorder` | the observer that keeps what a run tells, in columns |
//! | `recording` | the columns as arrays of numpy, without a copy |
//! | `job` | work in a thread of its own, which Ctrl-C ends |
//! | `run` | a run from its start to its end |
//! | `judge` | trajectories judged by a scene, and compared |
//! | `study` | which method reaches an accuracy, and what accuracy costs |
//! | `drop` | on which faces a body comes to rest |
//! | `show` | a run as a page, pictures and plots |
//! | `telling` | what pages and plots tell of a run, kept while it goes on |
//! | `drawn` | all plots of a run |
//! | `simulation` | a simulation in the hand |
//! | `actions` | what a program does to its bodies and joints |
//! | `views` | what a simulation tells of the present |
//! | `arguments` | what Python gives, checked |
//! | `contacts` | forces of friction and impacts, as functions of arrays |
//! | `files` | meshes and robots from their files |
//! | `stands` | whether a scene stands, up to which value, and tables of boxes as scenes |
//! | `functions` | parts of the library as functions of arrays |
//! | `errors` | errors of the library as Python's exceptions |
//!
//! No code here is unsafe: a column is a vector that is moved into an array of numpy, which then owns it.

mod actions;
mod arguments;
mod contacts;
mod drawn;
mod drop;
mod errors;
mod files;
mod functions;
mod job;
mod judge;
mod loaded;
mod recorder;
mod recording;
mod run;
mod show;
mod simulation;
mod stands;
mod study;
mod telling;
mod views;

// It has no code: what this crate shares with the tests is compiled once for both.
use one_build as _;

/// What the package is made from; its public part is `polhode`.
#[pyo3::pymodule(gil_used = false)]
mod _polhode {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::contacts::{friction, impact_with_friction, impact_without_friction};
    #[pymodule_export]
    use super::drop::rest_poses;
    #[pymodule_export]
    use super::files::{doctor, material_keys, mesh_of_file, robot_of_file};
    #[pymodule_export]
    use super::functions::{mesh_report, rotate_free};
    #[pymodule_export]
    use super::judge::{compare, judge};
    #[pymodule_export]
    use super::loaded::Loaded;
    #[pymodule_export]
    use super::recording::Recording;
    #[pymodule_export]
    use super::run::run;
    #[pymodule_export]
    use super::show::{gif, page, plot, still};
    #[pymodule_export]
    use super::simulation::{Simulation, Snapshot};
    #[pymodule_export]
    use super::stands::{boxes, standing_limit, stands};
    #[pymodule_export]
    use super::study::study;
    #[pymodule_export]
    use super::views::{BodyState, Contact, Coordinate, Energy, Finding, JointLoad, Momentum, StepOutcome};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
