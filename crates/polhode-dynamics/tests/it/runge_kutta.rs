//! The Runge-Kutta methods: orders of convergence, agreement with other programs, economy of evaluations.

use crate::support::{body, order, spin};
use glam::DVec3;
use polhode_dynamics::{BodyState, Dop853, Flight, FreeMotion, RigidBody, Rk4, System, rk4, state};
use polhode_spatial::{Motion, Pose, Rotation, Velocity};
use std::convert::Infallible;

/// A driven pendulum, which counts what it is asked.
struct Pendulum {
    evaluations: usize,
}

impl System for Pendulum {
    type Error = Infallible;

    fn dimension(&self) -> usize {
        2
    }

    fn derivative(&mut self, t: f64, y: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
        self.evaluations += 1;
        rates[0] = y[1];
        rates[1] = -y[0].sin() + 0.1 * (2.0 * t).cos();
        Ok(())
    }
}

/// A thrown asymmetric body and its exact flight.
fn throw() -> (RigidBody, Flight) {
    let body = body(1.0, DVec3::new(1.0, 2.0, 3.0));
    let velocity = Velocity::new(DVec3::new(1.0, 0.0, 5.0), DVec3::new(0.4, 0.8, 0.4));
    let start = body.at_velocity(Pose::new(Rotation::IDENTITY, DVec3::new(0.0, 0.0, 1.0)), velocity);
    (body, Flight::new(&body, 0.0, &start, DVec3::new(0.0, 0.0, -9.81)))
}

/// Attitude error of RK4 after 10 s in `steps` steps.
fn rk4_error(steps: usize) -> f64 {
    let (body, flight) = throw();
    let bodies = [body];
    let mut system = FreeMotion::new(&bodies, flight.gravity(), &[]);
    let mut state = flight.start().to_array();
    let (mut method, h) = (Rk4::new(state.len()), 10.0 / steps as f64);
    for k in 0..steps {
        method.step(&mut system, k as f64 * h, h, &mut state).unwrap();
    }
    let end = BodyState::from_array(&state);
    // Gravity is uniform, so the position is a polynomial of degree two, which the method integrates exactly.
    assert!((end.pose.translation - flight.pose(10.0).translation).length() < 1e-11);
    end.pose.rotation.angle_to(flight.pose(10.0).rotation)
}

/// The thesis's method: order 4.0, and at 1600 steps the error that the work-precision table gives for this body.
#[test]
fn rk4_has_order_four() {
    let errors = [100, 200, 400, 800, 1600].map(rk4_error);
    for pair in errors.windows(2) {
        let order = order(pair[0], pair[1]);
        assert!((order - 4.0).abs() < 0.1, "order {order} from {errors:?}");
    }
    assert!((4e-11..8e-11).contains(&errors[4]), "{errors:?}");
}

/// Attitude error of DOP853 with a fixed number of steps.
fn dop853_error(steps: usize) -> f64 {
    let (body, flight) = throw();
    let bodies = [body];
    let mut system = FreeMotion::new(&bodies, flight.gravity(), &[]);
    let mut state = flight.start().to_array();
    let (mut method, h, scale) = (Dop853::new(state.len()), 10.0 / steps as f64, [1.0; state::WIDTH]);
    for k in 0..steps {
        method.attempt(&mut system, k as f64 * h, &state, h, &scale).unwrap();
        state.copy_from_slice(method.end_state());
        state::normalize(&mut state);
    }
    BodyState::from_array(&state).pose.rotation.angle_to(flight.pose(10.0).rotation)
}

/// The driven pendulum shows order 8.0; free rotation does a little better, as the leading term of its error happens to
/// be small.
#[test]
fn dop853_has_order_eight() {
    let pendulum = |steps: usize| {
        let (mut system, mut method) = (Pendulum { evaluations: 0 }, Dop853::new(2));
        let (mut state, h) = ([1.0, 0.3], 10.0 / steps as f64);
        for k in 0..steps {
            method.attempt(&mut system, k as f64 * h, &state, h, &[1.0; 2]).unwrap();
            state.copy_from_slice(method.end_state());
        }
        state
    };
    let exact = pendulum(600);
    let error = |steps: usize| (pendulum(steps)[0] - exact[0]).hypot(pendulum(steps)[1] - exact[1]);
    for (coarse, fine) in [(40, 60), (60, 80)] {
        let order = (error(coarse) / error(fine)).ln() / (fine as f64 / coarse as f64).ln();
        assert!((order - 8.0).abs() < 0.2, "order {order} from {coarse} to {fine} steps");
    }
    let errors = [16, 24, 36].map(dop853_error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).ln() / 1.5f64.ln();
        assert!(order > 7.8, "order {order} from {errors:?}");
    }
}

/// Within a step the dense output is as good as a method of order 7: the error of one step falls as h^8.
#[test]
fn dense_output_has_order_seven() {
    let (body, flight) = throw();
    let bodies = [body];
    let mut system = FreeMotion::new(&bodies, flight.gravity(), &[]);
    let start = flight.start().to_array();
    let mut error = |h: f64| {
        let mut method = Dop853::new(start.len());
        method.attempt(&mut system, 0.0, &start, h, &[1.0; state::WIDTH]).unwrap();
        let step = method.dense(&mut system).unwrap();
        let mut worst = 0.0f64;
        for part in 0..=50 {
            let t = h * f64::from(part) / 50.0;
            let mut numbers = [0.0; state::WIDTH];
            step.evaluate(t, &mut numbers);
            worst = worst.max(BodyState::from_array(&numbers).pose.rotation.angle_to(flight.pose(t).rotation));
        }
        worst
    };
    let errors = [1.6, 0.8, 0.4, 0.2].map(&mut error);
    for pair in errors.windows(2) {
        let order = order(pair[0], pair[1]) - 1.0;
        assert!((order - 7.0).abs() < 0.2, "order {order} from {errors:?}");
    }
}

/// One step, its error estimate and its dense output, against the numbers of another program (SciPy 1.17, DOP853).
#[test]
fn dop853_agrees_with_another_program() {
    let mut system = Pendulum { evaluations: 0 };
    let mut method = Dop853::new(2);
    let error = method.attempt(&mut system, 0.5, &[1.0, 0.3], 0.7, &[1e-6, 2e-6]).unwrap();
    let near = |value: f64, reference: f64| assert!((value - reference).abs() < 1e-15, "{value} for {reference}");
    near(method.end_state()[0], 1.001705878832147);
    near(method.end_state()[1], -0.31071350821683);
    // The estimate is what is left of a cancellation: eleven digits remain.
    assert!((error / 0.008320628633323243 - 1.0).abs() < 1e-7, "{error}");
    let step = method.dense(&mut system).unwrap();
    let mut inside = [0.0; 2];
    step.evaluate(0.8, &mut inside);
    near(inside[0], 1.053181824606096);
    near(inside[1], 0.050309764377160004);
}

/// Errors of parts of the state: of one number that of the whole norm, of all the norm with the root of their count, of
/// numbers that are not there NaN, as after an attempt with a state of another length.
#[test]
fn errors_of_parts_of_the_state() {
    let mut system = Pendulum { evaluations: 0 };
    let mut method = Dop853::new(2);
    let norm = method.attempt(&mut system, 0.5, &[1.0, 0.3], 0.7, &[1e-6; 2]).unwrap();
    let whole = method.error_of(0..2) / 1e-6;
    assert!((whole / (norm * f64::sqrt(2.0)) - 1.0).abs() < 1e-14, "{whole} {norm}");
    let only_first = method.attempt(&mut system, 0.5, &[1.0, 0.3], 0.7, &[1e-6, f64::INFINITY]).unwrap();
    assert!((method.error_of(0..1) / 1e-6 / (only_first * f64::sqrt(2.0)) - 1.0).abs() < 1e-14);
    assert_eq!(method.error_of(1..1), 0.0);
    assert!(method.error_of(1..3).is_nan());
    assert_eq!(method.start_rates()[0], 0.3);
    method.attempt_unscaled(&mut system, 0.5, &[1.0; 3], 0.7).unwrap();
    assert!(method.error_of(0..2).is_nan());
}

/// Twelve evaluations for the first step, eleven for a repeated one, and the three of the dense output plus the rates
/// at the end, with which the next step then begins.
#[test]
fn dop853_evaluates_no_stage_twice() {
    let mut system = Pendulum { evaluations: 0 };
    let mut method = Dop853::new(2);
    let scale = [1e-9; 2];
    let counted = |system: &mut Pendulum, expected: usize| {
        assert_eq!(std::mem::take(&mut system.evaluations), expected);
    };
    method.attempt(&mut system, 0.0, &[1.0, 0.0], 0.5, &scale).unwrap();
    counted(&mut system, 12);
    method.attempt(&mut system, 0.0, &[1.0, 0.0], 0.25, &scale).unwrap();
    counted(&mut system, 11);
    method.dense(&mut system).unwrap();
    counted(&mut system, 4);
    let (t, end) = (method.end_time(), method.end_state().to_vec());
    method.attempt(&mut system, t, &end, 0.25, &scale).unwrap();
    counted(&mut system, 11);
    let with_reuse = method.end_state().to_vec();
    // A projected state or a changed system begins anew; the numbers are the same where the state is.
    method.restart();
    method.attempt(&mut system, t, &end, 0.25, &scale).unwrap();
    counted(&mut system, 12);
    assert_eq!(method.end_state(), with_reuse);
    let (t, mut end) = (method.end_time(), method.end_state().to_vec());
    method.dense(&mut system).unwrap();
    end[0] += 1e-15;
    system.evaluations = 0;
    method.attempt(&mut system, t, &end, 0.25, &scale).unwrap();
    counted(&mut system, 12);
}

/// With error control a generic rotation follows the exact one in proportion to the tolerance: the error per step is
/// held below it, and ten seconds take thirty to eighty steps.
#[test]
fn error_control_keeps_its_promise() {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 3.0), DVec3::ONE);
    let bodies = [body];
    let mut system = FreeMotion::new(&bodies, DVec3::ZERO, &[]);
    for tolerance in [1e-8, 1e-10, 1e-12] {
        let mut state = flight.start().to_array();
        let mut method = Dop853::new(state.len());
        let (mut t, mut h, mut attempts) = (0.0, 0.1, 0);
        while t < 10.0 {
            let step = f64::min(h, 10.0 - t);
            let scale = state.map(|y| tolerance * (1.0 + y.abs()));
            let error = method.attempt(&mut system, t, &state, step, &scale).unwrap();
            h = step * Dop853::next_step_factor(error);
            if error <= 1.0 {
                t = method.end_time();
                state.copy_from_slice(method.end_state());
                state::normalize(&mut state);
            }
            attempts += 1;
            assert!(attempts < 1000, "the controller is stuck");
        }
        let error = BodyState::from_array(&state).pose.rotation.angle_to(flight.pose(t).rotation);
        assert!(error < 100.0 * tolerance, "tolerance {tolerance:e}: error {error:e}");
    }
}

#[test]
fn step_factor_is_limited() {
    assert_eq!(Dop853::next_step_factor(0.0), 6.0);
    assert_eq!(Dop853::next_step_factor(1.0), 0.9);
    assert_eq!(Dop853::next_step_factor(1e30), 1.0 / 3.0);
    assert_eq!(Dop853::next_step_factor(f64::NAN), 1.0 / 3.0);
}

/// A slice of the wrong length, NaN and a system that fails: an error or a step that is never accepted.
#[test]
fn bad_input_is_no_accepted_step() {
    #[derive(Debug, PartialEq)]
    struct Stuck;
    struct Failing;
    impl System for Failing {
        type Error = Stuck;
        fn dimension(&self) -> usize {
            2
        }
        fn derivative(&mut self, t: f64, _: &[f64], rates: &mut [f64]) -> Result<(), Stuck> {
            rates.fill(1.0);
            if t > 0.2 { Err(Stuck) } else { Ok(()) }
        }
    }
    let mut method = Dop853::new(2);
    assert_eq!(method.attempt(&mut Failing, 0.0, &[0.0; 2], 1.0, &[1.0; 2]), Err(Stuck));
    assert!(method.attempt(&mut Failing, 0.0, &[0.0; 2], 0.1, &[1.0; 2]).is_ok_and(|error| error <= 1.0));
    let mut state = [1.0, 2.0];
    assert_eq!(rk4::step(&mut Failing, 0.0, 1.0, &mut state), Err(Stuck));
    assert_eq!(state, [1.0, 2.0], "a step that failed leaves the state alone");
    let mut pendulum = Pendulum { evaluations: 0 };
    for (state, scale) in [(&[0.0; 3][..], &[1.0; 2][..]), (&[0.0; 2], &[1.0; 1]), (&[f64::NAN, 0.0], &[1.0; 2])] {
        let error = method.attempt(&mut pendulum, 0.0, state, 0.1, scale).unwrap();
        assert!(error.is_nan());
    }
}
