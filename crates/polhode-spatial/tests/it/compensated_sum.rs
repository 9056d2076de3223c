//! The compensated sum against exact integer arithmetic.

use polhode_spatial::CompensatedSum;
use proptest::prelude::*;

/// A term that plain summation loses: 1 beside 1e16.
#[test]
fn keeps_what_plain_summation_loses() {
    let terms = [1e16, 1.0, -1e16];
    assert_eq!(terms.iter().sum::<f64>(), 0.0);
    assert_eq!(terms.into_iter().collect::<CompensatedSum>().value(), 1.0);
}

/// A tenth added ten million times is wrong by 2e-4 in plain summation and right to the last digit here.
#[test]
fn does_not_drift() {
    let mut sum = CompensatedSum::new(0.0);
    sum.extend(std::iter::repeat_n(0.1, 10_000_000));
    // Exactly 1e7 times the f64 nearest to 0.1, rounded.
    assert_eq!(sum.value(), 1e6);
}

/// Infinities and NaN do not vanish in the sum.
#[test]
fn infinity_stays_visible() {
    for bad in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        assert!(!CompensatedSum::from_iter([1.0, bad, 2.0]).value().is_finite());
    }
}

proptest! {
    /// The documented bound, `2u |s| + 4 n u^2 sum |x|`, on terms that differ by up to 18 orders of magnitude and
    /// cancel: they are integers, so their exact sum is one of i128.
    #[test]
    fn error_is_within_the_bound(
        parts in prop::collection::vec((-(1i64 << 53)..(1i64 << 53), 0u32..60), 0..200),
    ) {
        // Each term and then its opposite but for one unit of the mantissa: heavy cancellation.
        let pairs = parts.iter().flat_map(|&(m, e)| [(m, e), (1 - m, e)]);
        let (mut sum, mut exact, mut magnitude, mut n) = (CompensatedSum::ZERO, 0i128, 0.0, 0.0);
        for (mantissa, exponent) in pairs {
            let term = mantissa as f64 * 2f64.powi(exponent as i32);
            sum.add(term);
            exact += i128::from(mantissa) << exponent;
            magnitude += term.abs();
            n += 1.0;
        }
        let u = 0.5 * f64::EPSILON;
        let error = (sum.value() as i128 - exact).unsigned_abs() as f64;
        prop_assert!(error <= 2.0 * u * (exact as f64).abs() + 4.0 * n * u * u * magnitude, "error {error}");
    }
}
