//! The polynomial of degree 7 that one component of a state follows within a step.
//!
//! `y(x) = y0 + x (F0 + (1-x) (F1 + x (F2 + (1-x) (F3 + x (F4 + (1-x) (F5 + x F6))))))` with `x = (t - t0)/h`.
//! Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.6, dop853.f (contd8).

/// Coefficients per component: y0, F0 ... F6.
pub(crate) const COEFFICIENTS: usize = 8;

/// Where the states are sampled, as fractions of the step: `(1 - cos(k pi/7))/2`.
pub(crate) const NODES: [f64; COEFFICIENTS] = [
    0.0,
    0.049_515_566_048_790_43,
    0.188_255_099_070_633_2,
    0.388_739_533_021_842_8,
    0.611_260_466_978_157_2,
    0.811_744_900_929_366_7,
    0.950_484_433_951_209_5,
    1.0,
];

/// Coefficients of the nest through values at [`NODES`]: Newton's form with the nodes 0, 1, 0, 1, ... of the nest, by
/// elimination on the values of its products.
pub(crate) fn nested(values: [f64; COEFFICIENTS]) -> [f64; COEFFICIENTS] {
    let mut rows = NODES.map(|x| {
        let mut product = 1.0;
        let mut row = [1.0; COEFFICIENTS];
        for k in 1..COEFFICIENTS {
            product *= if k % 2 == 1 { x } else { 1.0 - x };
            row[k] = product;
        }
        row
    });
    // The rows at both ends are units but for the first two columns: they give the value and the change.
    let change = values[COEFFICIENTS - 1] - values[0];
    let mut right: [f64; COEFFICIENTS] = std::array::from_fn(|k| values[k] - values[0] - NODES[k] * change);
    for column in 2..COEFFICIENTS {
        let inner = column - 1..COEFFICIENTS - 1;
        let pivot = inner.clone().max_by(|&i, &j| rows[i][column].abs().total_cmp(&rows[j][column].abs()));
        let Some(pivot) = pivot else { continue };
        rows.swap(column - 1, pivot);
        right.swap(column - 1, pivot);
        for i in column..COEFFICIENTS - 1 {
            let factor = rows[i][column] / rows[column - 1][column];
            for k in column..COEFFICIENTS {
                rows[i][k] -= factor * rows[column - 1][k];
            }
            right[i] -= factor * right[column - 1];
        }
    }
    let mut f = [values[0], change, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    for column in (2..COEFFICIENTS).rev() {
        let known: f64 = (column + 1..COEFFICIENTS).map(|k| rows[column - 1][k] * f[k]).sum();
        f[column] = (right[column - 1] - known) / rows[column - 1][column];
    }
    f
}

/// Where in the step the time lies: 0 at its start, 1 at its end. A step of length zero is all start.
pub(crate) fn fraction(t0: f64, h: f64, t: f64) -> f64 {
    if h == 0.0 { 0.0 } else { (t - t0) / h }
}

/// One component at `x`.
pub(crate) fn evaluate(f: &[f64; COEFFICIENTS], x: f64) -> f64 {
    let mut y = 0.0;
    for (i, coefficient) in f[1..].iter().rev().enumerate() {
        y += coefficient;
        y *= if i % 2 == 0 { x } else { 1.0 - x };
    }
    f[0] + y
}

/// Coefficients of one component in powers of its distance from `x`.
pub(crate) fn expand(f: &[f64; COEFFICIENTS], x: f64) -> [f64; COEFFICIENTS] {
    let mut y = [0.0; COEFFICIENTS];
    for (i, coefficient) in f[1..].iter().rev().enumerate() {
        y[0] += coefficient;
        // The next factor of the nest is x + s or 1 - x - s, s the distance.
        let (constant, slope) = if i % 2 == 0 { (x, 1.0) } else { (1.0 - x, -1.0) };
        for k in (1..COEFFICIENTS).rev() {
            y[k] = constant * y[k] + slope * y[k - 1];
        }
        y[0] *= constant;
    }
    y[0] += f[0];
    y
}
