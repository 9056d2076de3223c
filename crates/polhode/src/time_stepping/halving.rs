//! Steps of half the length: where the problems of a step were not all solved, and to estimate its error.
//!
//! A step whose problems were not all solved is made again as two halves, whose problems are others. Failure: these may
//! be as hard; the better of both is taken, and what is left is told.
//!
//! The estimate, used in stretches of crowded events: a step of h is compared with two of h/2 from the same state, and
//! the result of the two halves is used. The largest displacement between the two results, relative to the size of each
//! body, estimates the error of the longer step. Between changes of contact this error is of order h^3 in a step, and
//! of order h^2 in a second; where a contact changes within the step it is of order h.

use super::step::TimeStepper;
use crate::accounting::time_step_report::TimeStepReport;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed};
use crate::solve::overlap::displacement;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_response::solve::step::EXACT_ENOUGH;

impl TimeStepper {
    /// The same stepper, which resolves bounces higher than this fraction of a body's size: if both step lengths lost a
    /// bounce, the estimate would not show it. Lower ones strike nothing, however short the steps are: the shorter the
    /// steps of bodies that lean on each other, the lower the bounces that could be followed, and each of them makes
    /// the next step shorter.
    pub(crate) fn following_bounces(mut self, height_relative: f64) -> Self {
        self.unseen_bounce = height_relative;
        self
    }

    /// Advances bodies as [`advance_by`](Self::advance_by) does, by two halves of the step where not all of its
    /// problems were solved and those of the halves are solved better.
    ///
    /// # Errors
    /// As [`advance_by`](Self::advance_by).
    pub(crate) fn advance(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        (t, h): (f64, f64),
    ) -> Result<TimeStepReport, ResponseError> {
        let start = states_of(states, bodies);
        let whole = self.advance_by(model, states, bodies, pairs, (t, h))?;
        if whole.residual <= EXACT_ENOUGH {
            return Ok(whole);
        }
        let (end, carried, forces) = (states_of(states, bodies), self.carried.clone(), self.cones.last.clone());
        set_states(states, bodies, &start);
        prescribed::prescribe_members(model, pairs, t, states);
        match self.advance_in_halves(model, states, bodies, pairs, (t, h)) {
            Ok(halves) if halves.residual < whole.residual => Ok(halves),
            _ => {
                (self.carried, self.cones.last) = (carried, forces);
                set_states(states, bodies, &end);
                prescribed::prescribe_members(model, pairs, t + h, states);
                Ok(whole)
            }
        }
    }

    /// Advances by one step of `h` (s) and by two halves, uses the result of the halves, and estimates the error of the
    /// whole step: the largest displacement between the two, relative to the size of the body.
    ///
    /// # Errors
    /// As [`advance_by`](Self::advance_by); the states are unchanged then.
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
        self.advance_by(model, states, bodies, pairs, (t, h)).inspect_err(|_| set_states(states, bodies, &start))?;
        let whole = states_of(states, bodies);
        set_states(states, bodies, &start);
        self.carried = carried;
        let report = self.advance_in_halves(model, states, bodies, pairs, (t, h));
        let report = report.inspect_err(|_| set_states(states, bodies, &start))?;
        let error = |(&body, whole): (&usize, &BodyState)| {
            let apart = displacement(model, body, whole, &states[body]);
            let size = model.bodies[body].size;
            if size > 0.0 { apart / size } else { apart }
        };
        let estimate = bodies.iter().zip(&whole).map(error).fold(0.0, f64::max);
        Ok((report, estimate))
    }

    fn advance_in_halves(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        (t, h): (f64, f64),
    ) -> Result<TimeStepReport, ResponseError> {
        let mut report = self.advance_by(model, states, bodies, pairs, (t, 0.5 * h))?;
        report.append(self.advance_by(model, states, bodies, pairs, (t + 0.5 * h, 0.5 * h))?);
        Ok(report)
    }
}
