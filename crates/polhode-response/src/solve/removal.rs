//! Removal of drift: reactions whose response takes gaps or velocities out of rows that hold.
//!
//! The reactions are those of least norm, `G l = -values`. Contacts of a pile may be so nearly dependent that an exact
//! removal moves bodies by thousands of times their gaps: what would move them by more than is allowed, or by much for
//! next to nothing, is removed in part only.

use super::held::hold_beside;
use super::{matrix, way};
use crate::delassus::Delassus;
use crate::dense::kernels::largest;
use crate::error::ResponseError;
use crate::least_norm_hold::LeastNormHold;
use crate::problem::ContactProblem;
use std::ops::Range;

/// A removal of negligible values that changes bodies by more than this many times the largest of them (no unit) must
/// be effective, or it is partial too: a buckled row of bodies between walls that is too long by a rounding error would
/// straighten a little at every step without becoming shorter.
const MODERATE_AMPLIFICATION: f64 = 1e3;

/// An effective removal leaves at most this fraction of the largest value (no unit).
const EFFECTIVE_REMAINDER: f64 = 0.1;

/// How values may be removed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The largest change of a point of a body, m or m/s.
    pub allowed: f64,
    /// Values below it are not worth a large change, m or m/s.
    pub negligible: f64,
    /// How far rows are open in relation to the size of their bodies (no unit).
    pub opened: f64,
}

/// Reactions that remove values.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Removed {
    /// One for each row.
    pub reactions: Vec<f64>,
    /// Whether they remove only a part.
    pub is_partial: bool,
}

/// Removes `values` from rows, those of `joints` beside their trees where they are many. `change_of` gives the largest
/// change of a point of a body (m, m/s) from the response of the bodies.
///
/// # Errors
/// When a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn remove(
    (rows, joints): (&ContactProblem, Range<usize>),
    values: &[f64],
    limits: Limits,
    change_of: impl Fn(&[f64]) -> f64,
) -> Result<Removed, ResponseError> {
    let change_by = |reactions: &[f64]| Ok::<_, ResponseError>(change_of(&rows.response(reactions)?));
    if let Some(forest) = way::trees(rows, joints) {
        let found = hold_beside(rows, &forest, values, limits.opened)?;
        let is_effective = largest(&found.rates) <= EFFECTIVE_REMAINDER * largest(values);
        if is_effective && change_by(&found.forces)? <= limits.allowed {
            return Ok(Removed { reactions: found.forces, is_partial: false });
        }
    }
    let Limits { allowed, negligible, opened } = limits;
    let delassus = matrix::of(rows)?;
    let reactions = LeastNormHold::factor_open(&delassus, opened)?.solve(&delassus, values)?;
    let change = change_by(&reactions)?;
    let is_moderate = largest(values) > negligible || change <= MODERATE_AMPLIFICATION * largest(values);
    if change <= allowed && (is_moderate || is_effective(&delassus, &reactions, values)?) {
        return Ok(Removed { reactions, is_partial: false });
    }
    let mut reactions = LeastNormHold::factor_softly(&delassus)?.solve(&delassus, values)?;
    let change = change_by(&reactions)?;
    if change > allowed {
        for reaction in &mut reactions {
            *reaction *= allowed / change;
        }
    }
    Ok(Removed { reactions, is_partial: true })
}

/// Whether reactions leave little of the values.
fn is_effective(delassus: &Delassus, reactions: &[f64], values: &[f64]) -> Result<bool, ResponseError> {
    let left: Vec<f64> = delassus.times(reactions)?.iter().zip(values).map(|(given, value)| given + value).collect();
    Ok(largest(&left) <= EFFECTIVE_REMAINDER * largest(values))
}
