//! The Python package, as its users have it: built, installed and tested in an environment of its own.
//!
//! | module | holds |
//! |---|---|
//! | `environment` | the virtual environment below `target` |
//! | `step` | the step of a verification |

mod environment;
mod step;

pub(crate) use step::{NAME, check};
