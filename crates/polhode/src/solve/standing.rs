//! Bodies at rest with many contacts: forces that hold all of them, found without a matrix of their rows.
//!
//! Coulomb's law of many contacts is solved in the accelerations of bodies (`polhode_response::sparse`). Where nothing
//! slides in that answer, or where the law has an answer in which something does but forces within the cones balance
//! all the same (`polhode_response::friction::Structure`: those of the greatest reserve of friction), these are made to
//! balance to rounding and are the certificate of rest: they lie in the cones of static friction, and what they leave
//! on each body is rounding of the forces on that body.
//!
//! Memory and time grow with contacts and bodies. Failure: none where no forces were found; the caller then asks the
//! methods for few contacts.

use super::sticking_forces::{HoldingForces, MOST_FRICTION_NEEDED};
use crate::collision::touch::Touch;
use crate::model::Model;
use crate::rows::assembly::Assembly;
use crate::rows::frictional_contact::Frictional;
use polhode_dynamics::BodyState;
use polhode_response::friction::{ContactStatus, Structure};
use polhode_response::solve::many::solve_many;
use polhode_response::solve::way;
use polhode_response::{Blocks, BlocksSolution, Method, ResponseError, SolverStatus};
use polhode_spatial::DVec3;

/// What the forces may leave on a body, relative to the sum of the magnitudes of the forces on it (no unit, 1e-14 to
/// 1e-12): rounding of a few hundred terms.
const BALANCED_RELATIVE: f64 = 1e-13;

/// Whether bodies are held by the forces found here: none of them moves, and contacts are many; in planar motion each
/// counts as two, as it does in space.
pub(super) fn is_for_many(model: &Model, states: &[BodyState], assembly: &Assembly, contacts: &[Touch]) -> bool {
    let is_still = |body: &BodyState| body.linear_velocity == DVec3::ZERO && body.angular_momentum == DVec3::ZERO;
    let each_for = if model.plane.is_some() { 2 } else { 1 };
    let are_many = way::are_many_at_rest(each_for * contacts.len());
    are_many && assembly.bodies().iter().all(|&body| is_still(&states[body]))
}

/// Forces with which none of the bodies moves, as a solution; none where there are none, or a joint has friction.
/// `free` are the accelerations of the bodies without contact forces, `constants` those of the rows.
///
/// # Errors
/// When a number is not finite.
pub(super) fn standing(
    assembly: &Assembly,
    blocks: &Blocks,
    (free, constants): (&[f64], &[f64]),
    frictional: &[Option<Frictional>],
) -> Result<Option<BlocksSolution>, ResponseError> {
    // What presses joints with friction is given: the velocities of bodies know nothing of it.
    if !way::is_plain(&assembly.problem) {
        return Ok(None);
    }
    let solved = solve_many(&assembly.problem, blocks, constants)?;
    if solved.report.status == SolverStatus::Solved && !solved.statuses.contains(&ContactStatus::Slide) {
        let held = balanced(assembly, blocks, free, frictional, (&solved.reactions, Method::ActiveSet))?;
        if held.is_some() {
            return Ok(held);
        }
    }
    let mut near = solved.reactions;
    near.resize(assembly.problem.len(), 0.0);
    let limit = Structure::new(&assembly.problem, blocks, free, &near)?.friction_limit()?;
    match limit.filter(|limit| limit.factor <= MOST_FRICTION_NEEDED) {
        Some(limit) => balanced(assembly, blocks, free, frictional, (&limit.forces, Method::InteriorPoint)),
        None => Ok(None),
    }
}

/// Forces near these that balance to rounding, as a solution, if they lie in the cones.
fn balanced(
    assembly: &Assembly,
    blocks: &Blocks,
    free: &[f64],
    frictional: &[Option<Frictional>],
    (forces, method): (&[f64], Method),
) -> Result<Option<BlocksSolution>, ResponseError> {
    let mut near = forces.to_vec();
    near.resize(assembly.problem.len(), 0.0);
    let balanced = blocks.balance_in_bodies(&assembly.problem, free, &near)?;
    let is_balanced = balanced.left <= BALANCED_RELATIVE;
    let held = HoldingForces { forces: balanced.forces, residual: balanced.left, is_balanced };
    Ok(held.solution(assembly, frictional, method))
}
