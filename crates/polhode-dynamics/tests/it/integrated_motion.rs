//! One body's motion over a step: the bounds hold for every pose and every velocity in every part of the step, and
//! close in on the truth as the part shrinks.

use crate::support::{cases, direction, moments, rotation, turned_body};
use glam::DVec3;
use polhode_dynamics::{BodyState, Dop853, Flight, FreeMotion, IntegratedMotion, RigidBody};
use polhode_spatial::{Motion, Pose, Rotation};
use proptest::prelude::*;

/// A step of two bodies; the motion of the second.
fn step(body: &RigidBody, start: &BodyState, gravity: DVec3, h: f64) -> IntegratedMotion {
    let bodies = [*body, *body];
    let mut system = FreeMotion::new(&bodies, gravity, &[]);
    let other = BodyState::at_rest(Pose::from_translation(DVec3::ONE));
    let state = [other.to_array(), start.to_array()].concat();
    let mut method = Dop853::new(state.len());
    method.attempt(&mut system, 1.0, &state, h, &vec![1.0; state.len()]).unwrap();
    let dense = method.dense(&mut system).unwrap();
    assert!(dense.body_motion(14, body).is_none(), "there is no whole body at 14");
    dense.body_motion(13, body).unwrap()
}

/// The motion of a step is that of the flight it approximates, to the error of the step.
#[test]
fn motion_follows_the_flight() {
    let body = turned_body(1.0, DVec3::new(1.0, 2.0, 2.5), Rotation::from_rotation_vector(DVec3::new(0.1, 0.4, -0.2)));
    let start = BodyState {
        pose: Pose::new(Rotation::from_rotation_vector(DVec3::ONE), DVec3::new(3.0, 0.0, 1.0)),
        linear_velocity: DVec3::new(1.0, 2.0, 3.0),
        angular_momentum: DVec3::new(2.0, -1.0, 1.5),
    };
    let gravity = DVec3::new(0.0, 0.0, -9.81);
    let flight = Flight::new(&body, 1.0, &start, gravity);
    let motion = step(&body, &start, gravity, 0.1);
    for k in 0..=20 {
        let t = 1.0 + 0.005 * f64::from(k);
        let (a, b) = (motion.pose(t), flight.pose(t));
        assert!((a.translation - b.translation).length() < 1e-14 && a.rotation.angle_to(b.rotation) < 1e-12);
        let (v, w, rate) = (motion.velocity(t), flight.velocity(t), motion.pose_rate(t));
        assert!((v.linear - w.linear).length() < 1e-13 && (v.angular - w.angular).length() < 1e-12);
        assert!((rate.linear - w.linear).length() < 1e-12 && (rate.angular - w.angular).length() < 1e-10);
    }
    // On a thousandth of the step the bounds are the truth to a thousandth.
    let (bounds, now) = (motion.bounds(1.05, 1.0501), flight.velocity(1.05));
    let tight = |bound: f64, value: f64| assert!(bound >= value && bound < value * 1.001, "{bound} for {value}");
    tight(bounds.speed, now.linear.length() * 0.9999);
    tight(bounds.acceleration, 9.81);
    tight(bounds.angular_speed, now.angular.length() * 0.9999);
    assert!(bounds.angular_acceleration <= 2.0 * flight.bounds(1.0, 1.1).angular_acceleration);
}

/// A steady spin has next to no angular acceleration, and the bound knows it on the whole step.
#[test]
fn steady_spin_is_bounded_tightly() {
    let body = turned_body(1.0, DVec3::new(1.0, 2.0, 2.5), Rotation::IDENTITY);
    let start = BodyState { angular_momentum: DVec3::Z * 25.0, ..BodyState::at_rest(Pose::IDENTITY) };
    let bounds = step(&body, &start, DVec3::ZERO, 0.01).bounds(1.0, 1.01);
    assert!(bounds.angular_acceleration < 1e-6, "{bounds:?}");
    assert!((10.0..10.0 + 1e-6).contains(&bounds.angular_speed), "{bounds:?}");
    assert!(bounds.speed < 1e-12 && bounds.acceleration < 1e-9, "{bounds:?}");
}

/// Times outside the step and steps that are no steps have no bounds.
#[test]
fn outside_the_step_nothing_is_promised() {
    let body = turned_body(1.0, DVec3::new(1.0, 2.0, 2.5), Rotation::IDENTITY);
    let start = BodyState { angular_momentum: DVec3::ONE, ..BodyState::at_rest(Pose::IDENTITY) };
    let motion = step(&body, &start, DVec3::ZERO, 0.1);
    assert!(motion.bounds(1.0, 1.1).angular_speed.is_finite());
    assert!(motion.bounds(1.0, 1.2).angular_speed.is_infinite());
    assert!(motion.bounds(f64::NAN, 1.05).speed.is_infinite());
    assert!(step(&body, &start, DVec3::ZERO, 0.0).bounds(1.0, 1.0).speed.is_infinite());
}

proptest! {
    #![proptest_config(cases(150))]

    /// Steps from good to far too long (a turn of 3 rad, where interpolation errs visibly), forwards and backwards.
    #[test]
    fn bounds_are_never_exceeded(
        (i, axes) in (moments(1.0), rotation()),
        (r, v, l, g) in (rotation(), direction(), direction(), direction()),
        exponent in -3.0..0.5f64, backwards in prop::bool::ANY,
        (first, length) in (0.0..1.0f64, 0.0..1.0f64), parts in prop::collection::vec(0.0..1.0f64, 10),
    ) {
        let body = turned_body(1.0, i, axes);
        let angular_momentum = l * i.min_element();
        let start = BodyState { pose: Pose::new(r, v), linear_velocity: v * 2.0, angular_momentum };
        let h = 10f64.powf(exponent) * if backwards { -1.0 } else { 1.0 };
        let motion = step(&body, &start, g * 9.81, h);
        let (a, b) = (1.0 + h * first, 1.0 + h * (first + (1.0 - first) * length));
        let bounds = motion.bounds(a, b);
        let samples: Vec<_> = parts.iter().map(|p| {
            let t = a + p * (b - a);
            (t, motion.pose(t), motion.velocity(t), motion.pose_rate(t))
        }).collect();
        for (t, pose, velocity, rate) in &samples {
            for sample in [velocity, rate] {
                prop_assert!(sample.linear.length() <= bounds.speed, "{} of {}", sample.linear.length(), bounds.speed);
                let rate = sample.angular.length();
                prop_assert!(rate <= bounds.angular_speed * (1.0 + 1e-14), "{} of {}", rate, bounds.angular_speed);
            }
            for (u, other_pose, other_velocity, other_rate) in &samples {
                let s = (t - u).abs();
                let near = |x: f64, limit: f64| x <= limit * (1.0 + 1e-9) + 1e-12;
                prop_assert!(near((pose.translation - other_pose.translation).length(), bounds.speed * s));
                prop_assert!(near(pose.rotation.angle_to(other_pose.rotation), bounds.angular_speed * s));
                prop_assert!(near((velocity.linear - other_velocity.linear).length(), bounds.acceleration * s));
                prop_assert!(near((rate.linear - other_rate.linear).length(), bounds.acceleration * s));
                prop_assert!(near((rate.angular - other_rate.angular).length(), bounds.angular_acceleration * s));
            }
        }
    }
}
