//! What numbers prescribe a motion, and why others do not.

use polhode_spatial::{DVec3, MotionBounds};
use thiserror::Error;

/// Largest magnitude of a number, a speed (m/s, rad/s) and an acceleration (m/s^2, rad/s^2) of a prescribed motion: their
/// products are still numbers.
pub const LARGEST: f64 = 1e100;

/// Largest angle between two samples of a table, rad: half a turn, which may go either way, less the digits that a
/// quaternion in a file may have lost.
pub const LARGEST_TURN: f64 = std::f64::consts::PI - 1e-6;

/// Why a motion is refused. Each message names the value and what is accepted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number is NaN, infinite or beyond every size.
    #[error("{quantity} of a prescribed motion is {value}: a number of at most {LARGEST:e} in magnitude is needed")]
    Number {
        /// What was given.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// An oscillation without a frequency.
    #[error("the frequency of a sine is {0} Hz: a positive number is needed; a body that stands still is a fixed body")]
    Frequency(f64),
    /// The numbers give a speed or an acceleration beyond every size.
    #[error(
        "a prescribed motion reaches {quantity} of {value:e}: at most {LARGEST:e} is accepted; move less, or more slowly"
    )]
    TooFast {
        /// What is too large, with its unit.
        quantity: &'static str,
        /// Its bound.
        value: f64,
    },
    /// A table says neither where the body is nor how it is turned.
    #[error("a table of a prescribed motion has neither positions nor orientations: give one of them, or both")]
    EmptyTable,
    /// A table of fewer than two samples.
    #[error(
        "a table of a prescribed motion has {0} samples: two or more are needed; a body that stands still is a fixed body"
    )]
    TooFewSamples(usize),
    /// There is not one position or orientation for each time.
    #[error("a table of a prescribed motion has {found} {quantity} for {times} times: give one for each time")]
    Count {
        /// What is counted.
        quantity: &'static str,
        /// How many there are.
        found: usize,
        /// How many there should be.
        times: usize,
    },
    /// The times of a table do not rise.
    #[error("times of a prescribed motion must rise: sample {index} has {t} s after {before} s")]
    TimeOrder {
        /// Index of the sample, from 0.
        index: usize,
        /// Its time, s.
        t: f64,
        /// The time of the sample before, s.
        before: f64,
    },
    /// From one sample to the next the body turns by so much that the way is not known.
    #[error(
        "orientations of a prescribed motion: from the sample before to sample {index} the body turns by {angle} rad, \
         and at most {LARGEST_TURN} is accepted, for half a turn may go either way: add samples between them"
    )]
    Turn {
        /// Index of the sample, from 0.
        index: usize,
        /// The angle, rad.
        angle: f64,
    },
    /// The pose given for the start is not the one that the motion has there.
    #[error(
        "the {quantity} given differs by {difference:.2e} {unit} from that of the table at t = 0, {needed:?}: \
         give that, or leave it out"
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

/// `value`, when it is of a size that products of can be formed.
pub(super) fn number(quantity: &'static str, value: f64) -> Result<f64, MotionError> {
    // Written so that NaN is refused.
    if value.abs() <= LARGEST { Ok(value) } else { Err(MotionError::Number { quantity, value }) }
}

/// `vector`, when its components are such numbers.
pub(super) fn vector(quantity: &'static str, vector: DVec3) -> Result<DVec3, MotionError> {
    for component in vector.to_array() {
        number(quantity, component)?;
    }
    Ok(vector)
}

/// Checks that speeds and accelerations are numbers that can be calculated with.
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
