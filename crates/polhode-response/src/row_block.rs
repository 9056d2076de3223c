//! Row blocks: what the rows of one constraint ask for together.
//!
//! | block | rows | asks for |
//! |---|---|---|
//! | [`RowBlock::Unilateral`] | 1 | `0 <= f _\|_ w >= 0`: a contact pushes |
//! | [`RowBlock::Bilateral`] | any | `w = 0`, forces of either sign: a pivot, a joint |
//! | [`RowBlock::Cone`] | 3 | normal and tangential forces with `\|f_t\| <= mu f_n`: a contact with Coulomb friction |
//!
//! A block is what a constraint hands over; the problem holds its rows. Of a cone with `mu = 0` all that is left is the normal
//! row, and that is solved. Friction above zero is not available: it is refused, not left out.

use crate::error::ResponseError;
use crate::problem::ContactProblem;
use std::ops::Range;

/// Rows of a cone: the normal and two tangential directions.
const CONE_ROWS: usize = 3;

/// One row: the bodies that it touches and their Jacobian blocks, as [`ContactProblem::push_row`] takes them.
pub type RowEntries<'a> = [(usize, &'a [f64])];

/// What the rows of one constraint ask for together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RowBlock {
    /// One row that pushes: `0 <= f _|_ w >= 0`.
    Unilateral,
    /// Rows that hold with forces of either sign: `w = 0`.
    Bilateral,
    /// A normal row and two tangential ones, orthogonal to it and to each other, in the order normal, first, second tangent:
    /// `|f_t| <= friction f_n` (Coulomb).
    Cone {
        /// Coefficient of friction (dimensionless, at least 0).
        friction: f64,
    },
}

impl RowBlock {
    /// How many rows the block has; none says that any number is right.
    pub const fn rows(self) -> Option<usize> {
        match self {
            Self::Unilateral => Some(1),
            Self::Bilateral => None,
            Self::Cone { .. } => Some(CONE_ROWS),
        }
    }
}

impl ContactProblem {
    /// Adds the rows of a constraint; returns the rows of the problem that stand for them, in the same order. A cone without
    /// friction has its normal row alone.
    ///
    /// ```
    /// use polhode_response::{ContactProblem, RowBlock};
    /// // A bead of 0.5 kg that a hole holds in the plane.
    /// let mut problem = ContactProblem::new(2, vec![2.0, 0.0, 0.0, 2.0])?;
    /// let rows = problem.push_block(RowBlock::Bilateral, &[&[(0, &[1.0, 0.0])], &[(0, &[0.0, 1.0])]])?;
    /// assert_eq!(rows, 0..2);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`ContactProblem::push_row`]; when the block has another number of rows; when friction is negative or not
    /// finite ([`ResponseError::Setting`]), or above zero ([`ResponseError::FrictionNotAvailable`]). No row is added then.
    pub fn push_block(&mut self, block: RowBlock, rows: &[&RowEntries<'_>]) -> Result<Range<usize>, ResponseError> {
        if let Some(expected) = block.rows().filter(|&expected| expected != rows.len()) {
            return Err(ResponseError::BlockRows { expected, found: rows.len() });
        }
        let first = self.len();
        match block {
            RowBlock::Unilateral => rows.iter().try_for_each(|row| self.push_row(row).map(|_| ())),
            RowBlock::Bilateral => rows.iter().try_for_each(|row| self.push_bilateral_row(row).map(|_| ())),
            RowBlock::Cone { friction } => {
                if !(friction >= 0.0 && friction.is_finite()) {
                    let (field, accepted) = ("friction", "at least 0 and finite");
                    return Err(ResponseError::Setting { field, accepted, value: friction });
                }
                if friction > 0.0 {
                    return Err(ResponseError::FrictionNotAvailable { friction });
                }
                rows.iter().take(1).try_for_each(|row| self.push_row(row).map(|_| ()))
            }
        }
        .inspect_err(|_| self.truncate_rows(first))?;
        Ok(first..self.len())
    }
}
