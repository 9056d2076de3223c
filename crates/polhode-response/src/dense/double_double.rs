//! Sums of products in twice the working precision, without fused multiply-add.
//!
//! A number is an unevaluated sum `high + low`. Source: Dekker 1971 (splitting, product), Knuth's two-sum; Hida, Li and
//! Bailey 2001. Assumption: no overflow in the splitting, magnitudes below 1e292; beyond it the result is not finite.

/// `high + low` with `|low| <= ulp(high) / 2`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// A working-precision number.
    pub(crate) const fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// Rounded to working precision.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }

    /// `self + a b`.
    pub(crate) fn plus_product(self, a: f64, b: f64) -> Self {
        let (product, error) = two_product(a, b);
        self.plus(product, error)
    }

    /// `self + a b` for a `b` of twice the precision.
    pub(crate) fn plus_long_product(self, a: f64, b: Self) -> Self {
        let (product, error) = two_product(a, b.high);
        self.plus(product, error + a * b.low)
    }

    fn plus(self, high: f64, low: f64) -> Self {
        let (sum, error) = two_sum(self.high, high);
        let rest = error + (self.low + low);
        let high = sum + rest;
        Self { high, low: rest - (high - sum) }
    }
}

/// The sum and its rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The product and its rounding error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// The upper 26 bits and the rest.
fn split(a: f64) -> (f64, f64) {
    // 2^27 + 1, Veltkamp's constant for 53 bits.
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(1 + 2^-30)^2 - 1 - 2^-29 = 2^-60` is exact, where working precision gives 0.
    #[test]
    fn products_keep_their_rounding_error() {
        let a = 1.0 + 2.0_f64.powi(-30);
        let sum = DoubleDouble::new(-1.0).plus_product(a, a).plus_product(-1.0, 2.0_f64.powi(-29));
        assert_eq!(sum.value(), 2.0_f64.powi(-60));
        let long = DoubleDouble::new(0.0).plus_product(a, a);
        assert_eq!(
            DoubleDouble::new(-2.0).plus_long_product(2.0, long).value(),
            2.0 * (a * a - 1.0 + 2.0_f64.powi(-60))
        );
    }
}
