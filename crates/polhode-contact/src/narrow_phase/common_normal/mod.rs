//! Common normals: the places at which one line is normal to two elements.
//!
//! | module | holds |
//! |---|---|
//! | `place` | a common normal |
//! | `minima` | the angles once around a circle or cone at which a height is least |
//! | `curves` | the places of a circle and a line, and of two circles |
//! | `places` | those of all pairs of elements |
//! | `branch_offset` | which of two places of a circle is meant |
//! | `chosen_place` | the place that two elements name |

pub(crate) mod branch_offset;
pub(crate) mod chosen_place;
pub(crate) mod curves;
pub(crate) mod minima;
pub(crate) mod place;
pub(crate) mod places;
