//! Where bodies meet: what every tier does with touching bodies.
//!
//! Collision detection knows no mass and the response knows no shape; here contacts become rows over bodies, bodies
//! become groups, impulses become momenta, and what has drifted is put back together.

pub(crate) mod acceleration_problem;
pub(crate) mod assembly;
pub(crate) mod constraint;
pub(crate) mod groups;
pub(crate) mod impact;
pub(crate) mod locator;
pub(crate) mod overlap;
pub(crate) mod projection;
