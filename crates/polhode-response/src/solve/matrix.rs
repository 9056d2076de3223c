//! The matrix of all rows, refused where there are too many.

use super::way::{MATRIX_MOST_ROWS, have_no_matrix};
use crate::delassus::Delassus;
use crate::error::ResponseError;
use crate::problem::ContactProblem;

/// The matrix of all rows.
///
/// # Errors
/// When they are too many.
pub(super) fn of(rows: &ContactProblem) -> Result<Delassus, ResponseError> {
    let mut delassus = Delassus::default();
    fill(&mut delassus, rows)?;
    Ok(delassus)
}

/// The same in memory that is used again.
///
/// # Errors
/// When they are too many.
pub(super) fn fill(delassus: &mut Delassus, rows: &ContactProblem) -> Result<(), ResponseError> {
    if have_no_matrix(rows.len()) {
        return Err(ResponseError::TooManyRows { rows: rows.len(), limit: MATRIX_MOST_ROWS });
    }
    rows.delassus_into(delassus);
    Ok(())
}
