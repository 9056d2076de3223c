//! Several contacts with friction struck together.
//!
//! Two questions are answered one after the other.
//!
//! 1. Which normal velocities? Those of the generalised reflection, as without friction: the mean of the inelastic
//!    impact at all contacts and of the elastic rounds at those that approach, `w = (1 - e) u_inel + e u_el` contact by
//!    contact, each step a cone problem with friction.
//! 2. Which impulses? Those that obey Coulomb's law at the velocities afterwards and do not leave slower than asked:
//!    `0 <= u_n+ - w _|_ p_n >= 0`, one cone problem.
//!
//! Without friction the second answer is the first one. With friction the normal velocities asked for may cost more
//! work than the contacts took, as Newton's law does at a single contact. They are lowered to `lambda w`, with the
//! largest `lambda` in `[0, 1]` for which
//!
//! - the kinetic energy does not rise: `p.(u- + u+)/2 <= 0`;
//! - the normal impulses give back at most `e^2` of the work that the inelastic impact takes (Stronge), and what the
//!   reflection gives to contacts that the inelastic impact opens.
//!
//! `lambda = 0` is the inelastic impact, which keeps both: with `p.u+ = -mu p_n |u_t+| <= 0` the energy changes by
//! `p.u+ - p.G p / 2 <= 0`.
//!
//! Assumption: the cone problem has a solution; bodies that are squeezed between others have none, and the status says
//! so. Source: Moreau 1988; Smith et al. 2012; Glocker (energy); Stronge 1990.

use super::part::{CONE_ENERGY_ROUNDING, ConeAnswer, Part, Struck, energy};
use crate::dense::kernels::compensated_dot;
use crate::error::ResponseError;
use crate::friction::FallbackPolicy;
use crate::friction::{ContactStatus, FrictionSolution};
use crate::impact::ImpactStatus;
use polhode_spatial::rounding;

/// Rounds of reflections after which bodies count as squeezed, where no rounds need ever end.
const ROUNDS: usize = 64;

/// Most steps to the largest `lambda` or restitution, and the width of its interval where they end (no unit).
const LAMBDA_STEPS: usize = 40;
const LAMBDA_WIDTH: f64 = 1e-12;

/// Steps in a row that do not halve the interval of `lambda` after which one does.
const SLOW_STEPS: usize = 3;

/// Impulses are shortened for the rounding of the energy to this at most (no unit): the residual of the cone problems
/// is far below, and a real gain is a defect that must show.
const SHORTEST: f64 = 1.0 - 1e-7;

/// An answer: impulses and velocities of all rows of a part.
#[derive(Debug, Clone)]
struct Answer {
    impulses: Vec<f64>,
    velocities: Vec<f64>,
}

/// An answer for some `lambda`, or for the restitution of a round.
#[derive(Debug, Clone)]
struct Attempt {
    answer: Answer,
    /// By how much it does more work than it may, relative to the work of all impulses (no unit); infinite where the
    /// cone problem was not solved.
    excess: f64,
    /// The same, J.
    surplus_j: f64,
}

impl Attempt {
    /// An answer, and by how much it does more work than it may; negative where it does less.
    fn new(part: &Part, asked: &Asked<'_>, answer: Answer) -> Self {
        let contacts = (0..part.contacts.len()).filter(|&block| !part.is_joint(block));
        let work = |row: usize| 0.5 * answer.impulses[row] * (asked.before[row] + answer.velocities[row]);
        let normal: f64 = contacts.map(|block| work(part.normal_row(block))).sum();
        let (change, size) = energy(&answer.impulses, asked.before, &answer.velocities);
        let surplus_j = (normal - asked.work).max(change);
        Self::with_surplus(answer, surplus_j, size)
    }

    /// An answer that does more work than it may by this (J), where the works of all impulses have this size (J).
    fn with_surplus(answer: Answer, surplus_j: f64, size: f64) -> Self {
        let excess = if size > 0.0 { surplus_j / size } else { 0.0 };
        Self { answer, excess, surplus_j }
    }

    /// The cone problem was not solved.
    const fn not_solved() -> Self {
        let answer = Answer { impulses: Vec::new(), velocities: Vec::new() };
        Self { answer, excess: f64::INFINITY, surplus_j: f64::INFINITY }
    }

    const fn is_solved(&self) -> bool {
        self.excess < f64::INFINITY
    }
}

/// What is asked of an impact.
#[derive(Debug, Clone)]
struct Asked<'a> {
    /// Velocities before, m/s.
    before: &'a [f64],
    /// `w` of the normal rows, zero elsewhere, m/s.
    velocities: Vec<f64>,
    /// Work that all normal impulses together may do at most, J.
    work: f64,
}

/// Strikes all contacts of a part, whose joints do not move. False when the cone problem of the inelastic impact was
/// not solved, and nothing was done.
pub(super) fn strike_together(part: &mut Part, struck: &mut Struck) -> Result<bool, ResponseError> {
    let before = struck.velocities.clone();
    let Some(mut answer) = answer(part, &before)? else { return Ok(false) };
    take_out_gain(part, &before, &mut answer.impulses);
    struck.add(part, &answer.impulses, answer.velocities);
    Ok(true)
}

/// Rounding must not be in favour of energy: shortens all impulses by what takes its gain out, along `p.u+`, the rate
/// at which the energy grows with their length. They stay in their cones.
fn take_out_gain(part: &Part, before: &[f64], impulses: &mut [f64]) {
    let after = part.after(before, impulses);
    let (gain, _) = energy(impulses, before, &after);
    let shorter = 1.0 - gain / compensated_dot(impulses, &after);
    if gain > 0.0 && shorter > SHORTEST {
        for impulse in impulses {
            *impulse *= shorter;
        }
    }
}

fn answer(part: &mut Part, before: &[f64]) -> Result<Option<Answer>, ResponseError> {
    let nothing = vec![0.0; part.contacts.rows()];
    let Some(inelastic) = solved(part, before, &nothing, None)? else { return Ok(None) };
    if part.restitution.iter().all(|e| *e == 0.0) {
        return Ok(Some(inelastic));
    }
    let elastic = reflected(part, before)?;
    let asked = Asked {
        before,
        velocities: asked_velocities(part, &inelastic, &elastic),
        work: work_limit(part, before, &inelastic, &elastic),
    };
    let full = attempt(part, &asked, 1.0, &inelastic.impulses)?;
    if full.excess <= CONE_ENERGY_ROUNDING {
        return Ok(Some(full.answer));
    }
    part.status = part.status.max(ImpactStatus::RestitutionLowered);
    let inelastic = Attempt::new(part, &asked, inelastic);
    let best = largest(inelastic, &full, |lambda, start| attempt(part, &asked, lambda, start))?;
    Ok(Some(best.answer))
}

/// The answer for `lambda w`.
fn attempt(part: &mut Part, asked: &Asked<'_>, lambda: f64, start: &[f64]) -> Result<Attempt, ResponseError> {
    let velocities: Vec<f64> = asked.velocities.iter().map(|velocity| lambda * velocity).collect();
    let found = quickly_where(lambda < 1.0, part, |part| solved(part, asked.before, &velocities, Some(start)))?;
    Ok(found.map_or_else(Attempt::not_solved, |answer| Attempt::new(part, asked, answer)))
}

/// Solves a cone problem, and `where` there are others to try in its place, without the last resorts: where Newton's
/// method from two starts and the convex programme find no answer, hundreds of sweeps seldom do.
fn quickly_where<T>(there_are_others: bool, part: &mut Part, solve: impl FnOnce(&mut Part) -> T) -> T {
    let settings = part.settings;
    part.settings.last_sweeps = 0;
    if there_are_others {
        part.settings.fallback = FallbackPolicy::Refuse;
    }
    let answer = solve(part);
    part.settings = settings;
    answer
}

/// The answer for the largest number in `[0, 1]` (`lambda`, or the restitution of a round) without excess, from the
/// answers at 0 and at 1, of which the latter has some. Work is quadratic in it as long as no contact begins to stick
/// or slide: the next one is the zero of the parabola through the ends of the interval and the end before, where it
/// lies inside and the interval shrinks, and the middle otherwise.
fn largest(
    at_0: Attempt,
    at_1: &Attempt,
    mut attempt: impl FnMut(f64, &[f64]) -> Result<Attempt, ResponseError>,
) -> Result<Attempt, ResponseError> {
    let (mut low, mut high) = ((0.0, at_0.surplus_j), (1.0, at_1.surplus_j));
    let mut before = None;
    let mut best = at_0;
    if best.excess >= 0.0 {
        return Ok(best);
    }
    let mut slow = 0;
    for _ in 0..LAMBDA_STEPS {
        let width = high.0 - low.0;
        if width <= LAMBDA_WIDTH {
            break;
        }
        let interpolated = if slow < SLOW_STEPS { zero_of_parabola(low, high, before) } else { None };
        slow = if interpolated.is_some() { slow } else { 0 };
        let lambda = interpolated.unwrap_or(0.5 * (low.0 + high.0));
        let tried = attempt(lambda, &best.answer.impulses)?;
        if tried.excess.abs() <= rounding::HUNDREDS_OF_TERMS {
            return Ok(tried);
        }
        if tried.excess < 0.0 {
            before = Some(std::mem::replace(&mut low, (lambda, tried.surplus_j)));
            best = tried;
        } else {
            before = Some(std::mem::replace(&mut high, (lambda, tried.surplus_j)));
        }
        slow = if high.0 - low.0 > 0.5 * width { slow + 1 } else { 0 };
    }
    Ok(best)
}

/// The zero between two points where a function has opposite signs, `(x, f)`, of the parabola through them and a third
/// one, or of the line through them where there is none; none where that is not inside.
fn zero_of_parabola(low: (f64, f64), high: (f64, f64), third: Option<(f64, f64)>) -> Option<f64> {
    let slope = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1) / (b.0 - a.0);
    let chord = slope(low, high);
    let bend = third.map_or(0.0, |third| (slope(high, third) - chord) / (third.0 - low.0));
    let bend = if bend.is_finite() { bend } else { 0.0 };
    // f = f_low + (x - x_low) (chord + bend (x - x_high)), with y = x - x_low.
    let linear = chord - bend * (high.0 - low.0);
    let root = (linear * linear - 4.0 * bend * low.1).sqrt();
    // The zero of a function that rises there, without cancellation.
    let y = if linear > 0.0 { -2.0 * low.1 / (linear + root) } else { (root - linear) / (2.0 * bend) };
    let x = low.0 + y;
    (x > low.0 && x < high.0).then_some(x)
}

/// The impulses that leave no contact slower than asked; none when the cone problem is not solved.
fn solved(
    part: &mut Part,
    before: &[f64],
    asked: &[f64],
    start: Option<&[f64]>,
) -> Result<Option<Answer>, ResponseError> {
    let all: Vec<usize> = (0..part.contacts.len()).collect();
    let constant: Vec<f64> = before.iter().zip(asked).map(|(u, asked)| u - asked).collect();
    let ConeAnswer { impulses, solution, is_solved } = part.solve(&all, &constant, start)?;
    Ok(is_solved.then(|| Answer { impulses, velocities: settled(part, &solution, asked) }))
}

/// The velocities of a solution: exactly those asked for where a contact carries, exactly 0 where it sticks.
fn settled(part: &Part, solution: &FrictionSolution, asked: &[f64]) -> Vec<f64> {
    let mut velocities: Vec<f64> = solution.velocities.iter().zip(asked).map(|(u, asked)| u + asked).collect();
    for (block, status) in solution.statuses.iter().enumerate() {
        let range = part.contacts.range(block);
        if part.is_joint(block) {
            velocities[range].fill(0.0);
            continue;
        }
        let normal = range.start;
        if *status != ContactStatus::Open {
            velocities[normal] = asked[normal];
        }
        velocities[normal] = velocities[normal].max(asked[normal]);
        for ((rows, _), part) in part.contacts.blocks()[block].parts().into_iter().zip(solution.parts[block]) {
            if part == ContactStatus::Stick {
                velocities[range.start + rows.start..range.start + rows.end].fill(0.0);
            }
        }
    }
    velocities
}

/// The elastic rounds: contacts that approach leave as fast as they came, until none approaches. Where friction would
/// raise the energy of a round so, they leave with the largest restitution that does not.
fn reflected(part: &mut Part, before: &[f64]) -> Result<Answer, ResponseError> {
    let mut total = Answer { impulses: vec![0.0; before.len()], velocities: before.to_vec() };
    let joints = part.joints();
    for _ in 0..ROUNDS {
        let mut chosen = part.approaching(&total.velocities);
        if chosen.is_empty() {
            break;
        }
        chosen.extend(&joints);
        let mut round = rebound(part, &chosen, &total.velocities, 1.0, None)?;
        if round.excess > CONE_ENERGY_ROUNDING {
            let inelastic = rebound(part, &chosen, &total.velocities, 0.0, None)?;
            if !inelastic.is_solved() {
                // What has been reached is what is asked for.
                break;
            }
            let velocities = &total.velocities;
            round = largest(inelastic, &round, |restitution, start| {
                quickly_where(true, part, |part| rebound(part, &chosen, velocities, restitution, Some(start)))
            })?;
        }
        total.velocities = round.answer.velocities;
        total.impulses.iter_mut().zip(&round.answer.impulses).for_each(|(total, impulse)| *total += impulse);
        part.hold_joints(&mut total.velocities);
    }
    Ok(total)
}

/// One round: the `chosen` contacts leave with this restitution, from these velocities of all rows (m/s). Its surplus
/// is by how much the energy rises.
fn rebound(
    part: &mut Part,
    chosen: &[usize],
    velocities: &[f64],
    restitution: f64,
    start: Option<&[f64]>,
) -> Result<Attempt, ResponseError> {
    let mut constant = velocities.to_vec();
    for &block in chosen.iter().filter(|&&block| !part.is_joint(block)) {
        constant[part.normal_row(block)] *= 1.0 + restitution;
    }
    let ConeAnswer { impulses, is_solved, .. } = part.solve(chosen, &constant, start)?;
    if !is_solved {
        return Ok(Attempt::not_solved());
    }
    let after = part.after(velocities, &impulses);
    let (change, size) = energy(&impulses, velocities, &after);
    Ok(Attempt::with_surplus(Answer { impulses, velocities: after }, change, size))
}

/// `w` of the normal rows, zero elsewhere.
fn asked_velocities(part: &Part, inelastic: &Answer, elastic: &Answer) -> Vec<f64> {
    let mut asked = vec![0.0; part.contacts.rows()];
    for block in (0..part.contacts.len()).filter(|&block| !part.is_joint(block)) {
        let (row, e) = (part.normal_row(block), part.restitution[block]);
        let mean = (1.0 - e) * inelastic.velocities[row] + e * elastic.velocities[row].max(0.0);
        asked[row] = if mean > part.tolerance { mean } else { 0.0 };
    }
    asked
}

/// Work that all normal impulses together may do at most, J.
fn work_limit(part: &Part, before: &[f64], inelastic: &Answer, elastic: &Answer) -> f64 {
    let (mut limit, mut all) = (0.0, 0.0);
    for block in (0..part.contacts.len()).filter(|&block| !part.is_joint(block)) {
        let (row, e) = (part.normal_row(block), part.restitution[block]);
        let taken = 0.5 * inelastic.impulses[row] * (before[row] + inelastic.velocities[row]);
        all += taken;
        limit += (1.0 - e * e) * taken + (e - e * e) * inelastic.velocities[row] * elastic.impulses[row];
    }
    limit.max(all)
}

#[cfg(test)]
mod tests {
    //! The zero of work that is quadratic in `lambda` is found at once; what gives none is told.
    use super::zero_of_parabola;

    /// A parabola through three of its points has its rising zero between two of them, a line that through two.
    #[test]
    fn the_zero_of_a_parabola_is_that_between_the_ends() {
        let parabola = |x: f64| 3.0 * (x - 0.25) * (x + 1.5);
        let at = |x: f64| (x, parabola(x));
        for third in [at(1.0), at(0.9), at(-0.5)] {
            let zero = zero_of_parabola(at(0.0), at(0.8), Some(third));
            assert!(zero.is_some_and(|zero| (zero - 0.25).abs() < 1e-15), "{zero:?}");
        }
        assert_eq!(zero_of_parabola((0.0, -1.0), (1.0, 3.0), None), Some(0.25));
    }

    /// Without a finite value at an end there is no zero to tell; a third point without one leaves the line.
    #[test]
    fn ends_without_a_value_have_no_zero() {
        assert_eq!(zero_of_parabola((0.0, -1.0), (1.0, f64::INFINITY), None), None);
        assert_eq!(zero_of_parabola((0.0, -1.0), (1.0, 2.0), Some((0.5, f64::NAN))), Some(1.0 / 3.0));
    }
}
