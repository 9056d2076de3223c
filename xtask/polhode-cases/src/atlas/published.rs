//! Printed digits, and how far from them a number may be.
//!
//! | written | is met by |
//! |---|---|
//! | `"0.1075"` | what rounds to it: half a unit of its last digit |
//! | `"0.508 +- 0.002"` | what is not farther from it |
//! | `"1 to 1e-9"` | what is not farther from it than that part of it |
//! | `"<= 1e-12"` | what is not larger in magnitude |
//! | `"stands"` | the same word |

use crate::row::{Row, Tolerance, Value};
use serde::Deserialize;
use std::fmt;

/// Half a unit of the last digit, and what f64 adds to it.
const ROUNDED: f64 = 0.5 + 1e-9;

/// What was published, as it is printed.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(from = "String")]
pub struct Published {
    text: String,
    value: Value,
    tolerance: Tolerance,
}

impl From<String> for Published {
    fn from(text: String) -> Self {
        let (value, tolerance) = understood(&text);
        Self { text, value, tolerance }
    }
}

impl fmt::Display for Published {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Published {
    /// A measured value beside it.
    pub fn row(&self, case: &str, quantity: &str, measured: Value) -> Row {
        Row::compared(case, quantity, self.value.clone(), measured, self.tolerance)
    }

    /// How far a measured value is from it; none of words.
    pub fn error(&self, measured: &Value) -> Option<f64> {
        self.value.numbers().map(|_| self.tolerance.error(&self.value, measured))
    }
}

fn understood(text: &str) -> (Value, Tolerance) {
    let number = |text: &str| text.trim().parse::<f64>().ok();
    if let Some(limit) = text.strip_prefix("<=").and_then(number) {
        return (Value::Number(0.0), Tolerance::Absolute(limit));
    }
    if let Some((value, bound)) = text.split_once("+-")
        && let (Some(value), Some(bound)) = (number(value), number(bound))
    {
        return (Value::Number(value), Tolerance::Absolute(bound));
    }
    if let Some((value, part)) = text.split_once(" to ")
        && let (Some(value), Some(part)) = (number(value), number(part))
    {
        return (Value::Number(value), Tolerance::Relative(part));
    }
    match number(text) {
        Some(value) => (Value::Number(value), Tolerance::Absolute(ROUNDED * unit_of_last_digit(text))),
        None => (Value::Text(text.to_owned()), Tolerance::Exact),
    }
}

/// What one more in the last digit of a printed number adds to it.
fn unit_of_last_digit(text: &str) -> f64 {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let behind = digits.split_once('.').map_or(0, |(_, behind)| behind.trim().len());
    let exponent: i32 = exponent.trim().parse().unwrap_or(0);
    libm::pow(10.0, f64::from(exponent) - behind as f64)
}

#[cfg(test)]
mod tests {
    //! What is printed is met by what rounds to it, and by nothing else.
    use super::*;
    use crate::row::Verdict;

    fn meets(printed: &str, measured: impl Into<Value>) -> bool {
        Published::from(printed.to_owned()).row("c", "q", measured.into()).verdict == Verdict::Ok
    }

    #[test]
    fn a_number_is_met_by_what_rounds_to_it() {
        assert!(meets("0.1075", 0.10749));
        assert!(!meets("0.1075", 0.10756));
        assert!(meets("-.070952354", -0.07095235365));
        assert!(!meets("-.070952354", -0.0709523546));
        assert!(meets("5e-3", 0.0054));
        assert!(meets("54", 54.4));
        assert!(!meets("54.0", 54.4));
    }

    #[test]
    fn bounds_and_words_are_met_as_they_are_written() {
        assert!(meets("0.508 +- 0.002", 0.5095));
        assert!(!meets("0.508 +- 0.002", 0.511));
        assert!(meets("2 to 1e-3", 2.001));
        assert!(!meets("2 to 1e-3", 2.003));
        assert!(meets("<= 1e-12", -1e-13));
        assert!(!meets("<= 1e-12", 1e-11));
        assert!(meets("stands", "stands"));
        assert!(!meets("stands", "falls"));
        assert!(!meets("1", "stands"));
    }
}
