//! A coordinate of a joint in given states: its value, its rate, and the row of forces along it.

use super::row::{BilateralRow, RowKind};
use polhode_spatial::DVec3;

/// A coordinate in given states.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CoordinateAt {
    /// m; of an angle the length of its arc.
    pub(crate) value: f64,
    /// m/s.
    pub(crate) rate: f64,
    /// m/s^2.
    pub(crate) bias: f64,
    /// Where a force along the coordinate acts, world, m.
    pub(crate) point: DVec3,
    /// Its direction on A (unit vector, world).
    pub(crate) direction: DVec3,
    /// Of an angle: the moment on A that such a force of 1 N stands for.
    pub(crate) moment: Option<AsMoment>,
    /// Of an angle: such a force at the lever of B.
    pub(crate) at_second: Option<AtLever>,
}

/// The row of an angle as a moment about the axis, without a lever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AsMoment {
    /// The moment on A of a multiplier of 1 N, N m, world: the axis times the length.
    pub(crate) axis: DVec3,
    /// m/s.
    pub(crate) rate: f64,
    /// m/s^2.
    pub(crate) bias: f64,
}

/// A force at a lever of a body, which stands for the moment about a hinge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AtLever {
    pub(crate) point: DVec3,
    pub(crate) direction: DVec3,
    pub(crate) rate: f64,
    pub(crate) bias: f64,
}

impl CoordinateAt {
    /// That of a row of displacement along a direction (unit vector, world) at a point (m), whose gap is its value.
    pub(crate) fn displacement(row: &BilateralRow, point: DVec3, direction: DVec3) -> Self {
        let BilateralRow { gap: value, rate, bias, .. } = *row;
        Self { value, rate, bias, point, direction, moment: None, at_second: None }
    }

    /// The rate of the coordinate itself, m/s: of an angle not that of its lever, which contains how fast the anchors
    /// part where the joint does not hold them yet, and depends on which way across the axis the lever points.
    pub(crate) fn own_rate(&self) -> f64 {
        self.moment.map_or(self.rate, |moment| moment.rate)
    }

    /// The same with the force of an angle at the lever of B, which turns with that body.
    pub(crate) fn at_lever_of_second(self) -> Self {
        let at = |AtLever { point, direction, rate, bias }| Self { rate, bias, point, direction, ..self };
        self.at_second.map_or(self, at)
    }

    /// The row that keeps the coordinate at a value (m).
    pub(crate) fn row(&self, value: f64) -> BilateralRow {
        BilateralRow { kind: RowKind::Along(self.direction), gap: self.value - value, rate: self.rate, bias: self.bias }
    }
}
