//! Damping of a contact spring from the coefficient of restitution.
//!
//! A mass m meets a spring at speed v and leaves it at e v. Both relations are exact for such an impact, and both are
//! inverted by bisection to the last bit.
//!
//! **Plain damper** `F = k d + c d'`, never pulling: the contact ends where F vanishes, not where the overlap does.
//! With `zeta = c/(2 sqrt(k m)) = sin phi`
//!
//! ```text
//! e = exp(-tan(phi) (pi - 2 phi)),        zeta <= 1
//! e = exp(-2 psi coth(psi)),              zeta = cosh(psi) > 1
//! ```
//!
//! (from x = v/w_d exp(-zeta w t) sin(w_d t) and x'' = 0 at w_d t = pi - 2 phi; both meet in e = exp(-2) at zeta = 1).
//! For the spring of Hertz `F = k d^(3/2) + c d^(1/4) d'` is the same oscillator in `y = sqrt(4/5) d^(5/4)` and the
//! time `d tau = (sqrt(5)/2) d^(1/4) dt`, also where F vanishes, with `c = 2 zeta sqrt(5 k m)/2`.
//!
//! **Hunt and Crossley** `F = k d^n (1 + a d')`, any n: `m v dv/(1 + a v) = -k d^n dd` gives with `y = a v`
//!
//! ```text
//! (1 + e) y = ln((1 + y)/(1 - e y))
//! ```
//!
//! and not the usual `a = 3 (1 - e)/(2 v)`, which holds for small damping only.
//!
//! Sources: docs/REFERENCES.md, Hunt and Crossley; Schwager and Poeschel (end of a contact at vanishing force); Antypov
//! and Elliott (Hertz's spring as a linear one). Symbols: e, zeta, y (no unit). How it fails: e = 0 would need damping
//! beyond all bounds. [`Relation::number_for`] refuses what is below [`SMALLEST_RESTITUTION`]; [`Relation::reachable`]
//! says what the strongest damping gives instead.

use super::SpringError;
use std::f64::consts::PI;

/// The smallest restitution that a damped spring is asked for (no unit, 1e-3 to 0.1): there the damper of a plain
/// spring is five times critical; that of Hunt and Crossley all but stops the body within the first tenth of the depth.
pub const SMALLEST_RESTITUTION: f64 = 0.01;

/// How far a Hunt-Crossley number is kept from its bound 1/e, in units of that bound: closer to it the difference
/// `1 - e y` is rounding. The restitution of the number is that asked to this part.
const FROM_BOUND: f64 = 1.0 / (1u64 << 50) as f64;

/// Halvings of a bisection: all bits of a number between neighbouring powers of two, and its exponent.
const HALVINGS: u32 = 200;

/// A law of damping, each with one dimensionless number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// A plain damper: the number is the damping ratio zeta.
    Plain,
    /// Hunt and Crossley: the number is `y = a v`.
    HuntCrossley,
}

impl Relation {
    /// The restitution that a damper reaches where this one is asked: at least [`SMALLEST_RESTITUTION`].
    pub fn reachable(self, restitution: f64) -> f64 {
        if restitution < SMALLEST_RESTITUTION { SMALLEST_RESTITUTION } else { restitution }
    }

    /// The number with which a lone impact has this restitution: 0 for e = 1.
    ///
    /// # Errors
    /// When the restitution is not in [[`SMALLEST_RESTITUTION`], 1].
    pub fn number_for(self, restitution: f64) -> Result<f64, SpringError> {
        if !(SMALLEST_RESTITUTION..=1.0).contains(&restitution) {
            return Err(SpringError::Restitution { value: restitution });
        }
        if restitution == 1.0 {
            return Ok(0.0);
        }
        // Of both relations the restitution falls as the number grows.
        let (mut low, mut high) = match self {
            Self::Plain => (0.0, 1.0 / restitution),
            Self::HuntCrossley => (0.0, (1.0 - FROM_BOUND) / restitution),
        };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if self.is_above(middle, restitution) { low = middle } else { high = middle }
        }
        Ok(0.5 * (low + high))
    }

    /// Whether the number gives a larger restitution than this.
    fn is_above(self, number: f64, restitution: f64) -> bool {
        match self {
            Self::Plain => self.restitution_of(number) > restitution,
            Self::HuntCrossley => hunt_crossley(number, restitution) < 0.0,
        }
    }

    /// The restitution of a lone impact with this number; NaN for a negative number.
    pub fn restitution_of(self, number: f64) -> f64 {
        match self {
            _ if number.is_nan() || number < 0.0 => f64::NAN,
            _ if number == 0.0 => 1.0,
            Self::Plain if number == 1.0 => libm::exp(-2.0),
            Self::Plain if number < 1.0 => {
                let angle = libm::asin(number);
                libm::exp(-libm::tan(angle) * (PI - 2.0 * angle))
            }
            Self::Plain => {
                let psi = libm::acosh(number);
                libm::exp(-2.0 * psi / libm::tanh(psi))
            }
            Self::HuntCrossley => {
                let (mut low, mut high) = (0.0, (1.0f64 / number).min(1.0));
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if middle <= low || middle >= high {
                        break;
                    }
                    if hunt_crossley(number, middle) < 0.0 { low = middle } else { high = middle }
                }
                0.5 * (low + high)
            }
        }
    }
}

/// `ln(1 + y) - ln(1 - e y) - (1 + e) y`, which changes its sign from minus to plus where y and e belong together: from
/// below in y, and from below in e.
fn hunt_crossley(y: f64, restitution: f64) -> f64 {
    let given_back = restitution * y;
    let value = libm::log1p(y) - libm::log1p(-given_back) - (y + given_back);
    // Differences of the third order vanish in rounding for numbers near zero: there the series decides,
    // -(1 - e^2) y^2/2 + (1 + e^3) y^3/3.
    if y < SERIES_BELOW {
        let e = restitution;
        let quartic = (1.0 - e * e * e * e) * y / 4.0;
        let cubic = (1.0 + e * e * e) / 3.0 - quartic + (1.0 + e * e * e * e * e) * y * y / 5.0;
        return y * y * (-(1.0 - e * e) / 2.0 + y * cubic);
    }
    value
}

/// Below this number the series to the fifth order is as exact as the logarithms (1e-4 to 1e-2).
const SERIES_BELOW: f64 = 1e-3;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
mod tests {
    //! The relations are inverses of each other, meet where they should, and are refused outside their range;
    //! integrating the equation of motion reaches the same restitution.
    use super::*;

    #[test]
    fn relations_are_inverted() {
        for relation in [Relation::Plain, Relation::HuntCrossley] {
            assert_eq!(relation.number_for(1.0).unwrap(), 0.0);
            for e in [0.999_999, 0.999, 0.98, 0.8, 0.5, 0.2, 0.1353, 0.1, 0.05, 0.01] {
                let number = relation.number_for(e).unwrap();
                let reached = relation.restitution_of(number);
                assert!((reached - e).abs() < 1e-11, "{relation:?} {e}: {number} {reached}");
            }
            for wrong in [0.0, 0.009, 1.1, -0.5, f64::NAN, f64::INFINITY] {
                let refused = relation.number_for(wrong).unwrap_err();
                assert!(matches!(refused, SpringError::Restitution { .. }), "{wrong}: {refused}");
            }
        }
    }

    /// Critical damping gives back exp(-2); for small damping Hunt and Crossley's number is 3 (1 - e)/2.
    #[test]
    fn limits_are_known() {
        assert!((Relation::Plain.restitution_of(1.0 - 1e-12) - libm::exp(-2.0)).abs() < 1e-5);
        assert!((Relation::Plain.restitution_of(1.0 + 1e-12) - libm::exp(-2.0)).abs() < 1e-5);
        let number = Relation::HuntCrossley.number_for(1.0 - 1e-6).unwrap();
        assert!((number / 1.5e-6 - 1.0).abs() < 1e-5);
    }
}
