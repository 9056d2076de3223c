//! Event location: the time within a step at which the state of a constraint changes.
//!
//! Each time in a step is on one of two sides of an event: before it or after it. The side follows from a signed event
//! function of a constraint ([`crate::constraint`]: positive before, not positive after) or from a test of many
//! constraints together. The bracket of the event is bisected on the interpolated states within the step until it is
//! 2^-44 (some 5e-14) of its initial length, or its ends are adjacent numbers.
//!
//! Assumption: one change of side in the bracket; of several, one is found. Bisection needs no smoothness: contact
//! forces have corners where contacts break, and a test without a value cannot be interpolated. Errors are those of the
//! evaluation of the side. Impacts of separate bodies are found by bounds that miss none (`polhode-contact`). Events of
//! free motion that a user of `polhode-dynamics` defines are found there, by a secant method (Oliveira and Takahashi
//! 2021).

/// Halvings of a bracket: 2^-44 is below 1e-13.
const HALVINGS: usize = 44;

/// On which side of an event a time lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Before,
    After,
    /// Close enough: the search ends.
    Here,
}

impl Side {
    /// By a signed event function.
    pub(crate) fn of(value: f64) -> Self {
        if value > 0.0 { Self::Before } else { Self::After }
    }
}

/// The final bracket, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bracket {
    /// The last time known to be before the event.
    pub(crate) before: f64,
    /// The first time known to be after it.
    pub(crate) after: f64,
    /// A time that was close enough.
    pub(crate) here: Option<f64>,
}

/// Narrows the bracket of an event between two times at which the sides are known.
///
/// # Errors
/// Those of `side`.
pub(crate) fn close_in<E>(
    (before, after): (f64, f64),
    mut side: impl FnMut(f64) -> Result<Side, E>,
) -> Result<Bracket, E> {
    let mut bracket = Bracket { before, after, here: None };
    for _ in 0..HALVINGS {
        let middle = 0.5 * (bracket.before + bracket.after);
        if middle <= bracket.before || middle >= bracket.after {
            break;
        }
        match side(middle)? {
            Side::Before => bracket.before = middle,
            Side::After => bracket.after = middle,
            Side::Here => return Ok(Bracket { here: Some(middle), ..bracket }),
        }
    }
    Ok(bracket)
}

#[cfg(test)]
mod tests {
    use super::{Side, close_in};
    use std::convert::Infallible;

    #[test]
    fn the_zero_of_a_signed_function_is_bracketed_to_the_resolution() {
        let found = close_in((0.0, 2.0), |t| Ok::<_, Infallible>(Side::of(2.0 - t * t)));
        assert!(found.is_ok_and(|found| {
            let (before, after) = (found.before * found.before, found.after * found.after);
            before < 2.0 && after >= 2.0 && found.after - found.before < 2.0 * 1e-13 && found.here.is_none()
        }));
    }

    #[test]
    fn the_search_ends_at_adjacent_numbers_and_at_a_time_close_enough() {
        let next = f64::from_bits(1.0_f64.to_bits() + 1);
        let found = close_in((1.0, next), |_| -> Result<Side, &str> { Err("asked") });
        assert!(found.is_ok_and(|found| (found.before, found.after) == (1.0, next)));
        let found = close_in((0.0, 1.0), |t| Ok::<_, Infallible>(if t < 0.6 { Side::Here } else { Side::After }));
        assert!(found.is_ok_and(|found| found.here == Some(0.5)));
        assert_eq!(close_in((0.0, 1.0), |_| -> Result<Side, &str> { Err("asked") }), Err("asked"));
    }
}
