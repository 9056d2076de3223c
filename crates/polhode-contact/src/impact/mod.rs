//! Impacts: the time at which two moving shapes touch.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@time_of_impact`] | the entry points |
//! | `impact_search`, `impact_error`, `impact_report` | settings, errors, the result |
//! | `composite_impact` | compounds and meshes, part by part |
//! | `pair_impact` | two shapes without parts |
//! | `impact_bounds`, `quadratic_bound` | for how long a pair certainly stays clear |
//! | `ring_arcs`, `ring_pair`, `arc_cuts` | the same for tori, arc by arc |
//! | `fine_time`, `root_bracket` | refinement of the time beyond the rounding of poses |

mod arc_cuts;
mod composite_impact;
mod fine_time;
mod impact_bounds;
mod impact_error;
mod impact_report;
mod impact_search;
mod pair_impact;
mod quadratic_bound;
mod ring_arcs;
mod ring_pair;
mod root_bracket;
pub mod time_of_impact;
