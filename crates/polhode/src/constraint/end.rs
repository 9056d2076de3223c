//! An end of a constraint: a point fixed in a movable body, in a kinematic one, or in the world.

use super::row::{Member, Part};
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
    /// A kinematic body.
    Driver {
        body: usize,
        /// From its origin to the point, in body axes, m.
        arm: DVec3,
    },
    /// A point of the world, m. Fixed bodies are part of it.
    World(DVec3),
}

/// Whether the first body of a contact at a joint is the first one of the joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    Same,
    Reversed,
}

impl Order {
    /// The sign of motions of the first body of the joint in those of the first one of the contact.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Same => 1.0,
            Self::Reversed => -1.0,
        }
    }
}

/// An end in given states, all world.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EndKinematics {
    pub(crate) point: DVec3,
    /// Of the point, m/s.
    pub(crate) velocity: DVec3,
    /// `w x (w x r)`: the acceleration of the point without that of the body, m/s^2.
    pub(crate) acceleration: DVec3,
    /// Attitude of the body.
    pub(crate) rotation: Rotation,
    /// Angular velocity of the body, rad/s.
    pub(crate) angular: DVec3,
    holder: Holder,
}

/// What an end is fixed in, with the arm to it, world, m.
#[derive(Debug, Clone, Copy)]
enum Holder {
    World,
    Body(usize, DVec3),
    Driver(usize, DVec3),
}

impl End {
    /// The end where this is the pose of the moving frame of a body, and its velocity.
    pub(crate) fn at(&self, motion: impl Fn(usize) -> (Pose, Velocity)) -> EndKinematics {
        match *self {
            Self::World(point) => EndKinematics {
                point,
                velocity: DVec3::ZERO,
                acceleration: DVec3::ZERO,
                rotation: Rotation::IDENTITY,
                angular: DVec3::ZERO,
                holder: Holder::World,
            },
            Self::Body { body, arm } | Self::Driver { body, arm } => {
                let (pose, Velocity { linear, angular }) = motion(body);
                let arm = pose.rotation.rotate(arm);
                EndKinematics {
                    point: pose.translation + arm,
                    velocity: linear + angular.cross(arm),
                    acceleration: angular.cross(angular.cross(arm)),
                    rotation: pose.rotation,
                    angular,
                    holder: match self {
                        Self::Driver { .. } => Holder::Driver(body, arm),
                        Self::World(_) | Self::Body { .. } => Holder::Body(body, arm),
                    },
                }
            }
        }
    }

    /// The movable body, if it is one.
    pub(crate) fn body(&self) -> Option<usize> {
        match *self {
            Self::Body { body, .. } => Some(body),
            Self::World(_) | Self::Driver { .. } => None,
        }
    }

    /// The kinematic body, if it is one.
    pub(crate) fn driver(&self) -> Option<usize> {
        match *self {
            Self::Driver { body, .. } => Some(body),
            Self::World(_) | Self::Body { .. } => None,
        }
    }
}

impl EndKinematics {
    /// The motion of another point (m, world) that moves with the body at this moment. Two bodies whose ends are apart
    /// bear their forces at one point, so that their angular momentum stays.
    pub(crate) fn at_point(self, point: DVec3) -> Self {
        let way = point - self.point;
        let (arm, holder) = match self.holder {
            Holder::World => return self,
            Holder::Body(body, arm) => (arm, Holder::Body(body, arm + way)),
            Holder::Driver(body, arm) => (arm, Holder::Driver(body, arm + way)),
        };
        Self {
            point,
            velocity: self.velocity + self.angular.cross(way),
            acceleration: self.angular.cross(self.angular.cross(arm + way)),
            holder,
            ..self
        }
    }

    /// Whether it is fixed in the world.
    pub(crate) fn is_in_world(&self) -> bool {
        matches!(self.holder, Holder::World)
    }

    /// The movable member of a constraint at this end, with its sign.
    pub(crate) fn member(&self, sign: f64) -> Option<Member> {
        match self.holder {
            Holder::Body(body, arm) => Some(Member { body, arm, sign, part: Part::First }),
            Holder::World | Holder::Driver(..) => None,
        }
    }

    /// The kinematic member, likewise.
    pub(crate) fn driver(&self, sign: f64) -> Option<Member> {
        match self.holder {
            Holder::Driver(body, arm) => Some(Member { body, arm, sign, part: Part::First }),
            Holder::World | Holder::Body(..) => None,
        }
    }
}
