//! Cache of the states of all bodies at the time of the last observation of energies and momenta.
//!
//! The states at one time are needed several times: by the ledgers, by a sample, by a program that reads the bodies.
//! While every body is in free flight or at rest they remain valid until the next event. The cache is not part of the
//! simulation state.

use polhode_dynamics::BodyState;
use std::sync::Arc;

/// States of all bodies at one time.
#[derive(Debug, Default)]
pub(super) struct StateCache {
    /// Time of the states, s; none when the cache is invalid.
    pub(super) t: Option<f64>,
    pub(super) states: Arc<Vec<BodyState>>,
}

impl StateCache {
    /// The states at `t` (s), if they are in the cache.
    pub(super) fn at(&self, t: f64) -> Option<&Arc<Vec<BodyState>>> {
        (self.t == Some(t)).then_some(&self.states)
    }

    /// Marks the cache as invalid.
    pub(super) fn invalidate(&mut self) {
        self.t = None;
    }
}
