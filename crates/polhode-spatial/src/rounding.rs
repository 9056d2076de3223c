//! What rounding and the digits of files leave, relative to the numbers it is left on.
//!
//! A result that cancels to less than the rounding of its terms is zero. How much that is follows from how many
//! operations have made it, and not from what it means: these are the sizes that all crates take. A relation of
//! numbers that are read from a file holds to the digits with which they are written.

/// The rounding of a result of a few operations, relative to the sum of the sizes of its terms (no unit).
pub const FEW_TERMS: f64 = 8.0 * f64::EPSILON;

/// The rounding of a result of a dozen operations, likewise.
pub const DOZEN_TERMS: f64 = 16.0 * f64::EPSILON;

/// The rounding of a result of some dozen operations, likewise. A bound is enlarged by this part of it for the
/// rounding of its own evaluation, so that it is never too small.
pub const DOZENS_OF_TERMS: f64 = 64.0 * f64::EPSILON;

/// The rounding of a result of some hundred operations, likewise.
pub const HUNDREDS_OF_TERMS: f64 = 1e-13;

/// About the square root of the rounding unit (no unit): below it the square of a number is lost beside 1, and half of
/// the digits are gone of a difference that is this small.
pub const HALF_OF_THE_DIGITS: f64 = 1e-8;

/// How far numbers of a file may miss a relation that they should obey, relative to their size (no unit): they are
/// written with ten digits. It is far above rounding, and far below what anyone sees of a motion.
pub const DIGITS_OF_A_FILE: f64 = 1e-9;
