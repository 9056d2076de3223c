//! Equilibrium: reactions within the cones that leave no velocity at any contact.
//!
//! Where friction jams bodies against each other Coulomb's law may have several answers: reactions that hold everything,
//! and others under which something moves. What is at rest stays at rest if it can. These are the least reactions that
//! hold everything:
//!
//! ```text
//! minimise |r|^2   subject to   G r + q = 0,   (1 - s) mu r_n >= |r_t| at every contact
//! ```
//!
//! with `s` the part of friction that is kept in reserve: a convex programme over second-order cones, with rows scaled to
//! one inverse mass. Source: Heyman 1966 (a structure stands if forces within the cones balance it); Goulart and Chen 2024
//! (the solver). Failure: `None` where no reactions balance, and where the interior point finds none.

use crate::error::ResponseError;
use crate::friction::block::FrictionBlock;
use crate::friction::problem::FrictionProblem;
use crate::interior_point::{ConeProgramme, ConeRows, least_motion};

/// The least reactions within the cones with `G r + q = 0` on all rows, to the tolerance of the interior point (1e-12 to
/// 1e-8 of the largest velocity without reactions). `reserve` is the part of the friction that they leave unused (no
/// unit). None where there are none, or a contact slides already.
///
/// ```
/// use polhode_response::friction::{FrictionBlock, FrictionProblem, balancing_reactions};
/// // A point of 2 kg on a slope of 3 in 4 under 10 m/s^2: friction of 0.76 holds it, with hardly any reserve.
/// let contact = FrictionBlock::Contact { rows: 2, friction: 0.76 };
/// let problem = FrictionProblem::from_dense(vec![contact], &[0.5, 0.0, 0.0, 0.5], vec![-8.0, 6.0])?;
/// assert!(balancing_reactions(&problem, 0.01)?.is_some());
/// assert!(balancing_reactions(&problem, 0.02)?.is_none());
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// # Errors
/// When the reserve is not in `[0, 1)`.
pub fn balancing_reactions(problem: &FrictionProblem, reserve: f64) -> Result<Option<Vec<f64>>, ResponseError> {
    if !(0.0..1.0).contains(&reserve) {
        return Err(ResponseError::Setting { field: "reserve", accepted: "at least 0 and below 1", value: reserve });
    }
    let (matrix, rows) = (problem.matrix(), problem.rows());
    let mut scales = vec![0.0; rows];
    for block in 0..problem.len() {
        scales[problem.range(block)].fill(1.0 / problem.inverse_mass(block).sqrt());
    }
    let (mut entries, mut constant) = (Vec::new(), Vec::with_capacity(2 * rows));
    for block in 0..problem.len() {
        for other in matrix.blocks(block) {
            let columns = matrix.range(other.column);
            for (at, value) in other.values.iter().enumerate() {
                let row = matrix.range(block).start + at / columns.len();
                let column = columns.start + at % columns.len();
                entries.push((row, column, value * scales[row] * scales[column]));
            }
        }
    }
    constant.extend(problem.constant().iter().zip(&scales).map(|(q, scale)| q * scale));
    let mut cones = vec![ConeRows::Zero(rows)];
    for (block, kind) in problem.blocks().iter().enumerate() {
        let range = problem.range(block);
        let weight = match *kind {
            FrictionBlock::Bilateral { .. } => continue,
            FrictionBlock::Sliding { .. } => return Ok(None),
            FrictionBlock::Contact { rows, friction } if rows > 1 && friction > 0.0 => {
                cones.push(ConeRows::SecondOrder(rows));
                friction * (1.0 - reserve)
            }
            FrictionBlock::Contact { rows, .. } => {
                cones.push(ConeRows::Nonnegative(1));
                if rows > 1 {
                    cones.push(ConeRows::Zero(rows - 1));
                }
                1.0
            }
        };
        for row in range.clone() {
            entries.push((constant.len(), row, if row == range.start { weight } else { 1.0 }));
            constant.push(0.0);
        }
    }
    let ConeProgramme::Solved { point, .. } = least_motion(rows, &entries, &constant, &cones) else { return Ok(None) };
    Ok(Some(point.iter().zip(&scales).map(|(reaction, scale)| reaction * scale).collect()))
}

#[cfg(test)]
mod tests {
    //! What balances is found, and what cannot balance is told.
    #![expect(clippy::unwrap_used, reason = "a failed step fails the test")]
    use super::*;

    const RESERVE: f64 = 1e-6;

    /// A point of 2 kg on a slope of 3 in 4: friction 0.76 holds it, 0.74 does not.
    fn on_a_slope(friction: f64) -> Option<Vec<f64>> {
        let contact = FrictionBlock::Contact { rows: 3, friction };
        let matrix = [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5];
        let problem = FrictionProblem::from_dense(vec![contact], &matrix, vec![-8.0, 6.0, 0.0]).unwrap();
        balancing_reactions(&problem, RESERVE).unwrap()
    }

    #[test]
    fn reactions_balance_where_friction_bears_the_slope() {
        let reactions = on_a_slope(0.76).unwrap();
        for (found, expected) in reactions.iter().zip([16.0, -12.0, 0.0]) {
            assert!((found - expected).abs() < 1e-9, "{found} where {expected} balances");
        }
    }

    #[test]
    fn nothing_balances_where_friction_is_too_small() {
        assert_eq!(on_a_slope(0.74), None);
    }

    /// A wedge of 1 kg between two walls that lean apart below by 0.1 rad: its weight alone presses it on neither, so that it
    /// may fall, and friction of 0.2 > tan(0.1) can hold it all the same.
    #[test]
    fn a_wedge_that_may_fall_is_held() {
        let (s, c) = (libm::sin(0.1), libm::cos(0.1));
        // Rows along the normals and tangents of both walls, in the plane.
        let rows = [[c, -s], [s, c], [-c, -s], [-s, c]];
        let matrix: Vec<f64> = rows.iter().flat_map(|a| rows.iter().map(|b| a[0] * b[0] + a[1] * b[1])).collect();
        let constant = rows.iter().map(|row| -9.81 * row[1]).collect();
        let contact = FrictionBlock::Contact { rows: 2, friction: 0.2 };
        let problem = FrictionProblem::from_dense(vec![contact; 2], &matrix, constant).unwrap();
        let reactions = balancing_reactions(&problem, RESERVE).unwrap().unwrap();
        let left = problem.velocities(&reactions).unwrap();
        assert!(left.iter().all(|u| u.abs() < 1e-8), "{left:?}");
        for contact in reactions.chunks(2) {
            assert!(contact[1].abs() <= 0.2 * contact[0], "{contact:?} is in the cone");
        }
    }
}
