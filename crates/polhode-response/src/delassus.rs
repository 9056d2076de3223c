//! The Delassus matrix `G = J M^-1 J^T`: how a unit force at one contact accelerates every contact.
//!
//! The thesis calls it `M_ij` (equation 18). It is symmetric and positive semidefinite, in general rank-deficient
//! (errata E13: the five-diamond has 82 rows and rank 50). Entries have the unit of inverse mass, 1/kg.
//!
//! Rows that are held and soft (`u = -c r`) add their compliance `c` to the diagonal, so that `G r + b = 0` says what
//! they ask for.
//!
//! Only pairs of rows that share a body are formed. The matrix is exactly symmetric, and an entry is the mean of
//! `J_i (M^-1 J_j)` and `J_j (M^-1 J_i)`, so that its bits depend neither on the order of the rows nor on which of
//! two mirror images is described.

use crate::dense::kernels::axpy;
use crate::dense::semidefinite::{Defect, find_defect};
use crate::error::{ResponseError, check_finite, check_length};
use crate::problem::{ContactProblem, RowEntry};
use crate::solve::way::IMPACT_IN_BODIES;
use crate::tolerances::MATRIX_ROUNDING;
use std::sync::Arc;

/// A dense, exactly symmetric Delassus matrix.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Delassus {
    size: usize,
    entries: Vec<f64>,
    not_finite: Option<usize>,
    /// The rows that it was formed of, where they are many.
    rows: Option<Arc<ContactProblem>>,
    /// The rows that it was formed of, however few.
    #[cfg(feature = "census")]
    origin: Option<Arc<ContactProblem>>,
}

impl Delassus {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.size
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.size == 0
    }

    /// The entry of `row` and `column`; 0 outside the matrix.
    pub fn get(&self, row: usize, column: usize) -> f64 {
        if row < self.size && column < self.size { self.entries[row * self.size + column] } else { 0.0 }
    }

    /// Row `row`, which is also column `row`; empty outside the matrix.
    pub fn row(&self, row: usize) -> &[f64] {
        if row < self.size { &self.entries[row * self.size..(row + 1) * self.size] } else { &[] }
    }

    /// `G f`.
    ///
    /// # Errors
    /// When `forces` has not one number for each row.
    pub fn times(&self, forces: &[f64]) -> Result<Vec<f64>, ResponseError> {
        check_length("forces", self.size, forces.len())?;
        let mut product = vec![0.0; self.size];
        for (row, &force) in forces.iter().enumerate() {
            if force != 0.0 {
                axpy(force, self.row(row), &mut product);
            }
        }
        Ok(product)
    }

    /// The matrix of these entries, row-major and symmetric.
    pub(crate) fn from_entries(size: usize, entries: Vec<f64>) -> Self {
        let not_finite = entries.iter().position(|entry| !entry.is_finite());
        Self { size, entries, not_finite, ..Self::default() }
    }

    /// The rows that it was formed of; none where they are few.
    pub(crate) fn rows(&self) -> Option<&Arc<ContactProblem>> {
        self.rows.as_ref()
    }

    /// The rows that it was formed of, however few.
    #[cfg(feature = "census")]
    pub(crate) fn origin(&self) -> Option<&Arc<ContactProblem>> {
        self.origin.as_ref()
    }

    /// All entries, row-major.
    pub(crate) fn entries(&self) -> &[f64] {
        &self.entries
    }

    /// Refuses a matrix with an entry that overflowed.
    pub(crate) fn check_finite(&self) -> Result<(), ResponseError> {
        self.not_finite.map_or(Ok(()), |index| Err(ResponseError::NotFinite { what: "Delassus matrix", index }))
    }
}

/// Checks that entries, row-major, are a Delassus matrix: symmetric and positive semidefinite to rounding, of any rank.
/// Solvers take the symmetry of a matrix that they are given for granted, and what they find for an indefinite one
/// means nothing.
///
/// ```
/// use polhode_response::check_delassus;
/// // Two contacts of one body of 2 kg on a line.
/// check_delassus(2, &[0.5, 0.5, 0.5, 0.5])?;
/// assert!(check_delassus(2, &[0.5, 0.6, 0.6, 0.5]).is_err());
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// # Errors
/// When the length is not `size^2`, or an entry is not finite, differs from its mirror image, or gives a negative
/// energy.
pub fn check_delassus(size: usize, entries: &[f64]) -> Result<(), ResponseError> {
    check_length("Delassus matrix", size.saturating_mul(size), entries.len())?;
    check_finite("Delassus matrix", entries)?;
    match find_defect(entries, size, MATRIX_ROUNDING) {
        None => Ok(()),
        Some(Defect::Asymmetric { row, column }) => {
            let (value, other) = (entries[row * size + column], entries[column * size + row]);
            Err(ResponseError::Asymmetric { row, column, value, other })
        }
        Some(Defect::Indefinite { row, part }) => Err(ResponseError::Indefinite { row, part, limit: MATRIX_ROUNDING }),
    }
}

impl ContactProblem {
    /// The Delassus matrix of all rows.
    pub fn delassus(&self) -> Delassus {
        let mut delassus = Delassus::default();
        self.delassus_into(&mut delassus);
        delassus
    }

    /// The Delassus matrix of all rows, in memory that is used again.
    pub fn delassus_into(&self, delassus: &mut Delassus) {
        let size = self.len();
        delassus.size = size;
        let is_rigid = self.compliances().is_empty();
        let is_kept = is_rigid && size >= IMPACT_IN_BODIES && !self.bilateral_rows(None).is_empty();
        delassus.rows = is_kept.then(|| Arc::new(self.clone()));
        #[cfg(feature = "census")]
        {
            delassus.origin = Some(Arc::new(self.clone()));
        }
        delassus.entries.clear();
        delassus.entries.resize(size * size, 0.0);
        // All (body, row, slot), sorted by body: rows of one body stand together, in the order of the rows.
        let mut touches: Vec<(usize, usize, usize)> = (0..size)
            .flat_map(|row| (0..self.touched(row)).map(move |slot| (self.entry(row, slot).body, row, slot)))
            .collect();
        touches.sort_unstable();
        for group in touches.chunk_by(|a, b| a.0 == b.0) {
            for (position, &(_, row, slot)) in group.iter().enumerate() {
                let a = self.entry(row, slot);
                for &(_, other_row, other_slot) in &group[position..] {
                    let b = self.entry(other_row, other_slot);
                    let value = symmetric_product(a, b);
                    delassus.entries[row * size + other_row] += value;
                }
            }
        }
        for &(row, compliance) in self.compliances() {
            delassus.entries[row * size + row] += compliance;
        }
        for row in 0..size {
            for column in 0..row {
                delassus.entries[row * size + column] = delassus.entries[column * size + row];
            }
        }
        delassus.not_finite = delassus.entries.iter().position(|entry| !entry.is_finite());
    }
}

/// The mean of `J_a (M^-1 J_b)` and `J_b (M^-1 J_a)`.
fn symmetric_product(a: RowEntry<'_>, b: RowEntry<'_>) -> f64 {
    // Sums of known length are unrolled.
    let fixed = match a.jacobian.len() {
        3 => fixed_product::<3>(a, b),
        6 => fixed_product::<6>(a, b),
        _ => None,
    };
    fixed.unwrap_or_else(|| mean_product([a.jacobian, b.response], [b.jacobian, a.response]))
}

/// The same of rows of this many numbers.
fn fixed_product<const N: usize>(a: RowEntry<'_>, b: RowEntry<'_>) -> Option<f64> {
    let [a_jacobian, b_response] = [a.jacobian.first_chunk::<N>()?, b.response.first_chunk::<N>()?];
    let [b_jacobian, a_response] = [b.jacobian.first_chunk::<N>()?, a.response.first_chunk::<N>()?];
    Some(mean_product([a_jacobian, b_response], [b_jacobian, a_response]))
}

/// The mean of two products of vectors: plain sums side by side, as rows are too short for more.
#[inline]
fn mean_product<T: AsRef<[f64]>>([a, b]: [T; 2], [c, d]: [T; 2]) -> f64 {
    let (mut one, mut other) = (0.0, 0.0);
    let lines = a.as_ref().iter().zip(b.as_ref()).zip(c.as_ref().iter().zip(d.as_ref()));
    for ((a, b), (c, d)) in lines {
        one += a * b;
        other += c * d;
    }
    0.5 * (one + other)
}
