//! Flight records: parabola, sameness of bits, bounds that hold.

use crate::support::{bits, body, body_rate, cases, direction, moments, rotation, spin, turned_body};
use glam::DVec3;
use polhode_dynamics::{BodyState, Flight};
use polhode_spatial::{Motion, Pose, Rotation, Velocity};
use proptest::prelude::*;

/// The centre of mass of a tumbling body runs along Galilei's parabola.
#[test]
fn center_of_mass_runs_along_a_parabola() {
    let body = body(3.0, DVec3::new(1.0, 2.0, 2.5));
    let start = body.at_velocity(
        Pose::new(Rotation::IDENTITY, DVec3::new(1.0, 2.0, 3.0)),
        Velocity::new(DVec3::new(4.0, 0.0, 10.0), DVec3::new(1.0, 2.0, 3.0)),
    );
    let flight = Flight::new(&body, 2.0, &start, DVec3::new(0.0, 0.0, -10.0));
    let state = flight.state(3.5);
    assert_eq!(state.pose.translation, DVec3::new(7.0, 2.0, 3.0 + 15.0 - 11.25));
    assert_eq!(state.linear_velocity, DVec3::new(4.0, 0.0, -5.0));
    assert_eq!(state.angular_momentum, start.angular_momentum);
}

/// Six thousand samples of a flight, taken in any order or alone, have the same bits at the same times; at the record's
/// time they are the record.
#[test]
fn samples_do_not_depend_on_what_was_asked_before() {
    let (_, flight) = spin(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.01, 2.0, 0.01));
    let times: Vec<f64> = (0..6000).map(|k| f64::from(k) / 60.0).collect();
    let forward: Vec<_> = times.iter().map(|&t| bits(&flight.state(t))).collect();
    for (k, &t) in times.iter().enumerate().rev() {
        assert_eq!(bits(&flight.state(t)), forward[k]);
    }
    let again = Flight::new(&body(1.0, DVec3::new(1.0, 2.0, 3.0)), 0.0, flight.start(), DVec3::ZERO);
    assert_eq!(bits(&again.state(times[4321])), forward[4321]);
    assert_eq!(bits(&flight.state(0.0)), bits(flight.start()));
}

/// Flights evaluated together have the bits that each has alone: by the series, by elliptic functions over half periods
/// too, next to the separatrix and on it, steady, and in groups that do not come out even.
#[test]
fn many_flights_have_the_bits_of_each_alone() {
    let moments = DVec3::new(1.0, 2.0, 3.0);
    let nearly = [0.0, 1e-12, 1e-7, 1e-3, 0.05, 0.3, 1.0, 2.5];
    let spins = nearly.into_iter().flat_map(|x| {
        let about =
            [DVec3::new(x, 2.0, 0.5 * x), DVec3::new(3.0, x, 0.2), DVec3::new(0.1 * x, x, 1.5), DVec3::splat(x)];
        // On the separatrix 2 T I2 = L^2, which for these moments is p1 = p3.
        about.into_iter().chain([DVec3::new(x, 1.0, x / 3.0)])
    });
    let flights: Vec<Flight> = spins.map(|spin_rad_s| spin(moments, spin_rad_s).1).collect();
    for t in [0.0, 1e-9, 0.02, 0.3, 0.9, 4.0, 77.0, -3.0] {
        for count in [0, 1, 3, 4, 7, flights.len()] {
            let mut states = vec![BodyState::default(); count];
            // One place more than there is.
            let of = flights.iter().take(count + 1).enumerate();
            Flight::write_states(of, t, &mut states);
            for (k, state) in states.iter().enumerate() {
                assert_eq!(bits(state), bits(&flights[k].state(t)), "t = {t}, flight {k} of {count}");
            }
        }
    }
}

/// A spin about a principal axis of the body stays one to the last bit, and its angular acceleration is bounded by
/// zero.
#[test]
fn principal_spin_is_bounded_exactly() {
    for axis in DVec3::AXES {
        let (body, flight) = spin(DVec3::new(3.0, 1.0, 2.0), axis * 7.0);
        let bounds = flight.bounds(0.0, 5.0);
        assert_eq!(bounds.angular_acceleration, 0.0);
        assert!((bounds.angular_speed / 7.0 - 1.0).abs() < 1e-13);
        for t in [0.1, 1.0, 100.0] {
            assert!((body_rate(&body, &flight.state(t)) - axis * 7.0).length() < 1e-13);
        }
    }
    let (_, ball) = spin(DVec3::splat(0.4), DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(ball.bounds(0.0, 1.0).angular_acceleration, 0.0);
}

/// The bound of the angular speed is reached: it is no larger than the largest speed by more than rounding.
#[test]
fn bound_of_the_angular_speed_is_reached() {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 2.5), DVec3::new(1.0, 0.3, -0.8));
    let period = flight.rotation().period().unwrap();
    let rates = (0..20_000).map(|k| flight.velocity(period * f64::from(k) / 20_000.0).angular.length());
    let largest = rates.fold(0.0, f64::max);
    let bound = flight.bounds(0.0, period).angular_speed;
    assert!(largest <= bound && bound < largest * (1.0 + 1e-6), "{largest} of {bound}");
    // Euler's equations at the samples stay below the bound of the acceleration, and come within a factor of two.
    let accelerations = (0..2000).map(|k| {
        let w = body_rate(&body, &flight.state(period * f64::from(k) / 2000.0));
        DVec3::new(-0.5 * w.y * w.z, 1.5 / 2.0 * w.z * w.x, -1.0 / 2.5 * w.x * w.y).length()
    });
    let largest = accelerations.fold(0.0, f64::max);
    let bound = flight.bounds(0.0, period).angular_acceleration;
    assert!(largest <= bound && bound <= 2.0 * largest, "{largest} of {bound}");
}

/// What is not finite comes back as NaN, with no panic.
#[test]
fn numbers_that_are_not_finite_come_back() {
    let body = body(1.0, DVec3::new(1.0, 2.0, 3.0));
    let state = BodyState { angular_momentum: DVec3::splat(f64::NAN), ..BodyState::default() };
    let flight = Flight::new(&body, 0.0, &state, DVec3::ZERO);
    assert!(!flight.state(1.0).is_finite());
    let flight = Flight::new(&body, f64::INFINITY, &BodyState::default(), DVec3::Z);
    assert!(!flight.state(1.0).is_finite());
    let _ = flight.bounds(f64::NAN, 1.0);
}

proptest! {
    #![proptest_config(cases(200))]

    /// At every time the speeds are within the bounds, and between any two times pose and velocity have changed by no
    /// more than the bounds allow.
    #[test]
    fn bounds_are_never_exceeded(
        (i, axes) in (moments(1.5), rotation()),
        (r, v, l, g) in (rotation(), direction(), direction(), direction()),
        start in -3.0..3.0f64, length in 0.0..5.0f64, parts in prop::collection::vec(0.0..1.0f64, 12),
    ) {
        let body = turned_body(1.0, i, axes);
        let angular_momentum = l * i.min_element() * 2.0;
        let state = BodyState { pose: Pose::new(r, v), linear_velocity: v * 2.0, angular_momentum };
        let flight = Flight::new(&body, 0.0, &state, g * 9.81);
        let bounds = flight.bounds(start, start + length);
        let samples: Vec<_> = parts.iter().map(|p| {
            let t = start + p * length;
            (t, flight.state(t), flight.velocity(t))
        }).collect();
        for (t, a, va) in &samples {
            prop_assert!(va.linear.length() <= bounds.speed);
            prop_assert!(va.angular.length() <= bounds.angular_speed);
            for (u, b, vb) in &samples {
                let s = (t - u).abs();
                let near = |x: f64, limit: f64| x <= limit * (1.0 + 1e-12) + 1e-13;
                prop_assert!(near((a.pose.translation - b.pose.translation).length(), bounds.speed * s));
                prop_assert!(near(a.pose.rotation.angle_to(b.pose.rotation), bounds.angular_speed * s));
                prop_assert!(near((va.linear - vb.linear).length(), bounds.acceleration * s));
                prop_assert!(near((va.angular - vb.angular).length(), bounds.angular_acceleration * s));
            }
        }
    }
}

/// A body that is thrown spinning about its middle axis, turned so that rounding leaves the axis: the steady record
/// keeps the spin for ever, as a motion in a plane must, while the general one shows the instability of the axis.
#[test]
fn steady_record_keeps_the_spin_about_the_middle_axis() {
    let body = body(1.0, DVec3::new(1.0, 2.0, 3.0));
    let turn = Rotation::from_rotation_vector(DVec3::new(0.4, -0.7, 0.2));
    let spin = turn.rotate(DVec3::Y) * 3.0;
    let state = body.at_velocity(Pose::new(turn, DVec3::ZERO), Velocity::new(DVec3::X, spin));
    let steady = Flight::steady(&body, 0.0, &state, DVec3::ZERO);
    for t in [1.0, 30.0, 1000.0] {
        let exact = Rotation::from_rotation_vector(spin * t) * turn;
        assert!(steady.pose(t).rotation.angle_to(exact) < 1e-15 * 3.0 * t + 1e-14, "t = {t}");
    }
}
