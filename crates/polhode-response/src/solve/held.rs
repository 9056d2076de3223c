//! Rows that hold, by the reactions of least norm: joints under given loads.

use super::way;
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::least_norm_hold::LeastNormHold;
use crate::problem::ContactProblem;
use std::ops::Range;

/// The reactions of joints that hold against these constant terms: beside their trees, or with the matrix of all rows.
///
/// # Errors
/// When a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn hold(rows: &ContactProblem, joints: Range<usize>, constants: &[f64]) -> Result<Vec<f64>, ResponseError> {
    let Some(forest) = way::trees(rows, joints) else { return Ok(hold_all(rows, constants)?.reactions) };
    let of_others = if forest.others().is_empty() {
        Vec::new()
    } else {
        let beside = forest.beside(rows);
        let constants = forest.constants_beside(rows, constants)?;
        LeastNormHold::factor_beside(&beside, 0.0)?.solve(&beside.delassus, &constants)?
    };
    Ok(forest.with_others(rows, constants, &of_others)?.forces)
}

/// Rows that hold as far as they can.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Held {
    /// One for each row.
    pub reactions: Vec<f64>,
    /// What is left of the constant terms: not rounding where rows contradict each other.
    pub left: Vec<f64>,
}

/// The same with the matrix of all rows: whether they contradict each other is seen among all of them.
///
/// # Errors
/// When a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn hold_all(rows: &ContactProblem, constants: &[f64]) -> Result<Held, ResponseError> {
    let delassus = rows.delassus();
    let reactions = LeastNormHold::factor(&delassus)?.solve(&delassus, constants)?;
    let left = delassus.times(&reactions)?.iter().zip(constants).map(|(given, constant)| given + constant).collect();
    Ok(Held { reactions, left })
}

/// Rows that hold whose reactions may not be determined: those of a mechanism with more supports than it needs.
#[derive(Debug)]
pub struct Supports {
    delassus: Delassus,
    hold: LeastNormHold,
}

impl Supports {
    /// Those of these rows.
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn of(rows: &ContactProblem) -> Result<Self, ResponseError> {
        let delassus = rows.delassus();
        Ok(Self { hold: LeastNormHold::factor(&delassus)?, delassus })
    }

    /// The part of some reactions that others may bear as well (no unit): 0 where they are determined. Rows that
    /// nothing can move, as those across the plane of a planar motion, bear nothing of them.
    ///
    /// # Errors
    /// When there is not one reaction for each row, or one is not finite.
    pub fn open_part(&self, mut reactions: Vec<f64>) -> Result<f64, ResponseError> {
        for (row, reaction) in reactions.iter_mut().enumerate() {
            *reaction *= f64::from(u8::from(self.delassus.get(row, row) > 0.0));
        }
        let undone: Vec<f64> = self.delassus.times(&reactions)?.iter().map(|rate| -rate).collect();
        let least = self.hold.solve(&self.delassus, &undone)?;
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let whole = product(&reactions, &reactions);
        let left = (whole - product(&reactions, &least)).abs();
        Ok(if whole > 0.0 { left / whole } else { 0.0 })
    }
}
