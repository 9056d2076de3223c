//! Pivots as constraints: each adds three bilateral rows to the constrained motion. By default the motion of a pivoted
//! body that nothing can touch is reduced to a rotation about its pivot; with all effects on, its pivot stays a
//! constraint. The tests compare the rows with that reduction and with closed forms, and combine them with contacts.

use crate::checks::{assert_closes, by, heavy_brick, numerical_relative};
use crate::support::{accurate, ball, elastic, floor, run};
use polhode::contact::Shape;
use polhode::dynamics::integrator::Method as Integrator;
use polhode::scene::Method;
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Decision, Effect, Effects, EventKind, Recorder, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;
const PIVOT: DVec3 = DVec3::new(0.3, -0.2, 1.1);

/// A top of mass 0.9 with its centre of mass 0.25 above the point it stands on, tilted and spinning.
fn top(moments: DVec3, spin: DVec3) -> Body {
    let properties =
        MassProperties::new(Mass::new(0.9).unwrap(), DVec3::Z * 0.25, Inertia::from_diagonal(moments).unwrap());
    let turn = Rotation::from_rotation_vector(DVec3::new(0.3, 0.4, 0.1));
    Body::movable("top", properties)
        .pose(Pose::new(turn, PIVOT))
        .pivot(PIVOT)
        .velocity(Velocity::new(DVec3::ZERO, turn.rotate(spin)))
}

fn tops() -> [(&'static str, Body); 4] {
    let turn = Rotation::from_rotation_vector(DVec3::Y * 2.0);
    let pendulum = heavy_brick("pendulum", 1.6, DVec3::new(0.1, 0.2, 0.9), DVec3::ZERO)
        .pose(Pose::new(turn, PIVOT - turn.rotate(DVec3::Z * 0.4)))
        .pivot(PIVOT);
    [
        ("Lagrange top", top(DVec3::new(0.02, 0.02, 0.013), DVec3::Z * 60.0)),
        ("asymmetric top", top(DVec3::new(0.02, 0.025, 0.013), DVec3::new(1.0, 0.5, 30.0))),
        ("slow top", top(DVec3::new(0.02, 0.025, 0.013), DVec3::new(0.2, 0.1, 2.0))),
        ("pendulum", pendulum),
    ]
}

fn largest_difference(a: &Recorder, b: &Recorder) -> (f64, f64) {
    assert_eq!(a.times_s, b.times_s);
    let rows = a.samples.iter().flatten().zip(b.samples.iter().flatten());
    rows.fold((0.0, 0.0), |(place, speed): (f64, f64), (a, b)| {
        let apart = (a.pose.translation - b.pose.translation).length() + a.pose.rotation.angle_to(b.pose.rotation);
        let faster =
            (a.velocity.linear - b.velocity.linear).length() + (a.velocity.angular - b.velocity.angular).length();
        (place.max(apart), speed.max(faster))
    })
}

/// Tops whose pivots are rows move as those reduced to a rotation: to 1e-12 in position and in relative angular
/// velocity, over a second.
#[test]
fn rows_move_tops_as_the_reduction_does() {
    for (name, body) in tops() {
        let method = Method { tolerance: Some(1e-13), ..by(Integrator::Dop853, 0.01) };
        let scene = Scene::builder(name).method(method).duration_s(1.0).body(body).build().unwrap();
        let (reduced, turning) = run(&scene, Effects::Planned);
        let (report, rows) = run(&scene, Effects::All);
        let (place, speed) = largest_difference(&turning, &rows);
        let fastest = rows.samples.iter().map(|row| row[0].velocity.angular.length()).fold(1.0, f64::max);
        assert!(place < 1e-12 && speed < 1e-12 * fastest, "{name}: {place:e} {speed:e}");
        let point = scene.bodies()[0].initial_pose().inverse_transform_point(PIVOT);
        let drift = rows.samples.iter().map(|row| (row[0].pose.transform_point(point) - PIVOT).length());
        assert!(drift.fold(0.0, f64::max) < 1e-13);
        assert!(numerical_relative(&report) < 1e-13, "{:e}", numerical_relative(&report));
        assert_closes(&report);
        let of = |report: &polhode::RunReport| {
            report.plan.effects.iter().find(|effect| effect.effect == Effect::Joints).unwrap().clone()
        };
        assert_eq!((of(&reduced).decision, of(&report).decision), (Decision::Off, Decision::On));
        assert!(of(&reduced).fact.contains("reduced to rotation"), "{}", of(&reduced).fact);
    }
}

/// At the default tolerance a top whose pivot is a constraint stays within 2e-11 of the reduced motion.
#[test]
fn rows_are_as_exact_as_the_tolerance_asks() {
    for (name, body) in tops() {
        let scene =
            Scene::builder(name).method(by(Integrator::Dop853, 0.01)).duration_s(1.0).body(body).build().unwrap();
        let (place, _) = largest_difference(&run(&scene, Effects::Planned).1, &run(&scene, Effects::All).1);
        assert!(place < 2e-11, "{name}: {place:e}");
    }
}

/// RK4, which computes the forces of the pivot at every stage, is of order four for a top too.
#[test]
fn rk4_moves_a_top_on_rows_at_order_four() {
    let (_, body) = tops().into_iter().nth(1).unwrap();
    let scene = |method| Scene::builder("top").method(method).duration_s(0.4).body(body.clone()).build().unwrap();
    let precise = Method { tolerance: Some(1e-13), ..by(Integrator::Dop853, 0.01) };
    let exact = run(&scene(precise), Effects::Planned).0.bodies[0].state.pose;
    let errors = [0.008, 0.004, 0.002].map(|step| {
        let (report, _) = run(&scene(by(Integrator::Rk4, step)), Effects::All);
        assert_closes(&report);
        report.bodies[0].state.pose.rotation.angle_to(exact.rotation)
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.6..4.7).contains(&order), "{order} {errors:?}");
    }
}

/// The brick of the tests in `pivots.rs`, hanging at rest from `PIVOT`.
fn rod(turn: Rotation) -> Body {
    heavy_brick("rod", MASS, SIZE, DVec3::ZERO).pose(Pose::new(turn, PIVOT - turn.rotate(DVec3::Z * ARM))).pivot(PIVOT)
}

const MASS: f64 = 1.6;
const SIZE: DVec3 = DVec3::new(0.1, 0.2, 0.9);
const ARM: f64 = 0.4;

fn swing_moment() -> f64 {
    MASS * ((SIZE.x * SIZE.x + SIZE.z * SIZE.z) / 12.0 + ARM * ARM)
}

fn weightless(name: &str, duration: f64) -> SceneBuilder {
    Scene::builder(name).method(accurate()).gravity(DVec3::ZERO).duration_s(duration)
}

/// A ball strikes a hanging rod at depth d below its pivot with the impulse J. The pivot gives the rod the impulse
/// `J (m a d/I - 1)`, where a is the depth of the centre of mass: zero at the centre of percussion, against J above it,
/// along J below it.
#[test]
fn the_pivot_bears_what_the_centre_of_percussion_says() {
    let (mass, speed, e, radius) = (0.3, 2.0, 0.5, 0.05);
    let moment = swing_moment();
    for depth in [0.3, moment / (MASS * ARM), 0.75] {
        let place = PIVOT + DVec3::new(0.5 * SIZE.x + radius, 0.0, -depth);
        let scene = weightless("percussion", 1e-6)
            .body(rod(Rotation::IDENTITY).material(elastic(e)))
            .body(ball("ball", mass, radius, place, DVec3::NEG_X * speed).material(elastic(e)))
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let impulse = (1.0 + e) * speed / (1.0 / mass + depth * depth / moment);
        assert_eq!(recorder.events.len(), 1, "the pivot's impulse is no event of a contact");
        assert!((recorder.events[0].impulse / impulse - 1.0).abs() < 1e-12);
        let given = report.ledger.momentum.support.value().linear;
        let expected = impulse * (1.0 - MASS * ARM * depth / moment);
        assert!((given.x - expected).abs() < 1e-11, "{depth}: {given} {expected}");
        assert!((report.bodies[0].state.velocity.angular.y - impulse * depth / moment).abs() < 1e-11);
        assert_closes(&report);
    }
}

/// A rod that swings against a post at depth d with the rate w rebounds with `e w`; the impulse is `(1 + e) w I/d`. A
/// post that moves at v strikes a hanging rod, which then has the rate `(1 + e) v/d`.
#[test]
fn a_rod_rebounds_from_a_post() {
    let (w, e, depth, radius, moment) = (1.3, 0.4, 0.6, 0.1, swing_moment());
    let place = PIVOT + DVec3::new(-0.5 * SIZE.x - radius, 0.0, -depth);
    let shape = || Shape::sphere(radius).unwrap();
    let post = Body::fixed("post").geometry(shape().into()).pose(Pose::from_translation(place)).material(elastic(e));
    // A turn about +y carries what hangs towards -x.
    let rod_at = |angle: f64| rod(Rotation::from_rotation_vector(DVec3::Y * angle)).material(elastic(e));
    let swinging = rod_at(-0.3).velocity(Velocity::new(DVec3::ZERO, DVec3::Y * w));
    let (report, recorder) = run(&weightless("post", 0.4).body(post).body(swinging).build().unwrap(), Effects::Planned);
    let struck: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Impact).collect();
    assert_eq!(struck.len(), 1);
    assert!((struck[0].t_s - 0.3 / w).abs() < 1e-11, "{}", struck[0].t_s);
    assert!((struck[0].impulse - (1.0 + e) * w * moment / depth).abs() < 1e-11, "{}", struck[0].impulse);
    let after = report.bodies[1].state;
    assert!((after.velocity.angular + DVec3::Y * (e * w)).length() < 1e-11, "{after:?}");
    assert!((after.pose.transform_point(DVec3::Z * ARM) - PIVOT).length() < 1e-14);
    assert_closes(&report);
    let motion = polhode::scene::PrescribedMotion::constant_velocity(Velocity::new(DVec3::X * 0.7, DVec3::ZERO));
    let pusher = Body::kinematic("pusher", motion.unwrap()).geometry(shape().into()).material(elastic(e));
    let pusher = pusher.pose(Pose::from_translation(place - DVec3::X * 0.07));
    let scene = weightless("pusher", 0.11).body(pusher).body(rod_at(0.0)).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!((recorder.events[0].t_s - 0.1).abs() < 1e-12);
    let expected = DVec3::NEG_Y * ((1.0 + e) * 0.7 / depth);
    assert!((report.bodies[1].state.velocity.angular - expected).length() < 1e-11, "{:?}", report.bodies[1]);
    assert_closes(&report);
}

/// A plank rests on a pivot and on a post at distance s from it, with a ball on it. The post bears `N = (m a + M x)
/// g/s`, with a and x the distances of the centre of mass and of the ball from the pivot. The pivot bears the rest, and
/// pulls down if the post is near it. Nothing moves.
#[test]
fn a_plank_rests_on_a_pivot_and_a_post() {
    let (size, mass, weight, radius) = (DVec3::new(2.0, 0.3, 0.1), 3.0, 1.2, 0.1);
    for post_at in [1.5, 0.6] {
        let plank = heavy_brick("plank", mass, size, PIVOT + DVec3::X).pivot(PIVOT);
        let below = PIVOT + DVec3::new(post_at, 0.0, -0.5 * size.z - radius);
        let post = Body::fixed("post").geometry(Shape::sphere(radius).unwrap().into());
        let above = PIVOT + DVec3::new(0.3, 0.0, 0.5 * size.z + radius);
        let scene = Scene::builder("plank")
            .method(accurate())
            .duration_s(1.0)
            .body(post.pose(Pose::from_translation(below)))
            .body(plank)
            .body(ball("ball", weight, radius, above, DVec3::ZERO))
            .build()
            .unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.5).unwrap();
        let forces: Vec<f64> = simulation.contacts().iter().map(|contact| contact.normal_force_n).collect();
        let expected = [(mass + 0.3 * weight) * G / post_at, weight * G];
        assert_eq!(forces.len(), 2);
        for (force, expected) in forces.iter().zip(expected) {
            assert!((force / expected - 1.0).abs() < 1e-12, "{forces:?} {expected}");
        }
        let pivots = simulation.pivots();
        let weight_borne = DVec3::Z * ((mass + weight) * G - expected[0]);
        assert!((pivots[0].force_n - weight_borne).length() < 1e-11, "{pivots:?} {weight_borne}");
        let report = simulation.run().unwrap();
        assert!(
            report.bodies.iter().all(|polhode::ReportedBody { state: body, .. }| body.velocity.is_zero()),
            "{:?}",
            report.bodies
        );
        assert_eq!(report.bodies[1].state.pose, *scene.bodies()[1].initial_pose());
        let borne = report.ledger.momentum.support.value();
        assert!((borne.linear - DVec3::Z * ((mass + weight) * G)).length() < 1e-11, "{borne:?}");
        assert_closes(&report);
    }
}

/// A rod on a pivot falls over and pushes a box along a smooth floor. While they touch, `(I w^2 + M v^2)/2` is the work
/// of the weight, where v is the speed of the pushing edge and of the box. The default method, fixed steps of the exact
/// integrator and RK4 agree, also on the time when they part.
#[test]
fn a_falling_rod_pushes_a_box() {
    let (tilt, mass, moment) = (0.3_f64, 2.0, swing_moment());
    let low = DVec3::new(0.0, 0.0, 0.6);
    // The edge relative to the pivot, which is 0.4 m below the centre.
    let edge = |angle: f64| Rotation::from_rotation_vector(DVec3::Y * angle).rotate(DVec3::new(0.05, 0.0, 0.85));
    let turn = Rotation::from_rotation_vector(DVec3::Y * tilt);
    let scene = |method| {
        let rod = heavy_brick("rod", MASS, SIZE, DVec3::ZERO).pose(Pose::new(turn, low + turn.rotate(DVec3::Z * ARM)));
        let cube = heavy_brick("box", mass, DVec3::new(1.5, 0.6, 1.8), DVec3::new(edge(tilt).x + 0.75, 0.0, 0.9));
        let scene = Scene::builder("push").method(method).duration_s(0.5).body(floor()).body(rod.pivot(low)).body(cube);
        scene.build().unwrap()
    };
    let (report, recorder) = run(&scene(accurate()), Effects::Planned);
    let parted: Vec<f64> = recorder.events.iter().filter(|e| e.kind == EventKind::ContactEnd).map(|e| e.t_s).collect();
    for (t, row) in recorder.times_s.iter().zip(&recorder.samples) {
        if parted.first().is_some_and(|parted| t >= parted) {
            break;
        }
        let (rod, cube) = (row[1], row[2]);
        let angle = 2.0 * rod.pose.rotation.to_wxyz()[2].atan2(rod.pose.rotation.to_wxyz()[0]);
        let (w, v) = (rod.velocity.angular.y, cube.velocity.linear.x);
        assert!((v - w * edge(angle).z).abs() < 1e-11, "{t}: {v} {w}");
        let given = MASS * G * ARM * (tilt.cos() - angle.cos());
        assert!((0.5 * (moment * w * w + mass * v * v) - given).abs() < 1e-11, "{t}: {given}");
    }
    assert!(recorder.samples.last().unwrap()[2].velocity.linear.x > 0.3);
    assert!(numerical_relative(&report) < 1e-11);
    assert_closes(&report);
    for (method, tolerance) in [(by(Integrator::Exact, 0.01), 1e-6), (by(Integrator::Rk4, 0.005), 1e-6)] {
        let (other, events) = run(&scene(method), Effects::Planned);
        let apart = (other.bodies[2].state.pose.translation - report.bodies[2].state.pose.translation).length();
        assert!(apart < tolerance, "{apart:e}");
        assert_eq!(events.events.len(), recorder.events.len());
        assert_closes(&other);
    }
}

/// Two tops lean against each other with their heads. The contact slides over both while they go round; the energy and
/// the mirror symmetry of the pair are kept.
#[test]
fn two_tops_lean_on_each_other() {
    let (length, radius, lean) = (0.25, 0.1, 0.35_f64);
    let apart = radius + length * lean.sin();
    let top = |name: &str, side: f64| {
        let properties = MassProperties::new(
            Mass::new(0.9).unwrap(),
            DVec3::ZERO,
            Inertia::from_diagonal(DVec3::new(0.005, 0.005, 0.004)).unwrap(),
        );
        let turn = Rotation::from_rotation_vector(DVec3::Y * (-side * lean));
        let foot = DVec3::new(side * apart, 0.0, 0.5);
        Body::movable(name, properties)
            .geometry(Shape::sphere(radius).unwrap().into())
            .pose(Pose::new(turn, foot + turn.rotate(DVec3::Z * length)))
            .pivot(foot)
            .velocity(Velocity::new(DVec3::ZERO, turn.rotate(DVec3::Z * (25.0 * side)) + DVec3::Z * (1.5 * side)))
    };
    let scene = Scene::builder("two tops").method(accurate()).duration_s(0.5);
    let scene = scene.body(top("right", 1.0)).body(top("left", -1.0)).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!(recorder.events.iter().all(|event| event.kind != EventKind::Impact), "{:?}", recorder.events);
    for row in &recorder.samples {
        let (right, left) = (row[0].pose.translation, row[1].pose.translation);
        // Mirror images in the plane x = 0; a reflection reverses a spin.
        assert!((right * DVec3::new(-1.0, 1.0, 1.0) - left).length() < 1e-10, "{right} {left}");
        assert!((right - left).length() > 2.0 * radius - 1e-12);
    }
    assert!((recorder.samples[20][0].pose.translation.y).abs() > 1e-3, "they go round");
    assert!(numerical_relative(&report) < 1e-11, "{:e}", numerical_relative(&report));
    assert_closes(&report);
    let (reduced, _) = run(&scene.with_method(by(Integrator::Exact, 0.001)), Effects::Planned);
    let apart = (reduced.bodies[0].state.pose.translation - report.bodies[0].state.pose.translation).length();
    assert!(apart < 1e-6, "{apart:e}");
}

/// Actions of a program on a body whose pivot is a constraint leave the pivot where it is, and a run restored from a
/// snapshot goes on with the same bits.
#[test]
fn programs_act_on_bodies_that_rows_hold() {
    let scene =
        Scene::builder("acted on").method(accurate()).duration_s(1.0).body(floor()).body(rod(Rotation::IDENTITY));
    let scene = scene.gravity(DVec3::ZERO).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    let id = simulation.body_id("rod").unwrap();
    simulation.advance_to(0.1).unwrap();
    simulation.apply_impulse(id, DVec3::X * 0.5, PIVOT - DVec3::Z * 0.7).unwrap();
    let w = -0.5 * 0.7 / swing_moment();
    let now = simulation.body(id);
    assert!((now.velocity.angular - DVec3::Y * w).length() < 1e-14, "{now:?}");
    assert!((now.velocity.linear + DVec3::X * (w * ARM)).length() < 1e-14, "{now:?}");
    simulation.set_velocity(id, Velocity::new(DVec3::ONE, DVec3::Y * 2.0)).unwrap();
    assert!((simulation.body(id).velocity.linear - DVec3::NEG_X * (2.0 * ARM)).length() < 1e-14);
    let away = Pose::from_translation(PIVOT + DVec3::X);
    assert!(simulation.set_pose(id, away).is_err());
    let turn = Rotation::from_rotation_vector(DVec3::X * 0.2);
    simulation.set_pose(id, Pose::new(turn, PIVOT - turn.rotate(DVec3::Z * ARM))).unwrap();
    simulation.advance_to(0.437).unwrap();
    let snapshot = simulation.snapshot();
    let mut other = Simulation::new(&scene).unwrap();
    other.restore(&snapshot).unwrap();
    let report = simulation.run().unwrap();
    assert_eq!(other.run().unwrap().bodies, report.bodies);
    assert!((report.bodies[1].state.pose.transform_point(DVec3::Z * ARM) - PIVOT).length() < 1e-13);
    assert_closes(&report);
}

/// Boxes that fall onto a seesaw and bounce on it and on the floor, so that events crowd.
pub(crate) fn seesaw() -> SceneBuilder {
    let bouncing = elastic(0.3);
    let seesaw = heavy_brick("seesaw", 2.0, DVec3::new(2.0, 0.4, 0.1), DVec3::Z * 0.3).pivot(DVec3::Z * 0.3);
    let mut scene =
        Scene::builder("seesaw").method(accurate()).duration_s(1.5).body(floor().material(bouncing.clone()));
    scene = scene.body(seesaw.material(bouncing.clone()));
    for (number, x) in [-0.8, -0.5, -0.3, 0.4, 0.7].into_iter().enumerate() {
        let turn = Rotation::from_rotation_vector(DVec3::new(0.1, 0.2 + x, 0.3));
        let place = DVec3::new(x, 0.01 * x, 0.55 + 0.15 * number as f64);
        let cube = heavy_brick(&format!("box {number}"), 0.3, DVec3::new(0.2, 0.15, 0.1), place);
        scene = scene.body(cube.pose(Pose::new(turn, place)).material(bouncing.clone()));
    }
    scene
}

/// At crowded events time steps advance a seesaw, its pivot stays in place, and the ledgers close.
#[test]
fn a_seesaw_goes_through_crowded_events() {
    let (report, recorder) = run(&seesaw().build().unwrap(), Effects::Planned);
    assert!(!report.crowded.is_empty(), "nothing has crowded");
    for row in &recorder.samples {
        assert!((row[1].pose.translation - DVec3::Z * 0.3).length() < 1e-11, "{}", row[1].pose.translation);
    }
    assert_closes(&report);
    assert!(report.energy.final_j <= report.energy.initial_j);
}
