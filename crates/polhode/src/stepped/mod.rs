//! The tier `stepped`: fixed time steps at the level of velocities, with an exact complementarity problem at every
//! step.
//!
//! Every step finds the pairs whose swept boxes overlap, joins their bodies to islands, and advances each island by the
//! time step of Moreau and Jean (`crate::time_stepping`), split at the first 32 of its impacts. Bodies in no island are
//! in free flight; kinematic bodies follow their prescribed motions. Events are not located to rounding and no step is
//! repeated, so that every step succeeds. The error decreases with the step. Penetration that a step leaves is removed
//! by a projection and booked.
//!
//! | module | holds |
//! |---|---|
//! | `facts` | what the tier is: its name, defaults, promise, and what it takes |
//! | `engine` | a run, one step of it, and queries at the present |
//! | `islands` | the islands of a step |
//! | `island_steps` | their time steps, on the threads that the program gives |
//! | `joint_breaks` | what joints bear at the present, and those that break at the end of a step |
//! | `rest` | islands that rest and are left out |
//! | `saved_loads` | the loads of joints over the last step as plain data |
//! | `instant_forces` | what forces and accelerations at one instant are |
//! | `present_forces` | forces and accelerations at one instant, for queries |
//! | `track_ends` | bodies that run off the ends of their tracks |
//! | `unexpected` | pairs of bodies that met within a step although they were not expected to |

mod engine;
pub(crate) mod facts;
mod instant_forces;
mod island_steps;
mod islands;
mod joint_breaks;
mod present_forces;
mod rest;
mod saved_loads;
mod track_ends;
mod unexpected;

pub(crate) use engine::SteppedEngine;
