//! What the tests share.

use glam::{DQuat, DVec3};
use polhode_dynamics::integrator::{AdaptiveDop853, Tolerance};
use polhode_dynamics::{BodyState, Flight, RigidBody};
use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A body with the given principal moments along its axes.
pub(crate) fn body(mass: f64, moments: DVec3) -> RigidBody {
    let inertia = Inertia::from_diagonal(moments).unwrap();
    RigidBody::new(&MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia))
}

/// A body whose principal axes are turned by `axes` against the body's.
pub(crate) fn turned_body(mass: f64, moments: DVec3, axes: Rotation) -> RigidBody {
    let inertia = Inertia::from_diagonal(moments).unwrap().rotated(axes);
    RigidBody::new(&MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia))
}

/// Free rotation of `moments` from the identity with angular velocity `w0`, as a flight without gravity.
pub(crate) fn spin(moments: DVec3, w0: DVec3) -> (RigidBody, Flight) {
    let body = body(1.0, moments);
    let start = body.at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, w0));
    (body, Flight::new(&body, 0.0, &start, DVec3::ZERO))
}

/// DOP853 under error control.
pub(crate) fn dop853(tolerance: f64) -> AdaptiveDop853 {
    AdaptiveDop853::new(Tolerance::new(tolerance).unwrap())
}

/// Angular velocity in body axes.
pub(crate) fn body_rate(body: &RigidBody, state: &BodyState) -> DVec3 {
    state.pose.rotation.inverse_rotate(body.angular_velocity(state))
}

/// Largest difference of the components of two quaternions, given either sign (scalar first).
pub(crate) fn quaternion_error(rotation: Rotation, reference: [f64; 4]) -> f64 {
    let [w, x, y, z] = reference;
    let (q, r) = (rotation.quaternion(), DQuat::from_xyzw(x, y, z, w));
    let largest = |d: DQuat| [d.x, d.y, d.z, d.w].iter().fold(0.0f64, |m, c| m.max(c.abs()));
    largest(q - r).min(largest(q + r))
}

/// Bits of a state, for tests of sameness.
pub(crate) fn bits(state: &BodyState) -> [u64; 13] {
    state.to_array().map(f64::to_bits)
}

/// Moments of a physical body: any order, the largest ratio `10^spread`.
pub(crate) fn moments(spread: f64) -> impl Strategy<Value = DVec3> {
    // Moments are sums of two of three positive numbers (the integrals of x^2, y^2, z^2), so the triangle inequality
    // holds by construction.
    [-spread..0.0f64, -spread..0.0, -spread..0.0].prop_map(|e| {
        let [a, b, c] = e.map(|e| 10f64.powf(e));
        DVec3::new(b + c, c + a, a + b)
    })
}

/// A direction.
pub(crate) fn direction() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0f64, -1.0..1.0, -1.0..1.0]
        .prop_map(DVec3::from_array)
        .prop_filter("needs a direction", |v| v.length() > 0.1)
        .prop_map(DVec3::normalize)
}

/// Any rotation.
pub(crate) fn rotation() -> impl Strategy<Value = Rotation> {
    (direction(), -3.2..3.2f64).prop_map(|(axis, angle)| Rotation::from_rotation_vector(axis * angle))
}

/// Property tests with the same numbers in every run, so that a failure can be run again and a pass means the same
/// everywhere.
pub(crate) fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(20_240_607),
        ..ProptestConfig::default()
    }
}

/// Slope between the errors of two step sizes, one half of the other.
pub(crate) fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}
