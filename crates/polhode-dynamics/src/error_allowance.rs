//! What a step may err in each quantity of a body, and the largest error in units of that.
//!
//! | quantity | error | unit |
//! |---|---|---|
//! | position | length of the vector | m |
//! | attitude | length of the quaternion's error: half an angle | 1 |
//! | velocity | length of the vector | m/s |
//! | angular momentum | length of the vector | kg m^2/s |
//!
//! The largest ratio of an error to its allowance decides about a step ([`crate::step_control`]), not the mean over all
//! numbers: a mean grows more lenient with every body, and with every number that happens to have no error.

use crate::Dop853;
use crate::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH};
use std::ops::Range;

/// The error of the quaternion that an error of the attitude of 1 rad is: its angle is twice the quaternion's.
const QUATERNION_PER_ANGLE: f64 = 0.5;

/// A quaternion whose length at the end of a step differs from one by more than this (no unit, 1e-4 to 1e-1) is no
/// attitude: motion keeps the length, so that the step errs by as much, and what its errors are compared with (speeds
/// and loads at its end) is of no use. Steps that converge change it by 1e-9 at most.
const NO_ATTITUDE: f64 = 1e-3;

/// The error allowed in each quantity of one body over one step; none by default.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorAllowance {
    /// m.
    pub position: f64,
    /// Of the quaternion (no unit).
    pub quaternion: f64,
    /// m/s.
    pub velocity: f64,
    /// kg m^2/s.
    pub angular_momentum: f64,
}

impl ErrorAllowance {
    /// What an attitude may err in its quaternion, where it may err by an angle (rad).
    pub const fn of_angle(angle: f64) -> f64 {
        QUATERNION_PER_ANGLE * angle
    }

    /// Whether all of it can be compared with.
    pub fn is_finite(&self) -> bool {
        [self.position, self.quaternion, self.velocity, self.angular_momentum].into_iter().all(f64::is_finite)
    }

    /// At least what `other` allows of each.
    pub fn at_least(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            quaternion: self.quaternion.max(other.quaternion),
            velocity: self.velocity.max(other.velocity),
            angular_momentum: self.angular_momentum.max(other.angular_momentum),
        }
    }

    /// Where the numbers of each quantity are in the body's state, and the error allowed in them.
    pub const fn by_quantity(self) -> [(Range<usize>, f64); 4] {
        [
            (POSITION..QUATERNION, self.position),
            (QUATERNION..LINEAR_VELOCITY, self.quaternion),
            (LINEAR_VELOCITY..ANGULAR_MOMENTUM, self.velocity),
            (ANGULAR_MOMENTUM..WIDTH, self.angular_momentum),
        ]
    }
}

/// The largest of the errors of a step in units of what is allowed for each: NaN as soon as one is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LargestError(f64);

impl LargestError {
    /// Takes in an error and what is allowed for it, both in the unit of their quantity.
    pub fn include(&mut self, error: f64, allowed: f64) {
        // No error is none also where nothing is allowed.
        let ratio = if error == 0.0 { 0.0 } else { error / allowed };
        if ratio > self.0 || ratio.is_nan() {
            self.0 = ratio;
        }
    }

    /// Takes in the errors that a method estimates for the body whose state begins at `offset`: NaN where its attitude
    /// at the end is none.
    pub fn include_body(&mut self, method: &Dop853, offset: usize, allowance: ErrorAllowance) {
        let quaternion = method.end_state().get(offset + QUATERNION..offset + LINEAR_VELOCITY).unwrap_or_default();
        let drift = quaternion.iter().map(|part| part * part).sum::<f64>().sqrt() - 1.0;
        let is_attitude = drift.abs() <= NO_ATTITUDE;
        if !is_attitude {
            self.0 = f64::NAN;
        }
        for (quantity, allowed) in allowance.by_quantity() {
            self.include(method.error_of(offset + quantity.start..offset + quantity.end), allowed);
        }
    }

    /// The largest so far, in units of what is allowed.
    pub const fn get(self) -> f64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::{ErrorAllowance, LargestError};
    use crate::state::{QUATERNION, WIDTH};
    use crate::{Dop853, System};
    use std::convert::Infallible;

    /// A spin that a stiff torque of drag overshoots within a step leaves a quaternion that is no rotation: the step is
    /// refused, whatever its errors are compared with.
    #[test]
    fn a_step_whose_attitude_is_none_is_refused() {
        let mut flat = vec![0.0; WIDTH];
        flat[QUATERNION] = 1.0;
        let spun = |rate: f64| {
            let mut method = Dop853::new(WIDTH);
            let mut system = Growing(rate);
            let Ok(()) = method.attempt_unscaled(&mut system, 0.0, &flat, 1.0);
            let mut largest = LargestError::default();
            let allowed = ErrorAllowance { quaternion: f64::MAX, position: 1.0, velocity: 1.0, angular_momentum: 1.0 };
            largest.include_body(&method, 0, allowed);
            largest.get()
        };
        assert_eq!(spun(0.0), 0.0);
        assert!(spun(3.0).is_nan());
    }

    /// A quaternion that grows at a rate (1/s).
    struct Growing(f64);

    impl System for Growing {
        type Error = Infallible;

        fn dimension(&self) -> usize {
            WIDTH
        }

        fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
            rates.fill(0.0);
            rates[QUATERNION] = self.0 * state[QUATERNION];
            Ok(())
        }
    }

    #[test]
    fn the_largest_error_is_nan_once_one_is() {
        let mut largest = LargestError::default();
        largest.include(0.0, 0.0);
        largest.include(1.0, 4.0);
        assert_eq!(largest.get(), 0.25);
        largest.include(f64::NAN, 1.0);
        largest.include(2.0, 1.0);
        assert!(largest.get().is_nan());
    }
}
