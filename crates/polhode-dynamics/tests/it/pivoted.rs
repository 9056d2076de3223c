//! Pivoted bodies: what they know of themselves, energy, pendulum.

use crate::support::{cases, dop853, moments, rotation};
use glam::DVec3;
use polhode_dynamics::integrator::{Exact, Integrator, event};
use polhode_dynamics::{BodyState, Flight, FreeMotion, RigidBody, energy, momentum};
use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use proptest::prelude::*;

fn vector(size: f64) -> impl Strategy<Value = DVec3> {
    [-size..size, -size..size, -size..size].prop_map(DVec3::from_array)
}

proptest! {
    #![proptest_config(cases(32))]

    /// A pivoted body and the same body free, moving as the pivot makes it: energies, momenta and velocities agree.
    #[test]
    fn pivoted_body_is_a_free_body_that_turns_about_the_pivot(
        moments in moments(1.0), attitude in rotation(), mass in 0.1..10.0f64,
        center in vector(1.0), pivot in vector(1.0), place in vector(3.0), spin in vector(4.0),
    ) {
        let inertia = Inertia::from_diagonal(moments).unwrap();
        let properties = MassProperties::new(Mass::new(mass).unwrap(), center, inertia);
        let (pivoted, free) = (RigidBody::pivoted(&properties, pivot), RigidBody::new(&properties));
        prop_assert!(pivoted.is_pivoted() && !free.is_pivoted());
        prop_assert_eq!((pivoted.inverse_mass(), pivoted.mass()), (0.0, mass));
        prop_assert_eq!((pivoted.arm(), free.arm()), (center - pivot, DVec3::ZERO));
        let lever = attitude.rotate(center - pivot);
        let turning = pivoted.at_velocity(Pose::new(attitude, place), Velocity::new(DVec3::ZERO, spin));
        let velocity = Velocity::new(spin.cross(lever), spin);
        let flying = free.at_velocity(Pose::new(attitude, place + lever), velocity);
        prop_assert!((pivoted.center_of_mass_position(&turning) - flying.pose.translation).length() < 1e-14);
        prop_assert!((pivoted.center_of_mass_velocity(&turning).linear - velocity.linear).length() < 1e-13);
        prop_assert_eq!(free.center_of_mass_velocity(&flying), free.velocity(&flying));
        let g = DVec3::new(0.3, -0.2, -9.81);
        let (e, f) = (energy::total_energy(&pivoted, &turning, g), energy::total_energy(&free, &flying, g));
        prop_assert!((e - f).abs() < 1e-12 * (1.0 + pivoted.kinetic_energy(&turning)), "{} {}", e, f);
        let about = DVec3::new(1.0, -2.0, 0.5);
        let l = momentum::angular_momentum_about(about, &pivoted, &turning);
        let m = momentum::angular_momentum_about(about, &free, &flying);
        prop_assert!((l - m).length() < 1e-12 * (1.0 + l.length() + turning.angular_momentum.length()));
        let p = momentum::linear_momentum(&pivoted, &turning) - momentum::linear_momentum(&free, &flying);
        prop_assert!(p.length() < 1e-12);
    }
}

/// Complete elliptic integral K by the arithmetic-geometric mean, from `1 - k^2`.
fn quarter_period(mc: f64) -> f64 {
    let (mut a, mut b) = (1.0, mc.sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    std::f64::consts::FRAC_PI_2 / a
}

/// A physical pendulum swinging 120 degrees to either side has the period `4 sqrt(I/(m g l)) K(sin(theta/2))`.
#[test]
fn pendulum_has_the_period_of_the_elliptic_integral() {
    let inertia = Inertia::from_diagonal(DVec3::new(0.3, 0.4, 0.2)).unwrap();
    let properties = MassProperties::new(Mass::new(2.0).unwrap(), DVec3::NEG_Z * 0.7, inertia);
    let body = RigidBody::pivoted(&properties, DVec3::ZERO);
    let bodies = [body];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &[]);
    let swing = 120f64.to_radians();
    let start = BodyState::at_rest(Pose::new(Rotation::from_rotation_vector(DVec3::X * swing), DVec3::ZERO));
    let k2 = (0.5 * swing).sin().powi(2);
    let about_pivot = 0.3 + 2.0 * 0.7 * 0.7;
    let period = 4.0 * f64::sqrt(about_pivot / (2.0 * 9.81 * 0.7)) * quarter_period(1.0 - k2);
    let methods: [(Box<dyn Integrator>, f64); 2] =
        [(Box::new(dop853(1e-13)), 0.2), (Box::new(Exact::blanes_moan()), 1e-3)];
    for (mut method, step) in methods {
        method.start(&motion, 0.0, &[start]);
        let mut lowest = Vec::new();
        while lowest.len() < 3 {
            let from = method.time();
            method.step(&motion, step).unwrap();
            let side = &mut |_: f64, states: &[BodyState]| states[0].pose.rotation.rotate(DVec3::Z).y;
            lowest.extend(event::locate(&mut *method, &motion, from, side).unwrap());
        }
        assert!((lowest[0] / (0.25 * period) - 1.0).abs() < 1e-11, "{lowest:?} {period}");
        assert!((lowest[2] / (1.25 * period) - 1.0).abs() < 1e-11, "{lowest:?} {period}");
        let drift = motion.total_energy(method.states()) - motion.total_energy(&[start]);
        assert!(drift.abs() < 1e-10, "{drift:e}");
    }
}

/// A rotor held at its centre of mass (gimbals) feels no torque of gravity: its motion is its flight under no gravity.
#[test]
fn rotor_on_gimbals_flies_by_its_record() {
    let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0)).unwrap();
    let properties = MassProperties::new(Mass::new(2.0).unwrap(), DVec3::new(0.1, 0.2, 0.3), inertia);
    let rotor = RigidBody::pivoted(&properties, properties.center_of_mass());
    let bodies = [rotor];
    let motion = FreeMotion::new(&bodies, DVec3::NEG_Z * 9.81, &[]);
    assert!(!motion.has_loads());
    let start =
        rotor.at_velocity(Pose::from_translation(DVec3::ONE), Velocity::new(DVec3::X, DVec3::new(0.1, 2.0, 0.1)));
    assert_eq!(start.linear_velocity, DVec3::ZERO, "the pivot stays");
    let mut method = Exact::blanes_moan();
    method.start(&motion, 1.0, &[start]);
    method.step(&motion, 30.0).unwrap();
    assert_eq!(method.states()[0], Flight::new(&rotor, 1.0, &start, DVec3::ZERO).state(31.0));
}
