//! Times of impact with closed forms: head-on shots, falls, grazing, resting contact, invalid input.

use crate::support::{Flight, at, ball, cuboid, floor, yaw};
use polhode_contact::{ImpactError, ImpactSearch, Shape, find_impact, separation, time_of_impact};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, Still, UnitVector, Velocity};

fn shot(from: DVec3, velocity: DVec3) -> Flight {
    Flight::new(Pose::from_translation(from), velocity, DVec3::ZERO)
}

fn time(a: &Shape, motion_a: &dyn Motion, b: &Shape, motion_b: &dyn Motion, t1: f64) -> Option<f64> {
    time_of_impact(a, motion_a, b, motion_b, 0.0, t1, &ImpactSearch::default()).expect("an answer")
}

fn assert_close(found: Option<f64>, expected: f64) {
    let found = found.expect("an impact");
    assert!((found - expected).abs() <= 1e-14 * expected, "{found} {expected}");
}

/// Head-on shots of every pair: the time is distance over speed.
#[test]
fn head_on() {
    let (sphere, cube) = (ball(0.5), cuboid(1.0, 1.0, 1.0));
    let point = Shape::points(vec![DVec3::ZERO]).expect("a point");
    let still = Still(Pose::IDENTITY);
    let fly = |x: f64, v: f64| shot(DVec3::X * x, DVec3::X * v);
    for speed in [1e-3, 1.0, 300.0] {
        assert_close(time(&sphere, &fly(-3.0, speed), &sphere, &still, 1e4), 2.0 / speed);
        assert_close(time(&sphere, &fly(-3.0, speed), &cube, &still, 1e4), 2.0 / speed);
        assert_close(time(&cube, &fly(-3.0, speed), &cube, &still, 1e4), 2.0 / speed);
        assert_close(time(&point, &fly(-3.0, speed), &cube, &still, 1e4), 2.5 / speed);
        assert_close(time(&point, &fly(-3.0, speed), &sphere, &still, 1e4), 2.5 / speed);
        assert_close(time(&sphere, &fly(-3.0, speed), &sphere, &fly(3.0, -speed), 1e4), 2.5 / speed);
    }
    // Corner first: a cube rotated by 45 degrees extends half its diagonal.
    let turned = Flight::new(Pose::new(yaw(std::f64::consts::FRAC_PI_4), DVec3::X * -3.0), DVec3::X, DVec3::ZERO);
    assert_close(time(&cube, &turned, &cube, &still, 10.0), 2.5 - 0.5_f64.sqrt());
}

/// Bodies falling on a floor: `t = sqrt(2 h/g)`; a box that also spins about the vertical has the same time.
#[test]
fn falls() {
    for height in [1e-6, 1e-3, 1.0, 100.0] {
        let mut fall = shot(DVec3::Z * (0.5 + height), DVec3::ZERO);
        fall.acceleration = DVec3::Z * -9.81;
        let expected = (2.0 * height / 9.81_f64).sqrt();
        let still = Still(Pose::IDENTITY);
        // The search ends when the separation is within rounding, 4 epsilons of the lengths it is computed from.
        let slack = 4.0 * f64::EPSILON * (4.0 + height) / (9.81 * expected);
        for (shape, spin) in [(ball(0.5), 0.0), (cuboid(1.0, 1.0, 1.0), 0.0), (cuboid(1.0, 2.0, 1.0), 7.0)] {
            fall.velocity.angular = DVec3::Z * spin;
            let report =
                find_impact(&shape, &fall, &floor(), &still, 0.0, 10.0, &ImpactSearch::default()).expect("answer");
            let found = report.time.expect("an impact");
            assert!((found - expected).abs() <= slack + 1e-14 * expected, "{found} {expected}");
            assert!(report.evaluations < 12, "{}", report.evaluations);
        }
    }
}

/// A box that falls on its corner while it tumbles takes few evaluations.
#[test]
fn tumbling_fall_is_cheap() {
    let mut total = 0;
    for i in 0..50 {
        let angle = 0.1 * f64::from(i);
        let turn = Rotation::from_rotation_vector(DVec3::new(angle, 0.3, -0.2 * angle));
        let mut fall =
            Flight::new(Pose::new(turn, DVec3::Z * 3.0), DVec3::new(1.0, 0.0, 2.0), DVec3::new(3.0, -2.0, 1.0));
        fall.acceleration = DVec3::Z * -9.81;
        let slab = cuboid(20.0, 20.0, 1.0);
        let still = Still(at(0.0, 0.0, -0.5));
        let settings = ImpactSearch::default();
        let report =
            find_impact(&cuboid(1.0, 0.5, 0.25), &fall, &slab, &still, 0.0, 2.0, &settings).expect("an answer");
        assert!(report.time.is_some());
        total += report.evaluations;
    }
    assert!(total < 50 * 12, "{total} evaluations for 50 falls");
}

/// A thrown ball that just reaches a ceiling, just misses it, or grazes a sphere: the search ends with the right
/// result.
#[test]
fn grazing() {
    let ceiling = Shape::half_space(UnitVector::new(DVec3::NEG_Z).expect("down"));
    let height = 1.0_f64;
    for above in [-1e-3, -1e-6, -1e-9, 1e-9, 1e-6, 1e-3] {
        let mut thrown = shot(DVec3::ZERO, DVec3::Z * (2.0 * 9.81 * height).sqrt());
        thrown.acceleration = DVec3::Z * -9.81;
        let ceiling_pose = Still(at(0.0, 0.0, height + 0.25 + above));
        let found = time(&ball(0.25), &thrown, &ceiling, &ceiling_pose, 1.0);
        assert_eq!(found.is_some(), above < 0.0, "{above}: {found:?}");
        let pass = shot(DVec3::new(-3.0, 1.0 + above, 0.0), DVec3::X);
        let passed = time(&ball(0.5), &pass, &ball(0.5), &Still(Pose::IDENTITY), 10.0);
        assert_eq!(passed.is_some(), above < 0.0, "{above}: {passed:?}");
        let slide = shot(DVec3::new(-3.0, 0.0, 1.0 + above), DVec3::X);
        let cube = cuboid(1.0, 1.0, 1.0);
        let slid = time(&cube, &slide, &cube, &Still(Pose::IDENTITY), 10.0);
        assert_eq!(slid.is_some(), above < 0.0, "{above}: {slid:?}");
    }
}

/// Two bodies that fall side by side a nanometre apart stay clear, and the search needs few evaluations although each
/// accelerates with g.
#[test]
fn falling_together() {
    for gap in [1e-9, 1e-6, 1e-3] {
        let mut fall = [shot(DVec3::ZERO, DVec3::X * 3.0), shot(DVec3::Z * (1.0 + gap), DVec3::X * 3.0)];
        for body in &mut fall {
            body.acceleration = DVec3::Z * -9.81;
        }
        let cube = cuboid(1.0, 1.0, 1.0);
        let report =
            find_impact(&cube, &fall[0], &cube, &fall[1], 0.0, 1.0, &ImpactSearch::default()).expect("an answer");
        assert_eq!(report.time, None);
        assert!(report.evaluations < 300, "{gap}: {}", report.evaluations);
    }
}

/// A pair that touches at the start: at rest it has no impact; separating, none until it comes back; approaching, the
/// impact is where it begins to overlap.
#[test]
fn starting_in_touch() {
    let (cube, still) = (cuboid(1.0, 1.0, 1.0), Still(Pose::IDENTITY));
    assert_eq!(time(&cube, &Still(at(0.0, 0.0, 1.0)), &cube, &still, 1.0), None);
    assert_eq!(time(&cube, &shot(DVec3::Z, DVec3::X * 0.1), &cube, &still, 1.0), None);
    let mut bounce = shot(DVec3::Z, DVec3::Z * 4.905);
    assert_eq!(time(&cube, &bounce, &cube, &still, 1.0), None);
    bounce.acceleration = DVec3::Z * -9.81;
    let back = time(&cube, &bounce, &cube, &still, 2.0).expect("it comes back");
    assert!((back - 1.0).abs() < 1e-14);
    let pressed = time(&cube, &shot(DVec3::Z, DVec3::Z * -1.0), &cube, &still, 1.0).expect("it overlaps");
    assert!(pressed < 2e-12, "{pressed}");
    let mut accelerated = shot(DVec3::Z, DVec3::ZERO);
    accelerated.acceleration = DVec3::Z * -2.0;
    let later = time(&cube, &accelerated, &cube, &still, 1.0).expect("it overlaps");
    assert!(later * later < 2e-12, "{later}");
}

/// Motions that are not finite, reversed intervals and exhausted limits are errors, not hangs or panics.
#[test]
fn errors() {
    struct Broken(f64);
    impl Motion for Broken {
        fn pose(&self, _: f64) -> Pose {
            at(self.0, 0.0, 3.0)
        }
        fn velocity(&self, _: f64) -> Velocity {
            Velocity::new(DVec3::splat(f64::NAN), DVec3::ZERO)
        }
        fn bounds(&self, _: f64, _: f64) -> MotionBounds {
            MotionBounds { speed: f64::INFINITY, ..MotionBounds::default() }
        }
    }
    let (cube, still, settings) = (cuboid(1.0, 1.0, 1.0), Still(Pose::IDENTITY), ImpactSearch::default());
    for x in [f64::NAN, f64::INFINITY, 0.0] {
        let result = time_of_impact(&cube, &Broken(x), &cube, &still, 0.0, 1.0, &settings);
        assert!(matches!(result, Err(ImpactError::NotFinite { .. })), "{result:?}");
    }
    for (t0, t1) in [(1.0, 0.0), (f64::NAN, 1.0), (0.0, f64::INFINITY)] {
        let result = time_of_impact(&cube, &still, &cube, &still, t0, t1, &settings);
        assert!(matches!(result, Err(ImpactError::Interval { .. })));
    }
    let few = ImpactSearch { max_evaluations: 2, ..settings };
    let near = Flight::new(at(0.0, 0.0, 1.1), DVec3::X, DVec3::ONE * 20.0);
    let result = time_of_impact(&cube, &near, &cube, &still, 0.0, 1.0, &few);
    assert!(matches!(result, Err(ImpactError::EvaluationLimit { limit: 2, .. })), "{result:?}");
    let plane = floor();
    assert_eq!(time(&plane, &still, &plane, &still, 1.0), None);
}

/// Two balls that start in touch, overlap by less than the touch tolerance and separate again before the interval ends
/// have an impact (before the fix, a minimum between two evaluations was ignored when the last one found them
/// separated).
#[test]
fn balls_that_overlap_and_separate_again_have_an_impact() {
    let ball = ball(0.2);
    let below = Flight::new(Pose::IDENTITY, DVec3::ZERO, DVec3::ZERO);
    for (apart, depth, end) in [(2e-13, 4e-13, 1e-3), (2e-13, 6e-13, 0.1), (4e-13, 1e-12, 3.0)] {
        let up = DVec3::new(0.6, 0.0, 0.8);
        // s(t) = apart - v t + a t^2/2 is -depth at the middle of the interval, and apart again at its end.
        let speed = 4.0 * (apart + depth) / end;
        let start = Pose::from_translation(up * (0.4 + apart));
        let above = Flight { acceleration: up * (2.0 * speed / end), ..Flight::new(start, up * -speed, DVec3::ZERO) };
        let found = time(&ball, &below, &ball, &above, end);
        let separation = found.map(|t| separation(&ball, &below.pose(t), &ball, &above.pose(t)));
        assert!(
            separation.is_some_and(|s| s < 0.0 && s > -0.5 * depth),
            "{apart:e} {depth:e}: {found:?} {separation:?}"
        );
    }
}
