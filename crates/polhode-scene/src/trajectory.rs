//! Reading back a trajectory that a run of a scene has written.
//!
//! The file is the CSV of [`output`](mod@crate::output). It is read sample by sample, whatever its size, and held against the
//! scene: every sample has every body of the scene once, times ascend, every number is finite.

use crate::trajectory_rows::{Row, RowError, Rows};
use polhode::{BodySample, Scene};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Names that an error lists at the most.
const MOST_NAMES: usize = 8;

/// Why a trajectory could not be read.
#[derive(Debug, Error)]
pub enum TrajectoryError {
    /// The file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file is not a whole trajectory of the scene.
    #[error("{}:{line}: not a trajectory of the scene: {reason}", path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: u64,
        /// What is wrong.
        reason: String,
    },
}

impl From<RowError> for TrajectoryError {
    fn from(error: RowError) -> Self {
        match error {
            RowError::Read { path, source } => Self::Read { path, source },
            RowError::Content { path, line, reason } => Self::Content { path, line, reason },
        }
    }
}

/// A trajectory that is being read.
#[derive(Debug)]
pub struct TrajectoryReader {
    rows: Rows,
    scene: String,
    names: Vec<String>,
    number_of: BTreeMap<String, usize>,
    /// The row that begins the next sample.
    next: Option<Row>,
    last_s: f64,
}

impl TrajectoryReader {
    /// Opens a trajectory of a scene.
    ///
    /// # Errors
    /// When the file cannot be read or does not begin as a trajectory with samples.
    pub fn open(path: &Path, scene: &Scene) -> Result<Self, TrajectoryError> {
        let mut rows = Rows::open(path)?;
        let Some(next) = rows.next()? else {
            return Err(rows.content("it has no samples".to_owned()).into());
        };
        let names: Vec<String> = scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let number_of = names.iter().enumerate().map(|(number, name)| (name.clone(), number)).collect();
        let scene = scene.name().to_owned();
        Ok(Self { rows, scene, names, number_of, next: Some(next), last_s: f64::NEG_INFINITY })
    }

    /// The next sample: its time (s) and all bodies in the order of the scene; nothing at the end.
    ///
    /// # Errors
    /// When the file cannot be read or does not go on as a trajectory of the scene.
    pub fn next_sample(&mut self) -> Result<Option<(f64, Vec<BodySample>)>, TrajectoryError> {
        let Some(first) = self.next.take() else { return Ok(None) };
        let time = first.key[0].clone();
        let t: f64 = time.parse().map_err(|_| self.wrong(format!("`{time}` is not a time")))?;
        if !t.is_finite() || t <= self.last_s {
            return Err(self.wrong(format!("t = {time} s does not follow the time before it")));
        }
        self.last_s = t;
        let mut bodies = vec![None; self.names.len()];
        let mut found = 0;
        let mut row = Some(first);
        while let Some(present) = row {
            if present.key[0] != time {
                self.next = Some(present);
                break;
            }
            let number = self.body_of(&present.key[1])?;
            if bodies[number].is_some() {
                return Err(self.wrong(format!("body `{}` stands twice at t = {time} s", present.key[1])));
            }
            bodies[number] = Some(self.sample(&present)?);
            found += 1;
            row = self.rows.next()?;
        }
        if let Some(missing) = bodies.iter().position(Option::is_none) {
            let (name, needed) = (&self.names[missing], self.names.len());
            let cut_off = if self.next.is_none() { "the file is cut off: " } else { "" };
            let reason = format!("{cut_off}t = {time} s has {found} of {needed} bodies; `{name}` is missing");
            return Err(self.wrong(reason));
        }
        Ok(Some((t, bodies.into_iter().flatten().collect())))
    }

    /// Whether the last sample has been read.
    pub fn is_at_end(&self) -> bool {
        self.next.is_none()
    }

    fn body_of(&self, name: &str) -> Result<usize, TrajectoryError> {
        self.number_of.get(name).copied().ok_or_else(|| {
            let known: Vec<_> = self.names.iter().take(MOST_NAMES).map(|name| format!("`{name}`")).collect();
            let more = if self.names.len() > MOST_NAMES { ", ..." } else { "" };
            let list = known.join(", ");
            self.wrong(format!("scene `{}` has no body `{name}`; its bodies are {list}{more}", self.scene))
        })
    }

    fn sample(&self, row: &Row) -> Result<BodySample, TrajectoryError> {
        if let Some(number) = row.numbers.iter().find(|number| !number.is_finite()) {
            return Err(self.wrong(format!("a number of body `{}` is {number}: it must be finite", row.key[1])));
        }
        row.body_sample().map_err(|error| self.wrong(format!("body `{}`: {error}", row.key[1])))
    }

    fn wrong(&self, reason: String) -> TrajectoryError {
        self.rows.content(reason).into()
    }
}
