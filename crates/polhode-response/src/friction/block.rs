//! What the rows of one block ask for together: a contact with Coulomb friction, or rows that hold.
//!
//! A contact has a normal row and as many tangential rows as the space has directions along the surface: two in space, one in
//! a plane, none where there is no friction to speak of. Its reaction lies in the cone `|r_t| <= mu r_n`.
//!
//! A contact may resist more than its slip: rolling, by the rows of two axes, and spinning, by that of the normal. Each is a
//! part of its block with a law of Coulomb's kind: `|r_i| <= mu_i r_n` where `u_i = 0`, and `r_i = -mu_i r_n u_i/|u_i|` where
//! not. Rows of rotations are angular velocities times a length, so that their reactions are moments over that length.

use crate::error::ResponseError;
use std::ops::Range;

/// Most rows of a contact that resists its slip alone: the normal and two tangents.
pub(crate) const CONTACT_ROWS: usize = 3;

/// Most rows of a block: those of a contact, two axes of rolling and that of spinning.
pub(crate) const MOST_ROWS: usize = 6;

/// Parts of a contact that resist: its slip, its rolling, its spinning.
pub(crate) const PARTS: usize = 3;

/// Most rows of each part.
const ROWS_OF_PARTS: [usize; PARTS] = [2, 2, 1];

/// Rows of a contact that slides.
const SLIDING_ROWS: usize = 2;

/// What a contact resists along some of its rows, up to a part of its normal reaction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Resistance {
    /// Rows, orthogonal to each other; 0 for what is not resisted.
    pub rows: usize,
    /// The largest reaction over the normal one (no unit, at least 0).
    pub friction: f64,
    /// Whether the contact moves already along the one row: its reaction there is `-friction r_n`.
    pub slides: bool,
}

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
    /// A contact that resists its slip (at most 2 rows), its rolling (2) and its spinning (1), in this order after the
    /// normal row.
    Resisted {
        /// What it resists; parts of no rows are left out.
        parts: [Resistance; PARTS],
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
            Self::Resisted { parts: [slip, roll, spin] } => 1 + slip.rows + roll.rows + spin.rows,
        }
    }

    /// Whether it is a contact that resists rotations.
    pub const fn resists_rotation(self) -> bool {
        matches!(self, Self::Resisted { .. })
    }

    /// The rows of each part of a contact that resists, counted from its normal row, and what it resists.
    pub(crate) fn parts(self) -> [(Range<usize>, Resistance); PARTS] {
        let slip = |rows: usize, friction: f64, slides: bool| {
            [Resistance { rows, friction, slides }, Resistance::default(), Resistance::default()]
        };
        let parts = match self {
            Self::Contact { rows, friction } => slip(rows.saturating_sub(1), friction, false),
            Self::Sliding { friction } => slip(SLIDING_ROWS - 1, friction, true),
            Self::Resisted { parts } => parts,
            Self::Bilateral { .. } => Default::default(),
        };
        let mut first = 1;
        parts.map(|part| {
            let rows = first..first + part.rows;
            first = rows.end;
            (rows, part)
        })
    }

    /// The coefficient of friction of its slip; none for rows that are held.
    pub const fn friction(self) -> Option<f64> {
        match self {
            Self::Resisted { parts: [slip, ..] } => Some(slip.friction),
            Self::Contact { friction, .. } | Self::Sliding { friction } => Some(friction),
            Self::Bilateral { .. } => None,
        }
    }

    /// Checks rows and coefficient; `block` is its index, for the message.
    pub(crate) fn check(self, block: usize) -> Result<(), ResponseError> {
        if !(1..=MOST_ROWS).contains(&self.rows()) {
            return Err(ResponseError::FrictionRows { block, rows: self.rows() });
        }
        for ((_, part), most) in self.parts().into_iter().zip(ROWS_OF_PARTS) {
            let friction = part.friction;
            if !(friction >= 0.0 && friction.is_finite()) {
                return Err(ResponseError::Friction { contact: block, friction });
            }
            if part.rows > if part.slides { 1 } else { most } {
                return Err(ResponseError::FrictionRows { block, rows: self.rows() });
            }
        }
        match self {
            Self::Contact { rows, .. } | Self::Bilateral { rows } if rows > CONTACT_ROWS => {
                Err(ResponseError::FrictionRows { block, rows })
            }
            _ => Ok(()),
        }
    }
}
