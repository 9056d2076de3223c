//! The terms of one contact: its geometry, the time derivatives of its separation, its slip.
//!
//! | module | holds |
//! |---|---|
//! | [`tangential`] | the slip, from the rates of the contact point and the normal |
//! | `crossed_edges` | an edge across an edge |
//! | `surface_distance` | the distance of a point from a feature |
//! | `point_on_surface` | a point on a surface |
//! | `stationary` | two elements at a common normal |
//! | [`evaluate`] | any contact, by the kind of its features |
//! | [`open_face`] | a face along which two bodies pass each other |

pub(crate) mod crossed_edges;
pub mod evaluate;
pub mod open_face;
pub(crate) mod point_on_surface;
pub(crate) mod stationary;
pub(crate) mod surface_distance;
pub mod tangential;
