//! Numbers and lengths in few letters, for pictures.

/// Units of length with how many metres they are, the largest first.
const UNITS: [(&str, f64); 5] = [("km", 1e3), ("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6)];

/// What rounding may take from a length, as a fraction.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A length (m) in the largest unit of which it has one.
pub(crate) fn words(length_m: f64) -> String {
    let fits = |unit: &f64| length_m >= unit * (1.0 - ROUNDING);
    let found = UNITS.iter().find(|(_, unit)| fits(unit)).or_else(|| UNITS.last());
    found.map_or_else(String::new, |(name, unit)| format!("{} {name}", short(length_m / unit)))
}

/// A number in three digits.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let exponent = libm::log10(value.abs()).floor();
    if !(-4.0..6.0).contains(&exponent) {
        return format!("{value:.0e}");
    }
    let digits = (2.0 - exponent).max(0.0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// 1, 2 or 5 times a power of ten, at least this; 1 for what is not above zero.
pub(crate) fn rounded_up(value: f64) -> f64 {
    if value <= 0.0 || !value.is_finite() {
        return 1.0;
    }
    let power = libm::pow(10.0, libm::log10(value).floor());
    [1.0, 2.0, 5.0].into_iter().map(|factor| factor * power).find(|&round| round >= value).unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    //! Units change at their own size.
    use super::*;

    #[test]
    fn lengths() {
        assert_eq!(words(2.0), "2 m");
        assert_eq!(words(0.05), "5 cm");
        assert_eq!(words(0.01), "1 cm");
        assert_eq!(words(0.002), "2 mm");
        assert_eq!(words(2e7), "20000 km");
        assert_eq!(words(1e-9), "0.001 um");
        assert_eq!((short(0.25), short(1000.0), short(3e9)), ("0.25".to_owned(), "1000".to_owned(), "3e9".to_owned()));
        assert_eq!((rounded_up(3.0), rounded_up(0.02), rounded_up(0.0)), (5.0, 0.02, 1.0));
    }
}
