//! What every method checks before it shows states within its last step.

use super::IntegrationError;
use crate::{BodyState, FreeMotion};

/// Checks that `states` are as many as the bodies and as the states `reached` at the end of the step, and that `t` lies
/// in the step, whose ends (s) may be in either order. At its end the states are written, and nothing is left to do:
/// true.
pub(super) fn answered_at_end(
    motion: &FreeMotion<'_>,
    [from, to]: [f64; 2],
    reached: &[BodyState],
    t: f64,
    states: &mut [BodyState],
) -> Result<bool, IntegrationError> {
    if !(from.min(to)..=from.max(to)).contains(&t) {
        return Err(IntegrationError::OutsideStep { t, from, to });
    }
    let bodies = motion.bodies().len();
    for count in [reached.len(), states.len()] {
        if count != bodies {
            return Err(IntegrationError::StateCount { states: count, bodies });
        }
    }
    if t == to {
        states.copy_from_slice(reached);
    }
    Ok(t == to)
}
