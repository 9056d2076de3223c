//! Symmetric tops on a pivot under gravity: validation cases HT-01, HT-02, HT-03, HT-05 (elliptic integrals, 20
//! digits).
//!
//! Moments about the pivot A = 1 (transverse) and C = 0.5 (axial), m = 1, the centre of mass at l = 0.5 on the axis,
//! g = 9.81. Attitude by Euler angles z-x-z: phi, theta, psi.

use crate::support::dop853;
use glam::DVec3;
use polhode_dynamics::integrator::{Exact, Integrator, event};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI, TAU};

const A: f64 = 1.0;
const C: f64 = 0.5;
const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);

/// The top. Its mass properties are in a frame with the tip as origin.
fn top() -> RigidBody {
    let inertia = Inertia::from_diagonal(DVec3::new(0.75, 0.75, C)).unwrap();
    let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::Z * 0.5, inertia);
    let top = RigidBody::pivoted(&properties, DVec3::ZERO);
    assert_eq!(top.moments(), DVec3::new(A, A, C));
    top
}

/// Axis tilted by `theta` about x (so towards -y), spinning at `w3` about itself, precessing at `rate` about z.
fn tilted(top: &RigidBody, theta: f64, w3: f64, rate: f64) -> BodyState {
    let rotation = Rotation::from_rotation_vector(DVec3::X * theta);
    let axis = rotation.rotate(DVec3::Z);
    let spin = axis * (w3 - rate * axis.z) + DVec3::Z * rate;
    top.at_velocity(
        Pose::from_translation(DVec3::new(1.0, 2.0, 3.0)) * Pose::new(rotation, DVec3::ZERO),
        Velocity::new(DVec3::ZERO, spin),
    )
}

fn axis(state: &BodyState) -> DVec3 {
    state.pose.rotation.rotate(DVec3::Z)
}

fn theta(state: &BodyState) -> f64 {
    let axis = axis(state);
    axis.x.hypot(axis.y).atan2(axis.z)
}

/// Rate of theta: the angular velocity along the line of nodes.
fn theta_rate(top: &RigidBody, state: &BodyState) -> f64 {
    top.angular_velocity(state).dot(DVec3::Z.cross(axis(state)).normalize())
}

/// Angle of precession: that of the line of nodes, in (-pi, pi].
fn phi(state: &BodyState) -> f64 {
    let axis = axis(state);
    axis.x.atan2(-axis.y)
}

/// An angle brought within pi of `near`.
fn near(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}

/// The two methods, at their best.
fn methods() -> [(Box<dyn Integrator>, f64); 2] {
    [(Box::new(dop853(1e-13)), 0.05), (Box::new(Exact::blanes_moan()), 1e-3)]
}

/// Runs to `t`.
fn run(method: &mut dyn Integrator, motion: &FreeMotion<'_>, start: &BodyState, t: f64, step: f64) -> BodyState {
    method.start(motion, 0.0, &[*start]);
    let steps = (t / step).round();
    for _ in 0..steps as usize {
        method.step(motion, t / steps).unwrap();
    }
    method.states()[0]
}

/// Times and states of the first `count` changes of sign of the rate of theta.
fn turning_points(
    method: &mut dyn Integrator,
    motion: &FreeMotion<'_>,
    start: &BodyState,
    step: f64,
    count: usize,
) -> Vec<(f64, BodyState)> {
    method.start(motion, 0.0, &[*start]);
    let mut found = Vec::new();
    for _ in 0..100_000 {
        let mut from = method.time();
        method.step(motion, step).unwrap();
        let top = motion.bodies()[0];
        while let Some(t) = event::locate(method, motion, from, &mut |_, s| theta_rate(&top, &s[0])).unwrap() {
            let mut state = [BodyState::default()];
            method.states_within(motion, t, &mut state).unwrap();
            found.push((t, state[0]));
            from = t;
        }
        if found.len() >= count {
            return found;
        }
    }
    found
}

fn relative(value: f64, reference: f64, tolerance: f64) {
    let error = value / reference - 1.0;
    assert!(error.abs() < tolerance, "{value} for {reference}: {error:e}");
}

/// HT-01 and HT-05: started at a rate of steady precession, the axis keeps its tilt and goes round at that rate.
#[test]
fn steady_precession() {
    let top = top();
    let bodies = [top];
    let motion = FreeMotion::new(&bodies, GRAVITY, &[]);
    let cases = [(FRAC_PI_6, 20.0, 0.5133195018749154), (FRAC_PI_6, 20.0, 11.0336858819176), (FRAC_PI_2, 50.0, 0.1962)];
    for (tilt, w3, rate) in cases {
        let start = tilted(&top, tilt, w3, rate);
        for (mut method, step) in methods() {
            let end = run(&mut *method, &motion, &start, 10.0, step);
            relative(near(phi(&end), rate * 10.0) / 10.0, rate, 1e-11);
            assert!((theta(&end) - tilt).abs() < 1e-11, "{:e}", theta(&end) - tilt);
            assert_eq!(end.pose.translation, DVec3::new(1.0, 2.0, 3.0), "the pivot stays");
        }
    }
}

/// HT-01: frequency of small nutation about the slow steady state.
#[test]
fn small_nutation() {
    let top = top();
    let bodies = [top];
    let motion = FreeMotion::new(&bodies, GRAVITY, &[]);
    let mut start = tilted(&top, FRAC_PI_6, 20.0, 0.5133195018749154);
    // A nutation of 1e-4 rad shifts the frequency by the square of that.
    start.angular_momentum += DVec3::X * 1e-4;
    let (mut method, step) = (dop853(1e-13), 0.05);
    let turns = turning_points(&mut method, &motion, &start, step, 21);
    relative(20.0 * PI / (turns[20].0 - turns[0].0), 9.114518956341064, 1e-6);
}

/// HT-02: released with its axis at rest the top falls, and rises again to a cusp.
#[test]
fn cuspidal_nutation() {
    let top = top();
    let bodies = [top];
    let motion = FreeMotion::new(&bodies, GRAVITY, &[]);
    let start = tilted(&top, FRAC_PI_6, 20.0, 0.0);
    for (mut method, step) in methods() {
        let turns = turning_points(&mut *method, &motion, &start, step, 2);
        relative(theta(&turns[0].1).to_degrees(), 33.21899743126117, 1e-10);
        relative(turns[1].0, 0.6878412233185921, 1e-10);
        relative(phi(&turns[1].1), 0.3525051159705355, 1e-10);
        relative(phi(&turns[1].1) / turns[1].0, 0.5124803574142042, 1e-10);
        let end = run(&mut *method, &motion, &start, 10.0, step);
        let close = |value: f64, reference: f64| {
            assert!((value - reference).abs() < 1e-9, "{value} for {reference}");
        };
        let precession = phi(&end);
        close(theta(&end), 0.5790072375106643);
        close(theta_rate(&top, &end), -0.058576941606281706);
        close(near(precession, 5.137022928469412), 5.137022928469412);
        // What is left of the attitude when phi and theta are taken off is the turn psi about the axis.
        let turn = |axis: DVec3, angle: f64| Rotation::from_rotation_vector(axis * angle);
        let spun = (turn(DVec3::Z, precession) * turn(DVec3::X, theta(&end))).inverse() * end.pose.rotation;
        let psi = 2.0 * spun.quaternion().z.atan2(spun.quaternion().w);
        close(near(psi, 195.66310203523028), 195.66310203523028);
        let expected = DVec3::new(-0.49859680748575785, -0.22543665474646205, 0.8370062952342322);
        assert!((axis(&end) - expected).length() < 1e-9);
    }
}

/// HT-03: an upright top sleeps above a critical spin and falls below it.
#[test]
fn sleeping_top() {
    let top = top();
    let bodies = [top];
    let motion = FreeMotion::new(&bodies, GRAVITY, &[]);
    let critical = 8.858893836140041;
    let mut method = dop853(1e-13);
    // Growth in the linear phase, once what decays has gone: at 15 s the tilt is 2e-3 rad, its square below 1e-5.
    let start = tilted(&top, 1e-9, 0.9 * critical, 0.0);
    let early = theta(&run(&mut method, &motion, &start, 10.0, 0.1));
    let late = theta(&run(&mut method, &motion, &start, 15.0, 0.1));
    relative((late / early).ln() / 5.0, 0.9653755745822452, 1e-4);
    // How far it falls, and the spin at which it no longer would: cos theta + 1 is linear in the square of the spin.
    let mut fall = |spin: f64| {
        let start = tilted(&top, 1e-9, spin, 0.0);
        theta(&turning_points(&mut method, &motion, &start, 0.1, 1)[0].1)
    };
    relative(fall(0.9 * critical).to_degrees(), 51.68386552633426, 1e-6);
    let (slow, fast) = (8.0f64, 8.5f64);
    let (c_slow, c_fast) = (1.0 + fall(slow).cos(), 1.0 + fall(fast).cos());
    let slope = (c_fast - c_slow) / (fast * fast - slow * slow);
    relative((slow * slow + (2.0 - c_slow) / slope).sqrt(), critical, 1e-4);
    // Just above the critical spin a tilt stays as small as it was, to the ratio that the frequency's difference
    // allows.
    let mut above = Exact::blanes_moan();
    let start = tilted(&top, 1e-6, 1.01 * critical, 0.0);
    above.start(&motion, 0.0, &[start]);
    for _ in 0..20_000 {
        above.step(&motion, 0.01).unwrap();
        assert!(theta(&above.states()[0]) < 1e-5);
    }
}
