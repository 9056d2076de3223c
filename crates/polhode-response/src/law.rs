//! The laws of constraints: what the rows of one block ask of their reactions `r` and velocities `u` together.
//!
//! | law | rows | asks for |
//! |---|---|---|
//! | [`Law::Hold`] | any | `u = 0`, reactions of either sign: a pivot, a joint, tangents that stick |
//! | the same, soft | any | `u = -c r` (`ContactProblem::soften`): a spring, a servo |
//! | [`Law::Push`] | 1 | `0 <= r _\|_ u >= 0`: a contact without friction |
//! | [`Law::Cone`] | 1 to 3 | `\|r_t\| <= mu r_n`, and Coulomb's law: a contact with friction |
//! | [`Law::Slide`] | 2 | `r_t = -mu r_n`: a contact that slides already |
//! | [`Law::Resist`] | 1 to 6 | a contact that resists slip, rolling and spinning |
//!
//! The words are the same for impulses and velocities, and for forces and accelerations. A contact has a normal row,
//! the first of its block, and as many tangential rows as the space has directions along the surface: two in space, one
//! in a plane.
//!
//! A contact may resist more than its slip: rolling, by the rows of two axes, and spinning, by that of the normal. Each
//! is a part of its block with a law of Coulomb's kind: `|r_i| <= mu_i r_n` where `u_i = 0`, and
//! `r_i = -mu_i r_n u_i/|u_i|` where not. Rows of rotations are angular velocities times a length, so that their
//! reactions are moments over that length.

use crate::error::ResponseError;
use std::ops::Range;

/// Most rows of a contact that resists its slip alone: the normal and two tangents.
pub(crate) const CONTACT_ROWS: usize = 3;

/// Most rows of a block: those of a contact, two axes of rolling and that of spinning; a joint that holds all relative
/// motion has as many.
pub const MOST_ROWS: usize = 6;

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

/// What the rows of one block, those of a contact or joint, ask for together.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// Rows that are held, `u = 0`, by reactions of either sign: tangents that stick, axes of a joint. Problems with
    /// friction take 1 to 3 rows; a joint of more is several blocks there.
    Hold {
        /// Rows.
        rows: usize,
    },
    /// One row that pushes: `0 <= r _|_ u >= 0`.
    Push,
    /// A contact: the normal row first, then the tangential rows, orthogonal to each other and of one length.
    Cone {
        /// Rows: 3 in space, 2 in a plane, 1 for a contact without tangential rows.
        rows: usize,
        /// Coefficient of friction (dimensionless, at least 0).
        friction: f64,
    },
    /// A contact that slides already: the normal row and the row along the direction of its slip. Its reaction is
    /// `(r_n, -mu r_n)`, whatever the velocity along the slip.
    Slide {
        /// Coefficient of friction (dimensionless, at least 0).
        friction: f64,
    },
    /// A contact that resists its slip (at most 2 rows), its rolling (2) and its spinning (1), in this order after the
    /// normal row.
    Resist {
        /// What it resists; parts of no rows are left out.
        parts: [Resistance; PARTS],
    },
}

impl Law {
    /// How many rows the block has.
    pub const fn rows(self) -> usize {
        match self {
            Self::Cone { rows, .. } | Self::Hold { rows } => rows,
            Self::Push => 1,
            Self::Slide { .. } => SLIDING_ROWS,
            Self::Resist { parts: [slip, roll, spin] } => 1 + slip.rows + roll.rows + spin.rows,
        }
    }

    /// Whether the first row, that along the normal, pushes; all other rows have reactions of either sign.
    pub const fn pushes(self) -> bool {
        !matches!(self, Self::Hold { .. })
    }

    /// Whether some reaction is bounded by that along the normal.
    pub(crate) fn has_friction(self) -> bool {
        self.parts().iter().any(|(rows, _)| !rows.is_empty())
    }

    /// Whether it is a contact that resists rotations.
    pub const fn resists_rotation(self) -> bool {
        matches!(self, Self::Resist { .. })
    }

    /// The rows of each part of a contact that resists, counted from its normal row, and what it resists.
    pub(crate) fn parts(self) -> [(Range<usize>, Resistance); PARTS] {
        let slip = |rows: usize, friction: f64, slides: bool| {
            [Resistance { rows, friction, slides }, Resistance::default(), Resistance::default()]
        };
        let parts = match self {
            Self::Cone { rows, friction } => slip(rows.saturating_sub(1), friction, false),
            Self::Slide { friction } => slip(SLIDING_ROWS - 1, friction, true),
            Self::Resist { parts } => parts,
            Self::Push | Self::Hold { .. } => Default::default(),
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
            Self::Resist { parts: [slip, ..] } => Some(slip.friction),
            Self::Cone { friction, .. } | Self::Slide { friction } => Some(friction),
            Self::Push => Some(0.0),
            Self::Hold { .. } => None,
        }
    }

    /// Checks rows and coefficient; `block` is its index, for the message.
    pub(crate) fn check(self, block: usize) -> Result<(), ResponseError> {
        let rows_within = |most: usize| {
            let rows = self.rows();
            if (1..=most).contains(&rows) { Ok(()) } else { Err(ResponseError::FrictionRows { block, rows }) }
        };
        let coefficient = |friction: f64| {
            let is_one = friction >= 0.0 && friction.is_finite();
            if is_one { Ok(()) } else { Err(ResponseError::Friction { contact: block, friction }) }
        };
        match self {
            Self::Push => Ok(()),
            Self::Hold { .. } => rows_within(CONTACT_ROWS),
            Self::Slide { friction } => coefficient(friction),
            Self::Cone { friction, .. } => rows_within(CONTACT_ROWS).and_then(|()| coefficient(friction)),
            Self::Resist { parts } => {
                rows_within(MOST_ROWS)?;
                for (part, most) in parts.iter().zip(ROWS_OF_PARTS) {
                    coefficient(part.friction)?;
                    if part.rows > if part.slides { 1 } else { most } {
                        return Err(ResponseError::FrictionRows { block, rows: self.rows() });
                    }
                }
                Ok(())
            }
        }
    }
}
