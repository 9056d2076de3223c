//! Why a playground does not do what was asked.

use polhode::{SceneError, SimulationError};
use polhode_scene::SceneFileError;
use thiserror::Error;

/// Why a playground does not do what was asked.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PlayError {
    /// The scene is refused.
    #[error(transparent)]
    Scene(Box<SceneFileError>),
    /// The engine refuses an action or ends the run.
    #[error(transparent)]
    Simulation(Box<SimulationError>),
    /// A coefficient is refused.
    #[error(transparent)]
    Material(Box<SceneError>),
    /// The number names no body.
    #[error("body number {index} (counted from 0) does not exist: the scene has {bodies} bodies")]
    Body {
        /// What was given.
        index: usize,
        /// How many there are.
        bodies: usize,
    },
    /// A body that forces do not move was to be held.
    #[error("{name} is fixed, or moves as prescribed: forces do not move it; take another body")]
    Fixed {
        /// The body.
        name: String,
    },
    /// A time was asked for that the run has not reached, or that is none.
    #[error("t = {t_s} s: the run has reached {now_s} s, and can go back to a time from 0 to there")]
    Time {
        /// What was asked for, s.
        t_s: f64,
        /// The present, s.
        now_s: f64,
    },
}

impl From<SceneFileError> for PlayError {
    fn from(error: SceneFileError) -> Self {
        Self::Scene(Box::new(error))
    }
}

impl From<SimulationError> for PlayError {
    fn from(error: SimulationError) -> Self {
        Self::Simulation(Box::new(error))
    }
}

impl From<SceneError> for PlayError {
    fn from(error: SceneError) -> Self {
        Self::Material(Box::new(error))
    }
}
