//! Impacts: when they happen, that bounces accumulate to rest, and that no body passes through another.

use crate::support::{accurate, ball, brick, elastic, floor, run};
use polhode::contact::Shape;
use polhode::scene::{Crowding, Method};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, Scene, Simulation, SimulationError};

/// Case IM-05: a ball whose bounces accumulate comes to rest at the exact time, and its tenth impact is at the time
/// that the geometric series gives.
#[test]
fn bouncing_ball_comes_to_rest_at_its_exact_time() {
    for (e, rest, tenth) in
        [(0.8, 4.063_712_768_871_578, 3.578_892_951_020_438), (0.5, 1.354_570_922_957_192_7, 1.352_807_158_734_592_2)]
    {
        let scene = Scene::builder("bounce")
            .method(accurate())
            .duration_s(5.0)
            .body(floor().material(elastic(e)))
            .body(ball("ball", 1.0, 0.1, DVec3::new(0.0, 0.0, 1.1), DVec3::ZERO).material(elastic(e)))
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
        assert!((impacts[9].t_s / tenth - 1.0).abs() < 1e-12, "{}", impacts[9].t_s);
        let rests: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Rest).collect();
        assert_eq!(rests.len(), 1);
        assert!((rests[0].t_s / rest - 1.0).abs() < 1e-9, "{}", rests[0].t_s);
        assert!(report.bodies[1].state.velocity.is_zero());
        assert!(report.ledger.closure_relative() < 1e-12);
    }
}

/// A ball bounces a few micrometres high, half a metre from the origin. Its position is rounded to 1e-11 of that
/// height, and its bounces are exact to 2e-12 all the same. (With impacts found only to the rounding of positions, the
/// apex was wrong by 1.1e-11 at e = 0.5 and by 1.1e-9 at e = 0.4.)
#[test]
fn low_bounces_do_not_feel_the_rounding_of_positions() {
    let (gravity, radius) = (9.81, 0.5);
    for (e, height) in [(0.5_f64, 1.0), (0.5, 1.3), (0.5, 0.7), (0.4, 1.0), (0.4, 1.3), (0.4, 0.7)] {
        let scene = Scene::builder("bounce")
            .duration_s(2.0)
            .body(floor().material(elastic(e)))
            .body(ball("ball", 1.0, radius, DVec3::Z * (height + radius), DVec3::ZERO).material(elastic(e)))
            .build()
            .unwrap();
        let (_, recorder) = run(&scene, Effects::Planned);
        let impacts: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
        let up = impacts[9].impulse * e / (1.0 + e);
        let apex = up * up / (2.0 * gravity);
        let error = apex / (e.powi(20) * height) - 1.0;
        assert!(error.abs() < 2e-12, "e = {e}, {height} m: {error:e}");
    }
}

/// If time no longer advances and the settings exclude time steps, the run ends with an error that names time and
/// place. Here a ball bounces between two plates. The longest step is some hours, so that a time of 0.2 s counts as no
/// advance.
#[test]
fn a_run_that_makes_no_progress_says_where() {
    let down = UnitVector::new(-DVec3::Z).unwrap();
    let ceiling = Body::fixed("ceiling").geometry(Shape::half_space(down).into());
    let scene = Scene::builder("rattle")
        .method(Method { step_s: Some(1e4), crowding: Some(Crowding::Error), ..accurate() })
        .duration_s(10.0)
        .body(floor().material(elastic(1.0)))
        .body(ceiling.pose(Pose::from_translation(DVec3::Z * 0.22)).material(elastic(1.0)))
        .body(ball("ball", 1.0, 0.1, DVec3::Z * 0.11, DVec3::Z * 100.0).material(elastic(1.0)))
        .build()
        .unwrap();
    let error = Simulation::new(&scene).unwrap().run().unwrap_err();
    let SimulationError::NoProgress { t_s: t, steps, advanced_s, body_b, .. } = &error else { panic!("{error}") };
    assert_eq!((*steps, body_b.as_str()), (256, "ball"));
    assert!(*advanced_s < 1.0 && (t - advanced_s).abs() < 1e-3, "{error}");
    assert!(error.to_string().contains("no progress"), "{error}");
}

/// A plank stands with one end on another one, and its other end falls at 100 m/s. Within an eighth of a step it would
/// pass through, and the nearest surface would be the far side. The penetration is found because the two were apart at
/// the start of the step.
#[test]
fn a_plank_that_stands_on_another_with_one_end_does_not_swing_through_it() {
    let (length, thickness, tilt, spin) = (10.0, 0.02, 0.008, 10.0);
    let lower = Body::fixed("lower")
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(12.0, 1.0, thickness)).unwrap()))
        .pose(Pose::from_translation(DVec3::Z * (-0.5 * thickness)));
    let rotation = Rotation::from_rotation_vector(DVec3::Y * -tilt);
    let from_end = rotation.rotate(DVec3::new(0.5 * length, 0.0, 0.5 * thickness));
    let angular = DVec3::Y * spin;
    let upper = brick("upper", DVec3::new(length, 1.0, thickness), DVec3::ZERO)
        .pose(Pose::new(rotation, from_end - DVec3::X * (0.5 * length)))
        .velocity(Velocity::new(angular.cross(from_end), angular));
    let scene = Scene::builder("planks").method(accurate()).duration_s(0.05).body(lower).body(upper).build().unwrap();
    let (_, recorder) = run(&scene, Effects::Planned);
    for (t, bodies) in recorder.times_s.iter().zip(&recorder.samples) {
        let lowest =
            [-0.5, 0.5].map(|end| bodies[1].pose.transform_point(DVec3::new(end * length, 0.0, -0.5 * thickness)).z);
        assert!(lowest.into_iter().all(|z| z > -1e-11), "{t} s: {lowest:?}");
    }
}

/// A box slides over the floor of a room at 1000 m/s, and a wall of the same body stops it, although within an eighth
/// of a step the box travels farther than wall and box are thick.
#[test]
fn a_box_that_slides_on_a_floor_is_stopped_by_a_wall_of_the_same_body() {
    let slab =
        |size: DVec3, center: DVec3| Shape::cuboid(size).unwrap().placed(&Pose::from_translation(center)).unwrap();
    let floor = slab(DVec3::new(60.0, 2.0, 1.0), DVec3::new(0.0, 0.0, -0.5));
    let wall = slab(DVec3::new(0.1, 2.0, 3.0), DVec3::new(5.6, 0.0, 1.5));
    let room = Body::fixed("room").geometry(Geometry::Shape(Shape::compound(vec![floor, wall]).unwrap()));
    let slider = brick("slider", DVec3::new(0.5, 0.5, 0.5), DVec3::Z * 0.25)
        .velocity(Velocity::new(DVec3::X * 1000.0, DVec3::ZERO));
    let scene = Scene::builder("room").method(accurate()).duration_s(0.05).body(room).body(slider).build().unwrap();
    let (_, recorder) = run(&scene, Effects::Planned);
    for (t, bodies) in recorder.times_s.iter().zip(&recorder.samples) {
        let reach = bodies[1].pose.translation.x + 0.25;
        assert!(reach < 5.55 + 1e-11, "{t} s: {reach} m");
    }
}

/// A heavy ball strikes a ball in a corner so slowly that this one returns to floor and wall before it has left the
/// touch distance. Such bounces are resolved without restitution, at once, which drives the small ball against the
/// heavy one again. That impact is resolved at the same instant too, until no contact approaches. (Without this the
/// balls collided two hundred times within a millisecond, each time with an overlap.)
#[test]
fn bounces_ended_at_one_instant_leave_no_contact_approaching() {
    for (e, heavy, speed) in [(0.1, 100.0, 2e-6), (0.05, 30.0, 1e-6), (0.2, 1000.0, 3e-6)] {
        let (small, large) = (0.1_f64, 0.25);
        let apart = ((small + large) * (small + large) - 2.0 * (large - small) * (large - small)).sqrt() + 1e-7;
        let wall = Body::fixed("wall").geometry(Shape::half_space(UnitVector::new(DVec3::X).unwrap()).into());
        let scene = Scene::builder("corner")
            .gravity(DVec3::new(-5.0, 0.0, -9.81))
            .duration_s(1.0)
            .body(floor().material(elastic(e)))
            .body(wall.material(elastic(e)))
            .body(ball("heavy", heavy, small, DVec3::new(small, 0.0, small), DVec3::ZERO).material(elastic(e)))
            .body(ball("light", 1.0, large, DVec3::new(large, -apart, large), DVec3::Y * speed).material(elastic(e)))
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let impacts = recorder.events.iter().filter(|event| event.kind == EventKind::Impact);
        let times: Vec<f64> = impacts.map(|event| event.t_s).collect();
        assert!(times.len() > 4 && times.iter().all(|&t| t == times[0]), "e = {e}: {times:?}");
        assert!(report.certificate.max_penetration_m < 2e-15, "e = {e}: {:?}", report.certificate);
        assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    }
}

/// An elastic ball bounces for ever. Where its bounces are lower than what a stretch of crowded events may be wrong by,
/// they are not followed one by one: the run says that its events crowded, and the ball is where it was to that height.
/// Bounces that can be seen are all followed, and keep their energy.
#[test]
fn elastic_bounces_too_low_to_be_seen_are_not_followed_one_by_one() {
    let radius = 0.05;
    let dropped_from = |height: f64| {
        let ground = floor().material(elastic(1.0));
        let falling = ball("ball", 1.0, radius, DVec3::Z * (radius + height), DVec3::ZERO).material(elastic(1.0));
        let builder = Scene::builder("bounces").method(accurate()).duration_s(0.5);
        run(&builder.body(ground).body(falling).build().unwrap(), Effects::Planned)
    };
    // Some 20,000 bounces of 2.9e-5 s.
    let unseen = 1e-9;
    let (report, recorder) = dropped_from(unseen);
    assert!(recorder.events.len() < 1000, "{}", recorder.events.len());
    assert!(!report.crowded.is_empty());
    let height = report.bodies[1].state.pose.translation.z - radius;
    assert!((-1e-15..=unseen).contains(&height), "{height}");
    let (report, recorder) = dropped_from(1e-3);
    assert!(recorder.events.len() > 15, "{}", recorder.events.len());
    assert!((report.energy.final_j - report.energy.initial_j).abs() < 1e-12 * 9.81, "{:?}", report.energy);
}

/// Two balls fly against a wall. With a restitution below `3 - 2 sqrt 2` they strike it and each other infinitely often
/// in a finite time, and stay (Bernu and Mazighi 1990); above it they come back after finitely many impacts. (With the
/// last impacts struck together by the law of simultaneous ones, they left with a tenth of what speed was left.)
#[test]
fn an_inelastic_collapse_leaves_no_velocity() {
    for (e, impacts) in [(0.1, None), (0.05, None), (0.16, None), (0.18, Some(17)), (0.2, Some(9)), (0.3, Some(5))] {
        let at = |x: f64| DVec3::new(x, 0.0, 0.0);
        let wall = Body::fixed("wall").geometry(Shape::half_space(-UnitVector::X).into());
        let scene = Scene::builder("collapse")
            .method(accurate())
            .gravity(DVec3::ZERO)
            .duration_s(20.0)
            .body(wall.material(elastic(e)))
            .body(ball("first", 1.0, 0.5, at(-1.0), DVec3::X).material(elastic(e)))
            .body(ball("second", 1.0, 0.5, at(-2.5), DVec3::X).material(elastic(e)))
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let speeds = [1, 2].map(|body: usize| report.bodies[body].state.velocity.linear.length());
        let struck = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).count();
        match impacts {
            None => assert!(speeds.iter().all(|&speed| speed < 1e-8), "{e}: {speeds:?}"),
            Some(impacts) => assert_eq!((struck, speeds.iter().all(|&speed| speed > 1e-8)), (impacts, true), "{e}"),
        }
    }
}
