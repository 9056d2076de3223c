//! The time steps of the islands of one step, by the executor that the program gave.
//!
//! Islands are divided into as many parts, in their order, as the executor runs at once. Each part has copies of the
//! states and of the stepper; what it did is put together in the order of the islands. An island reads no state of
//! another one, so that the result has the same bits for any number of parts. States of bodies that no island moves
//! (kinematic ones) are left anywhere within the step: the caller prescribes them.

use super::islands::Island;
use crate::accounting::time_step_report::TimeStepReport;
use crate::error::SimulationError;
use crate::model::Model;
use crate::model::states_of::{set_states, states_of};
use crate::tier::executor::{Executor, Task};
use crate::time_stepping::TimeStepper;
use polhode_dynamics::BodyState;

/// Reports of the steps of some islands, in their order, up to the first that failed.
type Reports = Result<Vec<TimeStepReport>, SimulationError>;

/// What the islands of one part did.
struct Part<'a> {
    islands: &'a [Island],
    states: Vec<BodyState>,
    stepper: TimeStepper,
    reports: Reports,
}

/// Makes the step of each island from `t` by `h` (s).
///
/// # Errors
/// That of the first island whose contact problem is not finite.
pub(super) fn advance_islands(
    model: &Model,
    executor: &dyn Executor,
    (stepper, states): (&mut TimeStepper, &mut [BodyState]),
    islands: &[Island],
    interval: (f64, f64),
) -> Reports {
    let parts = executor.width().get().min(islands.len());
    if parts <= 1 {
        return advance_each(model, (stepper, states), islands, interval);
    }
    let part = |islands| Part { islands, states: states.to_vec(), stepper: stepper.clone(), reports: Ok(Vec::new()) };
    let mut parts: Vec<Part<'_>> = islands.chunks(islands.len().div_ceil(parts)).map(part).collect();
    let task = |part: &mut Part<'_>| {
        part.reports = advance_each(model, (&mut part.stepper, &mut part.states), part.islands, interval);
    };
    executor.run(parts.iter_mut().map(|part| Box::new(move || task(part)) as Task<'_>).collect());
    let mut reports = Vec::with_capacity(islands.len());
    for part in parts {
        reports.extend(part.reports?);
        for island in part.islands {
            set_states(states, &island.bodies, &states_of(&part.states, &island.bodies));
            stepper.take_from(&part.stepper, &island.bodies, &island.pairs);
        }
    }
    Ok(reports)
}

fn advance_each(
    model: &Model,
    (stepper, states): (&mut TimeStepper, &mut [BodyState]),
    islands: &[Island],
    interval: (f64, f64),
) -> Reports {
    let advance = |island: &Island| {
        let made = stepper.advance(model, states, &island.bodies, &island.pairs, interval);
        made.map_err(|source| SimulationError::of_response(interval.0, source).among(model, &island.bodies))
    };
    islands.iter().map(advance).collect()
}
