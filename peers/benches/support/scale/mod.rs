//! What the bench `scale` is made of: scenes, the two engines, the judge of both, and the table.

pub(crate) mod judge;
pub(crate) mod measured;
pub(crate) mod ours;
pub(crate) mod peer;
pub(crate) mod scenes;
pub(crate) mod table;
