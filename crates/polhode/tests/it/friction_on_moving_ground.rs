//! Friction between bodies that move: conveyors, turntables, planks, and balls on a box that is pulled.

use crate::checks::{assert_closes, heavy_brick, max_position_error};
use crate::friction::rough;
use crate::support::{accurate, ball, brick, floor, run};
use polhode::contact::Shape;
use polhode::scene::{Force, Frame, Material, PairRule, PrescribedMotion, Signal};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, Scene, Simulation};

const G: f64 = 9.81;

/// A half-space below z = 0 that moves at this velocity.
fn moving_ground(velocity: Velocity, friction: f64) -> Body {
    Body::kinematic("ground", PrescribedMotion::constant_velocity(velocity).unwrap())
        .geometry(Shape::half_space(UnitVector::Z).into())
        .material(rough(friction))
}

/// A box of 2 kg, 0.1 m high.
fn flat(center: DVec3, velocity: DVec3) -> Body {
    heavy_brick("box", 2.0, DVec3::new(0.3, 0.2, 0.1), center + DVec3::Z * 0.05)
        .velocity(Velocity::new(velocity, DVec3::ZERO))
        .material(rough(0.4))
}

/// A box set on a conveyor is taken along at `mu g` until it has its speed, and then stands on it.
#[test]
fn conveyor_takes_a_box_along() {
    let (belt, start) = (DVec3::new(1.1, 0.5, 0.0), DVec3::new(-0.3, 0.2, 0.0));
    let slip = start - belt;
    let time = slip.length() / (0.4 * G);
    let scene = Scene::builder("conveyor")
        .method(accurate())
        .body(flat(DVec3::ZERO, start))
        .body(moving_ground(Velocity::new(belt, DVec3::ZERO), 0.4))
        .duration_s(2.0)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let worst = max_position_error(&recorder, 0, |t| {
        let slipping = t.min(time);
        belt * t + slip * slipping - slip.normalize() * (0.2 * G * slipping * slipping) + DVec3::Z * 0.05
    });
    assert!(worst < 1e-12, "{worst:e}");
    assert!((report.bodies[0].state.velocity.linear - belt).length() < 1e-13);
    // The slip lost is heat; the belt's work is the rest of what the box gained.
    let heat = 0.5 * 2.0 * slip.length_squared();
    assert!((report.ledger.friction.value() / heat - 1.0).abs() < 1e-11, "{} {heat}", report.ledger.friction.value());
    assert_closes(&report);
}

/// On a turntable a box is carried round where `mu g` is at least `w^2 r`, and slips where it is not.
#[test]
fn turntable_carries_a_box_round() {
    let rate = 2.5_f64;
    let critical = 0.4 * G / (rate * rate);
    for (radius, stays) in [(critical * (1.0 - 1e-6), true), (critical * 1.01, false)] {
        let center = DVec3::X * radius;
        let spin = DVec3::Z * rate;
        let body = flat(center, spin.cross(center)).velocity(Velocity::new(spin.cross(center), spin));
        let scene = Scene::builder("turntable")
            .method(accurate())
            .body(body)
            .body(moving_ground(Velocity::new(DVec3::ZERO, spin), 0.4))
            .duration_s(2.0)
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let worst = max_position_error(&recorder, 0, |t| {
            DVec3::new((rate * t).cos(), (rate * t).sin(), 0.0) * radius + DVec3::Z * 0.05
        });
        assert_eq!(worst < 1e-11, stays, "{worst:e}");
        assert_closes(&report);
    }
}

/// A ball that rolls on a turntable moves on a circle at `w k/(1 + k)`.
#[test]
fn ball_on_a_turntable_moves_on_a_circle() {
    let (rate, radius) = (7.0, 0.1);
    for (k, place, linear) in [(0.4, DVec3::X, DVec3::Y * 0.5), (2.0 / 3.0, DVec3::Y * 0.3, DVec3::new(-0.2, 0.4, 0.0))]
    {
        let inertia = Inertia::from_diagonal(DVec3::splat(k * radius * radius)).unwrap();
        let over = linear - (DVec3::Z * rate).cross(place);
        let body = Body::movable("ball", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
            .geometry(Shape::sphere(radius).unwrap().into())
            .pose(Pose::from_translation(place + DVec3::Z * radius))
            .velocity(Velocity::new(linear, DVec3::Z.cross(over) / radius))
            .material(rough(1.0));
        let scene = Scene::builder("turntable")
            .method(accurate())
            .body(body)
            .body(moving_ground(Velocity::new(DVec3::ZERO, DVec3::Z * rate), 1.0))
            .duration_s(5.0)
            .build()
            .unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let orbit = rate * k / (1.0 + k);
        let center = place + DVec3::Z.cross(linear) / orbit;
        let worst = max_position_error(&recorder, 0, |t| {
            let (sin, cos) = (orbit * t).sin_cos();
            let arm = place - center;
            center + arm * cos + DVec3::Z.cross(arm) * sin + DVec3::Z * radius
        });
        assert!(worst < 1e-11, "{worst:e}");
        assert_closes(&report);
    }
}

/// A block on a plank that slides freely: both end with one speed, after `M v^2/(2 mu g (m + M))`.
#[test]
fn block_on_a_plank_ends_with_its_speed() {
    let (light, heavy, friction, speed) = (1.0, 2.0, 0.3, 3.0);
    let block = heavy_brick("block", light, DVec3::new(0.2, 0.2, 0.1), DVec3::Z * 0.15)
        .velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO))
        .material(rough(friction));
    let plank = heavy_brick("plank", heavy, DVec3::new(6.0, 1.0, 0.1), DVec3::Z * 0.05).material(rough(friction));
    let scene = Scene::builder("plank").method(accurate()).body(block).body(plank).body(floor()).duration_s(1.5);
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    let [block, plank] = [report.bodies[0].state, report.bodies[1].state];
    let common = light * speed / (light + heavy);
    assert!((block.velocity.linear - DVec3::X * common).length() < 1e-13);
    assert!((plank.velocity.linear - DVec3::X * common).length() < 1e-13);
    let slipped = heavy * speed * speed / (2.0 * friction * G * (light + heavy));
    assert!((block.pose.translation.x - plank.pose.translation.x - slipped).abs() < 1e-12);
    let heat = 0.5 * light * speed * speed - 0.5 * (light + heavy) * common * common;
    assert!((report.ledger.friction.value() / heat - 1.0).abs() < 1e-12);
    assert_closes(&report);
}

/// SimBenchmark's rolling: a box with balls on it is pulled over the ground; its mean squared velocity error (best
/// published 3.9e-27 and 4.1e-7 m^2/s^2) along an axis and across.
#[test]
fn box_under_rolling_balls_is_pulled() {
    for direction in [DVec3::Y, DVec3::new(0.5, 0.75_f64.sqrt(), 0.0)] {
        let (box_mass, ball_mass, count, pull) = (10.0, 1.0, 9.0, 150.0);
        let named = |name: &str| Material::new(name);
        let pair = |a: &str, b: &str, friction: f64| {
            PairRule::new([a.to_owned(), b.to_owned()]).with_friction(friction).unwrap()
        };
        let size = DVec3::new(20.0, 20.0, 1.0);
        let force = Force::Applied {
            body: BodyId::new(0),
            force: direction * pull,
            torque: DVec3::ZERO,
            frame: Frame::World,
            point: None,
            signal: Signal::ONE,
        };
        let mut builder = Scene::builder("rolling")
            .method(accurate())
            .body(heavy_brick("box", box_mass, size, DVec3::Z * 0.5).material(named("box")))
            .body(floor().material(named("ground")))
            .pair_rule(pair("box", "ground", 0.4))
            .pair_rule(pair("box", "ball", 0.8))
            .force(force);
        for k in 0..9 {
            let center = DVec3::new(f64::from(4 * (k % 3) - 4), f64::from(4 * (k / 3) - 4), 1.5);
            let body = ball(&format!("ball {k}"), ball_mass, 0.5, center, DVec3::ZERO);
            builder = builder.body(body.material(named("ball")));
        }
        let scene = builder.build().unwrap();
        let ground = 0.4 * (box_mass + count * ball_mass) * G;
        let on_balls = (pull - ground) / box_mass / (3.5 / ball_mass + count / box_mass);
        let (box_rate, ball_rate) = ((pull - ground - count * on_balls) / box_mass, on_balls / ball_mass);
        let mut simulation = Simulation::new(&scene).unwrap();
        let mut sum = 0.0;
        for step in 1..=50 {
            let t = 0.01 * f64::from(step);
            simulation.advance_to(t).unwrap();
            let bodies = simulation.bodies();
            sum += (bodies[0].velocity.linear - direction * (box_rate * t)).length_squared();
            sum += (bodies[2].velocity.linear - direction * (ball_rate * t)).length_squared();
        }
        assert!(sum / 50.0 < 1e-24, "{:e}", sum / 50.0);
    }
}

/// A rough box that a wall pushes at constant speed, which friction may lift or press down by up to `mu_w P`: the push
/// `P` and what the floor bears are not unique, but with `P = mu N` friction takes between `mu W s/(1 + mu_w mu)` and
/// `mu W s/(1 - mu_w mu)` over the way s. The ledger once had 0.10 J of 0.39 at least, and less than none: forces of
/// least norm let the wall lift the box by more than its friction bears.
#[test]
fn a_wall_that_pushes_a_rough_box_lifts_it_by_no_more_than_its_friction() {
    let (speed, duration, edge) = (0.5, 0.5, 0.1);
    for heading in [0.0, 0.7] {
        for (floor_friction, wall_friction) in [(0.3, 0.5), (0.5, 0.5), (2.0, 0.4), (3.0, 0.5), (0.8, 1.1)] {
            let along = Rotation::from_rotation_vector(DVec3::Z * heading);
            let ahead = along.rotate(DVec3::X);
            let motion = PrescribedMotion::constant_velocity(Velocity::new(ahead * speed, DVec3::ZERO)).unwrap();
            let named = |name: &str| Material::new(name).with_friction(floor_friction).unwrap();
            let pushed = ["wall", "box"].map(str::to_owned);
            let start = Pose::new(along, DVec3::Z * (0.5 * edge));
            let behind = Pose::new(along, ahead * -edge + DVec3::Z * (0.51 * edge));
            let scene = Scene::builder("pushed")
                .method(accurate())
                .duration_s(duration)
                .body(brick("box", DVec3::splat(edge), DVec3::ZERO).pose(start).material(named("box")))
                .body(
                    Body::kinematic("wall", motion)
                        .geometry(Shape::cuboid(DVec3::splat(edge)).unwrap().into())
                        .pose(behind)
                        .material(named("wall")),
                )
                .body(floor().material(named("floor")))
                .pair_rule(PairRule::new(pushed).with_friction(wall_friction).unwrap())
                .build()
                .unwrap();
            let (report, _) = run(&scene, Effects::Planned);
            let way = ahead * (speed * duration);
            assert!((report.bodies[0].state.pose.translation - start.translation - way).length() < 1e-12);
            let alone = floor_friction * G * speed * duration;
            let product: f64 = floor_friction * wall_friction;
            let most = if product < 1.0 { alone / (1.0 - product) } else { f64::INFINITY };
            let taken = report.ledger.friction.value();
            let rounding = 1e-10 * alone;
            assert!(taken >= alone / (1.0 + product) - rounding && taken <= most + rounding, "{taken} of {alone}");
            assert_closes(&report);
        }
    }
}
