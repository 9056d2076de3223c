//! One result: what was expected, what was measured, how far apart they are and what that means.

use serde::{Deserialize, Serialize};

/// A reference or measured value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// Yes or no.
    Flag(bool),
    /// A count.
    Count(u64),
    /// A number.
    Number(f64),
    /// Several of yes and no.
    Flags(Vec<bool>),
    /// Several numbers.
    Numbers(Vec<f64>),
    /// Words.
    Text(String),
}

impl Value {
    /// The value as numbers, when it is made of them.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        match self {
            Self::Count(count) => Some(vec![*count as f64]),
            Self::Number(number) => Some(vec![*number]),
            Self::Numbers(numbers) => Some(numbers.clone()),
            Self::Flag(_) | Self::Flags(_) | Self::Text(_) => None,
        }
    }
}

macro_rules! value_from {
    ($($variant:ident from $type:ty),*) => {
        $(impl From<$type> for Value {
            fn from(value: $type) -> Self {
                Self::$variant(value.into())
            }
        })*
    };
}
value_from!(
    Flag from bool, Count from u64, Number from f64, Flags from Vec<bool>, Numbers from Vec<f64>, Text from &str,
    Text from String
);

impl<const N: usize> From<[f64; N]> for Value {
    fn from(numbers: [f64; N]) -> Self {
        Self::Numbers(numbers.to_vec())
    }
}

/// How far a measured value may be from its reference. The words are those of the reference files.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// Each component, relative to that component of the reference.
    Relative(f64),
    /// The norm of the difference, relative to the norm of the reference.
    RelativeNorm(f64),
    /// Each component, in the unit of the quantity.
    Absolute(f64),
    /// No difference at all.
    Exact,
    /// Not a matter of passing or failing.
    Info,
}

/// Smallest magnitude that a relative error is taken against, so that a reference of exactly zero asks for zero.
const SMALLEST_REFERENCE: f64 = 1e-300;

impl Tolerance {
    /// Distance of `measured` from `reference` in the sense of the tolerance; infinite when they cannot be compared
    /// and NaN when a number is.
    pub fn error(self, reference: &Value, measured: &Value) -> f64 {
        let (Some(expected), Some(found)) = (reference.numbers(), measured.numbers()) else {
            return if reference == measured { 0.0 } else { f64::INFINITY };
        };
        if expected.len() != found.len() {
            return f64::INFINITY;
        }
        let differences: Vec<f64> = expected.iter().zip(&found).map(|(e, f)| (f - e).abs()).collect();
        match self {
            Self::Relative(_) => {
                worst(differences.iter().zip(&expected).map(|(d, e)| d / e.abs().max(SMALLEST_REFERENCE)))
            }
            Self::RelativeNorm(_) => norm(&differences) / norm(&expected).max(SMALLEST_REFERENCE),
            Self::Absolute(_) | Self::Exact | Self::Info => worst(differences.into_iter()),
        }
    }

    /// The largest error that passes.
    pub fn limit(self) -> f64 {
        match self {
            Self::Relative(limit) | Self::RelativeNorm(limit) | Self::Absolute(limit) => limit,
            Self::Exact => 0.0,
            Self::Info => f64::INFINITY,
        }
    }

    /// Short words for the table: number and kind.
    pub fn words(self) -> String {
        match self {
            Self::Relative(limit) => format!("{limit:.0e} rel"),
            Self::RelativeNorm(limit) => format!("{limit:.0e} rel-norm"),
            Self::Absolute(limit) => format!("{limit:.0e} abs"),
            Self::Exact => "exact".to_owned(),
            Self::Info => String::new(),
        }
    }
}

/// The largest of some errors; NaN when one of them is.
fn worst(errors: impl Iterator<Item = f64>) -> f64 {
    // `f64::max` would drop what is not a number.
    errors.fold(0.0, |worst: f64, error| if worst >= error || worst.is_nan() { worst } else { error })
}

fn norm(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// What a result means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Within the tolerance.
    Ok,
    /// Outside the tolerance.
    Fails,
    /// Outside the tolerance, for a reason that is known.
    FailsKnown,
    /// Within the tolerance although it is marked as known to fail: the mark must go.
    PassesUnexpectedly,
    /// Shown, not judged.
    Info,
    /// Could not be measured here.
    Skipped,
}

impl Verdict {
    /// The word in the table.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Fails => "FAILS",
            Self::FailsKnown => "FAILS (known)",
            Self::PassesUnexpectedly => "PASSES (marked known)",
            Self::Info => "info",
            Self::Skipped => "skipped",
        }
    }

    /// Whether the run as a whole fails.
    pub const fn fails_the_run(self) -> bool {
        matches!(self, Self::Fails | Self::PassesUnexpectedly)
    }
}

/// One result.
#[derive(Debug, Clone)]
pub struct Row {
    /// Name of the case.
    pub case: String,
    /// What was measured, with its unit.
    pub quantity: String,
    /// What is right.
    pub reference: Option<Value>,
    /// What was found.
    pub measured: Value,
    /// How far apart they are, in the sense of the tolerance.
    pub error: f64,
    /// How far apart they may be.
    pub tolerance: Tolerance,
    /// What that means.
    pub verdict: Verdict,
    /// Why a row is known to fail, or why it was skipped.
    pub note: Option<String>,
}

impl Row {
    /// A measured value against its reference.
    pub fn compared(
        case: &str,
        quantity: &str,
        reference: impl Into<Value>,
        measured: impl Into<Value>,
        tolerance: Tolerance,
    ) -> Self {
        let (reference, measured) = (reference.into(), measured.into());
        let error = tolerance.error(&reference, &measured);
        let verdict = match tolerance {
            Tolerance::Info => Verdict::Info,
            _ if error <= tolerance.limit() => Verdict::Ok,
            _ => Verdict::Fails,
        };
        Self {
            case: case.to_owned(),
            quantity: quantity.to_owned(),
            reference: Some(reference),
            measured,
            error,
            tolerance,
            verdict,
            note: None,
        }
    }

    /// A number that must be at most `limit` away from zero.
    pub fn at_most(case: &str, quantity: &str, limit: f64, measured: f64) -> Self {
        Self::compared(case, quantity, 0.0, measured, Tolerance::Absolute(limit))
    }

    /// A value that must be met exactly.
    pub fn exact(case: &str, quantity: &str, reference: impl Into<Value>, measured: impl Into<Value>) -> Self {
        Self::compared(case, quantity, reference, measured, Tolerance::Exact)
    }

    /// A value that is shown and never decides; `asked` is the figure it is read against.
    pub fn info(case: &str, quantity: &str, asked: impl Into<Value>, measured: impl Into<Value>) -> Self {
        Self::compared(case, quantity, asked, measured, Tolerance::Info)
    }

    /// Something that went wrong before anything could be measured.
    pub fn broken(case: &str, quantity: &str, message: impl Into<String>) -> Self {
        Self::exact(case, quantity, "a result", message.into())
    }

    /// Something that cannot be measured on this machine.
    pub fn skipped(case: &str, quantity: &str, reason: &str) -> Self {
        let mut row = Self::info(case, quantity, "a result", "none");
        row.verdict = Verdict::Skipped;
        row.note = Some(reason.to_owned());
        row
    }

    /// Gives the row another reference, with the reason why that is what must be found.
    pub fn must_find(&mut self, reference: impl Into<Value>, tolerance: Tolerance, reason: &str) {
        *self = Self::compared(&self.case, &self.quantity, reference, self.measured.clone(), tolerance);
        self.note = Some(reason.to_owned());
    }

    /// Marks the row as known to fail for `reason`.
    pub fn mark_known(&mut self, reason: &str) {
        self.verdict = match self.verdict {
            Verdict::Fails => Verdict::FailsKnown,
            Verdict::Ok => Verdict::PassesUnexpectedly,
            other => other,
        };
        self.note = Some(reason.to_owned());
    }
}

#[cfg(test)]
mod tests {
    //! A row passes exactly when its error is within its tolerance, whatever the numbers are.
    use super::*;

    #[test]
    fn a_relative_tolerance_is_that_of_each_component() {
        let row = |measured: [f64; 2]| Row::compared("c", "q", [1.0, 1000.0], measured, Tolerance::Relative(1e-3));
        assert_eq!(row([1.0009, 1000.9]).verdict, Verdict::Ok);
        assert_eq!(row([1.002, 1000.0]).verdict, Verdict::Fails);
    }

    #[test]
    fn a_relative_tolerance_of_a_zero_asks_for_zero() {
        assert_eq!(Row::compared("c", "q", 0.0, 1e-200, Tolerance::Relative(1e-3)).verdict, Verdict::Fails);
        assert_eq!(Row::compared("c", "q", 0.0, 0.0, Tolerance::Relative(1e-3)).verdict, Verdict::Ok);
    }

    #[test]
    fn what_is_not_a_number_fails() {
        for tolerance in
            [Tolerance::Absolute(1.0), Tolerance::Relative(1.0), Tolerance::RelativeNorm(1.0), Tolerance::Exact]
        {
            assert_eq!(Row::compared("c", "q", [0.0, 1.0], [f64::NAN, 1.0], tolerance).verdict, Verdict::Fails);
            assert_eq!(Row::compared("c", "q", [1.0, 0.0], [1.0, f64::NAN], tolerance).verdict, Verdict::Fails);
        }
    }

    #[test]
    fn values_of_different_kinds_or_lengths_fail() {
        assert_eq!(Row::compared("c", "q", [1.0], [1.0, 1.0], Tolerance::Absolute(9.0)).verdict, Verdict::Fails);
        assert_eq!(Row::exact("c", "q", true, "true").verdict, Verdict::Fails);
    }

    #[test]
    fn a_row_marked_known_fails_the_run_only_when_it_passes() {
        let mut failing = Row::at_most("c", "q", 1.0, 2.0);
        failing.mark_known("reason");
        assert!(!failing.verdict.fails_the_run());
        let mut passing = Row::at_most("c", "q", 1.0, 0.5);
        passing.mark_known("reason");
        assert!(passing.verdict.fails_the_run());
    }
}
