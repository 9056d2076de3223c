//! Several contacts with friction struck one at a time, in the order of the blocks (thesis, section 3.3, with
//! friction).
//!
//! The first contact that approaches gets the impulse of the law of a single contact; then the search starts again.
//! Joints take part in each: their reactions to an impulse at the contact are found once, and the collision matrix is
//! that with the joints held. Each impulse by itself keeps what its law promises, so that the energy does not rise by
//! Stronge's.
//!
//! Assumption: the order of the blocks means something to the caller. Sequences that decay without end are cut off
//! below a threshold relative to the first approach, and what is left is removed by one inelastic cone problem.

use super::collision_matrix::CollisionMatrix;
use super::law::RestitutionLaw;
use super::outcome::FrictionalImpactStatus;
use super::part::{Part, Struck};
use super::reactions::UnitReactions;
use super::simultaneous::strike_together;
use super::single::SingleFrictionalImpact;
use crate::dense::kernels::largest;
use crate::error::ResponseError;
use crate::impact::ImpactStatus;
use polhode_spatial::rounding;

/// What may be left of the last approaches of a sequence, as a part of its threshold (no unit).
const ENOUGH: f64 = 0.1;

/// The largest residual of the last cone problem that is accepted (no unit).
const LARGEST_RESIDUAL: f64 = 0.01;

/// The part of its inverse mass along the normal that joints must leave a contact for its collision matrix to be formed
/// (no unit, 1e-8 to 1e-4): that has an error of some rounding units of the whole inverse mass.
const LEAST_FREEDOM: f64 = 1e-6;

/// What an impulse at one contact does.
#[derive(Debug, Clone)]
struct Reaction {
    collision: CollisionMatrix,
    friction: f64,
    /// For a unit impulse along each row of the contact: the impulses of all rows, those of joints included.
    impulses: Vec<Vec<f64>>,
    /// And the changes of velocity of all rows.
    changes: Vec<Vec<f64>>,
}

/// Strikes contact after contact of a part, whose joints do not move, `limit` times at most.
pub(super) fn strike_in_order(
    part: &mut Part,
    struck: &mut Struck,
    law: RestitutionLaw,
    limit: usize,
) -> Result<(), ResponseError> {
    let blocks = part.contacts.len();
    let mut reactions: Vec<Option<Reaction>> = vec![None; blocks];
    while let Some(&block) = part.approaching(&struck.velocities).first() {
        if struck.applications >= limit || part.status == ImpactStatus::NotSolved {
            part.status = part.status.max(ImpactStatus::StoppedAtThreshold);
            break;
        }
        if reactions[block].is_none() && !part.contacts.blocks()[block].resists_rotation() {
            reactions[block] = reaction_at(part, block)?;
        }
        match &reactions[block] {
            Some(reaction) => apply(part, struck, block, reaction, law)?,
            None => strike_with_joints(part, struck, block)?,
        }
    }
    let approaches = |block: usize| !part.is_joint(block) && struck.velocities[part.normal_row(block)] < 0.0;
    if (0..blocks).any(approaches) { finish(part, struck) } else { Ok(()) }
}

/// Strikes one contact of a part, whose joints do not move.
pub(super) fn strike_alone(
    part: &mut Part,
    struck: &mut Struck,
    block: usize,
    law: RestitutionLaw,
) -> Result<(), ResponseError> {
    match reaction_at(part, block)? {
        Some(reaction) => apply(part, struck, block, &reaction, law),
        None => strike_with_joints(part, struck, block),
    }
}

/// Strikes a contact that resists rotations, or that joints leave hardly any freedom, by the cone problem of its rows
/// and those of the joints. An approach of a contact without freedom is rounding, and is taken for none.
fn strike_with_joints(part: &mut Part, struck: &mut Struck, block: usize) -> Result<(), ResponseError> {
    let mut chosen = vec![block];
    chosen.extend(part.joints());
    let rows: Vec<usize> = chosen.iter().flat_map(|&block| part.contacts.range(block)).collect();
    let velocities: Vec<f64> = rows.iter().map(|&row| struck.velocities[row]).collect();
    let mut alone = Part::of(&part.contacts, &part.restitution, &chosen, part.settings)?;
    alone.tolerance = part.tolerance;
    let mut outcome = Struck::nothing(&alone, &velocities);
    struck.applications += 1;
    if !strike_together(&mut alone, &mut outcome)? {
        let normal = part.normal_row(block);
        if -struck.velocities[normal] <= rounding::HUNDREDS_OF_TERMS * largest(part.contacts.constant()) {
            struck.velocities[normal] = 0.0;
        } else {
            part.not_solved();
        }
        return Ok(());
    }
    part.solves += alone.solves;
    part.residual = part.residual.max(alone.residual);
    let mut impulses = vec![0.0; part.contacts.rows()];
    rows.iter().zip(&outcome.impulses).for_each(|(&row, &impulse)| impulses[row] = impulse);
    let mut after = part.after(&struck.velocities, &impulses);
    rows.iter().zip(&outcome.velocities).for_each(|(&row, &velocity)| after[row] = velocity);
    part.hold_joints(&mut after);
    struck.add(part, &impulses, after);
    Ok(())
}

/// What an impulse at `block` does, with all joints held. None where these leave it hardly any freedom along the
/// normal: of its collision matrix most digits are lost then.
fn reaction_at(part: &mut Part, block: usize) -> Result<Option<Reaction>, ResponseError> {
    let range = part.contact_rows(block);
    let UnitReactions { impulses, changes } = UnitReactions::of(part, range.clone())?;
    let entry = |i: usize, j: usize| 0.5 * changes[j][range.start + i] + 0.5 * changes[i][range.start + j];
    let alone = part.contacts.matrix().diagonal_entry(block, 0);
    let has_joints = !part.joints().is_empty();
    if has_joints && entry(0, 0) < LEAST_FREEDOM * alone {
        return Ok(None);
    }
    let full = [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i.max(j) < range.len() { entry(i, j) } else { 0.0 }));
    let held = if has_joints { without_rounding(full) } else { full };
    let collision = match range.len() {
        1 => CollisionMatrix::planar(held[0][0], 0.0, held[0][0])?,
        2 => CollisionMatrix::planar(held[0][0], held[0][1], held[1][1])?,
        _ => CollisionMatrix::new(held)?,
    };
    let friction = if range.len() == 1 { 0.0 } else { part.contacts.blocks()[block].friction().unwrap_or_default() };
    Ok(Some(Reaction { collision, friction, impulses, changes }))
}

/// A collision matrix with joints held, positive semidefinite: what the joints take from it leaves rounding, by which
/// the tangential part may fall below what its coupling with the normal asks for. The normal entry is above zero.
fn without_rounding(matrix: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let [[n, k1, k2], [_, t11, t12], [.., t22]] = matrix;
    let own = [k1 * (k1 / n), k1 * (k2 / n), k2 * (k2 / n)];
    let (first, second) = ((t11 - own[0]).max(0.0), (t22 - own[2]).max(0.0));
    let most = (first * second).sqrt();
    let both = (t12 - own[1]).max(-most).min(most) + own[1];
    [[n, k1, k2], [k1, first + own[0], both], [k2, both, second + own[2]]]
}

/// One impulse at one contact.
fn apply(
    part: &mut Part,
    struck: &mut Struck,
    block: usize,
    reaction: &Reaction,
    law: RestitutionLaw,
) -> Result<(), ResponseError> {
    let range = part.contact_rows(block);
    let mut velocity_before = [0.0; 3];
    velocity_before[..range.len()].copy_from_slice(&struck.velocities[range.clone()]);
    let impact = SingleFrictionalImpact {
        collision: reaction.collision,
        velocity_before,
        friction: reaction.friction,
        restitution: part.restitution[block],
        law,
    };
    let outcome = impact.resolve()?;
    if outcome.status == FrictionalImpactStatus::NotSolved {
        part.status = part.status.max(ImpactStatus::NotSolved);
    }
    for (k, &impulse) in outcome.impulse.iter().enumerate().take(range.len()) {
        let pairs = reaction.impulses[k].iter().zip(&reaction.changes[k]);
        for (row, (share, change)) in pairs.enumerate() {
            struck.impulses[row] += impulse * share;
            struck.velocities[row] += impulse * change;
        }
    }
    // The law says where the contact ends; the sum above says so up to rounding.
    struck.velocities[range.clone()].copy_from_slice(&outcome.velocity_after[..range.len()]);
    part.hold_joints(&mut struck.velocities);
    struck.normal_work[block] += outcome.normal_work;
    struck.friction_work[block] += outcome.friction_work;
    struck.energy_rises |= outcome.energy_rises;
    struck.applications += 1;
    Ok(())
}

/// Stops what still approaches by one inelastic cone problem. What a sequence leaves when it ends is below the
/// threshold and often no more than rounding, which contradicts itself at redundant contacts: it is stopped to a part
/// of the threshold.
pub(super) fn finish(part: &mut Part, struck: &mut Struck) -> Result<(), ResponseError> {
    let all: Vec<usize> = (0..part.contacts.len()).collect();
    let settings = part.settings;
    let left = largest(&struck.velocities);
    if left > 0.0 {
        let enough = (ENOUGH * part.tolerance / left).min(LARGEST_RESIDUAL);
        part.settings.acceptance = settings.acceptance.max(enough);
    }
    let answer = part.solve(&all, &struck.velocities, None)?;
    part.settings = settings;
    if !answer.is_solved {
        part.not_solved();
        return Ok(());
    }
    let mut after = part.after(&struck.velocities, &answer.impulses);
    for block in 0..part.contacts.len() {
        let row = part.normal_row(block);
        after[row] = after[row].max(0.0);
    }
    part.hold_joints(&mut after);
    struck.add(part, &answer.impulses, after);
    part.status = part.status.max(ImpactStatus::StoppedAtThreshold);
    Ok(())
}
