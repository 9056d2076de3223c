//! Boxes that bound shapes, still and moving.
//!
//! | module | holds |
//! |---|---|
//! | [`aabb`] | a box along the world's axes |
//! | [`around_shape`] | such boxes around a shape, at a pose and over an interval of a motion |
//! | `box_tree` | many boxes in a tree |
//!
//! Boxes are rounded outwards: a box contains every point of its shape, and an overlap is never missed.

pub mod aabb;
pub mod around_shape;
pub(crate) mod box_tree;

pub(crate) use box_tree::BoxTree;
