//! Roots of a monotone function by bisection, and the intervals on which a polynomial of degree four or less is
//! monotone.
//!
//! Between two neighbouring zeros of the derivative a polynomial is monotone and has at most one root, which bisection
//! finds to rounding. So the roots are found recursively, from the linear derivative up to the polynomial.

/// Most halvings of a bracket; it is then shorter than rounding.
const HALVINGS: usize = 100;

/// Ascending points that divide `[low, high]` into intervals on which the polynomial `sum c_i t^i` is monotone,
/// including the two ends; each interval contains at most one root.
pub(crate) fn monotone_pieces(coefficients: [f64; 5], low: f64, high: f64) -> Vec<f64> {
    let mut derivatives = vec![coefficients.to_vec()];
    for _ in 0..3 {
        let last = &derivatives[derivatives.len() - 1];
        let next = last.iter().enumerate().skip(1).map(|(i, c)| c * i as f64).collect();
        derivatives.push(next);
    }
    let mut places = vec![low, high];
    for polynomial in derivatives.iter().skip(1).rev() {
        let mut roots = vec![low];
        for ends in places.windows(2) {
            if let Some(root) = bisect(ends[0], ends[1], &|t| value(polynomial, t)) {
                roots.push(root);
            }
        }
        roots.push(high);
        places = roots;
    }
    places
}

/// The root of a monotone function in an interval; none when its values at the ends do not differ in sign.
pub(crate) fn bisect(mut low: f64, mut high: f64, function: &dyn Fn(f64) -> f64) -> Option<f64> {
    let (at_low, at_high) = (function(low), function(high));
    if at_low == 0.0 {
        return Some(low);
    }
    if (at_low < 0.0) == (at_high < 0.0) && at_high != 0.0 {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (function(middle) < 0.0) == (at_low < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(high)
}

fn value(coefficients: &[f64], t: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c)
}
