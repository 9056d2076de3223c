//! Why there is no judgement.

use polhode::SimulationError;
use polhode::response::ResponseError;
use polhode_scene::TrajectoryError;
use thiserror::Error;

/// Why there is no judgement.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum JudgeError {
    /// The trajectory cannot be read, or is not of the scene.
    #[error(transparent)]
    Trajectory(#[from] TrajectoryError),
    /// A trajectory of one sample has no motion.
    #[error("{0}: it has one sample: two are needed at least")]
    OneSample(String),
    /// Lengths, angles or quaternions are written in another way.
    #[error("{path}: {what}")]
    Units {
        /// The file.
        path: String,
        /// What is found, and what is accepted.
        what: String,
    },
    /// The tolerance is no tolerance.
    #[error("a tolerance of {0}: a number above 0 and below 1 is needed (of sizes, speeds and energies)")]
    Tolerance(f64),
    /// The scene cannot be evaluated in the states of the file.
    #[error(transparent)]
    Scene(#[from] SimulationError),
    /// The impulses of contacts cannot be found.
    #[error("t = {t_s} s: {source}")]
    Reactions {
        /// When, s.
        t_s: f64,
        /// Why.
        source: ResponseError,
    },
}
