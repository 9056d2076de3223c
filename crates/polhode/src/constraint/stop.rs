//! Stops: limits of the coordinates of joints, as contacts of the two bodies.
//!
//! At a stop the coordinate `q` (`coordinate.rs`) has reached its limit. Its separation is `q - q_lower` or
//! `q_upper - q`, and its row is that of the coordinate. It closes, strikes, holds, presses and opens by the same rules
//! as a contact of two shapes (thesis 3.4: `0 <= f _|_ chi'' >= 0`); only what touches is different, and it has no
//! friction.
//!
//! Jointed bodies do not collide, so that a pair of bodies has either contacts of its shapes or stops. A joint with the
//! world has its stops between the body and itself: `ContactId::members` says which bodies a contact has.
//!
//! An engine looks at every stop at the start and the end of each step and between them; two crossings between two
//! looks are not seen.

use super::coordinate::{CoordinateAt, Measured};
use super::end::Order;
use super::joint_coordinate::JointCoordinate;
use super::track::Guide;
use crate::scene::{Coordinate, Limits};
use polhode_contact::{ContactGeometry, ContactKinematics};
use std::sync::Arc;

/// On which side of a stop the coordinate is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FreeSide {
    Above,
    Below,
}

impl FreeSide {
    fn sign(self) -> f64 {
        match self {
            Self::Above => 1.0,
            Self::Below => -1.0,
        }
    }
}

/// A limit of a coordinate.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stop {
    measured: Measured,
    /// m; of an angle the length of its arc.
    limit: f64,
    side: FreeSide,
    /// Middle of the range, within half a revolution of which angles are, m.
    middle: f64,
    pub(crate) restitution: f64,
}

impl Stop {
    /// The stops of a coordinate.
    pub(crate) fn of(coordinate: &JointCoordinate) -> impl Iterator<Item = Self> + use<> {
        let JointCoordinate { measured, unit, near, freedom, .. } = coordinate.clone();
        let stop = move |limits: Limits, limit: f64, side| {
            let restitution = limits.restitution();
            let (limit, middle) = (limit * unit, near * unit);
            let measured = measured.clone();
            limit.is_finite().then_some(Self { measured, limit, side, middle, restitution })
        };
        let both = move |limits: Limits| {
            [stop(limits, limits.lower(), FreeSide::Above), stop(limits, limits.upper(), FreeSide::Below)]
        };
        freedom.limits().into_iter().flat_map(both).flatten()
    }

    /// The side of a track that pushes, with this coefficient of restitution.
    pub(crate) fn one_side(guide: &Arc<Guide>, restitution: f64) -> Self {
        let measured = Measured::Height(Arc::clone(guide));
        Self { measured, limit: 0.0, side: FreeSide::Above, middle: 0.0, restitution }
    }

    /// Whether it is the side of a track that pushes.
    pub(crate) fn is_side_of_track(&self) -> bool {
        matches!(self.measured, Measured::Height(_))
    }

    /// The coordinate that it limits; none of the side of a track, which is what the track keeps.
    pub(crate) fn coordinate(&self) -> Option<Coordinate> {
        match self.measured {
            Measured::Angle { .. } => Some(Coordinate::Angle),
            Measured::Displacement { .. } | Measured::Along(_) => Some(Coordinate::Displacement),
            Measured::Distance => Some(Coordinate::Distance),
            Measured::Height(_) => None,
        }
    }

    /// The ends of a track, at these arc lengths (m), with this coefficient of restitution.
    pub(crate) fn at_ends(guide: &Arc<Guide>, [first, last]: [f64; 2], restitution: f64) -> [Self; 2] {
        [(first, FreeSide::Above), (last, FreeSide::Below)].map(|(limit, side)| {
            let measured = Measured::Along(Arc::clone(guide));
            Self { measured, limit, side, middle: limit, restitution }
        })
    }

    /// Where the stop acts in given states; none where the coordinate has no direction.
    pub(crate) fn at(
        &self,
        coordinate: impl FnOnce(&Measured, f64) -> Option<CoordinateAt>,
        order: Order,
    ) -> Option<ContactKinematics> {
        let CoordinateAt { value, rate, bias, point, direction, .. } = coordinate(&self.measured, self.middle)?;
        let sign = self.side.sign();
        let normal = direction * (sign * order.sign());
        Some(ContactKinematics {
            geometry: ContactGeometry { point, normal, separation: (value - self.limit) * sign, margin: f64::INFINITY },
            separation_rate: rate * sign,
            acceleration_bias: bias * sign,
        })
    }
}
