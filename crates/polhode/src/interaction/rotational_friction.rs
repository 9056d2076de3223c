//! Friction of rolling and of spinning: moments at a contact.
//!
//! A contact with the normal force `f_n` resists the angular velocity `w` of A relative to B. With `w_n` its part
//! along the normal and `w_t` the rest,
//!
//! `M_roll = -c_r f_n w_t / |w_t|`, and `|M_roll| <= c_r f_n` where `w_t = 0`;
//! `M_spin = -c_s f_n w_n / |w_n|`, and `|M_spin| <= c_s f_n` where `w_n = 0`.
//!
//! The lengths `c_r`, `c_s` (m) are the friction of rolling and of spinning. Source: docs/REFERENCES.md, Johnson 1985;
//! Leine and Glocker 2003. Assumptions: the contact is a point, moments of friction do not depend on the speed, and
//! the impulse of a moment at an impact is bounded by the same length times the normal impulse.
//!
//! Method: rotations that are held are rows `l w = 0` beside the contact problem, with a length `l` of the pair: their
//! reactions `M / l` are forces, and their friction is the number `c / l` (`interaction/rotation_row.rs`). One whose moment exceeds its limit
//! turns against that moment. The moments of those that turn follow the normal forces, by repeating the solve until
//! they no longer change: a moment changes normal forces little or not at all. Fails where that does not converge:
//! the status of the solution says so.

use super::friction_blocks::{FrictionBlocks, RowSolution};
use crate::collision::contact_set::ContactId;
use crate::world::World;
use crate::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_response::friction::FrictionSettings;
use polhode_response::{Delassus, ResponseError, SolverStatus};
use polhode_spatial::DVec3;
use std::ops::Range;

/// Most repetitions of a solve. Each brings the moments nearer by the ratio of the length of friction to a lever arm.
const MOST_SOLVES: usize = 64;

/// Moments that change by less than this fraction of the largest no longer change (1e-15 to 1e-12).
const SETTLED: f64 = 1e-14;

/// A moment may exceed its limit by this fraction of it (1e-13 to 1e-9): the residual of the solver.
const LIMIT_ROUNDING: f64 = 1e-11;

/// A rotation that friction resists, among the rows of a problem.
#[derive(Debug, Clone)]
pub(crate) struct ResistedRotation {
    /// The normal row of its contact.
    pub(crate) normal: usize,
    /// Its own rows.
    pub(crate) rows: Range<usize>,
    /// The length of its friction over that of its rows (no unit).
    pub(crate) friction: f64,
    /// The direction in its rows in which it turns; none while it is held.
    pub(crate) turns: Option<Vec<f64>>,
}

impl ResistedRotation {
    /// Lets a held rotation turn if its moment is beyond the limit. Returns whether it does.
    fn gives_way(&mut self, reactions: &[f64]) -> bool {
        if self.turns.is_some() {
            return false;
        }
        let own = &reactions[self.rows.clone()];
        let moment = length(own);
        let gives_way = moment > self.friction * reactions[self.normal].max(0.0) * (1.0 + LIMIT_ROUNDING);
        if gives_way {
            self.turns = Some(own.iter().map(|part| -part / moment).collect());
        }
        gives_way
    }
}

/// Contacts with rotations that friction resists, solved.
#[derive(Debug)]
pub(crate) struct SettledRotations<S> {
    /// What the last solve found.
    pub(crate) found: S,
    /// Reactions of all rows, those of moments included.
    pub(crate) reactions: Vec<f64>,
    /// Whether the moments no longer change. Otherwise all numbers are those of the last solve.
    pub(crate) is_settled: bool,
}

/// Solves contacts with rotations that friction resists, each time by `solve`: it is given the blocks with rotations that
/// are held, the constant terms with those of the moments of others, and the reactions of the solve before, and returns
/// what it found with the reactions of the rows of the blocks. `blocks` hold all rows of `delassus` but those of
/// `rotations`. Rotations that give way turn afterwards.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn settle_rotations<S>(
    blocks: &FrictionBlocks,
    rotations: &mut [ResistedRotation],
    (delassus, constants): (&Delassus, &[f64]),
    mut solve: impl FnMut(&FrictionBlocks, &[f64], Option<&[f64]>) -> Result<(S, Vec<f64>), ResponseError>,
) -> Result<SettledRotations<S>, ResponseError> {
    let mut moments = vec![0.0; constants.len()];
    let mut start: Option<Vec<f64>> = None;
    let mut solves = 0;
    loop {
        let mut with_held = blocks.clone();
        for rotation in rotations.iter().filter(|rotation| rotation.turns.is_none()) {
            with_held.push_held(rotation.rows.clone());
        }
        let moved: Vec<f64> = delassus.times(&moments)?.iter().zip(constants).map(|(by, own)| by + own).collect();
        let (found, mut reactions) = solve(&with_held, &moved, start.as_deref())?;
        reactions.resize(constants.len(), 0.0);
        solves += 1;
        let mut any = false;
        for rotation in rotations.iter_mut() {
            any |= rotation.gives_way(&reactions);
        }
        let before = std::mem::replace(&mut moments, vec![0.0; constants.len()]);
        for rotation in rotations.iter() {
            let limit = rotation.friction * reactions[rotation.normal].max(0.0);
            for (row, direction) in rotation.rows.clone().zip(rotation.turns.iter().flatten()) {
                moments[row] = -limit * direction;
            }
        }
        let most = moments.iter().fold(0.0, |most: f64, moment| most.max(moment.abs()));
        let change = moments.iter().zip(&before).fold(0.0, |most: f64, (new, old)| most.max((new - old).abs()));
        let is_settled = !any && change <= SETTLED * most;
        if is_settled || solves == MOST_SOLVES {
            let used = if is_settled { &moments } else { &before };
            for (reaction, moment) in reactions.iter_mut().zip(used) {
                *reaction += moment;
            }
            return Ok(SettledRotations { found, reactions, is_settled });
        }
        start = Some(reactions);
    }
}

/// The forces of contacts with rotations that friction resists ([`settle_rotations`]).
///
/// # Errors
/// When a number is not finite.
pub(crate) fn solve_with_rotations(
    blocks: &FrictionBlocks,
    rotations: &mut [ResistedRotation],
    delassus: &Delassus,
    constants: &[f64],
) -> Result<RowSolution, ResponseError> {
    let solve = |blocks: &FrictionBlocks, constants: &[f64], start: Option<&[f64]>| {
        let mut solved = blocks.solve(delassus, constants, start, &FrictionSettings::default())?;
        let reactions = std::mem::take(&mut solved.reactions);
        Ok((solved, reactions))
    };
    let SettledRotations { found: mut solved, reactions, is_settled } =
        settle_rotations(blocks, rotations, (delassus, constants), solve)?;
    solved.reactions = reactions;
    let velocities = delassus.times(&solved.reactions)?;
    solved.velocities.resize(constants.len(), 0.0);
    for row in rotations.iter().filter(|one| one.turns.is_some()).flat_map(|one| one.rows.clone()) {
        solved.velocities[row] = velocities[row] + constants[row];
    }
    if !is_settled {
        solved.report.status = SolverStatus::Inaccurate;
    }
    Ok(solved)
}

/// The length of a vector.
fn length(parts: &[f64]) -> f64 {
    parts.iter().fold(0.0, |sum: f64, part| libm::hypot(sum, *part))
}

/// Applies impulses of moments on A (N m s, world) to the momenta of the bodies of their contacts.
pub(crate) fn apply_moments(
    world: &World,
    states: &mut [BodyState],
    moments: impl Iterator<Item = (ContactId, DVec3)>,
) {
    for (id, moment) in moments {
        for (body, signed) in [(id.a, moment), (id.b, -moment)] {
            if world.bodies[body].rigid.is_some() {
                states[body].angular_momentum += signed;
            }
        }
    }
}

/// Momentum that moments on A (N m s, N m) give to the bodies that move: only contacts with immovable bodies
/// contribute.
pub(crate) fn moment_support(world: &World, moments: impl Iterator<Item = (ContactId, DVec3)>) -> Momentum {
    let mut sum = MomentumSum::default();
    for (id, moment) in moments {
        let sign = match (world.carries_momentum(id.a), world.carries_momentum(id.b)) {
            (true, false) => 1.0,
            (false, true) => -1.0,
            _ => continue,
        };
        sum.add(Momentum { linear: DVec3::ZERO, angular: moment * sign });
    }
    sum.value()
}

/// Work (J; power, W) of kinematic bodies by moments on A (N m s; N m).
pub(crate) fn moment_work(
    world: &World,
    states: &[BodyState],
    moments: impl Iterator<Item = (ContactId, DVec3)>,
) -> f64 {
    let rotation = |body: usize| {
        if world.trajectory(body).is_some() { world.velocity(body, &states[body]).angular } else { DVec3::ZERO }
    };
    moments.map(|(id, moment)| -moment.dot(rotation(id.a) - rotation(id.b))).sum()
}
