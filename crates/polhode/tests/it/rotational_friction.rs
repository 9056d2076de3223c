//! Friction of rolling and of spinning, against closed forms: balls that roll to a halt, stop spinning, and are held
//! on a slope; in the tier `accurate` to rounding, in time steps to the error of a step.

use crate::checks::assert_closes;
use crate::friction::{on_slope, round, slope};
use crate::snapshots;
use crate::support::{accurate, run};
use polhode::contact::Shape;
use polhode::scene::{Material, Method, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Scene};

const G: f64 = 9.81;

/// Radius of the balls, m, and their moment of inertia over `m R^2`.
const RADIUS: f64 = 0.2;
const K: f64 = 0.4;

/// A material of these frictions of rolling and spinning, m.
fn felt(friction: f64, rolling: f64, spinning: f64) -> Material {
    Material::new("felt").with_friction(friction).unwrap().with_rotational_friction(rolling, spinning).unwrap()
}

fn rolling(speed: f64) -> Body {
    round(K, RADIUS, Velocity::new(DVec3::X * speed, DVec3::Y * (speed / RADIUS)))
}

fn stepped() -> Method {
    Method { tier: Some(Tier::Stepped), ..Method::default() }
}

/// How far the body has moved in the scene, m.
fn path(scene: &Scene) -> (f64, DVec3, Vec<(f64, EventKind)>) {
    let (report, recorder) = run(scene, Effects::Planned);
    // The momentum of a body that never moves has no scale.
    if !report.bodies[0].state.velocity.is_zero() {
        assert_closes(&report);
    }
    let start = scene.bodies()[0].initial_pose().translation;
    let moved = recorder.samples.last().unwrap()[0].pose.translation - start;
    let events = recorder.events.iter().map(|event| (event.t_s, event.kind)).collect();
    (moved.length(), report.bodies[0].state.velocity.angular, events)
}

/// A ball that rolls without slip slows down at `c g / (R (1 + k))` and stays where it halts, after `v^2 / 2a`. What
/// friction took is its energy.
#[test]
fn ball_rolls_to_a_halt() {
    let (speed, friction) = (1.0, 0.01);
    let deceleration = friction * G / (RADIUS * (1.0 + K));
    let (time, distance) = (speed / deceleration, speed * speed / (2.0 * deceleration));
    for (method, tolerance) in [(accurate(), 1e-11), (stepped(), 1e-5)] {
        let exact = method.tier == Some(Tier::Accurate);
        let scene = on_slope(Rotation::IDENTITY, rolling(speed), &felt(0.5, friction, 0.0)).method(method);
        let scene = scene.duration_s(1.2 * time).output_interval_s(0.1).build().unwrap();
        let (report, recorder) = run(&scene, Effects::Planned);
        let moved = recorder.samples.last().unwrap()[0].pose.translation.x;
        assert!((moved / distance - 1.0).abs() < tolerance, "{moved} {distance}");
        assert!(report.bodies[0].state.velocity.is_zero(), "{:?}", report.bodies[0].state);
        assert_closes(&report);
        let lost = report.ledger.friction.value() / (0.5 * (1.0 + K) * speed * speed);
        assert!((lost - 1.0).abs() < tolerance.max(1e-9), "{lost}");
        if exact {
            let rest = recorder.events.iter().find(|event| event.kind == EventKind::Rest).unwrap().t_s;
            assert!((rest / time - 1.0).abs() < 1e-11, "{rest} {time}");
        }
    }
}

/// A ball that spins on the spot stops after `k R^2 w / (c g)`.
#[test]
fn spinning_ball_stops() {
    let (spin, friction) = (20.0, 0.01);
    let time = K * RADIUS * RADIUS * spin / (friction * G);
    for (method, tolerance) in [(accurate(), 1e-11), (stepped(), 1e-3)] {
        let body = round(K, RADIUS, Velocity::new(DVec3::ZERO, DVec3::Z * spin));
        for (share, left) in [(0.5, 0.5), (1.1, 0.0)] {
            let scene = on_slope(Rotation::IDENTITY, body.clone(), &felt(0.5, 0.0, friction)).method(method.clone());
            let (moved, w, _) = path(&scene.duration_s(share * time).build().unwrap());
            assert!((w.z / spin - left).abs() < tolerance && moved < 1e-12, "{w:?} {moved}");
            assert!(left > 0.0 || w == DVec3::ZERO, "{w:?}");
        }
    }
}

/// A ball is held on a slope below `tan a = c / R`, and beyond it rolls down with `(g sin a - c g cos a / R) / (1 +
/// k)`.
#[test]
fn friction_of_rolling_holds_a_ball_on_a_slope() {
    let friction = 0.02;
    let limit = (friction / RADIUS).atan();
    // The first of the time steps, of 1e-3 s, errs by its acceleration times the square of its length.
    for (method, tolerance) in [(accurate(), 1e-11), (stepped(), 1e-6)] {
        for (angle, rolls) in [(limit * (1.0 - 1e-6), false), (limit * 1.5, true)] {
            let body = round(K, RADIUS, Velocity::ZERO);
            let material = felt(0.5, friction, 0.01);
            let scene = on_slope(slope(angle, 0.3), body, &material).method(method.clone());
            let (moved, w, _) = path(&scene.duration_s(0.5).build().unwrap());
            let acceleration = G * (angle.sin() - friction / RADIUS * angle.cos()) / (1.0 + K);
            let expected = if rolls { 0.5 * acceleration * 0.25 } else { 0.0 };
            assert!((moved - expected).abs() < tolerance, "{moved} {expected}");
            assert!(rolls || moved < 1e-12, "{moved}");
            assert!(rolls || w == DVec3::ZERO, "{w:?}");
        }
    }
}

/// A ball that slides without spin begins to roll when its slip has vanished: with the moment of friction of rolling
/// later than without. While it slides, `v' = -mu g` and `k R^2 w' = (mu R - c) g`.
#[test]
fn sliding_ball_begins_to_roll_against_friction_of_rolling() {
    let (speed, mu, friction) = (2.0, 0.2, 0.01);
    let body = round(K, RADIUS, Velocity::new(DVec3::X * speed, DVec3::ZERO));
    let spin_rate = (mu * RADIUS - friction) * G / (K * RADIUS * RADIUS);
    let time = speed / (mu * G + RADIUS * spin_rate);
    let scene = on_slope(Rotation::IDENTITY, body, &felt(mu, friction, 0.0)).duration_s(0.9 * time);
    let (report, _) = run(&scene.clone().build().unwrap(), Effects::Planned);
    let (t, end) = (0.9 * time, report.bodies[0].state.velocity);
    assert!((end.linear.x - (speed - mu * G * t)).abs() < 1e-11, "{end:?}");
    assert!((end.angular.y - spin_rate * t).abs() < 1e-10, "{end:?}");
    let (_, _, events) = path(&scene.duration_s(1.1 * time).build().unwrap());
    let sticks = events.iter().find(|(_, kind)| *kind == EventKind::Stick).unwrap().0;
    assert!((sticks / time - 1.0).abs() < 1e-11, "{sticks} {time}");
}

/// Where friction of rolling is stronger than the moment of sliding friction (`c > mu R`), a ball slides to a halt
/// without turning.
#[test]
fn ball_that_cannot_roll_slides() {
    let (speed, mu) = (1.0, 0.1);
    let body = round(K, RADIUS, Velocity::new(DVec3::X * speed, DVec3::ZERO));
    for (method, tolerance) in [(accurate(), 1e-11), (stepped(), 1e-5)] {
        let scene = on_slope(Rotation::IDENTITY, body.clone(), &felt(mu, 1.1 * mu * RADIUS, 0.0)).method(method);
        let (moved, w, _) = path(&scene.duration_s(1.5).build().unwrap());
        let distance = speed * speed / (2.0 * mu * G);
        assert!((moved / distance - 1.0).abs() < tolerance && w == DVec3::ZERO, "{moved} {distance} {w:?}");
    }
}

/// A run with friction of rolling and spinning goes on from a snapshot with the same bits.
#[test]
fn run_goes_on_with_the_same_bits() {
    let body = round(K, RADIUS, Velocity::new(DVec3::new(2.0, 1.0, 0.0), DVec3::new(3.0, 1.0, 20.0)));
    let scene = on_slope(slope(0.1, 0.3), body, &felt(0.2, 0.01, 0.02)).duration_s(3.0).build().unwrap();
    snapshots::check_restored_runs(&scene, Effects::Planned);
}

/// A ball that bounces while it rolls loses spin: with the normal impulse `p = m (1 + e) w` the moment gives `c p`, and
/// rolling without slip the speed falls by `c p/(m R (1 + k))`. One whose roll the moment can stop is stopped, and does
/// not turn back; one that spins loses `c_s p/(k m R^2)`.
#[test]
fn ball_that_bounces_loses_spin() {
    let (e, drop, friction) = (0.5, 0.8, 0.003);
    let rubber =
        Material::new("rubber").with_friction(0.9).expect("a material").with_restitution(e).expect("a material");
    let rubber = rubber.with_rotational_friction(friction, 2.0 * friction).expect("lengths");
    let impulse = (1.0 + e) * drop;
    let change = friction * impulse / (RADIUS * (1.0 + K));
    let spin_change = 2.0 * friction * impulse / (K * RADIUS * RADIUS);
    for method in [accurate(), stepped()] {
        for (speed, spin) in [(1.0, 2.0), (0.3 * change, 0.5 * spin_change), (-0.4, -1.0), (0.0, 0.0)] {
            let turning = DVec3::new(0.0, speed / RADIUS, spin);
            let body = round(K, RADIUS, Velocity::new(DVec3::new(speed, 0.0, -drop), turning));
            let scene = on_slope(Rotation::IDENTITY, body, &rubber).method(method.clone());
            let scene = scene.gravity(DVec3::ZERO).duration_s(0.01).build().expect("a scene");
            let (report, _) = run(&scene, Effects::Planned);
            let after = report.bodies[0].state.velocity;
            let less = |value: f64, change: f64| value.signum() * (value.abs() - change).max(0.0);
            let (speed_after, spin_after) = (less(speed, change), less(spin, spin_change));
            let expected = DVec3::new(speed_after, 0.0, e * drop);
            assert!((after.linear - expected).length() < 1e-11, "{after:?} {expected}");
            assert!((after.angular - DVec3::new(0.0, speed_after / RADIUS, spin_after)).length() < 1e-10, "{after:?}");
            assert!(report.warnings.is_empty(), "{:?}", report.warnings);
            let lost = report.ledger.friction.value();
            let kinetic = |speed: f64, spin: f64| 0.5 * (1.0 + K) * speed * speed + 0.5 * K * (RADIUS * spin).powi(2);
            let expected = kinetic(speed, spin) - kinetic(speed_after, spin_after);
            assert!((lost - expected).abs() < 1e-11, "{lost} {expected}");
            assert_closes(&report);
        }
    }
}

/// Friction of rolling bears a part of the moment that tips a box which slides flat down a slope: how much, and with it
/// where the slope presses, is not unique, and neither is the spin that follows. The least forces are taken, which are
/// the same wherever the scene is and however it is turned. (Random scene 34.)
#[test]
fn a_box_that_slides_flat_and_resists_rolling_moves_alike_wherever_it_is() {
    let size = DVec3::new(0.059_434_997_329_051_62, 0.089_067_636_575_585_04, 0.052_195_206_400_193_615);
    let properties = polhode::mesh::solid_box(size, Mass::new(0.823_773).unwrap()).unwrap();
    let up = DVec3::new(-0.491_655_963_767_655_25, 0.101_375_950_513_853_24, 0.864_868_388_802_082_9);
    let place = DVec3::new(-0.238_529_255_520_353_84, -0.411_539_070_794_782_97, -0.057_183_918_356_221_36);
    let own = Rotation::from_wxyz([
        0.682_878_548_465_722,
        -0.217_115_823_574_545_04,
        -0.142_923_391_613_781_95,
        0.682_723_283_949_207_2,
    ])
    .unwrap();
    let velocity = DVec3::new(-1.014_108_485_217_147_6, -1.588_416_605_870_588_9, -0.390_308_220_074_768_95);
    let end = |attitude: Rotation, moved: DVec3| {
        let turned = |v: DVec3| attitude.rotate(v);
        let slope = Shape::half_space(UnitVector::new(turned(up)).unwrap());
        let material = felt(0.3, 0.001_490_075, 0.0);
        let sliding = Body::movable("box", properties)
            .geometry(Shape::cuboid(size * 0.5).unwrap().into())
            .pose(Pose::new(attitude * own, moved + turned(place)))
            .velocity(Velocity::new(turned(velocity), DVec3::ZERO))
            .material(material.clone());
        let slope = Body::fixed("slope").geometry(slope.into()).pose(Pose::from_translation(moved));
        let scene = Scene::builder("slides flat").method(accurate()).gravity(turned(DVec3::NEG_Z * 9.81));
        let scene = scene.duration_s(0.1).body(sliding).body(slope.material(material)).build().unwrap();
        let state = run(&scene, Effects::Planned).0.bodies[0].state;
        (attitude.inverse_rotate(state.pose.translation - moved), attitude.inverse_rotate(state.velocity.angular))
    };
    let (place, spin) = end(Rotation::IDENTITY, DVec3::ZERO);
    let others = [(DVec3::ZERO, DVec3::new(3.1, -2.7, 1.3)), (DVec3::Z * 0.7, DVec3::ZERO), (DVec3::X, DVec3::Y)];
    for (attitude, moved) in others {
        let (other, turned) = end(Rotation::from_rotation_vector(attitude), moved);
        assert!((other - place).length() < 1e-10, "{attitude}: {:e} m", (other - place).length());
        assert!((turned - spin).length() < 1e-8, "{attitude}: {:e} rad/s", (turned - spin).length());
    }
}
