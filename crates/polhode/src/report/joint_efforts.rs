//! What acts along the coordinates of a joint, told apart by its cause.

use crate::scene::Coordinate;

/// What acts along a coordinate of a joint, by its cause: about the axis of an angle (N m), along the line of a
/// displacement or a distance (N), on the first body. What a tier does not compute is NaN.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Efforts {
    /// A motor, and what a prescribed motion takes. It is told whether anything moves or not.
    pub drive: f64,
    /// Gears.
    pub gear: f64,
    /// A spring.
    pub spring: f64,
    /// A damper.
    pub damper: f64,
    /// Dry friction, of bearings too.
    pub friction: f64,
    /// The limits of the coordinate.
    pub limit: f64,
}

impl Efforts {
    /// All of them together.
    pub fn sum(&self) -> f64 {
        self.to_array().into_iter().sum()
    }

    /// In the order of the fields.
    pub(crate) const fn to_array(self) -> [f64; 6] {
        let Self { drive, gear, spring, damper, friction, limit } = self;
        [drive, gear, spring, damper, friction, limit]
    }

    /// The same from an array.
    pub(crate) const fn from_array([drive, gear, spring, damper, friction, limit]: [f64; 6]) -> Self {
        Self { drive, gear, spring, damper, friction, limit }
    }
}

/// A cause of what acts along a coordinate beside springs, dampers and motors, which follow from the states.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cause {
    PrescribedMotion,
    Gear,
    Friction,
    Limit,
}

/// The efforts along each coordinate that a joint may have.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct EffortsAlong([Efforts; Coordinate::ALL.len()]);

impl EffortsAlong {
    /// All of them not known.
    pub(crate) const UNKNOWN: Self = Self([Efforts::from_array([f64::NAN; 6]); Coordinate::ALL.len()]);

    /// Those of limits not known, and no others.
    pub(crate) const UNKNOWN_LIMITS: Self =
        Self([Efforts::from_array([0.0, 0.0, 0.0, 0.0, 0.0, f64::NAN]); Coordinate::ALL.len()]);

    /// Those along one coordinate.
    pub(crate) const fn of(&self, coordinate: Coordinate) -> Efforts {
        self.0[coordinate as usize]
    }

    /// Adds one.
    pub(crate) fn add(&mut self, coordinate: Coordinate, cause: Cause, effort: f64) {
        let own = &mut self.0[coordinate as usize];
        match cause {
            Cause::PrescribedMotion => own.drive += effort,
            Cause::Gear => own.gear += effort,
            Cause::Friction => own.friction += effort,
            Cause::Limit => own.limit += effort,
        }
    }

    /// Adds all of others, so many times.
    pub(crate) fn add_times(&mut self, other: &Self, factor: f64) {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            let (mut sum, other) = (own.to_array(), other.to_array());
            sum.iter_mut().zip(other).for_each(|(own, other)| *own += other * factor);
            *own = Efforts::from_array(sum);
        }
    }

    /// As plain numbers.
    pub(crate) fn to_numbers(self) -> [f64; 18] {
        let mut numbers = [0.0; 18];
        for (place, own) in numbers.chunks_mut(6).zip(self.0) {
            place.copy_from_slice(&own.to_array());
        }
        numbers
    }

    /// From plain numbers.
    pub(crate) fn from_numbers(numbers: [f64; 18]) -> Self {
        let mut efforts = Self::default();
        for (own, numbers) in efforts.0.iter_mut().zip(numbers.chunks(6)) {
            let mut array = [0.0; 6];
            array.copy_from_slice(numbers);
            *own = Efforts::from_array(array);
        }
        efforts
    }
}
