//! Vectors of the tangent plane, as pairs of components along the two tangents.

/// A vector of the tangent plane.
pub(super) type Tangent = [f64; 2];

/// `a . b`.
pub(super) fn dot(a: Tangent, b: Tangent) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Length.
pub(super) fn length(a: Tangent) -> f64 {
    dot(a, a).sqrt()
}

/// `factor a`.
pub(super) fn scaled(a: Tangent, factor: f64) -> Tangent {
    [factor * a[0], factor * a[1]]
}

/// `a + b`.
pub(super) fn sum(a: Tangent, b: Tangent) -> Tangent {
    [a[0] + b[0], a[1] + b[1]]
}

/// `a` turned by a quarter, anticlockwise.
pub(super) fn quarter_turn(a: Tangent) -> Tangent {
    [-a[1], a[0]]
}

/// The direction of `a`; none where it is zero. Scaled before it is squared, so that nothing underflows.
pub(super) fn direction(a: Tangent) -> Option<Tangent> {
    let largest = a[0].abs().max(a[1].abs());
    if largest > 0.0 {
        let a = [a[0] / largest, a[1] / largest];
        Some(scaled(a, 1.0 / length(a)))
    } else {
        None
    }
}

/// Symmetric matrices of the tangent plane: the entries 11, 12, 22.
pub(super) type Symmetric = [f64; 3];

/// `m a`.
pub(super) fn times(m: Symmetric, a: Tangent) -> Tangent {
    [m[0] * a[0] + m[1] * a[1], m[1] * a[0] + m[2] * a[1]]
}

/// `m^-1 a` for a positive definite matrix; its least solution where `m` is singular to `rank_cut` (no unit, relative
/// to the trace) and `a` is in its range.
pub(super) fn solve(m: Symmetric, a: Tangent, rank_cut: f64) -> Tangent {
    let trace = m[0] + m[2];
    if trace <= 0.0 {
        return [0.0, 0.0];
    }
    // The larger diagonal entry is the pivot: the Schur complement of the other one then carries the rounding of its
    // own terms alone.
    let swap = m[2] > m[0];
    let (first, second) = if swap { (m[2], m[0]) } else { (m[0], m[2]) };
    let a = if swap { [a[1], a[0]] } else { a };
    let factor = m[1] / first;
    let rest = second - factor * m[1];
    let solution = if rest > rank_cut * trace {
        let y = (a[1] - factor * a[0]) / rest;
        [a[0] / first - factor * y, y]
    } else {
        // Rank one: the range is that of (1, factor).
        let share = (a[0] + factor * a[1]) / (first * (1.0 + factor * factor) * (1.0 + factor * factor));
        [share, factor * share]
    };
    if swap { [solution[1], solution[0]] } else { solution }
}
