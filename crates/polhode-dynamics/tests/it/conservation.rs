//! What each method of fixed step conserves, and its symmetries: energy, angular momentum, reversibility, covariance.

use crate::stepping::{METHODS, ORIENTATIONS, RATES, Scene, difference, method};
use crate::support::{body, cases, direction, moments, rotation, turned_body};
use glam::DVec3;
use polhode_dynamics::field::{Anchor, Field, Spring};
use polhode_dynamics::integrator::{ImplicitGyroscopic, IntegrationError, Integrator, Orientation, Rk4};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{Pose, Rotation, Velocity};
use proptest::prelude::*;

/// Methods that are symmetric in time.
const SYMMETRIC: [&str; 7] = [
    "splitting",
    "splitting-4 (Yoshida)",
    "splitting-4",
    "splitting-6",
    "implicit-midpoint",
    "moser-veselov",
    "moser-veselov-4",
];

fn tumbling() -> Scene {
    let body = body(1.0, DVec3::new(2.3, 3.1, 4.7));
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.4, 0.7, -0.2)), DVec3::ZERO);
    let state = body.at_velocity(pose, Velocity::new(DVec3::ZERO, DVec3::new(0.9, -1.1, 0.7)));
    Scene::free(&body, state)
}

/// Largest relative error of the energy over a free rotation, and whether L kept its bits.
fn energy_error(scene: &Scene, integrator: &mut dyn Integrator, end: f64, steps: usize) -> (f64, bool) {
    let (body, start) = (scene.bodies[0], scene.states[0]);
    let (mut worst, mut same) = (0.0f64, true);
    let before = body.rotational_energy(&start);
    let look = |states: &[BodyState]| {
        worst = worst.max((body.rotational_energy(&states[0]) / before - 1.0).abs());
        same &= states[0].angular_momentum == start.angular_momentum;
    };
    scene.run_looking(integrator, end, steps, look).unwrap();
    (worst, same)
}

/// Moser-Veselov and the midpoint rule keep the energy to round-off in long steps too, over a hundred thousand of them;
/// L is constant to the last bit in every method that turns by rotations. Measured: 4e-14 of energy at worst, a random
/// walk of rounding errors.
#[test]
fn moser_veselov_and_midpoint_keep_energy_and_angular_momentum_to_round_off() {
    let scene = tumbling();
    for name in ["implicit-midpoint", "moser-veselov", "moser-veselov-4"] {
        let (energy, same) = energy_error(&scene, &mut *method(name), 20_000.0, 100_000);
        println!("{name:20} {energy:.1e}");
        assert!(energy < 1e-12, "{name}: {energy:e}");
        assert!(same, "{name}: L has changed");
    }
}

#[test]
fn angular_momentum_keeps_its_bits_in_free_motion() {
    let scene = tumbling();
    for name in SYMMETRIC.into_iter().chain(["rk4", "rkmk4", "cf4"]) {
        assert!(energy_error(&scene, &mut *method(name), 100.0, 1000).1, "{name}");
    }
}

/// A splitting's energy error does not grow: over the last tenth of a hundred thousand steps it is as large as over the
/// first. RK4's grows in proportion to time.
#[test]
fn the_energy_error_of_splitting_is_bounded() {
    let scene = tumbling();
    for name in ["splitting", "splitting-4", "splitting-6"] {
        let short = energy_error(&scene, &mut *method(name), 2000.0, 10_000).0;
        let long = energy_error(&scene, &mut *method(name), 20_000.0, 100_000).0;
        println!("{name:20} {short:.3e} {long:.3e}");
        assert!(long < 1.01 * short, "{name}: {short:e}, {long:e}");
    }
    let [short, long] = [(500.0, 10_000), (5000.0, 100_000)]
        .map(|(end, steps)| energy_error(&scene, &mut Rk4::default(), end, steps).0);
    assert!(long > 5.0 * short, "{short:e}, {long:e}");
}

/// The total energy of a bound motion under forces stays bounded too, for every splitting into kicks and drifts: a body
/// on a spring that acts off its centre (of no rest length: where a spring pushes, its force has a singularity).
#[test]
fn the_energy_of_a_body_on_a_spring_is_bounded() {
    let mut scene = tumbling();
    let end = Anchor::Body { body: 0, point: DVec3::new(0.3, 0.1, -0.2) };
    let spring = Spring::new(end, Anchor::World(DVec3::new(1.0, 0.0, 0.5)), 3.0, 0.0).unwrap();
    scene.fields = vec![Box::new(spring) as Box<dyn Field>];
    let motion = scene.motion();
    let before = motion.total_energy(&scene.states);
    for name in SYMMETRIC {
        let [short, long] = [(100.0, 1000), (3000.0, 30_000)].map(|(end, steps)| {
            let mut worst = 0.0f64;
            let look = |states: &[BodyState]| worst = worst.max((motion.total_energy(states) / before - 1.0).abs());
            scene.run_looking(&mut *method(name), end, steps, look).unwrap();
            worst
        });
        println!("{name:22} {short:.2e} {long:.2e}");
        assert!(long < 3.0 * short, "{name}: {short:e}, {long:e}");
    }
}

proptest! {
    #![proptest_config(cases(64))]

    /// The implicit gyroscopic step never gains energy, whatever the body and the spin, up to a turn of one radian a
    /// step, and explicit Euler never loses any.
    #[test]
    fn the_implicit_gyroscopic_step_dissipates(
        moments in moments(1.0), attitude in rotation(), axis in direction(), turn in 0.001..1.0f64,
    ) {
        let body = body(1.0, moments);
        let state = body.at_velocity(Pose::new(attitude, DVec3::ZERO), Velocity::new(DVec3::ZERO, axis));
        let scene = Scene::free(&body, state);
        let mut energy = body.rotational_energy(&state);
        let look = |states: &[BodyState]| {
            let after = body.rotational_energy(&states[0]);
            assert!(after <= energy * (1.0 + 4.0 * f64::EPSILON), "{energy:e} {after:e}");
            energy = after;
        };
        scene.run_looking(&mut ImplicitGyroscopic::new(), 100.0 * turn, 100, look).unwrap();
        let mut energy = body.rotational_energy(&state);
        let look = |states: &[BodyState]| {
            let after = body.rotational_energy(&states[0]);
            assert!(after >= energy * (1.0 - 4.0 * f64::EPSILON), "{energy:e} {after:e}");
            energy = after;
        };
        scene.run_looking(&mut *method("explicit-euler"), 10.0 * turn, 10, look).unwrap();
    }

    /// A symmetric method goes back to where it came from, with forces too; the others do not, by their truncation.
    #[test]
    fn symmetric_methods_are_reversible(moments in moments(0.7), attitude in rotation(), axis in direction()) {
        let body = body(1.0, moments);
        let velocity = Velocity::new(DVec3::new(0.2, 0.1, 0.3), axis);
        let state = body.at_velocity(Pose::new(attitude, DVec3::new(0.5, 0.1, 0.0)), velocity);
        let mut scene = Scene::free(&body, state);
        let end = Anchor::Body { body: 0, point: DVec3::new(0.1, 0.05, -0.1) };
        let spring = Spring::new(end, Anchor::World(DVec3::X), 0.5, 0.3).unwrap();
        for loaded in [false, true] {
            if loaded {
                scene.fields = vec![Box::new(spring) as Box<dyn Field>];
            }
            let motion = scene.motion();
            for name in SYMMETRIC {
                let mut integrator = method(name);
                integrator.start(&motion, 0.0, &scene.states);
                for h in [0.1; 20].into_iter().chain([-0.1; 20]) {
                    integrator.step(&motion, h).unwrap();
                }
                let error = difference(integrator.states(), &scene.states);
                prop_assert!(error < 2e-13, "{}: {:e}", name, error);
            }
        }
    }

    /// Turning the world, or the axes in which the body is given, turns the motion: no method has a direction of its
    /// own. Euler angles do, in their errors, and the thesis's matrix of a quaternion that is not normalised.
    #[test]
    fn motion_does_not_depend_on_the_axes_it_is_written_in(
        moments in moments(0.7), attitude in rotation(), axis in direction(), world in rotation(), axes in rotation(),
    ) {
        // Axes of nearly equal moments are not defined to round-off, and splitting turns about them.
        let [x, y, z] = moments.to_array();
        prop_assume!([x / y, y / z, z / x].into_iter().all(|ratio| (ratio - 1.0).abs() > 0.1));
        let body = body(1.3, moments);
        let velocity = Velocity::new(DVec3::new(0.2, 0.1, 0.3), axis);
        let state = body.at_velocity(Pose::new(attitude, DVec3::new(0.5, 0.1, 0.0)), velocity);
        let turned = |rotation: Rotation, by: &RigidBody| {
            let velocity = Velocity::new(world.rotate(velocity.linear), world.rotate(velocity.angular));
            by.at_velocity(Pose::new(rotation, world.rotate(state.pose.translation)), velocity)
        };
        let end = |body: &RigidBody, state: BodyState, gravity: DVec3, integrator: &mut dyn Integrator| {
            Scene { gravity, ..Scene::free(body, state) }.run(integrator, 1.0, 20)[0]
        };
        let gravity = DVec3::new(0.0, 0.3, -1.0);
        // The same inertia in other body axes: R_WB' = R_WB axes^-1.
        let other = turned_body(1.3, moments, axes);
        let mut integrators: Vec<(String, Box<dyn Integrator>)> = Vec::new();
        integrators.extend(METHODS.map(|(name, new)| (name.to_owned(), new())));
        let covariant = |o: &Orientation| !matches!(o, Orientation::EulerAngles | Orientation::QuaternionUnnormalized);
        for orientation in ORIENTATIONS.into_iter().filter(covariant) {
            integrators.extend(RATES.map(|rate| -> (String, Box<dyn Integrator>) {
                (format!("{orientation:?} {rate:?}"), Box::new(Rk4::new(orientation, rate)))
            }));
        }
        for (name, mut integrator) in integrators {
            let plain = end(&body, state, gravity, &mut *integrator);
            let start = turned(world * attitude * axes.inverse(), &other);
            let other = end(&other, start, world.rotate(gravity), &mut *integrator);
            let back = world.inverse() * other.pose.rotation * axes;
            // Three numbers lose their digits where the turned quaternion comes near half a turn.
            let tolerance = if name.contains("ThreeNumbers") { 1e-10 } else { 1e-13 };
            let error = back.angle_to(plain.pose.rotation);
            prop_assert!(error < tolerance, "{}: {:e}", name, error);
            prop_assert!((world.inverse_rotate(other.pose.translation) - plain.pose.translation).length() < 1e-13);
            let momentum = world.inverse_rotate(other.angular_momentum) - plain.angular_momentum;
            prop_assert!(momentum.length() < tolerance * plain.angular_momentum.length(), "{}", name);
        }
    }
}

/// Position and velocity of a free body fall exactly as they should, to round-off, in every method but the Euler ones.
#[test]
fn free_fall_is_exact() {
    let mut scene = tumbling();
    scene.gravity = DVec3::new(0.1, 0.0, -9.81);
    scene.states[0].linear_velocity = DVec3::new(3.0, 0.0, 4.0);
    let (v, g) = (scene.states[0].linear_velocity, scene.gravity);
    for (name, new) in METHODS.into_iter().filter(|(_, new)| new().order() > 1) {
        let end = scene.run(&mut *new(), 2.0, 40)[0];
        assert!((end.pose.translation - (v * 2.0 + g * 2.0)).length() < 1e-13, "{name}");
        assert!((end.linear_velocity - (v + g * 2.0)).length() < 1e-13, "{name}");
    }
}

/// A pivot stays where it is, to the last bit, in every method and representation.
#[test]
fn a_pivot_stays() {
    let scene = crate::integrator_orders::heavy_top();
    let mut integrators: Vec<Box<dyn Integrator>> = METHODS.map(|(_, new)| new()).into();
    for orientation in ORIENTATIONS {
        integrators.extend(RATES.map(|rate| -> Box<dyn Integrator> { Box::new(Rk4::new(orientation, rate)) }));
    }
    for mut integrator in integrators {
        let end = scene.run(&mut *integrator, 1.0, 100)[0];
        assert_eq!(end.pose.translation, scene.states[0].pose.translation, "{integrator:?}");
        assert_eq!(end.linear_velocity, DVec3::ZERO, "{integrator:?}");
    }
}

/// What no method can integrate is an error with the states kept, never a panic: steps far too long for the implicit
/// equations, steps and states that are not finite, states that are not those of the bodies.
#[test]
fn what_cannot_be_integrated_is_an_error() {
    let scene = tumbling();
    let motion = scene.motion();
    let not_finite = BodyState { angular_momentum: DVec3::NAN, ..scene.states[0] };
    for (name, new) in METHODS {
        for h in [f64::NAN, f64::INFINITY, 1e300] {
            let mut integrator = new();
            integrator.start(&motion, 0.0, &scene.states);
            let result = integrator.step(&motion, h);
            assert!(result.is_err() || integrator.states()[0].is_finite(), "{name}, {h}");
            if result.is_err() {
                assert_eq!((integrator.states(), integrator.time()), (&scene.states[..], 0.0), "{name}, {h}");
            }
        }
        let mut integrator = new();
        integrator.start(&motion, 0.0, &[not_finite]);
        assert_eq!(integrator.step(&motion, 0.1), Err(IntegrationError::NotFinite { t: 0.0 }), "{name}");
        for states in [0, 2] {
            integrator.start(&motion, 0.0, &vec![scene.states[0]; states]);
            let wrong = IntegrationError::StateCount { states, bodies: 1 };
            assert_eq!(integrator.step(&motion, 0.1), Err(wrong), "{name}");
        }
    }
    for name in ["moser-veselov", "moser-veselov-4"] {
        let error = scene.run_looking(&mut *method(name), 100.0, 10, |_| ()).unwrap_err();
        assert!(matches!(error, IntegrationError::NoConvergence { .. }), "{name}: {error}");
    }
}
