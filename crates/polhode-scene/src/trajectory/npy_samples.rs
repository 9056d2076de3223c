//! The samples of an NPY file: doubles of shape (samples, bodies, 14), or 16 with errors, bodies in the order of the
//! scene.
//!
//! Format versions 1 to 3 (docs/REFERENCES.md, NumPy enhancement proposal 1). The file bears no names, so that all that
//! can be held against the scene is the number of bodies.

use super::error::{FilePlace, TrajectoryError};
use super::expected::{CUT_OFF, Expected, Sample};
use crate::output::{COLUMNS, ERROR_COLUMNS, ErrorColumns, NPY_WIDTH, NPY_WIDTH_WITH_ERRORS};
use crate::trajectory_rows::{FIRST_NUMBER, NUMBERS, Velocities, error_of};
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::{Path, PathBuf};

/// What every file begins with.
const MAGIC: &[u8; 6] = b"\x93NUMPY";
/// Bytes of a number.
const DOUBLE: u64 = 8;
/// Bytes of a header at the most: the largest of version 1.
const LONGEST_HEADER: u32 = 65_535;

/// The samples of an NPY file.
#[derive(Debug)]
pub(super) struct NpySamples {
    path: PathBuf,
    input: BufReader<File>,
    error_columns: ErrorColumns,
    /// How many numbers a body has behind its time, those of errors apart.
    numbers: usize,
    /// Bytes read.
    byte: u64,
    /// Samples that are left.
    left: u64,
    /// That the file has fewer than its header says, where it has.
    cut_off: Option<String>,
}

/// What the rows of a file may hold.
struct Kind {
    /// Numbers of a body in a sample.
    width: usize,
    /// Columns of a body, without errors.
    columns: usize,
    error_columns: ErrorColumns,
}

impl NpySamples {
    pub(super) fn open(path: &Path, expected: &Expected, velocities: Velocities) -> Result<Self, TrajectoryError> {
        let cannot_read = |source| TrajectoryError::Read { path: path.to_owned(), source };
        let file = File::open(path).map_err(cannot_read)?;
        let length = file.metadata().map_err(cannot_read)?.len();
        let (path, input, error_columns) = (path.to_owned(), BufReader::new(file), ErrorColumns::Absent);
        let numbers = NUMBERS;
        let mut samples = Self { path, input, error_columns, numbers, byte: 0, left: 0, cut_off: None };
        let header = samples.header()?;
        let [count, bodies, width] = shape(&header).map_err(|reason| samples.wrong(reason))?;
        // Instead of the name of the body, a row has its place.
        let kinds = velocities.widths().iter().flat_map(|&columns| {
            let of = |with_velocities: usize, error_columns| Kind {
                width: with_velocities + columns - COLUMNS.len(),
                columns,
                error_columns,
            };
            [of(NPY_WIDTH, ErrorColumns::Absent), of(NPY_WIDTH_WITH_ERRORS, ErrorColumns::Written)]
        });
        let kinds: Vec<Kind> = kinds.collect();
        let kind = kinds.iter().find(|own| own.width as u64 == width).filter(|_| bodies == expected.count() as u64);
        if let Some(Kind { columns, error_columns, .. }) = kind {
            (samples.numbers, samples.error_columns) = (columns - FIRST_NUMBER, *error_columns);
        } else {
            let widths: Vec<String> = kinds.iter().map(|own| own.width.to_string()).collect();
            let needed = format!("(samples, {}, {})", expected.count(), widths.join(" or "));
            let what = format!("its shape is ({count}, {bodies}, {width}), and the scene's is {needed}");
            return Err(samples.wrong(format!("{what}: is it another scene's?")));
        }
        let has = length - samples.byte.min(length);
        let sample = bodies * width * DOUBLE;
        if count == 0 && has >= sample {
            // The number of samples is written at the end, to which the run did not come.
            samples.left = has / sample;
            samples.cut_off = Some(format!("its header does not say how many samples follow: {CUT_OFF}"));
            return Ok(samples);
        }
        if count == 0 {
            return Err(samples.wrong("it has no samples".to_owned()));
        }
        let data = [bodies, width, DOUBLE].iter().try_fold(count, |product: u64, &factor| product.checked_mul(factor));
        if data != Some(has) {
            let needed = data.map_or("more than any file has".to_owned(), |data| data.to_string());
            let what = format!("{count} samples of {bodies} bodies take {needed} bytes, and {has} follow the header");
            if data.is_none_or(|data| data <= has) {
                return Err(samples.wrong(what));
            }
            // The samples that are there are read, up to where one is not whole.
            samples.cut_off = Some(format!("{what}: {CUT_OFF}"));
            if has < sample {
                return Err(samples.wrong(format!("{what}: {CUT_OFF}")));
            }
        }
        samples.left = count;
        Ok(samples)
    }

    pub(super) fn has_velocities(&self) -> bool {
        self.numbers == NUMBERS
    }

    /// Reads the dictionary before the data.
    fn header(&mut self) -> Result<String, TrajectoryError> {
        let magic: [u8; 6] = self.bytes()?;
        if magic != *MAGIC {
            return Err(self.wrong("an NPY file begins with \\x93NUMPY".to_owned()));
        }
        let [major, _minor]: [u8; 2] = self.bytes()?;
        let length = match major {
            1 => u32::from(u16::from_le_bytes(self.bytes()?)),
            2 | 3 => u32::from_le_bytes(self.bytes()?),
            _ => return Err(self.wrong(format!("version {major} of the format; 1, 2 and 3 can be read"))),
        };
        if length > LONGEST_HEADER {
            return Err(self.wrong(format!("a header of {length} bytes; at most {LONGEST_HEADER} are read")));
        }
        let mut header = vec![0; length as usize];
        self.fill(&mut header)?;
        String::from_utf8(header).map_err(|_| self.wrong("the header is not text".to_owned()))
    }

    pub(super) fn next(&mut self, expected: &mut Expected) -> Result<Option<Sample>, TrajectoryError> {
        if self.left == 0 {
            return self.cut_off.take().map_or(Ok(None), |reason| Err(self.wrong(reason)));
        }
        self.left -= 1;
        let mut time = None;
        let (mut bodies, mut errors) = (Vec::with_capacity(expected.count()), Vec::with_capacity(expected.count()));
        for number in 0..expected.count() {
            let t = f64::from_le_bytes(self.bytes()?);
            match time {
                None => time = Some(expected.time(t).map_err(|reason| self.wrong(reason))?),
                Some(first) if t == first => {}
                Some(first) => {
                    let name = expected.name(number);
                    return Err(self.wrong(format!("body `{name}` has t = {t:?} s in the sample of t = {first:?} s")));
                }
            }
            let mut numbers = [0.0; NUMBERS];
            for number in numbers.iter_mut().take(self.numbers) {
                *number = f64::from_le_bytes(self.bytes()?);
            }
            bodies.push(expected.state(number, numbers).map_err(|reason| self.wrong(reason))?);
            let mut error = [f64::NAN; ERROR_COLUMNS.len()];
            for number in error.iter_mut().take(self.error_columns.names().len()) {
                *number = f64::from_le_bytes(self.bytes()?);
            }
            errors.push(error_of(error).map_err(|reason| self.wrong(reason))?);
        }
        Ok(Some(Sample { t_s: time.unwrap_or_default(), bodies, errors: errors.into_iter().collect() }))
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], TrajectoryError> {
        let mut bytes = [0; N];
        self.fill(&mut bytes)?;
        Ok(bytes)
    }

    fn fill(&mut self, bytes: &mut [u8]) -> Result<(), TrajectoryError> {
        self.input.read_exact(bytes).map_err(|source| match source.kind() {
            io::ErrorKind::UnexpectedEof => self.wrong(self.cut_off.clone().unwrap_or_else(|| CUT_OFF.to_owned())),
            _ => TrajectoryError::Read { path: self.path.clone(), source },
        })?;
        self.byte += bytes.len() as u64;
        Ok(())
    }

    fn wrong(&self, reason: String) -> TrajectoryError {
        TrajectoryError::Content { path: self.path.clone(), place: FilePlace::Byte(self.byte), reason }
    }
}

/// The three lengths of the array that a header describes.
fn shape(header: &str) -> Result<[u64; 3], String> {
    let value = |key: &str| {
        let (_, rest) = header.split_once(&format!("'{key}':"))?;
        Some(rest.trim_start())
    };
    if !value("descr").is_some_and(|value| value.starts_with("'<f8'")) {
        return Err("its numbers are not doubles, little-endian ('descr': '<f8')".to_owned());
    }
    if !value("fortran_order").is_some_and(|value| value.starts_with("False")) {
        return Err("its order is not that of C ('fortran_order': False)".to_owned());
    }
    let lengths = value("shape").and_then(|value| value.strip_prefix('(')?.split_once(')'));
    let lengths: Option<Vec<u64>> =
        lengths.and_then(|(list, _)| list.split(',').map(|n| n.trim().parse().ok()).collect());
    lengths.and_then(|lengths| lengths.try_into().ok()).ok_or_else(|| "its shape has not three lengths".to_owned())
}
