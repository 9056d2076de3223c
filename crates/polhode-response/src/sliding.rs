//! Rows that are held while contacts slide.
//!
//! A contact that slides along the unit vector `d` bears, besides its normal force `f_n`, the force `-mu f_n d`. With
//! the rows `E` whose accelerations are zero and the rows `D` along the directions of sliding, the forces of `E`
//! satisfy
//!
//! `(G_EE - G_ED diag(mu) S) f + b = 0`,
//!
//! where `S` picks the normal force of each sliding contact. The matrix is not symmetric. Where its rows depend on each
//! other (four corners of a box), the forces of least norm are taken. Contacts that slide in different directions move
//! the bodies as their single forces do: equal feet of a symmetric body press alike, whatever their lever arms are.
//!
//! Method: with rows scaled to unit diagonal of `G`, QR factorisation with column pivoting of the transposed matrix,
//! which reveals the rank, and one step of iterative refinement. The last columns of `Q` are the forces that hold
//! nothing; what they can take from the norm of the unscaled forces they do, by least squares. Where masses differ by
//! more than [`ALIKE_MASSES`](crate::least_norm_hold), forces of heavy bodies cancel on light ones: there the residual
//! is taken in twice the working precision, and what the forces add up to on each body is rounded once. Source: Golub
//! and Van Loan, sections 5.4 and 5.5; the equations are those of Pfeiffer and Glocker 1996, chapter 4. Failure: a
//! matrix that is not finite is refused. Where sliding makes the matrix singular or turns the sign of its determinant
//! (Painleve), the forces are those of the equations all the same: whether they may act is for the caller to check.

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::delassus::Delassus;
use crate::dense::householder::PivotedQr;
use crate::dense::kernels::dot;
use crate::error::{ResponseError, check_finite, check_length};
use crate::least_norm_hold::{ALIKE_MASSES, LeastNormForces, rounds};
use crate::precise;
use crate::problem::ContactProblem;
#[cfg(feature = "census")]
use crate::report::SolverStatus;
use crate::tolerances::DEPENDENT;
use polhode_spatial::DoubleDouble;

/// Forces that accelerate every row by less than this fraction of what forces would one by one move nothing (no unit,
/// 1e-12 to 1e-6): far above the rounding of the sums, and below what directions of slip that are nearly one make.
const MOVES: f64 = 1e-8;

/// Steps of iterative refinement: the first brings the residual to rounding.
const REFINEMENTS: usize = 1;

/// A contact that slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingRow {
    /// Index of the row along its normal.
    pub normal: usize,
    /// Index of the row along the direction of sliding, after all rows that are held.
    pub tangent: usize,
    /// Coefficient of friction (no unit).
    pub coefficient: f64,
}

/// The forces (N) of all rows of `problem`, whose Delassus matrix is `delassus`: the least ones that hold the first
/// rows, one for each of `b` (m/s^2), at zero acceleration, and friction along the rows of `sliding`.
///
/// ```
/// use polhode_response::{ContactProblem, SlidingRow, least_norm_sliding_forces};
/// // A block of 2 kg slides on a floor under gravity: rows along the normal and along the slip, in a plane.
/// let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
/// problem.push_row(&[(0, &[0.0, 1.0])])?;
/// problem.push_held_row(&[(0, &[1.0, 0.0])])?;
/// let sliding = [SlidingRow { normal: 0, tangent: 1, coefficient: 0.3 }];
/// let forces = least_norm_sliding_forces(&problem, &problem.delassus(), &[-9.81], &sliding)?.forces;
/// assert!((forces[0] - 19.62).abs() < 1e-13 && (forces[1] + 0.3 * 19.62).abs() < 1e-13);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// # Errors
/// When a row does not exist, or a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn least_norm_sliding_forces(
    problem: &ContactProblem,
    delassus: &Delassus,
    b: &[f64],
    sliding: &[SlidingRow],
) -> Result<LeastNormForces, ResponseError> {
    SlidingFactors::of(problem, delassus, sliding, b.len())?.forces(problem, b, sliding)
}

/// The factors of rows that are held while contacts slide, which serve all constant terms.
#[derive(Debug, Clone)]
pub(crate) struct SlidingFactors {
    /// Rows that are held.
    held: usize,
    /// Their accelerations for unit forces along them, scaled.
    matrix: Vec<f64>,
    scale: Vec<f64>,
    factor: PivotedQr,
    /// The forces that hold nothing, where they have scales of their own.
    idle: Option<PivotedQr>,
    /// The ratio of the largest mass to the smallest one.
    ratio: f64,
}

impl SlidingFactors {
    /// Those of the first `held` rows of a problem.
    ///
    /// # Errors
    /// When a row does not exist, or a number is not finite.
    pub(crate) fn of(
        problem: &ContactProblem,
        delassus: &Delassus,
        sliding: &[SlidingRow],
        held: usize,
    ) -> Result<Self, ResponseError> {
        check_length("Delassus matrix", problem.len(), delassus.len())?;
        delassus.check_finite()?;
        let rows = delassus.len();
        check_length("rows held and sliding", rows, held + sliding.len())?;
        check_rows(sliding, held, rows)?;
        let scale: Vec<f64> = (0..held)
            .map(|row| {
                let diagonal = delassus.get(row, row);
                if diagonal > 0.0 { 1.0 / diagonal.sqrt() } else { 0.0 }
            })
            .collect();
        // Its transpose is factored: rows of the one are columns of the other.
        let mut matrix = held_by_forces(delassus, held, sliding);
        for (row, row_scale) in matrix.chunks_exact_mut(held.max(1)).zip(&scale) {
            for (entry, column_scale) in row.iter_mut().zip(&scale) {
                *entry *= row_scale * column_scale;
            }
        }
        let factor = PivotedQr::factor(held, held, matrix.clone(), DEPENDENT);
        let idle = idle_forces(&factor, &scale);
        Ok(Self { held, matrix, scale, factor, idle, ratio: problem.mass_ratio() })
    }

    /// The least forces (N) of all rows of the problem against these constant terms, one for each row that is held.
    ///
    /// # Errors
    /// When their number is another, or one is not finite.
    pub(crate) fn forces(
        &self,
        problem: &ContactProblem,
        b: &[f64],
        sliding: &[SlidingRow],
    ) -> Result<LeastNormForces, ResponseError> {
        let Self { held, matrix, scale, factor, ratio, .. } = self;
        check_length("constant terms", *held, b.len())?;
        check_finite("constant terms", b)?;
        let (wanted, mut scaled) = self.solved(b);
        for _ in 0..REFINEMENTS {
            let rows = matrix.chunks_exact((*held).max(1)).zip(&wanted);
            let left = rows.map(|(row, wanted)| wanted - dot(row, &scaled));
            let correction = factor.solve_transpose(&left.collect::<Vec<_>>());
            for (force, change) in scaled.iter_mut().zip(&correction) {
                *force += change;
            }
        }
        let mut forces: Vec<f64> = scaled.iter().zip(scale).map(|(force, scale)| force * scale).collect();
        if let Some(idle) = &self.idle {
            idle.remove_range(&mut forces);
        }
        #[cfg(feature = "census")]
        {
            let size = Size { bodies: problem.bodies(), rows: problem.len(), cones: sliding.len() };
            let method = if *ratio > ALIKE_MASSES { "twice the precision" } else { "least norm" };
            census::note_single(Chain::LeastNormSliding, size, method, SolverStatus::Solved, 0.0);
        }
        if *ratio > ALIKE_MASSES {
            return Ok(refined(problem, b, sliding, (factor, scale), (&forces, rounds(*ratio))));
        }
        let forces = with_friction(forces, sliding, problem.len());
        Ok(LeastNormForces { forces, loads: None })
    }

    /// How the forces of so many rows change with the constant terms of those that are held, without refinement. None
    /// where these are others.
    pub(crate) fn change(&self, b: &[f64], sliding: &[SlidingRow], rows: usize) -> Option<Vec<f64>> {
        if b.len() != self.held || check_rows(sliding, self.held, rows).is_err() {
            return None;
        }
        let (_, scaled) = self.solved(b);
        let mut forces: Vec<f64> = scaled.iter().zip(&self.scale).map(|(force, scale)| force * scale).collect();
        if let Some(idle) = &self.idle {
            idle.remove_range(&mut forces);
        }
        Some(with_friction(forces, sliding, rows))
    }

    /// What the forces have to do in scaled rows, and the scaled forces, without refinement.
    fn solved(&self, b: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let wanted: Vec<f64> = b.iter().zip(&self.scale).map(|(b, scale)| -b * scale).collect();
        let scaled = self.factor.solve_transpose(&wanted);
        (wanted, scaled)
    }
}

/// The forces of so many rows, from those of the rows that are held.
fn with_friction(mut forces: Vec<f64>, sliding: &[SlidingRow], rows: usize) -> Vec<f64> {
    forces.resize(rows, 0.0);
    for slide in sliding {
        forces[slide.tangent] -= slide.coefficient * forces[slide.normal];
    }
    forces
}

/// `forces` of the rows that are held, and friction, after so many steps of refinement in twice the working precision.
fn refined(
    problem: &ContactProblem,
    b: &[f64],
    sliding: &[SlidingRow],
    (factor, scale): (&PivotedQr, &[f64]),
    (forces, steps): (&[f64], usize),
) -> LeastNormForces {
    let rows: Vec<usize> = (0..problem.len()).collect();
    let mut exact: Vec<DoubleDouble> = forces.iter().map(|&force| DoubleDouble::new(force)).collect();
    exact.resize(problem.len(), DoubleDouble::default());
    let slide = |exact: &mut [DoubleDouble]| {
        for row in sliding {
            exact[row.tangent] = DoubleDouble::default().plus_long_product(-row.coefficient, exact[row.normal]);
        }
    };
    slide(&mut exact);
    for _ in 0..steps {
        let loads = precise::loads(problem, &rows, &exact);
        let left = precise::accelerations_under(problem, &rows[..b.len()], b, (&exact, &loads));
        let wanted: Vec<f64> = left.iter().zip(scale).map(|(left, scale)| -left * scale).collect();
        for ((force, change), scale) in exact.iter_mut().zip(factor.solve_transpose(&wanted)).zip(scale) {
            *force = force.plus_product(change, *scale);
        }
        slide(&mut exact);
    }
    let loads = precise::loads(problem, &rows, &exact).iter().map(|load| load.value()).collect();
    LeastNormForces { forces: exact.iter().map(|force| force.value()).collect(), loads: Some(loads) }
}

/// Checks the rows of contacts that slide.
pub(crate) fn check_rows(sliding: &[SlidingRow], held: usize, rows: usize) -> Result<(), ResponseError> {
    for row in sliding {
        if row.normal >= held || !(held..rows).contains(&row.tangent) {
            return Err(ResponseError::UnknownRow { row: row.normal.max(row.tangent), rows });
        }
        check_finite("coefficients of friction", &[row.coefficient])?;
    }
    Ok(())
}

/// The accelerations of the rows that are held for unit forces along them, with the friction that each normal force
/// brings, row by row.
pub(crate) fn held_by_forces(delassus: &Delassus, held: usize, sliding: &[SlidingRow]) -> Vec<f64> {
    let mut matrix = Vec::with_capacity(held * held);
    for row in 0..held {
        let start = matrix.len();
        matrix.extend_from_slice(&delassus.row(row)[..held]);
        for slide in sliding {
            matrix[start + slide.normal] -= slide.coefficient * delassus.row(row)[slide.tangent];
        }
    }
    matrix
}

/// Whether the motion depends on which of the forces that hold all rows are chosen: whether some of them, `z`, hold
/// nothing and move the bodies nevertheless, by the friction of contacts that slide in different directions. The rows
/// are those of [`least_norm_sliding_forces`], and `forces` its answer; the first `pushing` of them can only push, so
/// that a single `z` can be added only as far as none of them would pull. Where `f + s z` with `s_0 <= s <= s_1` is all
/// that holds, the answer is no where `s_1 - s_0` is rounding, however much `z` itself would move.
///
/// # Errors
/// When a row does not exist, or a number is not finite.
pub fn motion_depends_on_choice(
    delassus: &Delassus,
    held: usize,
    sliding: &[SlidingRow],
    (forces, pushing): (&[f64], usize),
) -> Result<bool, ResponseError> {
    delassus.check_finite()?;
    check_length("forces of rows", delassus.len(), forces.len())?;
    check_length("rows that push among those held", held, held.max(pushing))?;
    let rows = delassus.len();
    check_length("rows held and sliding", rows, held + sliding.len())?;
    check_rows(sliding, held, rows)?;
    let factor = PivotedQr::factor(held, held, held_by_forces(delassus, held, sliding), DEPENDENT);
    for column in factor.rank()..held {
        let mut change = vec![0.0; held];
        change[column] = 1.0;
        factor.apply(&mut change);
        let range = room(&change[..pushing], forces);
        change.resize(rows, 0.0);
        for slide in sliding {
            change[slide.tangent] -= slide.coefficient * change[slide.normal];
        }
        // Each row by itself: z.G z is zero where they all are, but its rounding is not a square.
        let moved = delassus.times(&change)?.iter().fold(0.0, |most: f64, w| most.max(w.abs()));
        let one_by_one = |of: &[f64]| {
            let row = |row: usize| delassus.row(row).iter().zip(of).map(|(entry, f)| (entry * f).abs()).sum::<f64>();
            (0..rows).map(row).fold(0.0, f64::max)
        };
        // Of several undetermined forces one may make room for another.
        let is_single = factor.rank() + 1 == held && range.is_finite();
        let (moved, terms) = if is_single { (range * moved, one_by_one(forces)) } else { (moved, one_by_one(&change)) };
        if moved > MOVES * terms {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The length of the interval of `s` in which no force `f + s z` pulls.
fn room(change: &[f64], forces: &[f64]) -> f64 {
    let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
    for (z, f) in change.iter().zip(forces).filter(|(z, _)| **z != 0.0) {
        let bound = -f.max(0.0) / z;
        if *z > 0.0 { least = least.max(bound) } else { most = most.min(bound) }
    }
    (most - least).max(0.0)
}

/// The factors of what forces hold nothing: of the null space of the matrix of which `factor` holds the transposed one,
/// with its columns scaled. None where there is nothing of it, or where rows are scaled alike.
fn idle_forces(factor: &PivotedQr, scale: &[f64]) -> Option<PivotedQr> {
    let (held, rank) = (scale.len(), factor.rank());
    if rank == held || scale.windows(2).all(|pair| pair[0] == pair[1]) {
        return None;
    }
    let mut undetermined = vec![0.0; held * (held - rank)];
    for (k, column) in undetermined.chunks_exact_mut(held).enumerate() {
        column[rank + k] = 1.0;
        factor.apply(column);
        for (entry, scale) in column.iter_mut().zip(scale) {
            *entry *= scale;
        }
    }
    Some(PivotedQr::factor(held, held - rank, undetermined, DEPENDENT))
}

#[cfg(test)]
mod tests {
    //! Where forces are not unique, those of least norm are taken: what feet bear does not depend on where they stand.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::ContactProblem;

    /// A plate of 1 kg on four feet that slide all one way moves in one way, whatever they bear; if they slide in a
    /// circle, what each bears decides how much they brake.
    #[test]
    fn motion_depends_on_the_choice_where_feet_slide_in_different_directions() {
        let feet = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
        let circle = |[x, y]: [f64; 2]| [-y, x];
        // Where all feet stand equally far out, forces that leave the load as it is make no moment either: the last one
        // stands further out.
        let turning = (feet.map(circle), [1.0, 1.0, 1.0, 1.5], true);
        for (directions, reach, depends) in [(feet.map(|_| [1.0, 0.0]), [1.0; 4], false), turning] {
            let mut inverse_mass = vec![0.0; 36];
            (0..6).for_each(|k| inverse_mass[7 * k] = 1.0);
            let mut problem = ContactProblem::new(6, inverse_mass).unwrap();
            for [x, y] in feet {
                problem.push_row(&[(0, &[0.0, 0.0, 1.0, y, -x, 0.0])]).unwrap();
            }
            for (([x, y], [dx, dy]), reach) in feet.into_iter().zip(directions).zip(reach) {
                problem.push_held_row(&[(0, &[dx, dy, 0.0, 0.0, 0.0, reach * (x * dy - y * dx)])]).unwrap();
            }
            let sliding = [0, 1, 2, 3].map(|k| SlidingRow { normal: k, tangent: 4 + k, coefficient: 0.3 });
            let delassus = problem.delassus();
            let of_loads = |loads: [f64; 4]| {
                let forces: Vec<f64> = loads.iter().copied().chain(loads.map(|load| -0.3 * load)).collect();
                motion_depends_on_choice(&delassus, 4, &sliding, (&forces, 4)).unwrap()
            };
            assert_eq!(of_loads([2.0, 1.0, 2.0, 1.0]), depends);
            // Two feet beside each other that bear nothing leave no room: what the others bear is determined.
            assert!(!of_loads([2.0, 0.0, 0.0, 1.0]));
        }
    }

    /// Four feet under a beam of 1 kg and 1 kg m^2, at other distances to the left than to the right, its centre of
    /// mass at their height: least are the forces that are linear in the place.
    #[test]
    fn sliding_feet_bear_forces_that_are_linear_in_their_places() {
        let feet = [-2.0, -0.5, 0.3, 4.0];
        let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        for x in feet {
            problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
        }
        for _ in feet {
            problem.push_held_row(&[(0, &[1.0, 0.0, 0.0])]).unwrap();
        }
        let sliding = [0, 1, 2, 3].map(|k| SlidingRow { normal: k, tangent: 4 + k, coefficient: 0.3 });
        let forces = least_norm_sliding_forces(&problem, &problem.delassus(), &[-9.81; 4], &sliding).unwrap().forces;
        // f = p + q x with the sum of the weight and no moment.
        let (count, sum) = (4.0, feet.iter().sum::<f64>());
        let squares = feet.iter().map(|x| x * x).sum::<f64>();
        let q = -9.81 * sum / (count * squares - sum * sum);
        let p = -q * squares / sum;
        for (foot, force) in feet.iter().zip(&forces) {
            assert!((force - p - q * foot).abs() < 1e-12, "{forces:?}");
        }
        assert!(forces[4..].iter().zip(&forces).all(|(tangent, normal)| (tangent + 0.3 * normal).abs() < 1e-14));
    }
}
