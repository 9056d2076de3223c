//! Impacts: when two moving shapes close.

mod arc_cuts;
mod composite_impact;
mod fine_time;
mod impact_bounds;
pub(crate) mod quadratic_bound;
mod ring_arcs;
mod ring_pair;
mod root_bracket;
pub mod time_of_impact;
