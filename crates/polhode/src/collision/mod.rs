//! Collision detection: which bodies are near each other, and where they touch.
//!
//! | module | holds |
//! |---|---|
//! | `envelope` | the distance from a body within which contacts are looked for |
//! | `boxes` | swept boxes of moving bodies, and the pairs whose boxes overlap |
//! | `face_patches` | where bodies may touch within a step: points fixed to both bodies, kept while these hardly move |
//! | `inner_borders` | points of patches at a border that other bodies continue |
//! | `narrow_phase` | contacts and separation of a pair of shapes, computed with the memory of the pair |
//! | `contact_set` | the contacts of a pair with identity, geometry and time derivatives |
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
pub(crate) mod contact_modes;
pub(crate) mod contact_set;
pub(crate) mod covered_borders;
pub(crate) mod envelope;
pub(crate) mod face_patches;
mod friction_ellipse;
pub(crate) mod friction_mode;
pub(crate) mod inner_borders;
pub(crate) mod moving_surfaces;
pub(crate) mod narrow_phase;
pub(crate) mod passing;
pub(crate) mod slip_directions;
pub(crate) mod turn;
