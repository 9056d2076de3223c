//! Impacts of a group in which contacts have friction.
//!
//! The contacts are struck by the laws of `polhode_response::impact::friction`: one contact alone by Stronge's
//! energetic restitution along Routh's path of slip, stick and reversal; several together, as a contact and its mirror
//! image in planar motion, by the cone problem of their velocities
//! after generalised reflection, one after the other where the scene asks for propagation, as springs where it asks for
//! pulse. The coefficient is that of kinetic friction. Friction of rolling and of spinning gives impulses of moments,
//! bounded by its length times the normal impulse: a contact with it is struck by the cone problem, also alone. A scene
//! may name another law for one contact alone without it ([`polhode_response::RestitutionLaw`]).
//!
//! An impact without a collision has the same impulses, but no approach: contacts slide, and no finite forces satisfy
//! Coulomb's law (Painleve).

use crate::collision::touch::Touch;
use crate::collision::{contact_kinematics, friction};
use crate::joints::joint_contacts;
use crate::model::{Loads, Model, tolerances};
use crate::rows::assembly::Assembly;
use crate::rows::friction_blocks::push_contact;
use crate::rows::frictional_contact::FrictionalContact;
use crate::rows::resisted_rotation::{self, with_rotations};
use crate::scene::{FrictionEllipse, ImpactLaw};
use crate::solve::cone_violation::{ConeViolation, RubbingForce, largest_violation};
use polhode_dynamics::BodyState;
use polhode_response::impact::{ImpactOutcome, ImpactStatus};
use polhode_response::solve::impact::{BlockLaw, Blow, Impact, Strikes, Struck, strike};
use polhode_response::{Blocks, Memory, ResponseError, RestitutionLaw};
use polhode_spatial::CompensatedSum;

/// An impact with friction.
#[derive(Debug)]
pub(crate) struct FrictionalImpact {
    pub(crate) assembly: Assembly,
    /// Of the rows of contacts and pivots; changes of energy without the work of friction.
    pub(crate) outcome: ImpactOutcome,
    /// Impulses of all rows, N s.
    pub(crate) reactions: Vec<f64>,
    /// Work of the impulses along tangents and of moments, J; negative when energy is lost.
    pub(crate) friction_work_j: f64,
    /// The law of restitution that was kept.
    pub(crate) restitution: Restitution,
    /// How far the impulses are from Coulomb's law.
    pub(crate) violation: Option<ConeViolation>,
}

/// Why contacts are struck.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Cause<'a> {
    /// They approach; those slower than this part of the fastest do not (no unit).
    Collision(f64),
    /// They jam at this time (s) under these loads.
    Jam(f64, &'a Loads),
}

/// Whether an impact gave the restitution asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Restitution {
    /// It did.
    #[default]
    Full,
    /// Less: with friction the full one would have given back more than `e^2` of the work of compression, or energy.
    Lowered,
    /// The law of restitution has raised the energy.
    RaisesEnergy,
}

/// Whether one of some contacts has friction.
pub(crate) fn have_friction(model: &Model, contacts: &[Touch]) -> bool {
    model.has_friction() && contacts.iter().any(|touch| friction::friction_of(model, touch.id).is_some())
}

/// Solves for the impulses at `contacts` and at the pivots of `bodies` (movable, ascending).
///
/// # Errors
/// When a number is not finite.
pub(crate) fn solve(
    model: &Model,
    states: &[BodyState],
    bodies: &[usize],
    contacts: &[Touch],
    (law, cause): (ImpactLaw, Cause<'_>),
) -> Result<FrictionalImpact, ResponseError> {
    let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let mut assembly = Assembly::new(model, states, bodies, rows)?;
    let of_contact = |touch: &Touch| FrictionalContact::of(model, states, (touch.id, touch.kinematics.geometry), None);
    let frictional: Vec<_> = contacts.iter().map(of_contact).collect();
    let (blocks, mut before) = blocks_of(&mut assembly, states, (contacts, &frictional))?;
    let rotations = match cause {
        Cause::Collision(_) => resisted_rotation::push(&mut assembly, model, &frictional, |_, _| None)?,
        Cause::Jam(..) => Vec::new(),
    };
    before.extend(assembly.rotations().iter().map(|row| row.rate(model, states)));
    let accelerations = match cause {
        Cause::Collision(_) => None,
        Cause::Jam(t, loads) => {
            let free = assembly.free_accelerations(model, states, loads);
            let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
            Some(assembly.acceleration_constants(model, t, states, &free, kinematics)?)
        }
    };
    let noise_floor = tolerances::velocity_rounding(model, states, bodies);
    take_out_rounding(&mut before, noise_floor);
    let blocks = with_rotations(blocks, &rotations);
    let restitution: Vec<f64> = contacts.iter().map(|touch| joint_contacts::restitution_at(model, touch)).collect();
    let mirrored: Vec<usize> = (0..contacts.len())
        .filter(|&contact| contact_kinematics::mirrored(model, states, contacts[contact].id).is_some())
        .collect();
    let blow = match &accelerations {
        Some(accelerations) => Blow::Jam(accelerations),
        None if are_micro_collisions(model, contacts) => Blow::MicroCollision,
        None => Blow::Collision,
    };
    let by = BlockLaw {
        blocks: &blocks,
        blow,
        noise_floor,
        stand_for_several: &mirrored,
        law: law.of_contacts_with_friction(model.scene.method().pulse_exponent.unwrap_or_default()),
        single: single_law(model, law),
        threshold: if let Cause::Collision(threshold) = cause { Some(threshold) } else { None },
    };
    let impact =
        Impact { rows: &assembly.problem, before: &before, restitution: &restitution, law: Strikes::Blocks(by) };
    let struck = strike(&impact, &mut Memory::default())?;
    let violation = violation_of(&assembly, &frictional, &struck.outcome.impulses);
    // Contacts of the cone problem are at zero to its residual: the energy is that of what the impulses really do. They
    // act along the rows. Where curves are nearly parallel, the rate of their separation is less exact than these.
    for (velocity, touch) in before.iter_mut().zip(contacts) {
        *velocity = rate_of_separation(model, states, touch);
    }
    Ok(FrictionalImpact { violation, ..impact_of(assembly, &before, struck) })
}

/// The impact at rows that moved at `before` (m/s): of contacts and pivots, of tangents and rotations.
fn impact_of(assembly: Assembly, before: &[f64], struck: Struck) -> FrictionalImpact {
    let Struck { mut outcome, changes, friction_work, energy_rises, .. } = struck;
    let first = assembly.first_tangent();
    let of_first = outcome.impulses.iter().take(first).copied().collect();
    let reactions = std::mem::replace(&mut outcome.impulses, of_first);
    let works = reactions.iter().zip(&changes).zip(before).map(|((p, given), before)| p * (before + 0.5 * given));
    let energy_change = works.collect::<CompensatedSum>().value();
    let friction_work_j = share_of_friction(friction_work, energy_change);
    outcome.energy_change = energy_change - friction_work_j;
    outcome.velocities_after.truncate(first);
    let restitution = match outcome.status {
        _ if energy_rises => Restitution::RaisesEnergy,
        ImpactStatus::RestitutionLowered => Restitution::Lowered,
        _ => Restitution::Full,
    };
    if matches!(outcome.status, ImpactStatus::StruckInOrder | ImpactStatus::RestitutionLowered) {
        outcome.status = ImpactStatus::Separated;
    }
    FrictionalImpact { assembly, outcome, reactions, friction_work_j, restitution, violation: None }
}

/// Whether no contact approaches faster than a micro-collision, where there are any.
fn are_micro_collisions(model: &Model, contacts: &[Touch]) -> bool {
    let is_slow = |slow: f64| contacts.iter().all(|touch| -touch.kinematics.separation_rate <= slow);
    model.envelope.is_some_and(|envelope| is_slow(envelope.slow))
}

/// The law of a contact that is struck alone: that of the scene, or else that of its impact law.
fn single_law(model: &Model, law: ImpactLaw) -> RestitutionLaw {
    model.scene.method().restitution_law.unwrap_or(law.of_single_contact())
}

/// Rate of separation of two bodies at the point of a contact, m/s.
pub(crate) fn rate_of_separation(model: &Model, states: &[BodyState], touch: &Touch) -> f64 {
    let geometry = &touch.kinematics.geometry;
    let at_point = |body: usize| {
        let velocity = model.velocity(body, &states[body]);
        velocity.linear + velocity.angular.cross(geometry.point - states[body].pose.translation)
    };
    geometry.normal.dot(touch.id.relative(at_point))
}

/// What friction took of the change of energy of an impact, J; negative when energy is lost. Works of impulses that act
/// together are those along the straight way from the velocities before to those after. Where one of the two would give
/// energy along that way, although both together take some, what was lost is the other's.
const fn share_of_friction(by_friction: f64, energy_change: f64) -> f64 {
    if energy_change < 0.0 { by_friction.clamp(energy_change, 0.0) } else { by_friction }
}

/// Velocities that are zero but for rounding (m/s) are zero: whether a contact that rests counts as bearing or as open
/// at the first step of a solver must not depend on the directions of the world.
fn take_out_rounding(velocities: &mut [f64], rounding: f64) {
    for velocity in velocities.iter_mut().filter(|velocity| velocity.abs() <= rounding) {
        *velocity = 0.0;
    }
}

/// How far impulses of all rows are from Coulomb's law.
fn violation_of(
    assembly: &Assembly,
    frictional: &[Option<FrictionalContact>],
    impulses: &[f64],
) -> Option<ConeViolation> {
    let mut tangents = assembly.of_tangents(impulses).peekable();
    let mut rubbing = Vec::new();
    for (normal, own) in frictional.iter().enumerate() {
        let Some(own) = own else { continue };
        let mut along = Vec::new();
        while let Some((_, impulse)) = tangents.next_if(|(row, _)| row.id == own.id) {
            along.push(impulse);
        }
        if !along.is_empty() {
            let (pair, ellipse) = ((own.id.a, own.id.b), own.coefficients.sliding);
            let (tangential, friction) = (ellipse.length(&along), ellipse.largest());
            rubbing.push(RubbingForce { pair, normal: impulses[normal], tangential, friction });
        }
    }
    largest_violation(rubbing.into_iter(), 0.0)
}

/// Adds the rows along the tangents of contacts with friction. Returns the block of each contact and those of pivots,
/// and the velocities of all rows before the impact, m/s.
fn blocks_of(
    assembly: &mut Assembly,
    states: &[BodyState],
    (contacts, frictional): (&[Touch], &[Option<FrictionalContact>]),
) -> Result<(Blocks, Vec<f64>), ResponseError> {
    let mut before = assembly.rates(contacts.iter().map(|touch| touch.kinematics.separation_rate));
    let mut blocks = Blocks::default();
    for (normal, friction) in frictional.iter().enumerate() {
        let rubs = friction.as_ref().filter(|own| own.coefficients.sliding.largest() > 0.0);
        let first = assembly.problem.len();
        assembly.push_tangents(states, rubs.into_iter().flat_map(FrictionalContact::rows))?;
        let slips = rubs.into_iter().flat_map(|own| own.tangents().into_iter().map(move |tangent| (own, tangent)));
        before.extend(slips.map(|(own, tangent)| tangent.dot(own.terms.slip_velocity)));
        let ellipse = rubs.map_or_else(FrictionEllipse::default, |own| own.coefficients.sliding);
        push_contact(&mut blocks, ellipse, normal, first..assembly.problem.len());
    }
    blocks.hold(contacts.len()..assembly.first_tangent());
    Ok((blocks, before))
}
