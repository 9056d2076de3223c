//! Kinematic bodies that a program steers: the motion is that of a scene that prescribes the same, in every rigid tier;
//! what the body does to others is booked; a snapshot keeps it; what cannot be is refused.

use crate::checks::{assert_closes, heavy_brick};
use crate::support::{ball, elastic, floor};
use polhode::contact::Shape;
use polhode::scene::{Interpolation, Method, MotionTable, PrescribedMotion, SampledOrientations, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{
    ActionError, Body, BodyId, Geometry, Outcome, Recorder, RunReport, Scene, Simulation, SimulationError, Steering,
};

const G: f64 = 9.81;
const RADIUS: f64 = 0.2;

fn still() -> PrescribedMotion {
    PrescribedMotion::constant_velocity(Velocity::ZERO).unwrap()
}

/// A slab 4 x 4 x 0.2 m whose top is at z = 0.
fn slab(motion: PrescribedMotion) -> Body {
    let shape = Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 4.0, 0.2)).unwrap());
    Body::kinematic("slab", motion).geometry(shape).pose(Pose::from_translation(DVec3::Z * -0.1))
}

/// All tiers but that of springs, whose stiffness follows from the speeds at the start: a body that is steered later
/// meets others.
fn rigid_tiers() -> impl Iterator<Item = Tier> {
    Tier::ALL.into_iter().filter(|tier| *tier != Tier::Penalty)
}

fn scene(tier: Tier, slab: Body, load: Body) -> Scene {
    let method = Method { tier: Some(tier), step_s: Some(1e-3), ..Method::default() };
    Scene::builder("steered").method(method).duration_s(1.0).body(slab).body(load).build().unwrap()
}

/// Advances to these times and does what the program does there; then runs to the end.
fn run(scene: &Scene, program: &[(f64, Steering)]) -> (RunReport, Recorder) {
    let mut simulation = Simulation::new(scene).unwrap();
    let mut recorder = Recorder::default();
    for &(t, steering) in program {
        if t > simulation.time() {
            simulation.advance_to_observed(t, &mut recorder).unwrap();
        }
        simulation.set_motion(body(&simulation, "slab"), steering).unwrap();
    }
    let report = simulation.run_observed(&mut recorder).unwrap();
    (report, recorder)
}

fn body(simulation: &Simulation, name: &str) -> BodyId {
    simulation.body_id(name).unwrap()
}

/// The largest distance of the samples of two runs: of places (m), and of velocities (m/s).
fn apart(one: &Recorder, other: &Recorder) -> f64 {
    assert_eq!(one.times_s, other.times_s);
    let pairs = one.samples.iter().flatten().zip(other.samples.iter().flatten());
    let distance = |(a, b): (&polhode::BodySample, &polhode::BodySample)| {
        let place = (a.pose.translation - b.pose.translation).length();
        place.max((a.velocity.linear - b.velocity.linear).length()).max(a.pose.rotation.angle_to(b.pose.rotation))
    };
    pairs.map(distance).fold(0.0, f64::max)
}

/// A velocity that is set at the start is the constant velocity of a scene, in every rigid tier: a slab that rises
/// under a ball in flight and strikes it.
#[test]
fn a_velocity_is_the_constant_motion_of_a_scene() {
    let velocity = Velocity::new(DVec3::new(0.1, 0.0, 1.5), DVec3::Z * 0.3);
    for tier in rigid_tiers() {
        let load = || ball("ball", 1.3, RADIUS, DVec3::Z * 1.0, DVec3::ZERO).material(elastic(0.5));
        let own = scene(tier, slab(still()).material(elastic(0.5)), load());
        let prescribed = PrescribedMotion::constant_velocity(velocity).unwrap();
        let given = scene(tier, slab(prescribed).material(elastic(0.5)), load());
        let (report, steered) = run(&own, &[(0.0, Steering::Velocity(velocity))]);
        let (expected, table) = run(&given, &[]);
        assert!(apart(&steered, &table) < 1e-12, "{tier:?} {:e}", apart(&steered, &table));
        let work = report.ledger.external.value();
        assert!((work - expected.ledger.external.value()).abs() < 1e-11 && work > 1.0, "{tier:?} {work}");
        assert_closes(&report);
    }
}

/// A pose that is reached within a time is a table of two samples, in every rigid tier, and its work is the weight
/// times the height: from rest to rest the kinetic energy does not change.
#[test]
fn a_pose_is_a_table_of_two_samples() {
    // So slow that the load stays on the slab.
    let (from, until) = (0.25, 0.9);
    let turn = DVec3::new(0.0, 0.0, 1.2);
    let end = Pose::new(Rotation::from_rotation_vector(turn), DVec3::new(0.3, 0.0, 0.4));
    for tier in rigid_tiers() {
        let table = MotionTable {
            times_s: vec![from, until],
            positions_m: Some(vec![DVec3::Z * -0.1, end.translation]),
            orientations: Some(SampledOrientations::RotationVectors(vec![DVec3::ZERO, turn])),
            interpolation: Interpolation::Spline,
        };
        let load = || heavy_brick("load", 2.0, DVec3::splat(0.4), DVec3::Z * 0.2);
        let (report, steered) =
            run(&scene(tier, slab(still()), load()), &[(from, Steering::Pose { pose: end, within_s: until - from })]);
        // A program that advances to a time ends a step there, in both runs.
        let given = scene(tier, slab(PrescribedMotion::table(&table).unwrap()), load());
        let mut simulation = Simulation::new(&given).unwrap();
        let mut recorder = Recorder::default();
        simulation.advance_to_observed(from, &mut recorder).unwrap();
        let expected = simulation.run_observed(&mut recorder).unwrap();
        assert!(apart(&steered, &recorder) < 1e-12, "{tier:?} {:e}", apart(&steered, &recorder));
        let work = report.ledger.external.value();
        assert!((work - expected.ledger.external.value()).abs() < 1e-11, "{tier:?} {work}");
        assert_closes(&report);
        let lifted = 2.0 * G * 0.5;
        let error = match tier {
            Tier::Accurate => 1e-11,
            // Of the order of a step.
            _ => 0.05 * lifted,
        };
        assert!((work - lifted).abs() < error, "{tier:?} {work} {lifted}");
    }
}

/// A slab that rises with a load and is halted leaves the load its speed: it flies on by `v^2/2g`. The load that lies
/// on a slab wakes when the slab moves, and rests again where it stands.
#[test]
fn a_halted_lift_leaves_its_load_the_speed() {
    let speed = 1.2;
    let load = heavy_brick("load", 2.0, DVec3::splat(0.4), DVec3::Z * 0.2);
    let mut simulation = Simulation::new(&scene(Tier::Accurate, slab(still()), load)).unwrap();
    let [slab, load] = ["slab", "load"].map(|name| body(&simulation, name));
    simulation.advance_to(0.1).unwrap();
    simulation.set_motion(slab, Steering::Velocity(Velocity::new(DVec3::Z * speed, DVec3::ZERO))).unwrap();
    simulation.advance_to(0.3).unwrap();
    assert!((simulation.body(load).velocity.linear.z - speed).abs() < 1e-12);
    simulation.set_motion(slab, Steering::HALT).unwrap();
    let height = simulation.body(load).pose.translation.z;
    assert!((height - 0.2 - speed * 0.2).abs() < 1e-12);
    simulation.advance_to(0.3 + speed / G).unwrap();
    let flown = simulation.body(load).pose.translation.z - height;
    assert!((flown - speed * speed / (2.0 * G)).abs() < 1e-12, "{flown}");
    let report = simulation.run().unwrap();
    assert_eq!(simulation.body(load).velocity, Velocity::ZERO);
    assert_closes(&report);
    // The load was struck once by the slab: the impulse m v at the speed v, half of which becomes kinetic energy.
    let external = 2.0 * speed * speed + 2.0 * G * speed * 0.2;
    assert!((report.ledger.external.value() - external).abs() < 1e-10, "{:?} {external}", report.ledger.external);
}

/// A new target before the last one is reached changes neither pose nor velocity nor acceleration at that instant, and
/// the body ends exactly at the new one.
#[test]
fn a_new_target_is_taken_smoothly() {
    let load = heavy_brick("load", 2.0, DVec3::splat(0.4), DVec3::Z * 0.2);
    let mut simulation = Simulation::new(&scene(Tier::Accurate, slab(still()), load)).unwrap();
    let slab = body(&simulation, "slab");
    let to = |z: f64, angle: f64| Steering::Pose {
        pose: Pose::new(Rotation::from_rotation_vector(DVec3::Z * angle), DVec3::Z * z),
        within_s: 0.5,
    };
    simulation.set_motion(slab, to(0.3, 0.5)).unwrap();
    simulation.advance_to(0.2).unwrap();
    let (before, accelerations) = (simulation.body(slab), simulation.accelerations().unwrap());
    assert!(before.velocity.linear.z > 0.5 && before.velocity.angular.z > 0.5);
    simulation.set_motion(slab, to(0.1, -0.3)).unwrap();
    let (after, now) = (simulation.body(slab), simulation.accelerations().unwrap());
    assert!((before.pose.translation - after.pose.translation).length() < 1e-15);
    assert!((before.velocity.linear - after.velocity.linear).length() < 1e-14);
    assert!((before.velocity.angular - after.velocity.angular).length() < 1e-14);
    for (one, other) in accelerations.iter().zip(&now) {
        assert!((one.linear - other.linear).length() < 1e-11, "{one:?} {other:?}");
    }
    simulation.advance_to(0.9).unwrap();
    let end = simulation.body(slab);
    assert_eq!(end.velocity, Velocity::ZERO);
    assert!((end.pose.translation - DVec3::Z * 0.1).length() < 1e-15);
    assert!(end.pose.rotation.angle_to(Rotation::from_rotation_vector(DVec3::Z * -0.3)) < 1e-15);
}

/// A snapshot holds what the program has said: the run goes on with the same bits. A snapshot of an earlier time brings
/// the motion of the scene back.
#[test]
fn a_snapshot_keeps_the_motion() {
    for tier in rigid_tiers() {
        let sine = PrescribedMotion::sine(DVec3::Z * 0.01, DVec3::ZERO, 1.0, 0.0).unwrap();
        let scene = scene(tier, slab(sine), heavy_brick("load", 2.0, DVec3::splat(0.4), DVec3::Z * 0.2));
        let mut simulation = Simulation::new(&scene).unwrap();
        let slab = body(&simulation, "slab");
        simulation.advance_to(0.1).unwrap();
        let unsteered = simulation.snapshot();
        let pose = Pose::from_translation(DVec3::Z * 0.2);
        simulation.set_motion(slab, Steering::Pose { pose, within_s: 0.4 }).unwrap();
        simulation.advance_to(0.3).unwrap();
        let snapshot = simulation.snapshot();
        let mut again = Simulation::new(&scene).unwrap();
        again.restore(&snapshot).unwrap();
        let (first, second) = (simulation.run().unwrap(), again.run().unwrap());
        assert_eq!(simulation.bodies(), again.bodies(), "{tier:?}");
        assert_eq!(first.ledger, second.ledger, "{tier:?}");
        again.restore(&unsteered).unwrap();
        again.run().unwrap();
        let mut never = Simulation::new(&scene).unwrap();
        never.advance_to(0.1).unwrap();
        never.run().unwrap();
        assert_eq!(again.bodies(), never.bodies(), "{tier:?}");
    }
}

/// A steered body passes through others only as they let it: a wall that a program moves pushes what it meets, also
/// what flies apart from it at the time of the command.
#[test]
fn a_steered_body_meets_what_it_did_not_touch() {
    let load = ball("ball", 1.0, RADIUS, DVec3::Z * (RADIUS + 0.5), DVec3::ZERO).material(elastic(0.0));
    let builder = Scene::builder("meets").gravity(DVec3::ZERO).duration_s(2.0).body(slab(still())).body(load);
    let scene = builder.build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.4).unwrap();
    let slab = body(&simulation, "slab");
    simulation.set_motion(slab, Steering::Velocity(Velocity::new(DVec3::Z, DVec3::ZERO))).unwrap();
    let report = simulation.run().unwrap();
    assert_eq!(report.outcome, Outcome::Completed);
    // The slab meets the ball at 0.9 s and carries it with it for 1.1 s.
    let place = simulation.body(body(&simulation, "ball")).pose.translation.z;
    assert!((place - (RADIUS + 0.5 + 1.1)).abs() < 1e-12, "{place}");
    assert!((report.ledger.external.value() - 1.0).abs() < 1e-12);
}

/// What is refused leaves the simulation as it was.
#[test]
fn what_cannot_be_is_refused() {
    let load = heavy_brick("load", 2.0, DVec3::splat(0.4), DVec3::Z * 0.5);
    let floor = floor().pose(Pose::from_translation(DVec3::Z * -2.0));
    let builder = Scene::builder("refused").duration_s(0.1).body(floor).body(slab(still())).body(load);
    let mut simulation = Simulation::new(&builder.build().unwrap()).unwrap();
    let [floor, slab, load] = ["floor", "slab", "load"].map(|name| body(&simulation, name));
    let before = simulation.snapshot();
    let mut refusal = |body, steering| match simulation.set_motion(body, steering) {
        Err(SimulationError::Action(error)) => error,
        other => panic!("{other:?}"),
    };
    for other in [floor, load] {
        assert!(matches!(refusal(other, Steering::HALT), ActionError::NotKinematic(_)));
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let linear = Steering::Velocity(Velocity::new(DVec3::X * bad, DVec3::ZERO));
        let angular = Steering::Velocity(Velocity::new(DVec3::ZERO, DVec3::X * bad));
        let pose = Steering::Pose { pose: Pose::from_translation(DVec3::Y * bad), within_s: 1.0 };
        for steering in [linear, angular, pose] {
            assert!(matches!(refusal(slab, steering), ActionError::NotFinite { .. }));
        }
    }
    for within_s in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let steering = Steering::Pose { pose: Pose::IDENTITY, within_s };
        assert!(matches!(refusal(slab, steering), ActionError::Time { .. }), "{within_s}");
    }
    let fast = Steering::Velocity(Velocity::new(DVec3::X * 1e200, DVec3::ZERO));
    assert!(matches!(refusal(slab, fast), ActionError::Motion { .. }));
    let fast = Steering::Pose { pose: Pose::from_translation(DVec3::X * 1e99), within_s: 1e-9 };
    assert!(matches!(refusal(slab, fast), ActionError::Motion { .. }));
    assert_eq!(simulation.snapshot().to_bytes(), before.to_bytes());
    simulation.remove_body(slab).unwrap();
    let gone = simulation.set_motion(slab, Steering::HALT);
    assert!(matches!(gone, Err(SimulationError::Action(ActionError::RemovedBody(_)))), "{gone:?}");
}
