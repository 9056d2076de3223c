//! What the rows of one block ask for together: a contact with Coulomb friction, or rows that hold.
//!
//! A contact has a normal row and as many tangential rows as the space has directions along the surface: two in space, one in
//! a plane, none where there is no friction to speak of. Its reaction lies in the cone `|r_t| <= mu r_n`.

use crate::error::ResponseError;

/// Most rows of a block: the normal and two tangents.
pub(crate) const MOST_ROWS: usize = 3;

/// Rows of a contact that slides.
const SLIDING_ROWS: usize = 2;

/// The rows of one contact or joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionBlock {
    /// A contact: the normal row first, then the tangential rows, orthogonal to each other and of one length.
    Contact {
        /// Rows: 3 in space, 2 in a plane, 1 for a contact without tangential rows.
        rows: usize,
        /// Coefficient of friction (dimensionless, at least 0).
        friction: f64,
    },
    /// A contact that slides already: the normal row and the row along the direction of its slip. Its reaction is
    /// `(r_n, -mu r_n)`, whatever the velocity along the slip.
    Sliding {
        /// Coefficient of friction (dimensionless, at least 0).
        friction: f64,
    },
    /// Rows that are held, `u = 0`, by reactions of either sign: tangents that stick, axes of a joint. 1 to 3 rows; a joint
    /// of more rows is several blocks.
    Bilateral {
        /// Rows.
        rows: usize,
    },
}

impl FrictionBlock {
    /// How many rows the block has.
    pub const fn rows(self) -> usize {
        match self {
            Self::Contact { rows, .. } | Self::Bilateral { rows } => rows,
            Self::Sliding { .. } => SLIDING_ROWS,
        }
    }

    /// The coefficient of friction; none for rows that are held.
    pub const fn friction(self) -> Option<f64> {
        match self {
            Self::Contact { friction, .. } | Self::Sliding { friction } => Some(friction),
            Self::Bilateral { .. } => None,
        }
    }

    /// Checks rows and coefficient; `block` is its index, for the message.
    pub(crate) fn check(self, block: usize) -> Result<(), ResponseError> {
        if !(1..=MOST_ROWS).contains(&self.rows()) {
            return Err(ResponseError::FrictionRows { block, rows: self.rows() });
        }
        match self.friction() {
            Some(friction) if !(friction >= 0.0 && friction.is_finite()) => {
                Err(ResponseError::Friction { contact: block, friction })
            }
            _ => Ok(()),
        }
    }
}
