//! Why there is no sweep.

use polhode_scene::SceneFileError;
use thiserror::Error;

/// Why there is no sweep.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The scene is refused, or a value of a list in it.
    #[error(transparent)]
    Scene(#[from] SceneFileError),
    /// What is to be varied is refused.
    #[error("--vary {0}")]
    Vary(String),
    /// A measure is refused.
    #[error("measure {text}: {why}; accepted: {accepted}")]
    Measure {
        /// As it was written.
        text: String,
        /// What is wrong with it.
        why: String,
        /// What is accepted.
        accepted: &'static str,
    },
    /// Two columns would have one name.
    #[error("the table would have two columns `{0}`: name the measure, as NAME=...")]
    Column(String),
    /// Too many runs, or none.
    #[error("{runs} runs: 1 to {most} are accepted; make several sweeps with other seeds")]
    Runs {
        /// How many were asked for, in words.
        runs: String,
        /// The most.
        most: u64,
    },
    /// A number of draws, where nothing is drawn, or none where something is.
    #[error("{0}")]
    Draws(String),
    /// The scene does not take an end of a range that is uncertain.
    #[error("uncertain {key} reaches {value}, which the scene refuses: {why}; give limits within what is accepted")]
    Reach {
        /// The key.
        key: String,
        /// The value.
        value: String,
        /// Why it is refused.
        why: String,
    },
    /// A share of the runs that is none.
    #[error("shard {0}: I/N is needed, with 1 <= I <= N, as 2/8")]
    Shard(String),
    /// A file that holds something else.
    #[error("{path}: {why}; nothing was written: give another path, or move the file away")]
    Foreign {
        /// The file.
        path: String,
        /// What it is.
        why: String,
    },
    /// A file that cannot be read or written.
    #[error("{path}: {source}")]
    File {
        /// The file.
        path: String,
        /// Why.
        source: std::io::Error,
    },
    /// The caller has ended it: what is finished is in its file.
    #[error("the sweep has been stopped")]
    Stopped,
}
