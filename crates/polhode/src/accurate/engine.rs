//! The state of a run: its bodies, the mode of each until its next event, and the order of events.

use super::agenda::{Agenda, Due};
use super::contacts::Contacts;
use super::instant::Instant;
use super::island::Island;
use super::motions::{Mode, Motions};
use super::near_pairs::NearPairs;
use super::schedule::Schedule;
use crate::error::SimulationError;
use crate::model::prescribed;
use crate::report::observer::Observer;
use crate::tier::Reached;
use crate::tier::core::Core;
use crate::tier::sampling::emit_samples_before;
use polhode_dynamics::BodyState;

/// If no body is integrated and no observer needs samples, energies and finiteness of states are checked once in so
/// many output samples.
const UNOBSERVED_SAMPLES: u64 = 256;

/// A run in progress.
#[derive(Debug)]
pub(crate) struct Engine {
    pub(super) motions: Motions,
    pub(super) schedule: Schedule,
    /// Whether the first instant has been resolved.
    pub(super) begun: bool,
    /// The instant that a program is about to change.
    pub(super) interrupted: Option<Instant>,
    /// Whether a program continues the simulation after the end of the run.
    pub(super) goes_on: bool,
}

impl Engine {
    /// Prepares a run: finds the touching contacts, removes overlaps within the touch distance, and makes a first guess
    /// of the active set.
    ///
    /// # Errors
    /// When bodies overlap at the start.
    pub(crate) fn new(core: &mut Core, states: Vec<BodyState>) -> Result<Self, SimulationError> {
        let count = core.model.bodies.len();
        let mut engine = Self {
            motions: Motions::new(core, states),
            schedule: Schedule {
                contacts: Contacts::new(count),
                near: NearPairs::new(core, count),
                agenda: Agenda::default(),
            },
            begun: false,
            interrupted: None,
            goes_on: false,
        };
        engine.find_initial_contacts(core)?;
        engine.motions.scratch.clone_from(&engine.motions.states);
        Ok(engine)
    }

    /// Resolves the first instant.
    pub(super) fn begin(&mut self, core: &mut Core) -> Result<(), SimulationError> {
        self.begun = true;
        self.resolve_start(core)
    }

    /// Processes what is due at `t`.
    pub(super) fn process(&mut self, core: &mut Core, t: f64, due: Due) -> Result<Reached, SimulationError> {
        core.model.work.check(t)?;
        if due != Due::FlightBoxes {
            self.motions.state_cache.invalidate();
        }
        match due {
            Due::FlightBoxes => self.schedule.renew_flight_boxes(core, &self.motions, t).map(|()| Reached::Limit),
            Due::Corner(body) => self.pass_corner(core, body, t),
            Due::Impact(a, b) => self.resolve_event(core, t, &[a, b]).map(|()| Reached::Event),
            Due::Island(first)
                if self
                    .motions
                    .islands
                    .get(&first)
                    .is_some_and(|island| island.changes || kinematic_member_stops(core, island, t)) =>
            {
                self.resolve_event(core, t, &[first]).map(|()| Reached::Event)
            }
            Due::Island(first) if self.motions.islands.get(&first).is_some_and(|island| island.is_unsolved) => {
                self.begin_stretch_of_island(core, first, t).map(|()| Reached::Event)
            }
            Due::Island(first) if self.motions.islands.get(&first).is_some_and(Island::is_crowd) => {
                core.accounts.count_step();
                self.next_crowd_step(core, first, t).map(|()| Reached::StepEnd)
            }
            Due::Island(first) => {
                core.accounts.count_step();
                self.next_step(core, first, t).map(|()| Reached::StepEnd)
            }
        }
    }

    /// Sends the observer the samples before `until` (s).
    pub(super) fn emit_samples(
        &mut self,
        core: &mut Core,
        until: f64,
        observer: &mut dyn Observer,
    ) -> Result<(), SimulationError> {
        let is_watched = observer.wants_samples() || observer.wants_frames();
        emit_samples_before(until, self, core, observer, |engine, core, t| {
            // Free flight in closed form has no error between two checks, and no observer needs the sample.
            if !is_watched && engine.motions.islands.is_empty() && core.accounts.skips_sample(UNOBSERVED_SAMPLES) {
                return Ok(None);
            }
            let states = engine.motions.observe_at(core, t)?;
            Ok(Some(if is_watched { engine.motions.kept_apart(core, t, states)? } else { states }))
        })
    }

    /// The motion of a kinematic body passes a corner (a time at which it is not smooth). Bodies resting on it wake if
    /// it begins to move.
    fn pass_corner(&mut self, core: &mut Core, body: usize, t: f64) -> Result<Reached, SimulationError> {
        self.schedule.expect_corner(core, body, t);
        let rests = |body: &usize| matches!(self.motions.tracks[*body].mode, Mode::Rest);
        let resting: Vec<usize> = self.schedule.contacts.partners(body).filter(rests).collect();
        if resting.is_empty() || prescribed::allows_rest(&core.model, body, t) {
            return Ok(Reached::Limit);
        }
        self.resolve_event(core, t, &resting).map(|()| Reached::Event)
    }

    /// Removes an island and its agenda entry.
    pub(super) fn remove_island(&mut self, first: usize) -> Option<Island> {
        let island = self.motions.islands.remove(&first)?;
        self.schedule.agenda.remove(island.due, Due::Island(first));
        Some(island)
    }
}

/// Whether a kinematic body that an island touches, or that a joint holds to it, stops at `t`, the end of the island's
/// step: then the island may come to rest.
pub(super) fn kinematic_member_stops(core: &Core, island: &Island, t: f64) -> bool {
    let drivers = core.model.joints.drivers_of(&island.bodies);
    island.active.held().iter().flat_map(|id| [id.a, id.b]).chain(drivers).any(|body| {
        !prescribed::stands_still(&core.model, body, island.t, t) && prescribed::allows_rest(&core.model, body, t)
    })
}
