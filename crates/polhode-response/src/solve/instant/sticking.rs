//! Forces of contacts of which none slides yet.
//!
//! The least forces with which every contact holds and sticks are an answer if they lie in the cones of static
//! friction, exact to rounding at any ratio of masses. Where they do not, bodies at rest are asked for forces in the
//! cones that add up to the same on every body, those of the greatest reserve of friction
//! ([`Structure`](crate::friction::Structure)), and all others for those of Coulomb's law. What these methods leave is
//! taken out by the least change, with residuals of twice the working precision: large forces that cancel on a light
//! body then leave no more than its own weight is rounded by.

use super::contacts::{Contact, Contacts};
use super::terms::{At, SLIDING_ROUNDING, STICKING_ACCELERATION, Terms, rounding_of};
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::friction::{BlocksSolution, ContactStatus, FallbackPolicy, FrictionSettings, Structure};
use crate::least_norm_hold::{LeastNormForces, least_norm_forces};
use crate::problem::ContactProblem;
use crate::report::{Method, SolverReport, SolverStatus};
use crate::solve::matrix;

/// Convex programmes of the cone problem at an instant at which nothing slides yet (8 to 64): without its answer the
/// motion cannot begin.
const CORRECTIONS: u32 = 32;

/// The part of friction that bodies at rest may need (no unit): 1, and the accuracy of that part. Forces that leave the
/// cones of all of it are refused afterwards.
pub(super) const MOST_FRICTION_NEEDED: f64 = 1.0 + 1e-6;

/// Forces with which every contact holds and sticks, and what they leave.
#[derive(Debug)]
pub(super) struct HoldingForces {
    /// Of all rows, N.
    pub(super) forces: Vec<f64>,
    /// The largest acceleration of a row that they leave, relative to the largest without forces. At large ratios of
    /// masses that of forces of twice the working precision, of which these are the rounded ones.
    pub(super) residual: f64,
    /// Whether that is rounding.
    pub(super) is_balanced: bool,
}

impl HoldingForces {
    /// The least forces.
    fn least(terms: Terms<'_>, delassus: &Delassus) -> Result<Self, ResponseError> {
        let least = least_norm_forces(terms.rows, delassus, terms.constants)?;
        let left = left_by(terms.rows, terms.constants, &least)?;
        Ok(Self::new(terms, delassus, least.forces, &left))
    }

    /// Forces that nearly hold every contact, made exact with the least change of those that bear something.
    fn near(
        terms: Terms<'_>,
        (delassus, contacts): (&Delassus, &Contacts),
        mut forces: Vec<f64>,
    ) -> Result<Self, ResponseError> {
        let pressed: Vec<&Contact> = contacts.all.iter().filter(|contact| forces[contact.normal] > 0.0).collect();
        let left = terms.rows.accelerations(terms.constants, &forces)?;
        let change = least_change(terms.rows, contacts, &pressed, &left)?;
        let left = left_by(terms.rows, &left, &change)?;
        forces.iter_mut().zip(&change.forces).for_each(|(force, change)| *force += change);
        Ok(Self::new(terms, delassus, forces, &left))
    }

    fn new(terms: Terms<'_>, delassus: &Delassus, forces: Vec<f64>, left: &[f64]) -> Self {
        let left = left.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let scale = terms.scale();
        let is_balanced = left <= STICKING_ACCELERATION * scale + rounding_of(delassus, &forces);
        let residual = if scale > 0.0 { left / scale } else { 0.0 };
        Self { forces, residual, is_balanced }
    }

    /// These forces as a solution, if they lie in the cones of static friction and hold every contact to rounding.
    pub(super) fn solution(&self, contacts: &Contacts, method: Method) -> Option<BlocksSolution> {
        (contacts.obey(&self.forces) && self.is_balanced).then(|| BlocksSolution {
            velocities: vec![0.0; self.forces.len()],
            reactions: self.forces.clone(),
            parts: contacts.statuses_of_parts(),
            statuses: vec![ContactStatus::Stick; contacts.all.len()],
            report: SolverReport { method, residual: self.residual, ..SolverReport::default() },
        })
    }
}

/// What forces leave of accelerations of all rows, m/s^2.
fn left_by(rows: &ContactProblem, accelerations: &[f64], least: &LeastNormForces) -> Result<Vec<f64>, ResponseError> {
    match &least.loads {
        Some(loads) => rows.accelerations_under(accelerations, &least.forces, loads),
        None => rows.accelerations(accelerations, &least.forces),
    }
}

/// The solution where nothing slides yet. The least forces with which every contact holds and sticks are an answer if
/// they lie in the cones of static friction, exact to rounding at any ratio of masses. Bodies at rest stay at rest if
/// any forces can hold them: where friction jams them against each other Coulomb's law has answers that move them as
/// well. The slow methods of the cone problem are for what nothing holds.
///
/// # Errors
/// When a number is not finite.
pub(super) fn of_no_slip(terms: Terms<'_>, delassus: &Delassus, at: At) -> Result<BlocksSolution, ResponseError> {
    let Terms { rows, blocks, constants } = terms;
    let contacts = Contacts::of(rows, blocks);
    let least = HoldingForces::least(terms, delassus)?;
    if let Some(held) = least.solution(&contacts, Method::ActiveSet) {
        return Ok(held);
    }
    let patient = FrictionSettings { corrections: CORRECTIONS, ..FrictionSettings::default() };
    if !least.is_balanced || at != At::Rest {
        let solved = blocks.solve(delassus, constants, None, &patient)?;
        return refined(terms, (delassus, &contacts), solved);
    }
    let settings = FrictionSettings { fallback: FallbackPolicy::Refuse, ..FrictionSettings::default() };
    let solved = blocks.solve(delassus, constants, None, &settings)?;
    let is_solved = solved.report.status == SolverStatus::Solved;
    if is_solved && !solved.statuses.contains(&ContactStatus::Slide) {
        let near = HoldingForces::near(terms, (delassus, &contacts), solved.reactions.clone())?;
        if let Some(held) = near.solution(&contacts, solved.report.method) {
            return Ok(held);
        }
    }
    if let Some(held) = in_equilibrium(terms, (delassus, &contacts), &least)? {
        return Ok(held);
    }
    let solved = if is_solved { solved } else { blocks.solve(delassus, constants, None, &patient)? };
    refined(terms, (delassus, &contacts), solved)
}

/// Forces within the cones under which no contact moves, if there are any; `least` are forces that hold every contact,
/// within the cones or not.
fn in_equilibrium(
    terms: Terms<'_>,
    (delassus, contacts): (&Delassus, &Contacts),
    least: &HoldingForces,
) -> Result<Option<BlocksSolution>, ResponseError> {
    let Terms { rows, blocks, .. } = terms;
    // Limit analysis asks what bodies press on each other by; what presses a joint is given.
    if !rows.compliances().is_empty() {
        return Ok(None);
    }
    let free: Vec<f64> = rows.response(&least.forces)?.iter().map(|acceleration| -acceleration).collect();
    let limit = Structure::new(rows, blocks, &free, &least.forces)?.friction_limit()?;
    let Some(limit) = limit.filter(|limit| limit.factor <= MOST_FRICTION_NEEDED) else { return Ok(None) };
    let held = HoldingForces::near(terms, (delassus, contacts), limit.forces)?;
    Ok(held.solution(contacts, Method::InteriorPoint))
}

/// Changes the forces by as little as possible so that all contacts that hold and stick have no acceleration: at large
/// ratios of masses the residual of the solver, relative to the largest acceleration, would move heavy bodies. The
/// solution is returned as it is where a contact slides.
fn refined(
    terms: Terms<'_>,
    (delassus, contacts): (&Delassus, &Contacts),
    mut solved: BlocksSolution,
) -> Result<BlocksSolution, ResponseError> {
    let rounding = STICKING_ACCELERATION * terms.scale() + rounding_of(delassus, &solved.reactions);
    let limit = SLIDING_ROUNDING * rounding;
    let mut pressed = Vec::new();
    for (contact, status) in contacts.all.iter().zip(&solved.statuses) {
        let moves = contact.rows().any(|row| solved.velocities[row].abs() > limit);
        match status {
            ContactStatus::Open => continue,
            ContactStatus::Stick if !moves => {}
            ContactStatus::Stick | ContactStatus::Slide => return Ok(solved),
        }
        pressed.push(contact);
    }
    let left = terms.rows.accelerations(terms.constants, &solved.reactions)?;
    let change = least_change(terms.rows, contacts, &pressed, &left)?.forces;
    solved.reactions.iter_mut().zip(&change).for_each(|(reaction, change)| *reaction += change);
    let held = contacts.joints.iter().copied().chain(pressed.into_iter().flat_map(Contact::rows));
    held.for_each(|row| solved.velocities[row] = 0.0);
    Ok(solved)
}

/// The least changes of the forces of some contacts and of joints that cancel what is left in their rows. Other rows
/// have zero.
fn least_change(
    rows: &ContactProblem,
    contacts: &Contacts,
    pressed: &[&Contact],
    left: &[f64],
) -> Result<LeastNormForces, ResponseError> {
    let normals = pressed.iter().map(|contact| contact.normal);
    let bounded = pressed.iter().flat_map(|contact| contact.bounded_rows());
    let own: Vec<usize> = normals.chain(contacts.joints.iter().copied()).chain(bounded).collect();
    let active = rows.with_rows(&own);
    let of_own: Vec<f64> = own.iter().map(|&row| left[row]).collect();
    let change = least_norm_forces(&active, &matrix::of(&active)?, &of_own)?;
    let mut forces = vec![0.0; left.len()];
    own.into_iter().zip(change.forces).for_each(|(row, change)| forces[row] = change);
    Ok(LeastNormForces { forces, loads: change.loads })
}
