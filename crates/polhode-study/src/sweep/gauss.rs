//! Gauss's quadrature of a probability, and the polynomial through its nodes.
//!
//! Nodes of `n` points are the roots of the orthonormal polynomial `p_n`, with
//! `x p_k = b_(k+1) p_(k+1) + b_k p_(k-1)`; `b_k = sqrt(k)` for the normal distribution (Hermite) and
//! `b_k = k / sqrt(4 k^2 - 1)` for the even one on [-1, 1] (Legendre). The weight of a node is
//! `1 / sum_(k < n) p_k(x)^2` (Christoffel). Roots of `p_n` lie between those of `p_(n-1)`, so that bisection finds
//! them to the last bit (Gautschi 2004, sections 1.2 and 1.4).

/// Which probability is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Weight {
    /// The normal distribution of mean 0 and deviation 1.
    Normal,
    /// The even distribution on [-1, 1].
    Even,
}

impl Weight {
    /// The coefficient `b_k` of the recurrence.
    fn coefficient(self, k: usize) -> f64 {
        let k = k as f64;
        match self {
            Self::Normal => libm::sqrt(k),
            Self::Even => k / libm::sqrt(4.0 * k * k - 1.0),
        }
    }

    /// The orthonormal polynomials up to that of degree `n`, at `x`.
    fn polynomials(self, n: usize, x: f64) -> Vec<f64> {
        let mut all = vec![1.0];
        for k in 0..n {
            let before = if k == 0 { 0.0 } else { self.coefficient(k) * all[k - 1] };
            all.push((x * all[k] - before) / self.coefficient(k + 1));
        }
        all
    }
}

/// Nodes in rising order, and their weights, whose sum is 1.
pub(super) fn rule(weight: Weight, count: usize) -> Vec<[f64; 2]> {
    let mut roots: Vec<f64> = Vec::new();
    for n in 1..=count {
        let end = match weight {
            // The largest root of the Hermite polynomial is below it (Szego 1975, 6.32).
            Weight::Normal => libm::sqrt(4.0 * n as f64 + 2.0),
            Weight::Even => 1.0,
        };
        let ends: Vec<f64> = [-end].into_iter().chain(roots).chain([end]).collect();
        roots = ends.windows(2).map(|pair| root(weight, n, [pair[0], pair[1]])).collect();
    }
    let of = |x: f64| [x, 1.0 / weight.polynomials(count - 1, x).iter().map(|p| p * p).sum::<f64>()];
    let nodes: Vec<[f64; 2]> = roots.into_iter().map(of).collect();
    // They are symmetric; bisection leaves the last bit to chance.
    (0..count)
        .map(|k| {
            let ([x, w], [other_x, other_w]) = (nodes[k], nodes[count - 1 - k]);
            [0.5 * (x - other_x), 0.5 * (w + other_w)]
        })
        .collect()
}

/// The root of the polynomial of degree `n` between two numbers.
fn root(weight: Weight, n: usize, [mut low, mut high]: [f64; 2]) -> f64 {
    let value = |x: f64| weight.polynomials(n, x)[n];
    let is_rising = value(high) > value(low);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if (value(middle) < 0.0) == is_rising {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// The values at `x` of the polynomials that are 1 at one of the nodes and 0 at the others (Lagrange).
pub(super) fn through(nodes: &[f64], x: f64) -> Vec<f64> {
    let of = |own: usize| {
        let others = nodes.iter().enumerate().filter(|(other, _)| *other != own);
        others.map(|(_, node)| (x - node) / (nodes[own] - node)).product()
    };
    (0..nodes.len()).map(of).collect()
}

#[cfg(test)]
mod tests {
    //! A rule of n nodes integrates polynomials of degree 2 n - 1 exactly: moments of both distributions.
    use super::*;

    #[test]
    fn moments_are_exact() {
        for n in 1..=12 {
            for (weight, moment) in [
                (Weight::Normal, (|k: usize| (1..k).step_by(2).map(|own| own as f64).product()) as fn(usize) -> f64),
                (Weight::Even, |k: usize| 1.0 / (k as f64 + 1.0)),
            ] {
                let nodes = rule(weight, n);
                for k in 0..2 * n {
                    let found: f64 = nodes.iter().map(|[x, w]| w * x.powi(k as i32)).sum();
                    let exact = if k % 2 == 1 { 0.0 } else { moment(k) };
                    let size: f64 = nodes.iter().map(|[x, w]| w * x.abs().powi(k as i32)).sum();
                    assert!((found - exact).abs() <= 1e-13 * size, "{weight:?} {n} {k}: {found} {exact}");
                }
            }
        }
    }

    #[test]
    fn a_polynomial_goes_through_its_nodes() {
        let nodes: Vec<f64> = rule(Weight::Normal, 6).iter().map(|own| own[0]).collect();
        let of = |x: f64| 1.0 + x - 2.0 * x * x * x + 0.5 * x.powi(5);
        let found: f64 = through(&nodes, 0.7).iter().zip(&nodes).map(|(own, node)| own * of(*node)).sum();
        assert!((found - of(0.7)).abs() < 1e-13, "{found}");
    }
}
