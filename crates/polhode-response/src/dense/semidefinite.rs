//! Whether a matrix is symmetric and positive semidefinite, of any rank.

/// What keeps a matrix from being symmetric and positive semidefinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Defect {
    /// An entry and its mirror image differ.
    Asymmetric { row: usize, column: usize },
    /// What other rows leave of this one is negative, as a part of its diagonal entry.
    Indefinite { row: usize, part: f64 },
}

/// What keeps a row-major matrix of finite entries from being symmetric and positive semidefinite to `rounding` (no
/// unit). The elimination takes the largest diagonal entry first, which rows that depend on each other need, and those
/// of contacts do.
pub(crate) fn find_defect(entries: &[f64], size: usize, rounding: f64) -> Option<Defect> {
    let unit = |row: usize| match entries[row * size + row] {
        entry if entry > 0.0 => entry.sqrt(),
        _ => 1.0,
    };
    let units: Vec<f64> = (0..size).map(unit).collect();
    let mut rest: Vec<f64> = entries.to_vec();
    for row in 0..size {
        for column in 0..size {
            rest[row * size + column] /= units[row] * units[column];
        }
    }
    let asymmetry = |row: usize, column: usize| (rest[row * size + column] - rest[column * size + row]).abs();
    for row in 0..size {
        if let Some(column) = (0..row).find(|&column| asymmetry(row, column) > rounding) {
            return Some(Defect::Asymmetric { row, column });
        }
    }
    let mut left: Vec<usize> = (0..size).collect();
    while !left.is_empty() {
        let diagonal = |row: usize| rest[row * size + row];
        if let Some(&row) = left.iter().find(|&&row| diagonal(row) < -rounding) {
            return Some(Defect::Indefinite { row, part: diagonal(row) });
        }
        let place = (0..left.len()).max_by(|&a, &b| diagonal(left[a]).total_cmp(&diagonal(left[b])))?;
        if diagonal(left[place]) <= rounding {
            return coupled(&rest, size, &left, rounding);
        }
        eliminate(&mut rest, size, left.swap_remove(place), &left);
    }
    None
}

/// Rows without a diagonal entry that act on each other.
fn coupled(rest: &[f64], size: usize, left: &[usize], rounding: f64) -> Option<Defect> {
    let most = |row: usize| left.iter().map(|&column| rest[row * size + column].abs()).fold(0.0, f64::max);
    let row = left.iter().copied().find(|&row| most(row) > 2.0 * rounding)?;
    Some(Defect::Indefinite { row, part: -most(row) })
}

/// Takes a row out of those that are left.
fn eliminate(rest: &mut [f64], size: usize, pivot: usize, left: &[usize]) {
    let line: Vec<f64> = left.iter().map(|&column| rest[pivot * size + column]).collect();
    let by = rest[pivot * size + pivot];
    for (&row, &own) in left.iter().zip(&line).filter(|(_, own)| **own != 0.0) {
        for (&column, entry) in left.iter().zip(&line) {
            rest[row * size + column] -= own / by * entry;
        }
    }
}

#[cfg(test)]
mod tests {
    //! Matrices of any rank pass; a negative direction and an asymmetry do not.
    use super::*;

    const ROUNDING: f64 = crate::tolerances::MATRIX_ROUNDING;

    #[test]
    fn redundant_rows_pass() {
        // Three rows of one body on a line, masses of two sizes.
        let rows = [1.0, 3.0, -1000.0];
        let matrix: Vec<f64> = rows.iter().flat_map(|a| rows.map(|b| a * b / 3.0)).collect();
        assert_eq!(find_defect(&matrix, 3, ROUNDING), None);
        assert_eq!(find_defect(&[0.0; 4], 2, ROUNDING), None);
        assert_eq!(find_defect(&[], 0, ROUNDING), None);
    }

    #[test]
    fn indefinite_matrices_are_found() {
        assert_eq!(find_defect(&[1.0, 2.0, 2.0, 1.0], 2, ROUNDING), Some(Defect::Indefinite { row: 0, part: -3.0 }));
        assert_eq!(find_defect(&[-2.0], 1, ROUNDING), Some(Defect::Indefinite { row: 0, part: -2.0 }));
        assert_eq!(find_defect(&[0.0, 1.0, 1.0, 0.0], 2, ROUNDING), Some(Defect::Indefinite { row: 0, part: -1.0 }));
    }

    #[test]
    fn asymmetric_matrices_are_found() {
        let found = find_defect(&[4.0, 1.0, 1.5, 4.0], 2, ROUNDING);
        assert_eq!(found, Some(Defect::Asymmetric { row: 1, column: 0 }));
    }
}
