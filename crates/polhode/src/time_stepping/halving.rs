//! Error estimate of a time step by step halving, used in stretches of crowded events.
//!
//! A step of h is compared with two of h/2 from the same state, and the result of the two halves is used. The largest
//! displacement between the two results, relative to the size of each body, estimates the error of the longer step.
//! Between changes of contact this error is of order h^3 in a step, and of order h^2 in a second; where a contact
//! changes within the step it is of order h.

use super::step::TimeStepper;
use crate::accounting::time_step_report::TimeStepReport;
use crate::model::Model;
use crate::model::states_of::{set_states, states_of};
use crate::solve::overlap::displacement;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

impl TimeStepper {
    /// The same stepper, which resolves bounces higher than this fraction of a body's size: if both step lengths lost a
    /// bounce, the estimate would not show it. Lower ones strike nothing, however short the steps are: the shorter the
    /// steps of bodies that lean on each other, the lower the bounces that could be followed, and each of them makes
    /// the next step shorter.
    pub(crate) fn following_bounces(mut self, height_relative: f64) -> Self {
        self.unseen_bounce = height_relative;
        self
    }

    /// Advances by one step of `h` (s) and by two halves, uses the result of the halves, and estimates the error of the
    /// whole step: the largest displacement between the two, relative to the size of the body.
    ///
    /// # Errors
    /// As [`TimeStepper::advance`]; the states are unchanged then.
    pub(crate) fn advance_with_estimate(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        (t, h): (f64, f64),
    ) -> Result<(TimeStepReport, f64), ResponseError> {
        let start = states_of(states, bodies);
        let carried = self.carried.clone();
        self.advance(model, states, bodies, pairs, (t, h)).inspect_err(|_| set_states(states, bodies, &start))?;
        let whole = states_of(states, bodies);
        set_states(states, bodies, &start);
        self.carried = carried;
        let mut report = self.advance(model, states, bodies, pairs, (t, 0.5 * h));
        if let Ok(first) = &mut report {
            let second = self.advance(model, states, bodies, pairs, (t + 0.5 * h, 0.5 * h));
            let second = second.inspect_err(|_| set_states(states, bodies, &start))?;
            first.append(second);
        }
        let report = report.inspect_err(|_| set_states(states, bodies, &start))?;
        let error = |(&body, whole): (&usize, &BodyState)| {
            let apart = displacement(model, body, whole, &states[body]);
            let size = model.bodies[body].size;
            if size > 0.0 { apart / size } else { apart }
        };
        let estimate = bodies.iter().zip(&whole).map(error).fold(0.0, f64::max);
        Ok((report, estimate))
    }
}
