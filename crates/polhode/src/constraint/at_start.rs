//! Joints of a scene at the start: their rows there, and that the velocities are what the joints leave free.

use super::joint::{HeldBody, ModelJoint};
use super::row::RowKind;
use crate::scene::{Joint, Scene, SceneError};
use polhode_spatial::rounding;
use polhode_spatial::{Motion, Pose, Velocity};

impl Scene {
    /// Checks the joints: that their bodies exist and can be held, and do not leave them at the start.
    ///
    /// # Errors
    /// With the first joint that is refused.
    pub(crate) fn check_joints(&self) -> Result<(), SceneError> {
        for (number, joint) in self.joints.iter().enumerate() {
            self.check_joint(number, joint)?;
            self.check_joint_velocity(number, joint)?;
        }
        Ok(())
    }

    /// The pose of the moving frame of a body at the start, and its velocity.
    pub(crate) fn motion_at_start(&self, body: usize) -> (Pose, Velocity) {
        let own = &self.bodies[body];
        if let Some(motion) = own.motion() {
            let trajectory = motion.from_pose(&motion.initial_pose(own.initial_pose()));
            return (trajectory.pose(0.0), trajectory.velocity(0.0));
        }
        let Some(properties) = own.mass_properties() else { return (Pose::IDENTITY, Velocity::ZERO) };
        let Velocity { linear, angular } = *own.initial_velocity();
        let center = properties.center_of_mass();
        let pose = *own.initial_pose() * Pose::from_translation(center);
        let linear = own.pivot_point().map_or(linear, |pivot| angular.cross(pose.translation - pivot));
        (pose, Velocity::new(linear, angular))
    }

    /// The speed (m/s) and rate of turning (rad/s) that the digits of a velocity at the start are relative to: its own,
    /// or the greatest of a prescribed motion in the run.
    pub(super) fn speeds_for_rounding(&self, body: usize) -> [f64; 2] {
        let own = &self.bodies[body];
        if let Some(motion) = own.motion() {
            let bounds = motion.from_pose(&motion.initial_pose(own.initial_pose())).bounds(0.0, self.duration_s);
            return [bounds.speed, bounds.angular_speed];
        }
        let (_, velocity) = self.motion_at_start(body);
        [velocity.linear.length(), velocity.angular.length()]
    }

    /// A joint as it is at the start, whose rows of rotation have the length 1 m.
    pub(super) fn joint_at_start(&self, number: usize, joint: &Joint) -> ModelJoint {
        let held = |body: usize| match &self.bodies[body] {
            own if own.motion().is_some() => HeldBody::Kinematic(self.motion_at_start(body).0),
            own if own.mass_properties().is_some() => HeldBody::Movable(self.motion_at_start(body).0),
            _ => HeldBody::Fixed,
        };
        ModelJoint::new((number, joint), &self.tracks, held, 1.0)
    }

    /// Checks that the velocities at the start are what a joint leaves free: the rates of its rows are zero to
    /// rounding.
    fn check_joint_velocity(&self, number: usize, joint: &Joint) -> Result<(), SceneError> {
        let motion = |body: usize| self.motion_at_start(body);
        let world_joint = self.joint_at_start(number, joint);
        let (mut apart, mut across) = (0.0, 0.0);
        for row in world_joint.rows_at(motion).rows {
            match row.kind {
                RowKind::Along(_) | RowKind::Helix { .. } | RowKind::Tied { .. } => {
                    apart = libm::hypot(apart, row.rate);
                }
                RowKind::About(_) | RowKind::Turning { .. } => across = libm::hypot(across, row.rate),
            }
        }
        let (mut speed, mut turning) = (0.0, 0.0);
        for body in world_joint.bodies().chain(world_joint.driver()) {
            // The parts of the velocity at the anchor may cancel.
            let [linear, angular] = self.speeds_for_rounding(body);
            speed += linear + angular * (joint.anchor() - motion(body).0.translation).length();
            turning += angular;
        }
        if apart > rounding::DIGITS_OF_A_FILE * speed {
            return Err(SceneError::JointMoves { number, apart_m_s: apart });
        }
        if across > rounding::DIGITS_OF_A_FILE * turning {
            return Err(SceneError::JointTurns { number, across_rad_s: across });
        }
        Ok(())
    }
}
