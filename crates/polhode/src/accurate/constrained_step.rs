//! A step of an island with a fixed active set, as it has been integrated (`constrained_stepping.rs`), and where such a
//! step ends at the latest.

use super::pace::is_instant;
use super::system::received;
use crate::accounting::books::Received;
use crate::collision::active_contacts::ActiveContacts;
use crate::identity::contact_id::ContactId;
use crate::model::{Model, prescribed};
use crate::tier::core::Core;
use polhode_dynamics::state::WIDTH;
use polhode_dynamics::{BodyState, DenseStep, Flight, IntegratedMotion};

/// A step of an island.
#[derive(Debug)]
pub(super) struct ConstrainedStep {
    /// Movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// Contacts that are active over the step.
    pub(super) active: ActiveContacts,
    pub(super) t: f64,
    /// End of the step, s: `t + h`, or exactly the horizon.
    pub(super) end: f64,
    /// Its length, s.
    pub(super) h: f64,
    pub(super) dense: DenseStep,
    pub(super) end_state: Vec<f64>,
    /// Motion of each body, for the search of impacts.
    pub(super) motions: Vec<Option<IntegratedMotion>>,
    /// Free rotations of those bodies on which no moment acts.
    pub(super) spins: Vec<Option<Flight>>,
}

impl ConstrainedStep {
    /// The pairs whose contacts may close within the step: those with held contacts, and those with stops, ascending.
    pub(super) fn watched_pairs(&self, model: &Model) -> Vec<(usize, usize)> {
        let mut pairs: Vec<_> = self.active.held().iter().map(|id| (id.a, id.b)).collect();
        if model.joints.has_joint_contacts() {
            pairs.extend(model.joints.joint_contact_pairs_among(&self.bodies));
            pairs.sort_unstable();
        }
        pairs.dedup();
        pairs
    }

    /// States of the island's bodies and of kinematic bodies at a time within the step, written over `states` (of all
    /// bodies).
    pub(super) fn states_at(&self, model: &Model, t: f64, states: &mut [BodyState]) {
        prescribed::prescribe(model, t, states);
        let mut flat = vec![0.0; self.end_state.len()];
        self.dense.evaluate(t, &mut flat);
        for (index, &body) in self.bodies.iter().enumerate() {
            if let Some(state) = self.state(&flat, index, t) {
                states[body] = state;
            }
        }
    }

    /// State of a body of the island at a time within the step.
    pub(super) fn state_at(&self, body: usize, t: f64) -> Option<BodyState> {
        let mut flat = vec![0.0; self.end_state.len()];
        self.dense.evaluate(t, &mut flat);
        self.state(&flat, self.bodies.binary_search(&body).ok()?, t)
    }

    /// Momentum and energy from external agents from the start of the step to `t`.
    pub(super) fn received_until(&self, t: f64) -> Received {
        let mut flat = vec![0.0; self.end_state.len()];
        self.dense.evaluate(t, &mut flat);
        received(&flat, self.bodies.len())
    }

    /// State of the body of this index, from the island's flat state at `t`.
    fn state(&self, flat: &[f64], index: usize, t: f64) -> Option<BodyState> {
        let mut state = BodyState::from_array(flat.as_chunks::<WIDTH>().0.get(index)?);
        if let Some(Some(spin)) = self.spins.get(index) {
            state.pose.rotation = polhode_spatial::Motion::pose(spin, t).rotation;
            state.angular_momentum = spin.start().angular_momentum;
        }
        Some(state)
    }

    /// Motion of a body over the step.
    pub(super) fn motion(&self, body: usize) -> Option<&IntegratedMotion> {
        self.motions.get(self.bodies.binary_search(&body).ok()?)?.as_ref()
    }

    /// The island at a time within its step, as interpolated.
    pub(super) fn at(&self, t: f64) -> StepEndStates {
        let mut flat = vec![0.0; self.end_state.len()];
        self.dense.evaluate(t, &mut flat);
        self.at_end(&flat, t)
    }

    /// The island at the end of its step, from its flat state there.
    pub(super) fn at_end(&self, flat: &[f64], t: f64) -> StepEndStates {
        let states = (0..self.bodies.len()).filter_map(|index| self.state(flat, index, t)).collect();
        StepEndStates { states, received: received(flat, self.bodies.len()) }
    }
}

/// Body states of a flat state, quaternions normalised.
pub(super) fn unpack(flat: &[f64]) -> impl Iterator<Item = BodyState> + '_ {
    flat.as_chunks::<WIDTH>().0.iter().map(BodyState::from_array)
}

/// An island at the end of its step.
pub(super) struct StepEndStates {
    /// States of its bodies.
    pub(super) states: Vec<BodyState>,
    /// Momentum and energy that external agents gave to it over the step.
    pub(super) received: Received,
}

/// Where a step from `t` (s) of bodies that these contacts hold must end at the latest: at the horizon, or where the
/// motion of a kinematic body that they touch, or that joints hold to them, is not smooth.
fn horizon(core: &Core, (bodies, held): (&[usize], &[ContactId]), t: f64) -> f64 {
    let end = core.horizon(t);
    prescribed::prescribed_corner_between(&core.model, bodies, held, (t, end)).unwrap_or(end)
}

/// Longest step that may be tried from `t`, s.
pub(super) fn step_limit(core: &Core, of: (&[usize], &[ContactId]), t: f64) -> f64 {
    let remaining = horizon(core, of, t) - t;
    let longest = core.settings.step_s;
    // A sum of equal steps may leave a remainder too short for a step: it is added to the last step.
    if is_instant(remaining - longest, longest) { remaining } else { longest }
}

/// `t + h`, or exactly the horizon when the step reaches it: `t + (end - t)` may round to either side of the end.
pub(super) fn end_of(core: &Core, of: (&[usize], &[ContactId]), t: f64, h: f64) -> f64 {
    let end = horizon(core, of, t);
    if h >= end - t { end } else { t + h }
}
