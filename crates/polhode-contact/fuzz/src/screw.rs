//! Motion along a straight path with a steady spin.

use polhode_spatial::{Motion, MotionBounds, Pose, Rotation, Velocity};

/// A straight path and a steady spin.
pub(crate) struct Screw(pub(crate) Pose, pub(crate) Velocity);

impl Motion for Screw {
    fn pose(&self, t: f64) -> Pose {
        let turn = Rotation::from_rotation_vector(self.1.angular * t);
        Pose::new(turn * self.0.rotation, self.0.translation + self.1.linear * t)
    }

    fn velocity(&self, _: f64) -> Velocity {
        self.1
    }

    fn bounds(&self, _: f64, _: f64) -> MotionBounds {
        MotionBounds {
            speed: self.1.linear.length(),
            angular_speed: self.1.angular.length(),
            ..MotionBounds::default()
        }
    }
}
