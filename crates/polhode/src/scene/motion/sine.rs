//! Oscillation about the initial pose.
//!
//! With `s(t) = sin(2 pi f t + phase)` the body's own origin is displaced by `A s(t)`, and the body is turned by the
//! rotation vector `B s(t)`, both in the world; `f` in Hz, `A` in m, `B` in rad.

use super::displacement::Displacement;
use super::error::{MotionError, number, vector, within_reach};
use polhode_spatial::rounding;
use polhode_spatial::{DVec3, Isometry, MotionBounds, Rotation};
use std::f64::consts::TAU;

/// An oscillation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sine {
    amplitude: DVec3,
    rotation: DVec3,
    /// rad/s.
    rate: f64,
    phase: f64,
}

impl Sine {
    pub(super) fn new(amplitude: DVec3, rotation: DVec3, frequency_hz: f64, phase: f64) -> Result<Self, MotionError> {
        let amplitude = vector("the amplitude", amplitude)?;
        let rotation = vector("the angle", rotation)?;
        if number("the frequency", frequency_hz)? <= 0.0 {
            return Err(MotionError::Frequency(frequency_hz));
        }
        let sine = Self { amplitude, rotation, rate: TAU * frequency_hz, phase: number("the phase", phase)? };
        within_reach(&sine.peak())?;
        Ok(sine)
    }

    /// The same in a space set otherwise.
    pub(super) fn moved(&self, space: &Isometry) -> Self {
        Self { amplitude: space.vector(self.amplitude), rotation: space.axial(self.rotation), ..*self }
    }

    /// Bounds over all times.
    fn peak(&self) -> MotionBounds {
        let (length, angle) = (self.amplitude.length(), self.rotation.length());
        MotionBounds {
            speed: length * self.rate,
            acceleration: length * self.rate * self.rate,
            angular_speed: angle * self.rate,
            angular_acceleration: angle * self.rate * self.rate,
        }
    }

    fn argument(&self, t: f64) -> f64 {
        self.rate * t + self.phase
    }

    pub(super) fn at(&self, t: f64) -> Displacement {
        let argument = self.argument(t);
        let (sine, cosine) = (libm::sin(argument), libm::cos(argument));
        let (first, second) = (self.rate * cosine, -self.rate * self.rate * sine);
        Displacement {
            translation: self.amplitude * sine,
            rotation: Rotation::from_rotation_vector(self.rotation * sine),
            velocity: self.amplitude * first,
            angular_velocity: self.rotation * first,
            acceleration: self.amplitude * second,
            angular_acceleration: self.rotation * second,
        }
    }

    pub(super) fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        let (from, to) = (self.argument(t0), self.argument(t1));
        let radius = 0.5 * (to - from).abs() + rounding::DOZEN_TERMS * (1.0 + from.abs() + to.abs());
        let middle = 0.5 * (from + to);
        let (sine, cosine) = (libm::sin(middle).abs(), libm::cos(middle).abs());
        // |cos(m + d)| <= |cos m| + |sin m| |d|, and likewise for the sine; written so that NaN gives the peak.
        let at_most = |value: f64| if value < 1.0 { value } else { 1.0 };
        let fast = at_most(cosine + sine * radius) * (1.0 + rounding::DOZEN_TERMS) + rounding::DOZEN_TERMS;
        let sharp = at_most(sine + cosine * radius) * (1.0 + rounding::DOZEN_TERMS) + rounding::DOZEN_TERMS;
        let peak = self.peak();
        MotionBounds {
            speed: peak.speed * fast,
            acceleration: peak.acceleration * sharp,
            angular_speed: peak.angular_speed * fast,
            angular_acceleration: peak.angular_acceleration * sharp,
        }
    }
}
