//! The axis along which two bodies separate best.

pub(crate) mod edge_axes;
pub(crate) mod gap;
pub(crate) mod ring;
pub(crate) mod ring_samples;
pub(crate) mod separating_axis;
pub(crate) mod sieve;
