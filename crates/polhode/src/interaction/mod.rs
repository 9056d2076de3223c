//! Interaction of touching bodies, shared by all tiers.
//!
//! Collision detection is independent of masses, and the response is independent of shapes. This module connects them:
//! it assembles constraint rows from contacts, groups connected bodies, applies impulses to momenta, and projects drift
//! away.

pub(crate) mod accelerations;
pub(crate) mod assembly;
pub(crate) mod bounce_friction;
pub(crate) mod cone_violation;
pub(crate) mod friction_blocks;
mod frictional_contact;
pub(crate) mod frictional_impact;
pub(crate) mod groups;
pub(crate) mod impact;
mod least_sliding_forces;
pub(crate) mod locator;
pub(crate) mod many_contacts;
pub(crate) mod overlap;
pub(crate) mod projection;
pub(crate) mod resisted_rotation;
pub(crate) mod rotation_row;
pub(crate) mod rotational_friction;
mod sticking_forces;
