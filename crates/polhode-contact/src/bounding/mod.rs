//! Volumes that bound shapes, still and moving.
//!
//! | module | volume | overlap of two |
//! |---|---|---|
//! | [`aabb`] | box along the world's axes, of still and moving shapes | six comparisons |
//! | [`bounding_sphere`] | smallest ball | one distance |
//! | [`oriented_box`] | box in any direction | separating axes, fifteen of them |
//!
//! `box_tree` sorts many boxes into a tree. All volumes are rounded outwards: a volume contains every point of its shape, and an overlap is never missed.

pub mod aabb;
mod axis_aligned_box;
pub mod bounding_sphere;
pub(crate) mod box_tree;
pub(crate) mod extent;
pub mod oriented_box;

pub use bounding_sphere::BoundingSphere;
pub(crate) use box_tree::{Bounds, BoxTree};
pub use oriented_box::OrientedBox;
