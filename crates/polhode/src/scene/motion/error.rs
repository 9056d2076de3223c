//! Limits of the numbers of a prescribed motion, and why a motion is refused.

use polhode_spatial::{DVec3, MotionBounds};
use thiserror::Error;

/// Largest magnitude of a number, a speed (m/s, rad/s) and an acceleration (m/s^2, rad/s^2) of a prescribed motion.
/// Products of such numbers do not overflow.
pub const LARGEST: f64 = 1e100;

/// Largest angle between two samples of a table, rad. It is a little less than half a turn, whose sense of rotation is
/// undetermined: the difference allows for the digits that a quaternion may have lost in a file.
pub const LARGEST_TURN: f64 = std::f64::consts::PI - 1e-6;

/// Why a motion is refused. Each message names the value and what is accepted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number is NaN, infinite or larger than [`LARGEST`].
    #[error("{quantity} of a prescribed motion is {value}: a number of at most {LARGEST:e} in magnitude is needed")]
    Number {
        /// What was given.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The frequency of an oscillation is not positive.
    #[error("the frequency of a sine is {0} Hz: a positive number is needed; a body that stands still is a fixed body")]
    Frequency(f64),
    /// A speed or an acceleration of the motion exceeds [`LARGEST`].
    #[error(
        "a prescribed motion reaches {quantity} of {value:e}: at most {LARGEST:e} is accepted; reduce the \
         displacement, or allow more time for it"
    )]
    TooFast {
        /// What is too large, with its unit.
        quantity: &'static str,
        /// Its bound.
        value: f64,
    },
    /// A table has neither positions nor orientations.
    #[error("a table of a prescribed motion has neither positions nor orientations: give one of them, or both")]
    EmptyTable,
    /// A table of fewer than two samples.
    #[error(
        "a table of a prescribed motion has {0} samples: two or more are needed; a body that stands still is a fixed \
         body"
    )]
    TooFewSamples(usize),
    /// The number of positions or orientations is not that of the times.
    #[error("a table of a prescribed motion has {found} {quantity} for {times} times: give one for each time")]
    Count {
        /// What is counted.
        quantity: &'static str,
        /// How many there are.
        found: usize,
        /// How many there should be.
        times: usize,
    },
    /// The times of a table do not increase.
    #[error("times of a prescribed motion must rise: sample {index} has {t} s after {before} s")]
    TimeOrder {
        /// Index of the sample, from 0.
        index: usize,
        /// Its time, s.
        t: f64,
        /// The time of the sample before, s.
        before: f64,
    },
    /// Two successive orientations differ by so much that the sense of rotation between them is undetermined.
    #[error(
        "orientations of a prescribed motion: between sample {before} and sample {index} the body turns by {angle} \
         rad, and at most {LARGEST_TURN} rad is accepted, because half a turn may go either way: add samples between \
         them",
        before = .index.saturating_sub(1)
    )]
    Turn {
        /// Index of the sample, from 0.
        index: usize,
        /// The angle, rad.
        angle: f64,
    },
    /// The initial pose given for the body is not that of the motion at t = 0.
    #[error(
        "the {quantity} given differs by {difference:.2e} {unit} from that of the table at t = 0, {needed:?}: give \
         that {quantity}, or leave it out"
    )]
    Start {
        /// What differs: the position or the orientation.
        quantity: &'static str,
        /// By how much.
        difference: f64,
        /// Unit of the difference.
        unit: &'static str,
        /// What the table has: x y z, or w x y z.
        needed: Vec<f64>,
    },
}

/// `value`, when its magnitude is at most [`LARGEST`].
pub(super) fn number(quantity: &'static str, value: f64) -> Result<f64, MotionError> {
    // Written so that NaN is refused.
    if value.abs() <= LARGEST { Ok(value) } else { Err(MotionError::Number { quantity, value }) }
}

/// `vector`, when the magnitude of each component is at most [`LARGEST`].
pub(super) fn vector(quantity: &'static str, vector: DVec3) -> Result<DVec3, MotionError> {
    for component in vector.to_array() {
        number(quantity, component)?;
    }
    Ok(vector)
}

/// Checks that speeds and accelerations are at most [`LARGEST`].
pub(super) fn within_reach(bounds: &MotionBounds) -> Result<(), MotionError> {
    let quantities = [
        ("a speed in m/s", bounds.speed),
        ("an acceleration in m/s^2", bounds.acceleration),
        ("an angular speed in rad/s", bounds.angular_speed),
        ("an angular acceleration in rad/s^2", bounds.angular_acceleration),
    ];
    // Written so that NaN is refused.
    let found = quantities.into_iter().find(|&(_, value)| !matches!(value, 0.0..=LARGEST));
    found.map_or(Ok(()), |(quantity, value)| Err(MotionError::TooFast { quantity, value }))
}
