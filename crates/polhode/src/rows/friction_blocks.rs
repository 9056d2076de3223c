//! The blocks of contacts with friction: their laws over the rows of an assembly.
//!
//! An assembly holds all normal rows first, then those of pivots, then those along tangents, then those of rotations. A
//! law is stated for the rows of one contact together. Rows along and across a grain are scaled, so that their ellipse
//! of friction becomes a circle (`crate::collision::friction_ellipse`).

use crate::collision::turn::Turn;
use crate::rows::resisted_rotation::ResistedRotation;
use crate::scene::FrictionEllipse;
use polhode_response::friction::ContactStatus;
use polhode_response::{Answer, Blocks, Law, Resistance, ResistedPart};
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

/// The same blocks with rotations that contacts resist, each in the block of its contact.
pub(crate) fn with_rotations(blocks: Blocks, rotations: &[ResistedRotation]) -> Blocks {
    if rotations.is_empty() {
        return blocks;
    }
    let mut whole = Blocks::default();
    for place in 0..blocks.len() {
        blocks.push_to(&mut whole, place);
        for rotation in rotations.iter().filter(|rotation| rotation.normal == place) {
            let part = part_of(rotation.turn);
            let ResistedRotation { friction, turns: slides, .. } = *rotation;
            let resistance = Resistance { rows: rotation.rows.len(), friction, slides };
            whole.resist(part, resistance, rotation.rows.clone());
        }
    }
    whole
}

/// The direction, in the rows of a rotation, in which the bodies turn, or begin to turn; none while friction holds
/// them. A moment opposes it; where nothing presses there is no moment, and the rotation follows its acceleration.
pub(crate) fn direction_of(solved: &Answer, rotation: &ResistedRotation) -> Option<Vec<f64>> {
    if rotation.turns {
        return Some(vec![1.0; rotation.rows.len()]);
    }
    let part = solved.parts.get(rotation.normal).map(|[_, rolls, spins]| match rotation.turn {
        Turn::Rolling => *rolls,
        Turn::Spinning => *spins,
    });
    if part == Some(ContactStatus::Stick) {
        return None;
    }
    let own = |of: &[f64], sign: f64| {
        rotation.rows.clone().filter_map(|row| of.get(row)).map(|part| sign * part).collect::<Vec<f64>>()
    };
    unit(&own(&solved.reactions, -1.0)).or_else(|| unit(&own(&solved.velocities, 1.0)))
}

/// A vector over its length; none of one that is zero.
fn unit(parts: &[f64]) -> Option<Vec<f64>> {
    let size = parts.iter().fold(0.0, |sum: f64, part| libm::hypot(sum, *part));
    (size > 0.0).then(|| parts.iter().map(|part| part / size).collect())
}
