//! Where bodies meet: what every tier does with touching bodies.
//!
//! Collision detection knows no mass and the response knows no shape; here contacts become rows over bodies, bodies
//! become groups, and impulses become momenta.

pub(crate) mod assembly;
pub(crate) mod contact_set;
pub(crate) mod groups;
pub(crate) mod impact;
