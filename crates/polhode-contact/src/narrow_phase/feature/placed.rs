//! A shape at a pose.

use crate::Shape;
use polhode_spatial::Pose;

/// A shape at a pose.
#[derive(Clone, Copy)]
pub(crate) struct Placed<'a> {
    pub(crate) shape: &'a Shape,
    pub(crate) pose: &'a Pose,
}

impl<'a> Placed<'a> {
    pub(crate) const fn new(shape: &'a Shape, pose: &'a Pose) -> Self {
        Self { shape, pose }
    }
}
