//! Present forces of many contacts, in the accelerations of bodies: no matrix of all rows is formed.
//!
//! Contacts that stick have the cone of their static coefficient, those that slide the force `-mu f_n` along their
//! slip. Where contacts are redundant the forces are some of those that are possible, not the least ones: their sum on
//! each body, and the accelerations, are unique as far as Coulomb's law makes them so. Memory and time grow with
//! contacts and bodies.

use super::instant_forces::{BodyAcceleration, PresentForces, forces_on};
use crate::collision::friction_mode::FrictionMode;
use crate::collision::touch::Touch;
use crate::collision::{contact_kinematics, friction, slip_directions};
use crate::model::{Loads, Model};
use crate::rows::assembly::{Assembly, TangentRow};
use crate::rows::friction_blocks::push_contact;
use crate::scene::FrictionEllipse;
use crate::solve::joint_loads::joint_loads;
use polhode_contact::TangentialKinematics;
use polhode_dynamics::BodyState;
use polhode_response::solve::many::solve_many;
use polhode_response::{Blocks, Law, ResponseError, SolverStatus};
use polhode_spatial::DVec3;

/// The forces of `contacts`, with their modes, between `bodies` (movable, ascending) at `t` (s) under these loads; none
/// where they were not found.
///
/// # Errors
/// When a number is not finite.
pub(super) fn forces_of_many(
    model: &Model,
    (t, states): (f64, &[BodyState]),
    bodies: &[usize],
    contacts: &[Touch],
    loads: &Loads,
) -> Result<Option<PresentForces>, ResponseError> {
    let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let mut assembly = Assembly::new(model, states, bodies, rows)?;
    if !assembly.problem.is_of_pairs() {
        return Ok(None);
    }
    let free = assembly.free_accelerations(model, states, loads);
    let mut blocks = Blocks::default();
    // The contact of each row along a tangent.
    let mut owners = Vec::new();
    for (normal, touch) in contacts.iter().enumerate() {
        let first = assembly.problem.len();
        let Rubbing { rows, law } = rubbing(model, states, touch);
        assembly.push_tangents(states, rows.into_iter())?;
        let tangents = first..assembly.problem.len();
        owners.extend(tangents.clone().map(|_| normal));
        match law {
            Rubs::Sticks(ellipse) => push_contact(&mut blocks, ellipse, normal, tangents),
            Rubs::Slides(friction) => blocks.push(Law::Slide { friction }, std::iter::once(normal).chain(tangents)),
        }
    }
    blocks.hold(contacts.len()..assembly.first_tangent());
    let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
    let constants = assembly.acceleration_constants(model, t, states, &free, kinematics)?;
    let solved = solve_many(&assembly.problem, &blocks, &constants)?;
    if solved.report.status != SolverStatus::Solved {
        return Ok(None);
    }
    let mut friction = vec![DVec3::ZERO; contacts.len()];
    for ((row, force), owner) in assembly.of_tangents(&solved.reactions).zip(owners) {
        friction[owner] += row.along.normal * force;
    }
    let mut accelerations = assembly.problem.response(&solved.reactions)?;
    for (acceleration, free) in accelerations.iter_mut().zip(&free) {
        *acceleration += free;
    }
    let body = |(body, linear, angular): (usize, DVec3, DVec3)| BodyAcceleration { body, linear, angular };
    let normal: Vec<f64> = solved.reactions.iter().take(contacts.len()).copied().collect();
    let on_contacts = forces_on(contacts, &normal, &friction);
    let joints = joint_loads(model, states, (&assembly, &solved.reactions), on_contacts);
    let accelerations = assembly.split(&accelerations).map(body).collect();
    Ok(Some(PresentForces { normal, friction, accelerations, joints }))
}

/// The rows of a contact along its tangents, and its law.
struct Rubbing {
    rows: Vec<TangentRow>,
    law: Rubs,
}

enum Rubs {
    /// It sticks, or has no friction.
    Sticks(FrictionEllipse),
    /// It slides, with this coefficient along its row.
    Slides(f64),
}

fn rubbing(model: &Model, states: &[BodyState], touch: &Touch) -> Rubbing {
    let none = Rubbing { rows: Vec::new(), law: Rubs::Sticks(FrictionEllipse::default()) };
    if friction::friction_of(model, touch.id).is_none() {
        return none;
    }
    let Some(terms) = contact_kinematics::tangential_kinematics(model, states, touch.id) else { return none };
    let Some(coefficients) = friction::friction_at(model, states, touch.id, terms.basis) else { return none };
    let row =
        |terms: &TangentialKinematics, tangent| TangentRow::new(touch.id, &touch.kinematics.geometry, terms, tangent);
    if let Some(FrictionMode::Sliding(slide)) = touch.modes.friction {
        let (against, friction) = coefficients.sliding.opposed(terms.basis, slide.direction);
        return Rubbing { rows: vec![row(&terms, against)], law: Rubs::Slides(friction) };
    }
    let tangents = slip_directions::slip_directions(model).tangents(&terms.basis);
    let rows = tangents.iter().map(|&tangent| row(&terms, tangent)).collect();
    Rubbing { rows, law: Rubs::Sticks(coefficients.at_rest) }
}
