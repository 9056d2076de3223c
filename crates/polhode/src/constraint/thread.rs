//! The row of a thread: a displacement along an axis that goes with the rotation about it.
//!
//! With the displacement `q_d`, the angle `q_a` and the lead `h` (m for each revolution, positive for a right-handed
//! thread) it keeps `q_d - h/(2 pi) q_a = 0`. Its forces are a force along the axis and the moment `-h/(2 pi)` of it
//! about the axis. The displacement says which revolution the angle is in. Source: Featherstone 2008, chapter 4
//! (helical joints).

use super::coordinate::Measured;
use super::end::EndKinematics;
use super::row::{BilateralRow, RowKind};
use polhode_spatial::{DVec3, Rotation};
use std::f64::consts::TAU;

/// A displacement along an axis that goes with the rotation about it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Thread {
    displacement: Measured,
    angle: Measured,
    /// Displacement for each radian, m.
    pitch: f64,
}

impl Thread {
    /// That of an axis (unit vector, world) and a lead (m) between bodies with these attitudes.
    pub(crate) fn new((axis, lead): (DVec3, f64), attitudes: (Rotation, Rotation)) -> Self {
        let (displacement, angle) = (Measured::displacement(axis, attitudes.1), Measured::angle(axis, attitudes));
        Self { displacement, angle, pitch: lead / TAU }
    }

    /// Its row; none where the coordinates have no direction.
    pub(crate) fn row(&self, a: &EndKinematics, b: &EndKinematics) -> Option<BilateralRow> {
        const RADIAN: f64 = 1.0;
        let displacement = self.displacement.at(a, b, RADIAN, 0.0)?;
        let angle = self.angle.at(a, b, RADIAN, displacement.value / self.pitch)?;
        let along = displacement.direction;
        let (turns, turning) = (a.angular - b.angular, b.angular.cross(along));
        Some(BilateralRow {
            kind: RowKind::Helix { along, about: along * -self.pitch },
            gap: displacement.value - self.pitch * angle.value,
            rate: displacement.rate - self.pitch * along.dot(turns),
            bias: displacement.bias - self.pitch * turning.dot(turns),
        })
    }
}
