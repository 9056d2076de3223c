//! Friction in the tier `accurate`, against closed forms of Coulomb's law: boxes that slide, stop and stick, forces
//! that exceed static friction, balls that come to roll; what friction takes is booked, and directions of axes do not
//! matter.

use crate::checks::{assert_closes, heavy_brick, max_position_error};
use crate::snapshots;
use crate::support::{accurate, ball, brick, run};
use polhode::contact::Shape;
use polhode::scene::{Force, Frame, Material, Method, Signal};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, SplitMix64, UnitVector, Velocity};
use polhode::{Body, BodyId, Decision, Effect, Effects, Recorder, RunReport, Scene, SceneBuilder, Simulation};
use std::f64::consts::{FRAC_PI_2, TAU};

const G: f64 = 9.81;

/// A material of this coefficient, static and kinetic.
pub(crate) fn rough(friction: f64) -> Material {
    Material::new(format!("mu = {friction}")).with_friction(friction).unwrap()
}

/// A material of these two coefficients.
pub(crate) fn sticky(static_friction: f64, kinetic: f64) -> Material {
    Material::new("sticky").with_friction(kinetic).unwrap().with_static_friction(static_friction).unwrap()
}

/// Turns x into downhill, y into level, z into the normal of a slope.
pub(crate) fn slope(angle: f64, azimuth: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::Z * azimuth) * Rotation::from_rotation_vector(DVec3::Y * angle)
}

/// One body and the ground: the body's pose and velocity are given in the directions of the slope.
pub(crate) fn on_slope(slope: Rotation, body: Body, material: &Material) -> SceneBuilder {
    let (pose, velocity) = (*body.initial_pose(), *body.initial_velocity());
    let body = body
        .pose(Pose::new(slope * pose.rotation, slope.rotate(pose.translation)))
        .velocity(Velocity::new(slope.rotate(velocity.linear), slope.rotate(velocity.angular)))
        .material(material.clone());
    let normal = UnitVector::new(slope.rotate(DVec3::Z)).unwrap();
    let ground = Body::fixed("ground").geometry(Shape::half_space(normal).into()).material(material.clone());
    Scene::builder("on a slope").method(accurate()).body(body).body(ground)
}

/// A box of 1 kg that lies on the plane z = 0, turned by `heading`, with a velocity.
pub(crate) fn lying(size: DVec3, heading: f64, velocity: DVec3) -> Body {
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::Z * heading), DVec3::Z * (0.5 * size.z));
    brick("box", size, DVec3::ZERO).pose(pose).velocity(Velocity::new(velocity, DVec3::ZERO))
}

/// A ball of 1 kg whose moment about any axis is `k m r^2`, on the plane z = 0.
pub(crate) fn round(k: f64, radius: f64, velocity: Velocity) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::splat(k * radius * radius)).unwrap();
    Body::movable("ball", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
        .geometry(Shape::sphere(radius).unwrap().into())
        .pose(Pose::from_translation(DVec3::Z * radius))
        .velocity(velocity)
}

/// A push on the first body.
fn push(force: DVec3, signal: Signal) -> Force {
    Force::Applied { body: BodyId::new(0), force, torque: DVec3::ZERO, frame: Frame::World, point: None, signal }
}

/// The times at which steps of a run ended at events, s.
fn events_of(scene: &Scene) -> Vec<f64> {
    let mut simulation = Simulation::new(scene).unwrap();
    let mut found = Vec::new();
    while simulation.time() < scene.duration_s() {
        let outcome = simulation.step().unwrap();
        if outcome.is_event() {
            found.push(outcome.t_s);
        }
    }
    found
}

/// A box stops after `v/(mu g)` and `v^2/(2 mu g)` on a straight line, whatever the direction of its slip and of its
/// edges; what friction took is all that the box had.
#[test]
fn box_stops_at_the_same_distance_in_any_direction() {
    let mut random = SplitMix64::new(1);
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    for _ in 0..20 {
        let (speed, friction, angle) = (between(0.1, 5.0), between(0.05, 1.0), between(0.0, TAU));
        let along = DVec3::new(angle.cos(), angle.sin(), 0.0);
        let size = DVec3::new(between(0.4, 1.0), between(0.4, 1.0), between(0.02, 0.2));
        let (time, distance) = (speed / (friction * G), speed * speed / (2.0 * friction * G));
        let scene = on_slope(Rotation::IDENTITY, lying(size, between(0.0, TAU), along * speed), &rough(friction))
            .duration_s(1.5 * time)
            .output_interval_s(0.1 * time)
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let z = 0.5 * size.z;
        let worst = max_position_error(&recorder, 0, |t| {
            let t = t.min(time);
            along * (speed * t - 0.5 * friction * G * t * t) + DVec3::Z * z
        });
        assert!(worst < 1e-12 * distance.max(1.0), "{worst:e}");
        assert!(report.bodies[0].state.velocity.is_zero());
        let stop = events_of(&scene)[0];
        assert!((stop / time - 1.0).abs() < 1e-12, "{stop} {time}");
        assert!((report.ledger.friction.value() / (0.5 * speed * speed) - 1.0).abs() < 1e-12);
        assert_closes(&report);
    }
}

/// The plan says that friction is simulated, and why.
#[test]
fn plan_knows_friction() {
    for (friction, expected) in [(0.0, Decision::Off), (0.3, Decision::On)] {
        let scene =
            on_slope(Rotation::IDENTITY, lying(DVec3::ONE, 0.0, DVec3::ZERO), &rough(friction)).build().unwrap();
        let simulation = Simulation::new(&scene).unwrap();
        let friction = simulation.plan().effects.iter().find(|effect| effect.effect == Effect::Friction).unwrap();
        assert_eq!(friction.decision, expected, "{}", friction.fact);
    }
}

/// A billionth above the tangent of the slope a box stays for ever, a billionth below it slides with `g sin(a) 1e-9`.
#[test]
fn a_billionth_of_friction_tells_stick_from_slide() {
    for (angle, azimuth) in [(20.0_f64.to_radians(), 0.0), (0.7, 1.1), (0.1, 4.0)] {
        let turn = slope(angle, azimuth);
        let moved = |friction: f64| {
            let scene = on_slope(turn, lying(DVec3::new(1.0, 1.0, 0.2), 0.4, DVec3::ZERO), &rough(friction));
            let (report, recorder) = run(&scene.duration_s(10.0).build().unwrap(), Effects::Planned);
            assert_closes(&report);
            let (first, last) = (recorder.samples[0][0].pose, recorder.samples.last().unwrap()[0].pose);
            turn.inverse_rotate(last.translation - first.translation)
        };
        assert_eq!(moved(angle.tan() * (1.0 + 1e-9)), DVec3::ZERO);
        let slid = moved(angle.tan() * (1.0 - 1e-9));
        let expected = 0.5 * G * angle.sin() * 1e-9 * 100.0;
        assert!((slid.x / expected - 1.0).abs() < 1e-5 && slid.y.abs() < 1e-4 * expected, "{slid} {expected}");
    }
}

/// A box that slides ever so slowly keeps to its motion: rounding across its slip does not turn the friction.
#[test]
fn slow_slide_lasts() {
    let angle = 20.0_f64.to_radians();
    let friction = rough(angle.tan() * (1.0 - 1e-9));
    let method = Method { step_s: Some(1.0), ..accurate() };
    let scene = on_slope(slope(angle, 0.0), lying(DVec3::new(1.0, 0.5, 0.5), 0.0, DVec3::ZERO), &friction)
        .method(method)
        .duration_s(1000.0)
        .output_interval_s(1.0)
        .build()
        .unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    let speed = report.bodies[0].state.velocity.linear.length();
    assert!((speed / (G * angle.sin() * 1e-6) - 1.0).abs() < 1e-5, "{speed:e}");
    assert_closes(&report);
}

/// The incline of Rigid IPC: at 26.565 degrees friction 0.5 holds, and 0.49 does not.
#[test]
fn incline_of_26_565_degrees() {
    let angle = 26.565_f64.to_radians();
    let slid = |friction: f64| {
        let scene = on_slope(slope(angle, 0.0), lying(DVec3::new(1.0, 1.0, 0.5), 0.0, DVec3::ZERO), &rough(friction));
        let (_, recorder) = run(&scene.duration_s(2.0).build().unwrap(), Effects::Planned);
        (recorder.samples.last().unwrap()[0].pose.translation - recorder.samples[0][0].pose.translation).length()
    };
    assert_eq!(slid(0.5), 0.0);
    let acceleration = G * (angle.sin() - 0.49 * angle.cos());
    assert!((0.5 * slid(0.49) / acceleration - 1.0).abs() < 1e-10, "{}", slid(0.49));
}

/// A box that came to rest on a slope has not moved after ten hours.
#[test]
fn box_rests_on_a_slope_for_ten_hours() {
    let turn = slope(20.0_f64.to_radians(), 0.3);
    let start = lying(DVec3::new(1.0, 0.5, 0.4), 0.2, DVec3::new(0.2, 0.3, 0.0));
    let scene = on_slope(turn, start, &rough(0.5)).duration_s(36_000.0).output_interval_s(10.0).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let (settled, last) = (recorder.samples[1][0].pose, recorder.samples.last().unwrap()[0].pose);
    assert_eq!(settled, last);
    assert_closes(&report);
}

/// A force that grows evenly moves a box when it exceeds static friction, and then `x = b (t - t0)^3/(6 m)`, faster at
/// once where kinetic friction is less.
#[test]
fn growing_force_moves_a_box_when_it_exceeds_static_friction() {
    let (mass, growth) = (2.0, 5.0);
    let direction = DVec3::new(0.8, 0.6, 0.0);
    for (at_rest, sliding) in [(0.4, 0.4), (0.5, 0.3)] {
        let start = at_rest * mass * G / growth;
        let body = heavy_brick("box", mass, DVec3::new(0.5, 0.4, 0.1), DVec3::Z * 0.05);
        let scene = on_slope(Rotation::IDENTITY, body, &sticky(at_rest, sliding))
            .force(push(direction * growth, Signal::polynomial(vec![0.0, 1.0]).unwrap()))
            .duration_s(start + 1.0)
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let worst = max_position_error(&recorder, 0, |t| {
            let t = (t - start).max(0.0);
            let x = growth / (6.0 * mass) * t.powi(3) + 0.5 * (at_rest - sliding) * G * t * t;
            direction * x + DVec3::Z * 0.05
        });
        assert!(worst < 1e-9, "{worst:e}");
        let begins = events_of(&scene);
        assert!(begins.iter().any(|t| (t - start).abs() < 1e-9), "{begins:?} {start}");
        let travelled = growth / (6.0 * mass) + 0.5 * (at_rest - sliding) * G;
        assert!((report.ledger.friction.value() / (sliding * mass * G * travelled) - 1.0).abs() < 1e-9);
        assert_closes(&report);
    }
}

/// With static friction above kinetic friction a box sticks until the larger is exceeded, slides by the smaller one,
/// and once it has stopped it sticks again by the larger.
#[test]
fn box_that_has_stopped_sticks_by_static_friction_again() {
    let (at_rest, sliding) = (0.5, 0.2);
    // In units of the weight: above static friction at 1 s, none from 1.2 s on, then between the two for ever.
    let pull = Signal::table(vec![(0.0, 0.0), (1.0, 0.6), (1.2, 0.0), (3.0, 0.0), (4.0, 0.45)]).unwrap();
    let scene =
        on_slope(Rotation::IDENTITY, lying(DVec3::new(0.6, 0.5, 0.1), 0.3, DVec3::ZERO), &sticky(at_rest, sliding))
            .force(push(DVec3::X * G, pull))
            .duration_s(8.0)
            .build()
            .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let place = |t: f64| recorder.samples[(t / 0.01).round() as usize][0].pose.translation.x;
    let start = at_rest / 0.6;
    assert!(place(start - 0.02).abs() < 1e-15);
    assert!(place(start + 0.02) > 0.0);
    // Speeds at the corners of the pull: its mean less kinetic friction, until that has taken all.
    let to_top = (0.5 * (at_rest + 0.6) - sliding) * G * (1.0 - start);
    let to_none = to_top + (0.3 - sliding) * G * 0.2;
    let stop = 1.2 + to_none / (sliding * G);
    let events = events_of(&scene);
    assert!(events.iter().any(|t| (t - stop).abs() < 1e-9), "{events:?} {stop}");
    assert!((place(stop + 0.02) - place(8.0)).abs() < 1e-13, "it sticks");
    assert_closes(&report);
}

/// Balls and cylinders that slide without spin come to roll after `v/(mu g (1 + 1/k))` with `v/(1 + k)`, and roll on.
#[test]
fn round_bodies_slip_then_roll() {
    let (speed, friction, radius) = (3.0, 0.2, 0.25);
    for k in [0.4, 2.0 / 3.0, 0.1] {
        let body = round(k, radius, Velocity::new(DVec3::X * speed, DVec3::ZERO));
        check_slip_to_roll(body, k, (speed, friction, radius));
    }
    let across = 0.25 * radius * radius + 0.4 * 0.4 / 12.0;
    let inertia = Inertia::from_diagonal(DVec3::new(across, across, 0.5 * radius * radius)).unwrap();
    let cylinder = Body::movable("cylinder", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
        .geometry(Shape::cylinder(radius, 0.4).unwrap().into())
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::X * FRAC_PI_2), DVec3::Z * radius))
        .velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO));
    check_slip_to_roll(cylinder, 0.5, (speed, friction, radius));
}

fn check_slip_to_roll(body: Body, k: f64, (speed, friction, radius): (f64, f64, f64)) {
    let time = speed / (friction * G * (1.0 + 1.0 / k));
    let rolling = speed / (1.0 + k);
    let scene =
        on_slope(Rotation::IDENTITY, body, &rough(friction)).duration_s(3.0).output_interval_s(0.05).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let worst = max_position_error(&recorder, 0, |t| {
        let slipping = t.min(time);
        let x = speed * slipping - 0.5 * friction * G * slipping * slipping + rolling * (t - slipping);
        DVec3::new(x, 0.0, radius)
    });
    assert!(worst < 1e-12, "k = {k}: {worst:e}");
    assert!(events_of(&scene).iter().any(|t| (t - time).abs() < 1e-12), "k = {k}");
    let spin = report.bodies[0].state.velocity.angular;
    assert!((spin - DVec3::Y * (rolling / radius)).length() < 1e-12);
    assert!((report.ledger.friction.value() / (0.5 * speed * speed * k / (1.0 + k)) - 1.0).abs() < 1e-12);
    assert_closes(&report);
}

/// Down a slope a ball rolls by `g sin(a)/(1 + k)` where friction is at least `tan(a) k/(1 + k)`; else it slips.
#[test]
fn balls_roll_or_slip_down_a_slope() {
    let (angle, radius) = (0.5_f64, 0.2);
    let turn = slope(angle, 2.0);
    for k in [0.4, 2.0 / 3.0] {
        let least = angle.tan() * k / (1.0 + k);
        for (friction, linear, angular) in [
            (least * (1.0 + 1e-9), G * angle.sin() / (1.0 + k), G * angle.sin() / (1.0 + k)),
            (0.5 * least, G * (angle.sin() - 0.5 * least * angle.cos()), 0.5 * least * G * angle.cos() / k),
        ] {
            let scene = on_slope(turn, round(k, radius, Velocity::ZERO), &rough(friction)).build().unwrap();
            let (report, recorder) = run(&scene, Effects::Planned);
            let start = turn.rotate(DVec3::Z * radius);
            let worst = max_position_error(&recorder, 0, |t| start + turn.rotate(DVec3::X * (0.5 * linear * t * t)));
            assert!(worst < 1e-11, "{worst:e}");
            let spin = turn.inverse_rotate(report.bodies[0].state.velocity.angular) * radius / scene.duration_s();
            assert!((spin - DVec3::Y * angular).length() < 1e-11, "{spin} {angular}");
            assert_closes(&report);
        }
    }
}

/// A billiard ball with draw and side spin moves on a parabola until it rolls, then straight on; spin about the
/// vertical does not matter.
#[test]
fn billiard_ball_moves_on_a_parabola() {
    let (radius, friction) = (0.0286, 0.2);
    let (linear, angular) = (DVec3::X * 2.0, DVec3::new(30.0, -60.0, 50.0));
    let slip = linear + angular.cross(DVec3::Z * -radius);
    let (time, along) = (slip.length() / (3.5 * friction * G), slip.normalize());
    let scene = on_slope(Rotation::IDENTITY, round(0.4, radius, Velocity::new(linear, angular)), &rough(friction))
        .duration_s(1.0)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let worst = max_position_error(&recorder, 0, |t| {
        let slipping = t.min(time);
        let rolling = linear - along * (friction * G * time);
        let curve = linear * slipping - along * (0.5 * friction * G * slipping * slipping);
        curve + rolling * (t - slipping) + DVec3::Z * radius
    });
    assert!(worst < 1e-12, "{worst:e}");
    assert!((report.bodies[0].state.velocity.angular.z - 50.0).abs() < 1e-12);
    assert_closes(&report);
}

/// A tall box on a slope steeper than its sides allow begins to tip about its lower edge, without slipping.
#[test]
fn tall_box_tips_over_its_edge() {
    let (width, height) = (0.3, 1.0);
    let tips = |angle: f64| {
        let turn = slope(angle, 0.0);
        let body = lying(DVec3::new(width, 0.4, height), 0.0, DVec3::ZERO);
        let scene = on_slope(turn, body, &rough(2.0)).duration_s(0.3).build().unwrap();
        let first = Simulation::new(&scene).unwrap().accelerations().unwrap()[0].angular;
        let (report, recorder) = run(&scene, Effects::Planned);
        assert_closes(&report);
        // The lower edge stays where it is.
        let edge = DVec3::new(0.5 * width, 0.0, -0.5 * height);
        let (from, to) = (recorder.samples[0][0].pose, recorder.samples.last().unwrap()[0].pose);
        assert!((to.transform_point(edge) - from.transform_point(edge)).length() < 1e-12, "{angle}");
        assert!(report.ledger.friction.value() == 0.0, "no slip, no loss");
        turn.inverse_rotate(first).y
    };
    let critical = (width / height).atan();
    assert!(tips(critical - 1e-6).abs() < 1e-12);
    let angle: f64 = critical + 0.1;
    let expected = 1.5 * G * (height * angle.sin() - width * angle.cos()) / (width * width + height * height);
    assert!((tips(angle) / expected - 1.0).abs() < 1e-12);
}

/// A tripod slides down a slope and spins.
fn tripod(world: Pose, mirror: f64) -> (RunReport, Recorder) {
    let feet = (0..3).map(|k| {
        let angle = 0.3 + TAU * f64::from(k) / 3.0;
        DVec3::new(0.4 * angle.cos(), mirror * 0.4 * angle.sin(), -0.1)
    });
    let inertia = Inertia::from_diagonal(DVec3::new(0.08, 0.09, 0.12)).unwrap();
    let body = Body::movable("tripod", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
        .geometry(Shape::points(feet.collect()).unwrap().into());
    let turn = slope(0.25, mirror * 0.4);
    let place = |vector: DVec3| world.rotation.rotate(turn.rotate(vector));
    let start = Pose::new(world.rotation * turn, world.transform_point(turn.rotate(DVec3::Z * 0.1)));
    let velocity = Velocity::new(place(DVec3::new(0.5, mirror * 0.8, 0.0)), place(DVec3::Z * (mirror * 3.0)));
    let normal = UnitVector::new(place(DVec3::Z)).unwrap();
    let ground = Body::fixed("ground").geometry(Shape::half_space(normal).into());
    let scene = Scene::builder("tripod")
        .method(accurate())
        .gravity(world.rotation.rotate(DVec3::Z * -G))
        .duration_s(0.5)
        .body(body.pose(start).velocity(velocity).material(rough(0.4)))
        .body(ground.pose(Pose::from_translation(world.translation)).material(rough(0.4)))
        .build()
        .unwrap();
    run(&scene, Effects::Planned)
}

/// The same motion in a world that is turned, moved or mirrored.
#[test]
fn sliding_and_spinning_follows_a_turned_moved_and_mirrored_world() {
    let home = tripod(Pose::IDENTITY, 1.0).0.bodies[0].state;
    assert!(home.pose.translation.length() > 0.1 && home.velocity.angular.length() > 0.1, "{home:?}");
    let turn = Rotation::from_wxyz([1.0, 2.0, 3.0, 4.0].map(|c: f64| c / 30.0_f64.sqrt())).unwrap();
    for (world, tolerance) in [
        (Pose::new(turn, DVec3::ZERO), 1e-12),
        (Pose::from_translation(DVec3::new(1e3, -2e3, 5e2)), 1e-9),
        (Pose::new(turn, DVec3::new(3.0, -2.0, 1.0)), 1e-11),
    ] {
        let found = tripod(world, 1.0).0.bodies[0].state;
        let place = world.inverse_transform_point(found.pose.translation);
        let spin = world.rotation.inverse_rotate(found.velocity.angular);
        assert!((place - home.pose.translation).length() < tolerance, "{place} {home:?}");
        assert!((spin - home.velocity.angular).length() < 10.0 * tolerance, "{spin} {home:?}");
    }
    let mirrored = tripod(Pose::IDENTITY, -1.0).0.bodies[0].state;
    let (flip, spin) = (DVec3::new(1.0, -1.0, 1.0), DVec3::new(-1.0, 1.0, -1.0));
    assert!((mirrored.pose.translation * flip - home.pose.translation).length() < 1e-13);
    assert!((mirrored.velocity.linear * flip - home.velocity.linear).length() < 1e-12);
    assert!((mirrored.velocity.angular * spin - home.velocity.angular).length() < 1e-12);
}

/// The ground gives a box that slides, stops and sticks the impulse of its weight and takes what momentum it had.
#[test]
fn ground_takes_the_momentum_of_a_sliding_box() {
    let mass = 2.5;
    let body = heavy_brick("box", mass, DVec3::new(0.5, 0.4, 0.1), DVec3::Z * 0.05)
        .velocity(Velocity::new(DVec3::new(1.2, -0.7, 0.0), DVec3::ZERO));
    let scene = on_slope(Rotation::IDENTITY, body, &rough(0.3)).duration_s(1.5).build().unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let given = report.ledger.momentum.support.value().linear;
    let expected = DVec3::new(-1.2, 0.7, G * 1.5) * mass;
    assert!((given - expected).length() < 1e-12 * expected.length(), "{given} {expected}");
    assert_closes(&report);
}

/// Runs of sliding, sticking and rolling go on from a snapshot with the same bits.
#[test]
fn runs_with_friction_go_on_with_the_same_bits() {
    let boxes =
        on_slope(slope(0.3, 0.4), lying(DVec3::new(0.6, 0.5, 0.2), 0.3, DVec3::new(0.2, 0.9, 0.0)), &rough(0.5));
    let pulled = on_slope(Rotation::IDENTITY, lying(DVec3::new(0.6, 0.5, 0.2), 0.3, DVec3::ZERO), &sticky(0.5, 0.3))
        .force(push(DVec3::new(4.0, 3.0, 0.0), Signal::sinusoid(2.0, 0.8, 0.0).unwrap()));
    let shot = on_slope(
        Rotation::IDENTITY,
        round(0.4, 0.1, Velocity::new(DVec3::X, DVec3::new(5.0, -10.0, 20.0))),
        &rough(0.3),
    );
    for builder in [boxes, pulled, shot] {
        snapshots::check_restored_runs(
            &builder.duration_s(1.5).output_interval_s(0.013).build().unwrap(),
            Effects::Planned,
        );
    }
}

/// What friction is between two bodies does not depend on their order in the scene; a body without a material has none.
#[test]
fn a_body_without_a_material_slips_freely() {
    let body = ball("ball", 1.0, 0.1, DVec3::Z * 0.1, DVec3::X);
    let ground = Body::fixed("ground").geometry(Shape::half_space(UnitVector::Z).into());
    let scene = Scene::builder("slippery").method(accurate()).body(ground).body(body.material(rough(0.5)));
    let (report, _) = run(&scene.duration_s(1.0).build().unwrap(), Effects::Planned);
    assert!((report.bodies[1].state.velocity.linear - DVec3::X).length() < 1e-14);
    assert!(report.bodies[1].state.velocity.angular.length() == 0.0);
}
