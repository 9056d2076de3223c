//! Stronge's energetic law for several contacts without friction: each contact gives back `e^2` of the work that it
//! took.
//!
//! Compression: the inelastic impact `0 <= u_c _|_ p_c >= 0`, `u_c = u- + G p_c`, along the straight way from `u-` to
//! `u_c`, on which row `i` takes the work `W_i = -p_c,i (u_i- + u_c,i)/2` (J). Expansion: the impulses go on growing in
//! the ratios of the compression, `dp_i = p_c,i ds`, and each row for itself ends as soon as it has given back
//! `e_i^2 W_i`; the others go on. What a row takes again meanwhile, pushed by the others, adds to its `W_i`. The
//! velocities are linear and the works quadratic in `s` between two ends, so that each end is the root of a quadratic.
//! What approaches afterwards, pushed by rows that ended later, is compressed and expands in another round. Where rows
//! that separate are closed by the others, the compression does positive work there; it has come from the rows that
//! took work, each of which has less to give back in proportion.
//!
//! Energy: `dT = -sum (1 - e_i^2) W_i <= 0` for every contact by itself, whatever the restitutions; the restitution is
//! taken away only where rounding of rows that contradict each other would raise the energy. With one `e` all rows end
//! at `s = e`: this is Poisson's law and Newton's then. They differ where `e` does.
//!
//! Assumption: the straight way, which is that of contacts of stiffness in proportion. Rounds may not end where bodies
//! are squeezed between others; they are given up then ([`ImpactStatus::LimitReached`]) and what approaches is stopped
//! inelastically.
//!
//! Source: Stronge 1990, for one contact; the extension to several is derived here.

use super::finish::Impact;
use super::outcome::{ImpactOutcome, ImpactStatus};
use crate::dense::scalar::Scalar;
use polhode_spatial::rounding;

/// Longest expansion, in lengths of the compression (no unit, 4 to 100): with one restitution it is `e`. Rows that
/// hardly open would go on without bound, and are ended with less than they may give.
const LONGEST_EXPANSION: f64 = 16.0;

/// Most rounds; those that end at all take fewer (16 to 256).
const ROUNDS: usize = 64;

/// Compresses and expands until no row approaches.
pub(super) fn energetic(impact: &mut Impact<'_>, restitution: &[f64]) -> ImpactOutcome {
    let mut outcome = ImpactOutcome { status: ImpactStatus::Separated, ..impact.nothing() };
    let mut velocities = impact.problem.u_before.to_vec();
    let joints = impact.joints();
    let mut impulses = vec![0.0; velocities.len()];
    impact.stop_joints(&joints, &mut velocities, &mut impulses, &mut outcome);
    outcome.impulses = impulses;
    let rows: Vec<usize> = (0..velocities.len()).collect();
    let mut round = 0;
    while velocities.iter().enumerate().any(|(row, &u)| impact.is_violated(row, u)) {
        if round >= ROUNDS.min(impact.problem.settings.limit) {
            outcome.status = ImpactStatus::LimitReached;
            break;
        }
        round += 1;
        let noise = impact.noise(&outcome.impulses);
        let solved = impact.solve(&rows, &velocities, noise, &mut outcome);
        if outcome.status == ImpactStatus::NotSolved {
            break;
        }
        for (total, amount) in outcome.impulses.iter_mut().zip(&solved.amounts) {
            *total += amount;
        }
        let mut expansion = Expansion::after(impact, (&velocities, restitution), &solved.amounts, solved.w);
        expansion.run(impact, &joints, &mut outcome);
        velocities = expansion.velocities;
    }
    impact.conclude(velocities, &mut outcome);
    outcome
}

/// The expansion of one round.
struct Expansion {
    /// Of all rows, m/s.
    velocities: Vec<f64>,
    /// `dp/ds` of each row, N s: zero of rows that have ended.
    growth: Vec<f64>,
    /// `du/ds` of each row, m/s.
    rates: Vec<f64>,
    /// What each row may still give back, J.
    left: Vec<f64>,
    /// What each row has taken, J.
    taken: Vec<f64>,
    /// `e^2` of each row.
    share: Vec<f64>,
    /// A velocity below this is zero, m/s.
    zero: f64,
}

impl Expansion {
    /// After a compression from `before` to `compressed` by the impulses `amounts`.
    fn after(
        impact: &Impact<'_>,
        (before, restitution): (&[f64], &[f64]),
        amounts: &[f64],
        compressed: Vec<f64>,
    ) -> Self {
        let rows = before.len();
        let mut expansion = Self {
            rates: compressed.iter().zip(before).map(|(after, before)| after - before).collect(),
            growth: amounts.to_vec(),
            left: vec![0.0; rows],
            taken: vec![0.0; rows],
            share: vec![0.0; rows],
            zero: f64::ROUNDING * impact.tolerance / impact.problem.settings.threshold.max(f64::EPSILON),
            velocities: compressed,
        };
        let works: Vec<f64> = (0..rows)
            .map(|row| {
                let mean = 0.5 * (before[row] + expansion.velocities[row]);
                if impact.problem.is_bilateral(row) { 0.0 } else { -amounts[row] * mean }
            })
            .collect();
        let (all, taken): (f64, f64) = (works.iter().sum(), works.iter().map(|work| work.max(0.0)).sum());
        let part = if taken > 0.0 { (all / taken).clamp(0.0, 1.0) } else { 0.0 };
        for row in 0..rows {
            let e = impact.restitution(restitution, row);
            expansion.share[row] = e * e;
            expansion.taken[row] = part * works[row].max(0.0);
            expansion.left[row] = e * e * expansion.taken[row];
        }
        expansion
    }

    /// Lets all rows give back what they may.
    fn run(&mut self, impact: &mut Impact<'_>, joints: &[usize], outcome: &mut ImpactOutcome) {
        // Each row ends once, and turns from closing to opening at most once between two ends.
        let most = (self.velocities.len() + 1) * (self.velocities.len() + 1);
        let mut total = 0.0;
        for _ in 0..most {
            while self.end_spent(impact) {
                self.direct(impact, joints, outcome);
            }
            let Some(length) = self.next_end(impact) else { break };
            self.go(impact, length.min(LONGEST_EXPANSION - total), outcome);
            total += length;
            if total >= LONGEST_EXPANSION {
                break;
            }
        }
    }

    /// Whether a row is a contact that still expands.
    fn expands(&self, impact: &Impact<'_>, row: usize) -> bool {
        self.growth[row] > 0.0 && !impact.problem.is_bilateral(row)
    }

    /// Ends the rows that have nothing left and open. Returns whether there were any.
    fn end_spent(&mut self, impact: &Impact<'_>) -> bool {
        let fastest = self.rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
        let opens = |row: usize| {
            let u = self.velocities[row];
            u > self.zero || (u >= -self.zero && self.rates[row] > f64::ROUNDING * fastest)
        };
        let spent = |row: &usize| {
            self.expands(impact, *row)
                && self.left[*row] <= rounding::HUNDREDS_OF_TERMS * self.taken[*row]
                && opens(*row)
        };
        let ended: Vec<usize> = (0..self.growth.len()).filter(spent).collect();
        for &row in &ended {
            self.growth[row] = 0.0;
        }
        !ended.is_empty()
    }

    /// Finds the rates of velocity for the rows that still expand, with all joints held.
    fn direct(&mut self, impact: &mut Impact<'_>, joints: &[usize], outcome: &mut ImpactOutcome) {
        for &joint in joints {
            self.growth[joint] = 0.0;
        }
        let rows: Vec<usize> = (0..self.growth.len()).collect();
        self.rates.fill(0.0);
        impact.advance(&mut self.rates, &rows, &self.growth);
        if joints.is_empty() || self.growth.iter().all(|growth| *growth == 0.0) {
            return;
        }
        let pulled: Vec<f64> = joints.iter().map(|&joint| self.rates[joint]).collect();
        let held = impact.solve(joints, &pulled, 0.0, outcome);
        impact.advance(&mut self.rates, joints, &held.amounts);
        for (&joint, amount) in joints.iter().zip(&held.amounts) {
            self.growth[joint] = *amount;
            self.rates[joint] = 0.0;
        }
    }

    /// How far it is to the next end: where a row has given back all that it may, or stops closing. None where no row
    /// expands, or none ever ends.
    fn next_end(&self, impact: &Impact<'_>) -> Option<f64> {
        let end = |row: usize| {
            let (u, rate, left) = (self.velocities[row], self.rates[row], self.left[row] / self.growth[row]);
            if u < -self.zero {
                return (rate > 0.0).then(|| -u / rate);
            }
            // u s + rate s^2/2 = left/growth, the positive root without cancellation.
            let u = u.max(0.0);
            let root = u * u + 2.0 * rate * left;
            (root >= 0.0 && left > 0.0).then(|| 2.0 * left / (u + root.sqrt()))
        };
        let rows = (0..self.growth.len()).filter(|&row| self.expands(impact, row));
        rows.filter_map(end).filter(|length| length.is_finite()).reduce(f64::min)
    }

    /// Goes on by a length.
    fn go(&mut self, impact: &Impact<'_>, length: f64, outcome: &mut ImpactOutcome) {
        for row in 0..self.growth.len() {
            let (before, after) = (self.velocities[row], self.velocities[row] + length * self.rates[row]);
            self.velocities[row] = after;
            let impulse = length * self.growth[row];
            outcome.impulses[row] += impulse;
            if self.expands(impact, row) {
                let work = 0.5 * impulse * (before + after);
                if work < 0.0 {
                    self.taken[row] -= work;
                    self.left[row] -= self.share[row] * work;
                } else {
                    self.left[row] = (self.left[row] - work).max(0.0);
                }
            }
        }
    }
}
