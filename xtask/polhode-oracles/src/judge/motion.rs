//! States, prescribed motions, momentum, free flight and Coulomb's law.

use super::judged::{Findings, Judged, State, Track};
use super::pairs::Near;
use crate::random_scene::model::{Force, Form, Motion, Role};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// Rounding of a quaternion, a prescribed pose, or the time of a sample, relative.
const ROUNDING: f64 = 1e-12;
/// Overlaps at the start that count as touch are removed by moves of this size at the most, m.
const TOUCH: f64 = 1e-9;
/// Arm about which a body without spin is given an angular momentum as a scale, m.
const LEAST_ARM: f64 = 1e-2;
/// Bodies nearer than this may touch, however slow they are, m.
const LEAST_GAP: f64 = 1e-6;
/// Error of a flight or a momentum, relative to the largest terms that it is made of. The error allowed to an
/// integrator is below it.
const MOTION: f64 = 1e-8;
/// Error of an impulse of a plane, relative to the speeds: bounces too small to be resolved end at once, with what they
/// would still have given.
const BOUNCES: f64 = 2e-5;
/// Error of a flight or a momentum in runs with stretches of crowded events, in which errors of 1e-6 are allowed and
/// told.
const CROWDED: f64 = 1e-5;

/// Whether all states are numbers, at the times asked for.
pub(super) fn states(judged: &Judged<'_>, track: &Track, findings: &mut Findings) -> bool {
    let last = track.times.last().copied().unwrap_or(f64::NAN);
    let duration = judged.model.duration;
    findings.hold("samples", if last == duration { 0.0 } else { f64::INFINITY }, 1.0, || {
        format!("the last is at {last} s of {duration} s")
    });
    for (&t, states) in track.times.iter().zip(&track.states) {
        for (number, state) in states.iter().enumerate() {
            let is_finite = state.position.is_finite()
                && state.orientation.is_finite()
                && state.velocity.is_finite()
                && state.angular_velocity.is_finite();
            let length = (state.orientation.length() - 1.0).abs();
            let off = if is_finite { length } else { f64::INFINITY };
            findings.hold("states", off, ROUNDING, || format!("t = {t} s: {}: {state:?}", judged.body(number).name));
            if !is_finite {
                return false;
            }
        }
    }
    true
}

/// Fixed bodies stay where they are, kinematic bodies follow their motion.
pub(super) fn still_bodies(judged: &Judged<'_>, track: &Track, findings: &mut Findings) {
    for (number, body) in judged.model.bodies.iter().enumerate() {
        for (&t, states) in track.times.iter().zip(&track.states) {
            let (start, turn) = (body.position, body.orientation);
            let (position, orientation) = match &body.role {
                Role::Free(_) if t == 0.0 => (start, turn),
                Role::Free(_) => break,
                Role::Fixed => (start, turn),
                Role::Moved(Motion::Constant(v, w)) => {
                    (start + *v * t, (DQuat::from_scaled_axis(*w * t) * turn).normalize())
                }
                Role::Moved(Motion::Sine { amplitude, turn: about, frequency, phase }) => {
                    let s = libm::sin(TAU * frequency * t + phase);
                    let turned = about.map_or(DQuat::IDENTITY, |(axis, angle)| {
                        DQuat::from_scaled_axis(axis.normalize() * (s * angle))
                    });
                    (start + *amplitude * s, (turned * turn).normalize())
                }
                Role::Moved(Motion::Table(times, positions)) => {
                    let at = times.iter().position(|&time| (time - t).abs() < ROUNDING);
                    (at.map_or(states[number].position, |at| positions[at]), turn)
                }
            };
            let state = &states[number];
            let off =
                (state.position - position).length() + (state.orientation * orientation.inverse()).xyz().length() * 2.0;
            // At the start overlaps that are rounding are removed.
            let allowed = if body.is_free() { TOUCH } else { ROUNDING * 10.0 };
            findings.hold("prescribed motion", off, allowed, || format!("t = {t} s: {} is {off:.1e} off", body.name));
        }
    }
}

/// Momentum and angular momentum of bodies among themselves, in space.
pub(super) fn momentum(judged: &Judged<'_>, track: &Track, findings: &mut Findings) {
    let model = judged.model;
    let is_closed = model.gravity == DVec3::ZERO
        && model.bodies.iter().all(|body| body.is_free() && body.pivot.is_none())
        && model.forces.iter().all(|force| matches!(force, Force::Between { .. }));
    if !is_closed {
        return;
    }
    let sums = |states: &[State]| {
        let (mut linear, mut angular, mut scale) = (DVec3::ZERO, DVec3::ZERO, [0.0; 2]);
        for (number, state) in states.iter().enumerate() {
            let Role::Free(mass) = judged.body(number).role else { continue };
            let (p, spin) = (state.velocity * mass, judged.spin(number, state));
            let orbital = judged.center(number, state).cross(p);
            linear += p;
            angular += orbital + spin;
            scale[0] += p.length();
            scale[1] += orbital.length() + spin.length() + p.length() * LEAST_ARM;
        }
        (linear, angular, scale)
    };
    let limit = if track.account.is_crowded { CROWDED } else { MOTION };
    let Some(first) = track.states.first().map(|states| sums(states)) else { return };
    for (&t, states) in track.times.iter().zip(&track.states) {
        let now = sums(states);
        for (name, change, scale) in [
            ("momentum", now.0 - first.0, now.2[0].max(first.2[0])),
            ("angular momentum", now.1 - first.1, now.2[1].max(first.2[1])),
        ] {
            findings.hold("momentum", change.length(), limit * scale, || {
                format!("t = {t} s: {name} has changed by {:.3e} of {scale:.3e}", change.length())
            });
        }
    }
}

/// Two samples that follow each other, of one body.
struct Interval<'a> {
    number: usize,
    t: f64,
    dt: f64,
    before: &'a State,
    after: &'a State,
    limit: f64,
}

/// Flight and Coulomb's law between samples.
pub(super) fn intervals(judged: &Judged<'_>, track: &Track, near: &Near, findings: &mut Findings) {
    let limit = if track.account.is_crowded { CROWDED } else { MOTION };
    let model = judged.model;
    for number in 0..model.bodies.len() {
        let body = judged.body(number);
        if !body.is_free() || body.pivot.is_some() || is_loaded(judged, number) {
            continue;
        }
        for k in 1..track.times.len() {
            let (t, dt) = (track.times[k - 1], track.times[k] - track.times[k - 1]);
            let states = [&track.states[k - 1], &track.states[k]];
            let others: Vec<usize> = (0..model.bodies.len())
                .filter(|&other| {
                    other != number && {
                        let pair = (number.min(other), number.max(other));
                        may_touch(judged, [number, other], states, dt, [near[k - 1][&pair], near[k][&pair]])
                    }
                })
                .collect();
            let (before, after) = (&states[0][number], &states[1][number]);
            let interval = Interval { number, t, dt, before, after, limit };
            match others[..] {
                [] => flight(judged, &interval, findings),
                [other] => {
                    if let Form::HalfSpace(normal) = judged.body(other).form {
                        coulomb(judged, &interval, other, normal, findings);
                    }
                }
                _ => {}
            }
        }
    }
}

/// Whether a force besides gravity acts on a body.
fn is_loaded(judged: &Judged<'_>, number: usize) -> bool {
    judged.model.forces.iter().any(|force| match force {
        Force::Drag { .. } => true,
        Force::Anchored { body, .. } => *body == number,
        Force::Between { bodies, .. } => bodies.contains(&number),
    })
}

/// Whether two bodies may touch between two samples: their separation at both ends is no more than they may approach in
/// that time, as fast as they are at either end and half as fast again.
fn may_touch(judged: &Judged<'_>, pair: [usize; 2], states: [&Vec<State>; 2], dt: f64, apart: [f64; 2]) -> bool {
    let speed = |number: usize| {
        let body = judged.body(number);
        let reach = if matches!(body.form, Form::HalfSpace(_)) { 0.0 } else { body.form.reach() };
        let at = |states: &Vec<State>| {
            let state = &states[number];
            state.velocity.length() + state.angular_velocity.length() * 2.0 * reach
        };
        at(states[0]).max(at(states[1]))
    };
    let fall = judged.model.gravity.length() * dt;
    let most = 1.5 * dt * (speed(pair[0]) + speed(pair[1]) + fall) + LEAST_GAP;
    apart[0] <= most || apart[1] <= most
}

fn flight(judged: &Judged<'_>, interval: &Interval<'_>, findings: &mut Findings) {
    let Interval { number, t, dt, before, after, limit } = *interval;
    let gravity = judged.model.gravity;
    let speed = before.velocity.length() + gravity.length() * dt;
    let moved = judged.center(number, after) - judged.center(number, before);
    let off = (moved - before.velocity * dt - 0.5 * dt * dt * gravity).length() / dt;
    let gained = (after.velocity - before.velocity - gravity * dt).length();
    let spin = judged.spin(number, before);
    let turned = (judged.spin(number, after) - spin).length();
    let name = &judged.body(number).name;
    findings.hold("flight", off.max(gained), limit * (speed + ROUNDING), || {
        format!("t = {t} s: {name} is {off:.3e} m/s (path) and {gained:.3e} m/s (velocity) off its parabola")
    });
    findings.hold("flight", turned, limit * (spin.length() + f64::MIN_POSITIVE), || {
        format!("t = {t} s: the angular momentum of {name} in flight changes by {turned:.3e} of {:.3e}", spin.length())
    });
}

/// The impulse of a plane on a body that can touch nothing else.
fn coulomb(judged: &Judged<'_>, interval: &Interval<'_>, other: usize, normal: DVec3, findings: &mut Findings) {
    let Interval { number, t, dt, before, after, .. } = *interval;
    let limit = BOUNCES;
    let gravity = judged.model.gravity;
    let gained = after.velocity - before.velocity - gravity * dt;
    let pressed = gained.dot(normal);
    let along = (gained - normal * pressed).length();
    let materials = [number, other].map(|body| judged.model.materials[judged.body(body).material]);
    let friction = (materials[0].static_friction * materials[1].static_friction).sqrt();
    let scale = before.velocity.length() + after.velocity.length() + gravity.length() * dt;
    let name = &judged.body(number).name;
    findings.hold("Coulomb", -pressed, limit * scale, || {
        format!("t = {t} s: a plane pulls {name} by {:.3e} m/s", -pressed)
    });
    findings.hold("Coulomb", along - friction * pressed.max(0.0), limit * scale, || {
        format!("t = {t} s: a plane presses {name} by {pressed:.3e} m/s and rubs by {along:.3e} at friction {friction}")
    });
}
