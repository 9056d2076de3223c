//! Bodies at rest with many contacts: forces that hold all of them, found without a matrix of their rows.
//!
//! Coulomb's law of many contacts is solved in the accelerations of bodies ([`sparse`](crate::sparse)). Where nothing
//! slides in that answer, or where the law has an answer in which something does but forces within the cones balance
//! all the same ([`Structure`]: those of the greatest reserve of friction), these are made to balance to rounding and
//! are the certificate of rest: they lie in the cones of static friction, and what they leave on each body is rounding
//! of the forces on that body.
//!
//! Memory and time grow with contacts and bodies. Failure: none where no forces were found; the methods for few
//! contacts are asked then.

use super::contacts::Contacts;
use super::sticking::{HoldingForces, MOST_FRICTION_NEEDED};
use super::terms::Terms;
use crate::error::ResponseError;
use crate::friction::{BlocksSolution, ContactStatus, Structure};
use crate::report::{Method, SolverStatus};
use crate::solve::way;

/// What the forces may leave on a body, relative to the sum of the magnitudes of the forces on it (no unit, 1e-14 to
/// 1e-12): rounding of a few hundred terms.
const BALANCED_RELATIVE: f64 = 1e-13;

/// Forces with which none of the bodies moves, as a solution; none where there are none, or a joint has friction.
/// `free` are the accelerations of the bodies without contact forces.
///
/// # Errors
/// When a number is not finite.
pub(super) fn standing(terms: Terms<'_>, free: &[f64]) -> Result<Option<BlocksSolution>, ResponseError> {
    let Terms { rows, blocks, .. } = terms;
    // What presses joints with friction is given: the velocities of bodies know nothing of it.
    if !way::is_plain(rows) {
        return Ok(None);
    }
    let contacts = Contacts::of(rows, blocks);
    let solved = terms.in_bodies()?;
    if solved.report.status == SolverStatus::Solved && !solved.statuses.contains(&ContactStatus::Slide) {
        let held = balanced(terms, &contacts, free, (&solved.reactions, Method::ActiveSet))?;
        if held.is_some() {
            return Ok(held);
        }
    }
    let mut near = solved.reactions;
    near.resize(rows.len(), 0.0);
    let limit = Structure::new(rows, blocks, free, &near)?.friction_limit()?;
    match limit.filter(|limit| limit.factor <= MOST_FRICTION_NEEDED) {
        Some(limit) => balanced(terms, &contacts, free, (&limit.forces, Method::InteriorPoint)),
        None => Ok(None),
    }
}

/// Forces near these that balance to rounding, as a solution, if they lie in the cones.
fn balanced(
    terms: Terms<'_>,
    contacts: &Contacts,
    free: &[f64],
    (forces, method): (&[f64], Method),
) -> Result<Option<BlocksSolution>, ResponseError> {
    let mut near = forces.to_vec();
    near.resize(terms.rows.len(), 0.0);
    let balanced = terms.blocks.balance_in_bodies(terms.rows, free, &near)?;
    let is_balanced = balanced.left <= BALANCED_RELATIVE;
    let held = HoldingForces { forces: balanced.forces, residual: balanced.left, is_balanced };
    Ok(held.solution(contacts, method))
}
