//! The states of all bodies when energies and momenta were last taken note of.
//!
//! At one time they are asked for more than once: by the ledgers at the end of a stretch of flights, by a sample, by a program
//! that reads the bodies. Where every body flies or stands they are kept until the next event: nothing else changes what they
//! are at that time. A cache and no part of the state.

use polhode_dynamics::BodyState;
use std::sync::Arc;

/// States of all bodies at one time.
#[derive(Debug, Default)]
pub(super) struct Looked {
    /// When they are the states, s; nothing when they are out of date.
    pub(super) t: Option<f64>,
    pub(super) states: Arc<Vec<BodyState>>,
}

impl Looked {
    /// The states at `t` (s), if they are kept.
    pub(super) fn at(&self, t: f64) -> Option<&Arc<Vec<BodyState>>> {
        (self.t == Some(t)).then_some(&self.states)
    }

    /// Something changes: they are out of date.
    pub(super) fn forget(&mut self) {
        self.t = None;
    }
}
