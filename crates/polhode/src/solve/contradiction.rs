//! Whether gears and prescribed motions of joints contradict each other, or the joints; and whether joints with several
//! kinematic bodies do.
//!
//! The rows `J a + b = 0` of joints and ties, with `b` their terms of velocities and of prescribed accelerations
//! (m/s^2), have a solution if `b` is in the range of `J`, which is that of `G = J M^-1 J^T`. The forces `f` of least
//! norm that come nearest to `G f = -b` leave a residual where it is not. Free accelerations do not matter: `J a` is in
//! that range.
//!
//! Limit: where a mechanism passes a singular position the rank is that of rounding, and a motion that is driven
//! through it may be told to contradict itself there, as it does.

use crate::constraint::ConstraintId;
use crate::constraint::joint::ModelJoint;
use crate::error::SimulationError;
use crate::model::Model;
use crate::rows::assembly::Assembly;
use polhode_dynamics::BodyState;
use polhode_response::{Ask, Memory, Question, ResponseError};

/// A residual of accelerations beyond this fraction of the largest term is a contradiction (no unit, 1e-9 to 1e-4): far
/// above rounding, and far below what two different motions ask for.
const CONTRADICTION: f64 = 1e-6;

/// Refuses bodies at `t` (s) whose gears and prescribed motions, or whose joints with several kinematic bodies,
/// contradict each other or their joints.
///
/// # Errors
/// [`SimulationError::JointsContradict`]; when a number is not finite.
pub(crate) fn refuse_contradictions(
    model: &Model,
    t: f64,
    states: &[BodyState],
    bodies: &[usize],
) -> Result<(), SimulationError> {
    let mut drivers = model.joints.drivers_of(bodies);
    let first = drivers.next();
    let are_driven_apart = first.is_some() && drivers.any(|other| Some(other) != first);
    if !are_driven_apart && model.joints.ties_among(bodies).next().is_none() {
        return Ok(());
    }
    let refused = |source| SimulationError::of_response(t, source).among(model, bodies);
    match contradicted(model, t, states, bodies).map_err(refused)? {
        None => Ok(()),
        Some(id) => Err(told(model, t, id)),
    }
}

/// The contradiction in words: what cannot be kept, and whom it holds.
fn told(model: &Model, t_s: f64, id: ConstraintId) -> SimulationError {
    let (a, b) = id.bodies();
    let (what, driver) = match id {
        ConstraintId::Tie { tie, .. } => (model.joints.name_of_tie(tie), None),
        ConstraintId::Joint { joint, .. } => {
            let of = model.joints.joint_numbered(joint);
            (format!("joint {joint}"), of.and_then(ModelJoint::driver))
        }
        ConstraintId::Pivot { .. } | ConstraintId::Contact(_) => ("the pivot".to_owned(), None),
    };
    let mut bodies: Vec<usize> = [a, b].into_iter().chain(driver).collect();
    bodies.dedup();
    let bodies = bodies.into_iter().map(|body| model.bodies[body].name.clone()).collect();
    SimulationError::JointsContradict { t_s, what, bodies }
}

/// The first tie where rows cannot be kept; without a tie, what has the row that is kept worst.
fn contradicted(
    model: &Model,
    t: f64,
    states: &[BodyState],
    bodies: &[usize],
) -> Result<Option<ConstraintId>, ResponseError> {
    let assembly = Assembly::new(model, states, bodies, std::iter::empty())?;
    let still = assembly.uniform_accelerations(polhode_spatial::DVec3::ZERO);
    let constants = assembly.acceleration_constants(model, t, states, &still, std::iter::empty())?;
    let largest = constants.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    // Terms of motions that cancel leave the rounding of their parts.
    let parts = bodies.iter().chain(&model.prescribed).map(|&body| {
        let velocity = model.velocity(body, &states[body]);
        let turning = velocity.angular.length();
        turning * (turning * model.bodies[body].size + velocity.linear.length())
    });
    let largest = largest.max(parts.fold(0.0, f64::max));
    if largest == 0.0 {
        return Ok(None);
    }
    let known = Question { constants: &constants, ..Question::default() };
    let left = assembly.answer(known, Ask::HoldAll, &mut Memory::default())?.velocities;
    let worst = left.iter().fold(0.0_f64, |most, left| most.max(left.abs()));
    if worst <= CONTRADICTION * largest {
        return Ok(None);
    }
    let mut ids = assembly.bilaterals().iter().map(|own| own.id);
    let tie = ids.find(|id| matches!(id, ConstraintId::Tie { .. }));
    let kept_worst = || left.iter().position(|left| left.abs() == worst).and_then(|row| assembly.constraint(row));
    Ok(tie.or_else(kept_worst))
}
