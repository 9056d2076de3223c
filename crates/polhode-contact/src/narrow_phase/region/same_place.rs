//! When two contacts of one pair of shapes are at the same place.

/// Two contacts, or two vertices, are at the same place when they are nearer than this many place tolerances: each of
/// them may deviate from the edges of the other face by one tolerance.
pub(crate) const SAME_PLACE: f64 = 4.0;
