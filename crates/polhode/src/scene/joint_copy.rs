//! Joints in a space set otherwise.
//!
//! Axes about which bodies turn go as angular velocities do (`polhode_spatial::isometry`), so that angles keep their
//! signs; axes along which they slide go as directions do, so that displacements keep theirs. An axis that is both
//! cannot do both in a mirror: it keeps the angle, a screw changes its hand, and the displacement of a cylindrical
//! joint changes its sign with all that acts along it.

use super::freedom::{Coordinate, Freedom};
use super::joint::{Joint, JointKind};
use super::track::{Follows, OneSide, TrackHold};
use crate::identity::body_id::BodyId;
use polhode_spatial::{Handedness, Isometry};

/// The sign that a coordinate takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    Kept,
    Changed,
}

impl Sign {
    /// 1 or -1.
    pub(super) const fn factor(self) -> f64 {
        match self {
            Self::Kept => 1.0,
            Self::Changed => -1.0,
        }
    }

    fn of(self, freedom: Freedom) -> Freedom {
        match self {
            Self::Kept => freedom,
            Self::Changed => freedom.reversed(),
        }
    }
}

impl Joint {
    /// The joint in a space set otherwise, between bodies of other numbers.
    pub(super) fn moved(&self, space: &Isometry, number: impl Fn(BodyId) -> BodyId) -> Self {
        let kind = self.kind().moved(space);
        let bare = Self::new(kind, number(self.body()), space.point(self.anchor()))
            .of(number(self.body()), self.other().map(&number));
        let along = |joint: Self, coordinate: Coordinate| match self.freedom(coordinate) {
            None => joint,
            Some(freedom) => joint.along(coordinate, self.kind().sign(coordinate, space.handedness()).of(freedom)),
        };
        let joint = Coordinate::ALL.into_iter().fold(bare, along);
        match self.strength() {
            None => joint,
            Some(strength) => joint.breaking_at(strength),
        }
    }
}

impl JointKind {
    /// The sign of a coordinate in a space set otherwise.
    pub(super) fn sign(self, coordinate: Coordinate, handedness: Handedness) -> Sign {
        match (self, coordinate, handedness) {
            (Self::Cylindrical { .. }, Coordinate::Displacement, Handedness::Mirrored) => Sign::Changed,
            _ => Sign::Kept,
        }
    }

    fn moved(self, space: &Isometry) -> Self {
        match self {
            Self::Ball | Self::Fixed => self,
            Self::Hinge { axis } => Self::Hinge { axis: space.axis(axis) },
            Self::Universal { axes } => Self::Universal { axes: axes.map(|axis| space.axis(axis)) },
            Self::Slider { axis } => Self::Slider { axis: space.direction(axis) },
            Self::Cylindrical { axis } => Self::Cylindrical { axis: space.axis(axis) },
            Self::Screw { axis, lead } => {
                let lead = match space.handedness() {
                    Handedness::Kept => lead,
                    Handedness::Mirrored => -lead,
                };
                Self::Screw { axis: space.axis(axis), lead }
            }
            Self::Planar { normal } => Self::Planar { normal: space.direction(normal) },
            Self::Rod { to } => Self::Rod { to: space.point(to) },
            Self::Rope { to } => Self::Rope { to: space.point(to) },
            Self::Track { track, hold, ends } => Self::Track { track, hold: hold.moved(space), ends },
        }
    }
}

impl TrackHold {
    fn moved(self, space: &Isometry) -> Self {
        match self {
            Self::Both(Follows::Frame { up: Some(up) }) => Self::Both(Follows::Frame { up: Some(space.direction(up)) }),
            Self::OneSide(side) => Self::OneSide(OneSide { towards: space.direction(side.towards), ..side }),
            Self::Both(_) | Self::Springs(_) => self,
        }
    }
}
