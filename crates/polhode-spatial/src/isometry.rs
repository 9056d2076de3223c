//! Isometries: how a space is set otherwise, turned, shifted and mirrored.
//!
//! A point `x` goes to `x' = R S x + d`, with `S = diag(-1, 1, 1)` where the space is mirrored and the identity where
//! it is not. The frame of a body is mirrored likewise in its own plane x = 0, so that it stays right-handed: a point
//! `p` of the body goes to `S p` in its frame. A body of the attitude `A` has the attitude `R S A S` then. Velocities,
//! forces and directions go as differences of points do (`R S v`); angular velocities, torques and axes of rotation go
//! with the opposite sign where the space is mirrored (`det(S) R S w`).

use crate::{Pose, Rotation, UnitVector, Velocity};
use glam::{DQuat, DVec3};

/// Whether left and right are exchanged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Handedness {
    /// They stay.
    #[default]
    Kept,
    /// The image in a mirror in the plane x = 0.
    Mirrored,
}

impl Handedness {
    /// A point or a vector, such as a velocity or a force.
    pub fn vector(self, v: DVec3) -> DVec3 {
        match self {
            Self::Kept => v,
            Self::Mirrored => DVec3::new(-v.x, v.y, v.z),
        }
    }

    /// An axis of rotation, an angular velocity, a torque.
    pub fn axial(self, v: DVec3) -> DVec3 {
        match self {
            Self::Kept => v,
            Self::Mirrored => DVec3::new(v.x, -v.y, -v.z),
        }
    }

    /// A rotation between two frames that are both mirrored.
    pub fn rotation(self, rotation: Rotation) -> Rotation {
        match self {
            Self::Kept => rotation,
            Self::Mirrored => {
                let q = rotation.quaternion();
                Rotation::renormalized(DQuat::from_xyzw(q.x, -q.y, -q.z, q.w))
            }
        }
    }
}

/// A space set otherwise.
///
/// ```
/// use polhode_spatial::isometry::{Handedness, Isometry};
/// use polhode_spatial::{DVec3, Rotation};
/// let image = Isometry::new(Rotation::IDENTITY, DVec3::Z, Handedness::Mirrored);
/// assert_eq!(image.point(DVec3::new(1.0, 2.0, 3.0)), DVec3::new(-1.0, 2.0, 4.0));
/// assert_eq!(image.axial(DVec3::Z), -DVec3::Z);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Isometry {
    turn: Rotation,
    shift: DVec3,
    handedness: Handedness,
}

impl Isometry {
    /// Mirrored first, if at all, then turned about the origin, then shifted (m).
    pub const fn new(turn: Rotation, shift: DVec3, handedness: Handedness) -> Self {
        Self { turn, shift, handedness }
    }

    /// How it is turned.
    pub const fn turn(&self) -> Rotation {
        self.turn
    }

    /// By how much it is shifted, m.
    pub const fn shift(&self) -> DVec3 {
        self.shift
    }

    /// Whether it is mirrored.
    pub const fn handedness(&self) -> Handedness {
        self.handedness
    }

    /// A point of the space.
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.vector(point) + self.shift
    }

    /// A velocity, a force, a direction.
    pub fn vector(&self, v: DVec3) -> DVec3 {
        self.turn.rotate(self.handedness.vector(v))
    }

    /// An angular velocity, a torque, an axis of rotation.
    pub fn axial(&self, v: DVec3) -> DVec3 {
        self.turn.rotate(self.handedness.axial(v))
    }

    /// A direction.
    pub fn direction(&self, direction: UnitVector) -> UnitVector {
        UnitVector::known(self.vector(direction.get()))
    }

    /// The direction of an axis of rotation.
    pub fn axis(&self, axis: UnitVector) -> UnitVector {
        UnitVector::known(self.axial(axis.get()))
    }

    /// The attitude of a body.
    pub fn rotation(&self, attitude: Rotation) -> Rotation {
        self.turn * self.handedness.rotation(attitude)
    }

    /// The pose of a body.
    pub fn pose(&self, pose: &Pose) -> Pose {
        Pose::new(self.rotation(pose.rotation), self.point(pose.translation))
    }

    /// The velocity of a body.
    pub fn velocity(&self, velocity: &Velocity) -> Velocity {
        Velocity::new(self.vector(velocity.linear), self.axial(velocity.angular))
    }

    /// The pose of a body as it was before.
    pub fn pose_before(&self, pose: &Pose) -> Pose {
        let back = self.turn.inverse();
        Pose::new(
            self.handedness.rotation(back * pose.rotation),
            self.handedness.vector(back.rotate(pose.translation - self.shift)),
        )
    }

    /// The velocity of a body as it was before.
    pub fn velocity_before(&self, velocity: &Velocity) -> Velocity {
        let back = self.turn.inverse();
        Velocity::new(
            self.handedness.vector(back.rotate(velocity.linear)),
            self.handedness.axial(back.rotate(velocity.angular)),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mirrored and turned space turns a body's velocity of a point into that of the point's image.
    #[test]
    fn velocities_of_points_go_as_points_do() {
        let turn = Rotation::from_rotation_vector(DVec3::new(0.3, -0.7, 1.1));
        let space = Isometry::new(turn, DVec3::new(2.0, -1.0, 0.5), Handedness::Mirrored);
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(-0.2, 0.9, 0.4)), DVec3::new(0.1, 0.2, 0.3));
        let velocity = Velocity::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(-0.5, 0.7, 0.2));
        let own = DVec3::new(0.3, -0.4, 0.6);
        let point = pose.transform_point(own);
        let of_point = velocity.linear + velocity.angular.cross(point - pose.translation);
        let (image, moved) = (space.pose(&pose), space.velocity(&velocity));
        let point_of_image = image.transform_point(Handedness::Mirrored.vector(own));
        assert!((point_of_image - space.point(point)).length() < 1e-15);
        let of_image = moved.linear + moved.angular.cross(point_of_image - image.translation);
        // Speeds of 4 m/s, of a dozen terms each.
        assert!((of_image - space.vector(of_point)).length() < 1e-14);
        assert!((space.pose_before(&image).translation - pose.translation).length() < 1e-15);
        assert!(space.pose_before(&image).rotation.angle_to(pose.rotation) < 1e-15);
        assert!((space.velocity_before(&moved).angular - velocity.angular).length() < 1e-15);
    }
}
