//! The rows of a trajectory in a CSV file, read one by one, whatever its size.

use crate::csv::{Fault, Records};
use crate::output::{COLUMNS, ERROR_COLUMNS, ErrorColumns};
use polhode::spatial::{DVec3, Pose, Rotation, RotationError, Velocity};
use polhode::{BodyError, BodySample};
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// First of the columns that hold numbers.
pub(crate) const FIRST_NUMBER: usize = 2;

/// First of the columns that hold velocities.
pub(crate) const FIRST_VELOCITY: usize = 9;

/// Whether a trajectory must have velocities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Velocities {
    /// It must.
    Needed,
    /// Times and poses are enough.
    MayBeAbsent,
}

impl Velocities {
    /// How many columns a trajectory may have, those of errors apart.
    pub(crate) fn widths(self) -> &'static [usize] {
        match self {
            Self::Needed => const { &[COLUMNS.len()] },
            Self::MayBeAbsent => const { &[COLUMNS.len(), FIRST_VELOCITY] },
        }
    }
}

/// Number of columns that hold numbers.
pub(crate) const NUMBERS: usize = COLUMNS.len() - FIRST_NUMBER;

/// Why a row could not be read.
#[derive(Debug)]
pub(crate) enum RowError {
    /// The file could not be read.
    Read { path: PathBuf, source: std::io::Error },
    /// The file is not a trajectory.
    Content { path: PathBuf, line: u64, reason: String },
}

/// One row of a trajectory.
#[derive(Debug)]
pub(crate) struct Row {
    /// Time and body as written.
    pub(crate) key: [String; 2],
    pub(crate) numbers: [f64; NUMBERS],
    /// The estimated error; none where the file has none, or it is not known.
    pub(crate) error: Option<BodyError>,
}

/// The error of a body from the numbers of its columns; none where it is not known.
///
/// # Errors
/// Why it is none, in words.
pub(crate) fn error_of(numbers: [f64; ERROR_COLUMNS.len()]) -> Result<Option<BodyError>, String> {
    for (number, column) in numbers.iter().zip(ERROR_COLUMNS) {
        if *number < 0.0 || number.is_infinite() {
            return Err(format!("column {column} is {number}: it must be finite and at least 0, or empty"));
        }
    }
    let [position_m, rotation_rad] = numbers;
    let is_known = !(position_m.is_nan() || rotation_rad.is_nan());
    Ok(is_known.then(|| BodyError::new(position_m, rotation_rad)))
}

impl Row {
    /// Pose and velocity.
    ///
    /// # Errors
    /// Why the numbers of the quaternion are no rotation.
    pub(crate) fn body_sample(&self) -> Result<BodySample, RotationError> {
        let [px, py, pz, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz] = self.numbers;
        let rotation = Rotation::from_wxyz([qw, qx, qy, qz])?;
        let velocity = Velocity { linear: DVec3::new(vx, vy, vz), angular: DVec3::new(wx, wy, wz) };
        Ok(BodySample { pose: Pose::new(rotation, DVec3::new(px, py, pz)), velocity })
    }
}

/// The rows of a trajectory.
#[derive(Debug)]
pub(crate) struct Rows {
    path: PathBuf,
    records: Records<BufReader<File>>,
    error_columns: ErrorColumns,
    /// How many columns there are, those of errors apart.
    width: usize,
    fields: Vec<String>,
}

impl Rows {
    /// Opens a file and reads its first line, which must name the columns.
    pub(crate) fn open(path: &Path, velocities: Velocities) -> Result<Self, RowError> {
        let file = File::open(path).map_err(|source| RowError::Read { path: path.to_owned(), source })?;
        let records = Records::new(BufReader::new(file));
        let error_columns = ErrorColumns::Absent;
        let width = COLUMNS.len();
        let mut rows = Self { path: path.to_owned(), records, error_columns, width, fields: Vec::new() };
        let is_empty = !rows.read()?;
        for (&width, error_columns) in
            velocities.widths().iter().flat_map(|width| [(width, ErrorColumns::Absent), (width, ErrorColumns::Written)])
        {
            if rows.fields == [&COLUMNS[..width], error_columns.names()].concat() {
                return Ok(Self { error_columns, width, ..rows });
            }
        }
        let what = if is_empty { "the file is empty: " } else { "" };
        let columns: Vec<String> = velocities.widths().iter().map(|&width| COLUMNS[..width].join(",")).collect();
        let (columns, more) = (columns.join(", or "), ERROR_COLUMNS.join(","));
        Err(rows.content(format!("{what}the first line must be {columns}, or that and ,{more}")))
    }

    fn read(&mut self) -> Result<bool, RowError> {
        self.records.read(&mut self.fields).map_err(|fault| match fault {
            Fault::Io(source) => RowError::Read { path: self.path.clone(), source },
            Fault::Content(reason) => self.content(reason.to_owned()),
        })
    }

    /// The next row; nothing at the end of the file.
    pub(crate) fn next(&mut self) -> Result<Option<Row>, RowError> {
        if !self.read()? {
            return Ok(None);
        }
        let needed = self.width + self.error_columns.names().len();
        if self.fields.len() != needed {
            let found = self.fields.len();
            return Err(self.content(format!("{found} columns, {needed} are needed{}", self.cut_off())));
        }
        let number = |field: &String, column: &str| {
            let wrong = |_| self.content(format!("`{field}` in column {column} is not a number{}", self.cut_off()));
            field.parse().map_err(wrong)
        };
        let mut numbers = [0.0; NUMBERS];
        for (own, (field, column)) in
            numbers.iter_mut().zip(self.fields.iter().zip(COLUMNS).take(self.width).skip(FIRST_NUMBER))
        {
            *own = number(field, column)?;
        }
        let mut error = [f64::NAN; ERROR_COLUMNS.len()];
        for (own, (field, column)) in error.iter_mut().zip(self.fields[self.width..].iter().zip(ERROR_COLUMNS)) {
            *own = if field.is_empty() { f64::NAN } else { number(field, column)? };
        }
        let error = error_of(error).map_err(|reason| self.content(reason))?;
        let key = [std::mem::take(&mut self.fields[0]), std::mem::take(&mut self.fields[1])];
        Ok(Some(Row { key, numbers, error }))
    }

    /// Whether the file has velocities; else they are read as zero.
    pub(crate) fn has_velocities(&self) -> bool {
        self.width > FIRST_VELOCITY
    }

    /// The line, from 1, at which the last row read ends.
    pub(crate) fn line(&self) -> u64 {
        self.records.line()
    }

    /// Whether the last row read has a line's end behind it.
    pub(crate) fn ends_with_line_end(&self) -> bool {
        self.records.ends_with_line_end()
    }

    /// What is to be said besides of a last line that has no end.
    fn cut_off(&self) -> &'static str {
        if self.ends_with_line_end() { "" } else { ": in this line the file is cut off: write it again" }
    }

    /// That the file is not a trajectory at the present line.
    pub(crate) fn content(&self, reason: String) -> RowError {
        RowError::Content { path: self.path.clone(), line: self.records.line().max(1), reason }
    }
}
