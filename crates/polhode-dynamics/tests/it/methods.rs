//! All methods behind one trait: names, orders, what they take, and that they agree on one motion.

use crate::support::{body, dop853};
use glam::DVec3;
use polhode_dynamics::field::{Anchor, Dependence, Drag, DragLaw, Field, Spring};
use polhode_dynamics::integrator::{IntegrationError, Integrator, Method, MethodSettings};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::{Pose, Rotation, Velocity};

#[test]
fn names_lead_to_methods_and_back() {
    for method in Method::ALL {
        assert_eq!(Method::from_name(method.name()), Ok(method));
        assert_eq!(method.to_string().parse(), Ok(method));
        assert_eq!(method.order(), method.build(&MethodSettings::default()).order());
    }
    let error = Method::from_name("rk5").unwrap_err().to_string();
    assert!(error.starts_with("unknown integrator \"rk5\": one of explicit-euler, "), "{error}");
    let orders = Method::ALL.map(Method::order);
    assert_eq!(orders, [1, 1, 1, 4, 4, 4, 2, 4, 6, 2, 4, 2, 8, 4, 2, 4]);
}

fn hung() -> (RigidBody, BodyState, Spring) {
    let body = body(2.0, DVec3::new(1.0, 2.0, 2.5));
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.4, 0.9, -0.3)), DVec3::ONE);
    let state = body.at_velocity(pose, Velocity::new(DVec3::X, DVec3::new(1.0, -0.7, 0.5)));
    let (a, b) = (Anchor::World(DVec3::Z * 3.0), Anchor::Body { body: 0, point: DVec3::new(0.5, 0.3, 0.4) });
    (body, state, Spring::new(a, b, 8.0, 1.0).unwrap())
}

fn distance(a: &BodyState, b: &BodyState) -> f64 {
    (a.pose.translation - b.pose.translation).length() + a.pose.rotation.angle_to(b.pose.rotation)
}

/// A body hung from a spring off its centre, half a second in 1000 steps: every method comes as near to the truth as
/// its order lets it, and drag is taken by those that say so and refused by the others.
#[test]
fn methods_agree() {
    let (body, start, spring) = hung();
    let bodies = [body];
    let sprung: [Box<dyn Field>; 1] = [Box::new(spring)];
    let dragged: [Box<dyn Field>; 2] = [Box::new(spring), Box::new(Drag::new(0, DragLaw::Linear, 0.5, 0.3).unwrap())];
    for fields in [&sprung[..], &dragged] {
        let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, fields);
        let mut exact = dop853(1e-13);
        exact.start(&motion, 0.0, &[start]);
        exact.step(&motion, 0.5).unwrap();
        for method in Method::ALL {
            let mut integrator = method.build(&MethodSettings::default());
            integrator.start(&motion, 0.0, &[start]);
            if !method.takes(motion.dependence()) {
                assert_eq!(motion.dependence(), Dependence::Velocities);
                let refused = IntegrationError::VelocityDependentField { method: method.name() };
                assert_eq!(integrator.step(&motion, 5e-4), Err(refused));
                continue;
            }
            for _ in 0..1000 {
                integrator.step(&motion, 5e-4).unwrap();
            }
            let error = distance(&integrator.states()[0], &exact.states()[0]);
            let allowed = match method.order() {
                1 => 2e-3,
                2 => 1e-6,
                _ => 2e-11,
            };
            assert!(error < allowed, "{method}: {error:e}");
        }
    }
}

/// Every method gives within a step what its own step of that length gives, and refuses times outside.
#[test]
fn states_within_a_step() {
    let (body, start, spring) = hung();
    let bodies = [body];
    let fields: [Box<dyn Field>; 1] = [Box::new(spring)];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &fields);
    for method in Method::ALL {
        let mut integrator = method.build(&MethodSettings::default());
        integrator.start(&motion, 0.0, &[start]);
        integrator.step(&motion, 0.02).unwrap();
        let mut within = [BodyState::default()];
        integrator.states_within(&motion, 0.007, &mut within).unwrap();
        integrator.states_within(&motion, 0.02, &mut [BodyState::default()]).unwrap();
        assert!(integrator.states_within(&motion, 0.03, &mut [BodyState::default()]).is_err(), "{method}");
        let mut short = method.build(&MethodSettings::default());
        short.start(&motion, 0.0, &[start]);
        short.step(&motion, 0.007).unwrap();
        let error = distance(&within[0], &short.states()[0]);
        assert!(error < 1e-12, "{method}: {error:e}");
    }
}
