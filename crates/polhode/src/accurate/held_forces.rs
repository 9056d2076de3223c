//! Forces of active contacts and of bilateral constraints at one stage of a step, the modes of friction given.
//!
//! Unknown are the normal forces `f_n` of all contacts, the tangential forces of each contact that sticks, and the
//! forces of pivots; a contact that slides along `d` adds `-mu f_n d`. The equations are `chi'' = 0` of all contacts,
//! `u_T' = 0` of those that stick, and `a_Q = 0` of pivots. Friction of rolling and of spinning adds a moment for each
//! rotation that is held, with `w' = 0`, and `-c f_n w / |w|` for one that turns. Where they do not determine the
//! forces, those of least norm are taken, and where something slides those of least norm within the cones of the
//! contacts that stick (`polhode_response::Ask::Stage`). Without sliding the choice affects neither the motion nor the
//! ledger; with sliding it decides what friction takes, and with contacts that slide in different directions the motion
//! as well.
//!
//! Failure: where no forces lie in the cones, the least ones are taken, with their violation of Coulomb's law. Where
//! masses differ much, or contacts resist rotations, the least ones are taken without a look at the cones.

use crate::collision::active_contacts::ActiveContacts;
use crate::collision::contact_kinematics;
use crate::collision::contact_modes::ContactModes;
use crate::collision::friction_mode::FrictionMode;
use crate::collision::turn::Turn;
use crate::identity::contact_id::ContactId;
use crate::model::{Loads, Model, tolerances};
use crate::rows::assembly::{Assembly, TangentRow};
use crate::rows::friction_blocks::{part_of, push_contact};
use crate::rows::frictional_contact::{FrictionalContact, Sliding};
use crate::rows::rotation_row::RotationRow;
use crate::scene::FrictionEllipse;
use crate::solve::accelerations::{violation_of_bearings, with_loads_of_bearings};
use crate::solve::cone_violation::{ConeViolation, RubbingForce, largest_violation};
use crate::solve::reactions::Reactions;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_response::{Answer, Ask, Blocks, Memory, Question, Resistance, ResponseError};
use polhode_spatial::DVec3;
use std::ops::Range;

/// A rotation that friction resists.
#[derive(Debug, Clone, Copy)]
struct ResistedTurn {
    turn: Turn,
    /// The direction in which it turns, and the friction in the rows of rotations (no unit); none while it is held.
    turning: Option<(DVec3, f64)>,
}

/// An active contact with friction.
#[derive(Debug, Clone, Copy)]
pub(super) struct FrictionContact {
    /// Its index among the active contacts.
    contact: usize,
    own: FrictionalContact,
    /// The angular velocity of A relative to B, rad/s.
    rotation: DVec3,
    /// The length in the rows of its rotations, m.
    turning_length: f64,
    /// Rotations that friction resists.
    turns: [Option<ResistedTurn>; 2],
}

impl FrictionContact {
    /// The rows along the tangents along which it may slip, where it sticks.
    fn sticking_rows(&self) -> impl Iterator<Item = TangentRow> + '_ {
        Some(&self.own).filter(|own| own.sliding.is_none()).into_iter().flat_map(FrictionalContact::rows)
    }

    /// The row along what friction opposes, where it slides.
    fn sliding_row(&self) -> Option<TangentRow> {
        Some(self.own.row_along(self.own.sliding?.row))
    }

    /// The row of a rotation about an axis (unit vector, world).
    fn row_about(&self, axis: DVec3) -> RotationRow {
        RotationRow { id: self.own.id, axis: axis * self.turning_length }
    }

    /// The rows of rotations that are held.
    fn held_rotations(&self) -> impl Iterator<Item = RotationRow> + '_ {
        let held = self.turns.iter().flatten().filter(|resisted| resisted.turning.is_none());
        held.flat_map(|resisted| self.own.axes_of(resisted.turn)).map(|axis| self.row_about(axis))
    }

    /// The rotations that turn: their rows and their friction there (no unit).
    fn turning(&self) -> impl Iterator<Item = (RotationRow, f64)> + '_ {
        let turning = self.turns.iter().flatten().filter_map(|resisted| resisted.turning);
        turning.map(|(axis, friction)| (self.row_about(axis), friction))
    }
}

/// Forces of the held contacts and of bilateral constraints.
#[derive(Debug, Default)]
pub(super) struct HeldForces {
    pub(super) reactions: Reactions,
    /// What all of them add up to on each body (body, N, N m), where the sum of the rounded forces would shake light
    /// bodies.
    pub(super) sums: Option<Vec<(usize, DVec3, DVec3)>>,
    /// Power that the contacts that slide dissipate, W.
    pub(super) dissipation: f64,
    /// How far contacts that stick are from Coulomb's law while others slide.
    pub(super) violation: Option<ConeViolation>,
}

/// The contacts with friction among active contacts.
pub(super) fn friction_contacts<'a>(
    model: &'a Model,
    states: &'a [BodyState],
    contacts: &'a [(ContactId, ContactKinematics)],
    active: &'a ActiveContacts,
) -> impl Iterator<Item = FrictionContact> + 'a {
    let resist = active.resist_rotation();
    let friction = move |(contact, (id, kinematics)): (usize, &(ContactId, ContactKinematics))| {
        let ContactModes { friction, rotation: modes } = active.modes(*id);
        let own = FrictionalContact::of(model, states, (*id, kinematics.geometry), Some(friction?))?;
        let rotation = if resist { contact_kinematics::relative_rotation(model, states, *id) } else { DVec3::ZERO };
        let turns = Turn::ALL.map(|turn| {
            let turning = match modes.get(turn)? {
                FrictionMode::Sticking => None,
                FrictionMode::Sliding(slide) => {
                    let direction = slide.direction_of(turn.part(rotation, kinematics.geometry.normal));
                    Some((direction, turn.coefficient(model, (id.a, id.b))?))
                }
            };
            Some(ResistedTurn { turn, turning })
        });
        let turning_length = tolerances::turning_length(model, id.a, id.b);
        Some(FrictionContact { contact, own, rotation, turning_length, turns })
    };
    contacts.iter().enumerate().filter_map(friction)
}

/// The forces of `contacts`, of which some have `friction`, and of the bilateral constraints of `bodies` (movable,
/// ascending) at time `t` (s).
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve(
    model: &Model,
    (t, states): (f64, &[BodyState]),
    bodies: &[usize],
    contacts: &[(ContactId, ContactKinematics)],
    friction: &[FrictionContact],
    loads: &Loads,
    memory: &mut Memory,
) -> Result<HeldForces, ResponseError> {
    let rows = contacts.iter().map(|(id, kinematics)| (*id, kinematics.geometry));
    let mut assembly = Assembly::new(model, states, bodies, rows)?;
    assembly.push_tangents(states, friction.iter().flat_map(FrictionContact::sticking_rows))?;
    assembly.push_rotations(friction.iter().flat_map(FrictionContact::held_rotations))?;
    let equations = assembly.problem.len();
    assembly.push_tangents(states, friction.iter().filter_map(FrictionContact::sliding_row))?;
    assembly.push_rotations(friction.iter().flat_map(|contact| contact.turning().map(|(row, _)| row)))?;
    let free = assembly.free_accelerations(model, states, loads);
    let kinematics = contacts.iter().map(|(id, kinematics)| (*id, kinematics));
    let mut constants = assembly.acceleration_constants(model, t, states, &free, kinematics)?;
    constants.truncate(equations);
    let laws = Laws::new(&assembly, (contacts.len(), friction));
    let known = Question { blocks: Some(&laws.blocks), ..Question::default() };
    let Answer { reactions: forces, on_bodies, beyond_cones, .. } =
        with_loads_of_bearings(&mut assembly, &mut constants, (known, Ask::Stage), memory)?;
    let of_contacts = if beyond_cones { laws.violation(&forces) } else { None };
    let violation = ConeViolation::larger(of_contacts, violation_of_bearings(&assembly));
    let slips = friction.iter().filter_map(|contact| {
        let Sliding { row, coefficient, .. } = contact.own.sliding?;
        Some(coefficient * forces.get(contact.contact)? * row.dot(contact.own.terms.slip_velocity))
    });
    let turns = friction.iter().flat_map(|contact| {
        let power =
            |(row, mu): (RotationRow, f64)| Some(mu * forces.get(contact.contact)? * row.axis.dot(contact.rotation));
        contact.turning().filter_map(power)
    });
    let by_rotation: f64 = turns.sum();
    Ok(HeldForces {
        dissipation: slips.sum::<f64>() + by_rotation,
        violation,
        reactions: Reactions::of(&assembly, contacts.len(), &forces),
        sums: on_bodies.map(|loads| assembly.split(&loads).collect()),
    })
}

/// The next row of each mode: rows along tangents that stick, of rotations that are held, along which contacts slide,
/// about which they turn.
struct NextRows {
    sticking: usize,
    held_rotations: usize,
    slipping: usize,
    turning: usize,
}

impl NextRows {
    fn new(assembly: &Assembly, friction: &[FrictionContact]) -> Self {
        let sticking = assembly.first_tangent();
        let held_rotations = sticking + friction.iter().map(|own| own.sticking_rows().count()).sum::<usize>();
        let slipping = held_rotations + friction.iter().map(|own| own.held_rotations().count()).sum::<usize>();
        let turning = slipping + friction.iter().filter(|own| own.own.sliding.is_some()).count();
        Self { sticking, held_rotations, slipping, turning }
    }
}

/// So many rows from the next one on.
fn take(next: &mut usize, rows: usize) -> Range<usize> {
    *next += rows;
    *next - rows..*next
}

/// What contacts with their modes ask of their forces.
struct Laws<'a> {
    blocks: Blocks,
    /// The contacts that stick, with their rows along tangents.
    sticking: Vec<(&'a FrictionContact, Range<usize>)>,
}

impl<'a> Laws<'a> {
    /// Those of so many contacts, of which these have friction. Rows of joints hold whatever a law says.
    fn new(assembly: &Assembly, (contacts, friction): (usize, &'a [FrictionContact])) -> Self {
        let mut next = NextRows::new(assembly, friction);
        let (mut blocks, mut sticking) = (Blocks::default(), Vec::new());
        let mut with_friction = friction.iter().peekable();
        for normal in 0..contacts {
            let Some(own) = with_friction.next_if(|own| own.contact == normal) else {
                push_contact(&mut blocks, FrictionEllipse::default(), normal, 0..0);
                continue;
            };
            let tangents = match own.own.sliding {
                Some(_) => take(&mut next.slipping, 1),
                None => take(&mut next.sticking, own.own.slip.count()),
            };
            FrictionalContact::push_block(Some(&own.own), &mut blocks, normal, tangents.clone());
            if own.own.sliding.is_none() {
                sticking.push((own, tangents));
            }
            for resisted in own.turns.iter().flatten() {
                let (own_rows, friction) = match resisted.turning {
                    Some((_, friction)) => (take(&mut next.turning, 1), friction),
                    None => (take(&mut next.held_rotations, own.own.axes_of(resisted.turn).len()), 0.0),
                };
                let slides = resisted.turning.is_some();
                let resistance = Resistance { rows: own_rows.len(), friction, slides };
                blocks.resist(part_of(resisted.turn), resistance, own_rows);
            }
        }
        Self { blocks, sticking }
    }

    /// How far contacts that stick are from Coulomb's law.
    fn violation(&self, forces: &[f64]) -> Option<ConeViolation> {
        let rubbing = self.sticking.iter().map(|(contact, rows)| {
            let FrictionalContact { id, coefficients, .. } = contact.own;
            let (normal, tangential) = (forces[contact.contact], coefficients.at_rest.length(&forces[rows.clone()]));
            RubbingForce { pair: (id.a, id.b), normal, tangential, friction: coefficients.at_rest.largest() }
        });
        largest_violation(rubbing, 0.0)
    }
}
