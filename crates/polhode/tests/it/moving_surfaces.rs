//! Surfaces that move while their shapes rest: belts take boxes along as a body that moves as a whole does, hold them
//! against a stop, drive vehicles; the ledger counts the work of their drives.

use crate::checks::{assert_closes, heavy_brick, max_position_error};
use crate::friction::rough;
use crate::snapshots;
use crate::support::{accurate, floor, run};
use polhode::contact::Shape;
use polhode::scene::{Method, SceneError, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Effects, Scene, SceneBuilder};

const G: f64 = 9.81;

/// A floor whose surface moves.
fn belt(velocity: DVec3) -> Body {
    floor().surface_velocity(velocity).material(rough(0.4))
}

/// A box of 2 kg, 0.1 m high.
fn flat(velocity: DVec3) -> Body {
    heavy_brick("box", 2.0, DVec3::new(0.3, 0.2, 0.1), DVec3::Z * 0.05)
        .velocity(Velocity::new(velocity, DVec3::ZERO))
        .material(rough(0.4))
}

fn scene(body: Body, belt: Body) -> SceneBuilder {
    Scene::builder("belt").method(accurate()).body(body).body(belt).duration_s(1.5)
}

/// A box is taken along at `mu g` until it has the speed of the belt. What the slip lost is heat; the drive of the belt
/// gives the rest of what the box gained. In every tier.
#[test]
fn belt_takes_a_box_along() {
    let (speed, start) = (DVec3::new(1.1, 0.5, 0.0), DVec3::new(-0.3, 0.2, 0.0));
    let slip = start - speed;
    let time = slip.length() / (0.4 * G);
    let stepped = Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() };
    for (method, tolerance) in [(accurate(), 1e-12), (stepped, 1e-3)] {
        let scene = scene(flat(start), belt(speed)).method(method).build().expect("a scene");
        let (report, recorder) = run(&scene, Effects::Planned);
        let worst = max_position_error(&recorder, 0, |t| {
            let slipping = t.min(time);
            speed * t + slip * slipping - slip.normalize() * (0.2 * G * slipping * slipping) + DVec3::Z * 0.05
        });
        assert!(worst < tolerance, "{worst:e}");
        assert!((report.bodies[0].state.velocity.linear - speed).length() < 0.1 * tolerance);
        let heat = 0.5 * 2.0 * slip.length_squared();
        let lost = report.ledger.friction.value();
        assert!((lost / heat - 1.0).abs() < 10.0 * tolerance, "{lost} {heat}");
        let work = report.ledger.external.value();
        let expected = heat + speed.length_squared() - start.length_squared();
        assert!((work / expected - 1.0).abs() < 10.0 * tolerance, "{work} {expected}");
        assert_closes(&report);
    }
}

/// A box that a wall stops stays where it is while the belt slides under it, which costs `mu m g v` all the time.
#[test]
fn belt_slides_under_a_box_that_is_stopped() {
    let wall = heavy_brick("wall", 1.0, DVec3::new(0.1, 1.0, 1.0), DVec3::new(0.2, 0.0, 0.5));
    let wall = Body::fixed("wall").geometry(wall.shape().expect("a shape").clone()).pose(*wall.initial_pose());
    let scene = scene(flat(DVec3::ZERO), belt(DVec3::X * 0.7)).body(wall).build().expect("a scene");
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!(max_position_error(&recorder, 0, |_| DVec3::Z * 0.05) < 1e-13);
    let heat = 0.4 * 2.0 * G * 0.7 * 1.5;
    assert!((report.ledger.friction.value() / heat - 1.0).abs() < 1e-10, "{}", report.ledger.friction.value());
    assert!((report.ledger.external.value() / heat - 1.0).abs() < 1e-10);
    assert_closes(&report);
}

/// A block with tracks drives off at `mu g` until its tracks no longer slip, and keeps that speed; turned, it drives
/// where its tracks point.
#[test]
fn tracks_drive_a_vehicle() {
    let heading = Rotation::from_rotation_vector(DVec3::Z * 0.8);
    let vehicle = flat(DVec3::ZERO).surface_velocity(DVec3::X * -0.9).pose(Pose::new(heading, DVec3::Z * 0.05));
    let scene = scene(vehicle, floor().material(rough(0.4))).build().expect("a scene");
    let (report, recorder) = run(&scene, Effects::Planned);
    let forward = heading.rotate(DVec3::X);
    let time = 0.9 / (0.4 * G);
    let worst = max_position_error(&recorder, 0, |t| {
        let slipping = t.min(time);
        forward * (0.2 * G * slipping * slipping + 0.9 * (t - slipping)) + DVec3::Z * 0.05
    });
    assert!(worst < 1e-12, "{worst:e}");
    assert_closes(&report);
}

/// A ball set on a belt slips and then rolls: the speed of its centre is that of a ball on a floor that moves as a
/// whole.
#[test]
fn ball_on_a_belt_comes_to_roll() {
    let (radius, k, speed) = (0.1, 0.4, 1.4);
    let inertia = Inertia::from_diagonal(DVec3::splat(k * radius * radius)).expect("an inertia");
    let mass = Mass::new(1.0).expect("a mass");
    let ball = Body::movable("ball", MassProperties::new(mass, DVec3::ZERO, inertia))
        .geometry(Shape::sphere(radius).expect("a ball").into())
        .pose(Pose::from_translation(DVec3::Z * radius))
        .material(rough(0.4));
    let scene = scene(ball, belt(DVec3::X * speed)).build().expect("a scene");
    let (report, _) = run(&scene, Effects::Planned);
    let velocity = report.bodies[0].state.velocity;
    assert!((velocity.linear - DVec3::X * (speed * k / (1.0 + k))).length() < 1e-12, "{velocity:?}");
    assert_closes(&report);
}

/// A velocity that is not finite is refused; a run goes on from a snapshot with the same bits.
#[test]
fn surface_velocities_are_checked_and_kept() {
    for bad in [f64::NAN, f64::INFINITY] {
        let error = scene(flat(DVec3::ZERO), belt(DVec3::X * bad)).build();
        assert!(matches!(error, Err(SceneError::NotFinite { quantity: "its surface velocity", .. })));
    }
    let scene = scene(flat(DVec3::new(0.1, 0.4, 0.0)), belt(DVec3::X * 0.8)).duration_s(0.5).output_interval_s(0.05);
    snapshots::check_restored_runs(&scene.build().expect("a scene"), Effects::Planned);
}
