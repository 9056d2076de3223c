//! Finds the singular force that has made a run fail.
//!
//! A force field may be singular: a point attracts with mu/d^2, which is infinite at the point, and no motion can be
//! integrated through it. What fails first is then a step, a search or an energy, and its message does not name the
//! cause. The same holds of a force of a program that becomes NaN. This module evaluates the forces of the scene one by
//! one at the present states, then where these would be a step later if nothing acted, and names the one that is not
//! finite or far too strong for the step. A body whose state is lost stands where it began.

use crate::error::SimulationError;
use crate::model::Model;
use crate::scene::Force;
use crate::tier::core::Core;
use crate::time_stepping::drift;
use polhode_dynamics::field::Wrench;
use polhode_dynamics::integrator::IntegrationError;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::ResponseError;

/// A force counts as the cause when alone it would move the body, from rest, by more than this many times the size of
/// the body within the longest step (dimensionless, 1 to 1e6). A force that steps of that length resolve moves the body
/// by a fraction of its size.
const SIZES_PER_STEP: f64 = 1e3;

/// The first force of the scene that is not finite on a body in these states at `t` (s).
pub(crate) fn not_finite(model: &Model, t: f64, states: &[BodyState]) -> Option<SimulationError> {
    let mut found = None;
    for_each_wrench(model, t, states, |force, body, wrench| {
        if found.is_none() && !is_finite(wrench) {
            found = Some(SimulationError::ForceNotFinite {
                t_s: t,
                body: name(model, body),
                force: describe(model, force),
            });
        }
    });
    found
}

/// The error that names the force which has caused `error`, if a force has at these states; else `error` itself.
pub(crate) fn explained(error: SimulationError, core: &Core, states: &[BodyState]) -> SimulationError {
    if !may_be_caused_by_a_force(&error) || core.model.scene.forces().is_empty() {
        return error;
    }
    let (model, h) = (&core.model, core.settings.step_s);
    let present: Vec<BodyState> = states.iter().enumerate().map(|(body, state)| known(model, body, state)).collect();
    let later = present.iter().enumerate().map(|(body, state)| drift(model, body, state, h)).collect();
    let looks = [(core.t, present), (core.t + h, later)];
    let cause = looks.iter().find_map(|(t, states)| not_finite(model, *t, states));
    cause.or_else(|| looks.iter().find_map(|(t, states)| too_strong(core, *t, states))).unwrap_or(error)
}

/// The state of a body; at rest where it began, if the state is not finite any more.
fn known(model: &Model, body: usize, state: &BodyState) -> BodyState {
    let is_lost = !state.is_finite() && body < model.scene.bodies().len();
    if is_lost { BodyState::at_rest(model.scene.motion_at_start(body).0) } else { *state }
}

/// The strongest force at `t` (s) that is far too strong for the step.
fn too_strong(core: &Core, t: f64, states: &[BodyState]) -> Option<SimulationError> {
    let model = &core.model;
    let mut strongest: Option<(f64, usize, usize, Wrench)> = None;
    for_each_wrench(model, t, states, |force, body, wrench| {
        let inverse_mass = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::inverse_mass);
        let travel = wrench.force.length() * inverse_mass * core.settings.step_s * core.settings.step_s;
        let sizes = travel / model.bodies[body].size;
        if sizes > SIZES_PER_STEP && strongest.is_none_or(|(largest, ..)| sizes > largest) {
            strongest = Some((sizes, force, body, wrench));
        }
    });
    strongest.map(|(_, force, body, wrench)| SimulationError::SingularForce {
        t_s: t,
        body: name(model, body),
        force: describe(model, force),
        force_n: wrench.force.length(),
    })
}

/// Whether a force that is singular, or no number, may cause such an error.
fn may_be_caused_by_a_force(error: &SimulationError) -> bool {
    match error {
        SimulationError::StepTooSmall { .. }
        | SimulationError::EnergyOverflow { .. }
        | SimulationError::Diverged { .. }
        | SimulationError::ContactSolve { .. }
        | SimulationError::ContactProblem { source: ResponseError::NotFinite { .. }, .. }
        | SimulationError::ImpactSearch { .. } => true,
        SimulationError::Integration { source, .. } => {
            matches!(source, IntegrationError::StepTooSmall { .. } | IntegrationError::NotFinite { .. })
        }
        _ => false,
    }
}

/// Calls `visit` with the index of every force of the scene, the index of every movable body, and the wrench of that
/// force on that body.
fn for_each_wrench(model: &Model, t: f64, states: &[BodyState], mut visit: impl FnMut(usize, usize, Wrench)) {
    let own = model.movable_states(states);
    for (number, force) in model.scene.forces().iter().enumerate() {
        // A force whose fields cannot be made was refused when the scene was built.
        let Ok(fields) = force.fields(model) else { continue };
        let mut wrenches = vec![Wrench::default(); own.len()];
        for field in &fields {
            field.add_wrenches(t, model.free_motion().bodies(), &own, &mut wrenches);
        }
        for (&body, wrench) in model.movable.iter().zip(wrenches) {
            if model.bodies[body].moves() && states[body].is_finite() {
                visit(number, body, wrench);
            }
        }
    }
}

fn is_finite(wrench: Wrench) -> bool {
    wrench.force.is_finite() && wrench.torque.is_finite()
}

fn name(model: &Model, body: usize) -> String {
    model.bodies[body].name.clone()
}

/// A force as a message names it: its index in the scene, counted from 0, and its kind.
fn describe(model: &Model, number: usize) -> String {
    let kind = match model.scene.forces().get(number) {
        Some(Force::PointGravity { center, .. }) => format!("point gravity towards {center} m"),
        Some(Force::MutualGravity { .. }) => "mutual gravity".to_owned(),
        Some(Force::Applied { .. }) => "an applied force and torque".to_owned(),
        Some(Force::Drag { .. }) => "drag".to_owned(),
        Some(Force::Spring { .. }) => "a spring".to_owned(),
        Some(Force::Field(_)) | None => "a field that the program defines".to_owned(),
    };
    format!("force number {number} ({kind}; forces are counted from 0)")
}
