//! Why there is no answer.

use polhode::SimulationError;
use polhode_scene::SceneFileError;
use thiserror::Error;

/// Why there is no answer.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum StandsError {
    /// The scene is refused.
    #[error(transparent)]
    Scene(Box<SceneFileError>),
    /// The engine ends.
    #[error("{scene}: {source}")]
    Simulation {
        /// Name of the scene.
        scene: String,
        /// Why.
        source: Box<SimulationError>,
    },
    /// The text of an interval is none.
    #[error(
        "{0}: KEY=LOW..HIGH is needed, two finite numbers, the smaller one first, as materials.wood.friction=0.1..0.8"
    )]
    Interval(String),
    /// A number of digits that is none.
    #[error("{found} digits: 1 to {most} are accepted")]
    Digits {
        /// What was asked for.
        found: u32,
        /// The most.
        most: u32,
    },
    /// Both ends stand, or both do not, so that there is no limit to be found between them.
    #[error(
        "{key}: it {does} at {low} and at {high}: give an interval at one end of which it stands, and not at the other"
    )]
    SameAtBothEnds {
        /// The key.
        key: String,
        /// The smaller value.
        low: String,
        /// The larger value.
        high: String,
        /// What it does at both, in words.
        does: &'static str,
    },
    /// The caller has ended the search.
    #[error("the search has been stopped")]
    Stopped,
}

impl From<SceneFileError> for StandsError {
    fn from(error: SceneFileError) -> Self {
        Self::Scene(Box::new(error))
    }
}
