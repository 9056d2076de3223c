//! Impacts: rows that approach are struck by a law of restitution, with friction or without.

use super::problem::Memory;
use crate::error::{ResponseError, check_length};
use crate::friction::Blocks;
use crate::impact::friction::reversal::reversal;
use crate::impact::friction::{
    MultipleFrictionalImpact, MultipleImpact, MultipleImpactLaw, MultipleImpactSettings, RestitutionLaw,
};
use crate::impact::{ImpactLaw, ImpactOutcome, ImpactProblem, ImpactSettings, propagation_in_order};
use crate::problem::ContactProblem;
use crate::tolerances::LARGEST_RESIDUAL_ROUNDING;

/// An impact at rows without friction.
#[derive(Debug, Clone, Copy)]
pub struct RowImpact<'a> {
    /// Bodies and rows.
    pub rows: &'a ContactProblem,
    /// Velocities of the rows before, m/s.
    pub before: &'a [f64],
    /// Restitution of each row, from 0 to 1; that of a joint is not used.
    pub restitution: &'a [f64],
    /// How rows share the impact.
    pub law: ImpactLaw,
    /// The order in which propagation strikes rows; none for that of the rows.
    pub order: Option<&'a [usize]>,
    /// Tolerances and limits.
    pub settings: &'a ImpactSettings,
}

/// Strikes rows without friction. That the law finds no solution is no error: see the status.
///
/// # Errors
/// When a list has the wrong length, or a number is not finite or out of its range.
#[cfg_attr(feature = "census", track_caller)]
pub fn strike_rows(impact: &RowImpact<'_>, memory: &mut Memory) -> Result<ImpactOutcome, ResponseError> {
    let Memory { active_set, delassus } = memory;
    impact.rows.delassus_into(delassus);
    let RowImpact { rows: contacts, before: u_before, restitution, settings, .. } = *impact;
    let problem = ImpactProblem { contacts, delassus, u_before, restitution, settings };
    match impact.order {
        Some(order) => propagation_in_order(&problem, active_set, order),
        None => impact.law.resolve(&problem, active_set),
    }
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

/// An impact at blocks with friction.
#[derive(Debug, Clone, Copy)]
pub struct BlockImpact<'a> {
    /// Bodies and rows.
    pub rows: &'a ContactProblem,
    /// Contacts first, then joints.
    pub blocks: &'a Blocks,
    /// Velocities of the rows before, m/s.
    pub before: &'a [f64],
    /// The error of these by rounding, m/s.
    pub noise_floor: f64,
    /// Restitution of each contact, from 0 to 1.
    pub restitution: &'a [f64],
    /// Contacts (ascending) that stand for several each, as a contact and its mirror image in a plane.
    pub stand_for_several: &'a [usize],
    /// How contacts that move each other share the impact.
    pub law: MultipleImpactLaw,
    /// The law where one contact is struck alone.
    pub single: RestitutionLaw,
    /// A contact approaches when it does faster than this part of the fastest (no unit); none for rounding.
    pub threshold: Option<f64>,
}

/// What an impact at blocks did, in the order of the rows.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct StruckBlocks {
    /// Impulses, N s.
    pub reactions: Vec<f64>,
    /// Velocities afterwards by the law, m/s: those of contacts that hold are exactly 0.
    pub velocities: Vec<f64>,
    /// What the impulses change the velocities by, m/s.
    pub changes: Vec<f64>,
    /// Works, status and certificate of the law; its impulses and velocities are in the order of the blocks.
    pub outcome: MultipleImpact,
}

/// Strikes blocks with friction. That the law finds no solution is no error: see the status.
///
/// # Errors
/// When a list has the wrong length, or a number is not finite or out of its range.
#[cfg_attr(feature = "census", track_caller)]
pub fn strike_blocks(impact: &BlockImpact<'_>, blow: Blow<'_>) -> Result<StruckBlocks, ResponseError> {
    let BlockImpact { rows, blocks, before, .. } = *impact;
    check_length("restitution of contacts", blocks.contacts(), impact.restitution.len())?;
    if let Blow::Jam(accelerations) = blow {
        check_length("accelerations of rows", rows.len(), accelerations.len())?;
    }
    let delassus = rows.delassus();
    let settings = settings_for(impact);
    let mut restitution = impact.restitution.to_vec();
    // Joints have no restitution.
    restitution.resize(blocks.len(), 0.0);
    let problem = MultipleFrictionalImpact {
        contacts: &blocks.problem(&delassus, before)?,
        restitution: &restitution,
        stand_for_several: impact.stand_for_several,
        law: impact.law,
        single: impact.single,
        settings: &settings,
    };
    let outcome = match blow {
        Blow::Jam(accelerations) => problem.without_collision(&blocks.velocities_in_blocks(accelerations))?,
        Blow::Collision => problem.resolve()?,
        Blow::MicroCollision => reversal(&problem, impact.restitution.len())?.map_or_else(|| problem.resolve(), Ok)?,
    };
    let reactions = blocks.reactions_in_rows(&outcome.impulses);
    let changes = delassus.times(&reactions)?;
    let velocities = blocks.velocities_in_rows(&outcome.velocities_after);
    Ok(StruckBlocks { reactions, velocities, changes, outcome })
}

/// Settings of an impact whose velocities have errors by rounding: where contacts hardly approach, redundant ones
/// contradict each other by that.
fn settings_for(impact: &BlockImpact<'_>) -> MultipleImpactSettings {
    let mut settings = MultipleImpactSettings::default();
    settings.threshold = impact.threshold.unwrap_or(settings.threshold);
    let largest = impact.before.iter().fold(0.0, |most: f64, velocity| most.max(velocity.abs()));
    if largest > 0.0 {
        let rounding = (impact.noise_floor / largest).min(LARGEST_RESIDUAL_ROUNDING);
        settings.solver.acceptance = settings.solver.acceptance.max(rounding);
    }
    settings
}
