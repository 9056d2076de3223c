//! What a measure `f` hangs on: how much of its variance `V` each uncertain value explains, and derivatives.
//!
//! The first-order index of a value is the share that it explains alone, `S_i = Var(E(f | x_i)) / V`; the total index
//! the share that is left when all others are known, `T_i = E(Var(f | x_others)) / V` (Sobol 2001). They are found
//!
//! - over a grid of Gauss's nodes, as sums: exact for polynomials. The polynomial through the nodes is held against the
//!   draws: where it leaves a share `e` of their variance unexplained, an index is within `2 sqrt(e) + e`;
//! - by mixed draws: with `f_A` of a draw, `f_B` of its second one and `f_M` of the mixed one,
//!   `S_i = mean((f_B - m) (f_M - f_A)) / V` (Saltelli 2010) and `T_i = mean((f_A - f_M)^2) / (2 V)` (Jansen 1999).
//!   Both are ratios of means over draws; their standard errors are those of a ratio of means.
//!
//! Derivatives are central differences at the middle with three steps, each half of the one before, of which the errors
//! of second and fourth order are taken out (Richardson); the change by the last extrapolation is their error.

use super::design::{Design, STEPS};
use super::distribution::{Drawing as _, Node};
use super::gauss;
use super::varied::{Values, Varied};

/// Draws that a polynomial is held against at the most.
pub(super) const MOST_JUDGED: usize = 1000;

/// A variance below this share of the square of the size is rounding: the measure does not vary.
const ROUNDING: f64 = f64::EPSILON * f64::EPSILON * 1e4;

/// A share of the variance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// The share.
    pub value: f64,
    /// A bound of its error by nodes, its standard error by draws; NaN where it is not known.
    pub error: f64,
}

/// A derivative at the middle of all values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derivative {
    /// By one unit of the value.
    pub value: f64,
    /// Its error, estimated.
    pub error: f64,
    /// The middle of the value.
    pub middle: f64,
    /// By how much the measure changes when the value changes by its standard deviation.
    pub by_deviation: f64,
}

/// What a measure hangs on an uncertain value.
#[derive(Debug, Clone, PartialEq)]
pub struct OfKey {
    /// The key.
    pub key: String,
    /// First-order index.
    pub first: Option<Index>,
    /// Total index.
    pub total: Option<Index>,
    /// Derivative.
    pub derivative: Option<Derivative>,
}

/// How indices were found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// Over a grid of Gauss's nodes.
    Nodes {
        /// How many each key has.
        counts: Vec<usize>,
        /// The share of the variance of the draws that the polynomial leaves unexplained; NaN where it is not known.
        unexplained: f64,
    },
    /// By mixed draws.
    Mixed {
        /// How many draws there are.
        draws: u64,
        /// How many are left out because one of their runs has no value.
        left_out: u64,
    },
    /// There are none, and why.
    None(String),
}

/// What a measure hangs on.
#[derive(Debug, Clone, PartialEq)]
pub struct Indices {
    /// How indices were found.
    pub method: Method,
    /// One for each key.
    pub keys: Vec<OfKey>,
}

/// A draw: its values and the measure of it.
pub(super) type Judge = (Vec<String>, f64);

/// First and total index of each key.
type Pairs = Vec<[Index; 2]>;

/// The indices by a grid; `f` has the nodes, the last key fastest.
pub(super) fn by_nodes(varied: &[Varied], design: &Design, f: &[f64], judges: &[Judge]) -> (Method, Pairs) {
    let nodes: Vec<Vec<Node>> =
        varied.iter().zip(design.nodes()).map(|(own, count)| own.values.nodes(*count)).collect();
    if f.iter().any(|own| own.is_nan()) {
        return (Method::None("a run at a node has no value: --sensitivities saltelli".to_owned()), Vec::new());
    }
    let places: Vec<Vec<usize>> = (0..f.len()).map(|node| design.places(node)).collect();
    let weight_but = |own: Option<usize>, node: usize| -> f64 {
        let of = |(key, place): (usize, &usize)| if Some(key) == own { 1.0 } else { nodes[key][*place].weight };
        places[node].iter().enumerate().map(of).product()
    };
    let weights: Vec<f64> = (0..f.len()).map(|node| weight_but(None, node)).collect();
    let mean: f64 = f.iter().zip(&weights).map(|(f, w)| f * w).sum();
    let variance: f64 = f.iter().zip(&weights).map(|(f, w)| w * (f - mean) * (f - mean)).sum();
    let size = f.iter().fold(0.0_f64, |size, own| size.max(own.abs()));
    if variance <= ROUNDING * size * size {
        return (Method::None("the measure does not vary".to_owned()), Vec::new());
    }
    let unexplained = unexplained(varied, &nodes, (design, f), judges);
    let error = 2.0 * libm::sqrt(unexplained) + unexplained;
    let index = |value: f64| Index { value, error };
    let of_key = |key: usize| {
        let mut alone = vec![0.0; nodes[key].len()];
        for node in 0..f.len() {
            alone[places[node][key]] += weight_but(Some(key), node) * (f[node] - mean);
        }
        let first: f64 = alone.iter().zip(&nodes[key]).map(|(own, node)| node.weight * own * own).sum();
        // Nodes that differ in this key alone stand a stride apart.
        let stride: usize = design.nodes()[key + 1..].iter().product();
        let along = |node: usize| (0..nodes[key].len()).map(move |place| node + place * stride);
        let mut total = 0.0;
        for node in (0..f.len()).filter(|node| places[*node][key] == 0) {
            let middle: f64 = along(node).zip(&nodes[key]).map(|(node, own)| own.weight * f[node]).sum();
            let spread = |(node, own): (usize, &Node)| own.weight * (f[node] - middle) * (f[node] - middle);
            total += weight_but(Some(key), node) * along(node).zip(&nodes[key]).map(spread).sum::<f64>();
        }
        [index(first / variance), index(total / variance)]
    };
    let pairs = (0..varied.len()).map(of_key).collect();
    (Method::Nodes { counts: design.nodes().to_vec(), unexplained }, pairs)
}

/// The share of the variance of draws that the polynomial through the nodes leaves; NaN where there are too few.
fn unexplained(varied: &[Varied], nodes: &[Vec<Node>], (design, f): (&Design, &[f64]), judges: &[Judge]) -> f64 {
    let known: Vec<&Judge> = judges.iter().filter(|(_, own)| !own.is_nan()).collect();
    let mean = known.iter().map(|(_, own)| own).sum::<f64>() / known.len() as f64;
    let (mut left, mut all) = (0.0, 0.0);
    for (values, own) in known {
        let Some(guess) = at(varied, nodes, (design, f), values) else { return f64::NAN };
        left += (own - guess) * (own - guess);
        all += (own - mean) * (own - mean);
    }
    left / all
}

/// The polynomial through the nodes, at these values.
fn at(varied: &[Varied], nodes: &[Vec<Node>], (design, f): (&Design, &[f64]), values: &[String]) -> Option<f64> {
    let mut left = f.to_vec();
    // The last key is the fastest: it goes first.
    for (key, own) in varied.iter().enumerate().rev() {
        let place = own.values.place_of(&values[key])?;
        let places: Vec<f64> = nodes[key].iter().map(|node| node.at).collect();
        let shares = gauss::through(&places, place);
        let count = design.nodes()[key];
        left = left.chunks(count).map(|own| own.iter().zip(&shares).map(|(f, share)| f * share).sum()).collect();
    }
    left.first().copied()
}

/// The indices by mixed draws; each of `draws` has the draw, its second one, and the mixed ones.
pub(super) fn by_mixed(draws: &[f64], keys: usize) -> (Method, Pairs) {
    let all: Vec<&[f64]> = draws.chunks_exact(keys + 2).collect();
    let used: Vec<&[f64]> = all.iter().copied().filter(|own| own.iter().all(|value| !value.is_nan())).collect();
    let count = used.len() as f64;
    if used.len() < 2 {
        return (Method::None("fewer than two draws have all their runs".to_owned()), Vec::new());
    }
    let mean = used.iter().map(|own| own[0] + own[1]).sum::<f64>() / (2.0 * count);
    let square = |own: f64| (own - mean) * (own - mean);
    let spreads: Vec<f64> = used.iter().map(|own| 0.5 * (square(own[0]) + square(own[1]))).collect();
    let variance = spreads.iter().sum::<f64>() / count;
    let size = used.iter().fold(0.0_f64, |size, own| size.max(own[0].abs()));
    if variance <= ROUNDING * size * size {
        return (Method::None("the measure does not vary".to_owned()), Vec::new());
    }
    let ratio = |of: &dyn Fn(&[f64]) -> f64| {
        let value = used.iter().map(|own| of(own)).sum::<f64>() / count / variance;
        let off = |(own, spread): (&&[f64], &f64)| (of(own) - value * spread) * (of(own) - value * spread);
        let squares: f64 = used.iter().zip(&spreads).map(off).sum();
        Index { value, error: libm::sqrt(squares / (count * (count - 1.0))) / variance }
    };
    let of_key = |key: usize| {
        [
            ratio(&|own| (own[1] - mean) * (own[key + 2] - own[0])),
            ratio(&|own| 0.5 * (own[0] - own[key + 2]) * (own[0] - own[key + 2])),
        ]
    };
    let pairs = (0..keys).map(of_key).collect();
    (Method::Mixed { draws: all.len() as u64, left_out: (all.len() - used.len()) as u64 }, pairs)
}

/// The derivative by a value: `steps` has, for each step, what the value and the measure are below and above.
pub(super) fn derivative(own: &Varied, steps: &[[[f64; 2]; 2]; STEPS]) -> Option<Derivative> {
    let Values::Drawn(drawn) = &own.values else { return None };
    let [first, second, third] = steps.map(|[[low, f_low], [high, f_high]]| (f_high - f_low) / (high - low));
    let [coarse, fine] = [(4.0 * second - first) / 3.0, (4.0 * third - second) / 3.0];
    let value = (16.0 * fine - coarse) / 15.0;
    let middle = drawn.at(0.5).parse().ok()?;
    let by_deviation = value * drawn.deviation()?;
    // What the last bits of the measure are by the smallest step.
    let [[low, f_low], [high, f_high]] = steps[STEPS - 1];
    let rounding = f64::EPSILON * f_low.abs().max(f_high.abs()) / (high - low);
    let error = (value - fine).abs() + rounding;
    (!value.is_nan()).then_some(Derivative { value, error, middle, by_deviation })
}

impl Values {
    fn nodes(&self, count: usize) -> Vec<Node> {
        match self {
            Self::Drawn(drawn) => drawn.nodes(count),
            Self::Listed(_) => Vec::new(),
        }
    }

    fn place_of(&self, value: &str) -> Option<f64> {
        match self {
            Self::Drawn(drawn) => drawn.place_of(value),
            Self::Listed(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    //! Indices of a product and of Ishigami's function, and a derivative, against their closed forms.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::super::design::Sensitivities;
    use super::*;
    use std::f64::consts::PI;

    fn varied(all: &[&str]) -> Vec<Varied> {
        all.iter().map(|text| Varied::parse(text).unwrap()).collect()
    }

    fn numbers(values: &[String]) -> Vec<f64> {
        values.iter().map(|own| own.parse().unwrap()).collect()
    }

    /// `f = x y` with x = 1 +- 0.5, y even in [1, 2] (mean 3/2, variance 1/12, mean of the square 7/3).
    #[test]
    fn a_product_over_a_grid() {
        let varied = varied(&["x=normal(1, 0.5)", "y=1..2"]);
        let design = Design::new(&varied, Sensitivities::Gauss, |_, _| true);
        assert_eq!(design.nodes(), [12, 12]);
        let first = design.before_draws() - 144;
        let of = |run: u64| numbers(&design.values(&varied, 3, run)).iter().product::<f64>();
        let f: Vec<f64> = (first..design.before_draws()).map(of).collect();
        let draws = design.before_draws()..design.before_draws() + 20;
        let judges: Vec<Judge> = draws.map(|run| (design.values(&varied, 3, run), of(run))).collect();
        let (method, pairs) = by_nodes(&varied, &design, &f, &judges);
        let v = 1.25 * 7.0 / 3.0 - 2.25;
        let exact = [[0.25 * 2.25 / v, 0.25 * (7.0 / 3.0) / v], [1.0 / 12.0 / v, 1.25 / 12.0 / v]];
        for (pair, exact) in pairs.iter().zip(exact) {
            assert!((0..2).all(|which| (pair[which].value - exact[which]).abs() < 1e-12), "{pair:?} {exact:?}");
        }
        assert!(matches!(method, Method::Nodes { unexplained, .. } if unexplained < 1e-20), "{method:?}");
    }

    /// `f = sin x + 7 sin^2 y + z^4 sin x / 10` (Ishigami and Homma 1990): three standard errors hold its indices.
    #[test]
    fn the_function_of_ishigami_by_mixed_draws() {
        let varied = varied(&[&format!("x={}..{PI}", -PI), &format!("y={}..{PI}", -PI), &format!("z={}..{PI}", -PI)]);
        let design = Design::new(&varied, Sensitivities::Saltelli, |_, _| true);
        let of = |run: u64| {
            let own = numbers(&design.values(&varied, 1, run));
            own[0].sin() + 7.0 * own[1].sin().powi(2) + 0.1 * own[2].powi(4) * own[0].sin()
        };
        let first = design.before_draws();
        let f: Vec<f64> = (first..first + 5 * 2000).map(of).collect();
        let (_, pairs) = by_mixed(&f, 3);
        for (pair, exact) in pairs.iter().zip([[0.3139, 0.5576], [0.4424, 0.4424], [0.0, 0.2437]]) {
            for (own, exact) in pair.iter().zip(exact) {
                assert!((own.value - exact).abs() < 3.5 * own.error && own.error < 0.06, "{own:?} {exact}");
            }
        }
    }

    #[test]
    fn a_derivative_is_extrapolated() {
        let own = &varied(&["x=normal(2, 0.4)"])[0];
        let steps = [0.1, 0.05, 0.025].map(|h| [[2.0 - h, (2.0_f64 - h).exp()], [2.0 + h, (2.0_f64 + h).exp()]]);
        let found = derivative(own, &steps).unwrap();
        let error = (found.value / 2.0_f64.exp() - 1.0).abs();
        assert!(error < 1e-11, "{error:e}");
        assert!(found.error > 0.0 && found.error < 1e-6, "{found:?}");
    }
}
