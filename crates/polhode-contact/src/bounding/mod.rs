//! Boxes that bound shapes at rest and in motion.
//!
//! | module | holds |
//! |---|---|
//! | [`aabb`] | an axis-aligned box |
//! | [`around_shape`] | the box around a shape at a pose, or over an interval of a motion |
//! | `box_tree` | many boxes in a tree |
//! | `floor` | heights of boxes above a half-space |
//!
//! Boxes are rounded outwards: a box contains every point of its shape, and an overlap is never missed.

pub mod aabb;
pub mod around_shape;
pub(crate) mod box_tree;
pub(crate) mod floor;

pub(crate) use box_tree::BoxTree;
