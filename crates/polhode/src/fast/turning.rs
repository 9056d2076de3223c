//! Free rotation over a substep: explicit, of second order, with the angular momentum kept to the last bit.
//!
//! ```text
//! q_1/2 = exp(h w_0 / 2) q_0,  w_1/2 = R_1/2 I^-1 R_1/2^T L,  q_1 = exp(h w_1/2) q_0
//! ```
//!
//! `L` (kg m^2/s, world) does not change without a torque, and the energy stays between `L^2 / 2 I_max` and
//! `L^2 / 2 I_min`: no step makes the rotation unstable. Source: the midpoint rule on the Lie group,
//! docs/REFERENCES.md, Hairer, Lubich and Wanner, IV.8. Assumption: less than half a turn in a substep; beyond, the
//! rotation is not followed, but stays bounded.

use polhode_dynamics::RigidBody;
use polhode_spatial::{DQuat, DVec3, Rotation};

/// The square of half the angle of a turn below which the tangent is its series (rad^2): the next term is below
/// rounding.
const SMALL_SQUARE: f64 = 1e-3;

/// The rotation after `h` (s) of turning at `w` (rad/s).
///
/// The quaternion is `(1, u tan(x)/x)` normalised, `u = w h / 2`, `x = |u|`: no more than one root and a series for
/// slow turns.
fn turned(rotation: Rotation, w: DVec3, h: f64) -> Rotation {
    let half = w * (0.5 * h);
    let square = half.length_squared();
    let stretch = if square < SMALL_SQUARE {
        // tan(x)/x = 1 + x^2/3 + 2 x^4/15 + 17 x^6/315 + 62 x^8/2835 + ...
        1.0 + square * (1.0 / 3.0 + square * (2.0 / 15.0 + square * (17.0 / 315.0 + square * (62.0 / 2835.0))))
    } else {
        let x = square.sqrt();
        libm::tan(x) / x
    };
    let u = half * stretch;
    let turn = DQuat::from_xyzw(u.x, u.y, u.z, 1.0);
    Rotation::renormalized(turn * rotation.quaternion())
}

/// What a substep of free rotation gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turned {
    pub(super) rotation: Rotation,
    /// Angular velocity at the end, rad/s, world.
    pub(super) angular: DVec3,
    /// Rotation vector of the turn, rad, to second order.
    pub(super) turn: DVec3,
}

/// The free rotation of a body over `h` (s), from a rotation at which its angular velocity is `angular`.
pub(super) fn turn(rigid: &RigidBody, rotation: Rotation, (momentum, angular): (DVec3, DVec3), h: f64) -> Turned {
    if angular == DVec3::ZERO {
        return Turned { rotation, angular, turn: DVec3::ZERO };
    }
    let moments = rigid.moments();
    if moments.x == moments.y && moments.y == moments.z {
        return Turned { rotation: turned(rotation, angular, h), angular, turn: angular * h };
    }
    let middle = rigid.angular_velocity_at(turned(rotation, angular, 0.5 * h), momentum);
    let rotation = turned(rotation, middle, h);
    Turned { rotation, angular: rigid.angular_velocity_at(rotation, momentum), turn: middle * h }
}

#[cfg(test)]
mod tests {
    //! Free rotation about the middle axis: the error falls with the square of the step, and the energy does not drift
    //! away.
    use super::*;
    use polhode_spatial::{Inertia, Mass, MassProperties};

    fn body() -> RigidBody {
        let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0)).expect("valid");
        RigidBody::new(&MassProperties::new(Mass::new(1.0).expect("valid"), DVec3::ZERO, inertia))
    }

    fn after(steps: u32) -> (Rotation, f64) {
        let (rigid, h) = (body(), 2.0 / f64::from(steps));
        let momentum = DVec3::new(0.1, 4.0, 0.2);
        let mut rotation = Rotation::IDENTITY;
        for _ in 0..steps {
            let angular = rigid.angular_velocity_at(rotation, momentum);
            rotation = turn(&rigid, rotation, (momentum, angular), h).rotation;
        }
        (rotation, 0.5 * momentum.dot(rigid.angular_velocity_at(rotation, momentum)))
    }

    #[test]
    fn it_is_of_second_order_and_bounded() {
        let (exact, _) = after(20_000);
        let errors = [100, 200, 400].map(|steps| after(steps).0.angle_to(exact));
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((1.8..2.2).contains(&order), "{errors:?}");
        }
        // A step of more than half a radian: the energy stays within its bounds.
        let momentum = DVec3::new(0.1, 4.0, 0.2);
        let (_, energy) = after(8);
        let square = momentum.length_squared();
        assert!(energy > square / 6.0 - 1e-12 && energy < square / 2.0 + 1e-12, "{energy}");
    }
}
