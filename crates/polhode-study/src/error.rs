//! Why there is no study, or no answer in it.

use polhode_scene::SceneFileError;
use thiserror::Error;

/// Why there is no study, or no answer in it.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum StudyError {
    /// The scene is refused.
    #[error(transparent)]
    Scene(#[from] SceneFileError),
    /// What is to be varied is refused.
    #[error("{0}")]
    Axis(String),
    /// There is nothing to compare candidates with.
    #[error("{0}")]
    NoReference(String),
    /// An accuracy is no positive number.
    #[error("{value}: an accuracy is a positive number, the largest error that is accepted")]
    Accuracy {
        /// What was given.
        value: f64,
    },
    /// No candidate reaches the accuracy.
    #[error("no method reaches an error of {asked:e}: {best}")]
    NotReached {
        /// The largest error that is accepted.
        asked: f64,
        /// The most accurate candidate, and its error.
        best: String,
    },
    /// The host has ended the study.
    #[error("the study has been stopped")]
    Stopped,
}
