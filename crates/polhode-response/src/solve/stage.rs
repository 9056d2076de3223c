//! Rows that hold while contacts slide as they are said to: forces at a stage of a step, the modes of friction given.
//!
//! Where the rows do not determine the forces, those of least norm are taken, and where something slides those of least
//! norm within the cones of the contacts that stick. Where masses differ much, or contacts resist rotations, the least
//! ones are taken without a look at the cones. Failure: where no forces lie in the cones, the least ones are the
//! answer, which [says so](Answer::beyond_cones).

use super::answer::Answer;
use super::held::report_of;
use super::problem::{Memory, RowProblem, Rows};
use super::{matrix, way};
use crate::delassus::Delassus;
use crate::dense::kernels::dot;
use crate::error::ResponseError;
use crate::friction::Blocks;
use crate::law::Law;
use crate::least_in_cones::least_forces_in_cones;
use crate::least_norm_hold::{LeastNormForces, least_norm_forces};
use crate::sliding::{SlidingFactors, SlidingRow};
use crate::sparse::{BesideForest, HeldForest};

/// The forces of rows that are held, the last ones of which slide as their blocks say. The constant terms are of the
/// rows that are held.
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve(problem: &RowProblem<'_>, blocks: &Blocks, memory: &mut Memory) -> Result<Answer, ResponseError> {
    let (rows, sliding) = (problem.rows, sliding_rows(blocks));
    let held = rows.len().saturating_sub(sliding.len());
    let constants = problem.known.constants;
    let constants = constants.get(..held).unwrap_or(constants);
    if sliding.is_empty()
        && let Some(forest) = way::trees(rows, problem.joints.clone())
    {
        return beside(problem, &forest);
    }
    let Memory { delassus, sliding: factors, .. } = memory;
    let known = factors.take().filter(|_| problem.known.rows == Rows::AsBefore);
    if known.is_none() {
        matrix::fill(delassus, rows)?;
    }
    let found = if sliding.is_empty() {
        Answer::from(least_norm_forces(rows, delassus, constants)?)
    } else {
        let known = match known {
            Some(known) => known,
            None => SlidingFactors::of(rows, delassus, &sliding, constants.len())?,
        };
        let least = factors.insert(known).forces(rows, constants, &sliding)?;
        within_cones((delassus, held, &sliding), blocks, least)?
    };
    let left: Vec<f64> = match &found.on_bodies {
        Some(loads) => {
            let mut all = constants.to_vec();
            all.resize(rows.len(), 0.0);
            rows.accelerations_under(&all, &found.reactions, loads)?
        }
        None => constants.iter().enumerate().map(|(row, own)| dot(delassus.row(row), &found.reactions) + own).collect(),
    };
    let report = report_of(&left[..constants.len()], constants);
    Ok(Answer { report, ..found })
}

impl Memory {
    /// How the forces of so many rows, the answer at the [stage](super::Ask::Stage) before, change with the constant
    /// terms of those that are held, as long as no cone bounds them: to some ten digits. None where nothing slides.
    pub fn change_at_stage(&self, change: &[f64], blocks: &Blocks, rows: usize) -> Option<Vec<f64>> {
        self.sliding.as_ref()?.change(change, &sliding_rows(blocks), rows)
    }
}

/// The forces of rows that are all held: of those beside the trees the least ones.
fn beside(problem: &RowProblem<'_>, forest: &HeldForest) -> Result<Answer, ResponseError> {
    let (rows, constants) = (problem.rows, problem.known.constants);
    let of_others = if forest.others().is_empty() {
        Vec::new()
    } else {
        let BesideForest { problem: beside, delassus, .. } = forest.beside(rows);
        least_norm_forces(&beside, &delassus, &forest.constants_beside(rows, constants)?)?.forces
    };
    let held = forest.with_others(rows, constants, &of_others)?;
    let report = report_of(&held.rates, constants);
    Ok(Answer { reactions: held.forces, report, ..Answer::default() })
}

/// The rows along which contacts slide or turn, in their order.
fn sliding_rows(blocks: &Blocks) -> Vec<SlidingRow> {
    let (mut sliding, mut first) = (Vec::new(), 0);
    for law in blocks.laws() {
        let rows = &blocks.rows()[first..first + law.rows()];
        first += law.rows();
        for (own, part) in law.parts() {
            if part.slides
                && let (Some(&normal), Some(&tangent)) = (rows.first(), rows.get(own.start))
            {
                sliding.push(SlidingRow { normal, tangent, coefficient: part.friction });
            }
        }
    }
    sliding.sort_by_key(|row| row.tangent);
    sliding
}

/// The least forces within the cones that hold what `least` hold: the first `held` rows, with friction along those of
/// `sliding`. Where there are none `least` stay, and violate Coulomb's law.
fn within_cones(
    (delassus, held, sliding): (&Delassus, usize, &[SlidingRow]),
    blocks: &Blocks,
    least: LeastNormForces,
) -> Result<Answer, ResponseError> {
    let turns = blocks.laws().iter().any(|law| law.resists_rotation());
    // Forces that are known in twice the working precision, because masses differ much, would lose that.
    if turns || least.loads.is_some() {
        return Ok(Answer::from(least));
    }
    Ok(match least_forces_in_cones(delassus, held, sliding, &cones(blocks), &least.forces)? {
        Some(forces) => Answer::from(LeastNormForces { forces, loads: None }),
        None => Answer { beyond_cones: true, ..Answer::from(least) },
    })
}

/// What bounds forces while some contacts slide: the cones of those that stick, and the push of all.
fn cones(blocks: &Blocks) -> Blocks {
    let mut cones = Blocks::default();
    let mut first = 0;
    for (place, law) in blocks.laws().iter().enumerate() {
        match law {
            Law::Slide { .. } => cones.push(Law::Push, blocks.rows()[first..].iter().copied().take(1)),
            law if law.pushes() => blocks.push_to(&mut cones, place),
            _ => {}
        }
        first += law.rows();
    }
    cones
}
