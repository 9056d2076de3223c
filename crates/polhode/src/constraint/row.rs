//! Rows of bilateral constraints, and the bodies that they are rows of.

use polhode_spatial::DVec3;

/// A body that a constraint holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Member {
    pub(crate) body: usize,
    /// From its centre of mass (of a kinematic body: its origin) to the point at which the force acts, world, m.
    pub(crate) arm: DVec3,
    /// 1 for the first body, -1 for the second.
    pub(crate) sign: f64,
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
    /// Rotation about an axis, times a length (m, world), with displacement along a direction times a part of it (no unit, world).
    Turning {
        /// The direction times its part.
        along: DVec3,
        /// The axis.
        about: DVec3,
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
    /// The kinematic one.
    pub(crate) driver: Option<Member>,
    pub(crate) rows: Vec<BilateralRow>,
}
