//! Results do not depend on the origin, on the directions of the axes, or on the scale of length.

use crate::support::{accurate, ball, brick, elastic, floor, run};
use polhode::contact::Shape;
use polhode::scene::{Material, Method};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Decision, Effect, Effects, EventKind, RunReport, Scene};

/// A bounce with e = 1/2 at another scale of length: all times scale with the square root of the length, that of rest
/// included.
#[test]
fn accumulating_bounce_scales_with_the_root_of_length() {
    for scale in [1e-4, 1.0, 1e4_f64] {
        let time = scale.sqrt();
        let scene = Scene::builder("scaled bounce")
            .method(Method { step_s: Some(0.01 * time), ..accurate() })
            .duration_s(2.0 * time)
            .output_interval_s(0.1 * time)
            .body(floor().material(elastic(0.5)))
            .body(ball("ball", 1.0, 0.1 * scale, DVec3::Z * (1.1 * scale), DVec3::ZERO).material(elastic(0.5)))
            .build()
            .unwrap();
        let (_, recorder) = run(&scene, Effects::Planned);
        let rest = recorder.events.iter().find(|event| event.kind == EventKind::Rest).unwrap();
        assert!((rest.t_s / time / 1.354_570_922_957_192_7 - 1.0).abs() < 1e-9, "{scale}: {}", rest.t_s);
    }
}

/// A tilted box lands and tumbles on. In a world that has been rotated and displaced it does the same, to the rounding
/// of poses far from the origin.
#[test]
fn tilted_landing_follows_a_turned_and_moved_world() {
    let landing = |world: Pose| {
        let place = |body: Body, pose: Pose| body.pose(world * pose).material(elastic(0.5));
        let up = world.rotation.rotate(DVec3::Z);
        let ground = Body::fixed("floor").geometry(Shape::half_space(UnitVector::new(up).unwrap()).into());
        let tilt = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, 0.5, 0.1)), DVec3::Z);
        let scene = Scene::builder("landing")
            .method(accurate())
            .gravity(up * -9.81)
            .duration_s(0.6)
            .body(place(ground, Pose::IDENTITY).pose(Pose::from_translation(world.translation)))
            .body(place(brick("box", DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO), tilt))
            .build()
            .unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let sample = report.bodies[1].state;
        (world.inverse_transform_point(sample.pose.translation), world.rotation.inverse_rotate(sample.velocity.angular))
    };
    let home = landing(Pose::IDENTITY);
    let turn = Rotation::from_wxyz([1.0, 2.0, 3.0, 4.0].map(|c: f64| c / 30.0_f64.sqrt())).unwrap();
    let turned = landing(Pose::new(turn, DVec3::ZERO));
    assert!((turned.0 - home.0).length() < 1e-12 && (turned.1 - home.1).length() < 1e-11, "{turned:?} {home:?}");
    let moved = landing(Pose::from_translation(DVec3::new(1e6, -2e6, 0.0)));
    assert!((moved.0 - home.0).length() < 1e-8 && (moved.1 - home.1).length() < 1e-8, "{moved:?} {home:?}");
}

/// Skipping bodies at rest and computing every effect give the same bits, while a box falls, rattles and comes to rest.
/// The box is tipped about none of its own axes, so that its motion is in no plane.
#[test]
fn all_effects_give_the_same_bits_as_the_plan() {
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.1, 0.4, 0.2)), DVec3::Z);
    let (planned, all) = rattle(pose);
    assert_eq!(planned.bodies, all.bodies);
    assert!(planned.bodies[1].state.velocity.is_zero(), "{:?}", planned.bodies[1]);
    assert!(planned.ledger.closure_relative() < 1e-12 && planned.ledger.momentum.closure_relative() < 1e-12);
}

/// A box that is tipped about one of its axes lands, rattles and comes to rest in a plane. Planar motion, with three
/// velocity coordinates, agrees with the motion in space, with six, in any plane; the box never leaves the plane.
#[test]
fn planar_motion_is_the_motion_in_space() {
    let tipped = Rotation::from_rotation_vector(DVec3::Y * 0.4);
    for turn in [Rotation::IDENTITY, Rotation::from_rotation_vector(DVec3::Z * 0.7)] {
        let (planned, all) = rattle(Pose::new(turn * tipped, DVec3::Z));
        let is_planar = |report: &RunReport| {
            let planar = report.plan.effects.iter().find(|e| e.effect == Effect::PlanarMotion);
            planar.is_some_and(|e| e.decision == Decision::On)
        };
        assert!(is_planar(&planned) && !is_planar(&all));
        let (a, b) = (planned.bodies[1].state, all.bodies[1].state);
        assert!((a.pose.translation - b.pose.translation).length() < 1e-12, "{a:?} {b:?}");
        assert!(a.pose.rotation.angle_to(b.pose.rotation) < 1e-12, "{a:?} {b:?}");
        let out_of_plane = turn.rotate(DVec3::Y).dot(a.pose.translation);
        assert!(out_of_plane.abs() < 1e-15, "{out_of_plane:e}");
        assert_eq!(planned.events, all.events);
    }
}

/// Runs a box on a floor from `pose`, with the planned effects and with all.
fn rattle(pose: Pose) -> (RunReport, RunReport) {
    let scene = Scene::builder("rattle")
        .method(accurate())
        .duration_s(3.0)
        .body(floor().material(elastic(0.4)))
        .body(brick("box", DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO).pose(pose).material(elastic(0.4)))
        .build()
        .unwrap();
    (run(&scene, Effects::Planned).0, run(&scene, Effects::All).0)
}

/// A box that falls on the floor and rattles keeps the promises of its run up to 10 km from the origin, with friction
/// and without: what separations far away are rounded by is no penetration.
#[test]
fn a_box_far_from_the_origin_keeps_what_its_run_promises() {
    for away in [3e2, 1e3, 3e3, 1e4] {
        for (friction, tilt) in [(0.0, 0.1), (0.0, 0.3), (0.5, 0.1), (0.5, 0.3)] {
            let material =
                Material::new("box and floor").with_friction(friction).unwrap().with_restitution(0.3).unwrap();
            let turn = Rotation::from_rotation_vector(DVec3::new(tilt, 0.2, 0.1));
            let body =
                brick("box", DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO).pose(Pose::new(turn, DVec3::new(away, 0.0, 0.5)));
            let body = body.velocity(Velocity::new(DVec3::new(0.5, 0.2, 0.0), DVec3::new(1.0, 0.0, 2.0)));
            let scene =
                Scene::builder("far away").method(accurate()).duration_s(1.0).body(floor().material(material.clone()));
            // `run` asks for a run that is not degraded.
            run(&scene.body(body.material(material)).build().unwrap(), Effects::Planned);
        }
    }
}
