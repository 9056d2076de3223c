//! Rows of bilateral constraints, and the bodies that they are rows of.

use polhode_response::{ContactProblem, ResponseError};
use polhode_spatial::DVec3;

/// A body that a constraint holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Member {
    pub(crate) body: usize,
    /// From its centre of mass (of a kinematic body: its origin) to the point at which the force acts, world, m.
    pub(crate) arm: DVec3,
    /// 1 for the first body, -1 for the second.
    pub(crate) sign: f64,
    /// Which of two coordinates that are tied to each other it is a body of; the first for all other constraints.
    pub(crate) part: Part,
}

/// One of two coordinates that are tied to each other (`tie.rs`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    First,
    Second,
}

/// Along what the row of a tie acts on the bodies of one of its coordinates, world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Action {
    /// A force along a direction (of any length) at a point, m.
    Force { direction: DVec3, point: DVec3 },
    /// A moment about an axis, times a length, m.
    Moment(DVec3),
}

impl Action {
    /// The same, so many times.
    pub(crate) fn times(self, factor: f64) -> Self {
        match self {
            Self::Force { direction, point } => Self::Force { direction: direction * factor, point },
            Self::Moment(axis) => Self::Moment(axis * factor),
        }
    }

    /// Its entries for a member: linear and angular.
    fn entries(self, member: &Member) -> (DVec3, DVec3) {
        match self {
            Self::Force { direction, .. } => (direction * member.sign, member.arm.cross(direction) * member.sign),
            Self::Moment(axis) => (DVec3::ZERO, axis * member.sign),
        }
    }
}

/// What a row measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RowKind {
    /// Displacement along a direction (unit vector, world).
    Along(DVec3),
    /// Rotation about an axis, times a length (m, world).
    About(DVec3),
    /// Displacement along a direction (unit vector, world) with rotation about an axis, times a length (m, world).
    Helix {
        /// The direction.
        along: DVec3,
        /// The axis.
        about: DVec3,
    },
    /// Rotation about an axis, times a length (m, world), with displacement along a direction times a part of it (no
    /// unit, world).
    Turning {
        /// The direction times its part.
        along: DVec3,
        /// The axis.
        about: DVec3,
    },
    /// Motion along one coordinate with that along another one.
    Tied {
        /// What acts along the first coordinate.
        first: Action,
        /// What acts along the second one.
        second: Action,
    },
}

/// A row of a bilateral constraint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BilateralRow {
    pub(crate) kind: RowKind,
    /// m.
    pub(crate) gap: f64,
    /// m/s.
    pub(crate) rate: f64,
    /// m/s^2.
    pub(crate) bias: f64,
}

impl BilateralRow {
    /// Its entries for a member: linear and angular.
    pub(crate) fn entries(&self, member: &Member) -> (DVec3, DVec3) {
        match self.kind {
            RowKind::Along(direction) => (direction * member.sign, member.arm.cross(direction) * member.sign),
            RowKind::About(axis) => (DVec3::ZERO, axis * member.sign),
            RowKind::Helix { along, about } | RowKind::Turning { along, about } => {
                (along * member.sign, (member.arm.cross(along) + about) * member.sign)
            }
            RowKind::Tied { first, second } => match member.part {
                Part::First => first.entries(member),
                Part::Second => second.entries(member),
            },
        }
    }
}

/// The rows of a constraint in given states, without its identity.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RowsAt {
    /// Where its force acts, world, m.
    pub(crate) point: DVec3,
    /// The movable ones of its bodies.
    pub(crate) members: Vec<Member>,
    /// The kinematic ones.
    pub(crate) drivers: Vec<Member>,
    pub(crate) rows: Vec<BilateralRow>,
}

/// Adds rows in linear and angular velocities in world axes to a problem, whose place of a body is given: a body with
/// two parts in a row has their sum.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn push_in_space(
    problem: &mut ContactProblem,
    place: impl Fn(usize) -> Option<usize>,
    (members, rows): (&[Member], &[BilateralRow]),
) -> Result<(), ResponseError> {
    for row in rows {
        let mut entries: Vec<(usize, [f64; 6])> = Vec::new();
        for member in members {
            let Some(body) = place(member.body) else { continue };
            let (along, about) = row.entries(member);
            let own = [along.x, along.y, along.z, about.x, about.y, about.z];
            match entries.iter_mut().find(|(known, _)| *known == body) {
                Some((_, sum)) => sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own),
                None => entries.push((body, own)),
            }
        }
        entries.sort_by_key(|(body, _)| *body);
        let entries: Vec<(usize, &[f64])> = entries.iter().map(|(body, own)| (*body, &own[..])).collect();
        problem.push_held_row(&entries)?;
    }
    Ok(())
}
