//! The pulse law: the contacts are springs that spend what they have taken, while the bodies stand still (Liu, Zhao and
//! Brogliato).
//!
//! Each contact stores the energy `E_i` of a spring of stiffness `K` and exponent `eta` (1: linear; 3/2: Hertz), all of the
//! same `K`. Impulses grow in the ratios of the forces,
//!
//! `dp_i/dp_j = (E_i/E_j)^(eta/(1 + eta))`, `dE_i = -u_i dp_i` while it closes, `dE_i = -u_i dp_i/e_i^2` while it opens,
//!
//! with `u = u- + G p` (m/s, 1/kg, N s), and the impact ends when all energies are spent and nothing approaches. In the
//! indentation `d_i`, `E_i = K d_i^(1 + eta)/(1 + eta)`, this is `dd_i = -c_i u_i dt`, `dp_i = K d_i^eta dt` with `c_i = 1`
//! while it closes and `1/e_i^2` while it opens: no start from 0/0, and each contact may be compressed many times. `K` cancels.
//!
//! Unlike the laws of complementarity it says how momentum spreads: one ball into a row of linear or of Hertzian contacts does
//! not send one ball out alone. Energy: `dT = -sum_i (1 - e_i^2) W_i <= 0`, with `W_i` the work that contact `i` took.
//!
//! Method: the equations by Dormand and Prince's pair of orders 5 and 4, with steps by the estimated error (relative to the
//! largest approach and inverse mass, [`STEP_ERROR`]), which cut themselves short where a contact opens or turns. Joints are held
//! throughout: their reaction to an impulse at each contact is found once. A contact that is struck alone has the closed form
//! of equation (14).
//!
//! Assumption: no friction, and stiffness the same at all contacts. Restitution below [`NO_REBOUND`] gives nothing back; such
//! contacts may be compressed again without end, so that what is left below [`END_WITHOUT_REBOUND`] of the approach is stopped
//! inelastically.
//! How it fails: contacts that lose energy while others press on them are compressed again and again; squeezed bodies, or many
//! contacts with little restitution, take more than [`MOST_STEPS`] steps so: the rest is stopped inelastically
//! and the status is [`ImpactStatus::LimitReached`].
//!
//! Source: Liu, Zhao and Brogliato 2008; Dormand and Prince 1980.

use super::finish::Impact;
use super::impact_problem::ImpactProblem;
use super::outcome::{ImpactOutcome, ImpactStatus};
use super::single_contact_impulse;
use crate::complementarity::ComplementaritySolver;
use crate::error::ResponseError;

/// The exponent of the springs of the contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum PulseExponent {
    /// `eta = 1`: force in proportion to indentation.
    Linear,
    /// `eta = 3/2`: Hertz, for curved surfaces.
    #[default]
    Hertz,
}

impl PulseExponent {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Hertz => "hertz",
        }
    }

    /// Force of an indentation, in units of `K`; no force where the bodies are apart.
    fn force(self, indentation: f64) -> f64 {
        let indentation = indentation.max(0.0);
        match self {
            Self::Linear => indentation,
            Self::Hertz => indentation * indentation.sqrt(),
        }
    }
}

/// Error of a step, in units of the indentation that the approach reaches (no unit, 1e-13 to 1e-9).
const STEP_ERROR: f64 = 1e-12;

/// An approach below this part of the first one is over (no unit): above the error of the steps.
const SPENT_APPROACH: f64 = 1e-10;

/// The same where a contact has no restitution (no unit, 1e-6 to 1e-3): what is left is stopped inelastically, as such a contact
/// would do by itself in ever smaller compressions.
const END_WITHOUT_REBOUND: f64 = 1e-4;

/// An indentation below this, in units of that which the approach reaches, is none (no unit).
const NO_INDENTATION: f64 = 1e-13;

/// Restitution below this gives nothing back (no unit): the springs that open would be `1/e^2` times as stiff.
const NO_REBOUND: f64 = 2e-2;

/// A contact without restitution has stopped when it approaches by less than this part of the first approach (no unit): its force
/// ends there, and steps that only came near would come no nearer.
const STOPPED: f64 = 1e-9;

/// Most steps of an impact (1e4 to 1e5).
const MOST_STEPS: usize = 20_000;

/// Shortest step, in units of the time of a pulse (no unit): where forces jump, error control would go on below it.
const SHORTEST_PULSE_STEP: f64 = 1e-13;

/// First step and longest one, in the same units: a pulse takes about 3.
const FIRST_PULSE_STEP: f64 = 1e-3;
const LONGEST_PULSE_STEP: f64 = 0.1;

/// By how much a step may become longer or shorter than the one before (no unit), and its margin.
const STEP_GROWTH: [f64; 2] = [0.1, 5.0];
const STEP_MARGIN: f64 = 0.9;

/// Resolves an impact by springs at the touching contacts.
///
/// # Errors
/// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
pub fn pulse(
    problem: &ImpactProblem<'_>,
    solver: &mut ComplementaritySolver,
    exponent: PulseExponent,
) -> Result<ImpactOutcome, ResponseError> {
    let approach = problem.approach()?;
    let mut impact = Impact::new(problem, approach, solver);
    if approach == 0.0 {
        return Ok(impact.nothing());
    }
    let mut outcome = ImpactOutcome { status: ImpactStatus::Separated, ..impact.nothing() };
    let mut velocities = problem.u_before.to_vec();
    let joints = impact.joints();
    let mut impulses = vec![0.0; velocities.len()];
    impact.stop_joints(&joints, &mut velocities, &mut impulses, &mut outcome);
    let contacts: Vec<usize> = (0..velocities.len()).filter(|&row| !problem.is_bilateral(row)).collect();
    let alone = if contacts.len() == 1 && joints.is_empty() { contacts.first() } else { None };
    if let Some(&row) = alone {
        let (before, e) = (velocities[row], problem.restitution[row]);
        if let Some(impulse) = single_contact_impulse(problem.delassus.get(row, row), before, e) {
            impact.advance(&mut velocities, &[row], &[impulse]);
            velocities[row] = if before < 0.0 { -e * before } else { before };
            impulses[row] += impulse;
        }
    } else {
        let reactions: Vec<Reaction> =
            contacts.iter().map(|&row| Reaction::to(&mut impact, row, &joints, &mut outcome)).collect();
        let from: Vec<f64> = contacts.iter().map(|&row| velocities[row]).collect();
        let restitution: Vec<f64> = contacts.iter().map(|&row| problem.restitution[row]).collect();
        if let Some(springs) = Springs::of(&contacts, &reactions, &from, restitution, exponent) {
            let (amounts, ended) = springs.run();
            if !ended && outcome.status == ImpactStatus::Separated {
                outcome.status = ImpactStatus::LimitReached;
            }
            for (reaction, amount) in reactions.iter().zip(&amounts) {
                for row in 0..velocities.len() {
                    impulses[row] += amount * reaction.impulses[row];
                    velocities[row] += amount * reaction.changes[row];
                }
            }
            for &row in &joints {
                velocities[row] = 0.0;
            }
        }
    }
    outcome.impulses = impulses;
    impact.conclude(velocities, &mut outcome);
    if outcome.status == ImpactStatus::StoppedAtThreshold {
        // The springs have spent their energy: what approaches still is the error of their steps, and no sequence cut off.
        outcome.status = ImpactStatus::Separated;
        outcome.finishing.clear();
    }
    impact.list_applications(&mut outcome);
    Ok(outcome)
}

/// What a unit impulse at a contact does to all rows, with the joints held.
struct Reaction {
    /// Of all rows, N s for each N s.
    impulses: Vec<f64>,
    /// Of all rows, m/s for each N s.
    changes: Vec<f64>,
}

impl Reaction {
    fn to(impact: &mut Impact<'_>, row: usize, joints: &[usize], outcome: &mut ImpactOutcome) -> Self {
        let rows = impact.problem.u_before.len();
        let (mut impulses, mut changes) = (vec![0.0; rows], vec![0.0; rows]);
        impulses[row] = 1.0;
        impact.advance(&mut changes, &[row], &[1.0]);
        if !joints.is_empty() {
            let pulled: Vec<f64> = joints.iter().map(|&joint| changes[joint]).collect();
            let held = impact.solve(joints, &pulled, 0.0, outcome);
            impact.advance(&mut changes, joints, &held.amounts);
            for (&joint, amount) in joints.iter().zip(&held.amounts) {
                impulses[joint] = *amount;
            }
        }
        Self { impulses, changes }
    }
}

/// The springs of all contacts, in units of the largest approach and of the largest inverse mass.
struct Springs {
    exponent: PulseExponent,
    /// `G` of the contacts over its largest diagonal entry, row-major.
    matrix: Vec<f64>,
    /// Velocities before over the largest approach.
    from: Vec<f64>,
    restitution: Vec<f64>,
    /// Unit of impulses, N s.
    impulse_unit: f64,
}

impl Springs {
    /// None where nothing can be moved, or nothing approaches.
    fn of(
        contacts: &[usize],
        reactions: &[Reaction],
        from: &[f64],
        restitution: Vec<f64>,
        exponent: PulseExponent,
    ) -> Option<Self> {
        let approach = from.iter().fold(0.0, |most: f64, u| most.max(-u));
        let largest = contacts.iter().zip(reactions).fold(0.0, |most: f64, (&row, of)| most.max(of.changes[row]));
        let impulse_unit = approach / largest;
        if !(impulse_unit > 0.0 && impulse_unit.is_finite()) {
            return None;
        }
        let entry = |i: usize, j: usize| {
            let both = [reactions[j].changes[contacts[i]], reactions[i].changes[contacts[j]]];
            (0.5 * both[0] + 0.5 * both[1]) / largest
        };
        let count = contacts.len();
        let matrix = (0..count * count).map(|k| entry(k / count, k % count)).collect();
        let restitution = restitution.into_iter().map(|e| if e < NO_REBOUND { 0.0 } else { e }).collect();
        Some(Self { exponent, matrix, from: from.iter().map(|u| u / approach).collect(), restitution, impulse_unit })
    }

    /// Velocities of the contacts after impulses.
    fn velocities(&self, impulses: &[f64]) -> Vec<f64> {
        let count = self.from.len();
        let lines = self.matrix.chunks_exact(count);
        let change = |line: &[f64]| line.iter().zip(impulses).map(|(entry, p)| entry * p).sum::<f64>();
        lines.zip(&self.from).map(|(line, from)| from + change(line)).collect()
    }

    /// Rates of indentations, then of impulses.
    fn rates(&self, state: &[f64]) -> Vec<f64> {
        let count = self.from.len();
        let (indentations, impulses) = state.split_at(count);
        let velocities = self.velocities(impulses);
        let mut rates = vec![0.0; 2 * count];
        for i in 0..count {
            let (d, u, e) = (indentations[i], velocities[i], self.restitution[i]);
            let opens = u > 0.0;
            rates[i] = match (opens, d > 0.0, e > 0.0) {
                (false, ..) => -u,
                (true, true, true) => -u / (e * e),
                _ => 0.0,
            };
            rates[count + i] = if opens && e == 0.0 { 0.0 } else { self.exponent.force(d) };
        }
        rates
    }

    /// Impulses of all contacts, N s, and whether everything was spent.
    fn run(&self) -> (Vec<f64>, bool) {
        let count = self.from.len();
        let mut state = vec![0.0; 2 * count];
        let mut length = FIRST_PULSE_STEP;
        let mut ended = false;
        let is_plastic = self.restitution.contains(&0.0);
        let (end, none) = if is_plastic { [END_WITHOUT_REBOUND; 2].into() } else { (SPENT_APPROACH, NO_INDENTATION) };
        for _ in 0..MOST_STEPS {
            let (next, error) = self.step(&state, length);
            let relative = error / STEP_ERROR;
            let accepted = relative <= 1.0 || length <= SHORTEST_PULSE_STEP;
            if accepted {
                state = next;
                let velocities = self.velocities(&state[count..]);
                ended = true;
                for i in 0..count {
                    let no_rebound = self.restitution[i] == 0.0 && velocities[i] >= -STOPPED;
                    if no_rebound || (state[i] <= none && velocities[i] > -end) {
                        state[i] = state[i].min(0.0);
                    }
                    ended &= state[i] <= 0.0 && velocities[i] > -end;
                    state[i] = state[i].max(0.0);
                }
                if ended {
                    break;
                }
            }
            let factor = if relative > 0.0 { STEP_MARGIN * libm::pow(relative, -0.2) } else { STEP_GROWTH[1] };
            let factor = if factor.is_finite() { factor.clamp(STEP_GROWTH[0], STEP_GROWTH[1]) } else { STEP_GROWTH[0] };
            length = (length * factor).clamp(SHORTEST_PULSE_STEP, LONGEST_PULSE_STEP);
        }
        (state[count..].iter().map(|p| p * self.impulse_unit).collect(), ended)
    }

    /// One step of a length, and its estimated error.
    fn step(&self, state: &[f64], length: f64) -> (Vec<f64>, f64) {
        /// The coefficients of the stages, and the difference of the two answers.
        const STAGES: [&[f64]; 6] = [
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
            &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
            &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
        ];
        const DIFFERENCE: [f64; 7] =
            [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
        let mut rates = vec![self.rates(state)];
        let mut next = state.to_vec();
        for weights in STAGES {
            next.copy_from_slice(state);
            for (weight, rate) in weights.iter().zip(&rates) {
                for (to, from) in next.iter_mut().zip(rate) {
                    *to += length * weight * from;
                }
            }
            rates.push(self.rates(&next));
        }
        let error = |i: usize| DIFFERENCE.iter().zip(&rates).map(|(weight, rate)| weight * rate[i]).sum::<f64>();
        let worst = (0..state.len()).map(|i| (length * error(i)).abs()).fold(0.0, f64::max);
        (next, worst)
    }
}
