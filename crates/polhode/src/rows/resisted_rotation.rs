//! A rotation that friction of rolling or spinning resists, among the rows of a problem: a part of the block of its
//! contact.
//!
//! Its rows are angular velocities times a length (`rows/rotation_row.rs`), and its friction `c / l` bounds their
//! reaction by a part of the normal one, as Coulomb's law bounds that of slip.

use crate::collision::turn::Turn;
use crate::model::Model;
use crate::rows::assembly::Assembly;
use crate::rows::friction_blocks::part_of;
use crate::rows::frictional_contact::FrictionalContact;
use crate::rows::rotation_row::RotationRow;
use polhode_response::friction::ContactStatus;
use polhode_response::{Answer, Blocks, Resistance, ResponseError};
use polhode_spatial::DVec3;
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

/// Adds the rows of rotations that friction resists at contacts, in their order. `turning` gives the direction in which
/// the bodies of one turn already (unit vector, world); none where they are held.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn push(
    assembly: &mut Assembly,
    model: &Model,
    contacts: &[Option<FrictionalContact>],
    turning: impl Fn(usize, Turn) -> Option<DVec3>,
) -> Result<Vec<ResistedRotation>, ResponseError> {
    let mut found = Vec::new();
    for (normal, contact) in contacts.iter().enumerate() {
        let Some(contact) = contact else { continue };
        for turn in Turn::ALL {
            let Some(friction) = turn.coefficient(model, (contact.id.a, contact.id.b)) else { continue };
            let along = turning(normal, turn);
            let axes = along.map_or_else(|| contact.axes_of(turn), |along| vec![along]);
            let rows = assembly.problem.len()..assembly.problem.len() + axes.len();
            assembly.push_rotations(axes.into_iter().map(|axis| RotationRow::about(model, contact.id, axis)))?;
            found.push(ResistedRotation { normal, turn, rows, friction, turns: along.is_some() });
        }
    }
    Ok(found)
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
