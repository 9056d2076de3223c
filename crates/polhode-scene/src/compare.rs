//! Comparing two trajectories.
//!
//! Two CSV trajectories with the same bodies at the same times (by text) are compared number by number: `|a - b| <=
//! atol + rtol max(|a|, |b|)`. A quaternion and its negative are the same rotation, so the sign of the second is chosen
//! to fit the first. Estimated errors are not compared: either file may have them. Files are read side by side, row by
//! row, whatever their size.

use crate::output::COLUMNS;
use crate::trajectory_rows::{FIRST_NUMBER, Row, RowError, Rows, Velocities};
use polhode::{BodyError, BodySample};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Where the quaternion stands among the numbers.
const QUATERNION: std::ops::Range<usize> = 3..7;

/// How much two numbers may differ.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tolerance {
    /// Absolute, in the unit of the column.
    pub absolute: f64,
    /// Relative to the larger of the two.
    pub relative: f64,
}

/// Why two files could not be compared.
#[derive(Debug, Error)]
pub enum CompareError {
    /// A file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file is not a trajectory.
    #[error("{}:{line}: not a trajectory: {reason}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: u64,
        /// What is wrong.
        reason: String,
    },
    /// A tolerance is negative or not a number.
    #[error("a tolerance is {0}: a number of at least 0 is needed")]
    Tolerance(f64),
}

impl From<RowError> for CompareError {
    fn from(error: RowError) -> Self {
        match error {
            RowError::Read { path, source } => Self::Read { path, source },
            RowError::Content { path, line, reason } => Self::Content { path, line, reason },
        }
    }
}

/// The outcome of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Rows compared.
    pub rows: u64,
    /// The first row in which bodies or times differ; comparing ends there.
    pub mismatch: Option<Mismatch>,
    /// One entry for each column of numbers.
    pub columns: Vec<ColumnDifference>,
}

/// A row in which the two files are not about the same thing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mismatch {
    /// Line in the first file, from 1.
    pub line: u64,
    /// What the first file has there: time and body, or nothing.
    pub a: Option<[String; 2]>,
    /// What the second file has there.
    pub b: Option<[String; 2]>,
}

/// The differences of a column.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnDifference {
    /// Name of the column.
    pub column: &'static str,
    /// Largest absolute difference; infinite where a number is NaN.
    pub largest: f64,
    /// Where it is, when there is any.
    pub at: Option<DifferencePlace>,
    /// Rows in which the difference is beyond the tolerance.
    pub beyond: u64,
}

/// Where a difference is.
#[derive(Debug, Clone, PartialEq)]
pub struct DifferencePlace {
    /// Time as it is written, s.
    pub t: String,
    /// Name of the body.
    pub body: String,
    /// Number in the first file.
    pub a: f64,
    /// Number in the second file.
    pub b: f64,
}

impl Comparison {
    /// Whether the two trajectories agree within the tolerance.
    pub fn agrees(&self) -> bool {
        self.mismatch.is_none() && self.columns.iter().all(|column| column.beyond == 0)
    }
}

/// Compares two CSV trajectories.
///
/// # Errors
/// When a file cannot be read or is not a trajectory, or a tolerance is negative.
pub fn compare(a: &Path, b: &Path, tolerance: Tolerance) -> Result<Comparison, CompareError> {
    compare_rows(a, b, tolerance, |_| ())
}

/// A row that both trajectories have.
#[derive(Debug)]
pub struct RowPair<'a> {
    /// Time, s; NaN where what is written is none.
    pub t_s: f64,
    /// Name of the body.
    pub body: &'a str,
    /// The body in both; none where numbers are no pose.
    pub samples: Option<[BodySample; 2]>,
    /// Its estimated errors in both; none where one of them is not known.
    pub errors: Option<[BodyError; 2]>,
}

/// Compares two CSV trajectories, and tells of every row that both have.
///
/// # Errors
/// As [`compare`](compare()).
pub fn compare_rows(
    a: &Path,
    b: &Path,
    tolerance: Tolerance,
    mut tell: impl FnMut(&RowPair<'_>),
) -> Result<Comparison, CompareError> {
    for value in [tolerance.absolute, tolerance.relative] {
        if value.is_nan() || value < 0.0 {
            return Err(CompareError::Tolerance(value));
        }
    }
    let (mut a, mut b) = (Rows::open(a, Velocities::Needed)?, Rows::open(b, Velocities::Needed)?);
    let column = |column| ColumnDifference { column, largest: 0.0, at: None, beyond: 0 };
    let mut comparison =
        Comparison { rows: 0, mismatch: None, columns: COLUMNS[FIRST_NUMBER..].iter().copied().map(column).collect() };
    loop {
        let (row_a, row_b) = (a.next()?, b.next()?);
        let (row_a, row_b) = match (row_a, row_b) {
            (None, None) => return Ok(comparison),
            (Some(row_a), Some(row_b)) if row_a.key == row_b.key => (row_a, row_b),
            (row_a, row_b) => {
                let (key_a, key_b) = (row_a.map(|row| row.key), row_b.map(|row| row.key));
                comparison.mismatch = Some(Mismatch { line: a.line(), a: key_a, b: key_b });
                return Ok(comparison);
            }
        };
        comparison.rows += 1;
        comparison.add(&row_a, &row_b, tolerance);
        let [time, body] = &row_a.key;
        let samples = row_a.body_sample().ok().zip(row_b.body_sample().ok()).map(|(a, b)| [a, b]);
        let errors = row_a.error.zip(row_b.error).map(|(a, b)| [a, b]);
        tell(&RowPair { t_s: time.parse().unwrap_or(f64::NAN), body, samples, errors });
    }
}

impl Comparison {
    fn add(&mut self, row_a: &Row, row_b: &Row, tolerance: Tolerance) {
        let dot: f64 = QUATERNION.map(|i| row_a.numbers[i] * row_b.numbers[i]).sum();
        for (i, column) in self.columns.iter_mut().enumerate() {
            let a = row_a.numbers[i];
            let is_opposite = QUATERNION.contains(&i) && dot < 0.0;
            let b = if is_opposite { -row_b.numbers[i] } else { row_b.numbers[i] };
            // Equal infinities do not differ; what is not a number differs from everything.
            let difference = if a == b { 0.0 } else { (a - b).abs() };
            let difference = if difference.is_nan() { f64::INFINITY } else { difference };
            if difference > tolerance.absolute + tolerance.relative * a.abs().max(b.abs()) || difference.is_infinite() {
                column.beyond += 1;
            }
            if difference > column.largest {
                let [t, body] = row_a.key.clone();
                column.largest = difference;
                column.at = Some(DifferencePlace { t, body, a, b });
            }
        }
    }
}
