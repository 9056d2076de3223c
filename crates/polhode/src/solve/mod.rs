//! What the rows of a group are solved for, in all tiers: forces at one instant, impulses of impacts, and the removal
//! of drift. Whether there is friction is decided here, and nowhere above.
//!
//! | module | holds |
//! |---|---|
//! | `accelerations` | forces and accelerations at one instant: which contacts hold, stick and slide |
//! | `held_at_rest` | bodies at rest with many contacts, for limit analysis |
//! | `impact`, `frictional_impact` | impulses of an impact, and of one with friction |
//! | `bounce_friction` | what ending bounces takes, with the friction that belongs to it |
//! | `reactions` | what the rows of a group take: where it acts, what it gives, which work it does |
//! | `rotational_friction` | moments of rolling and spinning: their work and their support |
//! | `projection`, `overlap` | projection of held contacts and joints; removal of penetration |
//! | `closed_loops` | poses at which closed loops of joints are closed, and their rows there |
//! | `contradiction` | whether gears and prescribed motions of joints contradict each other |
//! | `joint_loads` | what joints bear, from the forces of all rows |
//! | `joint_reactions` | reactions of joints alone, under loads that are given |
//! | `open_loads`, `open_contacts` | bearings and contacts whose loads statics leaves open |
//! | `cone_violation` | how far forces are from Coulomb's law |

pub(crate) mod accelerations;
pub(crate) mod bounce_friction;
pub(crate) mod closed_loops;
pub(crate) mod cone_violation;
pub(crate) mod contradiction;
pub(crate) mod frictional_impact;
pub(crate) mod held_at_rest;
pub(crate) mod impact;
pub(crate) mod joint_loads;
pub(crate) mod joint_reactions;
pub(crate) mod open_contacts;
pub(crate) mod open_loads;
pub(crate) mod overlap;
pub(crate) mod projection;
pub(crate) mod reactions;
pub(crate) mod rotational_friction;
