//! The frictional contact problem: `u = G r + q`, and Coulomb's law or a hold for each block of rows.
//!
//! `G` is the Delassus operator (1/kg), `q` the velocities (accelerations) without reactions, `r` the impulses
//! (forces). Source: Acary and Brogliato 2008, chapter 13; thesis, section 4 (where it stops). Assumption: the rows of
//! a contact have one unit, so that their speeds can be compared. Failure: data out of range is refused with a
//! [`ResponseError`].

use crate::certificate::nan_max;
use crate::dense::kernels::largest;
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::block_matrix::BlockMatrix;
use crate::friction::coulomb_cone::natural_map;
use crate::friction::rows_behind::RowsBehind;
use crate::law::{Law, MOST_ROWS};
use crate::tolerances::EXACT_ENOUGH;
use crate::tolerances::IMMOVABLE;
use std::ops::Range;

/// Rounding error of a sum of terms, in units in the last place of the sum of their magnitudes (4 to 64).
const ROUNDING_UNITS: f64 = 8.0;

/// A frictional contact problem.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionProblem {
    matrix: BlockMatrix,
    constant: Vec<f64>,
    blocks: Vec<Law>,
    /// `1 / rho` of each block.
    inverse_masses: Vec<f64>,
    /// The rows of the bodies behind it, where they are known and many.
    rows_behind: Option<RowsBehind>,
    /// The same, however few.
    #[cfg(feature = "census")]
    origin: Option<RowsBehind>,
}

impl FrictionProblem {
    /// A problem with a dense `G`, row-major.
    ///
    /// ```
    /// use polhode_response::Law;
    /// use polhode_response::friction::FrictionProblem;
    /// // A point of 2 kg on a floor of friction 0.5, pushed down with 3 m/s and along with 1 m/s.
    /// let contact = Law::Cone { rows: 3, friction: 0.5 };
    /// let matrix = [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5];
    /// let problem = FrictionProblem::from_dense(vec![contact], &matrix, vec![-3.0, 1.0, 0.0])?;
    /// assert_eq!(problem.rows(), 3);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`new`](Self::new) and [`BlockMatrix::from_dense`].
    pub fn from_dense(blocks: Vec<Law>, matrix: &[f64], constant: Vec<f64>) -> Result<Self, ResponseError> {
        check_blocks(&blocks)?;
        let sizes: Vec<usize> = blocks.iter().map(|block| block.rows()).collect();
        Self::new(blocks, BlockMatrix::from_dense(&sizes, matrix)?, constant)
    }

    /// A problem with a `G` in blocks, one block row for each of `blocks`.
    ///
    /// # Errors
    /// When a coefficient of friction is negative or not finite, a block has too few or too many rows, lengths differ,
    /// or a number is not finite.
    pub fn new(blocks: Vec<Law>, matrix: BlockMatrix, constant: Vec<f64>) -> Result<Self, ResponseError> {
        check_blocks(&blocks)?;
        check_length("blocks of the Delassus matrix", blocks.len(), matrix.len())?;
        for (index, block) in blocks.iter().enumerate() {
            check_length("rows of a block of the Delassus matrix", block.rows(), matrix.size(index))?;
        }
        check_length("constant terms", matrix.rows(), constant.len())?;
        check_finite("constant terms", &constant)?;
        let trace = |block| (0..matrix.size(block)).map(|row| matrix.diagonal_entry(block, row)).fold(0.0, f64::max);
        let most = (0..matrix.len()).map(trace).fold(0.0, f64::max);
        let least = if most > 0.0 { IMMOVABLE * most } else { 1.0 };
        let inverse_mass = |block| {
            let normal = matrix.diagonal_entry(block, 0);
            if normal > 0.0 { normal } else { least }
        };
        let inverse_masses = (0..matrix.len()).map(inverse_mass).collect();
        Ok(Self {
            matrix,
            constant,
            blocks,
            inverse_masses,
            rows_behind: None,
            #[cfg(feature = "census")]
            origin: None,
        })
    }

    /// The same problem, the rows of whose bodies are known.
    pub(crate) fn with_rows(self, rows: Option<RowsBehind>) -> Self {
        Self { rows_behind: rows, ..self }
    }

    /// The same problem, that knows where it comes from.
    #[cfg(feature = "census")]
    pub(crate) fn with_origin(self, origin: Option<RowsBehind>) -> Self {
        Self { origin, ..self }
    }

    /// The rows of bodies that it comes from.
    #[cfg(feature = "census")]
    pub(crate) fn origin(&self) -> Option<&RowsBehind> {
        self.origin.as_ref()
    }

    /// The rows of the bodies behind it.
    pub(crate) fn rows_behind(&self) -> Option<&RowsBehind> {
        self.rows_behind.as_ref()
    }

    /// Number of blocks.
    pub fn len(&self) -> usize {
        self.blocks.len()
    }

    /// Whether there is no block.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// Number of rows of all blocks.
    pub fn rows(&self) -> usize {
        self.matrix.rows()
    }

    /// The blocks.
    pub fn blocks(&self) -> &[Law] {
        &self.blocks
    }

    /// `G`.
    pub fn matrix(&self) -> &BlockMatrix {
        &self.matrix
    }

    /// `q`.
    pub fn constant(&self) -> &[f64] {
        &self.constant
    }

    /// The rows of a block; empty when it does not exist.
    pub fn range(&self, block: usize) -> Range<usize> {
        if block < self.len() { self.matrix.range(block) } else { 0..0 }
    }

    /// `u = G r + q`.
    ///
    /// # Errors
    /// When `reactions` has not one number for each row.
    pub fn velocities(&self, reactions: &[f64]) -> Result<Vec<f64>, ResponseError> {
        check_length("reactions", self.rows(), reactions.len())?;
        let mut velocities = Vec::new();
        self.matrix.times_plus(reactions, &self.constant, &mut velocities);
        Ok(velocities)
    }

    /// The residual of any reactions: the largest over all blocks of the natural map with De Saxce's correction, in
    /// units of velocity, relative to the largest velocity without reactions:
    ///
    /// `max_i |r_i - P_K(r_i - rho_i u'_i)| / (rho_i max_k |q_k|)`, `rho_i = 1 / G_nn,i`, `u' = u + mu |u_t| n`,
    ///
    /// and `|u_i| / max_k |q_k|` for rows that are held. No unit; the same when units of mass, length or time change.
    /// Zero where all `q` are zero and the reactions as well.
    ///
    /// # Errors
    /// When `reactions` has not one number for each row.
    pub fn residual(&self, reactions: &[f64]) -> Result<f64, ResponseError> {
        let velocities = self.velocities(reactions)?;
        Ok(self.residual_of(reactions, &velocities))
    }

    /// [`residual`](Self::residual) where `u` is known.
    pub(crate) fn residual_of(&self, reactions: &[f64], velocities: &[f64]) -> f64 {
        let size = largest(&self.constant);
        let most = (0..self.len()).map(|block| self.block_residual(block, reactions, velocities)).fold(0.0, nan_max);
        if most == 0.0 { 0.0 } else { most / size }
    }

    /// The largest residual that is ever taken for rounding.
    pub(crate) fn largest_rounding(&self) -> f64 {
        let friction = self.blocks.iter().filter_map(|block| block.friction()).fold(0.0, f64::max);
        (1.0 + friction) * EXACT_ENOUGH
    }

    /// What rounding of `G r + q` alone leaves of the residual of such reactions: large ones that cancel leave more,
    /// and the correction of De Saxce multiplies what is left of a slip by the coefficient of friction.
    pub(crate) fn rounding_of(&self, reactions: &[f64]) -> f64 {
        let size = largest(&self.constant);
        let terms = |row: usize| {
            let mut sums = [0.0; MOST_ROWS];
            for block in self.matrix.blocks(row) {
                let own = &reactions[self.matrix.range(block.column)];
                for (sum, line) in sums.iter_mut().zip(block.values.chunks_exact(own.len().max(1))) {
                    *sum += line.iter().zip(own).map(|(g, r)| (g * r).abs()).sum::<f64>();
                }
            }
            largest(&sums)
        };
        if size == 0.0 {
            return 0.0;
        }
        let rounding = |block: usize| {
            let friction = self.blocks[block].friction().unwrap_or(0.0);
            let plain = ROUNDING_UNITS * f64::EPSILON * terms(block).max(size) / size;
            (1.0 + friction) * plain.min(EXACT_ENOUGH)
        };
        (0..self.len()).map(rounding).fold(0.0, f64::max)
    }

    /// The natural map of one block, in units of velocity.
    pub(crate) fn block_residual(&self, block: usize, reactions: &[f64], velocities: &[f64]) -> f64 {
        let range = self.matrix.range(block);
        let (r, u) = (&reactions[range.clone()], &velocities[range]);
        natural_map(self.blocks[block], self.inverse_masses[block], r, u)
    }

    /// Mean of the diagonal over rows of a block. It does not depend on where in their plane two tangents lie.
    pub(crate) fn mean_inverse_mass(&self, block: usize, rows: Range<usize>) -> f64 {
        let count = rows.len().max(1) as f64;
        rows.map(|row| self.matrix.diagonal_entry(block, row)).sum::<f64>() / count
    }

    /// The same problem where each row yields, by this share of its inverse mass, to what its reaction exceeds that of
    /// `around`; rows of one part of a block alike.
    pub(crate) fn yielding(&self, share: f64, around: &[f64]) -> Self {
        let of_row = |block: usize, row: usize| {
            let law = self.blocks[block];
            let part = law.parts().into_iter().map(|(rows, _)| rows).find(|rows| rows.contains(&row));
            let whole = if law.friction().is_some() { 0..1 } else { 0..law.rows() };
            share * self.mean_inverse_mass(block, part.unwrap_or(whole))
        };
        let mut constant = self.constant.clone();
        for block in 0..self.len() {
            for (place, row) in self.range(block).enumerate() {
                constant[row] -= of_row(block, place) * around[row];
            }
        }
        Self { matrix: self.matrix.with_diagonal(of_row), constant, rows_behind: None, ..self.clone() }
    }

    /// `1 / rho` of a block.
    pub(crate) fn inverse_mass(&self, block: usize) -> f64 {
        self.inverse_masses[block]
    }
}

fn check_blocks(blocks: &[Law]) -> Result<(), ResponseError> {
    blocks.iter().enumerate().try_for_each(|(index, block)| block.check(index))
}
