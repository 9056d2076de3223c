//! One time step of bodies whose events crowd (`crowding.rs`), and how they go through it: along a line, with a steady turn.

use crate::time_stepping::{TimeStepReport, TimeStepper};
use polhode_dynamics::BodyState;
use polhode_spatial::{ConstantVelocity, Motion, MotionBounds, Pose, Still, Velocity};

/// A body's part in a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crowd {
    /// When the stretch ends, s.
    pub(super) until: f64,
    /// Length of the next time step, s.
    pub(super) step_s: f64,
    /// Number of the stretch in the accounts.
    pub(super) number: usize,
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
    /// What the step did, and what was carried before it.
    pub(super) report: TimeStepReport,
    pub(super) stepper: TimeStepper,
    pub(super) ways: Vec<Way>,
}

impl CrowdStep {
    /// Way of the body of this place.
    pub(super) fn way(&self, place: usize) -> Option<&Way> {
        self.ways.get(place)
    }

    /// States of the bodies at a time within the step.
    pub(super) fn states_at(&self, t: f64) -> Vec<BodyState> {
        if t >= self.end {
            return self.states.clone();
        }
        let at = |(way, (start, end)): (&Way, (&BodyState, &BodyState))| {
            let share = if self.end > self.t { (t - self.t) / (self.end - self.t) } else { 0.0 };
            BodyState {
                pose: way.pose(t),
                linear_velocity: start.linear_velocity.lerp(end.linear_velocity, share),
                angular_momentum: start.angular_momentum.lerp(end.angular_momentum, share),
            }
        };
        self.ways.iter().zip(self.start.iter().zip(&self.states)).map(at).collect()
    }
}

/// How a body goes through a time step.
#[derive(Debug, Clone)]
pub(super) enum Way {
    /// From its start to its end along a line, with a steady turn.
    Straight(ConstantVelocity),
    /// Not at all, or not finite, which its states say.
    Still(Still),
}

impl Way {
    fn between((t, start): (f64, &Pose), (end_t, end): (f64, &Pose)) -> Self {
        let h = end_t - t;
        let turn = (end.rotation * start.rotation.inverse()).to_rotation_vector();
        let velocity = Velocity::new((end.translation - start.translation) / h, turn / h);
        ConstantVelocity::new(t, *start, velocity).map_or(Self::Still(Still(*start)), Self::Straight)
    }
}

impl Motion for Way {
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

/// How bodies go from their states at one time (s) to those at another.
pub(super) fn ways((t, start): (f64, &[BodyState]), (end_t, end): (f64, &[BodyState])) -> Vec<Way> {
    start.iter().zip(end).map(|(start, end)| Way::between((t, &start.pose), (end_t, &end.pose))).collect()
}
