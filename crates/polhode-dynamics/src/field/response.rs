//! How a field's force changes with small motions of the bodies it acts on: what an implicit step needs to know.
//!
//! Near the present states the force at an end is `F - K dx - D dv`, with the displacement dx (m) and the change of
//! velocity dv (m/s) of the point at which it acts, against that of the other end. K and D are symmetric and have no
//! negative eigenvalue: a part of the true derivative that would make the motion unstable (a spring that is compressed
//! buckles aside) is left out, and remains in the force that is evaluated at the next step.

use glam::{DMat3, DVec3};

/// How a velocity decays under the force alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decay {
    /// By a constant fraction in equal times: the force is linear in the velocity.
    Exponential,
    /// As `1/(1 + t/T)`: the force is quadratic in the velocity.
    Hyperbolic,
}

/// The point of a body at which a force acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResponseEnd {
    /// Index of the body.
    pub body: usize,
    /// From the origin of its moving frame, m, world.
    pub arm: DVec3,
}

/// The response of one force, which acts at the first end and oppositely at the second one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceResponse {
    /// Where it acts; none for an end in the world.
    pub ends: [Option<ResponseEnd>; 2],
    /// K, N/m, world.
    pub stiffness: DMat3,
    /// D, N s/m, world.
    pub damping: DMat3,
    /// The torque about the origin of each body that turns with the body against it, N m/rad: of a force that pulls
    /// outwards at an arm. A bound, the same in all directions.
    pub rotational_stiffness: [f64; 2],
    /// As D, of a torque on the first body with its angular velocity, N m s, world.
    pub rotational_damping: DMat3,
    /// How velocities decay under the damping.
    pub decay: Decay,
}

impl ForceResponse {
    /// A force at these ends that does not respond to anything.
    pub const fn none(ends: [Option<ResponseEnd>; 2]) -> Self {
        Self {
            ends,
            stiffness: DMat3::ZERO,
            damping: DMat3::ZERO,
            rotational_stiffness: [0.0; 2],
            rotational_damping: DMat3::ZERO,
            decay: Decay::Exponential,
        }
    }
}

/// `a b^T`.
pub(super) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
