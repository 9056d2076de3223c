//! The motion of a kinematic body that a program steers, as the data from which it follows.

use crate::model::prescribed_state::velocity_of;
use crate::report::acceleration::Acceleration;
use crate::scene::motion::Departure;
use crate::scene::{MotionError, PrescribedMotion, Trajectory};
use crate::snapshot::{SnapshotError, content, numbers};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Velocity};

/// A motion that a program has given a kinematic body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Steered {
    /// When it was given, s.
    pub(crate) from_s: f64,
    /// The pose then.
    pub(crate) pose: Pose,
    /// The velocity from then on.
    pub(crate) velocity: Velocity,
    /// The acceleration then; it is zero without a goal.
    pub(crate) acceleration: Acceleration,
    /// Where it ends; without it the velocity stays.
    pub(crate) goal: Option<Goal>,
}

/// Where the motion of a steered body ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Goal {
    /// When, s.
    pub(crate) until_s: f64,
    /// The pose.
    pub(crate) pose: Pose,
}

impl Steered {
    /// The motion as a function of time.
    ///
    /// # Errors
    /// When a number, a speed or an acceleration is too large.
    pub(crate) fn trajectory(&self) -> Result<Trajectory, MotionError> {
        let motion = match self.goal {
            None => PrescribedMotion::steady_from(self.velocity, self.from_s)?,
            Some(goal) => {
                let start = Departure { pose: &self.pose, velocity: &self.velocity, acceleration: &self.acceleration };
                PrescribedMotion::approach([self.from_s, goal.until_s], &start, &goal.pose)?
            }
        };
        Ok(motion.from_pose(&self.pose))
    }

    pub(super) fn save(&self, body: usize) -> content::Steered {
        let state = |pose: Pose, velocity: Velocity| {
            BodyState { pose, linear_velocity: velocity.linear, angular_momentum: velocity.angular }.to_array()
        };
        content::Steered {
            body,
            from_s: self.from_s,
            start: state(self.pose, self.velocity),
            acceleration: [self.acceleration.linear.to_array(), self.acceleration.angular.to_array()],
            goal: self.goal.map(|goal| (goal.until_s, state(goal.pose, Velocity::ZERO))),
        }
    }

    pub(super) fn restored(saved: &content::Steered) -> Result<Self, SnapshotError> {
        let start = numbers::read_state(&saved.start)?;
        let [linear, angular] = saved.acceleration.map(DVec3::from_array);
        let goal = saved.goal.as_ref().map(|(until_s, state)| {
            numbers::read_state(state).map(|state| Goal { until_s: *until_s, pose: state.pose })
        });
        Ok(Self {
            from_s: saved.from_s,
            pose: start.pose,
            velocity: velocity_of(&start),
            acceleration: Acceleration { linear, angular },
            goal: goal.transpose()?,
        })
    }
}
