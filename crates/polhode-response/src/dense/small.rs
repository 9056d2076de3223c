//! Elimination for a handful of unknowns, in place.

/// `A^-1 b` in place of `b`, for a row-major `A`, which is destroyed: Gauss elimination with the largest pivot of each
/// column. Pivots below `cut` times the largest entry depend on the others: their unknowns are zero.
pub(crate) fn solve_small(a: &mut [f64], b: &mut [f64], cut: f64) {
    match b.len() {
        // Two bodies have six ways to move: loops of known length are unrolled.
        6 => solve_lines::<6>(a.as_chunks_mut().0, b, cut),
        size => {
            let mut lines: Vec<&mut [f64]> = a.chunks_exact_mut(size.max(1)).collect();
            eliminate(&mut lines, b, cut);
        }
    }
}

fn solve_lines<const N: usize>(a: &mut [[f64; N]], b: &mut [f64], cut: f64) {
    if let (Some(a), Some(b)) = (a.first_chunk_mut::<N>(), b.first_chunk_mut::<N>()) {
        eliminate(a, b, cut);
    }
}

fn eliminate<L: AsMut<[f64]> + AsRef<[f64]>>(a: &mut [L], b: &mut [f64], cut: f64) {
    let size = b.len();
    let largest = a.iter().flat_map(AsRef::as_ref).fold(0.0, |most: f64, value| most.max(value.abs()));
    for k in 0..size {
        let pivot = (k + 1..size)
            .fold(k, |best, row| if a[row].as_ref()[k].abs() > a[best].as_ref()[k].abs() { row } else { best });
        a.swap(k, pivot);
        b.swap(k, pivot);
        let (above, below) = a.split_at_mut(k + 1);
        let pivot_line = above[k].as_mut();
        let is_large = pivot_line[k].abs() > cut * largest;
        if !is_large {
            // Its unknown is zero, and its equation is left out.
            pivot_line.fill(0.0);
            (pivot_line[k], b[k]) = (1.0, 0.0);
            continue;
        }
        let over = 1.0 / pivot_line[k];
        for (line, row) in below.iter_mut().zip(k + 1..size) {
            let line = line.as_mut();
            let factor = line[k] * over;
            for (target, value) in line[k + 1..size].iter_mut().zip(&pivot_line[k + 1..size]) {
                *target -= factor * value;
            }
            b[row] -= factor * b[k];
        }
    }
    for k in (0..size).rev() {
        let line = a[k].as_ref();
        let known: f64 = line[k + 1..size].iter().zip(&b[k + 1..size]).map(|(a, x)| a * x).sum();
        b[k] = (b[k] - known) / line[k];
    }
}

#[cfg(test)]
mod tests {
    //! Unknowns of independent equations are found, those of dependent ones are zero.
    use super::*;

    const CUT: f64 = 1e-11;

    #[test]
    fn equations_are_solved_with_exchanges_of_rows() {
        let mut b = [5.0, 3.0, 4.0];
        solve_small(&mut [0.0, 2.0, 1.0, 1.0, 1.0, 0.0, 2.0, 0.0, 2.0], &mut b, CUT);
        assert_eq!(b, [1.0, 2.0, 1.0]);
    }

    #[test]
    fn unknowns_of_dependent_equations_are_zero() {
        let mut b = [2.0, 4.0, 3.0];
        solve_small(&mut [1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0], &mut b, CUT);
        assert_eq!(b, [2.0, 0.0, 1.0]);
    }

    #[test]
    fn six_unknowns_are_solved_like_any_number() {
        let entry = |i: usize, j: usize| 1.0 / (1.0 + i as f64 + j as f64) + f64::from(u8::from(i == j));
        let mut a: Vec<f64> = (0..36).map(|k| entry(k / 6, k % 6)).collect();
        let x = [1.0, -2.0, 3.0, -4.0, 5.0, -6.0];
        let mut b: Vec<f64> = (0..6).map(|i| (0..6).map(|j| entry(i, j) * x[j]).sum()).collect();
        solve_small(&mut a, &mut b, CUT);
        for (found, expected) in b.iter().zip(x) {
            assert!((found - expected).abs() < 1e-13, "{found} instead of {expected}");
        }
    }
}
