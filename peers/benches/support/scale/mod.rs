//! What the bench `scale` is made of: scenes, the two engines, and the judge of both.

pub(crate) mod judge;
pub(crate) mod ours;
pub(crate) mod peer;
pub(crate) mod scenes;
