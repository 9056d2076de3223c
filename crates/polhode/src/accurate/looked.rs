//! The states of all bodies when energies and momenta were last taken note of.
//!
//! At one time they are asked for more than once: by the ledgers at the end of a stretch of flights, by a sample, by a program
//! that reads the bodies. Where every body flies or stands they are kept until the next event: nothing else changes what they
//! are at that time. A cache and no part of the state.

use super::engine::Engine;
use crate::SimulationError;
use crate::core::Core;
use polhode_dynamics::BodyState;
use std::sync::Arc;

/// States of all bodies at one time.
#[derive(Debug, Default)]
pub(super) struct Looked {
    /// When they are the states, s; nothing when they are out of date.
    t: Option<f64>,
    states: Arc<Vec<BodyState>>,
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

impl Engine {
    /// Takes note of energies and momenta at `t` (s), a time within all present steps; the states of all bodies there.
    ///
    /// # Errors
    /// When a state cannot be evaluated or is not finite.
    pub(super) fn look(&mut self, core: &mut Core, t: f64) -> Result<Arc<Vec<BodyState>>, SimulationError> {
        if let Some(states) = self.looked.at(t) {
            return Ok(Arc::clone(states));
        }
        let mut looked = std::mem::take(&mut self.looked);
        // The room of the last ones serves again, unless somebody holds them.
        let states = Arc::make_mut(&mut looked.states);
        self.write_states_at(core, t, states)?;
        core.accounts.observe(&core.world, states, t)?;
        self.observed_s = t;
        looked.t = self.islands.is_empty().then_some(t);
        self.looked = looked;
        Ok(Arc::clone(&self.looked.states))
    }
}
