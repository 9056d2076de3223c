//! Impacts of a group in which contacts have friction.
//!
//! The contacts are struck by the laws of `polhode_response::impact::friction`: one contact alone by Stronge's energetic
//! restitution along Routh's path of slip, stick and reversal; several together by the cone problem of their velocities
//! after generalised reflection, or one after the other where the scene asks for propagation. The coefficient is that of
//! kinetic friction. A scene may name another law for one contact alone ([`polhode_response::RestitutionLaw`]).
//!
//! An impact without a collision has the same impulses, but no approach: contacts slide, and no finite forces satisfy
//! Coulomb's law (Painleve).

use super::assembly::{Assembly, TangentRow};
use super::friction_blocks::FrictionBlocks;
use crate::collision::contact_set::{ContactId, Touch};
use crate::scene::{FrictionEllipse, ImpactLaw};
use crate::world::{Loads, World};
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_response::impact::{Application, ImpactOutcome, ImpactStatus};
use polhode_response::{
    MultipleFrictionalImpact, MultipleImpactLaw, MultipleImpactSettings, MultipleImpactStatus, ResponseError,
};

/// An impact with friction.
#[derive(Debug)]
pub(crate) struct FrictionalImpact {
    pub(crate) assembly: Assembly,
    /// Of the rows of contacts and pivots; changes of energy without the work of friction.
    pub(crate) outcome: ImpactOutcome,
    /// Impulses along tangents, N s: the contact with the tangent in the place of its normal, and the impulse on A.
    pub(crate) tangential: Vec<(ContactId, ContactGeometry, f64)>,
    /// Work of the impulses along tangents, J; negative when energy is lost.
    pub(crate) friction_work_j: f64,
    /// The law of restitution that was kept.
    pub(crate) restitution: Restitution,
}

/// Why contacts are struck.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Cause<'a> {
    /// They approach.
    Collision,
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
pub(crate) fn have_friction(world: &World, contacts: &[Touch]) -> bool {
    world.has_friction() && contacts.iter().any(|touch| world.friction_of(touch.id.a, touch.id.b).is_some())
}

/// Solves for the impulses at `contacts` and at the pivots of `bodies` (movable, ascending).
///
/// # Errors
/// When a number is not finite.
pub(crate) fn solve(
    world: &World,
    states: &[BodyState],
    bodies: &[usize],
    contacts: &[Touch],
    (law, cause): (ImpactLaw, Cause<'_>),
) -> Result<FrictionalImpact, ResponseError> {
    let rows = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let mut assembly = Assembly::new(world, states, bodies, rows)?;
    let (blocks, before) = blocks_of(&mut assembly, world, states, contacts)?;
    let mut restitution: Vec<f64> =
        contacts.iter().map(|touch| world.scene.pair_material(touch.id.a, touch.id.b).restitution()).collect();
    // Pivots have no restitution.
    restitution.resize(blocks.len(), 0.0);
    let problem = blocks.problem(&assembly.problem.delassus(), &before)?;
    let impact = MultipleFrictionalImpact {
        contacts: &problem,
        restitution: &restitution,
        law: if law == ImpactLaw::Propagation { MultipleImpactLaw::Sequence } else { MultipleImpactLaw::Simultaneous },
        single: world.scene.method().restitution_law.unwrap_or_default(),
        settings: &MultipleImpactSettings::default(),
    };
    let struck = match cause {
        Cause::Collision => impact.resolve()?,
        Cause::Jam(t, loads) => {
            let free = assembly.free_accelerations(world, states, loads);
            let kinematics = contacts.iter().map(|touch| (touch.id, &touch.kinematics));
            let accelerations = assembly.acceleration_constants(world, t, states, &free, kinematics)?;
            impact.without_collision(&blocks.of_rows(&accelerations))?
        }
    };
    let impulses = blocks.reactions_in_rows(&struck.impulses);
    let first = assembly.first_tangent();
    let along = assembly.tangents().iter().zip(impulses.iter().skip(first));
    let tangential = along.map(|(row, &impulse)| (row.id, row.along, impulse)).collect();
    let applications = (0..contacts.len()).filter(|&row| impulses[row] != 0.0).map(|row| Application {
        row,
        impulse: impulses[row],
        energy_change: struck.normal_work[row] + struck.friction_work[row],
    });
    let applications = applications.collect();
    let friction_work_j: f64 = struck.friction_work.iter().sum();
    let outcome = ImpactOutcome {
        applications,
        finishing: Vec::new(),
        velocities_after: blocks.velocities_in_rows(&struck.velocities_after).into_iter().take(first).collect(),
        status: status_of(struck.status),
        energy_change: struck.energy_change - friction_work_j,
        solves: struck.solves,
        residual: struck.residual,
        impulses: impulses.into_iter().take(first).collect(),
    };
    let restitution = match struck.status {
        _ if struck.energy_rises => Restitution::RaisesEnergy,
        MultipleImpactStatus::RestitutionLowered => Restitution::Lowered,
        _ => Restitution::Full,
    };
    Ok(FrictionalImpact { assembly, outcome, tangential, friction_work_j, restitution })
}

/// Adds the rows along the tangents of contacts with friction. Returns the block of each contact and those of pivots, and
/// the velocities of all rows before the impact, m/s.
fn blocks_of(
    assembly: &mut Assembly,
    world: &World,
    states: &[BodyState],
    contacts: &[Touch],
) -> Result<(FrictionBlocks, Vec<f64>), ResponseError> {
    let mut before: Vec<f64> = contacts.iter().map(|touch| touch.kinematics.separation_rate).collect();
    before.extend(assembly.pivots().iter().flat_map(|pivot| pivot.velocity.to_array()));
    let mut blocks = FrictionBlocks::default();
    for (normal, touch) in contacts.iter().enumerate() {
        let friction = world.friction_of(touch.id.a, touch.id.b).filter(|friction| friction.sliding.largest() > 0.0);
        let terms = friction.and_then(|_| world.tangential_kinematics(states, touch.id));
        let first = assembly.problem.len();
        let mut ellipse = FrictionEllipse::default();
        if let Some(terms) = terms {
            ellipse = world.friction_at(states, touch.id, terms.basis).map_or(ellipse, |friction| friction.sliding);
            let row = |tangent| TangentRow::new(touch.id, &touch.kinematics.geometry, &terms, tangent);
            assembly.push_tangents(states, terms.basis.into_iter().map(row))?;
            before.extend(terms.basis.map(|tangent| tangent.dot(terms.slip_velocity)));
        }
        blocks.push_contact(ellipse, normal, first..assembly.problem.len());
    }
    blocks.push_held(contacts.len()..assembly.first_tangent());
    Ok((blocks, before))
}

/// The status as impacts without friction state it; [`Restitution`] says whether restitution was lowered.
const fn status_of(status: MultipleImpactStatus) -> ImpactStatus {
    match status {
        MultipleImpactStatus::NoApproach => ImpactStatus::NoApproach,
        MultipleImpactStatus::Separated
        | MultipleImpactStatus::StruckInOrder
        | MultipleImpactStatus::RestitutionLowered => ImpactStatus::Separated,
        MultipleImpactStatus::StoppedAtThreshold => ImpactStatus::StoppedAtThreshold,
        MultipleImpactStatus::NotSolved => ImpactStatus::NotSolved,
    }
}
