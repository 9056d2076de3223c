//! Energy from the states, held against the report, against time and against the ledger.

use super::judged::{Findings, Judged, State, Track};
use crate::random_scene::model::{Force, RestitutionLaw, Role};
use glam::DVec3;

/// Relative to the scale: what two computations of one energy may differ by.
const ROUNDING: f64 = 1e-11;
/// Relative to the scale: what the energy may rise by between samples without a cause, and terms of the ledger may be
/// below zero by.
const RISE: f64 = 1e-8;
/// Relative to the scale: what the integrator and projections may take or give in a run that ends well.
const NUMERICAL: f64 = 1e-6;

/// Of bodies at rest the energy of a lift by this height is the scale, m.
const LEAST_HEIGHT: f64 = 1e-2;

/// T, V and the largest T so far.
fn energy(judged: &Judged<'_>, states: &[State]) -> (f64, f64) {
    let (mut kinetic, mut potential) = (0.0, 0.0);
    for (number, state) in states.iter().enumerate() {
        let Role::Free(mass) = judged.body(number).role else { continue };
        let spin = judged.spin(number, state);
        kinetic += 0.5 * (mass * state.velocity.length_squared() + spin.dot(state.angular_velocity));
        potential -= mass * judged.model.gravity.dot(judged.center(number, state));
    }
    let point = |body: usize, own: DVec3| states[body].position + states[body].orientation * own;
    for force in &judged.model.forces {
        potential += match force {
            Force::Anchored { body, point: own, anchor, stiffness, rest_length, .. } => {
                let stretch = (point(*body, *own) - *anchor).length() - rest_length;
                0.5 * stiffness * stretch * stretch
            }
            Force::Between { bodies: [a, b], points, stiffness, rest_length, .. } => {
                let stretch = (point(*a, points[0]) - point(*b, points[1])).length() - rest_length;
                0.5 * stiffness * stretch * stretch
            }
            Force::Drag { .. } => 0.0,
        };
    }
    (kinetic, potential)
}

/// Holds energy and ledger against their laws.
pub(super) fn hold(judged: &Judged<'_>, track: &Track, findings: &mut Findings) {
    let energies: Vec<(f64, f64)> = track.states.iter().map(|states| energy(judged, states)).collect();
    let (Some(&first), Some(&last)) = (energies.first(), energies.last()) else { return };
    let v0 = first.1;
    let moved = energies.iter().map(|(t, v)| t + (v - v0).abs()).fold(0.0, f64::max);
    let height = track.states.iter().flatten().map(|state| state.position.length()).fold(0.0, f64::max);
    let weights = judged.model.bodies.iter().map(|body| if let Role::Free(mass) = body.role { mass } else { 0.0 });
    let weight = weights.sum::<f64>() * judged.model.gravity.length();
    // Energies are sums of terms of this size, whatever they come to.
    let sums = moved + weight * height + v0.abs();
    let account = &track.account;
    let total = |(t, v): (f64, f64)| t + v;
    for (what, own, told) in [("start", first, account.initial), ("end", last, account.end)] {
        findings.hold("energy of the report", (total(own) - told).abs(), ROUNDING * sums, || {
            format!("at the {what} {:.15e} J from the states, {told:.15e} J in the report", total(own))
        });
    }
    let is_driven = judged.model.bodies.iter().any(|body| matches!(body.role, Role::Moved(_)));
    let may_add = judged.model.restitution_law.is_some_and(RestitutionLaw::may_add_energy);
    let scale = moved.max(weight * LEAST_HEIGHT);
    if !is_driven && !may_add {
        for (pair, times) in energies.windows(2).zip(track.times.windows(2)) {
            let rise = total(pair[1]) - total(pair[0]);
            findings.hold("energy rises", rise, RISE * scale + ROUNDING * sums, || {
                format!("by {rise:.3e} J of {scale:.3e} from t = {} s to {} s", times[0], times[1])
            });
        }
    }
    for (name, loss) in [("friction", account.friction), ("rest", account.rest), ("damping", account.damping)] {
        findings.hold("loss below zero", -loss, RISE * scale, || format!("{name}: {loss:.3e} J of {scale:.3e}"));
    }
    if !may_add {
        // By Stronge's law no normal work is given back beyond what was taken; by the others with friction some may be,
        // at the cost of friction.
        let is_stronge = judged.model.restitution_law.is_none_or(|law| law == RestitutionLaw::Named("stronge"));
        let (name, loss) = if is_stronge {
            ("impact", account.impact)
        } else {
            ("impact and friction", account.impact + account.friction)
        };
        findings.hold("loss below zero", -loss, RISE * scale, || format!("{name}: {loss:.3e} J of {scale:.3e}"));
    }
    for (name, taken) in [("numerical", account.numerical), ("projection", account.projection)] {
        findings
            .hold("numerical loss", taken.abs(), NUMERICAL * scale, || format!("{name}: {taken:.3e} J of {scale:.3e}"));
    }
    let losses =
        account.impact + account.friction + account.rest + account.damping + account.projection + account.numerical;
    let left = total(last) - total(first) + losses - account.external;
    findings.hold("ledger", left.abs(), RISE * scale + ROUNDING * sums, || {
        format!("{left:.3e} J of {scale:.3e} have no cause in the ledger")
    });
}
