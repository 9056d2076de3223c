//! A rotation that friction of rolling or spinning resists, among the rows of a problem: a part of the block of its
//! contact.
//!
//! Its rows are angular velocities times a length (`rows/rotation_row.rs`), and its friction `c / l` bounds their
//! reaction by a part of the normal one, as Coulomb's law bounds that of slip.

use crate::collision::turn::Turn;
use std::ops::Range;

/// A rotation that friction resists, among the rows of a problem.
#[derive(Debug, Clone)]
pub(crate) struct ResistedRotation {
    /// The normal row of its contact, which is the place of its block too.
    pub(crate) normal: usize,
    /// Which rotation it is.
    pub(crate) turn: Turn,
    /// Its own rows.
    pub(crate) rows: Range<usize>,
    /// The length of its friction over that of its rows (no unit).
    pub(crate) friction: f64,
    /// Whether the bodies turn already, along its one row.
    pub(crate) turns: bool,
}
