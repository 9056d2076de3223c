//! What the method `exact-adaptive` promises: the error that was asked for, wherever on the motion the forces grow
//! strong; energy that does not drift; an attitude that nothing turns exact to rounding; states within a step as good
//! as at its end. And corners of signals: that no method under error control steps over a pulse.

use crate::support::{bits, body, dop853, turned_body};
use glam::DVec3;
use polhode_dynamics::field::{
    Anchor, AppliedForce, Drag, DragLaw, Field, Frame, PointGravity, Signal, Spring, corner_between,
};
use polhode_dynamics::integrator::{AdaptiveExact, IntegrationError, Integrator, Tolerance};
use polhode_dynamics::{BodyState, Flight, FreeMotion, RigidBody};
use polhode_spatial::{Pose, Rotation, Velocity};
use std::f64::consts::TAU;

fn adaptive(tolerance: f64) -> AdaptiveExact {
    AdaptiveExact::new(Tolerance::new(tolerance).unwrap())
}

fn tumbling(position: DVec3, velocity: DVec3) -> (RigidBody, BodyState) {
    let body = turned_body(2.0, DVec3::new(1.0, 2.0, 2.5), Rotation::from_rotation_vector(DVec3::new(0.3, 0.2, -0.4)));
    let velocity = Velocity::new(velocity, DVec3::new(3.0, -7.0, 5.0));
    (body, body.at_velocity(Pose::from_translation(position), velocity))
}

fn sun() -> Vec<Box<dyn Field>> {
    vec![Box::new(PointGravity::new(1.0, DVec3::ZERO).unwrap())]
}

/// A comet of eccentricity 0.9 that begins where all is slow comes back to its start after a period, whatever the step;
/// its spin, which no torque turns, is that of free rotation to rounding; its energy is what it was.
#[test]
fn comet_is_followed_past_its_sun() {
    // Semi-major axis one: aphelion at 1 + e, where v^2 = (1 - e)/(1 + e).
    let e = 0.9f64;
    let (body, start) = tumbling(DVec3::X * (1.0 + e), DVec3::Y * ((1.0 - e) / (1.0 + e)).sqrt());
    let (bodies, fields) = ([body], sun());
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    for (tolerance, steps) in [(1e-8, 10), (1e-8, 200), (1e-11, 200)] {
        let mut method = adaptive(tolerance);
        method.start(&motion, 0.0, &[start]);
        let (mut fewest, mut most) = (u32::MAX, 0);
        for _ in 0..steps {
            method.step(&motion, TAU / f64::from(steps)).unwrap();
            fewest = fewest.min(method.inner_steps());
            most = most.max(method.inner_steps());
        }
        let end = method.states()[0];
        let error = (end.pose.translation - start.pose.translation).length();
        assert!(error < 10.0 * tolerance, "{tolerance:e} in {steps}: {error:e}");
        let flight = Flight::new(&body, 0.0, &start, DVec3::ZERO).state(TAU);
        let turned = end.pose.rotation.angle_to(flight.pose.rotation);
        assert!(turned < 1e-11, "{turned:e}");
        let energy = motion.total_energy(&[start]);
        assert!((motion.total_energy(&[end]) - energy).abs() < tolerance * motion.kinetic_energy(&[start]));
        assert!(steps < 200 || most >= 4 * fewest, "{fewest} to {most} steps within one");
    }
}

/// Near a circle the steps stay equal, and the energy of some 300 turns oscillates but does not drift.
#[test]
fn energy_of_a_bound_motion_does_not_drift() {
    // Without spin, whose energy would drown that of the orbit in its rounding.
    let body = body(2.0, DVec3::ONE);
    let start = body.at_velocity(Pose::from_translation(DVec3::X), Velocity::new(DVec3::Y * 1.05, DVec3::ZERO));
    let (bodies, fields) = ([body], sun());
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let mut method = adaptive(1e-6);
    method.start(&motion, 0.0, &[start]);
    let energy = motion.total_energy(&[start]);
    let mut worst = [0.0f64; 2];
    for step in 0..9000 {
        method.step(&motion, TAU / 30.0).unwrap();
        let half = usize::from(step >= 4500);
        worst[half] = worst[half].max((motion.total_energy(method.states()) - energy).abs());
    }
    assert!(worst[1] < 1.2 * worst[0], "{worst:?}");
}

/// The time can be looked at in any order, within steps of many parts: the states are those of short steps.
#[test]
fn states_within_steps() {
    let (body, start) = tumbling(DVec3::X, DVec3::Y);
    let anchors = (Anchor::World(DVec3::Z * 3.0), Anchor::Body { body: 0, point: DVec3::new(0.5, 0.3, 0.4) });
    let fields: [Box<dyn Field>; 1] = [Box::new(Spring::new(anchors.0, anchors.1, 20.0, 1.0).unwrap())];
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &fields);
    let mut exact = dop853(1e-13);
    exact.start(&motion, 0.0, &[start]);
    exact.step(&motion, 2.0).unwrap();
    for steps in [1, 7] {
        let mut method = adaptive(1e-10);
        method.start(&motion, 0.0, &[start]);
        for _ in 0..steps {
            let from = method.time();
            method.step(&motion, 2.0 / f64::from(steps)).unwrap();
            let mut seen = Vec::new();
            for share in [0.1, 0.15, 0.9, 0.5, 0.1, 1.0, 0.0] {
                let t = if share < 1.0 { from + share * (method.time() - from) } else { method.time() };
                let (mut state, mut reference) = ([BodyState::default()], [BodyState::default()]);
                method.states_within(&motion, t, &mut state).unwrap();
                exact.states_within(&motion, t.min(2.0), &mut reference).unwrap();
                let error = (state[0].pose.translation - reference[0].pose.translation).length()
                    + state[0].pose.rotation.angle_to(reference[0].pose.rotation);
                assert!(error < 1e-9, "{t}: {error:e}");
                seen.push(bits(&state[0]));
            }
            assert_eq!(seen[0], seen[4], "the same time, the same state");
        }
    }
}

/// Time turned back leads to the start, to the tolerance; a body that nothing loads flies by its record to the last
/// bit.
#[test]
fn time_turned_back_and_unloaded_bodies() {
    let (body, start) = tumbling(DVec3::X, DVec3::Y);
    let bodies = [body, body];
    let fields: [Box<dyn Field>; 1] = [Box::new(AppliedForce::new(1, DVec3::X, Frame::Body).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z, &fields);
    let mut method = adaptive(1e-11);
    method.start(&motion, 0.0, &[start; 2]);
    method.step(&motion, 1.3).unwrap();
    let flight = Flight::new(&body, 0.0, &start, DVec3::NEG_Z);
    assert_eq!(bits(&method.states()[0]), bits(&flight.state(1.3)));
    method.step(&motion, -1.3).unwrap();
    let back = method.states()[1];
    assert!((back.pose.translation - start.pose.translation).length() < 1e-11);
    assert!((back.linear_velocity - start.linear_velocity).length() < 1e-11);
}

/// A fall into the sun, forces that depend on velocities and a limit of the steps are errors that leave everything as
/// it was.
#[test]
fn what_cannot_be_done_is_an_error() {
    let (body, start) = tumbling(DVec3::X, DVec3::ZERO);
    let (bodies, fields) = ([body], sun());
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let mut method = adaptive(1e-9).limited_to(1 << 12);
    method.start(&motion, 0.0, &[start]);
    let error = method.step(&motion, 2.0).unwrap_err();
    assert!(matches!(error, IntegrationError::StepTooSmall { .. } | IntegrationError::NotFinite { .. }), "{error}");
    assert_eq!((method.time(), method.states()), (0.0, &[start][..]));
    method.step(&motion, 0.1).unwrap();
    let mut few = adaptive(1e-12).limited_to(2);
    few.start(&motion, 0.0, &[start]);
    assert!(matches!(few.step(&motion, 1.0), Err(IntegrationError::StepTooSmall { .. })));
    let drag: [Box<dyn Field>; 1] = [Box::new(Drag::new(0, DragLaw::Linear, 0.5, 0.3).unwrap())];
    let dragged = FreeMotion::new(&bodies, DVec3::ZERO, &drag);
    method.start(&dragged, 0.0, &[start]);
    let refused = IntegrationError::VelocityDependentField { method: "exact-adaptive" };
    assert_eq!(method.step(&dragged, 0.1), Err(refused));
}

/// The corners of a table are its points, from either side and never the ends themselves.
#[test]
fn corners_of_signals() {
    let table = Signal::table(vec![(0.1, 0.0), (0.2, 5.0), (0.3, 0.0)]).unwrap();
    let cases = [
        (0.0, 1.0, Some(0.1)),
        (0.1, 1.0, Some(0.2)),
        (0.3, 1.0, None),
        (0.0, 0.1, None),
        (1.0, 0.0, Some(0.3)),
        (0.3, 0.0, Some(0.2)),
        (0.1, -1.0, None),
        (0.2, 0.1, None),
        (0.15, 0.15, None),
        (f64::NAN, 1.0, None),
    ];
    for (from, to, expected) in cases {
        assert_eq!(table.corner_between(from, to), expected, "{from} to {to}");
        let force = AppliedForce::new(0, DVec3::X, Frame::World).unwrap();
        let fields: Vec<Box<dyn Field>> =
            vec![Box::new(force.clone()), Box::new(force.following(table.clone())), sun().remove(0)];
        assert_eq!(corner_between(&fields, from, to), expected, "{from} to {to}");
    }
    assert_eq!(Signal::sinusoid(1.0, 2.0, 0.0).unwrap().corner_between(0.0, 1.0), None);
}

/// A pulse far shorter than a step is not passed over by DOP853, in either direction of time: `m v` is its area.
#[test]
fn pulse_is_not_stepped_over() {
    let bodies = [body(2.0, DVec3::ONE)];
    let pulse = Signal::table(vec![(0.5002, 0.0), (0.5003, 5.0), (0.5004, 0.0)]).unwrap();
    let force = AppliedForce::new(0, DVec3::Y, Frame::World).unwrap().following(pulse);
    let fields: [Box<dyn Field>; 1] = [Box::new(force)];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let mut method = dop853(1e-10);
    method.start(&motion, 0.0, &[BodyState::default()]);
    method.step(&motion, 1.0).unwrap();
    let speed = method.states()[0].linear_velocity.y;
    assert!((speed * 2.0 / (0.5 * 5.0 * 2e-4) - 1.0).abs() < 1e-9, "{speed}");
    method.step(&motion, -1.0).unwrap();
    assert!(
        method.states()[0].linear_velocity.length() < 1e-12 && method.states()[0].pose.translation.length() < 1e-12
    );
}
