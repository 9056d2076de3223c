//! A trajectory of any kind that is being read.

use super::csv_samples::CsvSamples;
use super::error::TrajectoryError;
use super::expected::Expected;
use super::json_samples::JsonSamples;
use super::npy_samples::NpySamples;
use crate::trajectory_rows::Velocities;
use polhode::{BodyError, BodySample, Scene};
use std::path::Path;

/// Kinds of trajectory file.
#[derive(Debug, Clone, Copy)]
enum Kind {
    Csv,
    Json,
    Npy,
}

impl Kind {
    /// The kind that a name says; what an interrupted run has kept ends in `.partial` besides, and what a killed
    /// program has left behind in a random word and `.tmp`, with a dot before the name.
    fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy().to_ascii_lowercase();
        let temporary = name.strip_prefix('.').and_then(|name| name.strip_suffix(".tmp")?.rsplit_once('.'));
        let name = temporary.map_or(name.as_str(), |(name, _)| name);
        let (_, ending) = name.strip_suffix(".partial").unwrap_or(name).rsplit_once('.')?;
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
    Csv(Box<CsvSamples>),
    Json(JsonSamples),
    Npy(NpySamples),
}

/// A trajectory that is being read.
#[derive(Debug)]
pub struct TrajectoryReader {
    samples: Samples,
    expected: Expected,
    /// Whether a sample has been read.
    has_begun: bool,
    /// The errors of the last sample read.
    errors: Option<Vec<BodyError>>,
    cut_off: Option<TrajectoryError>,
}

impl TrajectoryReader {
    /// Opens a trajectory of a scene.
    ///
    /// # Errors
    /// When the ending is unknown, or the file cannot be read or does not begin as a trajectory of the scene.
    pub fn open(path: &Path, scene: &Scene) -> Result<Self, TrajectoryError> {
        Self::open_with(path, scene, Velocities::Needed)
    }

    /// The same of one that may lack velocities, which are zero then.
    ///
    /// # Errors
    /// As [`TrajectoryReader::open`].
    pub fn open_with(path: &Path, scene: &Scene, velocities: Velocities) -> Result<Self, TrajectoryError> {
        let expected = Expected::new(scene);
        let samples = match Kind::of(path).ok_or_else(|| TrajectoryError::Ending { path: path.to_owned() })? {
            Kind::Csv => Samples::Csv(Box::new(CsvSamples::open(path, velocities)?)),
            Kind::Json => Samples::Json(JsonSamples::open(path, &expected, velocities)?),
            Kind::Npy => Samples::Npy(NpySamples::open(path, &expected, velocities)?),
        };
        Ok(Self { samples, expected, has_begun: false, errors: None, cut_off: None })
    }

    /// The next sample: its time (s) and all bodies in the order of the scene; nothing at the end. A file that is cut
    /// off, as one of a program that was killed, ends with its last whole sample ([`TrajectoryReader::cut_off`] says
    /// so).
    ///
    /// # Errors
    /// When the file cannot be read or does not go on as a trajectory of the scene, or has no whole sample.
    pub fn next_sample(&mut self) -> Result<Option<(f64, Vec<BodySample>)>, TrajectoryError> {
        if self.cut_off.is_some() {
            return Ok(None);
        }
        let next = match &mut self.samples {
            Samples::Csv(samples) => samples.next(&mut self.expected),
            Samples::Json(samples) => samples.next(&mut self.expected),
            Samples::Npy(samples) => samples.next(&mut self.expected),
        };
        match next {
            Err(error) if self.has_begun && error.is_cut_off() => {
                self.cut_off = Some(error);
                Ok(None)
            }
            next => {
                self.has_begun = true;
                let next = next?;
                self.errors = next.as_ref().and_then(|sample| sample.errors.clone());
                Ok(next.map(|sample| (sample.t_s, sample.bodies)))
            }
        }
    }

    /// Whether the file has velocities.
    pub fn has_velocities(&self) -> bool {
        match &self.samples {
            Samples::Csv(samples) => samples.has_velocities(),
            Samples::Json(samples) => samples.has_velocities(),
            Samples::Npy(samples) => samples.has_velocities(),
        }
    }

    /// The estimated errors of the bodies of the sample that was read last, in the order of the scene; none where the
    /// file has none, or one of them is not known.
    pub fn errors(&self) -> Option<&[BodyError]> {
        self.errors.as_deref()
    }

    /// Where and how the file is cut off, once its last whole sample has been read.
    pub fn cut_off(&self) -> Option<&TrajectoryError> {
        self.cut_off.as_ref()
    }
}
