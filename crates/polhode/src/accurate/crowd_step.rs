//! One time step of bodies with crowded events (`crowding.rs`). Within it each body moves along a line at constant
//! angular velocity.

use crate::time_stepping::{TimeStepReport, TimeStepper};
use polhode_dynamics::BodyState;
use polhode_spatial::{ConstantVelocity, Motion, MotionBounds, Pose, Still, Velocity};

/// The state of a stretch of crowded events.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crowd {
    /// When the stretch that a body began ends, s; for one that joined it, when it joined.
    pub(super) until: f64,
    /// Length of the next time step, s.
    pub(super) step_s: f64,
    /// Number of the stretch in the accounts.
    pub(super) number: usize,
    /// Error that is left for steps within which contacts begin to stick or to slide, relative to the size of a body.
    pub(super) spare_error: f64,
}

impl Crowd {
    /// The stretch of bodies that go on together: to the later end, with the shorter step and the lesser error left.
    pub(super) fn together_with(self, other: &Self) -> Self {
        Self {
            until: self.until.max(other.until),
            step_s: self.step_s.min(other.step_s),
            spare_error: self.spare_error.min(other.spare_error),
            ..self
        }
    }
}

/// One time step of a crowd.
#[derive(Debug)]
pub(super) struct CrowdStep {
    /// Start and end, s.
    pub(super) t: f64,
    pub(super) end: f64,
    pub(super) start: Vec<BodyState>,
    pub(super) states: Vec<BodyState>,
    pub(super) pairs: Vec<(usize, usize)>,
    /// Report of the step, and the stepper as it was before the step.
    pub(super) report: TimeStepReport,
    pub(super) stepper: TimeStepper,
    pub(super) motions: Vec<StepMotion>,
}

impl CrowdStep {
    /// Motion of the body at this index.
    pub(super) fn motion(&self, place: usize) -> Option<&StepMotion> {
        self.motions.get(place)
    }

    /// States of the bodies at a time within the step.
    pub(super) fn states_at(&self, t: f64) -> Vec<BodyState> {
        if t >= self.end {
            return self.states.clone();
        }
        let at = |(motion, (start, end)): (&StepMotion, (&BodyState, &BodyState))| {
            let share = if self.end > self.t { (t - self.t) / (self.end - self.t) } else { 0.0 };
            BodyState {
                pose: motion.pose(t),
                linear_velocity: start.linear_velocity.lerp(end.linear_velocity, share),
                angular_momentum: start.angular_momentum.lerp(end.angular_momentum, share),
            }
        };
        self.motions.iter().zip(self.start.iter().zip(&self.states)).map(at).collect()
    }
}

/// Motion of a body within a time step.
#[derive(Debug, Clone)]
pub(super) enum StepMotion {
    /// From its start to its end along a line, at constant angular velocity.
    Straight(ConstantVelocity),
    /// No motion, or not finite; the states show which.
    Still(Still),
}

impl StepMotion {
    fn between((t, start): (f64, &Pose), (end_t, end): (f64, &Pose)) -> Self {
        let h = end_t - t;
        let turn = (end.rotation * start.rotation.inverse()).to_rotation_vector();
        let velocity = Velocity::new((end.translation - start.translation) / h, turn / h);
        ConstantVelocity::new(t, *start, velocity).map_or(Self::Still(Still(*start)), Self::Straight)
    }
}

impl Motion for StepMotion {
    fn pose(&self, t: f64) -> Pose {
        match self {
            Self::Straight(motion) => motion.pose(t),
            Self::Still(motion) => motion.pose(t),
        }
    }

    fn velocity(&self, t: f64) -> Velocity {
        match self {
            Self::Straight(motion) => motion.velocity(t),
            Self::Still(motion) => motion.velocity(t),
        }
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        match self {
            Self::Straight(motion) => motion.bounds(t0, t1),
            Self::Still(motion) => motion.bounds(t0, t1),
        }
    }
}

/// Motions of bodies from their states at one time (s) to those at another.
pub(super) fn motions((t, start): (f64, &[BodyState]), (end_t, end): (f64, &[BodyState])) -> Vec<StepMotion> {
    start.iter().zip(end).map(|(start, end)| StepMotion::between((t, &start.pose), (end_t, &end.pose))).collect()
}
