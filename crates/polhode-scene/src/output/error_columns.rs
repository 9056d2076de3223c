//! The columns of a trajectory that hold the estimated errors of the bodies.

use polhode::BodyError;

/// The columns: how far a body's origin may be from where it should be (m), and its attitude (rad).
pub const ERROR_COLUMNS: [&str; 2] = ["error_m", "error_rad"];

/// Whether a file has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ErrorColumns {
    /// The errors of the run are not estimated.
    Absent,
    /// They are; where one is not known, a field is empty, null or not a number.
    Written,
}

impl ErrorColumns {
    /// The names of those that the file has.
    pub(crate) const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Absent => &[],
            Self::Written => &ERROR_COLUMNS,
        }
    }

    /// Their numbers for a body of a sample with these errors; not a number where they are not known.
    pub(super) fn numbers(self, errors: Option<&[BodyError]>, body: usize) -> impl Iterator<Item = f64> {
        let unknown = BodyError::new(f64::NAN, f64::NAN);
        let error = errors.and_then(|errors| errors.get(body)).copied().unwrap_or(unknown);
        [error.position_m, error.rotation_rad].into_iter().take(self.names().len())
    }
}
