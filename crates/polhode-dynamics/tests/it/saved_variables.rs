//! A method that goes on from the variables it has saved gives the bits of one that was never stopped.

use crate::stepping::{ORIENTATIONS, RATES};
use crate::support::{bits, body};
use glam::DVec3;
use polhode_dynamics::field::{Anchor, Field, Spring};
use polhode_dynamics::integrator::{Integrator, Method, MethodSettings, Orientation, Rk4};
use polhode_dynamics::{BodyState, FreeMotion, Pose, RigidBody, Rotation};

fn states(bodies: &[RigidBody]) -> Vec<BodyState> {
    let state = |(index, body): (usize, &RigidBody)| {
        let x = index as f64;
        let pose =
            Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, 0.7 + x, -0.2)), DVec3::new(x, 0.5, -0.3 * x));
        let mut state = BodyState::at_rest(pose);
        state.linear_velocity = DVec3::new(0.2, -0.1, 0.4 * x);
        state.angular_momentum = DVec3::new(0.3, 1.1, -0.4) * body.moments().x;
        state
    };
    bodies.iter().enumerate().map(state).collect()
}

fn fields() -> Vec<Box<dyn Field>> {
    let spring = Spring::new(
        Anchor::Body { body: 0, point: DVec3::new(0.1, 0.2, 0.0) },
        Anchor::Body { body: 1, point: DVec3::new(0.0, -0.1, 0.1) },
        12.0,
        0.4,
    );
    vec![Box::new(spring.unwrap())]
}

/// Steps of a length that is no fraction of another, and a look into the middle of each.
fn go_on(method: &mut dyn Integrator, motion: &FreeMotion<'_>, steps: u32) -> Vec<[u64; 13]> {
    let mut seen = Vec::new();
    for _ in 0..steps {
        let from = method.time();
        let mut within = method.states().to_vec();
        method.step(motion, 0.0137).unwrap();
        method.states_within(motion, from + 0.005, &mut within).unwrap();
        seen.extend(within.iter().chain(method.states()).map(bits));
    }
    seen
}

fn check(name: &str, make: &dyn Fn() -> Box<dyn Integrator>, motion: &FreeMotion<'_>) {
    let mut method = make();
    method.start(motion, 0.25, &states(motion.bodies()));
    for steps in [0, 1, 7] {
        go_on(&mut *method, motion, steps);
        let saved = method.save();
        let mut other = make();
        other.restore(motion, &saved).unwrap();
        assert_eq!(other.time().to_bits(), method.time().to_bits(), "{name}");
        // A look into the step before the stop.
        let t = method.time() - if steps == 0 { 0.0 } else { 0.004 };
        let mut looks = [method.states().to_vec(), method.states().to_vec()];
        method.states_within(motion, t, &mut looks[0]).unwrap();
        other.states_within(motion, t, &mut looks[1]).unwrap();
        assert_eq!(
            looks[0].iter().map(bits).collect::<Vec<_>>(),
            looks[1].iter().map(bits).collect::<Vec<_>>(),
            "{name}"
        );
        assert_eq!(go_on(&mut *other, motion, 9), go_on(&mut *method, motion, 9), "{name} after {steps} steps");
        for length in 0..saved.len() {
            assert!(other.restore(motion, &saved[..length]).is_err(), "{name}: {length} of {} numbers", saved.len());
        }
        for place in 0..saved.len() {
            let mut altered = saved.clone();
            altered[place] = f64::NAN;
            // Refused or not: no panic, whatever the numbers are.
            let _ = make().restore(motion, &altered);
        }
    }
}

#[test]
fn every_method_goes_on_from_its_saved_variables_with_the_same_bits() {
    let bodies = [body(1.0, DVec3::new(1.0, 2.0, 3.0)), body(2.0, DVec3::new(0.5, 0.6, 0.9))];
    for fields in [Vec::new(), fields()] {
        let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &fields);
        for method in Method::ALL {
            check(method.name(), &|| method.build(&MethodSettings::default()), &motion);
        }
        for orientation in ORIENTATIONS {
            for rate in RATES {
                let name = format!("rk4 {orientation:?} {rate:?}");
                check(&name, &|| Box::new(Rk4::new(orientation, rate)), &motion);
            }
        }
    }
}

/// One body that nothing loads keeps its record of flight beside one that is loaded.
#[test]
fn records_of_flight_are_saved_with_the_methods_that_keep_them() {
    let bodies = [body(1.0, DVec3::new(1.0, 2.0, 3.0)), body(2.0, DVec3::new(0.5, 0.6, 0.9))];
    let spring = Spring::new(Anchor::World(DVec3::ZERO), Anchor::Body { body: 0, point: DVec3::X }, 5.0, 0.1).unwrap();
    let fields: Vec<Box<dyn Field>> = vec![Box::new(spring)];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z, &fields);
    for method in [Method::Exact, Method::ExactStrang, Method::ExactAdaptive, Method::Dop853] {
        check(method.name(), &|| method.build(&MethodSettings::default()), &motion);
    }
    let variables = |orientation| Rk4::new(orientation, RATES[0]).save().len();
    assert_eq!(variables(Orientation::Matrix), variables(Orientation::Quaternion), "nothing is kept before the start");
}
