//! A root between two points at which a function has opposite signs.
//!
//! Regula falsi with the Illinois weighting (superlinear where the function is smooth), with a bisection after every
//! step that has not halved the bracket, so that the number of evaluations is bounded. Source: docs/REFERENCES.md,
//! Dowell and Jarratt 1971.

/// A point and the function's value there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) at: f64,
    pub(crate) value: f64,
}

/// The last point found at which the value is not negative, or any point with a value within `tolerance` of zero,
/// between `left` (value >= 0) and `right` (value < 0). The function may fail; its error ends the search. Two steps
/// halve the bracket at least, so that no double is left between its ends after a few dozen.
pub(crate) fn last_not_negative<E>(
    mut left: Sample,
    mut right: Sample,
    tolerance: f64,
    mut function: impl FnMut(f64) -> Result<f64, E>,
) -> Result<Sample, E> {
    let (mut weight_left, mut weight_right) = (left.value, right.value);
    let mut bisect = false;
    loop {
        let middle = left.at + 0.5 * (right.at - left.at);
        let secant = left.at + (right.at - left.at) * (weight_left / (weight_left - weight_right));
        let at = if bisect || !(secant > left.at && secant < right.at) { middle } else { secant };
        if left.value <= tolerance || !(at > left.at && at < right.at) {
            return Ok(left);
        }
        let width = right.at - left.at;
        let value = function(at)?;
        if value.abs() <= tolerance {
            return Ok(Sample { at, value });
        }
        if value > 0.0 {
            left = Sample { at, value };
            weight_left = value;
            weight_right *= 0.5;
        } else {
            right = Sample { at, value };
            weight_right = value;
            weight_left *= 0.5;
        }
        bisect = right.at - left.at > 0.5 * width;
    }
}
