//! Impacts: when two moving shapes close.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@time_of_impact`] | the questions |
//! | `impact_search`, `impact_error`, `impact_report` | settings, why there is no answer, the answer |
//! | `composite_impact` | compounds and meshes, part by part |
//! | `pair_impact` | two shapes without parts |
//! | `impact_bounds`, `quadratic_bound` | for how long a pair certainly stays clear |
//! | `ring_arcs`, `ring_pair`, `arc_cuts` | the same of rings, arc by arc |
//! | `fine_time`, `root_bracket` | the time found, finer than poses are rounded |

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
