//! Impacts: rows that approach are struck by a law of restitution, with friction or without.

use super::matrix;
use super::problem::Memory;
use crate::error::{ResponseError, check_length};
use crate::friction::Blocks;
use crate::impact::friction::reversal::reversal;
use crate::impact::friction::{
    MultipleFrictionalImpact, MultipleImpact, MultipleImpactLaw, MultipleImpactSettings, RestitutionLaw,
};
use crate::impact::{Application, ImpactLaw, ImpactOutcome, ImpactProblem, ImpactSettings};
use crate::problem::ContactProblem;
use crate::tolerances::LARGEST_RESIDUAL_ROUNDING;

/// An impact at rows.
#[derive(Debug, Clone, Copy)]
pub struct Impact<'a> {
    /// Bodies and rows.
    pub rows: &'a ContactProblem,
    /// Velocities of the rows before, m/s.
    pub before: &'a [f64],
    /// Restitution, from 0 to 1, of each row, of which that of a joint is not used; of each contact where blocks are
    /// struck.
    pub restitution: &'a [f64],
    /// The law that strikes them.
    pub law: Strikes<'a>,
}

/// How rows share an impact.
#[derive(Debug, Clone, Copy)]
pub enum Strikes<'a> {
    /// Rows without friction.
    Rows {
        /// How they share it.
        law: ImpactLaw,
        /// The order in which propagation strikes rows; none for that of the rows.
        order: Option<&'a [usize]>,
        /// Tolerances and limits.
        settings: &'a ImpactSettings,
    },
    /// Blocks with friction.
    Blocks(BlockLaw<'a>),
}

/// How blocks with friction share an impact.
#[derive(Debug, Clone, Copy)]
pub struct BlockLaw<'a> {
    /// Contacts first, then joints.
    pub blocks: &'a Blocks,
    /// Why they are struck.
    pub blow: Blow<'a>,
    /// The error of the velocities before by rounding, m/s.
    pub noise_floor: f64,
    /// Contacts (ascending) that stand for several each, as a contact and its mirror image in a plane.
    pub stand_for_several: &'a [usize],
    /// How contacts that move each other share the impact.
    pub law: MultipleImpactLaw,
    /// The law where one contact is struck alone.
    pub single: RestitutionLaw,
    /// A contact approaches when it does faster than this part of the fastest (no unit); none for rounding.
    pub threshold: Option<f64>,
}

/// Why contacts are struck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Blow<'a> {
    /// They approach.
    Collision,
    /// They approach slowly, as bodies that rest on each other do: those that stick reverse their slip as well.
    MicroCollision,
    /// They slide, and no finite forces satisfy Coulomb's law (Painleve): accelerations of the rows without forces,
    /// m/s^2.
    Jam(&'a [f64]),
}

/// What an impact did.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct Struck {
    /// Impulses and velocities of the rows in their order: those of contacts that hold are exactly 0.
    pub outcome: ImpactOutcome,
    /// What the impulses change the velocities by, m/s; of blocks only.
    pub changes: Vec<f64>,
    /// Work of the impulses along tangents, J.
    pub friction_work: f64,
    /// A warning: the energy rose by more than rounding, as some laws of restitution let it.
    pub energy_rises: bool,
}

/// Strikes rows. That the law finds no solution is no error: see the status.
///
/// # Errors
/// When a list has the wrong length, or a number is not finite or out of its range.
#[cfg_attr(feature = "census", track_caller)]
pub fn strike(impact: &Impact<'_>, memory: &mut Memory) -> Result<Struck, ResponseError> {
    let Impact { rows: contacts, before: u_before, restitution, law } = *impact;
    let outcome = match law {
        Strikes::Blocks(of_blocks) => return strike_blocks(impact, &of_blocks),
        Strikes::Rows { law, order, settings } => {
            let Memory { active_set, delassus, .. } = memory;
            matrix::fill(delassus, contacts)?;
            let problem = ImpactProblem { contacts, delassus, u_before, restitution, settings };
            match order {
                Some(order) => law.resolve_in_order(&problem, active_set, order),
                None => law.resolve(&problem, active_set),
            }
        }
    };
    Ok(Struck { outcome: outcome?, ..Struck::default() })
}

/// The same of blocks with friction.
#[cfg_attr(feature = "census", track_caller)]
fn strike_blocks(impact: &Impact<'_>, by: &BlockLaw<'_>) -> Result<Struck, ResponseError> {
    let Impact { rows, before, restitution: of_contacts, .. } = *impact;
    let BlockLaw { blocks, blow, stand_for_several, law, single, .. } = *by;
    check_length("restitution of contacts", blocks.contacts(), of_contacts.len())?;
    if let Blow::Jam(accelerations) = blow {
        check_length("accelerations of rows", rows.len(), accelerations.len())?;
    }
    let delassus = matrix::of(rows)?;
    let settings = settings_for(before, by);
    let mut restitution = of_contacts.to_vec();
    // Joints have no restitution.
    restitution.resize(blocks.len(), 0.0);
    let contacts = &blocks.problem(&delassus, before)?;
    let (restitution, settings) = (&restitution[..], &settings);
    let problem = MultipleFrictionalImpact { contacts, restitution, stand_for_several, law, single, settings };
    let struck = match blow {
        Blow::Jam(accelerations) => problem.without_collision(&blocks.velocities_in_blocks(accelerations))?,
        Blow::Collision => problem.resolve()?,
        Blow::MicroCollision => reversal(&problem, of_contacts.len())?.map_or_else(|| problem.resolve(), Ok)?,
    };
    let impulses = blocks.reactions_in_rows(&struck.impulses);
    let changes = delassus.times(&impulses)?;
    let velocities_after = blocks.velocities_in_rows(&struck.velocities_after);
    let applications = applications(blocks, &struck, &impulses);
    let MultipleImpact { status, energy_change, solves, residual, energy_rises, friction_work, .. } = struck;
    let finishing = Vec::new();
    let outcome =
        ImpactOutcome { impulses, applications, finishing, velocities_after, status, energy_change, solves, residual };
    Ok(Struck { outcome, changes, friction_work: friction_work.iter().sum(), energy_rises })
}

/// The impulses along the normals of contacts, each with the work of all rows of its contact.
fn applications(blocks: &Blocks, struck: &MultipleImpact, impulses: &[f64]) -> Vec<Application> {
    let mut first = 0;
    let firsts = blocks.laws().iter().take(blocks.contacts()).map(|law| {
        first += law.rows();
        blocks.rows()[first - law.rows()]
    });
    let works = struck.normal_work.iter().zip(&struck.friction_work).map(|(normal, friction)| normal + friction);
    let applications = firsts.zip(works).map(|(row, energy_change)| {
        let impulse = impulses[row];
        Application { row, impulse, energy_change }
    });
    applications.filter(|own| own.impulse != 0.0).collect()
}

/// Settings of an impact whose velocities have errors by rounding: where contacts hardly approach, redundant ones
/// contradict each other by that.
fn settings_for(before: &[f64], by: &BlockLaw<'_>) -> MultipleImpactSettings {
    let mut settings = MultipleImpactSettings::default();
    settings.threshold = by.threshold.unwrap_or(settings.threshold);
    let largest = before.iter().fold(0.0, |most: f64, velocity| most.max(velocity.abs()));
    if largest > 0.0 {
        let rounding = (by.noise_floor / largest).min(LARGEST_RESIDUAL_ROUNDING);
        settings.solver.acceptance = settings.solver.acceptance.max(rounding);
    }
    settings
}
