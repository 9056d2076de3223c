//! The stages of methods on the group of rotations: an attitude, and a part that is a vector space.
//!
//! Position, velocity and angular momentum take the classical Runge-Kutta method beside the attitude.

use super::body_axes::to_body;
use super::four_stages::mean;
use super::loads::Load;
use crate::{BodyState, RigidBody};
use glam::{DQuat, DVec3};
use polhode_spatial::{Pose, Rotation};

/// A body at a stage.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stage {
    /// `q_WB`, of length one up to rounding.
    pub(crate) attitude: DQuat,
    vectors: Vectors,
}

/// Position, velocity, angular momentum; or their rates: velocity, acceleration, torque.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Vectors {
    position: DVec3,
    velocity: DVec3,
    angular_momentum: DVec3,
}

impl Stage {
    /// The first stage.
    #[inline]
    pub(crate) const fn first(start: &BodyState) -> Self {
        Self {
            attitude: start.pose.rotation.quaternion(),
            vectors: Vectors {
                position: start.pose.translation,
                velocity: start.linear_velocity,
                angular_momentum: start.angular_momentum,
            },
        }
    }

    /// At `attitude`, the vectors `reach` (s) along `rates` from the start.
    #[inline]
    pub(crate) fn reached(start: &BodyState, attitude: DQuat, rates: &Vectors, reach: f64) -> Self {
        let vectors = Vectors {
            position: start.pose.translation + rates.position * reach,
            velocity: start.linear_velocity + rates.velocity * reach,
            angular_momentum: start.angular_momentum + rates.angular_momentum * reach,
        };
        Self { attitude, vectors }
    }

    /// Angular velocity in body axes, `I^-1 R^T L`, rad/s.
    #[inline]
    pub(crate) fn angular_velocity(&self, body: &RigidBody) -> DVec3 {
        body.inverse_inertia() * to_body(self.attitude, self.vectors.angular_momentum)
    }

    /// Rates of the vectors.
    #[inline]
    pub(crate) const fn rates(&self, load: Load) -> Vectors {
        Vectors { position: self.vectors.velocity, velocity: load.acceleration, angular_momentum: load.torque }
    }

    /// The state, its quaternion normalised.
    #[inline]
    pub(crate) fn state(&self) -> BodyState {
        BodyState {
            pose: Pose::new(Rotation::renormalized(self.attitude), self.vectors.position),
            linear_velocity: self.vectors.velocity,
            angular_momentum: self.vectors.angular_momentum,
        }
    }
}

impl Vectors {
    /// The weighted mean of the rates of the four stages.
    #[inline]
    pub(crate) fn mean<R>(rates: &[R; 4], part: impl Fn(&R) -> &Self) -> Self {
        Self {
            position: mean(rates, |k| part(k).position),
            velocity: mean(rates, |k| part(k).velocity),
            angular_momentum: mean(rates, |k| part(k).angular_momentum),
        }
    }
}
