//! The active set: a primal method for `0 <= f _|_ w = G f + b >= 0` with `G` positive semidefinite.
//!
//! State: the set `P` of rows that carry force, with `G_PP` nonsingular and `w_P = 0`, `f >= 0`. Starting from a guess
//! of `P`, one violated row `j` (`w_j < 0`) at a time is pushed: `f_j` grows, `f_P` follows so that `w_P` stays 0
//! (direction `d = -G_PP^-1 G_Pj`), until `w_j = 0` (`j` joins `P`) or a force of `P` reaches zero (it leaves, and the
//! push goes on). `w_j` rises with the rate of the Schur complement `s = G_jj - G_jP G_PP^-1 G_Pj`; where `s` is zero
//! to rounding the row depends on `P`, and only an exchange is possible: the factor stays well-conditioned and
//! singular `G` needs no regularisation. Each push lowers `1/2 f.G f + b.f`, so the method ends; pushes of length zero
//! (degenerate rows) fall back to the rule of least index.
//!
//! A push that nothing stops is a ray `z = (d, 1) >= 0` with `G z = 0` and `b.z = w_j < 0`: the certificate of Farkas
//! that no forces keep every row from approaching.
//!
//! Source: Dantzig's and van de Panne and Whinston's principal pivoting in the form of Lawson and Hanson's NNLS;
//! Baraff 1994; Goldfarb and Idnani 1983 (the dual view); least index: Chang 1979 in Cottle, Pang and Stone. Failure:
//! what working precision cannot decide ends a run as [`Outcome::Doubtful`], to be repeated in twice the precision; a
//! limit of pivots ends all loops, also for NaN.

use super::rank::{Dependence, Image, Rank, SAFE_PIVOT};
use crate::certificate::row_accelerations;
use crate::dense::cholesky::GrowingCholesky;
use crate::dense::kernels::{dot, largest};
use crate::dense::scalar::Scalar;
use crate::precise;
use crate::settings::SolverSettings;
use crate::tolerances::TRUSTED_PIVOT;

/// A Schur complement above this fraction of the diagonal is independent without a closer look (no unit).
const CLEARLY_INDEPENDENT: f64 = 1e-6;

/// Corrections of a direction before its row is called doubtful: the first leaves rounding where the factor is good
/// to 1e-8, the second is for factors that have shrunk and grown many times.
const CORRECTIONS: usize = 2;

/// Multiple of the noise floor that passes for noise where rows depend on each other (no unit): that of several rows
/// adds up.
pub(crate) const NOISE_ALLOWED: f64 = 8.0;

/// However ill-conditioned the factor is, rates above this fraction of the largest are real (no unit); what that gets
/// wrong shows in the residual.
const LARGEST_RATE_ROUNDING: f64 = 1e-3;

/// Pivots that are allowed whatever the number of rows.
const FREE_PIVOTS: usize = 100;

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// No row is violated.
    Converged,
    /// The same, and the answer is within the acceptance.
    Accepted,
    /// A push that nothing stops: [`ActiveSet::ray`] shows that there are no forces.
    Infeasible,
    /// Working precision cannot tell.
    Doubtful,
    /// Too many pivots.
    PivotLimit,
}

/// What happened to a pushed row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Push {
    Joined,
    Dropped,
    Infeasible,
    Doubtful,
    OverLimit,
}

/// The method with its memory; [`run`](Self::run) may be called again and again.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActiveSet<T = f64> {
    factor: GrowingCholesky<T>,
    /// `P` in the order of the factor.
    rows: Vec<usize>,
    member: Vec<bool>,
    /// Rows that are squeezed within rounding and left alone.
    ignored: Vec<bool>,
    pub(crate) forces: Vec<T>,
    pub(crate) w: Vec<T>,
    direction: Vec<T>,
    line: Vec<T>,
    correction: Vec<T>,
    image: Image,
    weights: Vec<f64>,
    /// After [`Outcome::Infeasible`]: forces that move nothing and that the constant terms outweigh, the largest 1.
    pub(crate) ray: Vec<f64>,
    pub(crate) pivots: usize,
    stalled: usize,
}

/// The problem of one run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Problem<'a, T = f64> {
    /// `G`, row-major and symmetric.
    pub(crate) matrix: &'a [T],
    /// `b`.
    pub(crate) constant: &'a [T],
    /// Which rows are bilateral: `w = 0` and a force of either sign; none when empty.
    pub(crate) bilateral: &'a [bool],
    /// How ranks are decided.
    pub(crate) rank: Rank<'a>,
    /// A row that cannot be held, violated by less than this fraction of its terms, is left alone as rounding of the
    /// data (no unit); the residual reports it.
    pub(crate) squeeze_rounding: f64,
    /// Tolerances.
    pub(crate) settings: &'a SolverSettings,
}

impl<T: Scalar> Problem<'_, T> {
    fn size(&self) -> usize {
        self.constant.len()
    }

    fn at(&self, row: usize, column: usize) -> T {
        self.matrix[row * self.size() + column]
    }

    fn diagonal(&self, row: usize) -> f64 {
        self.at(row, row).to_f64()
    }

    fn is_bilateral(&self, row: usize) -> bool {
        self.bilateral.get(row).copied().unwrap_or(false)
    }

    /// A force, or zero when it is that of a contact and pulls.
    fn admitted(&self, row: usize, force: T) -> T {
        if self.is_bilateral(row) { force } else { force.or_zero() }
    }
}

impl<T: Scalar> ActiveSet<T> {
    /// The rows that carry force, in the order in which they entered.
    pub(crate) fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// Solves the problem, starting from the guess that `start` carries the forces.
    pub(crate) fn run(&mut self, problem: Problem<'_, T>, start: &[usize]) -> Outcome {
        let size = problem.size();
        self.prepare(problem);
        self.establish(problem, start);
        let limit = (problem.settings.pivots_per_row as usize).saturating_mul(size).saturating_add(FREE_PIVOTS);
        // Pushes in a row share one refinement: it is needed only before the end.
        let mut refined = false;
        loop {
            if let Some(row) = self.most_violated(problem) {
                refined = false;
                match self.push(problem, row, limit) {
                    Push::Infeasible => return Outcome::Infeasible,
                    Push::Doubtful => return Outcome::Doubtful,
                    Push::OverLimit => return Outcome::PivotLimit,
                    Push::Joined | Push::Dropped => {}
                }
            } else if refined {
                return Outcome::Converged;
            } else {
                self.refine(problem);
                refined = true;
            }
        }
    }

    fn prepare(&mut self, problem: Problem<'_, T>) {
        let size = problem.size();
        self.factor.reset(size);
        self.rows.clear();
        self.member.clear();
        self.member.resize(size, false);
        self.ignored.clear();
        self.ignored.resize(size, false);
        self.forces.clear();
        self.forces.resize(size, T::default());
        self.w.clear();
        self.w.resize(size, T::default());
        self.ray.clear();
        self.weights.clear();
        // Violations are compared in the energy norm: w_i / sqrt(G_ii).
        self.weights.extend((0..size).map(|i| 1.0 / problem.diagonal(i).max(f64::MIN_POSITIVE).sqrt()));
        self.pivots = 0;
        self.stalled = 0;
    }

    /// Factorises the independent rows of a guess, drops those whose forces would pull, and sets the forces.
    fn establish(&mut self, problem: Problem<'_, T>, start: &[usize]) {
        // Bilateral rows come first and never leave: those that depend on others depend on bilateral ones alone.
        let joints: Vec<usize> = (0..problem.size()).filter(|&row| problem.is_bilateral(row)).collect();
        let mut guess = joints.clone();
        guess.extend(start.iter().copied().filter(|&row| row < problem.size()));
        loop {
            for &row in &guess {
                if !self.member[row] {
                    let pivot = self.schur_complement(problem, row);
                    let clear = is_clear(problem, row, pivot);
                    if !clear {
                        self.solve_direction();
                    }
                    if clear || self.stands_out(problem, row, pivot) {
                        self.join(row, pivot);
                    }
                }
            }
            self.direction.clear();
            self.direction.extend(self.rows.iter().map(|&row| -problem.constant[row]));
            self.factor.solve(&mut self.direction);
            let pushes = |row: usize, force: T| problem.is_bilateral(row) || force >= T::default();
            if self.rows.iter().zip(&self.direction).all(|(&row, &force)| pushes(row, force)) {
                for (&row, &force) in self.rows.iter().zip(&self.direction) {
                    self.forces[row] = force;
                }
                row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
                return;
            }
            guess.clear();
            guess.extend(
                self.rows.iter().zip(&self.direction).filter(|(row, f)| pushes(**row, **f)).map(|(&row, _)| row),
            );
            self.pivots += self.rows.len() - guess.len();
            self.factor.reset(problem.size());
            for &row in &self.rows {
                self.member[row] = false;
            }
            self.rows.clear();
        }
    }

    /// One step of iterative refinement of `w_P = 0`, then `w` of all rows afresh.
    fn refine(&mut self, problem: Problem<'_, T>) {
        self.direction.clear();
        self.direction.extend(self.rows.iter().map(|&row| -self.w[row]));
        self.factor.solve(&mut self.direction);
        for (&row, &correction) in self.rows.iter().zip(&self.direction) {
            self.forces[row] = problem.admitted(row, self.forces[row] + correction);
        }
        row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
    }

    /// The row to push: the most violated in the energy norm, or the first violated one while there is no progress.
    fn most_violated(&self, problem: Problem<'_, T>) -> Option<usize> {
        let least_index = self.stalled > 2 * problem.size();
        let mut best: Option<(usize, f64)> = None;
        for row in 0..problem.size() {
            let violation = -self.w[row].to_f64() * self.weights[row];
            let candidate = violation > 0.0 && !self.member[row] && !problem.is_bilateral(row);
            if candidate && best.is_none_or(|(_, most)| violation > most) && self.is_violated(problem, row) {
                if least_index {
                    return Some(row);
                }
                best = Some((row, violation));
            }
        }
        best.map(|(row, _)| row)
    }

    fn is_violated(&self, problem: Problem<'_, T>, row: usize) -> bool {
        let SolverSettings { tolerance, noise_floor, .. } = *problem.settings;
        // The terms may have shrunk since a row was left alone.
        let (tolerance, noise_floor) = if self.ignored[row] {
            (problem.squeeze_rounding, NOISE_ALLOWED * noise_floor)
        } else {
            (tolerance, noise_floor)
        };
        let depth = -self.w[row].to_f64() - noise_floor;
        depth > tolerance * problem.constant[row].to_f64().abs() && depth > tolerance * self.scale(problem, row)
    }

    /// `W_i = |b_i| + sum_k |G_ik| f_k`.
    fn scale(&self, problem: Problem<'_, T>, row: usize) -> f64 {
        let own = problem.constant[row].to_f64().abs() + problem.diagonal(row) * self.forces[row].to_f64().abs();
        let others = self.rows.iter().filter(|&&k| k != row);
        own + others.map(|&k| (problem.at(row, k).to_f64() * self.forces[k].to_f64()).abs()).sum::<f64>()
    }

    /// Raises the force of `row` until it is held or its force is back at zero.
    fn push(&mut self, problem: Problem<'_, T>, row: usize, limit: usize) -> Push {
        loop {
            self.pivots += 1;
            if self.pivots > limit {
                return Push::OverLimit;
            }
            let pivot = self.schur_complement(problem, row);
            self.solve_direction();
            let full = match self.dependence(problem, row, pivot) {
                Dependence::Independent => Some((-self.w[row] / pivot).or_zero()),
                Dependence::Dependent => None,
                Dependence::Doubtful => return Push::Doubtful,
            };
            let (step, blocking) = self.longest_step(problem, full);
            let Some(step) = step else {
                return self.unstoppable(problem, row);
            };
            let present = largest(&self.forces) + problem.constant[row].to_f64().abs() / problem.diagonal(row);
            self.stalled = if step.to_f64() > f64::ROUNDING * present { 0 } else { self.stalled + 1 };
            self.forces[row] = self.forces[row] + step;
            for (&other, &change) in self.rows.iter().zip(&self.direction) {
                self.forces[other] = problem.admitted(other, self.forces[other] + step * change);
            }
            let Some(position) = blocking else {
                self.join(row, pivot);
                row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
                return Push::Joined;
            };
            self.leave(position);
            self.w[row] = problem.constant[row] + dot(&problem.matrix[row * problem.size()..], &self.forces);
            if self.forces[row] == T::default() && !self.is_violated(problem, row) {
                row_accelerations(problem.matrix, problem.constant, &self.forces, &mut self.w);
                return Push::Dropped;
            }
        }
    }

    /// The longest step along the direction up to `full`, none when nothing limits it, and the position in `P` of the
    /// force that stops it.
    fn longest_step(&self, problem: Problem<'_, T>, full: Option<T>) -> (Option<T>, Option<usize>) {
        let least_index = self.stalled > 2 * self.forces.len();
        let steepest = self.rate_rounding(problem);
        let (mut longest, mut stopping): (Option<T>, Option<usize>) = (full, None);
        for (position, (&row, &rate)) in self.rows.iter().zip(&self.direction).enumerate() {
            if rate.to_f64() < -steepest * self.weights[row] && !problem.is_bilateral(row) {
                let step = self.forces[row] / -rate;
                let tie_won = |other: usize| {
                    if least_index { row < self.rows[other] } else { rate < self.direction[other] }
                };
                let better =
                    longest.is_none_or(|best| step < best) || (longest == Some(step) && stopping.is_some_and(tie_won));
                if better {
                    (longest, stopping) = (Some(step), Some(position));
                }
            }
        }
        (longest, stopping)
    }

    /// The part of a rate that may be rounding of zero, in the energy norm, `|d_k| sqrt(G_kk)`: that of the largest
    /// rate, enlarged as much as the factor may have done it.
    fn rate_rounding(&self, problem: Problem<'_, T>) -> f64 {
        let rates = self.rows.iter().zip(&self.direction).map(|(&row, d)| d.to_f64().abs() / self.weights[row]);
        let pivots = self.rows.iter().zip(self.factor.pivots()).map(|(&row, pivot)| pivot / problem.diagonal(row));
        let share = (T::ROUNDING / pivots.fold(1.0, f64::min)).min(LARGEST_RATE_ROUNDING);
        share * rates.fold(0.0, f64::max)
    }

    /// Nothing stops the push of a dependent row: bodies are squeezed, truly or by rounding of the data.
    fn unstoppable(&mut self, problem: Problem<'_, T>, row: usize) -> Push {
        let depth = -self.w[row].to_f64() - NOISE_ALLOWED * problem.settings.noise_floor;
        if depth <= problem.squeeze_rounding * self.scale(problem, row) {
            self.ignored[row] = true;
            return Push::Dropped;
        }
        if matches!(problem.rank, Rank::Motion(_)) {
            return Push::Doubtful;
        }
        let balance = self.rows.iter().zip(&self.direction);
        let balance =
            balance.fold(problem.constant[row], |sum, (&k, &d)| sum + problem.constant[k] * problem.admitted(k, d));
        if balance.to_f64() >= 0.0 {
            return Push::Doubtful;
        }
        let (size, steepest) = (largest(&self.direction).max(1.0), self.rate_rounding(problem));
        self.ray.resize(problem.size(), 0.0);
        self.ray[row] = 1.0 / size;
        for (&k, d) in self.rows.iter().zip(&self.direction) {
            let rate = if problem.is_bilateral(k) { d.to_f64().abs() } else { d.to_f64() };
            let rounding = rate <= steepest * self.weights[k];
            self.ray[k] = if rounding { 0.0 } else { d.to_f64() / size };
        }
        Push::Infeasible
    }

    /// Puts `L^-1 G_Pj` into `line` and returns the Schur complement of row `j`.
    fn schur_complement(&mut self, problem: Problem<'_, T>, row: usize) -> T {
        let column = &problem.matrix[row * problem.size()..(row + 1) * problem.size()];
        self.line.clear();
        self.line.extend(self.rows.iter().map(|&k| column[k]));
        self.factor.solve_lower(&mut self.line);
        problem.at(row, row) - dot(&self.line, &self.line)
    }

    /// Whether row `row` depends on `P`, for the current direction, which is corrected on the way.
    fn dependence(&mut self, problem: Problem<'_, T>, row: usize, pivot: T) -> Dependence {
        if is_clear(problem, row, pivot) || self.stands_out(problem, row, pivot) {
            return Dependence::Independent;
        }
        let Rank::Motion(motion) = problem.rank else {
            return Dependence::Dependent;
        };
        let mut image = std::mem::take(&mut self.image);
        let mut found = Dependence::Doubtful;
        for round in 0..=CORRECTIONS {
            let direction = self.rows.iter().zip(&self.direction).map(|(&k, d)| (k, d.to_f64()));
            let distance = motion.distance(direction.chain([(row, 1.0)]), &mut image);
            if distance <= motion.cut * self.terms(problem, row) {
                found = Dependence::Dependent;
                break;
            }
            if round < CORRECTIONS {
                self.correction.clear();
                self.correction.extend(self.rows.iter().map(|&k| T::from_f64(-motion.acceleration(k, &image))));
                self.factor.solve(&mut self.correction);
                for (d, change) in self.direction.iter_mut().zip(&self.correction) {
                    *d = *d + *change;
                }
            }
        }
        self.image = image;
        found
    }

    /// Whether the Schur complement stands out of the rounding of the terms that cancel in it.
    fn stands_out(&self, problem: Problem<'_, T>, row: usize, pivot: T) -> bool {
        // s = z.G z with z = (d, 1): the rounding of G enters with the square of sum |z_i| sqrt(G_ii).
        let size = self.terms(problem, row);
        let cut = match problem.rank {
            Rank::Pivot(cut) => cut,
            Rank::Motion(_) => SAFE_PIVOT,
        };
        pivot.to_f64() > cut * size * size
    }

    /// `sum_i |z_i| sqrt(G_ii)` with `z = (d, 1)`.
    fn terms(&self, problem: Problem<'_, T>, row: usize) -> f64 {
        let terms = self.rows.iter().zip(&self.direction);
        let terms = terms.map(|(&k, d)| d.to_f64().abs() * problem.diagonal(k).sqrt());
        problem.diagonal(row).sqrt() + terms.sum::<f64>()
    }

    /// `d = -L^-T line = -G_PP^-1 G_Pj`.
    fn solve_direction(&mut self) {
        self.direction.clear();
        self.direction.extend(self.line.iter().map(|&value| -value));
        self.factor.solve_upper(&mut self.direction);
    }

    fn join(&mut self, row: usize, pivot: T) {
        self.factor.push(&self.line, pivot);
        self.rows.push(row);
        self.member[row] = true;
    }

    fn leave(&mut self, position: usize) {
        self.factor.remove(position);
        let row = self.rows.remove(position);
        self.member[row] = false;
        self.forces[row] = T::default();
    }
}

impl<T: Scalar> ActiveSet<T> {
    /// `y = G_PP^-1 r` and `|L^-1 r| = sqrt(r.y)`, in the order of [`rows`](Self::rows). None when the factor is too
    /// ill-conditioned for that to be relied on.
    pub(crate) fn absorbed(&self, problem: Problem<'_, T>, residual: &[f64]) -> Option<(Vec<f64>, f64)> {
        let mut pivots = self.rows.iter().zip(self.factor.pivots());
        let trusted = TRUSTED_PIVOT * (T::ROUNDING / f64::ROUNDING);
        if !pivots.all(|(&row, pivot)| pivot > trusted * problem.diagonal(row)) {
            return None;
        }
        let mut y: Vec<T> = residual.iter().map(|&r| T::from_f64(r)).collect();
        self.factor.solve_lower(&mut y);
        // Scaled by the largest, so that squares of roundings do not vanish.
        let size = largest(&y);
        let squares = y.iter().map(|value| (value.to_f64() / size) * (value.to_f64() / size));
        let length = if size > 0.0 { size * squares.sum::<f64>().sqrt() } else { size };
        self.factor.solve_upper(&mut y);
        Some((y.iter().map(|value| value.to_f64()).collect(), length))
    }
}

/// Whether a Schur complement needs no closer look.
fn is_clear<T: Scalar>(problem: Problem<'_, T>, row: usize, pivot: T) -> bool {
    pivot.to_f64() > CLEARLY_INDEPENDENT * problem.diagonal(row)
}

impl ActiveSet {
    /// Whether the factor asks for refinement in twice the working precision.
    pub(crate) fn wants_precision(&self, matrix: &[f64]) -> bool {
        let size = self.forces.len();
        let largest_diagonal = self.rows.iter().map(|&row| matrix[row * size + row]).fold(0.0, f64::max);
        precise::is_worth_it(largest_diagonal, self.factor.smallest_pivot())
    }

    /// One step of iterative refinement with accelerations that the caller has found in twice the precision. `false`
    /// when a force would pull by more than rounding of zero: then nothing is changed.
    pub(crate) fn correct(&mut self, w: &[f64], bilateral: &[bool]) -> bool {
        let is_bilateral = |row: usize| bilateral.get(row).copied().unwrap_or(false);
        self.direction.clear();
        self.direction.extend(self.rows.iter().map(|&row| -w[row]));
        self.factor.solve(&mut self.direction);
        let pushing = |(&row, change): (&usize, &f64)| {
            is_bilateral(row) || self.forces[row] + change >= -f64::ROUNDING * self.forces[row]
        };
        if !self.rows.iter().zip(&self.direction).all(pushing) {
            return false;
        }
        for (&row, change) in self.rows.iter().zip(&self.direction) {
            let force = self.forces[row] + change;
            self.forces[row] = if is_bilateral(row) { force } else { force.max(0.0) };
        }
        true
    }
}
