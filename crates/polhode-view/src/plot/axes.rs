//! Labels of the marks of axes, and values in few digits.

use super::scale::Mark;
use super::svg::{Spot, Svg, Type};

/// Writes a mark.
pub(crate) fn mark(svg: &mut Svg, at: Spot, mark: &Mark, kind: Type) {
    match mark {
        Mark::Number(number) => svg.text(at, number, kind),
        Mark::Power(0) => svg.text(at, "1", kind),
        Mark::Power(exponent) => svg.power_of_ten(at, "", *exponent, kind),
        Mark::Foot { all_zero: true, .. } => svg.text(at, "0", kind),
        Mark::Foot { lowest, .. } => svg.power_of_ten(at, "< ", *lowest, kind),
    }
}

/// A value in few digits, with its unit: what a label says of the end of a line.
pub(crate) fn value(value: f64, unit: &str) -> String {
    let number = if value == 0.0 {
        "0".to_owned()
    } else if !value.is_finite() {
        value.to_string()
    } else if PLAIN.contains(&value.abs()) {
        let decade = libm::floor(libm::log10(value.abs()));
        let text = format!("{value:.*}", (DIGITS - 1.0 - decade).max(0.0) as usize);
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.1e}")
    };
    let number = number.replace('-', "\u{2212}");
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// Sizes of values that are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-3..1e6;

/// Digits of a value that is written without an exponent.
const DIGITS: f64 = 4.0;

#[cfg(test)]
mod tests {
    //! A value is short, and keeps its sign.
    use super::*;

    #[test]
    fn values_are_short() {
        let all = [0.0, -0.0, 1.0, 12.345678, -3e-15, 2.5e7, f64::NAN].map(|number| value(number, "J"));
        assert_eq!(all, ["0 J", "0 J", "1 J", "12.35 J", "\u{2212}3.0e\u{2212}15 J", "2.5e7 J", "NaN J"]);
        assert_eq!(value(999999.9, ""), "1000000");
    }
}
