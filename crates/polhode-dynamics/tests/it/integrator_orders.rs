//! Orders of convergence of every method of fixed step, every representation of orientation, and dense output.
//!
//! The order is the slope of the error at a fixed time between halved steps, in the range where truncation is far above
//! round-off and the leading term of the error rules. Free rotation is measured against its closed form, forced motion
//! against `exact` (Blanes and Moan's composition of exact flights) with steps so short that its error is round-off.

use crate::stepping::{METHODS, ORIENTATIONS, RATES, Scene, difference, method};
use crate::support::{body, dop853, order};
use glam::DVec3;
use polhode_dynamics::field::{Anchor, AppliedForce, Drag, DragLaw, Field, Frame, PointGravity, Signal, Spring};
use polhode_dynamics::integrator::{Exact, IntegrationError, Integrator, Rk4};
use polhode_dynamics::{BodyState, Flight, RigidBody};
use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};

const MOMENTS: DVec3 = DVec3::new(2.3, 3.1, 4.7);

/// How far a measured order may be from that of theory: what the next term of the error makes of it.
const TOLERANCE: f64 = 0.1;

/// A generic rotation, far from the separatrix. The angular momentum lies along z of the world, so that the z axis of
/// the body, which circles about it, never comes near the singular attitude of Euler angles.
fn free_rotation() -> Scene {
    let body = body(1.0, MOMENTS);
    let momentum = MOMENTS * DVec3::new(0.9, -1.1, 0.7);
    let axis = momentum.cross(DVec3::Z);
    let turn = axis.normalize() * momentum.angle_between(DVec3::Z);
    let pose = Pose::from_translation(DVec3::new(1.0, 2.0, 3.0));
    let mut state = BodyState { pose, linear_velocity: DVec3::new(1.0, 0.5, 4.0), ..BodyState::default() };
    state.pose.rotation = Rotation::from_rotation_vector(turn);
    state.angular_momentum = state.pose.rotation.rotate(momentum);
    Scene { gravity: DVec3::new(0.0, 0.0, -9.81), ..Scene::free(&body, state) }
}

/// The closed form of [`free_rotation`].
fn exact_flight(scene: &Scene, t: f64) -> Vec<BodyState> {
    vec![Flight::new(&scene.bodies[0], 0.0, &scene.states[0], scene.gravity).state(t)]
}

/// A heavy asymmetric top.
pub(crate) fn heavy_top() -> Scene {
    let inertia = Inertia::from_diagonal(DVec3::new(0.3, 0.5, 0.6)).unwrap();
    let properties = MassProperties::new(Mass::new(1.2).unwrap(), DVec3::new(0.1, -0.2, 0.4), inertia);
    let body = RigidBody::pivoted(&properties, DVec3::ZERO);
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.9, 0.4, 0.2)), DVec3::new(1.0, 2.0, 3.0));
    let state = body.at_velocity(pose, Velocity::new(DVec3::ZERO, DVec3::new(0.4, -0.3, 1.7)));
    Scene { gravity: DVec3::new(0.0, 0.0, -1.5), ..Scene::free(&body, state) }
}

/// Two bodies joined off their centres by a spring, in uniform gravity and that of a point, one pulled by a force that
/// varies with time; the inertia of the second is not diagonal in its axes.
fn coupled() -> Scene {
    let first = body(1.0, DVec3::new(0.4, 0.5, 0.7));
    let axes = Rotation::from_rotation_vector(DVec3::new(0.5, -0.3, 0.8));
    let inertia = Inertia::from_diagonal(DVec3::new(0.3, 0.9, 1.0)).unwrap().rotated(axes);
    let second = RigidBody::new(&MassProperties::new(Mass::new(2.0).unwrap(), DVec3::ZERO, inertia));
    let at = |x: f64, turn: DVec3| Pose::new(Rotation::from_rotation_vector(turn), DVec3::new(x, 0.2, 0.0));
    let states = vec![
        first
            .at_velocity(at(-0.8, DVec3::new(0.7, 0.2, 0.1)), Velocity::new(DVec3::Y * 0.3, DVec3::new(0.5, 0.4, 0.9))),
        second
            .at_velocity(at(0.9, DVec3::new(1.1, 0.0, 0.3)), Velocity::new(DVec3::Z * 0.2, DVec3::new(-0.4, 0.3, 0.5))),
    ];
    let anchor = |body, point| Anchor::Body { body, point };
    let ends = (anchor(0, DVec3::new(0.2, 0.1, 0.0)), anchor(1, DVec3::new(-0.1, 0.3, 0.2)));
    let force = AppliedForce::new(0, DVec3::new(0.2, 0.1, -0.3), Frame::World).unwrap();
    let fields: Vec<Box<dyn Field>> = vec![
        Box::new(Spring::new(ends.0, ends.1, 2.0, 1.0).unwrap()),
        Box::new(PointGravity::new(3.0, DVec3::new(0.0, 1.0, -6.0)).unwrap()),
        Box::new(force.following(Signal::sinusoid(1.0, 0.3, 0.4).unwrap())),
    ];
    Scene { bodies: vec![first, second], gravity: DVec3::new(0.0, 0.1, 0.2), fields, states }
}

/// Numbers of steps per second, coarsest first, at which a method of this order is in its asymptotic range.
fn rates_of_steps(order: u32) -> [usize; 3] {
    match order {
        1 => [1000, 2000, 4000],
        2 => [100, 200, 400],
        4 => [25, 50, 100],
        _ => [8, 16, 32],
    }
}

/// Asserts the order of the errors of a method in so many steps.
fn check(what: &str, theory: u32, steps: [usize; 3], mut error: impl FnMut(usize) -> f64) {
    let errors = steps.map(&mut error);
    let orders = [order(errors[0], errors[1]), order(errors[1], errors[2])];
    println!("{what:40} {:.3} {:.3}   {:.1e} {:.1e}", orders[0], orders[1], errors[0], errors[2]);
    // Round-off, of some 1e-14 here, must not be what is measured.
    assert!(errors[2] > 3e-13, "{what}: {errors:?}");
    assert!((orders[1] - f64::from(theory)).abs() < TOLERANCE, "{what}: {orders:?} from {errors:?}");
}

/// As [`check`] for a motion of `end` seconds.
fn check_motion(what: &str, new: impl Fn() -> Box<dyn Integrator>, scene: &Scene, end: f64, exact: &[BodyState]) {
    let theory = new().order();
    let steps = rates_of_steps(theory).map(|rate| (rate as f64 * end) as usize);
    check(what, theory, steps, |steps| difference(&scene.run(&mut *new(), end, steps), exact));
}

#[test]
fn free_rotation_converges_at_the_order_of_each_method() {
    let scene = free_rotation();
    let exact = exact_flight(&scene, 20.0);
    for (name, new) in METHODS {
        let theory = new().order();
        check(name, theory, rates_of_steps(theory).map(|rate| 20 * rate), |steps| {
            let end = scene.run(&mut *new(), 20.0, steps);
            end[0].pose.rotation.angle_to(exact[0].pose.rotation)
        });
    }
}

/// The largest error over ten times, because at one time alone the leading term of an error may happen to vanish.
#[test]
fn every_representation_of_orientation_converges_at_order_four() {
    let scene = free_rotation();
    let exact: Vec<_> = (1..=10).map(|k| exact_flight(&scene, f64::from(k))[0].pose.rotation).collect();
    for orientation in ORIENTATIONS {
        for rate in RATES {
            check(&format!("{orientation:?}, {rate:?}"), 4, [500, 1000, 2000], |steps| {
                let (mut count, mut worst) = (0, 0.0f64);
                let look = |states: &[BodyState]| {
                    count += 1;
                    if count % (steps / 10) == 0 {
                        worst = worst.max(states[0].pose.rotation.angle_to(exact[count / (steps / 10) - 1]));
                    }
                };
                scene.run_looking(&mut Rk4::new(orientation, rate), 10.0, steps, look).unwrap();
                worst
            });
        }
    }
}

/// States at the end of a forced motion, by two methods that have nothing in common.
fn forced_reference(scene: &Scene, end: f64) -> Vec<BodyState> {
    let reference = scene.run(&mut dop853(1e-13), end, 100);
    let composed = scene.run(&mut Exact::blanes_moan(), end, 4000);
    assert!(difference(&reference, &composed) < 2e-12, "{:e}", difference(&reference, &composed));
    reference
}

#[test]
fn a_heavy_top_converges_at_the_order_of_each_method() {
    let scene = heavy_top();
    let exact = forced_reference(&scene, 6.0);
    for (name, new) in METHODS {
        check_motion(&format!("top: {name}"), new, &scene, 6.0, &exact);
    }
}

#[test]
fn coupled_bodies_converge_at_the_order_of_each_method() {
    let scene = coupled();
    let exact = forced_reference(&scene, 4.0);
    for (name, new) in METHODS {
        check_motion(&format!("coupled: {name}"), new, &scene, 4.0, &exact);
    }
}

#[test]
fn a_heavy_top_converges_in_every_representation() {
    let scene = heavy_top();
    let exact = forced_reference(&scene, 2.0);
    for orientation in ORIENTATIONS {
        for rate in RATES {
            let new = || -> Box<dyn Integrator> { Box::new(Rk4::new(orientation, rate)) };
            check_motion(&format!("top: {orientation:?}, {rate:?}"), new, &scene, 2.0, &exact);
        }
    }
}

/// Methods that take the loads where they need them converge under drag; the others refuse it, by name.
#[test]
fn drag_is_integrated_at_the_order_of_the_method_or_refused() {
    let mut scene = coupled();
    scene.fields.push(Box::new(Drag::new(0, DragLaw::Quadratic, 0.3, 0.1).unwrap()));
    scene.fields.push(Box::new(Drag::new(1, DragLaw::Linear, 0.2, 0.05).unwrap()));
    let exact = scene.run(&mut dop853(1e-13), 4.0, 60);
    for (name, new) in METHODS {
        if ["explicit-euler", "semi-implicit-euler", "implicit-gyroscopic", "rk4", "rkmk4", "cf4"].contains(&name) {
            check_motion(&format!("drag: {name}"), new, &scene, 4.0, &exact);
        } else {
            let error = scene.run_looking(&mut *new(), 4.0, 10, |_| ()).unwrap_err();
            let own = name.split(' ').next().unwrap();
            assert_eq!(error, IntegrationError::VelocityDependentField { method: own });
        }
    }
}

/// States in the middle of steps converge as those at their ends do: the global error at a time that no step ends at.
#[test]
fn states_within_a_step_converge_at_the_order_of_the_method() {
    let scene = coupled();
    let motion = scene.motion();
    let exact = forced_reference(&scene, 3.0);
    for (name, new) in METHODS {
        let theory = new().order();
        check(&format!("within: {name}"), theory, rates_of_steps(theory).map(|rate| 3 * rate), |steps| {
            // The last step passes the time of the reference by 0.37 of its length.
            let h = 3.0 / (steps as f64 - 0.37);
            let mut integrator = new();
            integrator.start(&motion, 0.0, &scene.states);
            for _ in 0..steps {
                integrator.step(&motion, h).unwrap();
            }
            let mut states = scene.states.clone();
            integrator.states_within(&motion, 3.0, &mut states).unwrap();
            difference(&states, &exact)
        });
    }
}

/// At the ends of the last step the states within it are those of the integrator, bit for bit, and outside it none.
#[test]
fn states_within_a_step_meet_its_ends() {
    let scene = coupled();
    let motion = scene.motion();
    let mut states = scene.states.clone();
    for (name, new) in METHODS {
        let mut integrator = new();
        integrator.start(&motion, 0.5, &scene.states);
        integrator.states_within(&motion, 0.5, &mut states).unwrap();
        assert_eq!(states, scene.states, "{name}");
        integrator.step(&motion, 0.1).unwrap();
        let before = integrator.states().to_vec();
        integrator.step(&motion, 0.1).unwrap();
        let (from, to) = (0.5 + 0.1, integrator.time());
        integrator.states_within(&motion, from, &mut states).unwrap();
        assert_eq!(states, before, "{name}");
        integrator.states_within(&motion, to, &mut states).unwrap();
        assert_eq!(states, integrator.states(), "{name}");
        for t in [0.55, 0.75, f64::NAN] {
            let error = integrator.states_within(&motion, t, &mut states).unwrap_err();
            assert!(matches!(error, IntegrationError::OutsideStep { .. }), "{name}: {error}");
        }
    }
}

/// A motion with fields of no force is integrated stage by stage over all bodies, one without body by body: the same
/// motion, to round-off.
#[test]
fn a_field_without_force_changes_nothing() {
    let scene = free_rotation();
    let mut loaded = free_rotation();
    loaded.fields.push(Box::new(PointGravity::new(0.0, DVec3::ZERO).unwrap()));
    for (name, _) in METHODS {
        let [free, loaded] = [&scene, &loaded].map(|scene| scene.run(&mut *method(name), 1.0, 50));
        // The composition of order 4 with loads is another than the single map without.
        let tolerance = if name == "moser-veselov-4" { 1e-6 } else { 1e-14 };
        assert!(difference(&free, &loaded) < tolerance, "{name}: {:e}", difference(&free, &loaded));
    }
}
