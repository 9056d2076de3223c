//! The blocks of contacts with friction: their laws over the rows of an assembly.
//!
//! An assembly holds all normal rows first, then those of pivots, then those along tangents, then those of rotations. A
//! law is stated for the rows of one contact together. Rows along and across a grain are scaled, so that their ellipse
//! of friction becomes a circle (`crate::collision::friction_ellipse`).

use crate::collision::turn::Turn;
use crate::scene::FrictionEllipse;
use polhode_response::{Blocks, Law, ResistedPart};
use std::ops::Range;

/// Adds the block of a contact with its normal row and its tangents, friction along which lies in this ellipse.
pub(crate) fn push_contact(blocks: &mut Blocks, ellipse: FrictionEllipse, normal: usize, tangents: Range<usize>) {
    let law = Law::Cone { rows: 1 + tangents.len(), friction: ellipse.largest() };
    let rows = std::iter::once(normal).chain(tangents.clone());
    if tangents.is_empty() || ellipse.is_circle() {
        return blocks.push(law, rows);
    }
    let scales = ellipse.scales();
    blocks.push_scaled(law, rows, std::iter::once(1.0).chain(scales.into_iter().take(tangents.len())));
}

/// The part of a block that is of this rotation.
pub(crate) const fn part_of(turn: Turn) -> ResistedPart {
    match turn {
        Turn::Rolling => ResistedPart::Rolling,
        Turn::Spinning => ResistedPart::Spinning,
    }
}
