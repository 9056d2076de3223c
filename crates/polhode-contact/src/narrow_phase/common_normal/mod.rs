//! Common normals: the places at which one line is normal to two elements.

pub(crate) mod branch;
pub(crate) mod curves;
pub(crate) mod minima;
pub(crate) mod places;
