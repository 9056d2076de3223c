//! The native part of the Python package `polhode`: Python asks, the library answers.
//!
//! | module | holds |
//! |---|---|
//! | `loaded` | a scene that has been read |
//! | `recorder` | the observer that keeps what a run tells, in columns |
//! | `recording` | the columns as arrays of numpy, without a copy |
//! | `job` | work in a thread of its own, which Ctrl-C ends |
//! | `run` | a run |
//! | `show` | a run as a page, pictures and plots |
//! | `telling` | what pages and plots tell of a run, kept while it goes on |
//! | `drawn` | all plots of a run |
//! | `simulation` | a simulation in the hand |
//! | `actions` | what a program does to its bodies and joints |
//! | `views` | what a simulation tells of the present |
//! | `arguments` | what Python gives, checked |
//! | `functions` | parts of the library as functions of arrays |
//! | `errors` | errors of the library as Python's exceptions |
//!
//! No code here is unsafe: a column is a vector that is moved into an array of numpy, which then owns it.

mod actions;
mod arguments;
mod drawn;
mod errors;
mod functions;
mod job;
mod loaded;
mod recorder;
mod recording;
mod run;
mod show;
mod simulation;
mod telling;
mod views;

/// What the package is made from; its public part is `polhode`.
#[pyo3::pymodule(gil_used = false)]
mod _polhode {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::functions::{doctor, mesh_report, rotate_free};
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
    use super::views::{BodyState, Contact, Coordinate, Energy, Finding, JointLoad, StepOutcome};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
