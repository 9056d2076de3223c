//! One time step of bodies with crowded events (`crowding.rs`).
//!
//! The states at an instant within it are those of a shorter time step from the same start: they obey the contacts, and
//! do not change the step. Only the search for impacts of other islands takes each body along a line at constant
//! angular velocity.

use crate::accounting::time_step_report::TimeStepReport;
use crate::model::states_of::set_states;
use crate::model::{Model, prescribed};
use crate::time_stepping::TimeStepper;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
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

    /// Advances the bodies from the start of the step to `t` (s), and writes their states, and those of the kinematic
    /// bodies that they may touch, into `states` (of all bodies). Within the step the same two halves are made as for
    /// the whole step, the last one shorter: bodies obey the contacts at every instant, and at the end of the step
    /// these are its states.
    ///
    /// # Errors
    /// When it is not possible; the states are those at the start of the step then.
    pub(super) fn advance_to(
        &self,
        model: &Model,
        bodies: &[usize],
        t: f64,
        states: &mut [BodyState],
    ) -> Result<TimeStepReport, ResponseError> {
        if t >= self.end {
            set_states(states, bodies, &self.states);
            return Ok(self.report.clone());
        }
        set_states(states, bodies, &self.start);
        prescribed::prescribe_members(model, &self.pairs, self.t, states);
        let mut stepper = self.stepper.clone();
        let about = stepper.about();
        if t <= self.t {
            return Ok(TimeStepReport::new(about));
        }
        let (whole, h) = (self.end - self.t, t - self.t);
        let half = 0.5 * whole;
        let parts = [(self.t, h.min(half)), (self.t + half, h - half)];
        let mut report = TimeStepReport::new(about);
        for &(from, span) in parts.iter().filter(|(_, span)| *span > 0.0) {
            report.append(stepper.advance(model, states, bodies, &self.pairs, (from, span))?);
        }
        Ok(report)
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
