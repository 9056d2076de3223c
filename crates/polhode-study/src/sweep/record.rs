//! The file in which the finished runs of a sweep are kept: CSV (RFC 4180).
//!
//! Its first line says of which sweep it is, `# polhode sweep` and a hash of scene, values, measures and version; then
//! the names of the columns and one line for each run, in their order. So a file that was cut off is the beginning of
//! the whole one, and the same command goes on behind its last whole line, to the same bytes. Shards have files of
//! their own beside it, whose lines are taken over when the whole sweep is asked for.

use super::error::SweepError;
use super::plan::Sweep;
use super::run::Row;
use blake2::digest::consts::U16;
use blake2::{Blake2b, Digest};
use polhode_scene::csv::{fields, quoted};
use std::fs::{self, File, OpenOptions};
use std::io::{Read as _, Write as _};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// What the first line begins with.
const MARK: &str = "# polhode sweep ";

/// The file of a sweep, or of a shard of it, open behind its last whole line.
#[derive(Debug)]
pub struct Record {
    path: PathBuf,
    file: File,
    /// The run whose line is the next one.
    next: u64,
}

impl Sweep {
    /// What a file of this sweep is told by: the texts that the scene is made of, with all changes, are `scene`.
    pub fn digest(&self, scene: &str) -> String {
        let told = format!("{}\n{}\n{scene}", env!("CARGO_PKG_VERSION"), self.told());
        let whole =
            Blake2b::<U16>::digest(told.as_bytes()).iter().fold(0_u128, |whole, byte| (whole << 8) | u128::from(*byte));
        format!("{whole:032x}")
    }

    /// The line with the names of the columns, without its end.
    pub fn columns_line(&self) -> String {
        self.columns().iter().map(|column| quoted(column)).collect::<Vec<_>>().join(",")
    }

    /// The first two lines of its file.
    pub(super) fn head(&self, digest: &str) -> String {
        format!("{MARK}{digest}\n{}\n", self.columns_line())
    }

    /// The row of a line of this sweep.
    fn row_of(&self, line: &str) -> Option<Row> {
        let cells = fields(line.strip_suffix('\n').unwrap_or(line));
        let (keys, measures) = (self.leading(), self.measures.len());
        let (run, rest) = cells.split_first()?;
        if rest.len() != keys + measures + 3 {
            return None;
        }
        let numbers: Option<Vec<f64>> =
            rest[keys + 1..=keys + 1 + measures].iter().map(|own| own.parse().ok()).collect();
        let numbers = numbers?;
        Some(Row {
            run: run.parse().ok()?,
            values: rest[..keys].to_vec(),
            outcome: rest[keys].clone(),
            error: numbers[0],
            measured: numbers[1..].to_vec(),
            reason: rest[keys + measures + 2].clone(),
        })
    }
}

impl Row {
    /// The line of a run, without its end.
    pub fn line(&self) -> String {
        let numbers = std::iter::once(self.error).chain(self.measured.iter().copied()).map(digits);
        let cells = [self.run.to_string()].into_iter().chain(self.values.iter().cloned()).chain([self.outcome.clone()]);
        let all = cells.chain(numbers).chain([self.reason.clone()]);
        all.map(|cell| quoted(&cell).into_owned()).collect::<Vec<_>>().join(",")
    }
}

impl Record {
    /// Opens the file for the runs of a sweep with this digest; begins it where there is none. `has` is given each row
    /// that it has.
    ///
    /// # Errors
    /// When the file is of something else, or cannot be read or written.
    pub fn open(
        path: &Path,
        (sweep, digest): (&Sweep, &str),
        runs: Range<u64>,
        has: impl FnMut(&Row),
    ) -> Result<Self, SweepError> {
        let fault = |source| SweepError::File { path: path.display().to_string(), source };
        let head = sweep.head(digest);
        let mut file = OpenOptions::new().read(true).append(true).create(true).open(path).map_err(fault)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(fault)?;
        let text = String::from_utf8_lossy(&bytes);
        let lines = lines_of(path, &text, &head)?;
        let rows = rows_of(path, sweep, &lines, runs.clone())?;
        let whole = if lines.is_empty() && text.len() < head.len() { 0 } else { head.len() + length(&lines) };
        if whole < bytes.len() {
            file.set_len(whole as u64).map_err(fault)?;
        }
        let next = runs.start + rows.len() as u64;
        let mut record = Self { path: path.to_owned(), file, next };
        if whole == 0 {
            record.write(&head)?;
        }
        rows.iter().for_each(has);
        Ok(record)
    }

    /// The run whose line is the next one.
    pub fn next(&self) -> u64 {
        self.next
    }

    /// Appends a finished run.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn append(&mut self, row: &Row) -> Result<(), SweepError> {
        self.write(&format!("{}\n", row.line()))?;
        self.next += 1;
        Ok(())
    }

    /// Takes over the rows that the file of a shard has, as far as they follow on those that are there; `has` is given
    /// each of them.
    ///
    /// # Errors
    /// When it is of something else, or a file cannot be read or written.
    pub fn take_over(
        &mut self,
        shard: &Path,
        (sweep, digest): (&Sweep, &str),
        runs: Range<u64>,
        mut has: impl FnMut(&Row),
    ) -> Result<(), SweepError> {
        let bytes = fs::read(shard).map_err(|source| SweepError::File { path: shard.display().to_string(), source })?;
        let text = String::from_utf8_lossy(&bytes);
        let lines = lines_of(shard, &text, &sweep.head(digest))?;
        for row in rows_of(shard, sweep, &lines, runs)? {
            if row.run == self.next {
                self.append(&row)?;
                has(&row);
            }
        }
        Ok(())
    }

    fn write(&mut self, text: &str) -> Result<(), SweepError> {
        let fault = |source| SweepError::File { path: self.path.display().to_string(), source };
        self.file.write_all(text.as_bytes()).map_err(fault)
    }
}

/// The file of a shard beside that of its sweep: `table.2-of-8.csv` beside `table.csv`.
pub fn path_of_shard(path: &Path, number: u64, of: u64) -> PathBuf {
    let ending = path.extension().map_or_else(String::new, |ending| format!(".{}", ending.to_string_lossy()));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}.{number}-of-{of}{ending}"))
}

/// The shards that have a file beside that of their sweep, in the order of their runs.
pub fn shards_of(path: &Path) -> Vec<[u64; 2]> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let names = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.file_name());
    let shard = |name: std::ffi::OsString| {
        let found = Path::new(&name);
        let rest = found.file_stem()?.to_str()?.strip_prefix(&format!("{stem}."))?.to_owned();
        let (number, of) = rest.split_once("-of-")?;
        let [number, of]: [u64; 2] = [number.parse().ok()?, of.parse().ok()?];
        ((1..=of).contains(&number) && found.extension() == path.extension()).then_some([number, of])
    };
    let mut all: Vec<[u64; 2]> = names.filter_map(shard).collect();
    all.sort_by(|[a, of_a], [b, of_b]| (u128::from(*a) * u128::from(*of_b)).cmp(&(u128::from(*b) * u128::from(*of_a))));
    all
}

/// The whole lines of a text behind its head, with their ends.
///
/// # Errors
/// When it begins otherwise.
fn lines_of<'a>(path: &Path, text: &'a str, head: &str) -> Result<Vec<&'a str>, SweepError> {
    if head.starts_with(text) {
        return Ok(Vec::new());
    }
    if let Some(rest) = text.strip_prefix(head) {
        return Ok(records(rest));
    }
    let first = text.lines().next().unwrap_or_default();
    let why = match first.strip_prefix(MARK) {
        Some(digest) if head.contains(digest) => "it has other columns".to_owned(),
        Some(digest) => format!("it is of another sweep ({digest})"),
        None => "it is no file of a sweep".to_owned(),
    };
    Err(SweepError::Foreign { path: path.display().to_string(), why })
}

/// The rows of lines: runs from the first of these on, in their order.
///
/// # Errors
/// When a line is none of these.
fn rows_of(path: &Path, sweep: &Sweep, lines: &[&str], runs: Range<u64>) -> Result<Vec<Row>, SweepError> {
    let foreign = |why: String| SweepError::Foreign { path: path.display().to_string(), why };
    let mut rows = Vec::with_capacity(lines.len());
    for (run, line) in (runs.start..).zip(lines) {
        let row = sweep.row_of(line).filter(|row| row.run == run);
        let row = row.ok_or_else(|| foreign(format!("its line `{}` is not that of run {run}", line.trim_end())))?;
        if run >= runs.end {
            return Err(foreign(format!("it has run {run}, and {} were asked for", runs.end - runs.start)));
        }
        rows.push(row);
    }
    Ok(rows)
}

fn length(lines: &[&str]) -> usize {
    lines.iter().map(|line| line.len()).sum()
}

/// The whole lines of a text, with their ends; a line break within quotes is part of a line.
fn records(text: &str) -> Vec<&str> {
    let (mut all, mut start, mut is_quoted) = (Vec::new(), 0, false);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => is_quoted = !is_quoted,
            b'\n' if !is_quoted => {
                all.push(&text[start..=at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    all
}

/// The shortest digits from which the number is read again.
fn digits(number: f64) -> String {
    if number.is_nan() { "nan".to_owned() } else { format!("{number:?}") }
}
