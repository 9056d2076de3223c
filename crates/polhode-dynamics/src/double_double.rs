//! Differences of products in twice the working precision.
//!
//! A number is kept as the unevaluated sum of two doubles, `high + low` with `|low| <= ulp(high)/2`; products are split
//! after Veltkamp and Dekker, without fused multiply-add, so that the bits are the same on every platform. Relative
//! error of an operation: about 1e-31. Assumes magnitudes between 1e-140 and 1e140, beyond which the parts of a
//! product under- or overflow. Source: docs/REFERENCES.md, Dekker 1971.

/// An unevaluated sum of two doubles.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// `a - b` without error.
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        let high = a - b;
        let b_part = high - a;
        Self { high, low: (a - (high - b_part)) - (b + b_part) }
    }

    /// The product with a double.
    pub(crate) fn times(self, factor: f64) -> Self {
        let (high, error) = product(self.high, factor);
        normalized(high, error + self.low * factor)
    }

    /// `self - other`, rounded to a double.
    pub(crate) fn minus(self, other: Self) -> f64 {
        let high = Self::difference(self.high, other.high);
        high.high + (high.low + (self.low - other.low))
    }
}

/// `a b` and its rounding error.
fn product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

/// Two halves of at most 26 bits each, whose products are exact.
fn split(a: f64) -> (f64, f64) {
    /// `2^27 + 1`: Veltkamp's constant for 53 bits.
    const SPLITTER: f64 = 134_217_729.0;
    let c = SPLITTER * a;
    let high = c - (c - a);
    (high, a - high)
}

fn normalized(high: f64, low: f64) -> DoubleDouble {
    let sum = high + low;
    DoubleDouble { high: sum, low: low - (sum - high) }
}
