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
    // A contradiction ends where a joint breaks.
    let may_be_apart = are_driven_apart && !model.joints.may_break_among(bodies);
    let has_ties = model.joints.ties_among(bodies).next().is_some();
    let ask = match (has_ties, may_be_apart) {
        (true, _) => Ask::HoldAll,
        (false, true) => Ask::Hold,
        (false, false) => return Ok(()),
    };
    let refused = |source| SimulationError::of_response(t, source).among(model, bodies);
    match contradicted(model, t, (states, bodies), ask).map_err(refused)? {
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
        ConstraintId::Pivot { .. } => ("the pivot".to_owned(), None),
        ConstraintId::Contact(_) => ("the contact".to_owned(), None),
    };
    let mut bodies: Vec<usize> = [a, b].into_iter().chain(driver).collect();
    bodies.dedup();
    let bodies = bodies.into_iter().map(|body| model.bodies[body].name.clone()).collect();
    SimulationError::JointsContradict { t_s, what, bodies }
}

/// What has the row that is kept worst, where some are not kept; a tie before joints.
fn contradicted(
    model: &Model,
    t: f64,
    (states, bodies): (&[BodyState], &[usize]),
    ask: Ask<'_>,
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
    let left = match assembly.answer(known, ask, &mut Memory::default()) {
        // Nobody can tell of so many rows.
        Err(ResponseError::TooManyRows { .. }) => return Ok(None),
        answer => answer?.velocities,
    };
    let is_broken = |left: f64| left.is_nan() || left.abs() > CONTRADICTION * largest;
    let broken = left.iter().enumerate().filter(|(_, left)| is_broken(**left));
    let mut by_size: Vec<(f64, ConstraintId)> =
        broken.filter_map(|(row, left)| Some((left.abs(), assembly.constraint(row)?))).collect();
    by_size.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let tie = by_size.iter().find(|(_, id)| matches!(id, ConstraintId::Tie { .. }));
    Ok(tie.or(by_size.first()).map(|(_, id)| *id))
}
