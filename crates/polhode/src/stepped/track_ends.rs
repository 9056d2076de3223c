//! Bodies that run off the ends of their tracks: at the end of the step in which they do, an error of the first order
//! in its length.

use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::joints::released::{self, RunOff};
use crate::report::event::{Event, EventKind};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;

/// Joints whose bodies have run off the ends of their tracks at `t` (s) hold nothing any more.
///
/// # Errors
/// When the forces on the bodies cannot be made.
pub(super) fn let_go_at_ends_of_tracks(core: &mut Core, states: &[BodyState], t: f64) -> Result<(), SimulationError> {
    for RunOff { joint, body, point } in released::run_off(&core.model, states, &core.model.movable) {
        released::release(&mut core.model, &[joint])?;
        core.accounts.add_event(Event { point, ..Event::new(t, EventKind::Detach, BodyId::new(body)) });
    }
    Ok(())
}
