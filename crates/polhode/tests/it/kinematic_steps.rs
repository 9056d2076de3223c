//! Kinematic bodies in time steps: the tier `stepped`, and stretches of crowded events in the tier `accurate`.

use crate::checks::max_position_error;
use crate::stepped::{run_by, stepped};
use crate::support::{accurate, ball, brick, elastic};
use polhode::contact::Shape;
use polhode::scene::{Method, PrescribedMotion};
use polhode::spatial::{DVec3, Motion, Pose, Velocity};
use polhode::{Body, Geometry, Scene, SceneBuilder, Simulation, Steering};
use std::f64::consts::PI;

const G: f64 = 9.81;
const RADIUS: f64 = 0.2;

/// A slab 4 x 4 x 0.2 m whose top is at z = 0 where its motion begins.
fn slab(motion: PrescribedMotion) -> Body {
    let shape = Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 4.0, 0.2)).unwrap());
    Body::kinematic("slab", motion).geometry(shape).pose(Pose::from_translation(DVec3::Z * -0.1))
}

fn steady(linear: DVec3) -> PrescribedMotion {
    PrescribedMotion::constant_velocity(Velocity::new(linear, DVec3::ZERO)).unwrap()
}

/// A box on a conveyor without friction stays where it is, and the conveyor does no work; each pose of the conveyor is
/// the prescribed one to the last bit.
#[test]
fn box_on_a_conveyor_without_friction_stays() {
    let belt = slab(steady(DVec3::X * 0.8));
    let trajectory = belt.trajectory().unwrap();
    let scene = Scene::builder("conveyor").duration_s(1.5).output_interval_s(0.013);
    let scene = scene.body(belt).body(brick("box", DVec3::splat(0.4), DVec3::Z * 0.2));
    let (report, recorder) = run_by(&scene, stepped(0.01));
    assert!(max_position_error(&recorder, 1, |_| DVec3::Z * 0.2) < 1e-13);
    for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        assert_eq!((row[0].pose, row[0].velocity), (trajectory.pose(t), trajectory.velocity(t)), "{t}");
    }
    assert!(report.ledger.external.value().abs() < 1e-13 * report.ledger.scale_j, "{:?}", report.ledger);
}

/// A lift of constant speed carries a ball: the ball stays on it to rounding, and the work of the lift is the energy
/// that the ball gains.
#[test]
fn lift_does_the_work_of_raising_a_ball() {
    let scene = Scene::builder("lift").duration_s(1.0).output_interval_s(0.1).body(slab(steady(DVec3::Z * 0.5)));
    let scene = scene.body(ball("ball", 2.0, RADIUS, DVec3::Z * RADIUS, DVec3::Z * 0.5));
    let (report, recorder) = run_by(&scene, stepped(0.01));
    assert!(max_position_error(&recorder, 1, |t| DVec3::Z * (RADIUS + 0.5 * t)) < 1e-12);
    assert!((report.ledger.external.value() - 2.0 * G * 0.5).abs() < 1e-10, "{:?}", report.ledger);
    assert!(report.ledger.impact.value().abs() < 1e-10, "{:?}", report.ledger);
}

/// A ball bounces on a table that oscillates vertically. The error of `stepped` against `accurate` is of second order
/// in the step: in the height of the ball, in the work of the table and in the loss by impacts.
#[test]
fn bounces_on_a_shaken_table_converge() {
    let shaken = PrescribedMotion::sine(DVec3::Z * 0.03, DVec3::ZERO, 3.0, 0.0).unwrap();
    let scene = Scene::builder("shaken").duration_s(1.1).output_interval_s(1.1);
    let scene = scene.body(slab(shaken).material(elastic(0.7)));
    let scene = scene.body(ball("ball", 0.6, RADIUS, DVec3::Z * (RADIUS + 0.4), DVec3::ZERO).material(elastic(0.7)));
    let results = |method: Method| {
        let (report, recorder) = run_by(&scene, method);
        let height = recorder.samples.last().unwrap()[1].pose.translation.z;
        [height, report.ledger.external.value(), report.ledger.impact.value()]
    };
    let exact = results(accurate());
    let errors = [0.02, 0.01, 0.005, 0.0025, 0.00125].map(|step| {
        let found = results(stepped(step));
        [0, 1, 2].map(|k| (found[k] - exact[k]).abs())
    });
    for k in 0..3 {
        let order = (errors[0][k] / errors[4][k]).log2() / 4.0;
        assert!(order > 1.7, "{k}: order {order}: {errors:?}");
    }
}

/// A ball stays on a table that oscillates with accelerations below g, to second order in the step.
#[test]
fn ball_on_a_gentle_table_stays_on_it() {
    let (amplitude, rate) = (0.02, std::f64::consts::TAU);
    let gentle = PrescribedMotion::sine(DVec3::Z * amplitude, DVec3::ZERO, 1.0, 0.0).unwrap();
    let top = |t: f64| amplitude * (rate * t).sin();
    let scene = Scene::builder("gentle").duration_s(1.0).output_interval_s(0.05).body(slab(gentle));
    let scene = scene.body(ball("ball", 1.0, RADIUS, DVec3::Z * RADIUS, DVec3::Z * (amplitude * rate)));
    let errors = [0.02, 0.01, 0.005].map(|step| {
        let (report, recorder) = run_by(&scene, stepped(step));
        assert!(report.ledger.impact.value().abs() < step * step, "{step}: {:?}", report.ledger);
        max_position_error(&recorder, 1, |t| DVec3::Z * (RADIUS + top(t)))
    });
    assert!(errors[2] < 1e-4 && errors[0] / errors[2] > 8.0, "{errors:?}");
}

/// A bin that is shaken, as a compound of five walls, with balls in it.
fn shaken_bin(count: u32) -> SceneBuilder {
    let wall = |size: DVec3, place: DVec3| Shape::cuboid(size).unwrap().translated(place).unwrap();
    let mut walls = vec![wall(DVec3::new(1.4, 1.4, 0.2), DVec3::Z * -0.1)];
    for side in [-0.6, 0.6] {
        walls.push(wall(DVec3::new(0.2, 1.4, 1.0), DVec3::new(side, 0.0, 0.5)));
        walls.push(wall(DVec3::new(1.0, 0.2, 1.0), DVec3::new(0.0, side, 0.5)));
    }
    let shaking = PrescribedMotion::sine(DVec3::new(0.02, 0.0, 0.01), DVec3::ZERO, 2.0, 0.0).unwrap();
    let bin = Body::kinematic("bin", shaking).geometry(Geometry::Shape(Shape::compound(walls).unwrap()));
    let mut scene = Scene::builder("bin").duration_s(1.0).output_interval_s(0.1).body(bin.material(elastic(0.3)));
    for k in 0..count {
        let place = DVec3::new(
            0.4 * f64::from(k % 2) - 0.2 + 0.01 * f64::from(k),
            0.4 * f64::from(k / 2 % 2) - 0.2,
            0.2 + 0.35 * f64::from(k / 4),
        );
        scene = scene.body(ball(&format!("ball {k}"), 0.5, 0.12, place, DVec3::ZERO).material(elastic(0.3)));
    }
    scene
}

/// Balls in a shaken bin go through stretches of crowded events in the tier `accurate`, whose report names them;
/// nothing leaves the bin, and the ledgers close with the work of the bin in them.
#[test]
fn pile_in_a_shaken_bin_goes_through_crowding() {
    let (report, recorder) = run_by(&shaken_bin(16), accurate());
    assert!(!report.crowded.is_empty(), "{:?}", report.warnings);
    assert!(report.certificate.max_penetration_of_limit <= 1.0, "{:?}", report.certificate);
    assert!(report.ledger.external.value().abs() > 1e-3, "{:?}", report.ledger);
    let trajectory = shaken_bin(0).build().unwrap().bodies()[0].trajectory().unwrap();
    for (&t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        for own in &row[1..] {
            let seen = trajectory.pose(t).inverse_transform_point(own.pose.translation);
            assert!(seen.x.abs() < 0.45 && seen.y.abs() < 0.45 && seen.z > 0.05, "{t} {seen}");
        }
    }
}

/// The same pile in a bin that a program moves about, also within its stretches of crowded events, whose companion is
/// moved with it: nothing leaves the bin, and a run restored from a snapshot continues with the same bits.
#[test]
fn pile_in_a_steered_bin_stays_in_it() {
    let scene = shaken_bin(16).method(accurate()).build().unwrap();
    let mut whole = Simulation::new(&scene).unwrap();
    let mut resumed = Simulation::new(&scene).unwrap();
    let bin = whole.body_id("bin").unwrap();
    let steer = |simulation: &mut Simulation, k: u32| {
        let t = 0.05 * f64::from(k + 1);
        let pose = Pose::from_translation(DVec3::new(0.02, 0.0, 0.01) * (4.0 * PI * t).sin());
        simulation.set_motion(bin, Steering::Pose { pose, within_s: 0.05 }).unwrap();
        simulation.advance_to(t).unwrap();
        let inverse = simulation.body(bin).pose.inverse();
        for own in &simulation.bodies()[1..] {
            let seen = inverse.transform_point(own.pose.translation);
            assert!(seen.x.abs() < 0.45 && seen.y.abs() < 0.45 && seen.z > 0.05, "{k} {seen}");
        }
    };
    for k in 0..20 {
        if k == 15 {
            resumed.restore(&whole.snapshot()).unwrap();
        }
        steer(&mut whole, k);
        if k >= 15 {
            steer(&mut resumed, k);
        }
    }
    let report = whole.run().unwrap();
    assert!(!report.crowded.is_empty() && report.error.largest.is_some(), "{:?}", report.warnings);
    assert!(report.certificate.max_penetration_of_limit <= 1.0, "{:?}", report.certificate);
    assert_eq!(report.ledger, resumed.run().unwrap().ledger);
    assert_eq!(whole.bodies(), resumed.bodies());
}

/// The same pile by fixed steps: a run restored from a snapshot within a step continues with the same bits.
#[test]
fn pile_in_a_shaken_bin_by_fixed_steps() {
    let scene = shaken_bin(6);
    let (report, _) = run_by(&scene, stepped(0.005));
    assert!(report.ledger.external.value().abs() > 1e-3, "{:?}", report.ledger);
    let scene = scene.method(stepped(0.005)).build().unwrap();
    let mut whole = Simulation::new(&scene).unwrap();
    whole.advance_to(0.4).unwrap();
    let snapshot = whole.snapshot();
    let mut resumed = Simulation::new(&scene).unwrap();
    resumed.restore(&snapshot).unwrap();
    for simulation in [&mut whole, &mut resumed] {
        simulation.advance_to(0.9).unwrap();
    }
    assert_eq!(whole.frame(), resumed.frame());
}
