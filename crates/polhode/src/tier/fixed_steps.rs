//! What tiers share that advance all bodies together by steps of one length: their states, the integrator between
//! collisions, the contacts within reach, samples within a step, and the queries that follow from these.
//!
//! Such a tier books every step when it makes it, and whose states are all those of the present between two steps.

use crate::collision::boxes::Boxes;
use crate::collision::contact_set;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::model::{ModelBody, prescribed, reported, tolerances, work};
use crate::report::acceleration::Acceleration;
use crate::report::frame::{IslandView, MotionKind};
use crate::rows::assembly::free_acceleration;
use crate::snapshot::SnapshotError;
use crate::snapshot::numbers::{State, read_states, write_states};
use crate::tier::core::Core;
use polhode_dynamics::integrator::Integrator;
use polhode_dynamics::{BodyState, FreeMotion};
use polhode_spatial::{DVec3, Still};
use std::sync::Arc;

/// The bodies of a run by fixed steps.
#[derive(Debug)]
pub(crate) struct SteppedBodies {
    /// States of all bodies at the present.
    pub(crate) states: Vec<BodyState>,
    pub(crate) integrator: Box<dyn Integrator>,
    pub(crate) boxes: Boxes,
    /// Number of pairs that touched at the last detection.
    pub(crate) touching_pairs: usize,
    /// Which bodies forces move.
    moves: Vec<bool>,
}

/// Whether an integrator may go on from its own variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Continues {
    /// Where only it has changed the states since its last step.
    Untouched,
    /// Never: the forces are others.
    Anew,
}

impl SteppedBodies {
    /// Bodies in these states.
    pub(crate) fn new(core: &Core, states: Vec<BodyState>) -> Self {
        Self {
            integrator: core.settings.build_integrator(),
            boxes: Boxes::new(core.settings.broad_phase, states.len()),
            touching_pairs: 0,
            moves: core.model.bodies.iter().map(ModelBody::moves).collect(),
            states,
        }
    }

    /// Those of a snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene.
    pub(crate) fn restored(core: &Core, states: &[State], integrator: &[f64]) -> Result<Self, SnapshotError> {
        let mut bodies = Self::new(core, read_states(states, core.model.bodies.len())?);
        let restored = bodies.integrator.restore(&core.model.free_motion(), integrator);
        restored.map_err(|_| SnapshotError::Invalid("the variables of the integrator do not fit its bodies"))?;
        Ok(bodies)
    }

    /// States of all bodies at `t` (s), given those of the movable ones.
    pub(crate) fn all_states(&self, core: &Core, movable: &[BodyState], t: f64) -> Vec<BodyState> {
        let mut states = self.states.clone();
        prescribed::prescribe(&core.model, t, &mut states);
        for (&body, state) in core.model.movable.iter().zip(movable) {
            states[body] = *state;
        }
        states
    }

    /// Integrates the bodies over a step of length `h` (s). Their new states are the integrator's.
    ///
    /// # Errors
    /// When the integrator cannot make the step.
    pub(crate) fn integrate(
        &mut self,
        core: &Core,
        motion: &FreeMotion<'_>,
        (h, continues): (f64, Continues),
    ) -> Result<(), SimulationError> {
        let states = core.model.movable_states(&self.states);
        core.model.work.add(states.len() * work::OF_BODY);
        if continues == Continues::Anew || self.integrator.states() != states {
            self.integrator.start(motion, core.t, &states);
        }
        self.integrator.step(motion, h).map_err(|source| SimulationError::Integration { t_s: core.t, source })
    }

    /// States of all bodies at `t` (s) within the step that has just been integrated, computed by a shorter step.
    ///
    /// # Errors
    /// When the integrator cannot make it.
    pub(crate) fn states_within(
        &mut self,
        core: &Core,
        motion: &FreeMotion<'_>,
        t: f64,
    ) -> Result<Option<Arc<Vec<BodyState>>>, SimulationError> {
        let mut movable = core.model.movable_states(&self.states);
        let within = t.min(self.integrator.time());
        let found = self.integrator.states_within(motion, within, &mut movable);
        found.map_err(|source| SimulationError::Integration { t_s: core.t, source })?;
        Ok(Some(Arc::new(self.all_states(core, &movable, t))))
    }

    /// Contacts of pairs that are apart by at most `reach` (m), or overlap; counts the pairs.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(crate) fn detect(&mut self, core: &Core, reach: f64) -> Result<Vec<Touch>, SimulationError> {
        let touches = contacts_within(core, &self.states, &mut self.boxes, reach)?;
        self.touching_pairs = touches.chunk_by(|x, y| (x.id.a, x.id.b) == (y.id.a, y.id.b)).count();
        Ok(touches)
    }

    /// How each body moves.
    pub(crate) fn motions(&self) -> Vec<MotionKind> {
        self.moves.iter().map(|&moves| if moves { MotionKind::Integrated } else { MotionKind::Given }).collect()
    }

    /// All bodies step together: one island of those that move.
    pub(crate) fn islands(&self) -> Vec<IslandView> {
        let moving = self.moves.iter().enumerate().filter(|&(_, &moves)| moves);
        let bodies: Vec<BodyId> = moving.map(|(body, _)| BodyId::new(body)).collect();
        if bodies.is_empty() { Vec::new() } else { vec![IslandView { bodies }] }
    }

    /// Takes up a body that has been added to the world.
    pub(crate) fn add_body(&mut self, core: &Core, state: BodyState) {
        self.moves.push(core.model.bodies[self.states.len()].moves());
        self.states.push(state);
        self.boxes.make_room();
    }

    /// Drops a body.
    pub(crate) fn remove_body(&mut self, body: usize) {
        self.boxes.put(body, None);
        self.moves[body] = false;
    }

    /// The states for a snapshot.
    pub(crate) fn save_states(&self) -> Vec<State> {
        write_states(&self.states)
    }
}

/// End of the next step of the scene's length (s), or the limit.
pub(crate) fn next_step_end(core: &Core, limit_s: f64) -> f64 {
    let h = core.settings.step_s;
    if h >= limit_s - core.t { limit_s } else { core.t + h }
}

/// Every contact point of every pair that is apart by at most `reach` (m), or overlaps.
///
/// # Errors
/// When there are more bodies than the broad phase can number.
pub(crate) fn contacts_within(
    core: &Core,
    states: &[BodyState],
    boxes: &mut Boxes,
    reach: f64,
) -> Result<Vec<Touch>, SimulationError> {
    for (body, state) in states.iter().enumerate() {
        boxes.set(&core.model, body, &Still(state.pose), (core.t, core.t), reach);
    }
    let mut touches = Vec::new();
    boxes.all_pairs(&core.model, |a, b| {
        let reach = reach.max(tolerances::rounding(&core.model, states, a, b));
        touches.extend(contact_set::contacts_of_pair(&core.model, states, a, b, reach).into_iter().map(Touch::from));
    })?;
    Ok(touches)
}

/// Accelerations of all bodies at the present in these states, as they are reported: those of prescribed motions, and
/// of the movable bodies under gravity, fields and what `load_of` says: force (N) and torque (N m) about the origin of
/// the body with this place among the movable ones; none where nothing else acts.
pub(crate) fn accelerations_under(
    core: &Core,
    states: &[BodyState],
    load_of: impl Fn(usize) -> Option<(DVec3, DVec3)>,
) -> Vec<Acceleration> {
    let model = &core.model;
    let fields = model.loads(core.t, states);
    let mut out = vec![Acceleration { linear: DVec3::ZERO, angular: DVec3::ZERO }; model.bodies.len()];
    for &body in &model.prescribed {
        let (linear, angular) = prescribed::prescribed_acceleration(model, body, core.t);
        out[body] = Acceleration { linear, angular };
    }
    for (place, (&body, rigid)) in model.movable.iter().zip(model.free_motion().bodies()).enumerate() {
        let state = &states[body];
        let (mut linear, mut angular) = free_acceleration(model, states, &fields, body);
        if let Some((force, torque)) = load_of(place) {
            linear += force * rigid.inverse_mass();
            angular += rigid.inverse_inertia_world(state.pose.rotation) * torque;
        }
        out[body] = reported::reported_acceleration(model, body, state, linear, angular);
    }
    out
}
