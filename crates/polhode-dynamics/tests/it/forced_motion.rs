//! Motions under force fields that have closed forms: the orbit, the oscillator, drag, thrust and torque.

use crate::support::{body, dop853, order};
use glam::DVec3;
use polhode_dynamics::field::{
    Account, Anchor, AppliedForce, AppliedTorque, Damper, Drag, DragLaw, Field, Frame, MutualGravity, PointGravity,
    Signal, Spring,
};
use polhode_dynamics::integrator::{Exact, IntegrationError, Integrator};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::{Pose, Velocity};

const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);

/// The states after `t` in `steps` steps.
fn run(
    method: &mut dyn Integrator,
    motion: &FreeMotion<'_>,
    start: &[BodyState],
    t: f64,
    steps: u32,
) -> Vec<BodyState> {
    method.start(motion, 0.0, start);
    for _ in 0..steps {
        method.step(motion, t / f64::from(steps)).unwrap();
    }
    method.states().to_vec()
}

fn moving(body: &RigidBody, position: DVec3, velocity: DVec3) -> BodyState {
    body.at_velocity(Pose::from_translation(position), Velocity::new(velocity, DVec3::ZERO))
}

/// Kepler's orbit about a point with `mu = 1`, semi-major axis one and eccentricity e, from perihelion: position and
/// velocity after `t`, by Kepler's equation.
fn kepler(e: f64, t: f64) -> (DVec3, DVec3) {
    let mut anomaly = t;
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - t) / (1.0 - e * anomaly.cos());
    }
    let (s, c) = anomaly.sin_cos();
    let minor = (1.0 - e * e).sqrt();
    (DVec3::new(c - e, minor * s, 0.0), DVec3::new(-s, minor * c, 0.0) / (1.0 - e * c))
}

/// An orbit of eccentricity 0.6 over two and a half turns: DOP853 to its tolerance, Blanes and Moan to order 4.
#[test]
fn kepler_orbit() {
    let bodies = [body(3.0, DVec3::new(1e-3, 2e-3, 2e-3))];
    let center = DVec3::new(5.0, -2.0, 1.0);
    let fields: [Box<dyn Field>; 1] = [Box::new(PointGravity::new(1.0, center).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let t = 16.0;
    let ((p0, v0), (p, v)) = (kepler(0.6, 0.0), kepler(0.6, t));
    let start = [moving(&bodies[0], p0 + center, v0)];
    let end = run(&mut dop853(1e-12), &motion, &start, t, 8)[0];
    assert!((end.pose.translation - center - p).length() < 1e-11, "{:e}", (end.pose.translation - center - p).length());
    assert!((end.linear_velocity - v).length() < 1e-11);
    let error = |steps| {
        let end = run(&mut Exact::blanes_moan(), &motion, &start, t, steps)[0];
        (end.pose.translation - center - p).length()
    };
    let errors = [400, 800, 1600].map(error);
    for pair in errors.windows(2) {
        assert!((order(pair[0], pair[1]) - 4.0).abs() < 0.1, "{errors:?}");
    }
    assert!(errors[2] < 1e-7, "{errors:?}");
}

/// Two bodies that attract each other: their difference follows Kepler's orbit, their centre moves straight.
#[test]
fn two_bodies_orbit_each_other() {
    let (m1, m2) = (3.0, 1.0);
    let bodies = [body(m1, DVec3::ONE), body(m2, DVec3::ONE)];
    // G (m1 + m2) = 1.
    let fields: [Box<dyn Field>; 1] = [Box::new(MutualGravity::new(0.25).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let ((p0, v0), (p, _)) = (kepler(0.3, 0.0), kepler(0.3, 10.0));
    let drift = DVec3::new(0.1, 0.2, 0.3);
    let start = [moving(&bodies[0], p0 * -0.25, v0 * -0.25 + drift), moving(&bodies[1], p0 * 0.75, v0 * 0.75 + drift)];
    let methods: [(Box<dyn Integrator>, u32, f64); 2] =
        [(Box::new(dop853(1e-12)), 5, 1e-11), (Box::new(Exact::blanes_moan()), 4000, 1e-10)];
    for (mut method, steps, tolerance) in methods {
        let end = run(&mut *method, &motion, &start, 10.0, steps);
        let (a, b) = (end[0].pose.translation, end[1].pose.translation);
        assert!((b - a - p).length() < tolerance, "{:e}", (b - a - p).length());
        // Impulses cancel to the last bit; what is left is the rounding of up to 5e4 sums.
        let center = (a * 0.75 + b * 0.25 - drift * 10.0).length();
        assert!(center < 1e-12, "{center:e}");
    }
}

/// A mass on a spring without rest length, off its centre: an isotropic oscillator about where the weight holds it.
#[test]
fn harmonic_oscillator() {
    let bodies = [body(2.0, DVec3::ONE)];
    let hook = DVec3::new(1.0, 2.0, 3.0);
    let end = Anchor::Body { body: 0, point: DVec3::ZERO };
    let fields: [Box<dyn Field>; 1] = [Box::new(Spring::new(Anchor::World(hook), end, 18.0, 0.0).unwrap())];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    // w^2 = k/m = 9.
    let rest = hook + GRAVITY / 9.0;
    let (x, v) = (DVec3::new(0.3, -0.2, 0.5), DVec3::new(1.0, 0.4, -0.7));
    let start = [moving(&bodies[0], rest + x, v)];
    let exact = rest + x * 30f64.cos() + v * (30f64.sin() / 3.0);
    let error = |method: &mut dyn Integrator, steps| {
        (run(method, &motion, &start, 10.0, steps)[0].pose.translation - exact).length()
    };
    assert!(error(&mut dop853(1e-12), 10) < 1e-11);
    let errors = [200, 400, 800].map(|steps| error(&mut Exact::strang(), steps));
    assert!(errors.windows(2).all(|pair| (order(pair[0], pair[1]) - 2.0).abs() < 0.05), "{errors:?}");
    let errors = [200, 400, 800].map(|steps| error(&mut Exact::blanes_moan(), steps));
    assert!(errors.windows(2).all(|pair| (order(pair[0], pair[1]) - 4.0).abs() < 0.1), "{errors:?}");
}

/// A spring with a damper along one line: `x = exp(-d t) (x0 cos w t + (v0 + d x0)/w sin w t)`.
#[test]
fn damped_oscillator() {
    let bodies = [body(2.0, DVec3::ONE)];
    let (wall, end) = (Anchor::World(DVec3::X * -1.5), Anchor::Body { body: 0, point: DVec3::ZERO });
    let fields: [Box<dyn Field>; 2] =
        [Box::new(Spring::new(wall, end, 18.0, 1.5).unwrap()), Box::new(Damper::new(wall, end, 1.6).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let start = [moving(&bodies[0], DVec3::X * 0.5, DVec3::X)];
    let (d, t) = (0.4f64, 5.0f64);
    let w = (9.0 - d * d).sqrt();
    let exact = (-d * t).exp() * (0.5 * (w * t).cos() + (1.0 + d * 0.5) / w * (w * t).sin());
    let end = run(&mut dop853(1e-12), &motion, &start, t, 3)[0];
    assert!((end.pose.translation.x - exact).abs() < 1e-11, "{} {exact}", end.pose.translation.x);
    let mut splitting = Exact::blanes_moan();
    splitting.start(&motion, 0.0, &start);
    assert_eq!(splitting.step(&motion, 0.1), Err(IntegrationError::VelocityDependentField { method: "exact" }));
    assert_eq!(splitting.states(), start, "a step that failed leaves the states alone");
}

/// Linear drag under gravity in a wind: the velocity relaxes to the terminal one, `v = u + g/k + (v0 - u - g/k) exp(-k
/// t)` with `k = c/m`; a spin about a principal axis dies out likewise.
#[test]
fn linear_drag() {
    let bodies = [body(2.0, DVec3::new(1.0, 2.0, 3.0))];
    let wind = DVec3::new(4.0, 0.0, 1.0);
    let drag = Drag::new(0, DragLaw::Linear, 1.2, 0.9).unwrap().in_wind(wind).unwrap();
    let fields: [Box<dyn Field>; 1] = [Box::new(drag)];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let v0 = DVec3::new(5.0, 1.0, 10.0);
    let start = [bodies[0].at_velocity(Pose::IDENTITY, Velocity::new(v0, DVec3::Z * 7.0))];
    let (k, t) = (0.6, 4.0);
    let end = run(&mut dop853(1e-12), &motion, &start, t, 2)[0];
    let terminal = wind + GRAVITY / k;
    let decay = f64::exp(-k * t);
    let velocity = terminal + (v0 - terminal) * decay;
    let position = terminal * t + (v0 - terminal) * ((1.0 - decay) / k);
    assert!((end.linear_velocity - velocity).length() < 1e-11);
    assert!((end.pose.translation - position).length() < 1e-11);
    let spin = bodies[0].angular_velocity(&end);
    assert!((spin - DVec3::Z * (7.0 * f64::exp(-0.3 * t))).length() < 1e-11);
}

/// Quadratic drag: a fall from rest has `v = v_t tanh(g t/v_t)`, `z = v_t^2/g ln cosh(g t/v_t)`, and ends at the
/// terminal speed `v_t = sqrt(m g/c)`; a spin dies out as `w0/(1 + k w0 t/I)`.
#[test]
fn quadratic_drag() {
    let bodies = [body(2.0, DVec3::new(1.0, 2.0, 3.0))];
    let fields: [Box<dyn Field>; 1] = [Box::new(Drag::new(0, DragLaw::Quadratic, 0.5, 0.6).unwrap())];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let start = [bodies[0].at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, DVec3::Z * 5.0))];
    let terminal = f64::sqrt(2.0 * 9.81 / 0.5);
    for t in [0.5, 2.0, 20.0] {
        let end = run(&mut dop853(1e-12), &motion, &start, t, 1)[0];
        let x = 9.81 * t / terminal;
        assert!((end.linear_velocity.z + terminal * x.tanh()).abs() < 1e-10, "{t}");
        assert!((end.pose.translation.z + terminal * terminal / 9.81 * x.cosh().ln()).abs() < 1e-10, "{t}");
        let spin = 5.0 / (1.0 + 0.6 * 5.0 * t / 3.0);
        assert!((bodies[0].angular_velocity(&end).z - spin).abs() < 1e-11);
    }
}

/// A torque fixed in a symmetric body along its axis: `w3 = w30 + tau t/C`, and the transverse part of the angular
/// velocity turns in the body by the angle `(C - A)/A (w30 t + tau t^2/(2 C))`.
#[test]
fn body_torque_along_the_axis_of_a_symmetric_body() {
    let (a, c, torque, t) = (2.0, 3.0, 1.5, 6.0);
    let bodies = [body(1.0, DVec3::new(a, a, c))];
    let fields: [Box<dyn Field>; 1] = [Box::new(AppliedTorque::new(0, DVec3::Z * torque, Frame::Body).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let w0 = DVec3::new(0.8, -0.3, 0.7);
    let start = [bodies[0].at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, w0))];
    let turn = (c - a) / a * (w0.z * t + torque * t * t / (2.0 * c));
    let (s, k) = turn.sin_cos();
    let exact = DVec3::new(w0.x * k - w0.y * s, w0.x * s + w0.y * k, w0.z + torque * t / c);
    let methods: [(Box<dyn Integrator>, u32, f64); 2] =
        [(Box::new(dop853(1e-12)), 3, 1e-11), (Box::new(Exact::blanes_moan()), 6000, 1e-11)];
    for (mut method, steps, tolerance) in methods {
        let end = run(&mut *method, &motion, &start, t, steps)[0];
        let rate = end.pose.rotation.inverse_rotate(bodies[0].angular_velocity(&end));
        assert!((rate - exact).length() < tolerance, "{:e}", (rate - exact).length());
    }
}

/// A shaken body, `F = f sin(2 pi nu t + phase)`: the splitting evaluates the force at the right times, to its order.
#[test]
fn shaken_body() {
    let bodies = [body(2.0, DVec3::ONE)];
    let (nu, phase, f) = (0.5f64, 0.4f64, 3.0);
    let shake =
        |frame| AppliedForce::new(0, DVec3::X * f, frame).unwrap().following(Signal::sinusoid(1.0, nu, phase).unwrap());
    let fields: [Box<dyn Field>; 1] = [Box::new(shake(Frame::World))];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let (start, t) = ([BodyState::default()], 5.3);
    let w = std::f64::consts::TAU * nu;
    let exact = f / 2.0 * (t * phase.cos() / w + (phase.sin() - (w * t + phase).sin()) / (w * w));
    let error = |method: &mut dyn Integrator, steps| {
        (run(method, &motion, &start, t, steps)[0].pose.translation.x - exact).abs()
    };
    assert!(error(&mut dop853(1e-12), 1) < 1e-11);
    let errors = [100, 200, 400].map(|steps| error(&mut Exact::strang(), steps));
    assert!(errors.windows(2).all(|pair| (order(pair[0], pair[1]) - 2.0).abs() < 0.05), "{errors:?}");
    let errors = [40, 80, 160].map(|steps| error(&mut Exact::blanes_moan(), steps));
    assert!(errors.windows(2).all(|pair| (order(pair[0], pair[1]) - 4.0).abs() < 0.1), "{errors:?}");
}

/// Constant thrust along the axis of a spinning body is a thrust along a fixed direction: `x = t^2 F/(2 m)`.
#[test]
fn spinning_rocket() {
    let bodies = [body(2.0, DVec3::new(2.0, 2.0, 3.0))];
    let fields: [Box<dyn Field>; 1] = [Box::new(AppliedForce::new(0, DVec3::Z * 4.0, Frame::Body).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let start = [bodies[0].at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, DVec3::Z * 20.0))];
    for mut method in [Box::new(dop853(1e-12)) as Box<dyn Integrator>, Box::new(Exact::strang())] {
        let end = run(&mut *method, &motion, &start, 3.0, 3)[0];
        assert!((end.pose.translation - DVec3::Z * 9.0).length() < 1e-13 * 9.0);
        assert!((bodies[0].angular_velocity(&end) - DVec3::Z * 20.0).length() < 1e-12);
    }
}

/// Every joule is accounted for: over a motion with a spring, a damper, drag, wind and a motor, the change of the total
/// energy is the work of dampers and of what is outside, their power integrated over the states within the steps.
#[test]
fn energy_is_accounted_for() {
    let bodies = [body(2.0, DVec3::new(1.0, 2.0, 2.5)), body(1.0, DVec3::new(0.3, 0.2, 0.4))];
    let ends = (Anchor::Body { body: 0, point: DVec3::X * 0.5 }, Anchor::Body { body: 1, point: DVec3::Y * 0.3 });
    let motor = AppliedTorque::new(1, DVec3::X, Frame::Body).unwrap();
    let fields: Vec<Box<dyn Field>> = vec![
        Box::new(Spring::new(ends.0, ends.1, 8.0, 1.0).unwrap()),
        Box::new(Damper::new(ends.0, ends.1, 0.7).unwrap()),
        Box::new(Drag::new(0, DragLaw::Quadratic, 0.1, 0.2).unwrap()),
        Box::new(Drag::new(1, DragLaw::Linear, 0.2, 0.1).unwrap().in_wind(DVec3::Y).unwrap()),
        Box::new(motor.following(Signal::sinusoid(0.4, 1.0, 0.0).unwrap())),
    ];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let start = [moving(&bodies[0], DVec3::ZERO, DVec3::Y), moving(&bodies[1], DVec3::X * 2.0, DVec3::Z)];
    let mut method = dop853(1e-12);
    method.start(&motion, 0.0, &start);
    let (mut damping, mut external) = (0.0, 0.0);
    // Gauss and Legendre's four points, of order 8, on steps of 0.02.
    let points = [(0.861136311594052575, 0.347854845137453857), (0.339981043584856265, 0.652145154862546143)];
    let mut within = start;
    for _ in 0..100 {
        let from = method.time();
        method.step(&motion, 0.02).unwrap();
        let (middle, half) = (0.5 * (from + method.time()), 0.5 * (method.time() - from));
        for (x, weight) in points.into_iter().flat_map(|(x, weight)| [(x, weight), (-x, weight)]) {
            let t = middle + half * x;
            method.states_within(&motion, t, &mut within).unwrap();
            damping += half * weight * motion.power(t, &within, Account::Damping);
            external += half * weight * motion.power(t, &within, Account::External);
        }
    }
    let change = motion.total_energy(method.states()) - motion.total_energy(&start);
    assert!(damping < -0.1 && external.abs() > 0.1, "{damping} {external}");
    assert!((change - damping - external).abs() < 1e-10, "{change} {damping} {external}");
}
