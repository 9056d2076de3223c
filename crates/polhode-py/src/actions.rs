//! What a program gives bodies and joints of a simulation: velocities and motors.

use crate::arguments;
use polhode::scene::{Drive, Motor};
use polhode::spatial::Velocity;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// What drives a coordinate, as Python gives it: exactly one of effort, velocity and position, with what belongs to it.
#[derive(FromPyObject)]
pub(crate) struct Driven {
    #[pyo3(item)]
    effort: Option<f64>,
    #[pyo3(item)]
    velocity: Option<f64>,
    #[pyo3(item)]
    gain: Option<f64>,
    #[pyo3(item)]
    position: Option<f64>,
    #[pyo3(item)]
    stiffness: Option<f64>,
    #[pyo3(item)]
    damping: Option<f64>,
    #[pyo3(item)]
    most: Option<f64>,
}

impl Driven {
    /// The motor; none when nothing is given.
    pub(crate) fn motor(&self) -> PyResult<Option<Motor>> {
        let drive = match *self {
            Self {
                effort: None,
                velocity: None,
                position: None,
                gain: None,
                stiffness: None,
                damping: None,
                most: None,
            } => {
                return Ok(None);
            }
            Self {
                effort: Some(effort),
                velocity: None,
                position: None,
                gain: None,
                stiffness: None,
                damping: None,
                ..
            } => Drive::Effort(effort),
            Self {
                velocity: Some(velocity),
                gain: Some(gain),
                effort: None,
                position: None,
                stiffness: None,
                damping: None,
                ..
            } => Drive::Velocity { velocity, gain },
            Self {
                position: Some(position),
                stiffness: Some(stiffness),
                damping,
                effort: None,
                velocity: None,
                gain: None,
                ..
            } => Drive::Position { position, stiffness, damping: damping.unwrap_or_default() },
            _ => {
                return Err(PyValueError::new_err(
                    "a motor is exactly one of effort; velocity with gain; position with stiffness (and damping)",
                ));
            }
        };
        let motor = Motor::new(drive).and_then(|motor| self.most.map_or(Ok(motor), |most| motor.at_most(most)));
        motor.map(Some).map_err(|error| PyValueError::new_err(error.to_string()))
    }
}

/// A velocity and an angular velocity, zero where none is given.
pub(crate) fn velocity_of(
    velocity: Option<&Bound<'_, PyAny>>,
    angular_velocity: Option<&Bound<'_, PyAny>>,
) -> PyResult<Velocity> {
    let linear = arguments::vector_or_zero("velocity", velocity)?;
    Ok(Velocity::new(linear, arguments::vector_or_zero("angular_velocity", angular_velocity)?))
}
