//! What a body knows of itself: inverses, angular velocity and momentum, energy; and the flat layout of its state.

use crate::support::{body, cases, direction, moments, rotation, turned_body};
use glam::{DMat3, DVec3};
use polhode_dynamics::state::{self, WIDTH};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use proptest::prelude::*;

/// A needle a million times thinner than long: spun about its own axis it has that axis' energy, to round-off.
#[test]
fn needle_keeps_the_digits_of_its_small_moment() {
    let axes = Rotation::from_rotation_vector(DVec3::new(0.3, -0.7, 0.2));
    let needle = turned_body(1.0, DVec3::new(1e-6, 1.0, 1.0), axes);
    let axis = axes.rotate(DVec3::X);
    let smallest = needle.principal().moments().x;
    let product = needle.inverse_inertia() * axis;
    assert!((product * smallest - axis).length() < 1e-15 * 1e6);
    assert!((needle.inverse_inertia() - needle.inverse_inertia().transpose()).abs_diff_eq(DMat3::ZERO, 0.0));
    // Multiplied out, the inverse undoes the inertia as well as the condition number allows.
    assert!((needle.inertia() * needle.inverse_inertia()).abs_diff_eq(DMat3::IDENTITY, 1e-16 * 1e6));
}

/// A body with a diagonal inertia in any order keeps its own axes: a spin about one of them is exactly one.
#[test]
fn diagonal_inertia_keeps_the_axes_of_the_body() {
    let brick = body(2.0, DVec3::new(3.0, 1.0, 2.0));
    assert_eq!(brick.axes(), Rotation::IDENTITY);
    assert_eq!(brick.inverse_inertia(), DMat3::from_diagonal(DVec3::new(1.0 / 3.0, 1.0, 0.5)));
    assert_eq!(brick.principal().moments(), DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(brick.inverse_mass(), 0.5);
    let state = brick.at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, DVec3::Z * 5.0));
    assert_eq!(state.angular_momentum, DVec3::Z * 10.0);
    assert_eq!(brick.angular_velocity(&state), DVec3::Z * 5.0);
    assert_eq!(brick.kinetic_energy(&state), 25.0);
}

#[test]
fn slices_of_another_length_are_refused() {
    let numbers = BodyState::default().to_array();
    let error = BodyState::from_slice(&numbers[..12]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a body's state takes 13 numbers, the slice has 12: pass the slice from the body's offset on"
    );
    assert!(BodyState::default().write_to_slice(&mut [0.0; 3]).is_err());
    assert!(
        BodyState::from_slice(&[0.0; 20]).is_ok_and(|state| !state.is_finite()),
        "a zero quaternion is no rotation"
    );
}

/// Normalising a state of two bodies touches their quaternions alone.
#[test]
fn normalize_restores_quaternions() {
    let mut numbers: Vec<f64> = (0..2 * WIDTH).map(|k| k as f64 + 1.0).collect();
    let before = numbers.clone();
    state::normalize(&mut numbers);
    for body in 0..2 {
        let q = &numbers[13 * body + 3..13 * body + 7];
        assert!((q.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-15);
        assert!((q[3] / q[0] - before[13 * body + 6] / before[13 * body + 3]).abs() < 1e-15);
        assert_eq!(numbers[13 * body..13 * body + 3], before[13 * body..13 * body + 3]);
        assert_eq!(numbers[13 * body + 7..13 * body + 13], before[13 * body + 7..13 * body + 13]);
    }
}

proptest! {
    #![proptest_config(cases(256))]

    /// Velocity to state and back; energy as `(m v^2 + w . L)/2`; world inverse of inertia as `R I^-1 R^T`.
    #[test]
    fn velocity_and_state_agree(
        i in moments(2.0), axes in rotation(), r in rotation(), v in direction(), w in direction(),
    ) {
        let body = turned_body(0.7, i, axes);
        let velocity = Velocity::new(v, w);
        let state = body.at_velocity(Pose::new(r, DVec3::new(1.0, 2.0, 3.0)), velocity);
        let ratio = i.max_element() / i.min_element();
        prop_assert!((body.velocity(&state).angular - w).length() < 4e-16 * ratio + 1e-14);
        let energy = 0.5 * (0.7 * v.length_squared() + w.dot(state.angular_momentum));
        prop_assert!((body.kinetic_energy(&state) / energy - 1.0).abs() < 1e-14 + 4e-16 * ratio);
        let by_matrix = body.inverse_inertia_world(r) * state.angular_momentum;
        prop_assert!((by_matrix - w).length() < 1e-14 * ratio);
        prop_assert_eq!(BodyState::from_array(&state.to_array()), state);
    }

    /// The inertia that comes back is the one that went in.
    #[test]
    fn inverse_undoes_inertia(i in moments(2.0), axes in rotation()) {
        let inertia = Inertia::from_diagonal(i).unwrap().rotated(axes);
        let body = RigidBody::new(&MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia));
        let ratio = i.max_element() / i.min_element();
        prop_assert!((body.inertia() * body.inverse_inertia()).abs_diff_eq(DMat3::IDENTITY, 4e-15 * ratio));
        prop_assert_eq!(body.inertia(), inertia.matrix());
    }
}
