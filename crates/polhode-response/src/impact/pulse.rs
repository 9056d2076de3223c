//! The pulse law: the contacts are springs that spend what they have taken, while the bodies stand still (Liu, Zhao and
//! Brogliato).
//!
//! Each contact stores the energy `E_i` of a spring of stiffness `K` and exponent `eta` (1: linear; 3/2: Hertz), all of
//! the same `K`. Impulses grow in the ratios of the forces,
//!
//! `dp_i/dp_j = (E_i/E_j)^(eta/(1 + eta))`, `dE_i = -u_i dp_i` while it closes, `dE_i = -u_i dp_i/e_i^2` while it
//! opens,
//!
//! with `u = u- + G p` (m/s, 1/kg, N s), and the impact ends when all energies are spent and nothing approaches
//! (`friction/springs.rs` has the method). `K` cancels.
//!
//! Unlike the laws of complementarity it says how momentum spreads: one ball into a row of linear or of Hertzian
//! contacts does not send one ball out alone. Energy: `dT = -sum_i (1 - e_i^2) W_i <= 0`, with `W_i` the work that
//! contact `i` took.
//!
//! Joints are held throughout: their reaction to an impulse at each contact is found once. A contact that is struck
//! alone has the closed form of equation (14).
//!
//! Assumption: no friction (`friction/pulse.rs` has it), and stiffness the same at all contacts.
//! How it fails: where no velocity separates all rows, as of a body that just fits between two others, what keeps all
//! its energy goes on without end; there [`SQUEEZED_COMPRESSIONS`] are allowed, elsewhere [`MOST_COMPRESSIONS`]. The
//! rest is stopped inelastically and the status is [`ImpactStatus::LimitReached`].
//!
//! Source: Liu, Zhao and Brogliato 2008.

use super::finish::Impact;
use super::friction::pulse::MOST_COMPRESSIONS;
use super::friction::spring_contact::SpringContact;
use super::friction::springs::{PulseExponent, Springs};
use super::impact_problem::ImpactProblem;
use super::outcome::{ImpactOutcome, ImpactStatus};
use super::single_contact_impulse;

/// Most compressions for each contact where no velocity separates all rows (16 to 1000): what loses a tenth of its
/// energy in each has a thousandth left.
const SQUEEZED_COMPRESSIONS: usize = 64;

/// Resolves an impact by springs at the touching contacts.
pub(super) fn pulse(impact: &mut Impact<'_>, exponent: PulseExponent) -> ImpactOutcome {
    let problem = impact.problem;
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
            contacts.iter().map(|&row| Reaction::to(impact, row, &joints, &mut outcome)).collect();
        if let Some(springs) = springs(problem, &contacts, &reactions, (&velocities, exponent)) {
            let squeezed = !impact.can_separate(&mut outcome);
            let most = if squeezed { SQUEEZED_COMPRESSIONS * contacts.len() } else { MOST_COMPRESSIONS };
            let sprung = springs.run(most.min(problem.settings.limit));
            if !sprung.ended && outcome.status == ImpactStatus::Separated {
                outcome.status = ImpactStatus::LimitReached;
            }
            let amounts = sprung.impulses;
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
    let before_rounding = impulses_total(&outcome);
    impact.conclude(velocities, &mut outcome);
    if outcome.finishing.is_empty() && impulses_total(&outcome) != before_rounding {
        // The error of the steps was in favour of energy: the velocities are those of the impulses that were shortened
        // for it.
        let rows: Vec<usize> = (0..outcome.impulses.len()).collect();
        let mut after = problem.u_before.to_vec();
        impact.advance(&mut after, &rows, &outcome.impulses);
        for (row, (to, exact)) in outcome.velocities_after.iter_mut().zip(after).enumerate() {
            *to = if *to == 0.0 || problem.is_bilateral(row) { 0.0 } else { exact.max(0.0) };
        }
    }
    if outcome.status == ImpactStatus::StoppedAtThreshold {
        // The springs have spent their energy: what approaches still is the error of their steps, and no sequence cut
        // off.
        outcome.status = ImpactStatus::Separated;
        outcome.finishing.clear();
    }
    outcome
}

/// The sum of all impulses, N s.
fn impulses_total(outcome: &ImpactOutcome) -> f64 {
    outcome.impulses.iter().sum()
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

/// The springs of the contacts at these velocities of all rows.
fn springs(
    problem: &ImpactProblem<'_>,
    contacts: &[usize],
    reactions: &[Reaction],
    (velocities, exponent): (&[f64], PulseExponent),
) -> Option<Springs> {
    let entry = |i: usize, j: usize| {
        let both = [reactions[j].changes[contacts[i]], reactions[i].changes[contacts[j]]];
        0.5 * both[0] + 0.5 * both[1]
    };
    let count = contacts.len();
    let matrix = (0..count * count).map(|k| entry(k / count, k % count)).collect();
    let from = contacts.iter().map(|&row| velocities[row]).collect();
    let spring = |(row, &of): (usize, &usize)| SpringContact {
        row,
        tangents: 0,
        friction: 0.0,
        restitution: problem.restitution[of],
    };
    Springs::of(contacts.iter().enumerate().map(spring).collect(), matrix, from, exponent)
}
