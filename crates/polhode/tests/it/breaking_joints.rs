//! Joints that break: at the time at which their load reaches their strength, as closed forms say; what they held flies
//! on from there; breaking takes no energy; impulses of impacts break those that have a greatest impulse; a snapshot
//! from before makes them whole.

use crate::checks::assert_closes;
use crate::joints::{inertia, rod};
use crate::support::{accurate, ball, brick, run};
use polhode::mesh::solid_box;
use polhode::scene::{Force, Frame, Joint, JointKind, Method, Signal, Strength, Tier};
use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
use polhode::{Body, Effects, EventKind, Recorder, Scene, SceneBuilder, Simulation, Snapshot};

const G: f64 = 9.81;

fn stepped(step_s: f64) -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(step_s), ..Method::default() }
}

fn strength() -> Strength {
    Strength::default()
}

/// The time of the only break of a joint.
#[track_caller]
fn broke_at(recorder: &Recorder) -> f64 {
    let breaks: Vec<f64> =
        recorder.events.iter().filter(|event| event.kind == EventKind::Break).map(|event| event.t_s).collect();
    assert_eq!(breaks.len(), 1, "{breaks:?}");
    breaks[0]
}

/// A block of 2 kg that a weld holds to the world, pulled down by a force that grows with 10 N/s.
fn pulled(method: Method, weld: Strength) -> SceneBuilder {
    let mut scene = Scene::builder("pulled").method(method).gravity(DVec3::Z * -G).duration_s(3.0);
    let properties = solid_box(DVec3::splat(0.1), Mass::new(2.0).unwrap()).unwrap();
    let block = scene.add_body(Body::movable("block", properties));
    let weld = Joint::new(JointKind::Fixed, block, DVec3::Z * 0.05).breaking_at(weld);
    let (force, torque, frame) = (DVec3::Z * -10.0, DVec3::ZERO, Frame::World);
    let signal = Signal::polynomial(vec![0.0, 1.0]).unwrap();
    scene.joint(weld).force(Force::Applied { body: block, force, torque, frame, point: None, signal })
}

/// The weld breaks when weight and pull are its strength, and the block falls from then on under both.
#[test]
fn a_weld_breaks_when_its_load_is_its_strength() {
    let most = 31.0;
    let expected = (most - 2.0 * G) / 10.0;
    for (method, within) in [(accurate(), 1e-10), (stepped(1e-3), 1.001e-3)] {
        let is_accurate = method.tier == Some(Tier::Accurate);
        let scene = pulled(method, strength().force(most).unwrap()).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let t = broke_at(&recorder);
        assert!((t - expected).abs() < within, "{t} and {expected}");
        // z'' = -g - 5 t after the break.
        let fallen = |t1: f64| {
            let h = t1 - expected;
            -0.5 * G * h * h - 5.0 * (t1.powi(3) / 6.0 - expected.powi(2) * t1 / 2.0 + expected.powi(3) / 3.0)
        };
        let z = report.bodies[0].state.pose.translation.z;
        assert!((z - fallen(3.0)).abs() < if is_accurate { 1e-9 } else { 0.05 }, "{z} and {}", fallen(3.0));
        assert_closes(&report);
    }
}

/// A rod that falls from level about its end: of a thin one the force of the hinge is 2.5 m g sin along it and m g cos
/// / 4 across it. Where that reaches the strength the rod flies off with the velocity that it has there.
#[test]
fn a_falling_rod_breaks_its_hinge_where_newton_says() {
    let (mass, length) = (1.5, 0.8);
    let most = 2.0 * mass * G;
    // Of a thin rod (2.5 s)^2 + (c/4)^2 = 2^2 with s^2 + c^2 = 1, s the sine of the angle below level.
    let moment = inertia((mass, length)) + 0.25 * mass * length * length;
    let share = mass * length * length / moment;
    let (along, across) = (1.0 + 0.5 * share, 1.0 - 0.25 * share);
    let sine = ((4.0 - across * across) / (along * along - across * across)).sqrt();
    let mut scene = Scene::builder("falling rod").method(accurate()).gravity(DVec3::Z * -G).duration_s(1.0);
    let body = rod("rod", (mass, length), DVec3::X * (0.5 * length), std::f64::consts::FRAC_PI_2);
    let body = scene.add_body(body);
    let hinge = Joint::hinge(body, DVec3::ZERO, UnitVector::Y).breaking_at(strength().force(most).unwrap());
    let (report, recorder) = run(&scene.joint(hinge).build().unwrap(), Effects::Planned);
    let rate = (mass * G * length * sine / moment).sqrt();
    let end = &report.bodies[0].state;
    assert!(
        (end.velocity.angular.length() - rate).abs() < 1e-10 * rate,
        "{} and {rate}",
        end.velocity.angular.length()
    );
    let (t, cosine) = (broke_at(&recorder), (1.0 - sine * sine).sqrt());
    let speed = 0.5 * length * rate;
    let down = speed * cosine + G * (1.0 - t);
    assert!((end.velocity.linear.z + down).abs() < 1e-9, "{} and {down}", end.velocity.linear.z);
    assert!((end.velocity.linear.x.abs() - speed * sine).abs() < 1e-10, "{}", end.velocity.linear.x);
    assert_closes(&report);
}

/// A beam of two halves that welds hold to a wall: when the moment breaks the one at the wall, both halves fall as one.
#[test]
fn what_is_behind_a_broken_weld_stays_together() {
    let half = |name: &str, x: f64| brick(name, DVec3::new(0.5, 0.1, 0.1), DVec3::X * x);
    let mut scene = Scene::builder("beam").method(accurate()).gravity(DVec3::Z * -G).duration_s(0.5);
    let (near, far) = (scene.add_body(half("near", 0.25)), scene.add_body(half("far", 0.75)));
    let wall = Joint::new(JointKind::Fixed, near, DVec3::ZERO).breaking_at(strength().moment(9.0).unwrap());
    let middle = Joint::new(JointKind::Fixed, far, DVec3::X * 0.5).with(near);
    let middle = middle.breaking_at(strength().moment(9.0).unwrap().force(1e3).unwrap());
    // 2 kg at 0.5 m have 9.81 N m at the wall, 1 kg at 0.25 m have 2.45 N m in the middle.
    let (report, recorder) = run(&scene.joint(wall).joint(middle).build().unwrap(), Effects::Planned);
    assert_eq!(broke_at(&recorder), 0.0);
    for (body, x) in report.bodies.iter().zip([0.25, 0.75]) {
        let off = body.state.pose.translation - DVec3::new(x, 0.0, -0.5 * G * 0.25);
        assert!(off.length() < 1e-10, "{off}");
    }
    assert_closes(&report);
}

/// A ball strikes a plate that a weld holds: with a greatest impulse below that of the impact the plate is free
/// afterwards, after an impact with the weld whole; without one it stays.
#[test]
fn an_impulse_breaks_what_has_a_greatest_impulse() {
    let fly = |weld: Strength| {
        let mut scene = Scene::builder("struck").method(accurate()).gravity(DVec3::ZERO).duration_s(1.0);
        let plate = scene.add_body(brick("plate", DVec3::new(1.0, 1.0, 0.1), DVec3::ZERO));
        scene.add_body(ball("ball", 0.5, 0.1, DVec3::Z * 0.5, DVec3::Z * -2.0));
        let weld = Joint::new(JointKind::Fixed, plate, DVec3::Z * -0.05).breaking_at(weld);
        run(&scene.joint(weld).build().unwrap(), Effects::Planned)
    };
    // The ball stops on the plate: 1 N s, which the weld bears.
    let (report, recorder) = fly(strength().impulse(0.9).unwrap());
    assert!((broke_at(&recorder) - 0.175).abs() < 1e-10);
    assert!(report.bodies[0].state.velocity.linear.length() < 1e-12);
    let (_, recorder) = fly(strength().impulse(1.1).unwrap());
    assert!(recorder.events.iter().all(|event| event.kind != EventKind::Break));
    // Without a bound of impulses there is none.
    let (_, recorder) = fly(strength().force(1.0).unwrap());
    assert!(recorder.events.iter().all(|event| event.kind != EventKind::Break));
}

/// A snapshot from before the break makes the joint whole again; one from after it goes on with the same bits.
#[test]
fn broken_joints_are_part_of_a_snapshot() {
    for method in [accurate(), stepped(1e-3)] {
        let scene = pulled(method, strength().force(31.0).unwrap()).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.7).unwrap();
        let before = simulation.snapshot().to_bytes();
        assert_eq!(simulation.joint_loads().len(), 1);
        simulation.advance_to(2.0).unwrap();
        assert!(simulation.joint_loads().is_empty());
        let after = simulation.snapshot().to_bytes();
        let whole = simulation.run().unwrap();
        for bytes in [&after, &before] {
            simulation.restore(&Snapshot::from_bytes(bytes).unwrap()).unwrap();
            assert_eq!(simulation.joint_loads().len(), usize::from(bytes == &before));
            assert_eq!(simulation.run().unwrap().bodies, whole.bodies);
        }
    }
}

/// The loads of joints in time steps are those of the equations at that state.
#[test]
fn time_steps_tell_the_loads_of_joints() {
    let beam = |method: Method| {
        let mut scene = Scene::builder("cantilever").method(method).gravity(DVec3::Z * -G);
        let properties = solid_box(DVec3::new(1.0, 0.1, 0.1), Mass::new(2.0).unwrap()).unwrap();
        let beam = scene.add_body(Body::movable("beam", properties).pose(Pose::from_translation(DVec3::X * 0.5)));
        let weld = Joint::new(JointKind::Fixed, beam, DVec3::ZERO);
        let mut simulation = Simulation::new(&scene.joint(weld).build().unwrap()).unwrap();
        simulation.advance_to(0.5).unwrap();
        simulation.joint_loads()[0]
    };
    for method in [accurate(), stepped(1e-2)] {
        let load = beam(method);
        assert!((load.force_n - DVec3::Z * 2.0 * G).length() < 1e-11, "{load:?}");
        assert!((load.moment_n_m - DVec3::Y * -G).length() < 1e-11, "{load:?}");
    }
}

/// Strengths that are no load are refused.
#[test]
fn a_strength_is_above_zero() {
    for value in [0.0, -1.0, f64::NAN] {
        assert!(strength().force(value).is_err() && strength().moment(value).is_err());
        assert!(strength().impulse(value).is_err());
    }
    assert!(strength().force(f64::INFINITY).is_ok());
}
