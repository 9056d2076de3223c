//! Values of a mesh that is infinitely fine, from meshes each twice as fine as the one before.
//!
//! Richardson extrapolation: with values a_1, a_2, a_3 (the last of the finest mesh) the order of convergence is
//! `p = log2((a_2 - a_1) / (a_3 - a_2))` and the limit `a_3 + (a_3 - a_2) / (2^p - 1)`. Where the differences have not
//! the signs and sizes of an order between [`LEAST_ORDER`] and [`MOST_ORDER`] the nearer of the two is taken. The error
//! is estimated by 1.25 times the distance from the finest value to the limit, the grid convergence index. Four meshes
//! tell more: the error is then 1.25 times how far the limit moved with the finest mesh, or how far it is from that of
//! order 1, whichever is larger, so that orders that agree by chance are no digits. Source:
//! docs/REFERENCES.md, Richardson 1911; Roache 1998. Fails: values that have not come to their order yet (meshes that
//! are too coarse for contacts that open and close) may be farther off than the estimate.

use crate::error::ElasticError;

/// The least order that an extrapolation takes: of contacts that open and close at single nodes.
pub const LEAST_ORDER: f64 = 1.0;

/// The most: that of bilinear elements and central differences.
pub const MOST_ORDER: f64 = 2.0;

/// Margin of the estimate of the error (Roache 1998, three meshes).
const MARGIN: f64 = 1.25;

/// Meshes that an extrapolation takes.
const FEWEST: usize = 3;

/// Standard errors of a mean that its error is taken to be.
const NOISE: f64 = 2.0;

/// A mean and its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// Its standard error; zero where there is one value.
    pub error: f64,
}

/// A value without the error of the mesh, as far as meshes tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extrapolated {
    /// The value.
    pub value: f64,
    /// How far off it may be.
    pub error: f64,
    /// The order at which the meshes converge to it.
    pub order: f64,
}

impl Extrapolated {
    /// From means with standard errors: two of them, as the extrapolation carries them, are added to the error.
    ///
    /// # Errors
    /// Fewer than three.
    pub fn of_means(means: &[Mean]) -> Result<Self, ElasticError> {
        let values: Vec<f64> = means.iter().map(|mean| mean.value).collect();
        let mut found = Self::of(&values)?;
        if let [.., second, third] = means {
            let carried = 1.0 / (libm::exp2(found.order) - 1.0);
            let (fine, coarse) = ((1.0 + carried) * third.error, carried * second.error);
            found.error += NOISE * (fine * fine + coarse * coarse).sqrt();
        }
        Ok(found)
    }

    /// From values of meshes, each twice as fine as the one before; the last three count.
    ///
    /// # Errors
    /// Fewer than three.
    pub fn of(values: &[f64]) -> Result<Self, ElasticError> {
        let &[.., first, second, third] = values else {
            return Err(ElasticError::Meshes { given: values.len(), least: FEWEST });
        };
        let (coarse, fine) = (second - first, third - second);
        if fine == 0.0 {
            return Ok(Self { value: third, error: 0.0, order: MOST_ORDER });
        }
        let ratio = coarse / fine;
        let order = if ratio > 0.0 { libm::log2(ratio).clamp(LEAST_ORDER, MOST_ORDER) } else { LEAST_ORDER };
        let correction = fine / (libm::exp2(order) - 1.0);
        let value = third + correction;
        let [.., before, _, _, _] = values else {
            return Ok(Self { value, error: MARGIN * correction.abs(), order });
        };
        let moved = (value - Self::of(&[*before, first, second])?.value).abs();
        let of_least_order = (correction - fine / (libm::exp2(LEAST_ORDER) - 1.0)).abs();
        Ok(Self { value, error: MARGIN * moved.max(of_least_order), order })
    }
}

#[cfg(test)]
mod tests {
    //! Errors of one order are taken away; errors of none are told.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn an_error_of_one_order_is_taken_away() {
        for order in [1.0, 1.5, 2.0] {
            let value = |k: i32| 3.0 + 0.5 * libm::exp2(-order * f64::from(k));
            let found = Extrapolated::of(&[value(0), value(1), value(2)]).unwrap();
            assert!((found.value - 3.0).abs() < 1e-14 && (found.order - order).abs() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn four_meshes_say_how_far_the_limit_moved() {
        let value = |k: i32| 3.0 + 0.5 * libm::exp2(-f64::from(k)) + 0.1 * libm::exp2(-2.0 * f64::from(k));
        let three = Extrapolated::of(&[value(1), value(2), value(3)]).unwrap();
        let four = Extrapolated::of(&[value(0), value(1), value(2), value(3)]).unwrap();
        assert_eq!(three.value, four.value);
        let off = (four.value - 3.0).abs();
        assert!(off < four.error && four.error < 0.25 * three.error, "{off} {four:?} {three:?}");
    }

    #[test]
    fn values_that_go_to_and_fro_keep_their_last_difference_for_an_error() {
        let found = Extrapolated::of(&[1.0, 1.2, 1.1]).unwrap();
        assert!((found.value - 1.0).abs() < 1e-14 && found.error > 0.1, "{found:?}");
        assert!(matches!(Extrapolated::of(&[1.0, 2.0]), Err(ElasticError::Meshes { given: 2, least: 3 })));
    }
}
