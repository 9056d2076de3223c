//! Whether a row depends on the rows that carry force.
//!
//! With `d = -G_PP^-1 G_Pj` and `z = (d, 1)`, row `j` depends on the set `P` when `J^T z = 0`. Its distance from `P` is
//! `|M^-1/2 J^T z|`, to be compared with the terms that cancel in it, `sum_i |z_i| sqrt(G_ii)`. The Schur complement is
//! the square of the distance, so in working precision it tells distances apart only down to 1e-7 or so; the sum
//! `J^T z` itself does down to 1e-15, once `d` has been corrected with the motion that it leaves over.
//!
//! Source: corrected semi-normal equations, Björck 1987. Failure: where a row is neither clearly independent nor
//! dependent the answer is [`Dependence::Doubtful`], and twice the precision has to decide.

use crate::dense::kernels::{axpy, dot};
use crate::problem::ContactProblem;

/// A distance whose square, relative to that of the terms, is above this fraction is found from the Schur complement
/// in working precision (no unit): there forces are good to 1e-16 / 1e-9 before they are refined.
pub(crate) const SAFE_PIVOT: f64 = 1e-9;

/// How ranks are decided.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Rank<'a> {
    /// By the Schur complement alone: independent above this fraction of the square of the terms (no unit).
    Pivot(f64),
    /// By the motion of the bodies.
    Motion(Motion<'a>),
}

/// What is known of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dependence {
    Independent,
    Dependent,
    Doubtful,
}

/// The rows of a problem, and the distance below which a row is dependent.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Motion<'a> {
    pub(crate) problem: &'a ContactProblem,
    /// Which rows of the problem; all when `None`.
    pub(crate) rows: Option<&'a [usize]>,
    /// Relative to the terms (no unit).
    pub(crate) cut: f64,
}

/// `J^T z` and `M^-1 J^T z` of all bodies.
#[derive(Debug, Clone, Default)]
pub(crate) struct Image {
    moment: Vec<f64>,
    response: Vec<f64>,
}

impl Motion<'_> {
    /// Puts the motion of the forces into `image` and returns `|M^-1/2 J^T z|`.
    pub(crate) fn distance(&self, forces: impl Iterator<Item = (usize, f64)>, image: &mut Image) -> f64 {
        let width = self.problem.width();
        for numbers in [&mut image.moment, &mut image.response] {
            numbers.clear();
            numbers.resize(width * self.problem.bodies(), 0.0);
        }
        for (row, force) in forces {
            for entry in self.problem.entries(self.index(row)) {
                let block = entry.body * width..(entry.body + 1) * width;
                axpy(force, entry.jacobian, &mut image.moment[block.clone()]);
                axpy(force, entry.response, &mut image.response[block]);
            }
        }
        dot(&image.moment, &image.response).max(0.0).sqrt()
    }

    /// `J_i M^-1 J^T z`.
    pub(crate) fn acceleration(&self, row: usize, image: &Image) -> f64 {
        let width = self.problem.width();
        let share = |entry: crate::problem::RowEntry<'_>| {
            dot(entry.jacobian, &image.response[entry.body * width..(entry.body + 1) * width])
        };
        self.problem.entries(self.index(row)).map(share).sum()
    }

    fn index(&self, row: usize) -> usize {
        self.rows.map_or(row, |rows| rows[row])
    }
}
