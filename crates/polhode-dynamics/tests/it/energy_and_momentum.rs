//! Energy and momentum of flights: conserved where they must be, and covariant under a change of reference point.

use crate::support::{cases, direction, moments, rotation, turned_body};
use glam::DVec3;
use polhode_dynamics::energy::{potential_energy, total_energy};
use polhode_dynamics::momentum::{angular_momentum_about, linear_momentum};
use polhode_dynamics::{BodyState, Flight};
use polhode_spatial::Pose;
use proptest::prelude::*;

#[test]
fn potential_energy_is_zero_at_the_origin() {
    let gravity = DVec3::new(0.0, 0.0, -9.81);
    assert_eq!(potential_energy(2.0, gravity, DVec3::new(5.0, 5.0, 0.0)), 0.0);
    assert_eq!(potential_energy(2.0, gravity, DVec3::new(0.0, 0.0, 3.0)), 2.0 * 9.81 * 3.0);
}

proptest! {
    #![proptest_config(cases(100))]

    /// A throw under gravity keeps T + V; without gravity it keeps momentum and angular momentum about any point.
    #[test]
    fn flights_conserve(
        (i, axes) in (moments(1.5), rotation()),
        (r, x, v, l) in (rotation(), direction(), direction(), direction()),
        point in direction(), t in -10.0..10.0f64,
    ) {
        let body = turned_body(1.3, i, axes);
        let angular_momentum = l * i.max_element();
        let start = BodyState { pose: Pose::new(r, x * 4.0), linear_velocity: v * 3.0, angular_momentum };
        let gravity = DVec3::new(0.1, -0.2, -9.81);
        let end = Flight::new(&body, 0.5, &start, gravity).state(0.5 + t);
        let (before, after) = (total_energy(&body, &start, gravity), total_energy(&body, &end, gravity));
        // The energy's error is relative to its largest parts, which the fall makes.
        let potential = potential_energy(1.3, gravity, end.pose.translation).abs();
        let scale = body.kinetic_energy(&end) + body.kinetic_energy(&start) + potential;
        prop_assert!((after - before).abs() < 1e-13 * scale, "{before} became {after}");

        let end = Flight::new(&body, 0.5, &start, DVec3::ZERO).state(0.5 + t);
        prop_assert_eq!(linear_momentum(&body, &end), linear_momentum(&body, &start));
        let about = |s| angular_momentum_about(point, &body, s);
        prop_assert!((about(&end) - about(&start)).length() < 1e-12 * (1.0 + about(&start).length()));
    }
}
