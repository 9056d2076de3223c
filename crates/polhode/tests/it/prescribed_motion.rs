//! Prescribed motion: closed forms, derivatives, smoothness at samples, bounds, and refused input.

use crate::support::{ball, floor};
use polhode::contact::Shape;
use polhode::scene::motion::{LARGEST, LARGEST_TURN};
use polhode::scene::{
    Attachment, Force, Interpolation, MotionError, MotionTable, PrescribedMotion, SampledOrientations, Trajectory,
};
use polhode::spatial::{DVec3, Motion, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Geometry, Scene, SceneError};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A pose without special directions.
fn initial() -> Pose {
    Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, -1.1, 0.7)), DVec3::new(2.0, -3.0, 0.5))
}

fn turned(x: f64, y: f64, z: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::new(x, y, z))
}

/// Samples at uneven times that move and turn about changing axes.
fn table() -> MotionTable {
    MotionTable {
        times_s: vec![-0.5, 0.2, 0.5, 1.3, 1.4, 2.6],
        positions_m: Some(
            [(0.0, 0.0, 0.0), (0.3, 0.1, 0.0), (0.2, 0.4, -0.1), (1.0, -1.0, 0.5), (1.0, -1.1, 0.5), (0.0, 0.0, 2.0)]
                .map(|(x, y, z)| DVec3::new(x, y, z))
                .to_vec(),
        ),
        orientations: Some(SampledOrientations::Rotations(vec![
            turned(0.1, 0.0, 0.0),
            turned(0.5, 0.4, 0.0),
            turned(0.4, 0.9, -0.6),
            turned(-0.5, 2.0, 1.0),
            turned(-0.6, 2.0, 1.2),
            turned(1.5, 0.5, 0.0),
        ])),
        interpolation: Interpolation::Spline,
    }
}

/// One trajectory of each kind.
fn each_kind() -> Vec<Trajectory> {
    let constant = Velocity::new(DVec3::new(0.4, -0.2, 0.1), DVec3::new(1.0, 2.0, -0.5));
    let motions = [
        PrescribedMotion::constant_velocity(constant),
        PrescribedMotion::sine(DVec3::new(0.1, 0.0, -0.2), DVec3::new(0.5, 0.9, 0.2), 0.8, 0.4),
        PrescribedMotion::table(&table()),
    ];
    motions.into_iter().map(|motion| motion.unwrap().from_pose(&initial())).collect()
}

/// The derivative of `y` at zero by central differences of fourth order with spacing h.
fn rate(h: f64, y: impl Fn(f64) -> DVec3) -> DVec3 {
    ((y(h) - y(-h)) * 8.0 - (y(2.0 * h) - y(-2.0 * h))) / (12.0 * h)
}

/// A body at constant velocity goes straight and turns about an axis of the world, from its initial pose.
#[test]
fn constant_velocity() {
    let velocity = Velocity::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, 0.0, FRAC_PI_2));
    let trajectory = PrescribedMotion::constant_velocity(velocity).unwrap().from_pose(&initial());
    assert_eq!(trajectory.pose(0.0), initial());
    let pose = trajectory.pose(2.0);
    assert!((pose.translation - (initial().translation + DVec3::new(2.0, 4.0, 6.0))).length() < 1e-15);
    assert!(pose.rotation.angle_to(turned(0.0, 0.0, PI) * initial().rotation) < 1e-15);
    assert_eq!(trajectory.velocity(7.0), velocity);
    assert_eq!((trajectory.acceleration(7.0).linear, trajectory.acceleration(7.0).angular), (DVec3::ZERO, DVec3::ZERO));
    assert_eq!(trajectory.corner_between(0.0, 10.0), None);
}

/// An oscillation is centred on the initial pose; at t = 0 the phase decides where the body is. With phase zero it is
/// at the amplitude, with velocity zero, a quarter of a period later.
#[test]
fn sine() {
    let (amplitude, rotation) = (DVec3::new(0.0, 0.3, 0.4), DVec3::new(0.2, 0.0, 0.0));
    let at = |phase: f64| PrescribedMotion::sine(amplitude, rotation, 2.0, phase).unwrap().from_pose(&initial());
    let trajectory = at(0.0);
    assert_eq!(trajectory.pose(0.0), initial());
    assert!((trajectory.velocity(0.0).linear - amplitude * (2.0 * TAU)).length() < 1e-14);
    assert!((trajectory.velocity(0.0).angular - rotation * (2.0 * TAU)).length() < 1e-14);
    let quarter = trajectory.pose(0.125);
    assert!((quarter.translation - initial().translation - amplitude).length() < 1e-15);
    assert!(quarter.rotation.angle_to(turned(0.2, 0.0, 0.0) * initial().rotation) < 1e-15);
    assert!(trajectory.velocity(0.125).linear.length() < 1e-14);
    let acceleration = trajectory.acceleration(0.125);
    assert!((acceleration.linear + amplitude * (4.0 * TAU * TAU)).length() < 1e-12);
    assert!((acceleration.angular + rotation * (4.0 * TAU * TAU)).length() < 1e-12);
    // sin(pi/6) = 1/2.
    let start = at(PI / 6.0).pose(0.0);
    assert!((start.translation - initial().translation - amplitude * 0.5).length() < 1e-15);
    assert!(start.rotation.angle_to(turned(0.1, 0.0, 0.0) * initial().rotation) < 1e-15);
}

/// Between two samples the body moves from rest to rest by `10 x^3 - 15 x^4 + 6 x^5`, in position and in angle.
#[test]
fn two_samples() {
    let table = MotionTable {
        times_s: vec![1.0, 3.0],
        positions_m: Some(vec![DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0)]),
        orientations: Some(SampledOrientations::RotationVectors(vec![DVec3::ZERO, DVec3::new(0.0, 0.0, 3.0)])),
        ..MotionTable::default()
    };
    let trajectory = PrescribedMotion::table(&table).unwrap().from_pose(&Pose::IDENTITY);
    for x in [0.0, 0.1, 0.25, 0.5, 0.7, 0.99, 1.0_f64] {
        let (way, speed) = (x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), 30.0 * x * x * (1.0 - x) * (1.0 - x));
        let t = 1.0 + 2.0 * x;
        let (pose, velocity) = (trajectory.pose(t), trajectory.velocity(t));
        assert!((pose.translation - DVec3::X * (4.0 * way)).length() < 1e-14, "{x}");
        assert!(pose.rotation.angle_to(turned(0.0, 0.0, 3.0 * way)) < 1e-14, "{x}");
        assert!((velocity.linear - DVec3::X * (2.0 * speed)).length() < 1e-13, "{x}");
        assert!((velocity.angular - DVec3::Z * (1.5 * speed)).length() < 1e-13, "{x}");
    }
}

/// A table passes through its samples; before the first and after the last one the body stands still. A table without
/// orientations, or without positions, keeps those of the initial pose.
#[test]
fn table_goes_through_its_samples() {
    let full = table();
    let trajectory = PrescribedMotion::table(&full).unwrap().from_pose(&initial());
    let (positions, Some(SampledOrientations::Rotations(rotations))) = (full.positions_m.unwrap(), full.orientations)
    else {
        panic!("the table has rotations");
    };
    for ((&t, &position), &rotation) in full.times_s.iter().zip(&positions).zip(&rotations) {
        assert_eq!(trajectory.pose(t).translation, position);
        assert!(trajectory.pose(t).rotation.angle_to(rotation) < 1e-15);
    }
    for (t, at) in [(-7.0, 0), (-0.5, 0), (2.6, 5), (1e9, 5)] {
        assert_eq!(trajectory.pose(t).translation, positions[at]);
        assert_eq!(trajectory.velocity(t), Velocity::ZERO);
        assert_eq!(trajectory.acceleration(t).linear, DVec3::ZERO);
    }
    let still = trajectory.bounds(3.0, 9.0);
    assert_eq!(
        (still.speed, still.angular_speed, still.acceleration, still.angular_acceleration),
        (0.0, 0.0, 0.0, 0.0)
    );
    let moved = PrescribedMotion::table(&MotionTable { orientations: None, ..table() }).unwrap();
    assert_eq!(moved.from_pose(&initial()).pose(0.7).rotation, initial().rotation);
    let turned = PrescribedMotion::table(&MotionTable { positions_m: None, ..table() }).unwrap();
    assert_eq!(turned.from_pose(&initial()).pose(0.7).translation, initial().translation);
}

/// Velocity and acceleration are the derivatives of the pose, for every kind of motion, also where rotations do not
/// commute.
#[test]
fn velocities_and_accelerations_are_derivatives() {
    let h = 1e-3;
    for trajectory in each_kind() {
        for t in [-0.3, 0.0, 0.1, 0.35, 0.9, 1.0, 1.35, 2.0, 2.4] {
            let velocity = trajectory.velocity(t);
            let linear = rate(h, |s| trajectory.pose(t + s).translation);
            let from = trajectory.pose(t).rotation.inverse();
            let angular = rate(h, |s| (trajectory.pose(t + s).rotation * from).to_rotation_vector());
            // The difference formula errs by the fifth derivative times h^4/30: that of the table is up to 1e5.
            assert!((velocity.linear - linear).length() < 1e-8, "{t}: {} {linear}", velocity.linear);
            assert!((velocity.angular - angular).length() < 1e-7, "{t}: {} {angular}", velocity.angular);
            let acceleration = trajectory.acceleration(t);
            let linear = rate(h, |s| trajectory.velocity(t + s).linear);
            let angular = rate(h, |s| trajectory.velocity(t + s).angular);
            assert!((acceleration.linear - linear).length() < 1e-6, "{t}: {} {linear}", acceleration.linear);
            assert!((acceleration.angular - angular).length() < 1e-5, "{t}: {} {angular}", acceleration.angular);
        }
    }
}

/// Pose, velocity and acceleration of a table are continuous at every sample, the first and the last one too.
#[test]
fn tables_are_twice_continuously_differentiable() {
    let trajectory = PrescribedMotion::table(&table()).unwrap().from_pose(&Pose::IDENTITY);
    for t in table().times_s {
        let distance = |step: f64| {
            let (before, after) = (t - step, t + step);
            let (a, b) = (trajectory.pose(before), trajectory.pose(after));
            let (va, vb) = (trajectory.velocity(before), trajectory.velocity(after));
            let (aa, ab) = (trajectory.acceleration(before), trajectory.acceleration(after));
            (a.translation - b.translation).length()
                + a.rotation.angle_to(b.rotation)
                + (va.linear - vb.linear).length()
                + (va.angular - vb.angular).length()
                + (aa.linear - ab.linear).length()
                + (aa.angular - ab.angular).length()
        };
        // The acceleration may change by the largest third derivative of the table, some 1e5, times the spacing.
        for step in [1e-6, 1e-9] {
            assert!(distance(step) < 1e5 * step + 1e-9, "{t}: {}", distance(step));
        }
    }
}

/// About one axis, over several turns, the angle is interpolated as a position is.
#[test]
fn turns_about_one_axis_are_those_of_the_angle() {
    let times_s = vec![0.0, 0.4, 1.1, 1.5, 2.5, 3.0];
    let angles = [0.0, 2.0, 5.0, 8.0, 9.5, 12.5];
    let axis = DVec3::new(2.0, -1.0, 2.0) / 3.0;
    let vectors: Vec<DVec3> = angles.map(|angle| axis * angle).to_vec();
    let table = MotionTable {
        times_s,
        positions_m: Some(vectors.clone()),
        orientations: Some(SampledOrientations::RotationVectors(vectors)),
        ..MotionTable::default()
    };
    let trajectory = PrescribedMotion::table(&table).unwrap().from_pose(&Pose::IDENTITY);
    for step in 0..=300 {
        let t = f64::from(step) * 0.01;
        let (pose, velocity, acceleration) = (trajectory.pose(t), trajectory.velocity(t), trajectory.acceleration(t));
        assert!(pose.rotation.angle_to(Rotation::from_rotation_vector(pose.translation)) < 1e-13);
        assert!((velocity.angular - velocity.linear).length() < 1e-12);
        assert!((acceleration.angular - acceleration.linear).length() < 1e-10);
    }
    assert!((trajectory.pose(3.0).translation.length() - 12.5).abs() < 1e-14);
}

/// A spline of samples of a smooth motion from rest to rest, about changing axes, approximates it to fourth order.
#[test]
fn order_of_tables() {
    let way = |t: f64| t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
    let pose = |t: f64| {
        let s = way(t);
        let rotation = turned(1.5 * s, 0.0, 0.5 * s * s) * turned(0.0, 2.0 * s, 0.7 * s);
        Pose::new(rotation, DVec3::new(libm::sin(3.0 * s), s * s, libm::exp(s)))
    };
    let error = |count: usize| {
        let times_s: Vec<f64> = (0..=count).map(|k| k as f64 / count as f64).collect();
        let table = MotionTable {
            positions_m: Some(times_s.iter().map(|&t| pose(t).translation).collect()),
            orientations: Some(SampledOrientations::Rotations(times_s.iter().map(|&t| pose(t).rotation).collect())),
            times_s,
            interpolation: Interpolation::Spline,
        };
        let trajectory = PrescribedMotion::table(&table).unwrap().from_pose(&Pose::IDENTITY);
        (0..=1000).map(|k| f64::from(k) / 1000.0).fold((0.0, 0.0), |(place, angle): (f64, f64), t| {
            let (found, exact) = (trajectory.pose(t), pose(t));
            let (off, turn) =
                ((found.translation - exact.translation).length(), found.rotation.angle_to(exact.rotation));
            (place.max(off), angle.max(turn))
        })
    };
    let (coarse, fine) = (error(40), error(80));
    let orders = (libm::log2(coarse.0 / fine.0), libm::log2(coarse.1 / fine.1));
    assert!(orders.0 > 3.8 && orders.1 > 3.8, "{coarse:?} {fine:?} {orders:?}");
}

/// The spline of orientations depends neither on the axes of the world nor on those of the body.
#[test]
fn tables_do_not_depend_on_frames() {
    let (world, body) = (turned(0.4, 1.0, -2.0), turned(-1.0, 0.3, 0.8));
    let Some(SampledOrientations::Rotations(rotations)) = table().orientations else {
        panic!("the table has rotations");
    };
    let seen = rotations.iter().map(|&rotation| world * rotation * body).collect();
    let orientations = Some(SampledOrientations::Rotations(seen));
    let there = PrescribedMotion::table(&MotionTable { orientations, ..table() }).unwrap().from_pose(&initial());
    let here = PrescribedMotion::table(&table()).unwrap().from_pose(&initial());
    for step in 0..40 {
        let t = -0.6 + 0.083 * f64::from(step);
        assert!((world * here.pose(t).rotation * body).angle_to(there.pose(t).rotation) < 1e-14);
        assert!((world.rotate(here.velocity(t).angular) - there.velocity(t).angular).length() < 1e-12);
        assert!((world.rotate(here.acceleration(t).angular) - there.acceleration(t).angular).length() < 1e-10);
    }
}

/// A step of an integrator may not pass a sample of a table: `corner_between` gives the next one, in both directions of
/// time.
#[test]
fn the_next_sample_of_a_table_is_found_in_both_directions() {
    let motion = PrescribedMotion::table(&table()).unwrap();
    assert_eq!(motion.corner_between(0.0, 9.0), Some(0.2));
    assert_eq!(motion.corner_between(0.2, 9.0), Some(0.5));
    assert_eq!(motion.corner_between(0.2, 0.5), None);
    assert_eq!(motion.corner_between(9.0, 0.0), Some(2.6));
    assert_eq!(motion.corner_between(1.35, -9.0), Some(1.3));
    assert_eq!(motion.corner_between(2.6, 9.0), None);
    assert_eq!(motion.corner_between(f64::NAN, 9.0), None);
}

/// Over short intervals the bounds tend to the values of the motion.
#[test]
fn bounds_shrink() {
    for trajectory in each_kind() {
        for t in [0.1, 0.35, 1.1, 2.2] {
            let bounds = trajectory.bounds(t, t + 1e-6);
            let (velocity, acceleration) = (trajectory.velocity(t), trajectory.acceleration(t));
            let near = |bound: f64, value: f64| bound <= value + 1e-3;
            assert!(near(bounds.speed, velocity.linear.length()), "{bounds:?} {velocity:?}");
            assert!(near(bounds.angular_speed, velocity.angular.length()), "{bounds:?} {velocity:?}");
            assert!(near(bounds.acceleration, acceleration.linear.length()), "{bounds:?} {acceleration:?}");
        }
    }
}

/// Checks the bounds of an interval against samples of it, and of the changes between them.
fn check_bounds(trajectory: &Trajectory, from: f64, to: f64, parts: &[f64]) -> Result<(), TestCaseError> {
    let bounds = trajectory.bounds(from, to);
    let times = parts.iter().map(|part| from + part * (to - from));
    let samples: Vec<_> = times.map(|t| (t, trajectory.pose(t), trajectory.velocity(t))).collect();
    for (t, pose, velocity) in &samples {
        let acceleration = trajectory.acceleration(*t);
        prop_assert!(velocity.linear.length() <= bounds.speed, "{velocity:?} {bounds:?}");
        prop_assert!(velocity.angular.length() <= bounds.angular_speed, "{velocity:?} {bounds:?}");
        prop_assert!(acceleration.linear.length() <= bounds.acceleration, "{acceleration:?} {bounds:?}");
        prop_assert!(acceleration.angular.length() <= bounds.angular_acceleration, "{acceleration:?} {bounds:?}");
        for (u, other, other_velocity) in &samples {
            let s = (t - u).abs();
            let near = |x: f64, limit: f64| x <= limit * (1.0 + 1e-9) + 1e-11;
            prop_assert!(near((pose.translation - other.translation).length(), bounds.speed * s));
            prop_assert!(near(pose.rotation.angle_to(other.rotation), bounds.angular_speed * s));
            prop_assert!(near((velocity.linear - other_velocity.linear).length(), bounds.acceleration * s));
            prop_assert!(near((velocity.angular - other_velocity.angular).length(), bounds.angular_acceleration * s));
        }
    }
    Ok(())
}

fn vector(size: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-size..size).prop_map(DVec3::from_array)
}

/// Smooth tables of three to seven samples with spacings between 0.01 and 1 s and turns of up to 3 rad.
fn tables() -> impl Strategy<Value = MotionTable> {
    let sample = (0.01..1.0f64, vector(1.0), vector(1.7));
    let kind = prop_oneof![Just(Interpolation::Monotone), Just(Interpolation::Spline)];
    (prop::collection::vec(sample, 3..8), kind).prop_map(|(samples, interpolation)| {
        let (mut t, mut rotation) = (-0.3, Rotation::IDENTITY);
        let mut table = MotionTable { interpolation, ..MotionTable::default() };
        let (mut positions, mut rotations) = (Vec::new(), Vec::new());
        for (spacing, position, turn) in samples {
            t += spacing;
            rotation = Rotation::from_rotation_vector(turn) * rotation;
            table.times_s.push(t);
            positions.push(position);
            rotations.push(rotation);
        }
        table.positions_m = Some(positions);
        table.orientations = Some(SampledOrientations::Rotations(rotations));
        table
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Bounds of a table are never exceeded, over parts of one segment and over several.
    #[test]
    fn bounds_of_tables_are_never_exceeded(
        table in tables(), start in -0.5..3.0f64, exponent in -4.0..0.6f64,
        parts in prop::collection::vec(0.0..=1.0f64, 12),
    ) {
        let trajectory = PrescribedMotion::table(&table).unwrap().from_pose(&initial());
        check_bounds(&trajectory, start, start + libm::pow(10.0, exponent), &parts)?;
    }

    /// Bounds of an oscillation are never exceeded, over a small part of a period and over many, also after many
    /// periods.
    #[test]
    fn bounds_of_oscillations_are_never_exceeded(
        (amplitude, rotation) in (vector(2.0), vector(2.0)), frequency in 0.1..50.0f64, phase in -9.0..9.0f64,
        start in -1e3..1e3f64, exponent in -5.0..1.0f64, parts in prop::collection::vec(0.0..=1.0f64, 12),
    ) {
        let trajectory =
            PrescribedMotion::sine(amplitude, rotation, frequency, phase).unwrap().from_pose(&Pose::IDENTITY);
        let bounds = trajectory.bounds(start, start + libm::pow(10.0, exponent));
        for part in parts {
            let t = start + part * libm::pow(10.0, exponent);
            let (velocity, acceleration) = (trajectory.velocity(t), trajectory.acceleration(t));
            prop_assert!(velocity.linear.length() <= bounds.speed);
            prop_assert!(velocity.angular.length() <= bounds.angular_speed);
            prop_assert!(acceleration.linear.length() <= bounds.acceleration);
            prop_assert!(acceleration.angular.length() <= bounds.angular_acceleration);
        }
    }

    /// A monotone table stays between its samples, in every coordinate, at all times.
    #[test]
    fn monotone_tables_stay_between_their_samples(table in tables(), parts in prop::collection::vec(0.0..=1.0f64, 12)) {
        let motion = PrescribedMotion::table(&MotionTable { interpolation: Interpolation::Monotone, ..table.clone() });
        let trajectory = motion.unwrap().from_pose(&Pose::IDENTITY);
        let positions = table.positions_m.as_ref().unwrap();
        for (times, ends) in table.times_s.windows(2).zip(positions.windows(2)) {
            for part in &parts {
                let place = trajectory.pose(times[0] + part * (times[1] - times[0])).translation;
                let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
                prop_assert!((place - place.clamp(low, high)).length() < 1e-14, "{place} {low} {high}");
            }
        }
    }

    /// Whatever the samples, the motion goes through them, and its velocity is the derivative of its pose.
    #[test]
    fn tables_of_any_samples(table in tables(), part in 0.05..0.95f64) {
        let trajectory = PrescribedMotion::table(&table).unwrap().from_pose(&Pose::IDENTITY);
        let Some(SampledOrientations::Rotations(rotations)) = &table.orientations else { unreachable!() };
        for (&t, &rotation) in table.times_s.iter().zip(rotations) {
            prop_assert!(trajectory.pose(t).rotation.angle_to(rotation) < 1e-12);
        }
        for pair in table.times_s.windows(2) {
            let length = pair[1] - pair[0];
            let (t, h) = (pair[0] + part * length, 1e-3 * length);
            let from = trajectory.pose(t).rotation.inverse();
            let angular = rate(h, |s| (trajectory.pose(t + s).rotation * from).to_rotation_vector());
            let velocity = trajectory.velocity(t).angular;
            // Tolerances are relative to the largest rates of the segment: a table may turn to and fro.
            let bounds = trajectory.bounds(pair[0], pair[1]);
            // The motion before a sample ends at it and does not jump to it.
            let near = trajectory.pose(pair[1] - 1e-9 * length).rotation;
            let jump = near.angle_to(trajectory.pose(pair[1]).rotation);
            prop_assert!(jump <= 1.1e-9 * length * bounds.angular_speed + 1e-12, "{jump}");
            let most = bounds.angular_speed.max(bounds.angular_acceleration * length);
            prop_assert!((velocity - angular).length() <= 1e-6 * most, "{velocity} {angular}");
            let change = rate(h, |s| trajectory.velocity(t + s).angular);
            let acceleration = trajectory.acceleration(t).angular;
            prop_assert!((acceleration - change).length() * length <= 1e-5 * most, "{acceleration} {change}");
        }
    }
}

/// Bounds of all kinds over intervals of every length; over an interval with a NaN the bound is infinite.
#[test]
fn bounds_of_every_kind() {
    let parts: Vec<f64> = (0..=20).map(|k| f64::from(k) / 20.0).collect();
    for trajectory in each_kind() {
        for length in [0.0, 1e-3, 0.1, 1.0, 5.0] {
            check_bounds(&trajectory, 0.3, 0.3 + length, &parts).unwrap();
        }
    }
    let table = PrescribedMotion::table(&table()).unwrap().from_pose(&initial());
    assert!(table.bounds(f64::NAN, 1.0).speed.is_infinite());
}

/// Numbers that prescribe no motion are refused, with the value and what is accepted.
#[test]
fn bad_numbers() {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2.0 * LARGEST];
    let refused = |result: Result<PrescribedMotion, MotionError>| result.unwrap_err().to_string();
    for value in bad {
        for velocity in [Velocity::new(DVec3::X * value, DVec3::Z), Velocity::new(DVec3::X, DVec3::Y * value)] {
            assert!(refused(PrescribedMotion::constant_velocity(velocity)).contains("at most 1e100"));
        }
        let sine = |a: f64, b: f64, f: f64, p: f64| refused(PrescribedMotion::sine(DVec3::X * a, DVec3::X * b, f, p));
        for message in [sine(value, 0.0, 1.0, 0.0), sine(0.0, value, 1.0, 0.0), sine(1.0, 0.0, value, 0.0)] {
            assert!(message.contains("at most 1e100"), "{message}");
        }
        assert!(sine(1.0, 0.0, 1.0, value).contains("the phase"));
        let mut times = table();
        times.times_s[2] = value;
        assert!(refused(PrescribedMotion::table(&times)).contains("a time"));
        let mut places = table();
        places.positions_m.as_mut().unwrap()[3].y = value;
        assert!(refused(PrescribedMotion::table(&places)).contains("a position"));
        let vectors = SampledOrientations::RotationVectors(vec![DVec3::ZERO, DVec3::X * value]);
        let (times_s, orientations) = (vec![0.0, 1.0], Some(vectors));
        let turns = MotionTable { times_s, orientations, ..MotionTable::default() };
        assert!(refused(PrescribedMotion::table(&turns)).contains("a rotation vector"));
    }
    for frequency in [0.0, -0.0, -2.0] {
        let error = PrescribedMotion::sine(DVec3::X, DVec3::ZERO, frequency, 0.0).unwrap_err();
        assert_eq!(error, MotionError::Frequency(frequency));
    }
    let too_fast = PrescribedMotion::sine(DVec3::X * 1e60, DVec3::ZERO, 1e30, 0.0).unwrap_err();
    assert!(matches!(too_fast, MotionError::TooFast { quantity: "an acceleration in m/s^2", .. }), "{too_fast}");
}

/// Tables without samples, with times out of order, with too few entries, or with half a turn or more between samples.
#[test]
fn bad_tables() {
    let refused = |table: MotionTable| PrescribedMotion::table(&table).unwrap_err();
    assert_eq!(refused(MotionTable::default()), MotionError::TooFewSamples(0));
    let one = MotionTable { times_s: vec![0.0], positions_m: Some(vec![DVec3::X]), ..MotionTable::default() };
    assert_eq!(refused(one), MotionError::TooFewSamples(1));
    assert_eq!(refused(MotionTable { positions_m: None, orientations: None, ..table() }), MotionError::EmptyTable);
    for time in [0.2, 0.1] {
        let mut unsorted = table();
        unsorted.times_s[2] = time;
        assert_eq!(refused(unsorted), MotionError::TimeOrder { index: 2, t: time, before: 0.2 });
    }
    let mut short = table();
    short.positions_m.as_mut().unwrap().pop();
    assert_eq!(refused(short), MotionError::Count { quantity: "positions", found: 5, times: 6 });
    let two = |orientations| {
        let (times_s, orientations) = (vec![0.0, 1.0], Some(orientations));
        MotionTable { times_s, orientations, ..MotionTable::default() }
    };
    let half = two(SampledOrientations::Rotations(vec![Rotation::IDENTITY, turned(0.0, PI, 0.0)]));
    assert!(matches!(refused(half), MotionError::Turn { index: 1, angle } if (angle - PI).abs() < 1e-12));
    // A turn of more than 2 pi: from the orientations alone it would look like a small one.
    let whole = two(SampledOrientations::RotationVectors(vec![DVec3::ZERO, DVec3::Z * (TAU + 0.1)]));
    assert!(matches!(refused(whole), MotionError::Turn { index: 1, .. }));
    let most = two(SampledOrientations::RotationVectors(vec![DVec3::ZERO, DVec3::Z * LARGEST_TURN]));
    assert!(PrescribedMotion::table(&most).is_ok());
    let near = MotionTable {
        times_s: vec![0.0, f64::MIN_POSITIVE],
        positions_m: Some(vec![DVec3::ZERO, DVec3::X]),
        ..MotionTable::default()
    };
    assert!(matches!(refused(near), MotionError::TooFast { .. }));
}

/// A table of heights.
fn heights(times: &[f64], heights: &[f64], interpolation: Interpolation) -> PrescribedMotion {
    let positions_m = Some(heights.iter().map(|&height| DVec3::Z * height).collect());
    PrescribedMotion::table(&MotionTable { times_s: times.to_vec(), positions_m, interpolation, orientations: None })
        .unwrap()
}

/// Two equal samples are a hold: the body stands still between them, whatever follows. (A spline rises to 42.8 m
/// between two samples at 3 m before a fast drop.) The spline's overshoot is found, and monotone and linear tables have
/// none.
#[test]
fn a_hold_before_a_fast_drop_stands_still() {
    let (times, samples) = ([0.0, 5.0, 5.05], [3.0, 3.0, 1.0]);
    for kind in [Interpolation::Monotone, Interpolation::Linear] {
        let motion = heights(&times, &samples, kind);
        let trajectory = motion.from_pose(&Pose::IDENTITY);
        for step in 0..=500 {
            assert_eq!(trajectory.pose(f64::from(step) * 0.01).translation, DVec3::Z * 3.0, "{kind:?}");
        }
        assert_eq!(motion.excursion(), None);
    }
    let found = heights(&times, &samples, Interpolation::Spline).excursion().unwrap();
    assert_eq!((found.coordinate, found.unit, found.sample), ("z", "m", 0));
    assert!((found.value - 42.8).abs() < 0.05 && (found.beyond - 39.8).abs() < 0.05, "{found}");
    let trajectory = heights(&times, &samples, Interpolation::Spline).from_pose(&Pose::IDENTITY);
    assert!((trajectory.pose(found.t_s).translation.z - found.value).abs() < 1e-12);
}

/// A lift that waits above stays at its height; about one axis the angle does the same.
#[test]
fn a_lift_does_not_pass_its_floor() {
    let times = [0.0, 2.0, 3.0, 5.0];
    let trajectory = heights(&times, &[0.0, 2.0, 2.0, 0.0], Interpolation::Monotone).from_pose(&Pose::IDENTITY);
    let highest = (0..=500).map(|k| trajectory.pose(f64::from(k) * 0.01).translation.z).fold(0.0, f64::max);
    assert_eq!(highest, 2.0);
    let turns = [0.0, 2.0, 2.0, 0.0].map(|angle| DVec3::Y * angle).to_vec();
    let orientations = Some(SampledOrientations::RotationVectors(turns));
    let table = MotionTable { times_s: times.to_vec(), orientations, ..MotionTable::default() };
    let turned = PrescribedMotion::table(&table).unwrap();
    assert_eq!(turned.excursion(), None);
    let spline = MotionTable { interpolation: Interpolation::Spline, ..table };
    assert_eq!(PrescribedMotion::table(&spline).unwrap().excursion().map(|found| found.unit), Some("rad"));
}

/// Samples of a smooth rise from rest to rest are approximated to fourth order by monotone interpolation too: where the
/// spline is monotone, it is the spline, bit for bit.
#[test]
fn a_monotone_table_of_a_smooth_rise_is_its_spline() {
    let times: Vec<f64> = (0..=20).map(|k| f64::from(k) * 0.05).collect();
    let rise: Vec<f64> = times.iter().map(|t| t * t * t * (10.0 - 15.0 * t + 6.0 * t * t)).collect();
    let [monotone, spline] = [Interpolation::Monotone, Interpolation::Spline]
        .map(|kind| heights(&times, &rise, kind).from_pose(&Pose::IDENTITY));
    for step in 0..=1000 {
        let t = f64::from(step) * 1e-3;
        assert_eq!((monotone.pose(t), monotone.velocity(t)), (spline.pose(t), spline.velocity(t)), "{t}");
    }
}

/// A linear table jumps in velocity at its samples, but not where neighbouring slopes are the same in decimals.
#[test]
fn jumps_of_linear_tables_are_found() {
    let straight = heights(&[0.0, 0.1, 0.2, 0.3], &[1.0, 1.1, 1.2, 1.3], Interpolation::Linear);
    assert_eq!((straight.jump_between(0.0, 0.3), straight.jump_between(-1.0, 1.0)), (None, Some(0.0)));
    assert_eq!(straight.jump_between(0.0, 1.0), Some(0.3));
    let bent = heights(&[0.0, 0.1, 0.2, 0.3], &[1.0, 1.1, 1.2, 1.31], Interpolation::Linear);
    assert_eq!(bent.jump_between(0.0, 0.3), Some(0.2));
    assert_eq!(heights(&[0.0, 0.1, 0.2], &[0.0, 1.0, 5.0], Interpolation::Spline).jump_between(-1.0, 1.0), None);
    let (at, after) = (bent.from_pose(&Pose::IDENTITY), 0.25);
    assert!((at.velocity(after).linear.z - 1.1).abs() < 1e-12 && at.acceleration(after).linear == DVec3::ZERO);
}

/// A table of any numbers that is accepted gives finite poses, velocities and accelerations.
#[test]
fn extreme_tables_stay_finite() {
    let tables = [
        (vec![-1e99, 0.0, 1e99], vec![DVec3::ZERO, DVec3::X * 1e99, DVec3::ZERO]),
        (vec![0.0, 1e-20, 1e20], vec![DVec3::ZERO, DVec3::X * 1e-20, DVec3::ZERO]),
        (vec![1e15, 1e15 + 1.0, 2e15], vec![DVec3::splat(1e99); 3]),
    ];
    for (times_s, positions) in tables {
        let positions_m = Some(positions);
        let table = MotionTable { times_s: times_s.clone(), positions_m, ..MotionTable::default() };
        let trajectory = PrescribedMotion::table(&table).unwrap().from_pose(&Pose::IDENTITY);
        for pair in times_s.windows(2) {
            let t = 0.5 * (pair[0] + pair[1]);
            assert!(trajectory.pose(t).is_finite() && trajectory.velocity(t).is_finite());
            assert!(trajectory.acceleration(t).linear.is_finite());
        }
    }
}

fn shaker() -> PrescribedMotion {
    PrescribedMotion::sine(DVec3::Z * 0.1, DVec3::ZERO, 5.0, 0.0).unwrap()
}

fn build(body: Body) -> Result<Scene, SceneError> {
    Scene::builder("kinematic").body(body).build()
}

/// A kinematic body has neither velocity nor pivot nor mass of its own. It may have any shape that a fixed body may
/// have, and collides only with bodies that forces move.
#[test]
fn kinematic_bodies() {
    let body = || Body::kinematic("table", shaker());
    assert!(body().is_fixed() && body().mass_properties().is_none() && body().motion().is_some());
    let fast = body().velocity(Velocity::new(DVec3::X, DVec3::ZERO));
    assert_eq!(build(fast).unwrap_err(), SceneError::KinematicBodyHasVelocity("table".to_owned()));
    assert_eq!(build(body().pivot(DVec3::X)).unwrap_err(), SceneError::KinematicBodyPivots("table".to_owned()));
    let surface = Shape::triangle_mesh(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]]).unwrap();
    for shape in [Shape::half_space(UnitVector::Z), surface, Shape::sphere(1.0).unwrap()] {
        let scene = Scene::builder("shapes")
            .body(floor())
            .body(body().geometry(Geometry::Shape(shape)))
            .body(ball("ball", 1.0, 0.5, DVec3::Z * 5.0, DVec3::ZERO))
            .build()
            .unwrap();
        assert!(
            !scene.can_collide(BodyId::new(0), BodyId::new(1)) && scene.can_collide(BodyId::new(1), BodyId::new(2))
        );
    }
}

/// A table gives the pose of the body. A pose that is given as well must be that of the table at t = 0, to the digits
/// of a scene file.
#[test]
fn tables_and_initial_poses() {
    let motion = PrescribedMotion::table(&table()).unwrap();
    let start = motion.from_pose(&Pose::IDENTITY).pose(0.0);
    let body = || Body::kinematic("table", motion.clone());
    assert_eq!(*body().initial_pose(), start);
    assert!(build(body()).is_ok());
    let typed = Pose { translation: start.translation + DVec3::X * 1e-9, ..start };
    assert!(build(body().pose(typed)).is_ok());
    assert_eq!(body().pose(typed).trajectory().unwrap().pose(0.0), start);
    let aside = Pose { translation: start.translation + DVec3::X, ..start };
    let refused = build(body().pose(aside)).unwrap_err();
    assert!(matches!(&refused, SceneError::Motion { source: MotionError::Start { quantity: "position", .. }, .. }));
    let askew = Pose { rotation: turned(0.0, 0.0, 0.1) * start.rotation, ..start };
    let refused = build(body().pose(askew)).unwrap_err();
    assert!(refused.to_string().contains("the orientation given differs by 1.00e-1 rad"), "{refused}");
    // A table without orientations leaves the orientation of the initial pose free.
    let moved = PrescribedMotion::table(&MotionTable { orientations: None, ..table() }).unwrap();
    let upright = Pose { translation: start.translation, ..initial() };
    assert!(build(Body::kinematic("table", moved).pose(upright)).is_ok());
    let nowhere = Pose { translation: DVec3::X * f64::NAN, ..start };
    assert!(matches!(build(body().pose(nowhere)).unwrap_err(), SceneError::NotFinite { .. }));
}

/// A spring cannot be fastened to a kinematic body yet: the scene is refused with an error that says so.
#[test]
fn springs_on_kinematic_bodies() {
    let spring = Force::Spring {
        a: Attachment::Body { body: BodyId::new(0), point: DVec3::ZERO },
        b: Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO },
        stiffness: 1.0,
        rest_length: 1.0,
        damping: 0.0,
    };
    let scene = Scene::builder("spring")
        .body(Body::kinematic("table", shaker()))
        .body(ball("ball", 1.0, 0.5, DVec3::Z * 5.0, DVec3::ZERO))
        .force(spring)
        .build();
    assert!(matches!(scene.unwrap_err(), SceneError::NotYetAvailable { .. }));
}
