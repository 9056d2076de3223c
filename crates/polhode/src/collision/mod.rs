//! Collision detection: which bodies are near each other, and where they touch.
//!
//! | module | holds |
//! |---|---|
//! | `boxes` | swept boxes of moving bodies, and the pairs whose boxes overlap |
//! | `face_patches` | where bodies may touch within a step: points fixed to both bodies, kept while these hardly move |
//! | `inner_borders` | points of patches at a border that other bodies continue |
//! | `touch` | contacts as the engine holds them |
//! | `contact_set` | the contacts of a pair of bodies |
//! | `contact_kinematics` | geometry and rates of a contact in any states |
//! | `friction` | the friction of two bodies at a contact |
//! | `contact_view` | contacts as programs see them |
//! | `covered_borders` | contacts at a border that other bodies continue |
//! | `passing` | bodies that pass over the border of another one without a collision |
//! | `contact_modes` | the modes of a contact between two events |
//! | `friction_mode` | whether an active contact with friction sticks or slides, and in which direction |
//! | `friction_ellipse` | Coulomb's law along and across a grain |
//! | `slip_directions` | the directions in which bodies slip and roll on each other: fewer in planar motion |
//! | `moving_surfaces` | what belts do to the slip of a contact, and the work of their drives |
//! | `turn` | rolling and spinning of two bodies on each other, and whether friction holds them |
//! | `active_contacts` | the active contacts of an island, each with its modes |

pub(crate) mod active_contacts;
pub(crate) mod boxes;
pub(crate) mod contact_kinematics;
pub(crate) mod contact_modes;
pub(crate) mod contact_set;
pub(crate) mod contact_view;
pub(crate) mod covered_borders;
pub(crate) mod face_patches;
pub(crate) mod friction;
mod friction_ellipse;
pub(crate) mod friction_mode;
pub(crate) mod inner_borders;
pub(crate) mod moving_surfaces;
pub(crate) mod passing;
pub(crate) mod slip_directions;
pub(crate) mod touch;
pub(crate) mod turn;
