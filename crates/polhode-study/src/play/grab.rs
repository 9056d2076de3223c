//! The spring by which a body is held at a point and drawn to another one.
//!
//! The spring pulls with `F = -k x - c v`, x: from the hand to the point (m), v: the velocity of the point (m/s), with
//! `k = m w^2` and `c = 2 m w` for a body of mass m (kg): critically damped at the rate w (rad/s), whatever the mass.
//! The force is constant over a step of length h, and taken at its end, so that no step is too long for it:
//!
//! ```text
//! (1 + h (c + h k) K) F = -k x - (c + h k) v,   K = 1/m + [r]^T I^-1 [r]
//! ```
//!
//! A body that hangs at rest stretches it by `g (1/w + h)^2` (m), g: gravity (m/s^2).
//! K: the inverse mass of the point (1/kg), r: from the centre of mass to it (m), I: inertia about the centre of mass
//! (kg m^2). Source: Catto, Soft Constraints, Game Developers Conference 2011.

use polhode::spatial::{DMat3, DVec3, MassProperties, Pose};
use polhode::{BodyId, BodySample};
use std::f64::consts::TAU;

/// Rate of the spring, rad/s (6 to 60): a hand that stops is followed within a quarter of a second.
const RATE: f64 = 2.0 * TAU;

/// A body that is held at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grab {
    /// The body.
    pub body: BodyId,
    /// Where it is held, in its own frame, m.
    pub point_m: DVec3,
    /// Where the hand is, world, m.
    pub hand_m: DVec3,
}

impl Grab {
    /// The point at which a body in this pose is held, world, m.
    pub fn held_m(&self, pose: &Pose) -> DVec3 {
        pose.transform_point(self.point_m)
    }

    /// Force (N) and torque about the centre of mass (N m) on a body in this state, for a step of `h_s` (s).
    pub fn load(&self, own: &MassProperties, state: &BodySample, h_s: f64) -> [DVec3; 2] {
        let arm = state.pose.rotation.rotate(self.point_m - own.center_of_mass());
        let stretch = self.held_m(&state.pose) - self.hand_m;
        let velocity = state.velocity.linear + state.velocity.angular.cross(arm);
        let (stiffness, damping) = (own.mass() * RATE * RATE, 2.0 * own.mass() * RATE);
        let lead = damping + h_s * stiffness;
        let matrix = DMat3::IDENTITY + inverse_mass(own, &state.pose, arm) * (h_s * lead);
        let force = matrix.inverse() * (stretch * -stiffness - velocity * lead);
        [force, arm.cross(force)]
    }
}

/// The inverse mass of a point of a body, at `arm` (m, world) from its centre of mass, 1/kg.
fn inverse_mass(own: &MassProperties, pose: &Pose, arm: DVec3) -> DMat3 {
    let inverse = own.inertia().rotated(pose.rotation).matrix().inverse();
    let cross = DMat3::from_cols(
        DVec3::new(0.0, arm.z, -arm.y),
        DVec3::new(-arm.z, 0.0, arm.x),
        DVec3::new(arm.y, -arm.x, 0.0),
    );
    DMat3::from_diagonal(DVec3::splat(own.mass().recip())) + cross.transpose() * inverse * cross
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
mod tests {
    //! The force is that of the spring for short steps; a long step does not overshoot.
    use super::*;
    use polhode::spatial::{Inertia, Mass, Velocity};

    fn body() -> MassProperties {
        let inertia = Inertia::from_diagonal(DVec3::new(0.02, 0.03, 0.04)).unwrap();
        MassProperties::new(Mass::new(2.0).unwrap(), DVec3::ZERO, inertia)
    }

    fn still() -> BodySample {
        BodySample { pose: Pose::IDENTITY, velocity: Velocity::ZERO }
    }

    #[test]
    fn the_force_of_a_short_step_is_that_of_the_spring() {
        let grab = Grab { body: BodyId::new(0), point_m: DVec3::X * 0.1, hand_m: DVec3::new(0.1, 0.0, 0.3) };
        let [force, torque] = grab.load(&body(), &still(), 1e-12);
        let expected = DVec3::Z * (2.0 * RATE * RATE * 0.3);
        assert!((force - expected).length() < 1e-6 * expected.length());
        assert!((torque - (DVec3::X * 0.1).cross(force)).length() < 1e-9);
    }

    #[test]
    fn the_point_does_not_pass_the_hand_in_a_long_step() {
        let grab = Grab { body: BodyId::new(0), point_m: DVec3::X * 0.1, hand_m: DVec3::new(0.1, 0.0, 0.3) };
        for h_s in [1e-3, 0.01, 0.1, 1.0] {
            let [force, _] = grab.load(&body(), &still(), h_s);
            let moved = h_s * h_s * (inverse_mass(&body(), &Pose::IDENTITY, DVec3::X * 0.1) * force);
            assert!(moved.z > 0.0 && moved.z <= 0.3 && moved.x.abs() < 1e-12, "{h_s}: {moved}");
        }
    }
}
