//! What the methods `exact`, `exact-strang` and `dop853` promise as integrators: exact flights, states within a step,
//! errors that leave everything as it was.

use crate::support::{bits, body, dop853, order, spin, turned_body};
use glam::DVec3;
use polhode_dynamics::field::{
    Anchor, AppliedForce, Drag, DragLaw, Field, Frame, PointGravity, Signal, Spring, Wrench,
};
use polhode_dynamics::free_motion::BufferedMotion;
use polhode_dynamics::integrator::{Exact, IntegrationError, Integrator, Tolerance};
use polhode_dynamics::{BodyState, Flight, FreeMotion, RigidBody, System, rk4, state};
use polhode_spatial::{Pose, Rotation, Velocity};

const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);

/// A tumbling body with turned axes, thrown.
fn thrown() -> (RigidBody, BodyState) {
    let body = turned_body(2.0, DVec3::new(1.0, 2.0, 2.5), Rotation::from_rotation_vector(DVec3::new(0.3, 0.2, -0.4)));
    let velocity = Velocity::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, -2.0, 0.5));
    (body, body.at_velocity(Pose::from_translation(DVec3::ONE), velocity))
}

/// A body hung off its centre from a spring: translation and rotation are coupled.
fn hung() -> (RigidBody, BodyState, Vec<Box<dyn Field>>) {
    let (body, state) = thrown();
    let (a, b) = (Anchor::World(DVec3::Z * 3.0), Anchor::Body { body: 0, point: DVec3::new(0.5, 0.3, 0.4) });
    (body, state, vec![Box::new(Spring::new(a, b, 20.0, 1.0).unwrap())])
}

/// Without loads the states are those of the flight to the last bit, however the time is divided, and they are within
/// steps too.
#[test]
fn unloaded_bodies_fly_by_their_record() {
    let (body, start) = thrown();
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, GRAVITY, &[]);
    let flight = Flight::new(&body, 0.5, &start, GRAVITY);
    for (mut method, steps) in [(Exact::blanes_moan(), 1), (Exact::blanes_moan(), 64), (Exact::strang(), 7)] {
        method.start(&motion, 0.5, &[start]);
        for _ in 0..steps {
            let from = method.time();
            method.step(&motion, 8.0 / f64::from(steps)).unwrap();
            assert_eq!(bits(&method.states()[0]), bits(&flight.state(method.time())));
            let mut within = [BodyState::default()];
            let t = 0.3 * from + 0.7 * method.time();
            method.states_within(&motion, t, &mut within).unwrap();
            assert_eq!(bits(&within[0]), bits(&flight.state(t)));
        }
    }
}

/// A field that acts on one body leaves the other's flight exact.
#[test]
fn fields_leave_other_bodies_alone() {
    let (body, start) = thrown();
    let bodies = [body, body];
    let fields: [Box<dyn Field>; 1] = [Box::new(AppliedForce::new(1, DVec3::X, Frame::World).unwrap())];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let mut method = Exact::blanes_moan();
    method.start(&motion, 0.0, &[start, start]);
    for _ in 0..10 {
        method.step(&motion, 0.1).unwrap();
    }
    let flight = Flight::new(&body, 0.0, &start, GRAVITY);
    assert_eq!(bits(&method.states()[0]), bits(&flight.state(method.time())));
    // A constant force is a parabola, which the splitting follows exactly: x += t^2 F/(2 m).
    let pushed = method.states()[1].pose.translation - method.states()[0].pose.translation;
    assert!((pushed - DVec3::X * 0.25).length() < 1e-14);
}

/// Within its steps a method is as good as at their ends: the error at the middle of steps falls with its order.
#[test]
fn states_within_steps_have_the_order_of_the_method() {
    let (body, start, fields) = hung();
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let times = [0.37, 1.03, 1.61, 1.99];
    // The worst error at the times, none of which ends a step, and at the end.
    let states = |method: &mut dyn Integrator, steps: u32| {
        method.start(&motion, 0.0, &[start]);
        let mut found = Vec::new();
        for _ in 0..steps {
            let from = method.time();
            method.step(&motion, 2.0 / f64::from(steps)).unwrap();
            let to = method.time();
            for t in times.into_iter().filter(|&t| from < t && t <= to) {
                let mut within = [BodyState::default()];
                method.states_within(&motion, t, &mut within).unwrap();
                found.push(within[0]);
            }
        }
        assert_eq!(found.len(), times.len());
        found
    };
    let exact = states(&mut dop853(1e-13), 40);
    let error = |method: &mut dyn Integrator, steps| {
        let distance = |(a, b): (&BodyState, &BodyState)| {
            (a.pose.translation - b.pose.translation).length() + a.pose.rotation.angle_to(b.pose.rotation)
        };
        states(method, steps).iter().zip(&exact).map(distance).fold(0.0, f64::max)
    };
    for (mut method, expected) in [(Exact::strang(), 2.0), (Exact::blanes_moan(), 4.0)] {
        let errors = [80, 160, 320, 640].map(|steps| error(&mut method, steps));
        // The times fall on different parts of the steps, so the errors fall evenly only on the whole.
        let overall = order(errors[0], errors[3]) / 3.0;
        assert!((overall - expected).abs() < 0.15, "{overall} {errors:?}");
    }
    // Under error control: within the tolerance, also far inside one long step, and with every step.
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        for steps in [1, 3, 100] {
            let error = error(&mut dop853(tolerance), steps);
            assert!(error < 10.0 * tolerance, "{tolerance:e}, {steps} steps: {error:e}");
        }
    }
}

/// Time turned back leads to the start: to round-off for the symmetric methods, to the tolerance for the other.
#[test]
fn time_can_be_turned_back() {
    let (body, start, fields) = hung();
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let methods: [(Box<dyn Integrator>, f64); 3] =
        [(Box::new(Exact::strang()), 1e-12), (Box::new(Exact::blanes_moan()), 1e-12), (Box::new(dop853(1e-11)), 1e-10)];
    for (mut method, tolerance) in methods {
        method.start(&motion, 0.0, &[start]);
        for h in [0.05; 20].into_iter().chain([-0.05; 20]) {
            method.step(&motion, h).unwrap();
        }
        assert!(method.time().abs() < 1e-15);
        let end = method.states()[0];
        let error = (end.pose.translation - start.pose.translation).length()
            + end.pose.rotation.angle_to(start.pose.rotation)
            + (end.angular_momentum - start.angular_momentum).length();
        assert!(error < tolerance, "{method:?}: {error:e}");
    }
}

/// Translated by 1e6 m the motion is the same to the rounding of the positions.
#[test]
fn far_from_the_origin() {
    let (body, start) = thrown();
    let bodies = [body];
    let run = |offset: DVec3| {
        let (a, b) = (Anchor::World(DVec3::Z * 3.0 + offset), Anchor::Body { body: 0, point: DVec3::X * 0.5 });
        let fields: [Box<dyn Field>; 1] = [Box::new(Spring::new(a, b, 20.0, 1.0).unwrap())];
        let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
        let mut method = dop853(1e-12);
        let mut state = start;
        state.pose.translation += offset;
        method.start(&motion, 0.0, &[state]);
        method.step(&motion, 1.0).unwrap();
        (method.states()[0].pose.translation - offset, method.accepted_steps())
    };
    let ((near, few), (far, many)) = (run(DVec3::ZERO), run(DVec3::splat(1e6)));
    assert!((near - far).length() < 1e-8, "{:e}", (near - far).length());
    assert!(many <= 2 * few, "rounding is not mistaken for error: {many} steps for {few}");
}

/// Fields that depend on velocities are refused by name, with the method that takes them.
#[test]
fn velocity_dependent_fields_need_dop853() {
    let (body, start) = thrown();
    let bodies = [body];
    let fields: [Box<dyn Field>; 1] = [Box::new(Drag::new(0, DragLaw::Linear, 1.0, 1.0).unwrap())];
    let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    for (mut method, name) in [(Exact::blanes_moan(), "exact"), (Exact::strang(), "exact-strang")] {
        method.start(&motion, 0.0, &[start]);
        let error = method.step(&motion, 0.1).unwrap_err();
        assert_eq!(error, IntegrationError::VelocityDependentField { method: name });
        assert!(error.to_string().contains("dop853"));
        assert_eq!((method.time(), method.states()), (0.0, &[start][..]));
    }
    let mut method = dop853(1e-9);
    method.start(&motion, 0.0, &[start]);
    assert_eq!(method.step(&motion, 0.1), Ok(()));
}

/// Wrong counts, times outside the step, steps and states that are not finite, a force that becomes so: typed errors,
/// and the states are those before.
#[test]
fn failed_steps_change_nothing() {
    let (body, start, _) = hung();
    let bodies = [body];
    let bad: [Box<dyn Field>; 1] = [Box::new(
        AppliedForce::new(0, DVec3::X, Frame::World).unwrap().following(Signal::from_fn(|t| (0.3 - t).sqrt())),
    )];
    let fine = FreeMotion::new(&bodies, GRAVITY, &[]);
    let failing = FreeMotion::new(&bodies, GRAVITY, &bad);
    let methods: [Box<dyn Integrator>; 3] =
        [Box::new(Exact::blanes_moan()), Box::new(Exact::strang()), Box::new(dop853(1e-9))];
    for mut method in methods {
        method.start(&fine, 0.0, &[start; 2]);
        assert_eq!(method.step(&fine, 0.1), Err(IntegrationError::StateCount { states: 2, bodies: 1 }));
        method.start(&failing, 0.0, &[start]);
        method.step(&failing, 0.2).unwrap();
        let before = method.states().to_vec();
        let error = method.step(&failing, 0.2).unwrap_err();
        assert!(matches!(error, IntegrationError::NotFinite { .. }), "{method:?}: {error:?}");
        for h in [f64::NAN, f64::INFINITY] {
            assert!(matches!(method.step(&failing, h), Err(IntegrationError::NotFinite { .. })));
        }
        assert_eq!((method.time(), method.states()), (0.2, &before[..]));
        let mut within = [BodyState::default()];
        method.states_within(&failing, 0.1, &mut within).unwrap();
        assert!(within[0].is_finite(), "the last step that succeeded can still be asked");
        for t in [-0.1, 0.21, f64::NAN] {
            let outside = method.states_within(&failing, t, &mut within);
            assert!(matches!(outside, Err(IntegrationError::OutsideStep { .. })));
        }
        assert!(method.states_within(&failing, 0.1, &mut [BodyState::default(); 3]).is_err());
        method.step(&failing, 0.0).unwrap();
        assert_eq!((method.time(), method.states()), (0.2, &before[..]), "a step of no length");
        method.start(&fine, 0.0, &[BodyState { linear_velocity: DVec3::NAN, ..start }]);
        assert!(matches!(method.step(&fine, 0.1), Err(IntegrationError::NotFinite { .. })));
        method.start(&FreeMotion::new(&[], GRAVITY, &[]), 0.0, &[]);
        assert_eq!(method.step(&FreeMotion::new(&[], GRAVITY, &[]), 0.1), Ok(()), "nothing moves");
    }
}

/// A fall into a point mass: the steps shrink until there is nothing left to shrink, and the error says so.
#[test]
fn singularity_is_reported() {
    let bodies = [body(1.0, DVec3::ONE)];
    let fields: [Box<dyn Field>; 1] = [Box::new(PointGravity::new(1.0, DVec3::ZERO).unwrap())];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let mut method = dop853(1e-9);
    method.start(&motion, 0.0, &[BodyState::at_rest(Pose::from_translation(DVec3::X))]);
    // A fall from rest at distance one takes pi/sqrt(8).
    let error = method.step(&motion, 2.0).unwrap_err();
    match error {
        IntegrationError::StepTooSmall { t, .. } | IntegrationError::NotFinite { t } => {
            assert!((t - std::f64::consts::PI / 8f64.sqrt()).abs() < 1e-6, "{error}");
        }
        other => panic!("{other}"),
    }
}

/// Tolerances out of range are refused.
#[test]
fn tolerances_have_limits() {
    for tolerance in [0.0, -1.0, 1e-16, 0.5, f64::NAN, f64::INFINITY] {
        assert!(Tolerance::new(tolerance).is_err(), "{tolerance}");
    }
    assert!(Tolerance::new(1e-13).is_ok());
}

/// The last step of a run is cut to its end and says nothing about the next: the step does not stay short.
#[test]
fn short_last_steps_do_not_shorten_the_next() {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 3.0), DVec3::ONE);
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &[]);
    let mut method = dop853(1e-10);
    method.start(&motion, 0.0, &[*flight.start()]);
    method.step(&motion, 10.0).unwrap();
    let steps = method.accepted_steps();
    method.step(&motion, 1e-6).unwrap();
    assert_eq!(method.accepted_steps(), 1);
    method.step(&motion, 10.0).unwrap();
    assert!(method.accepted_steps() <= steps + 2, "{} after {steps}", method.accepted_steps());
}

/// A body takes the steps that it needs, whatever moves with it: errors are not averaged over bodies.
#[test]
fn other_bodies_do_not_dilute_the_error() {
    let (body, start, fields) = hung();
    let steps = |others: usize| {
        let mut bodies = vec![body];
        let mut states = vec![start];
        bodies.extend(vec![crate::support::body(1.0, DVec3::ONE); others]);
        states.extend(vec![BodyState::default(); others]);
        let motion = FreeMotion::new(&bodies, GRAVITY, &fields);
        let mut method = dop853(1e-9);
        method.start(&motion, 0.0, &states);
        method.step(&motion, 3.0).unwrap();
        (method.accepted_steps(), bits(&method.states()[0]))
    };
    assert_eq!(steps(0), steps(30));
}

/// Error control knows no unit: with lengths four thousand times smaller, and masses to match, the steps are the same.
#[test]
fn error_control_is_the_same_at_every_size() {
    let steps = |scale: f64| {
        let body = body(2.0 * scale.powi(3), DVec3::new(1.0, 2.0, 2.5) * scale.powi(5));
        let velocity = Velocity::new(DVec3::new(1.0, 2.0, 3.0) * scale, DVec3::new(1.0, -2.0, 0.5));
        let state = body.at_velocity(Pose::from_translation(DVec3::ONE * scale), velocity);
        let (a, b) = (Anchor::World(DVec3::Z * 3.0 * scale), Anchor::Body { body: 0, point: DVec3::X * 0.5 * scale });
        let fields: [Box<dyn Field>; 1] = [Box::new(Spring::new(a, b, 20.0 * scale.powi(3), scale).unwrap())];
        let bodies = [body];
        let motion = FreeMotion::new(&bodies, GRAVITY * scale, &fields);
        let mut method = dop853(1e-10);
        method.start(&motion, 0.0, &[state]);
        method.step(&motion, 3.0).unwrap();
        (method.accepted_steps(), method.states()[0].pose.translation / scale)
    };
    // Powers of two, so that the arithmetic is the same to the last bit.
    assert_eq!(steps(1.0), steps(1.0 / 4096.0));
    assert_eq!(steps(1.0), steps(4096.0));
}

/// As a system of flat states the motion integrates as its integrators do, with buffers and without.
#[test]
fn free_motion_is_a_system() {
    let (body, start, fields) = hung();
    let bodies = [body, body];
    let mut motion = FreeMotion::new(&bodies, GRAVITY, &fields);
    let flat: Vec<f64> = [start, start].iter().flat_map(BodyState::to_array).collect();
    assert_eq!(motion.dimension(), flat.len());
    let (mut rates, mut buffered) = (vec![0.0; flat.len()], vec![0.0; flat.len()]);
    motion.derivative(0.0, &flat, &mut rates).unwrap();
    BufferedMotion::new(motion).derivative(0.0, &flat, &mut buffered).unwrap();
    assert_eq!(rates, buffered);
    let mut wrenches = [Wrench::default(); 2];
    motion.wrenches(0.0, &[start; 2], &mut wrenches);
    assert_eq!(rates[state::LINEAR_VELOCITY..][..3], (GRAVITY + wrenches[0].force * 0.5).to_array());
    assert_eq!(rates[state::ANGULAR_MOMENTUM..][..3], wrenches[0].torque.to_array());
    assert_eq!(rates[state::WIDTH + state::LINEAR_VELOCITY..][..3], GRAVITY.to_array(), "nothing pulls the other body");
    let mut state = flat.clone();
    rk4::step(&mut motion, 0.0, 1e-3, &mut state).unwrap();
    let mut method = dop853(1e-13);
    method.start(&motion, 0.0, &[start; 2]);
    method.step(&motion, 1e-3).unwrap();
    let truth: Vec<f64> = method.states().iter().flat_map(BodyState::to_array).collect();
    assert!(state.iter().zip(&truth).all(|(a, b)| (a - b).abs() < 1e-13));
}
