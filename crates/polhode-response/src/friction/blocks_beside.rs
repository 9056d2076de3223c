//! Blocks of contacts of bodies in trees of joints: those of the rows that are left when the trees have been
//! eliminated, and the answer for all rows from theirs.
//!
//! Held blocks lose the rows of the trees. Assumption: rows of trees are in held blocks, and are not scaled.

use crate::certificate::nan_max;
use crate::error::ResponseError;
use crate::friction::blocks::{Blocks, BlocksSolution};
use crate::friction::linearisation::ContactStatus;
use crate::law::Law;
use crate::problem::ContactProblem;
use crate::sparse::HeldForest;

impl Blocks {
    /// The blocks of the rows beside trees, by their places among them.
    pub fn beside(&self, forest: &HeldForest) -> Self {
        let mut beside = Self::default();
        let scales: Vec<f64> = self.scales().collect();
        let is_scaled = scales.iter().any(|scale| *scale != 1.0);
        let mut first = 0;
        for law in self.laws() {
            let own = first..first + law.rows();
            first = own.end;
            let left = |(&row, &scale): (&usize, &f64)| Some((forest.others().binary_search(&row).ok()?, scale));
            let (rows, scales): (Vec<usize>, Vec<f64>) =
                self.rows()[own.clone()].iter().zip(&scales[own]).filter_map(left).unzip();
            let law = if let Law::Hold { .. } = law { Law::Hold { rows: rows.len() } } else { *law };
            if rows.len() != law.rows() || rows.is_empty() {
                continue;
            }
            if is_scaled {
                beside.push_scaled(law, rows, scales);
            } else {
                beside.push(law, rows);
            }
        }
        beside
    }

    /// The answer for all rows from that for the blocks [`beside`](Self::beside) the trees; `constants` are of all
    /// rows.
    ///
    /// # Errors
    /// Those of [`HeldForest::with_others`].
    #[cfg_attr(feature = "census", track_caller)]
    pub fn with_forest(
        &self,
        (problem, forest): (&ContactProblem, &HeldForest),
        constants: &[f64],
        beside: &BlocksSolution,
    ) -> Result<BlocksSolution, ResponseError> {
        let of_others = |place: usize| beside.reactions.get(place).copied().unwrap_or_default();
        let of_others: Vec<f64> = (0..forest.others().len()).map(of_others).collect();
        let found = forest.with_others(problem, constants, &of_others)?;
        let mut velocities = vec![0.0; problem.len()];
        for (&row, &velocity) in forest.others().iter().zip(&beside.velocities) {
            velocities[row] = velocity;
        }
        let (mut statuses, mut parts) = (Vec::with_capacity(self.len()), Vec::with_capacity(self.len()));
        let (mut first, mut next) = (0, 0);
        for law in self.laws() {
            let own = &self.rows()[first..first + law.rows()];
            first += law.rows();
            if own.iter().any(|row| forest.others().binary_search(row).is_ok()) {
                statuses.push(beside.statuses[next]);
                parts.push(beside.parts[next]);
                next += 1;
            } else {
                statuses.push(ContactStatus::Stick);
                parts.push([ContactStatus::Stick, ContactStatus::Open, ContactStatus::Open]);
            }
        }
        let mut report = beside.report;
        report.residual = nan_max(report.residual, found.residual);
        Ok(BlocksSolution { reactions: found.forces, velocities, statuses, parts, report })
    }
}
