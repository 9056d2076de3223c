//! The samples of a JSON file: `{"scene": .., "bodies": [..], "columns": [..], "samples": [{"t": .., "states": [..]},
//! ..]}`.
//!
//! Only one sample is in memory. What is read of the object are `bodies` and `columns`, which must stand before
//! `samples`.

use super::counted_bytes::CountedBytes;
use super::error::TrajectoryError;
use super::expected::{CUT_OFF, Expected, Sample};
use crate::output::{COLUMNS, ERROR_COLUMNS, ErrorColumns};
use crate::trajectory_rows::{FIRST_NUMBER, NUMBERS, Velocities, error_of};
use serde::Deserialize;
use serde::de::{DeserializeOwned, IgnoredAny};
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// A sample as it is written; a number that is not finite is written as null.
#[derive(Debug, Deserialize)]
struct WrittenSample {
    t: Option<f64>,
    states: Vec<Vec<Option<f64>>>,
}

/// The samples of a JSON file.
#[derive(Debug)]
pub(super) struct JsonSamples {
    path: PathBuf,
    bytes: CountedBytes<BufReader<File>>,
    /// Numbers of the bodies in the order of the file.
    bodies: Vec<usize>,
    error_columns: ErrorColumns,
    /// How many numbers a body has, those of errors apart.
    numbers: usize,
    is_first: bool,
    has_ended: bool,
}

impl JsonSamples {
    pub(super) fn open(path: &Path, expected: &Expected, velocities: Velocities) -> Result<Self, TrajectoryError> {
        let file = File::open(path).map_err(|source| TrajectoryError::Read { path: path.to_owned(), source })?;
        let bytes = CountedBytes::new(BufReader::new(file));
        let (path, bodies, error_columns) = (path.to_owned(), Vec::new(), ErrorColumns::Absent);
        let numbers = NUMBERS;
        let mut samples = Self { path, bytes, bodies, error_columns, numbers, is_first: true, has_ended: false };
        samples.read_head(expected, velocities)?;
        Ok(samples)
    }

    /// Reads up to the first sample.
    fn read_head(&mut self, expected: &Expected, velocities: Velocities) -> Result<(), TrajectoryError> {
        self.take(b'{')?;
        let (mut bodies, mut columns) = (None::<Vec<String>>, None::<Vec<String>>);
        loop {
            let key: String = self.value("a key")?;
            self.take(b':')?;
            match key.as_str() {
                "samples" => break,
                "bodies" => bodies = Some(self.value("a list of names")?),
                "columns" => columns = Some(self.value("a list of names")?),
                _ => drop::<IgnoredAny>(self.value("a value")?),
            }
            self.take(b',')?;
        }
        let columns = columns.unwrap_or_default();
        let kinds = velocities.widths().iter().flat_map(|&width| {
            [ErrorColumns::Absent, ErrorColumns::Written].map(|errors| (&COLUMNS[FIRST_NUMBER..width], errors))
        });
        let mut kinds = kinds.filter(|(numbers, errors)| columns == [numbers, errors.names()].concat());
        let Some((numbers, error_columns)) = kinds.next() else {
            let lists: Vec<String> =
                velocities.widths().iter().map(|&width| COLUMNS[FIRST_NUMBER..width].join(", ")).collect();
            let (list, more) = (lists.join(", or "), ERROR_COLUMNS.join(", "));
            return Err(self.wrong(format!("`columns` must stand before `samples` and be {list}, or that and {more}")));
        };
        (self.numbers, self.error_columns) = (numbers.len(), error_columns);
        let bodies = bodies.ok_or_else(|| self.wrong("`bodies` must stand before `samples`".to_owned()))?;
        for name in &bodies {
            let number = expected.body(name).map_err(|reason| self.wrong(reason))?;
            if self.bodies.contains(&number) {
                return Err(self.wrong(format!("body `{name}` stands twice in `bodies`")));
            }
            self.bodies.push(number);
        }
        if let Some(missing) = (0..expected.count()).find(|number| !self.bodies.contains(number)) {
            return Err(self.wrong(format!("body `{}` of the scene is missing in `bodies`", expected.name(missing))));
        }
        self.take(b'[')
    }

    pub(super) fn has_velocities(&self) -> bool {
        self.numbers == NUMBERS
    }

    pub(super) fn next(&mut self, expected: &mut Expected) -> Result<Option<Sample>, TrajectoryError> {
        if self.has_ended {
            return Ok(None);
        }
        let is_first = std::mem::take(&mut self.is_first);
        if self.mark()? == b']' {
            if is_first {
                return Err(self.wrong("it has no samples".to_owned()));
            }
            self.bytes.skip();
            self.take(b'}')?;
            self.has_ended = true;
            return Ok(None);
        }
        if !is_first {
            self.take(b',')?;
        }
        let written: WrittenSample = self.value("a sample {\"t\": .., \"states\": [..]}")?;
        let t = expected.time(written.t.unwrap_or(f64::NAN)).map_err(|reason| self.wrong(reason))?;
        if written.states.len() != self.bodies.len() {
            let (found, needed) = (written.states.len(), self.bodies.len());
            return Err(self.wrong(format!("t = {t:?} s has {found} of {needed} bodies")));
        }
        let (mut states, mut errors) = (vec![None; self.bodies.len()], vec![None; self.bodies.len()]);
        for (&number, row) in self.bodies.iter().zip(written.states) {
            let row: Vec<f64> = row.into_iter().map(|number| number.unwrap_or(f64::NAN)).collect();
            let needed = self.numbers + self.error_columns.names().len();
            let Some((read, error)) = row.split_at_checked(self.numbers).filter(|_| row.len() == needed) else {
                let name = expected.name(number);
                return Err(self.wrong(format!("body `{name}` has {} of {needed} numbers", row.len())));
            };
            let mut numbers = [0.0; NUMBERS];
            numbers.iter_mut().zip(read).for_each(|(own, read)| *own = *read);
            let error = error.first_chunk().copied().map_or(Ok(None), error_of);
            errors[number] = error.map_err(|reason| self.wrong(reason))?;
            states[number] = Some(expected.state(number, numbers).map_err(|reason| self.wrong(reason))?);
        }
        let (bodies, errors) = (states.into_iter().flatten().collect(), errors.into_iter().collect());
        Ok(Some(Sample { t_s: t, bodies, errors }))
    }

    /// The next byte that is no space.
    fn mark(&mut self) -> Result<u8, TrajectoryError> {
        let mark =
            self.bytes.next_mark().map_err(|source| TrajectoryError::Read { path: self.path.clone(), source })?;
        mark.ok_or_else(|| self.wrong(CUT_OFF.to_owned()))
    }

    /// Takes a byte that must come next.
    fn take(&mut self, wanted: u8) -> Result<(), TrajectoryError> {
        let found = self.mark()?;
        if found != wanted {
            let (found, wanted) = (char::from(found), char::from(wanted));
            return Err(self.wrong(format!("`{found}` where `{wanted}` must stand")));
        }
        self.bytes.skip();
        Ok(())
    }

    /// Reads a value that ends by itself: a text, a list or an object.
    fn value<T: DeserializeOwned>(&mut self, what: &str) -> Result<T, TrajectoryError> {
        self.mark()?;
        let read = T::deserialize(&mut serde_json::Deserializer::from_reader(&mut self.bytes));
        read.map_err(|error| {
            if error.is_io() {
                return TrajectoryError::Read { path: self.path.clone(), source: error.into() };
            }
            if error.is_eof() {
                return self.wrong(CUT_OFF.to_owned());
            }
            // Its own line and column count from the beginning of the value.
            let words = error.to_string();
            let words = words.split(" at line ").next().unwrap_or(&words);
            self.wrong(format!("{what} must stand here: {words}"))
        })
    }

    fn wrong(&self, reason: String) -> TrajectoryError {
        TrajectoryError::Content { path: self.path.clone(), place: self.bytes.place(), reason }
    }
}
