//! Numbers and lengths as messages say them.

/// Digits after the first one: messages give a length to find a place by, not to compute with.
const DIGITS: usize = 2;

/// Numbers that are written without a power of ten.
const PLAIN: std::ops::Range<f64> = 1e-3..1e6;

/// A number in at most three digits.
pub(crate) fn number(number: f64) -> String {
    let rounded: f64 = format!("{number:.DIGITS$e}").parse().unwrap_or(number);
    let is_plain = rounded == 0.0 || PLAIN.contains(&rounded.abs());
    if is_plain { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// A length (m) in at most three digits, with its unit.
pub(crate) fn length(length_m: f64) -> String {
    format!("{} m", number(length_m))
}

#[cfg(test)]
mod tests {
    //! Few digits, and no more zeros than are needed.
    use super::*;

    #[test]
    fn lengths_read_well() {
        let said = [0.5, 0.1 + 0.2, 1.0000000000000001e-7, 1.7320508e-9, 123_456.0, 0.0, -0.25, 2e7].map(length);
        assert_eq!(said, ["0.5 m", "0.3 m", "1e-7 m", "1.73e-9 m", "123000 m", "0 m", "-0.25 m", "2e7 m"]);
        assert_eq!([f64::NAN, f64::INFINITY].map(length), ["NaN m", "inf m"]);
    }
}
