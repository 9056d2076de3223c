//! Volumes that bound shapes, still and moving.

pub mod aabb;
