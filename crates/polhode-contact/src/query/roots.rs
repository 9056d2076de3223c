//! Places where a function changes its sign: of a monotone one by bisection, of a polynomial of degree four or less between
//! the zeros of its derivative.
//!
//! Between two neighbouring zeros of the derivative a polynomial is monotone and has at most one root, which bisection
//! finds to rounding: so the roots of the derivatives give those of the polynomial, from the line upwards.

/// Halvings of a bracket, after which it is shorter than rounding.
const HALVINGS: usize = 100;

/// Places in `[low, high]`, ascending, that part it into pieces on which the polynomial `sum c_i t^i` is monotone, with the
/// ends of the interval; on each piece it has at most one root.
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

/// The root of a monotone function in an interval, when its values at the ends differ in sign.
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
