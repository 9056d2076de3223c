//! Forces of active contacts with friction at one stage of a step, their modes given.
//!
//! Unknown are the normal forces `f_n` of all contacts, two tangential forces of each contact that sticks, and the
//! forces of pivots; a contact that slides along `d` adds `-mu f_n d`. The equations are `chi'' = 0` of all contacts,
//! `u_T' = 0` of those that stick, and `a_Q = 0` of pivots. Where they do not determine the forces, those of least norm
//! are taken (`polhode_response::least_norm_sliding_forces`). Without sliding that does not affect the motion; with
//! contacts that slide in different directions it does.

use crate::collision::contact_set::ContactId;
use crate::collision::friction_mode::FrictionMode;
use crate::interaction::assembly::{Assembly, TangentRow};
use crate::pivots::PivotKinematics;
use crate::world::{Loads, World};
use polhode_contact::{ContactGeometry, ContactKinematics, TangentialKinematics};
use polhode_dynamics::BodyState;
use polhode_response::{ResponseError, SlidingRow, least_norm_forces, least_norm_sliding_forces};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// An active contact with friction.
#[derive(Debug, Clone, Copy)]
pub(super) struct FrictionContact {
    /// Its index among the active contacts.
    contact: usize,
    id: ContactId,
    geometry: ContactGeometry,
    terms: TangentialKinematics,
    /// The direction in which it slides, and its coefficient; none when it sticks.
    sliding: Option<(DVec3, f64)>,
}

/// Forces of contacts with friction and of pivots.
#[derive(Debug, Default)]
pub(super) struct FrictionForces {
    /// Normal forces of the contacts, N.
    pub(super) normal: Vec<f64>,
    /// Forces along tangents, N: (contact, the contact with the tangent in the place of its normal, force on A).
    pub(super) tangential: Vec<(ContactId, ContactGeometry, f64)>,
    /// Of the pivots, N.
    pub(super) pivots: Vec<(PivotKinematics, DVec3)>,
    /// Power that the contacts that slide dissipate, W.
    pub(super) dissipation: f64,
}

/// The contacts with friction among active contacts.
pub(super) fn friction_contacts(
    world: &World,
    states: &[BodyState],
    contacts: &[(ContactId, ContactKinematics)],
    modes: &BTreeMap<ContactId, FrictionMode>,
) -> Vec<FrictionContact> {
    let friction = |(contact, (id, kinematics)): (usize, &(ContactId, ContactKinematics))| {
        let mode = *modes.get(id)?;
        let terms = world.tangential_kinematics(states, *id)?;
        let sliding = match mode {
            FrictionMode::Sticking => None,
            FrictionMode::Sliding(slide) => {
                let coefficient = world.friction_of(id.a, id.b).map_or(0.0, |friction| friction.sliding);
                Some((slide.direction_of(terms.slip_velocity), coefficient))
            }
        };
        Some(FrictionContact { contact, id: *id, geometry: kinematics.geometry, terms, sliding })
    };
    contacts.iter().enumerate().filter_map(friction).collect()
}

/// The forces of `contacts` and of the pivots of `bodies` (movable, ascending) at time `t` (s).
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve(
    world: &World,
    (t, states): (f64, &[BodyState]),
    bodies: &[usize],
    contacts: &[(ContactId, ContactKinematics)],
    friction: &[FrictionContact],
    loads: &Loads,
) -> Result<FrictionForces, ResponseError> {
    let rows = contacts.iter().map(|(id, kinematics)| (*id, kinematics.geometry));
    let mut assembly = Assembly::new(world, states, bodies, rows)?;
    let row = |contact: &FrictionContact, tangent: DVec3| {
        TangentRow::new(contact.id, &contact.geometry, &contact.terms, tangent)
    };
    let sticking = friction.iter().filter(|contact| contact.sliding.is_none());
    let sticking: Vec<_> =
        sticking.flat_map(|contact| contact.terms.basis.map(|tangent| row(contact, tangent))).collect();
    assembly.push_tangents(states, sticking.into_iter())?;
    let equations = assembly.problem.len();
    let slides = friction.iter().filter_map(|contact| Some((contact, contact.sliding?)));
    let slides: Vec<_> =
        slides.map(|(contact, (direction, mu))| (row(contact, direction), contact.contact, mu)).collect();
    assembly.push_tangents(states, slides.iter().map(|&(row, ..)| row))?;
    let free = assembly.free_accelerations(world, states, loads);
    let kinematics = contacts.iter().map(|(id, kinematics)| (*id, kinematics));
    let mut constants = assembly.acceleration_constants(world, t, states, &free, kinematics)?;
    let delassus = assembly.problem.delassus();
    let forces = if slides.is_empty() {
        least_norm_forces(&assembly.problem, &delassus, &constants)?.forces
    } else {
        constants.truncate(equations);
        let sliding = slides.iter().enumerate().map(|(k, &(_, normal, coefficient))| SlidingRow {
            normal,
            tangent: equations + k,
            coefficient,
        });
        least_norm_sliding_forces(&delassus, &constants, &sliding.collect::<Vec<_>>())?
    };
    let first = assembly.first_tangent();
    let along = assembly.tangents().iter().zip(forces.iter().skip(first));
    let tangential = along.map(|(row, &force)| (row.id, row.along, force)).collect();
    let slips = friction.iter().filter_map(|contact| {
        let (direction, mu) = contact.sliding?;
        Some(mu * forces.get(contact.contact)? * direction.dot(contact.terms.slip_velocity))
    });
    Ok(FrictionForces {
        dissipation: slips.sum(),
        pivots: assembly.pivot_forces(&forces).map(|(pivot, force)| (*pivot, force)).collect(),
        tangential,
        normal: forces.get(..contacts.len()).unwrap_or_default().to_vec(),
    })
}
