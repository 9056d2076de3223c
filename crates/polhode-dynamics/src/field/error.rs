//! Why numbers are no force field.

use thiserror::Error;

/// Why a field cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FieldError {
    /// A number is NaN or infinite.
    #[error("{quantity} of a force field must be finite, found {value}")]
    NotFinite {
        /// What was given.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A coefficient that must not be negative is: the force would create energy.
    #[error("{quantity} of a force field must be zero or positive, found {value}")]
    Negative {
        /// What was given.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Both ends are held by the same body, or both by the world.
    #[error("a spring or damper must join two different bodies, or a body and the world")]
    SameEnds,
    /// A table without points.
    #[error("a table of a signal needs at least one point (time in s, value)")]
    EmptyTable,
    /// The times of a table do not rise.
    #[error("times of a table must rise: point {index} has {t} s after {before} s")]
    TableOrder {
        /// Index of the point, from 0.
        index: usize,
        /// Its time, s.
        t: f64,
        /// The time of the point before, s.
        before: f64,
    },
}

/// `value`, when it is finite.
pub(super) fn finite(quantity: &'static str, value: f64) -> Result<f64, FieldError> {
    if value.is_finite() { Ok(value) } else { Err(FieldError::NotFinite { quantity, value }) }
}

/// `value`, when it is finite and not negative.
pub(super) fn not_negative(quantity: &'static str, value: f64) -> Result<f64, FieldError> {
    if finite(quantity, value)? >= 0.0 { Ok(value) } else { Err(FieldError::Negative { quantity, value }) }
}

/// `vector`, when its components are finite.
pub(super) fn finite_vector(quantity: &'static str, vector: glam::DVec3) -> Result<glam::DVec3, FieldError> {
    for component in vector.to_array() {
        finite(quantity, component)?;
    }
    Ok(vector)
}
