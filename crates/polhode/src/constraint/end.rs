//! An end of a constraint: a point fixed in a movable body, or in the world.

use super::row::Member;
use polhode_spatial::{DVec3, Pose, Rotation, Velocity};

/// Where a constraint holds a body or the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum End {
    /// A movable body.
    Body {
        body: usize,
        /// From its centre of mass to the point, in body axes, m.
        arm: DVec3,
    },
    /// A point of the world, m. Fixed bodies are part of it.
    World(DVec3),
}

/// An end in given states, all world.
#[derive(Debug, Clone, Copy)]
pub(super) struct EndKinematics {
    pub(super) point: DVec3,
    /// Of the point, m/s.
    pub(super) velocity: DVec3,
    /// `w x (w x r)`: the acceleration of the point without those of the body, m/s^2.
    pub(super) acceleration: DVec3,
    /// Attitude of the body.
    pub(super) rotation: Rotation,
    /// Angular velocity of the body, rad/s.
    pub(super) angular: DVec3,
    /// Without its sign.
    member: Option<(usize, DVec3)>,
}

impl End {
    /// The end where this is the pose of the moving frame of a body, and its velocity.
    pub(super) fn at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> EndKinematics {
        match *self {
            Self::World(point) => EndKinematics {
                point,
                velocity: DVec3::ZERO,
                acceleration: DVec3::ZERO,
                rotation: Rotation::IDENTITY,
                angular: DVec3::ZERO,
                member: None,
            },
            Self::Body { body, arm } => {
                let (pose, Velocity { linear, angular }) = motion(body);
                let arm = pose.rotation.rotate(arm);
                EndKinematics {
                    point: pose.translation + arm,
                    velocity: linear + angular.cross(arm),
                    acceleration: angular.cross(angular.cross(arm)),
                    rotation: pose.rotation,
                    angular,
                    member: Some((body, arm)),
                }
            }
        }
    }

    /// The body, if it is one.
    pub(crate) fn body(&self) -> Option<usize> {
        match *self {
            Self::Body { body, .. } => Some(body),
            Self::World(_) => None,
        }
    }
}

impl EndKinematics {
    /// The motion of another point (m, world) that moves with the body at this moment. Two bodies whose ends are apart bear
    /// their forces at one point, so that their angular momentum stays.
    pub(super) fn at_point(self, point: DVec3) -> Self {
        let Some((body, arm)) = self.member else { return self };
        let way = point - self.point;
        Self {
            point,
            velocity: self.velocity + self.angular.cross(way),
            acceleration: self.angular.cross(self.angular.cross(arm + way)),
            member: Some((body, arm + way)),
            ..self
        }
    }

    /// The member of a constraint at this end, with its sign.
    pub(super) fn member(&self, sign: f64) -> Option<Member> {
        self.member.map(|(body, arm)| Member { body, arm, sign })
    }
}
