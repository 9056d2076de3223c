//! The tier `stepped`: fixed steps at the level of velocities, with exact complementarity at every step.
//!
//! Every step finds the pairs whose swept boxes meet, joins them to islands, and advances each island on its own by the
//! time step after Moreau and Jean (`crate::time_stepping`), split at a few impacts. Bodies that meet nothing and that
//! no force acts on follow their flight records; kinematic bodies follow their motions exactly. No event is located to
//! rounding and no step is repeated, so that the tier always gets through; its error falls with the step, and overlap
//! is moved out and booked.

mod engine;
mod islands;

pub(crate) use engine::SteppedEngine;
