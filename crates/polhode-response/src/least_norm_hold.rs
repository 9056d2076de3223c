//! Rows that are held at `w = 0` by the least forces, whatever their sign.
//!
//! Where rows depend on each other, or nearly do, the forces that hold them are not, or hardly, determined. A choice
//! of independent rows then puts the load on some of them, and what little the others differ by becomes motion that a
//! symmetric scene does not have: two contacts whose normals are tilted by an angle `a` against each other turn a load
//! that only one of them carries into a moment of order `a`. The least forces treat all rows alike.
//!
//! Method: with rows scaled to unit diagonal, the proximal-point iteration
//! `f <- f - (G + eps 1)^-1 (G f + b)`, `f = 0` at first, converges to the least-norm solution; each round multiplies
//! the error in a direction of eigenvalue `l` by `eps / (eps + l)`, and directions with `l << eps` stay at zero force.
//! One Cholesky factorisation of `G + eps 1`, which always exists, serves all rounds.
//!
//! Mass ratios. A body of 1 kg between the floor and one of `R` kg bears forces of `R g` that cancel. Their rounding
//! accelerates it by some `1e-16 R g`, whatever the solver, and forces that lift the heavy body have the eigenvalue
//! `1/R`, which must not be taken for rows that depend on each other. Where masses differ by more than
//! `ALIKE_MASSES`, [`least_norm_forces`] therefore
//!
//! - keeps `f` and `G f + b` in twice the working precision, summed body by body, and rounds what the forces add up to
//!   on a body, `J^T f`, once, after the sum;
//! - decides which rows depend on each other as if all bodies were of one mass: with `K` the matrix of such bodies,
//!   scaled to unit diagonal, it regularises by `eps^2 (K + eps 1)^-1` in the place of `eps 1`, which is `eps` where
//!   `K` has eigenvalues below `eps` and `eps^2` elsewhere;
//! - takes as many rounds as the mass ratio asks for: the factor, in working precision, only decides how fast they
//!   converge.
//!
//! Sources: Rockafellar 1976 (proximal point); Higham, Accuracy and Stability, chapters 10 and 12 (refinement with
//! residuals in extended precision). Failure: a matrix that is not finite or not positive semidefinite beyond rounding
//! is refused; beyond ratios of 1e11 the rounds do not converge, and heavy bodies are held only in part.

#[cfg(feature = "census")]
use crate::census::{self, Answer, Chain, Size};
#[cfg(feature = "census")]
use crate::certificate::nan_max;
use crate::delassus::Delassus;
use crate::dense::kernels::dot;
#[cfg(feature = "census")]
use crate::dense::kernels::largest;
use crate::error::{ResponseError, check_finite, check_length};
use crate::precise;
use crate::problem::ContactProblem;
#[cfg(feature = "census")]
use crate::report::SolverStatus;
use crate::sparse::BesideForest;
use polhode_spatial::DoubleDouble;

/// The regularisation `eps`, relative to the unit diagonal. Eigenvalues are quadratic in distances: directions in
/// which contacts differ by less than 1e-5 of the lever arm are left to the other rows. Rounding leaves forces of
/// 1e-16 / eps in undetermined directions, which move nothing.
const REGULARIZATION: f64 = 1e-10;

/// The same where small values are cancelled softly ([`LeastNormHold::factor_softly`]).
const SOFT_REGULARIZATION: f64 = 1e-2;

/// Rounds of the iteration: a direction with eigenvalue 1e-6 of the largest has converged to rounding after four.
const ROUNDS: usize = 4;

/// Masses within this ratio count as alike: forces in working precision leave 256 rounding units, some 1e-13 g, in the
/// accelerations of the lightest body.
pub(crate) const ALIKE_MASSES: f64 = 256.0;

/// Rounding of the factor of some hundred rows of unit diagonal (no unit): what a round leaves of an eigenvalue 1.
const FACTOR_ROUNDING: f64 = 1e-14;

/// Smallest eigenvalue that towers of alike bodies have, some ten high (no unit); at a mass ratio `R` it is `1 / R` of
/// this.
const SMALLEST_EIGENVALUE: f64 = 1e-2;

/// What the rounds leave of the error of the accelerations (no unit): the rounding unit.
const CONVERGED: f64 = f64::EPSILON;

/// Limit of the rounds, reached at mass ratios of 1e10 and more.
const MOST_ROUNDS: usize = 40;

/// What is left of the accelerations where rows count as held in a census (no unit).
#[cfg(feature = "census")]
const HELD: f64 = 1e-9;

/// A factorised set of rows that are all held.
#[derive(Debug, Clone)]
pub struct LeastNormHold {
    /// Scale of each row; zero for a row that nothing can move.
    scale: Vec<f64>,
    /// Lower triangle of the Cholesky factor of the scaled and regularised matrix, row by row.
    factor: Vec<f64>,
}

impl LeastNormHold {
    /// Factorises the matrix of the rows.
    ///
    /// # Errors
    /// When the matrix is not finite.
    pub fn factor(delassus: &Delassus) -> Result<Self, ResponseError> {
        Self::regularized((delassus, None), REGULARIZATION)
    }

    /// As [`factor`](Self::factor) for rows of gaps the largest of which is this part of the size of the bodies (no
    /// unit), in Newton steps that close them. Rows that depend on each other where the gaps are closed do not where
    /// they are open: by so much of their size, and their gaps contradict each other by the square of it. Regularised
    /// by the gap itself, such directions are left alone, to the order of its square, and all others are closed to that
    /// of its fourth power: the steps converge quadratically, also where rows depend on each other (Yamashita and
    /// Fukushima 2001).
    ///
    /// # Errors
    /// When the matrix is not finite.
    pub fn factor_open(delassus: &Delassus, gap: f64) -> Result<Self, ResponseError> {
        Self::regularized((delassus, None), gap.clamp(REGULARIZATION, SOFT_REGULARIZATION))
    }

    /// As [`factor_open`](Self::factor_open) for rows beside trees: dependence is decided against what each of them
    /// would move without the trees. What is left of one that they hold is rounding.
    ///
    /// # Errors
    /// When the matrix is not finite.
    pub fn factor_beside(beside: &BesideForest, gap: f64) -> Result<Self, ResponseError> {
        let regularization = gap.clamp(REGULARIZATION, SOFT_REGULARIZATION);
        Self::regularized((&beside.delassus, Some(&beside.free)), regularization)
    }

    /// As [`factor`](Self::factor), for small values that need not be cancelled at any price: what only forces above
    /// some ten times `b` would cancel stays. These are the directions with eigenvalues below 1e-2 of the unit
    /// diagonal.
    ///
    /// # Errors
    /// When the matrix is not finite.
    pub fn factor_softly(delassus: &Delassus) -> Result<Self, ResponseError> {
        Self::regularized((delassus, None), SOFT_REGULARIZATION)
    }

    fn regularized((delassus, free): (&Delassus, Option<&[f64]>), regularization: f64) -> Result<Self, ResponseError> {
        delassus.check_finite()?;
        let scale: Vec<f64> = match free {
            Some(free) => free.iter().map(|&own| inverse_root(own)).collect(),
            None => unit_diagonal(delassus),
        };
        let entry = |i: usize, j: usize| {
            let own = if i == j && free.is_none() { 1.0 } else { scale[i] * delassus.row(i)[j] * scale[j] };
            if i == j { own + regularization } else { own }
        };
        let factor = cholesky(scale.len(), entry, 0.5 * regularization);
        Ok(Self { scale, factor })
    }

    /// As [`factor`](Self::factor), with dependence decided as if the bodies of `problem` were of one mass.
    fn factor_unlike(problem: &ContactProblem, delassus: &Delassus) -> Result<Self, ResponseError> {
        let alike = problem.with_alike_masses().delassus();
        let Self { mut scale, factor } = Self::factor(&alike)?;
        let n = scale.len();
        let largest = (0..n).map(|i| scale[i] * delassus.get(i, i) * scale[i]).fold(0.0, f64::max);
        if largest > 0.0 {
            let root = largest.sqrt();
            for scale in &mut scale {
                *scale /= root;
            }
        }
        // The lower triangle of the inverse is all that is asked of it.
        let mut inverse = Vec::with_capacity(n * n);
        for column in 0..n {
            inverse.resize((column + 1) * n, 0.0);
            let unit = &mut inverse[column * n..];
            unit[column] = 1.0;
            back_substitute_from(&factor, unit, column);
        }
        let entry = |i: usize, j: usize| {
            scale[i] * delassus.row(i)[j] * scale[j] + REGULARIZATION * REGULARIZATION * inverse[j * n + i]
        };
        let factor = cholesky(n, entry, FACTOR_ROUNDING);
        Ok(Self { scale, factor })
    }

    /// The least forces with `w = G f + b = 0` on all rows.
    ///
    /// # Errors
    /// When lengths differ or `b` is not finite.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn solve(&self, delassus: &Delassus, b: &[f64]) -> Result<Vec<f64>, ResponseError> {
        let forces = self.forces(delassus, b)?;
        #[cfg(feature = "census")]
        {
            let w = delassus.times(&forces)?.into_iter().zip(b).map(|(w, b)| w + b);
            let size = Size { rows: b.len(), ..Size::default() };
            let residual = left(w, b);
            census::note_single(Chain::LeastNorm, size, "hold", status_of(residual), residual);
        }
        Ok(forces)
    }

    fn forces(&self, delassus: &Delassus, b: &[f64]) -> Result<Vec<f64>, ResponseError> {
        let n = self.scale.len();
        check_length("Delassus matrix", n, delassus.len())?;
        check_length("constant terms", n, b.len())?;
        check_finite("constant terms", b)?;
        let mut forces = vec![0.0; n];
        for round in 0..ROUNDS {
            let w = if round == 0 { vec![0.0; n] } else { delassus.times(&forces)? };
            let mut correction: Vec<f64> = (0..n).map(|i| -(w[i] + b[i]) * self.scale[i]).collect();
            back_substitute(&self.factor, &mut correction);
            for ((force, change), scale) in forces.iter_mut().zip(&correction).zip(&self.scale) {
                *force += change * scale;
            }
        }
        Ok(forces)
    }
}

/// `1 / sqrt(G_ii)`; zero for a row that nothing can move.
fn unit_diagonal(delassus: &Delassus) -> Vec<f64> {
    (0..delassus.len()).map(|i| inverse_root(delassus.get(i, i))).collect()
}

fn inverse_root(diagonal: f64) -> f64 {
    if diagonal > 0.0 { 1.0 / diagonal.sqrt() } else { 0.0 }
}

/// The packed lower triangle of the factor of a regularised matrix, row by row. Rounding can take at most a few units
/// in the last place from a matrix that is positive semidefinite: pivots are at least `smallest`.
fn cholesky(n: usize, entry: impl Fn(usize, usize) -> f64, smallest: f64) -> Vec<f64> {
    let mut factor: Vec<f64> = Vec::with_capacity(n * (n + 1) / 2);
    for i in 0..n {
        let start = factor.len();
        for j in 0..i {
            let other = &factor[triangle(j)..triangle(j) + j];
            let left = entry(i, j) - dot(&factor[start..], other);
            factor.push(left / factor[triangle(j) + j]);
        }
        let left = entry(i, i) - dot(&factor[start..], &factor[start..]);
        factor.push(left.max(smallest).sqrt());
    }
    factor
}

/// Solves `L L^T x = y` in place.
fn back_substitute(factor: &[f64], y: &mut [f64]) {
    back_substitute_from(factor, y, 0);
}

/// The same where the first `first` entries of `y` are zero: only the later entries of `x` are found.
fn back_substitute_from(factor: &[f64], y: &mut [f64], first: usize) {
    let n = y.len();
    for i in first..n {
        let row = &factor[triangle(i)..=triangle(i) + i];
        y[i] = (y[i] - dot(&row[..i], &y[..i])) / row[i];
    }
    for i in (first..n).rev() {
        let row = &factor[triangle(i)..=triangle(i) + i];
        let value = y[i] / row[i];
        y[i] = value;
        for (entry, rest) in row[first..i].iter().zip(&mut y[first..i]) {
            *rest -= entry * value;
        }
    }
}

/// Least forces that hold rows of a problem.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastNormForces {
    /// One for each row (N; impulses, N s), of either sign.
    pub forces: Vec<f64>,
    /// What they add up to on each body, `J^T f`, in blocks of the problem's width: at large mass ratios only, where
    /// the sum of `forces` would accelerate light bodies by its rounding.
    pub loads: Option<Vec<f64>>,
}

/// The least forces with `w = G f + b = 0` on all rows of `problem`, whose Delassus matrix is `delassus`: those of
/// [`LeastNormHold`] where masses are alike, and in twice the working precision where they are not.
///
/// # Errors
/// When lengths differ, or the matrix or `b` is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn least_norm_forces(
    problem: &ContactProblem,
    delassus: &Delassus,
    b: &[f64],
) -> Result<LeastNormForces, ResponseError> {
    let found = least_forces(problem, delassus, b)?;
    #[cfg(feature = "census")]
    counted(problem, delassus, b, &found)?;
    Ok(found)
}

/// Tells the census, and what forces in working precision would have left where masses differ.
#[cfg(feature = "census")]
#[track_caller]
fn counted(
    problem: &ContactProblem,
    delassus: &Delassus,
    b: &[f64],
    found: &LeastNormForces,
) -> Result<(), ResponseError> {
    let answer = |method, forces: &[f64], loads: Option<&[f64]>| {
        let w = match loads {
            Some(loads) => problem.accelerations_under(b, forces, loads)?,
            None => problem.accelerations(b, forces)?,
        };
        let residual = left(w.iter().copied(), b);
        let (tried, status) = (vec![method], status_of(residual));
        Ok::<_, ResponseError>(Answer { method, tried, status, residual, cost: 1, motion: Vec::new() })
    };
    let loads = found.loads.as_deref();
    let first = answer(if loads.is_some() { "twice the precision" } else { "hold" }, &found.forces, loads)?;
    let again = |without: &[&str]| {
        let is_tried = loads.is_some() && !without.contains(&"hold");
        let forces = LeastNormHold::factor(delassus).and_then(|hold| hold.forces(delassus, b));
        forces.ok().filter(|_| is_tried).and_then(|forces| answer("hold", &forces, None).ok())
    };
    let size = Size { bodies: problem.bodies(), rows: b.len(), cones: 0 };
    census::note(Chain::LeastNorm, size, &first, first.residual, again, || problem.text(None, b));
    Ok(())
}

/// What forces leave of the accelerations without them, relative to the largest.
#[cfg(feature = "census")]
fn left(w: impl Iterator<Item = f64>, b: &[f64]) -> f64 {
    let size = largest(b);
    if size == 0.0 { 0.0 } else { w.fold(0.0, |most, w| nan_max(most, w.abs())) / size }
}

#[cfg(feature = "census")]
fn status_of(residual: f64) -> SolverStatus {
    if residual <= HELD { SolverStatus::Solved } else { SolverStatus::Inaccurate }
}

fn least_forces(problem: &ContactProblem, delassus: &Delassus, b: &[f64]) -> Result<LeastNormForces, ResponseError> {
    check_length("Delassus matrix", problem.len(), delassus.len())?;
    check_length("constant terms", problem.len(), b.len())?;
    check_finite("constant terms", b)?;
    let ratio = problem.mass_ratio();
    if ratio <= ALIKE_MASSES {
        let forces = LeastNormHold::factor(delassus)?.forces(delassus, b)?;
        return Ok(LeastNormForces { forces, loads: None });
    }
    let hold = LeastNormHold::factor_unlike(problem, delassus)?;
    let rows: Vec<usize> = (0..problem.len()).collect();
    let mut forces = vec![DoubleDouble::default(); b.len()];
    let mut correction = vec![0.0; b.len()];
    for _ in 0..rounds(ratio) {
        let loads = precise::loads(problem, &rows, &forces);
        let w = precise::accelerations_under(problem, &rows, b, (&forces, &loads));
        for ((change, w), scale) in correction.iter_mut().zip(&w).zip(&hold.scale) {
            *change = -w * scale;
        }
        back_substitute(&hold.factor, &mut correction);
        for ((force, change), scale) in forces.iter_mut().zip(&correction).zip(&hold.scale) {
            *force = force.plus_product(*change, *scale);
        }
    }
    let loads = precise::loads(problem, &rows, &forces).iter().map(|load| load.value()).collect();
    Ok(LeastNormForces { forces: forces.iter().map(|force| force.value()).collect(), loads: Some(loads) })
}

impl ContactProblem {
    /// Whether the masses that the rows meet differ so little that forces in working precision hold the lightest body
    /// to rounding: by a factor of 256 at most.
    pub fn has_alike_masses(&self) -> bool {
        self.mass_ratio() <= ALIKE_MASSES
    }
}

/// Rounds after which the forces that lift the heaviest body have converged so far that what is missing accelerates the
/// lightest by rounding.
pub(crate) fn rounds(ratio: f64) -> usize {
    let left = FACTOR_ROUNDING / (FACTOR_ROUNDING + SMALLEST_EIGENVALUE / ratio);
    let (mut rounds, mut error) = (1, left);
    while error > CONVERGED / ratio && rounds < MOST_ROUNDS {
        error *= left;
        rounds += 1;
    }
    rounds
}

/// Where row `i` of a packed lower triangle begins.
const fn triangle(i: usize) -> usize {
    i * (i + 1) / 2
}
