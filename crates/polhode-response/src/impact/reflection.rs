//! The generalised reflection: the velocities are mirrored at the contacts that approach, again and again.
//!
//! With `V` the rows that approach and `v_inel(V)` the velocities after an inelastic impact at `V` alone (the
//! projection of `v` on the set where no row of `V` approaches), `v <- 2 v_inel(V) - v` keeps the energy exactly and
//! carries momentum through a row of balls. It is repeated until no row approaches, which happens after finitely many
//! rounds. With restitution the result is the mean of that and of the inelastic impact at all touching rows,
//! `v+ = (1 - e) v_inel + e v_GR`; the energy is convex, so it does not rise. Restitutions that differ weight the
//! impulses row by row; what then still approaches is stopped inelastically, and if the energy would rise, the
//! smallest restitution is used for all rows, said by the status.
//!
//! The rounds end because each brings `v` nearer to any velocity at which all rows separate. Where there is none,
//! because bodies fit exactly between others, they may not, and no motion of the same energy need exist: then the
//! rounds are given up, and what approaches is stopped inelastically ([`ImpactStatus::LimitReached`]).
//!
//! Source: Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on simultaneous impact, 2012.

use super::finish::Impact;
use super::outcome::{ImpactOutcome, ImpactStatus};
use super::unequal::{extremes, or_lowered};

/// Rounds after which it is worth one more solve to know whether they end.
const ROUNDS_BEFORE_DOUBT: usize = 64;

/// Impulses and velocities of one of the two parts.
#[derive(Debug, Clone)]
struct Part {
    impulses: Vec<f64>,
    velocities: Vec<f64>,
}

/// Resolves an impact by generalised reflection.
pub(super) fn reflection(impact: &mut Impact<'_>) -> ImpactOutcome {
    let problem = impact.problem;
    let mut outcome = ImpactOutcome { status: ImpactStatus::Separated, ..impact.nothing() };
    // Joints have none, and leave with the mean of the two parts whatever the contacts have.
    let [least, most] = extremes(problem);
    let inelastic = if least < 1.0 { Some(inelastic(impact, &mut outcome)) } else { None };
    let elastic = if most > 0.0 { Some(elastic(impact, &mut outcome)) } else { None };
    let parts = (inelastic.as_ref(), elastic.as_ref());
    let start = outcome.clone();
    let evenly = |impact: &mut Impact<'_>, restitution: f64| {
        let mut outcome = start;
        blend_evenly(impact, parts, restitution, &mut outcome);
        outcome
    };
    if least == most {
        evenly(impact, least)
    } else {
        blend_by_row(impact, parts, problem.restitution, &mut outcome);
        or_lowered(impact, outcome, Some(least), evenly)
    }
}

/// The inelastic impact at all touching rows: no row approaches afterwards.
fn inelastic(impact: &mut Impact<'_>, outcome: &mut ImpactOutcome) -> Part {
    let rows: Vec<usize> = (0..impact.problem.u_before.len()).collect();
    let solved = impact.solve(&rows, impact.problem.u_before, 0.0, outcome);
    Part { impulses: solved.amounts, velocities: solved.w }
}

/// The rounds of reflections.
fn elastic(impact: &mut Impact<'_>, outcome: &mut ImpactOutcome) -> Part {
    let joints = impact.joints();
    let mut part =
        Part { impulses: vec![0.0; impact.problem.u_before.len()], velocities: impact.problem.u_before.to_vec() };
    impact.stop_joints(&joints, &mut part.velocities, &mut part.impulses, outcome);
    for round in 0.. {
        let velocities = &mut part.velocities;
        let mut approaching: Vec<usize> = (0..velocities.len())
            .filter(|&row| velocities[row] < -impact.tolerance && !impact.problem.is_bilateral(row))
            .collect();
        if approaching.is_empty() || outcome.status == ImpactStatus::NotSolved {
            break;
        }
        if round >= impact.problem.settings.limit || (round == ROUNDS_BEFORE_DOUBT && !impact.can_separate(outcome)) {
            outcome.status = ImpactStatus::LimitReached;
            break;
        }
        approaching.extend(&joints);
        let before: Vec<f64> = approaching.iter().map(|&row| velocities[row]).collect();
        let noise = impact.noise(&part.impulses);
        let solved = impact.solve(&approaching, &before, noise, outcome);
        let doubled: Vec<f64> = solved.amounts.iter().map(|impulse| 2.0 * impulse).collect();
        impact.advance(velocities, &approaching, &doubled);
        for (k, &row) in approaching.iter().enumerate() {
            part.impulses[row] += doubled[k];
            if solved.held[k] {
                velocities[row] = -before[k];
            }
        }
    }
    part
}

/// One restitution for all rows: impulses and velocities are means of the two parts, and exact zeros stay exact.
fn blend_evenly(
    impact: &mut Impact<'_>,
    (inelastic, elastic): (Option<&Part>, Option<&Part>),
    restitution: f64,
    outcome: &mut ImpactOutcome,
) {
    let mut velocities = vec![0.0; impact.problem.u_before.len()];
    outcome.impulses.fill(0.0);
    for (part, weight) in [(inelastic, 1.0 - restitution), (elastic, restitution)] {
        if let (Some(part), true) = (part, weight > 0.0) {
            for row in 0..velocities.len() {
                velocities[row] += weight * part.velocities[row];
                outcome.impulses[row] += weight * part.impulses[row];
            }
        }
    }
    impact.conclude(velocities, outcome);
}

/// Restitutions that differ: each row takes its own mean of the two impulses.
fn blend_by_row(
    impact: &mut Impact<'_>,
    (inelastic, elastic): (Option<&Part>, Option<&Part>),
    restitution: &[f64],
    outcome: &mut ImpactOutcome,
) {
    let impulse = |part: Option<&Part>, row: usize| part.map_or(0.0, |part| part.impulses[row]);
    for (row, &e) in restitution.iter().enumerate() {
        outcome.impulses[row] = (1.0 - e) * impulse(inelastic, row) + e * impulse(elastic, row);
    }
    let mut velocities = impact.problem.u_before.to_vec();
    let rows: Vec<usize> = (0..velocities.len()).collect();
    impact.advance(&mut velocities, &rows, &outcome.impulses);
    impact.conclude(velocities, outcome);
    // The inelastic solve at the end belongs to this blend: it is no sequence that was cut off.
    if outcome.status == ImpactStatus::StoppedAtThreshold {
        outcome.status = ImpactStatus::Separated;
    }
}
