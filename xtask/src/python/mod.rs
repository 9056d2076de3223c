//! The Python package, as its users have it: built, installed and tested in an environment of its own.
//!
//! | module | holds |
//! |---|---|
//! | `environment` | the virtual environment below `target` |
//! | `licences` | the licence texts of what a wheel contains |
//! | `step` | the step of a verification |

mod environment;
mod licences;
mod step;

pub(crate) use licences::run as write_licences;
pub(crate) use step::{NAME, check};
