//! Narrow phase: whether, where and how two shapes touch.

mod closest_feature;
pub mod counterpart;
pub(crate) mod crossed_edges;
pub mod evaluate;
pub(crate) mod face_pair;
pub mod manifold;
pub mod separating_axis;
pub mod separation;

pub(crate) use closest_feature::nearest_feature;
