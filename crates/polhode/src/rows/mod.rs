//! Constraint rows of groups of bodies: collision detection knows no masses, and the response knows no shapes; here
//! contacts and bilateral constraints become rows that the response solves for.
//!
//! | module | holds |
//! |---|---|
//! | `assembly` | the rows of a group: contacts, bilateral constraints, tangents, rotations; what their reactions are |
//! | `answers` | what is asked of them |
//! | `bearing_loads` | bearings that their loads press |
//! | `groups` | bodies that contacts, joints and forces connect |
//! | `frictional_contact`, `friction_blocks` | a contact with friction among the rows, and the laws of its block |
//! | `rotation_row`, `resisted_rotation` | rows of rolling and spinning, and the friction that resists them |
//! | `many_contacts` | which contacts of a pair stand for many |

mod answers;
pub(crate) mod assembly;
mod bearing_loads;
pub(crate) mod friction_blocks;
pub(crate) mod frictional_contact;
pub(crate) mod groups;
pub(crate) mod many_contacts;
pub(crate) mod resisted_rotation;
pub(crate) mod rotation_row;
