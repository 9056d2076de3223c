//! Location of events within steps.

use crate::support::{body, dop853, spin};
use glam::DVec3;
use polhode_dynamics::integrator::{Exact, IntegrationError, Integrator, event};
use polhode_dynamics::{BodyState, FreeMotion};
use polhode_spatial::{Pose, Velocity};

/// Methods to whose order nothing is lost: the projectile's path is a polynomial of degree two.
fn methods() -> [Box<dyn Integrator>; 3] {
    [Box::new(Exact::blanes_moan()), Box::new(Exact::strang()), Box::new(dop853(1e-13))]
}

/// A projectile crosses z = 0 at `(v + sqrt(v^2 + 2 g z0))/g`, to 1e-13 of the step and the rounding of the states.
#[test]
fn projectile_crosses_the_ground() {
    let bodies = [body(1.0, DVec3::new(1.0, 2.0, 3.0))];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &[]);
    let velocity = Velocity::new(DVec3::new(1.0, 0.0, 4.0), DVec3::new(0.1, 3.0, 0.1));
    let start = [bodies[0].at_velocity(Pose::from_translation(DVec3::Z * 1.5), velocity)];
    let exact = (4.0 + f64::sqrt(16.0 + 2.0 * 9.81 * 1.5)) / 9.81;
    for mut method in methods() {
        for step in [0.3, 1.0, 2.0] {
            method.start(&motion, 5.0, &start);
            let found = loop {
                let from = method.time();
                method.step(&motion, step).unwrap();
                let height = &mut |_: f64, states: &[BodyState]| states[0].pose.translation.z;
                if let Some(t) = event::locate(&mut *method, &motion, from, height).unwrap() {
                    break t;
                }
            };
            assert!((found - 5.0 - exact).abs() < 1e-13 * step + 1e-14, "{method:?} {step} {:e}", found - 5.0 - exact);
            let mut state = [BodyState::default()];
            method.states_within(&motion, found, &mut state).unwrap();
            assert!(state[0].pose.translation.z <= 0.0, "the event has happened at the time returned");
        }
    }
}

/// Of several changes of sign the first is found, then the next from there, and none that is not there.
#[test]
fn events_come_one_after_the_other() {
    let (body, flight) = spin(DVec3::new(1.0, 1.0, 2.0), DVec3::Z * 3.0);
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &[]);
    for mut method in methods() {
        method.start(&motion, 0.0, &[*flight.start()]);
        method.step(&motion, 4.0).unwrap();
        let mut from = 0.0;
        let side = &mut |_: f64, states: &[BodyState]| states[0].pose.rotation.rotate(DVec3::X).x;
        for k in 0..4 {
            let t = event::locate(&mut *method, &motion, from, side).unwrap().unwrap();
            let exact = std::f64::consts::PI * (f64::from(k) + 0.5) / 3.0;
            assert!((t - exact).abs() < 1e-12, "{k}: {:e}", t - exact);
            assert!(t > from);
            from = t;
        }
        assert_eq!(event::locate(&mut *method, &motion, from, side), Ok(None));
        // Time backwards.
        method.start(&motion, 4.0, method.states().to_vec().as_slice());
        method.step(&motion, -4.0).unwrap();
        let t = event::locate(&mut *method, &motion, 4.0, side).unwrap().unwrap();
        assert!((t - std::f64::consts::PI * 3.5 / 3.0).abs() < 1e-12);
    }
}

/// Functions of the time alone: a zero at the start, at the end, a jump, a flat zero, infinite values, NaN.
#[test]
fn difficult_functions() {
    let bodies = [body(1.0, DVec3::ONE)];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &[]);
    let mut method = Exact::strang();
    method.start(&motion, 0.0, &[BodyState::default()]);
    method.step(&motion, 2.0).unwrap();
    let mut locate = |f: &dyn Fn(f64) -> f64| event::locate(&mut method, &motion, 0.0, &mut |t, _| f(t));
    assert_eq!(locate(&|t| t), Ok(None), "a zero at the start is no event");
    assert_eq!(locate(&|t| t - 2.0), Ok(Some(2.0)));
    assert_eq!(locate(&|_| 0.0), Ok(None));
    let near = |found: Result<Option<f64>, IntegrationError>, exact: f64| {
        let t = found.unwrap().unwrap();
        assert!((t - exact).abs() <= 2.0 * event::RESOLUTION, "{:e}", t - exact);
    };
    near(locate(&|t| if t < 0.7 { -1.0 } else { 1e9 }), 0.7);
    near(locate(&|t| if t < 0.7 { f64::NEG_INFINITY } else { f64::INFINITY }), 0.7);
    near(locate(&|t| (t - 1.3).powi(9)), 1.3);
    near(locate(&|t| ((t - 0.1) * 1e3).tanh()), 0.1);
    near(locate(&|t| t * (0.9 - t)), 0.9);
    assert!(matches!(locate(&|t| if t > 1.0 { f64::NAN } else { 1.0 }), Err(IntegrationError::NotFinite { .. })));
    let outside = event::locate(&mut method, &motion, -1.0, &mut |t, _| t);
    assert!(matches!(outside, Err(IntegrationError::OutsideStep { .. })));
}

/// A smooth function is closed in on with few evaluations, a nasty one with not many more than bisection.
#[test]
fn location_is_cheap() {
    let bodies = [body(1.0, DVec3::ONE)];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &[]);
    let mut method = Exact::strang();
    method.start(&motion, 0.0, &[BodyState::default()]);
    method.step(&motion, 1.0).unwrap();
    let mut count = |f: &dyn Fn(f64) -> f64| {
        let mut evaluations = 0;
        let event = &mut |t: f64, _: &[BodyState]| {
            evaluations += 1;
            f(t)
        };
        event::locate(&mut method, &motion, 0.0, event).unwrap();
        evaluations
    };
    let smooth = count(&|t| t.exp() - 2.0);
    assert!(smooth < 17 + 12, "{smooth}");
    // Bisection takes log2(1e13/16) = 39 halvings.
    let nasty = count(&|t| (t - 0.55).powi(9));
    assert!(nasty <= 17 + 41, "{nasty}");
}
