//! Motions in closed form: where they are, how fast, and that their bounds hold.

use crate::random::{assert_vector, poses, vectors};
use polhode_spatial::{
    ConstantScrew, ConstantVelocity, DVec3, Motion, MotionError, Pose, Rotation, SteadyFlight, Still, UnitVector,
    Velocity,
};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Times at which an interval is sampled.
const SAMPLES: u32 = 64;

/// What makes a motion, or says why not.
type Start = fn(f64, Pose, Velocity) -> Result<(), MotionError>;

/// One motion of each kind from the same start.
fn all(t0: f64, start: Pose, velocity: Velocity, acceleration: DVec3) -> [Box<dyn Motion>; 3] {
    [
        Box::new(ConstantVelocity::new(t0, start, velocity).unwrap()),
        Box::new(ConstantScrew::new(t0, start, velocity).unwrap()),
        Box::new(SteadyFlight::new(t0, start, velocity, acceleration).unwrap()),
    ]
}

fn states() -> impl Strategy<Value = (f64, Pose, Velocity, DVec3)> {
    (-10.0..10.0_f64, poses(3.0), vectors(5.0), vectors(5.0), vectors(9.81))
        .prop_map(|(t0, start, v, w, a)| (t0, start, Velocity::new(v, w), a))
}

/// A quarter of a turn about z while moving along x.
#[test]
fn constant_velocity_is_a_line_and_a_steady_spin() {
    let velocity = Velocity::new(DVec3::X * 3.0, DVec3::Z * FRAC_PI_2);
    let motion = ConstantVelocity::new(1.0, Pose::from_translation(DVec3::Y), velocity).unwrap();
    let pose = motion.pose(2.0);
    assert_eq!(pose.translation, DVec3::new(3.0, 1.0, 0.0));
    assert_vector(pose.rotation.rotate(DVec3::X), DVec3::Y, 1.0, 4e-16);
    assert_eq!(motion.velocity(2.0), velocity);
}

/// The highest point of a throw is `v^2 / 2g` up, and the flight comes down as fast as it went up.
#[test]
fn steady_flight_is_a_parabola() {
    let (up, gravity) = (12.0, 9.81);
    let velocity = Velocity::new(DVec3::new(5.0, 0.0, up), DVec3::X * TAU);
    let flight = SteadyFlight::new(-2.0, Pose::IDENTITY, velocity, DVec3::Z * -gravity).unwrap();
    let apex = up / gravity;
    let expected = DVec3::new(5.0 * apex, 0.0, up * up / (2.0 * gravity));
    assert_vector(flight.pose(apex - 2.0).translation, expected, 10.0, 4e-16);
    assert_vector(flight.velocity(2.0 * apex - 2.0).linear, DVec3::new(5.0, 0.0, -up), up, 4e-16);
    assert!(flight.pose(-1.0).rotation.angle_to(Rotation::IDENTITY) < 4e-16, "a full turn");
}

/// A screw of 0.5 m a turn at a radius of 2 m: after a quarter a quarter of the pitch higher, and after each turn
/// exactly above its start.
#[test]
fn constant_screw_is_a_helix() {
    let (radius, pitch) = (2.0, 0.5);
    let velocity = Velocity::new(DVec3::new(0.0, radius * TAU, pitch), DVec3::Z * TAU);
    let screw = ConstantScrew::new(0.0, Pose::from_translation(DVec3::X * radius), velocity).unwrap();
    assert_vector(screw.pose(0.25).translation, DVec3::new(0.0, radius, pitch / 4.0), radius, 4e-16);
    assert_vector(screw.pose(1.0).translation, DVec3::new(radius, 0.0, pitch), radius, 1e-15);
    assert_vector(screw.pose(100.0).translation, DVec3::new(radius, 0.0, 100.0 * pitch), radius, 1e-13);
}

/// Without a spin, and with a spin about the direction of travel, a screw is a straight line.
#[test]
fn a_screw_along_its_axis_is_straight() {
    let v = DVec3::new(1.0, -2.0, 2.0);
    for spin in [DVec3::ZERO, v, v * 1e-200, v * -1e9] {
        let screw = ConstantScrew::new(0.0, Pose::IDENTITY, Velocity::new(v, spin)).unwrap();
        assert_vector(screw.pose(7.0).translation, v * 7.0, 21.0, 1e-15);
    }
}

/// A spin so slow that its square underflows moves nothing off the line that could be seen, and has its bound.
#[test]
fn a_screw_with_the_slowest_spin_is_straight() {
    let spin = DVec3::new(3e-320, 0.0, 0.0);
    let screw = ConstantScrew::new(0.0, Pose::IDENTITY, Velocity::new(DVec3::Y, spin)).unwrap();
    assert_vector(screw.pose(2.0).translation, DVec3::Y * 2.0, 2.0, 1e-300);
    assert!(screw.bounds(0.0, 1.0).angular_speed >= 3e-320);
}

/// Speeds whose squares underflow or overflow still have bounds, and bounds that say nothing are infinite, not small.
#[test]
fn bounds_hold_at_the_ends_of_f64() {
    for size in [5e-324, 1e-310, 1e-170, 1e170, 5e307] {
        let vector = DVec3::new(size, -size, size);
        for motion in all(0.0, Pose::IDENTITY, Velocity::new(vector, vector), vector) {
            let bounds = motion.bounds(0.0, 1.0);
            let now = motion.velocity(0.0);
            let largest = now.linear.abs().max_element().max(now.angular.abs().max_element());
            assert!(bounds.speed >= 1.5 * largest && bounds.angular_speed >= 1.5 * largest, "{size:e}: {bounds:?}");
        }
    }
    let flight = SteadyFlight::new(0.0, Pose::IDENTITY, Velocity::ZERO, DVec3::Z).unwrap();
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(flight.bounds(0.0, t).speed, f64::INFINITY);
        assert_eq!(flight.bounds(t, 0.0).speed, f64::INFINITY);
    }
}

/// Nothing panics at any time; where a pose cannot be told it is not finite.
#[test]
fn far_times_do_not_panic() {
    let velocity = Velocity::new(DVec3::splat(1e10), DVec3::splat(1e10));
    for motion in all(0.0, Pose::IDENTITY, velocity, DVec3::splat(1e10)) {
        for t in [f64::NAN, f64::INFINITY, f64::MAX, f64::MIN] {
            assert!(!motion.pose(t).is_finite(), "{t}");
            let _ = (motion.velocity(t), motion.bounds(-t, t));
        }
    }
}

/// What is not finite is refused by name.
#[test]
fn numbers_that_are_not_finite_make_no_motion() {
    let bad = DVec3::new(0.0, f64::NAN, 0.0);
    let far = Pose::from_translation(DVec3::splat(f64::INFINITY));
    let (at, rest) = (Pose::IDENTITY, Velocity::ZERO);
    let starts: [Start; 3] = [
        |t0, start, velocity| ConstantVelocity::new(t0, start, velocity).map(drop),
        |t0, start, velocity| ConstantScrew::new(t0, start, velocity).map(drop),
        |t0, start, velocity| SteadyFlight::new(t0, start, velocity, DVec3::ZERO).map(drop),
    ];
    for new in starts {
        assert_eq!(new(f64::INFINITY, at, rest), Err(MotionError::Time(f64::INFINITY)));
        assert_eq!(new(0.0, far, rest), Err(MotionError::Pose(far)));
        let velocity = Velocity::new(DVec3::ZERO, bad);
        let error = new(0.0, at, velocity).unwrap_err();
        assert!(matches!(error, MotionError::Velocity(_)), "{error}");
        assert!(error.to_string().contains("NaN"), "{error}");
    }
    assert!(matches!(SteadyFlight::new(0.0, at, rest, bad), Err(MotionError::Acceleration(_))));
}

proptest! {
    /// At the time of its start a motion is at its start, to the last bit.
    #[test]
    fn the_start_is_exact((t0, start, velocity, acceleration) in states()) {
        for motion in all(t0, start, velocity, acceleration) {
            prop_assert_eq!(motion.pose(t0), start);
            prop_assert_eq!(motion.velocity(t0), velocity);
        }
    }

    /// The velocity of every point of the body is the rate of change of its position: central difference of the
    /// pose, whose error is of second order in the step.
    #[test]
    fn velocity_is_the_derivative_of_the_pose(state in states(), s in -3.0..3.0_f64, p in vectors(2.0)) {
        let (t0, start, velocity, acceleration) = state;
        let h = 1e-5;
        for motion in all(t0, start, velocity, acceleration) {
            let t = t0 + s;
            let at = |t: f64| motion.pose(t).transform_point(p);
            let difference = (at(t + h) - at(t - h)) / (2.0 * h);
            let expected = motion.velocity(t).at(motion.pose(t).rotation.rotate(p));
            prop_assert!((difference - expected).length() < 1e-6, "{difference} {expected}");
        }
    }

    /// No sample of an interval is faster than its bounds, and nothing changes by more than they allow.
    #[test]
    fn bounds_are_never_too_small(state in states(), from in -5.0..5.0_f64, length in 0.0..5.0_f64) {
        let (t0, start, velocity, acceleration) = state;
        for motion in all(t0, start, velocity, acceleration) {
            let bounds = motion.bounds(from, from + length);
            let step = length / f64::from(SAMPLES);
            let mut last = None;
            for k in 0..=SAMPLES {
                let t = (from + step * f64::from(k)).min(from + length);
                let (pose, now) = (motion.pose(t), motion.velocity(t));
                prop_assert!(now.linear.length() <= bounds.speed, "{} {}", now.linear.length(), bounds.speed);
                prop_assert!(now.angular.length() <= bounds.angular_speed);
                if let Some((before, then, pose_before)) = last.replace((t, now, pose)) {
                    let (duration, rounding): (f64, f64) = (t - before, 1e-13);
                    prop_assert!((now.linear - then.linear).length() <= bounds.acceleration * duration + rounding);
                    prop_assert!((now.angular - then.angular).length() <= bounds.angular_acceleration * duration);
                    let path: f64 = (pose.translation - pose_before.translation).length();
                    prop_assert!(path <= bounds.speed * duration + rounding);
                    let turn = pose.rotation.angle_to(pose_before.rotation);
                    prop_assert!(turn <= bounds.angular_speed * duration + rounding);
                }
            }
        }
    }

    /// Nor are they generous: the speed reaches its bound at an end of the interval, the acceleration everywhere.
    #[test]
    fn bounds_are_reached(state in states(), length in 0.1..5.0_f64) {
        let (t0, start, velocity, acceleration) = state;
        for motion in all(t0, start, velocity, acceleration) {
            let bounds = motion.bounds(t0, t0 + length);
            let speed = |t: f64| motion.velocity(t).linear.length();
            prop_assert!(speed(t0).max(speed(t0 + length)) >= bounds.speed * (1.0 - 1e-13));
            let h = 1e-4;
            let rate = (motion.velocity(t0 + h).linear - motion.velocity(t0 - h).linear).length() / (2.0 * h);
            prop_assert!((rate - bounds.acceleration).abs() < 1e-5, "{rate} {}", bounds.acceleration);
        }
    }

    /// A flight without acceleration has a constant velocity, and a screw without spin too; what neither moves nor
    /// turns is still.
    #[test]
    fn special_cases_agree((t0, start, velocity, _) in states(), s in -9.0..9.0_f64) {
        let straight = ConstantVelocity::new(t0, start, velocity).unwrap();
        let flight = SteadyFlight::new(t0, start, velocity, DVec3::ZERO).unwrap();
        prop_assert_eq!(flight.pose(t0 + s), straight.pose(t0 + s));
        let sliding = Velocity::new(velocity.linear, DVec3::ZERO);
        let (screw, straight) =
            (ConstantScrew::new(t0, start, sliding).unwrap(), ConstantVelocity::new(t0, start, sliding).unwrap());
        prop_assert_eq!(screw.pose(t0 + s), straight.pose(t0 + s));
        for motion in all(t0, start, Velocity::ZERO, DVec3::ZERO) {
            prop_assert_eq!(motion.pose(t0 + s), Still(start).pose(t0 + s));
            prop_assert_eq!(motion.bounds(t0, t0 + s), Still(start).bounds(t0, t0 + s));
        }
    }

    /// A screw is a rotation about its axis and a shift along it, however far it has turned, and its velocity seen from
    /// the body does not change.
    #[test]
    fn a_screw_turns_about_its_axis((t0, start, velocity, _) in states(), s in -9.0..9.0_f64) {
        let Velocity { linear, angular } = velocity;
        prop_assume!(angular.length() > 0.1);
        let screw = ConstantScrew::new(t0, start, velocity).unwrap();
        let pose = screw.pose(t0 + s);
        let center = start.translation + angular.cross(linear) / angular.length_squared();
        let axis = UnitVector::new(angular).unwrap().get();
        let turn = Rotation::from_rotation_vector(angular * s);
        let expected = center + turn.rotate(start.translation - center) + axis * (axis.dot(linear) * s);
        let scale = 1.0 + (center - start.translation).length() + linear.length() * s.abs();
        prop_assert!((pose.translation - expected).length() <= 1e-14 * scale, "{} {expected}", pose.translation);
        let seen = |pose: Pose, velocity: Velocity| pose.rotation.inverse_rotate(velocity.linear);
        let (now, first) = (seen(pose, screw.velocity(t0 + s)), seen(start, velocity));
        prop_assert!((now - first).length() <= 1e-14 * (1.0 + linear.length()));
    }

    /// It does not matter from which of its times a motion is given.
    #[test]
    fn a_motion_continues_from_any_of_its_times(state in states(), s in -3.0..3.0_f64, more in -3.0..3.0_f64) {
        let (t0, start, velocity, acceleration) = state;
        let t1 = t0 + s;
        let first = all(t0, start, velocity, acceleration);
        for (kind, motion) in first.iter().enumerate() {
            let again = &all(t1, motion.pose(t1), motion.velocity(t1), acceleration)[kind];
            let (a, b) = (motion.pose(t1 + more), again.pose(t1 + more));
            prop_assert!((a.translation - b.translation).length() < 1e-12, "{kind}");
            prop_assert!(a.rotation.angle_to(b.rotation) < 1e-13, "{kind}");
        }
    }
}
