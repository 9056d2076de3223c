//! The terms of one contact: its geometry, the time derivatives of its separation, its slip.

pub(crate) mod crossed_edges;
pub mod evaluate;
pub(crate) mod stationary;
pub mod tangential;
