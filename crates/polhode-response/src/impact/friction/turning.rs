//! A piece of the path along which the direction of slip turns, as Taylor series.
//!
//! In the variable `s` with `dp_n = r ds`, in units in which the rates of slip are of size 1, the path has polynomial
//! rates without a singularity at zero slip (rates `a`, `g`, `h` of [`Coulomb`]): `d' = h d_perp`, `r' = r g`,
//! `p_n' = r`, `p_t' = -mu r d`, `W_n' = u_n r`, `W_t' = -mu r^2`, and `u_n = u_n- + K_nn p_n + k.p_t`. Slip ends at
//! `s = infinity`, with `r` falling exponentially; once it has fallen to nothing, or the direction has settled, a
//! straight piece goes on.
//!
//! Order and step after Jorba and Zou 2005: at a fifth of the radius of convergence the first term left out is below
//! the rounding unit.

use super::coulomb::Coulomb;
use super::plane::{self, Tangent};
use super::restitution::{Happening, Stage};
use super::root::rising_zero;
use polhode_spatial::rounding;

/// Order of the series.
const ORDER: usize = 24;
/// Step over radius of convergence (no unit): `0.2^24` is below the rounding unit.
const SHARE_OF_RADIUS: f64 = 0.2;

/// Longest step, in units in which the rates of slip are of size 1: for rates that cancel to nothing, whose last
/// coefficients underflow.
const LONGEST: f64 = 64.0;

/// Coefficients of a power series.
type Series = [f64; ORDER + 1];

/// A piece of a path with a direction that turns.
#[derive(Debug, Clone)]
pub(super) struct Turning {
    direction: [Series; 2],
    speed: Series,
    pub(super) normal_velocity: Series,
    /// What is added along the piece: zero at its start.
    pub(super) normal_impulse: Series,
    pub(super) tangential_impulse: [Series; 2],
    pub(super) normal_work: Series,
    pub(super) friction_work: Series,
    /// `du_n/dp_n`.
    normal_rate: Series,
    /// The terms of it, in magnitude.
    normal_rate_terms: f64,
    /// Where the piece ends at the latest.
    step: f64,
}

impl Turning {
    /// The piece that begins with this slip and normal velocity.
    pub(super) fn new(coulomb: &Coulomb, direction: Tangent, speed: f64, normal_velocity: f64) -> Self {
        let zero = [0.0; ORDER + 1];
        let mut piece = Self {
            direction: [zero, zero],
            speed: zero,
            normal_velocity: zero,
            normal_impulse: zero,
            tangential_impulse: [zero, zero],
            normal_work: zero,
            friction_work: zero,
            normal_rate: zero,
            normal_rate_terms: coulomb.normal_rate_terms(),
            step: 0.0,
        };
        piece.direction[0][0] = direction[0];
        piece.direction[1][0] = direction[1];
        piece.speed[0] = speed;
        piece.normal_velocity[0] = normal_velocity;
        piece.expand(coulomb);
        piece.step = piece.length();
        piece
    }

    /// Computes all coefficients from the first ones.
    fn expand(&mut self, coulomb: &Coulomb) {
        let (matrix, mu) = (&coulomb.matrix, coulomb.friction);
        let ([k1, k2], [t11, t12, t22]) = (matrix.coupling, matrix.tangential);
        let (zero, unit) = ([0.0; ORDER + 1], coulomb.slip_rate_terms());
        let (mut turning, mut speed_rate) = (zero, zero);
        for n in 0..=ORDER {
            let [c, s] = &self.direction;
            let [cc, cs, ss] = products([(c, c), (c, s), (s, s)], n);
            turning[n] = k2 * c[n] - k1 * s[n] - mu * (t12 * (cc - ss) + (t22 - t11) * cs);
            speed_rate[n] = k1 * c[n] + k2 * s[n] - mu * (t11 * cc + 2.0 * t12 * cs + t22 * ss);
            self.normal_rate[n] = -mu * (k1 * c[n] + k2 * s[n]);
            if n == 0 {
                self.normal_rate[0] += matrix.normal;
            }
            if n == ORDER {
                break;
            }
            let next = (n + 1) as f64 * unit;
            let r = &self.speed;
            let pairs = [(s, &turning), (c, &turning), (r, c), (r, s), (r, &speed_rate), (r, r)];
            let [turn_c, turn_s, slip_1, slip_2, slowing, square] = products(pairs, n);
            self.direction[0][n + 1] = -turn_c / next;
            self.direction[1][n + 1] = turn_s / next;
            self.speed[n + 1] = slowing / next;
            self.normal_impulse[n + 1] = self.speed[n] / next;
            self.tangential_impulse[0][n + 1] = -mu * slip_1 / next;
            self.tangential_impulse[1][n + 1] = -mu * slip_2 / next;
            let tangential = [self.tangential_impulse[0][n + 1], self.tangential_impulse[1][n + 1]];
            self.normal_velocity[n + 1] =
                matrix.normal * self.normal_impulse[n + 1] + plane::dot(matrix.coupling, tangential);
            let [normal_power] = products([(&self.normal_velocity, &self.speed)], n);
            self.normal_work[n + 1] = normal_power / next;
            self.friction_work[n + 1] = -mu * square / next;
        }
    }

    /// The step that the last two coefficients allow: those of the direction and of the square of the relative speed,
    /// which the works are integrals of.
    fn length(&self) -> f64 {
        let relative = self.speed.map(|coefficient| coefficient / self.speed[0]);
        let radius = |order: usize| {
            let [c, s] = [&self.direction[0], &self.direction[1]].map(|series| series[order].abs());
            let [square] = products([(&relative, &relative)], order);
            libm::pow(c.max(s).max(square.abs()), -1.0 / order as f64)
        };
        (SHARE_OF_RADIUS * radius(ORDER).min(radius(ORDER - 1))).min(LONGEST)
    }

    /// Where the first thing happens, and what it is.
    pub(super) fn first(&self, stage: Stage) -> (f64, Happening) {
        let mut end = self.step;
        // Between zeros of du_n/dp_n the normal velocity rises or falls throughout: at most one end is in such a piece.
        let rounding = rounding::HUNDREDS_OF_TERMS * self.normal_rate_terms;
        if self.normal_rate[0] > rounding && value(&self.normal_rate, end) < -rounding {
            end = first_zero(&negative(&self.normal_rate), 0.0, end);
        }
        let velocity = &self.normal_velocity;
        if matches!(stage, Stage::Compression) {
            if value(velocity, end) >= 0.0 && velocity[0] < 0.0 {
                return (first_zero(velocity, 0.0, end), Happening::CompressionEnds);
            }
            return (end, Happening::PieceEnds);
        }
        let falls = value(velocity, end) < 0.0;
        let last = if falls { first_zero(&negative(velocity), 0.0, end) } else { end };
        let (series, goal) = match stage {
            Stage::Compression => return (end, Happening::PieceEnds),
            Stage::UntilVelocity(goal) => (&self.normal_velocity, goal),
            Stage::ForImpulse(goal) => (&self.normal_impulse, goal),
            Stage::ForWork(goal) => (&self.normal_work, goal),
        };
        if value(series, last) >= goal {
            let mut left = *series;
            left[0] -= goal;
            return (first_zero(&left, 0.0, last), Happening::ImpactEnds);
        }
        if falls { (last, Happening::CompressionBegins) } else { (end, Happening::PieceEnds) }
    }

    /// Direction and speed of slip at a place of the piece.
    pub(super) fn slip(&self, at: f64) -> (Tangent, f64) {
        let direction = [value(&self.direction[0], at), value(&self.direction[1], at)];
        (plane::direction(direction).unwrap_or(direction), value(&self.speed, at))
    }
}

/// Coefficient `n` of the products of pairs of series. All sums run at once: one alone waits for each of its additions.
fn products<const PAIRS: usize>(pairs: [(&Series, &Series); PAIRS], n: usize) -> [f64; PAIRS] {
    let lines = pairs.map(|(a, b)| (&a[..=n], &b[..=n]));
    // Empty sums of floating-point numbers begin with -0.
    let mut sums = [-0.0; PAIRS];
    for k in 0..=n {
        for (sum, (a, b)) in sums.iter_mut().zip(&lines) {
            *sum += a[k] * b[n - k];
        }
    }
    sums
}

/// The sum of a series.
pub(super) fn value(series: &Series, at: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, coefficient| sum * at + coefficient)
}

fn negative(series: &Series) -> Series {
    series.map(|coefficient| -coefficient)
}

/// Where a series that is negative at `low` and not at `high` has its zero.
fn first_zero(series: &Series, low: f64, high: f64) -> f64 {
    let slope = |at: f64| (1..=ORDER).rev().fold(0.0, |sum, n| sum * at + n as f64 * series[n]);
    rising_zero(|at| (value(series, at), slope(at)), low, high)
}
