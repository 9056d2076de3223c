//! Numbers of 112 binary digits after the point, for oracles: 34 decimal digits, range 2^15.
//!
//! Plain integers, so that nothing is shared with the floating-point code under test. A product is rounded down at the
//! last place (2^-112 = 1.9e-34); sums are exact; doubles enter and leave without error as far as the places go.

/// Binary digits after the point.
const PLACES: i32 = 112;

/// `self.0 2^-112`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Fixed(i128);

impl Fixed {
    pub(crate) const ZERO: Self = Self(0);
    pub(crate) const ONE: Self = Self(1 << PLACES);

    /// Exactly `x`, but for binary digits beyond the last place.
    pub(crate) fn new(x: f64) -> Self {
        let (mantissa, exponent) = parts(x);
        Self(shifted(i128::from(mantissa), exponent + PLACES))
    }

    /// `a/b` to the last place.
    pub(crate) fn ratio(a: f64, b: f64) -> Self {
        let ((n, n_exponent), (d, d_exponent)) = (parts(a), parts(b));
        let (sign, n, d) = (n.signum() * d.signum(), i128::from(n.abs()), i128::from(d.abs()));
        // Long division, one binary digit at a time.
        let (mut quotient, mut rest) = (n / d, n % d);
        let digits = n_exponent - d_exponent + PLACES;
        for _ in 0..digits {
            rest *= 2;
            quotient = 2 * quotient + rest / d;
            rest %= d;
        }
        Self(i128::from(sign) * shifted(quotient, digits.min(0)))
    }

    /// A decimal number of at most 30 digits with one before the point, as `-1.25e-3`, over a power of two.
    pub(crate) fn from_decimal(text: &str, unit: f64) -> Self {
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        let number: i128 = format!("{digits:0<30}").parse().unwrap();
        // Two halves of fifteen digits, each of which is a double.
        let (high, low) = (number / 10i128.pow(15), number % 10i128.pow(15));
        let size = Self::ratio(high as f64, 1e14) + Self::ratio(low as f64, 1e22) * Self::ratio(1.0, 1e7);
        let exponent: i32 = exponent.parse().unwrap();
        // Powers of ten up to 1e22 are doubles.
        let (above, below) = (10f64.powi(exponent.max(0)), 10f64.powi((-exponent).max(0)));
        let factor = Self::ratio(above, below * unit);
        let size = size * factor;
        if mantissa.starts_with('-') { -size } else { size }
    }

    /// Divided by an integer.
    pub(crate) fn over(self, n: usize) -> Self {
        Self(self.0 / n as i128)
    }

    pub(crate) fn to_f64(self) -> f64 {
        // The conversion of an integer rounds to nearest, and a power of two only moves the exponent.
        self.0 as f64 * 2f64.powi(-PLACES)
    }

    pub(crate) fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// `2^-n`.
    pub(crate) fn binary(n: i32) -> Self {
        Self(1 << (PLACES - n))
    }
}

impl PartialOrd for Fixed {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl std::ops::Add for Fixed {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl std::ops::Sub for Fixed {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl std::ops::Neg for Fixed {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl std::ops::Mul for Fixed {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let magnitude = high_product(self.0.unsigned_abs(), other.0.unsigned_abs()) as i128;
        Self(if (self.0 < 0) == (other.0 < 0) { magnitude } else { -magnitude })
    }
}

/// `a b 2^-112`, rounded down.
fn high_product(a: u128, b: u128) -> u128 {
    const LOW: u128 = (1 << 64) - 1;
    let ((a1, a0), (b1, b0)) = ((a >> 64, a & LOW), (b >> 64, b & LOW));
    let (low, cross1, cross2, high) = (a0 * b0, a1 * b0, a0 * b1, a1 * b1);
    let middle = (low >> 64) + (cross1 & LOW) + (cross2 & LOW);
    let low = (middle << 64) | (low & LOW);
    let high = high + (cross1 >> 64) + (cross2 >> 64) + (middle >> 64);
    (high << (128 - PLACES)) | (low >> PLACES)
}

/// Mantissa and exponent: `x = mantissa 2^exponent`.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let mantissa = if exponent == 0 { fraction } else { fraction | (1 << 52) };
    (if x < 0.0 { -mantissa } else { mantissa }, exponent.max(1) - 1075)
}

/// `n 2^shift`, rounded towards zero.
fn shifted(n: i128, shift: i32) -> i128 {
    if shift >= 0 { n << shift } else { n / (1i128 << (-shift).min(126)) }
}

#[test]
fn numbers_enter_and_leave_exactly() {
    for x in [1.0, -0.1, 1e-17, 123.456, 0.0] {
        assert_eq!(Fixed::new(x).to_f64(), x);
    }
    // Quotients within the range of 2^15.
    for x in [1.0, -0.1, 1e-3, 123.456] {
        assert!((Fixed::ratio(3.0, x).to_f64() * x / 3.0 - 1.0).abs() < 1e-15);
    }
    // 1/3 in 112 digits, three times, is one but for the last place; products round there too.
    let third = Fixed::ratio(1.0, 3.0);
    assert!((Fixed::ONE - third - third - third).to_f64() <= 1e-33);
    assert!((Fixed::new(-1.5) * Fixed::new(0.1) + Fixed::new(0.15)).to_f64().abs() < 2e-17);
    assert!((third * third - Fixed::ratio(1.0, 9.0)).abs().to_f64() < 1e-33);
    assert!((Fixed::from_decimal("-3.33333333333333333333333333333e-1", 1.0) + third).abs().to_f64() < 1e-29);
    assert_eq!(Fixed::from_decimal("2.5e3", 4.0), Fixed::new(625.0));
    assert!((Fixed::ratio(-1.0, 9.0) + Fixed::ONE.over(9)).abs().to_f64() < 1e-33);
}
