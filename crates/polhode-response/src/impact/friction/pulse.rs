//! Several contacts with friction struck as springs that spend what they have taken (Liu, Zhao and Brogliato).
//!
//! The law of `impact = "pulse"` where contacts have friction: normal impulses grow as springs of one stiffness push,
//! those of friction by Coulomb's law at the slip of the moment, so that slip may stop, stick and reverse within the
//! impact, at each contact at its own time (`springs.rs`). A contact that is struck alone follows Routh's path to
//! Stronge's end, which is the same law in closed form. Joints are held throughout.
//!
//! Energy: each contact loses `(1 - e^2) W` of the work `W` that it takes, and what friction takes.
//!
//! How it fails: a body that is wedged and keeps all its energy is compressed without end; beyond [`MOST_COMPRESSIONS`]
//! what approaches still is stopped by one inelastic cone problem ([`ImpactStatus::StoppedAtThreshold`]).
//! Contacts that resist rolling or spinning are no part of the law, and are refused.
//!
//! Source: Liu, Zhao and Brogliato 2008, 2009.

use super::part::{Part, Struck};
use super::reactions::UnitReactions;
use super::sequence::finish;
use super::spring_contact::SpringContact;
use super::springs::{PulseExponent, Springs};
use crate::error::ResponseError;
use crate::impact::ImpactStatus;
use crate::law::Law;

/// Most compressions of an impact (1e3 to 1e5). A body between others is compressed about as often as the root of the
/// ratio of their masses says where no energy is lost, a ratio of some 1e6 here, and as often as that ratio itself
/// where much is lost.
pub(crate) const MOST_COMPRESSIONS: usize = 2_000;

/// Strikes all contacts of a part, whose joints do not move.
pub(super) fn strike_by_springs(
    part: &mut Part,
    struck: &mut Struck,
    exponent: PulseExponent,
    limit: usize,
) -> Result<(), ResponseError> {
    let contacts = part.touching();
    for &block in &contacts {
        if !matches!(part.contacts.blocks()[block], Law::Push | Law::Cone { .. }) {
            return Err(ResponseError::PulseOfRotation { block });
        }
    }
    let rows: Vec<usize> = contacts.iter().flat_map(|&block| part.contact_rows(block)).collect();
    let reactions = UnitReactions::of(part, rows.iter().copied())?;
    let entry = |i: usize, j: usize| 0.5 * reactions.changes[j][rows[i]] + 0.5 * reactions.changes[i][rows[j]];
    let count = rows.len();
    let matrix = (0..count * count).map(|k| entry(k / count, k % count)).collect();
    let from = rows.iter().map(|&row| struck.velocities[row]).collect();
    let mut first = 0;
    let springs = contacts.iter().map(|&block| {
        let (row, law) = (first, part.contacts.blocks()[block]);
        first += law.rows();
        let (friction, restitution) = (law.friction().unwrap_or_default(), part.restitution[block]);
        SpringContact { row, tangents: law.rows() - 1, friction, restitution }
    });
    let Some(springs) = Springs::of(springs.collect(), matrix, from, exponent) else { return Ok(()) };
    let sprung = springs.run(MOST_COMPRESSIONS.min(limit));
    if !sprung.ended {
        part.status = part.status.max(ImpactStatus::StoppedAtThreshold);
    }
    for ((unit, change), amount) in reactions.impulses.iter().zip(&reactions.changes).zip(&sprung.impulses) {
        for row in 0..unit.len() {
            struck.impulses[row] += amount * unit[row];
            struck.velocities[row] += amount * change[row];
        }
    }
    for (&block, [normal, friction]) in contacts.iter().zip(&sprung.works) {
        struck.normal_work[block] += normal;
        struck.friction_work[block] += friction;
    }
    struck.applications += contacts.len();
    part.hold_joints(&mut struck.velocities);
    for (&block, _) in contacts.iter().zip(&sprung.sticks).filter(|(_, sticks)| **sticks) {
        let range = part.contact_rows(block);
        struck.velocities[range.start + 1..range.end].fill(0.0);
    }
    let approaches = contacts.iter().any(|&block| struck.velocities[part.normal_row(block)] < 0.0);
    let status = part.status;
    if approaches {
        finish(part, struck)?;
    }
    if sprung.ended && part.status == ImpactStatus::StoppedAtThreshold {
        // What approaches still is the error of the steps, and no sequence cut off.
        part.status = status;
    }
    Ok(())
}
