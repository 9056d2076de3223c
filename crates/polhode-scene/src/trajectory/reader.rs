//! A trajectory of any kind that is being read.

use super::csv_samples::CsvSamples;
use super::error::TrajectoryError;
use super::expected::Expected;
use super::json_samples::JsonSamples;
use super::npy_samples::NpySamples;
use polhode::{BodySample, Scene};
use std::path::Path;

/// Kinds of trajectory file.
#[derive(Debug, Clone, Copy)]
enum Kind {
    Csv,
    Json,
    Npy,
}

impl Kind {
    /// The kind that a name says; what an interrupted run has kept ends in `.partial` besides.
    fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy().to_ascii_lowercase();
        let (_, ending) = name.strip_suffix(".partial").unwrap_or(&name).rsplit_once('.')?;
        match ending {
            "csv" => Some(Self::Csv),
            "json" => Some(Self::Json),
            "npy" => Some(Self::Npy),
            _ => None,
        }
    }
}

/// Whether a name is that of a trajectory.
pub fn is_trajectory(path: &Path) -> bool {
    Kind::of(path).is_some()
}

/// The samples of a file.
#[derive(Debug)]
enum Samples {
    Csv(CsvSamples),
    Json(JsonSamples),
    Npy(NpySamples),
}

/// A trajectory that is being read.
#[derive(Debug)]
pub struct TrajectoryReader {
    samples: Samples,
    expected: Expected,
}

impl TrajectoryReader {
    /// Opens a trajectory of a scene.
    ///
    /// # Errors
    /// When the ending is unknown, or the file cannot be read or does not begin as a trajectory of the scene.
    pub fn open(path: &Path, scene: &Scene) -> Result<Self, TrajectoryError> {
        let expected = Expected::new(scene);
        let samples = match Kind::of(path).ok_or_else(|| TrajectoryError::Ending { path: path.to_owned() })? {
            Kind::Csv => Samples::Csv(CsvSamples::open(path)?),
            Kind::Json => Samples::Json(JsonSamples::open(path, &expected)?),
            Kind::Npy => Samples::Npy(NpySamples::open(path, &expected)?),
        };
        Ok(Self { samples, expected })
    }

    /// The next sample: its time (s) and all bodies in the order of the scene; nothing at the end.
    ///
    /// # Errors
    /// When the file cannot be read or does not go on as a trajectory of the scene.
    pub fn next_sample(&mut self) -> Result<Option<(f64, Vec<BodySample>)>, TrajectoryError> {
        match &mut self.samples {
            Samples::Csv(samples) => samples.next(&mut self.expected),
            Samples::Json(samples) => samples.next(&mut self.expected),
            Samples::Npy(samples) => samples.next(&mut self.expected),
        }
    }
}
