//! Where a motor reaches its bound or leaves it: its effort has a corner there, which an integrator of high order does
//! not see.
//!
//! An effort is smooth as long as each motor stays at its upper bound, between its bounds, or at its lower one. A step
//! that passes from one of these phases to another is made again up to the corner, which is located on its dense
//! output: the forces of the other phase act there for the error of that time alone, so that they change a velocity by
//! its square. Phases are looked at where the step begins, at eight times and at its end; a bound that is reached and
//! left again between two looks is not seen.

use super::constrained_step::ConstrainedStep;
use super::locate::PENETRATION_CHECKS;
use super::pace::is_instant;
use crate::constraint::locator::{Side, close_in};
use crate::joints::motors;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use std::convert::Infallible;

/// The first time of a step (s) at which a motor of its bodies reaches its bound or leaves it; none where that is
/// hardly after its start. `states` are overwritten.
pub(super) fn corner_within(core: &Core, step: &ConstrainedStep, states: &mut [BodyState]) -> Option<f64> {
    if !core.model.joints.has_bounded_motors_among(&step.bodies) {
        return None;
    }
    let mut phases = |t: f64| {
        step.states_at(&core.model, t, states);
        motors::phases_of_motors(&core.model, states, &step.bodies)
    };
    let (start, length) = (step.t, step.end - step.t);
    let (mut before, mut own) = (start, phases(start));
    let mut look = 1;
    while look <= PENETRATION_CHECKS {
        let after = start + length * (f64::from(look) / f64::from(PENETRATION_CHECKS));
        if phases(after) == own {
            before = after;
            look += 1;
            continue;
        }
        let side = |t: f64| Ok::<_, Infallible>(if phases(t) == own { Side::Before } else { Side::After });
        let Ok(bracket) = close_in((before, after), side);
        if !is_instant(bracket.after - start, core.settings.step_s) {
            return (bracket.after < step.end).then_some(bracket.after);
        }
        // The step before has ended at this corner, to rounding.
        (before, own) = (bracket.after, phases(bracket.after));
    }
    None
}
