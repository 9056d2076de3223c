//! A table as Apache Parquet, made of its CSV when all rows are there.
//!
//! Of the format (parquet-format 2.9) it uses what every reader knows: required columns, plain encoding, no
//! compression, one page for each column of a group of rows; its footer is Thrift's compact protocol. Run numbers are
//! whole numbers, values that are numbers in every row and all measures are floats of 64 bits, the rest is text. The
//! crate `parquet` would do the same, and bring about twenty crates for it.

use super::error::SweepError;
use super::plan::Sweep;
use super::record::Record;
use super::run::Row;
use polhode_scene::AtomicFile;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// What a file begins and ends with.
const MAGIC: &[u8] = b"PAR1";

/// The key of the metadata that says of which sweep a file is.
const SWEEP: &str = "polhode sweep";

/// Rows of a group: a page of them is far below the limit of 2^31 bytes.
const ROWS_OF_GROUP: usize = 1 << 20;

/// Kinds of field in Thrift's compact protocol.
const I32: u8 = 5;
const I64: u8 = 6;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// A file of Parquet that is absent, or of the same sweep.
#[derive(Debug)]
pub struct Parquet<'a> {
    path: PathBuf,
    sweep: &'a Sweep,
    digest: &'a str,
}

/// A column.
enum Column {
    Whole(Vec<i64>),
    Float(Vec<f64>),
    Text(Vec<String>),
}

/// Where a column of a group of rows is: its place and its length, bytes.
type Place = [usize; 2];

impl<'a> Parquet<'a> {
    /// The file at this path, which is written later.
    ///
    /// # Errors
    /// When there is a file of something else.
    pub fn of(path: &Path, (sweep, digest): (&'a Sweep, &'a str)) -> Result<Self, SweepError> {
        let name = || path.display().to_string();
        let bytes = match fs::read(path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => MAGIC.to_vec(),
            Err(source) => return Err(SweepError::File { path: name(), source }),
        };
        let holds = |text: &str| bytes.windows(text.len()).rev().any(|own| own == text.as_bytes());
        let is_own = bytes == MAGIC || (bytes.ends_with(MAGIC) && holds(SWEEP) && holds(digest));
        let why = if holds(SWEEP) { "it is of another sweep" } else { "it is no file of a sweep" };
        if is_own {
            Ok(Self { path: path.to_owned(), sweep, digest })
        } else {
            Err(SweepError::Foreign { path: name(), why: why.to_owned() })
        }
    }

    /// Writes the rows of this CSV.
    ///
    /// # Errors
    /// When a file cannot be read or written.
    pub fn write(&self, csv: &Path) -> Result<(), SweepError> {
        let mut rows = Vec::new();
        Record::open(csv, (self.sweep, self.digest), 0..self.sweep.runs(), |row| rows.push(row.clone()))?;
        let bytes = self.bytes(&rows);
        let fault = |source| SweepError::File { path: self.path.display().to_string(), source };
        let mut file = AtomicFile::create(&self.path).map_err(fault)?;
        file.write_all(&bytes).and_then(|()| file.commit()).map_err(fault)
    }

    fn bytes(&self, rows: &[Row]) -> Vec<u8> {
        let names = self.sweep.columns();
        let mut bytes = MAGIC.to_vec();
        let kinds = columns(rows);
        let mut groups = Vec::new();
        for rows in rows.chunks(ROWS_OF_GROUP) {
            let places: Vec<Place> = columns(rows)
                .into_iter()
                .zip(&kinds)
                .map(|(own, whole)| {
                    let start = bytes.len();
                    page(&mut bytes, &own.of_kind_of(whole), rows.len());
                    [start, bytes.len() - start]
                })
                .collect();
            groups.push((rows.len(), places));
        }
        let footer = self.footer(rows.len(), &names, (&kinds, &groups));
        bytes.extend(&footer);
        bytes.extend((footer.len() as u32).to_le_bytes());
        bytes.extend(MAGIC);
        bytes
    }

    /// Schema, places of the columns, and of which sweep it is.
    fn footer(&self, rows: usize, names: &[String], (kinds, groups): (&[Column], &[(usize, Vec<Place>)])) -> Vec<u8> {
        let mut out = Compact::default();
        out.number(1, I32, 1);
        out.list(2, STRUCT, names.len() + 1);
        let mut root = Compact::default();
        root.text(4, "schema");
        root.number(5, I32, names.len() as i64);
        out.element(root);
        for (name, column) in names.iter().zip(kinds) {
            let mut own = Compact::default();
            own.number(1, I32, column.kind());
            own.number(3, I32, 0);
            own.text(4, name);
            if let Column::Text(_) = column {
                own.number(6, I32, 0);
            }
            out.element(own);
        }
        out.number(3, I64, rows as i64);
        out.list(4, STRUCT, groups.len());
        for (count, places) in groups {
            let mut group = Compact::default();
            group.list(1, STRUCT, names.len());
            for ((name, column), place) in names.iter().zip(kinds).zip(places) {
                group.element(chunk(name, column, (*count, *place)));
            }
            group.number(2, I64, places.iter().map(|[_, length]| *length as i64).sum());
            group.number(3, I64, *count as i64);
            out.element(group);
        }
        out.list(5, STRUCT, 1);
        let mut own = Compact::default();
        own.text(1, SWEEP);
        own.text(2, self.digest);
        out.element(own);
        out.text(6, concat!("polhode version ", env!("CARGO_PKG_VERSION")));
        out.end()
    }
}

/// What the footer says of a column of a group.
fn chunk(name: &str, column: &Column, (count, [start, length]): (usize, Place)) -> Compact {
    let mut meta = Compact::default();
    meta.number(1, I32, column.kind());
    // Plain values, and levels (of which required columns have none) as runs.
    meta.list(2, I32, 2);
    meta.raw(&[0, 6]);
    meta.list(3, BINARY, 1);
    meta.bytes_of(name);
    meta.number(4, I32, 0);
    meta.number(5, I64, count as i64);
    meta.number(6, I64, length as i64);
    meta.number(7, I64, length as i64);
    meta.number(9, I64, start as i64);
    let mut own = Compact::default();
    own.number(2, I64, start as i64);
    own.within(3, meta);
    own
}

/// A page with all values of a column, behind its header.
fn page(bytes: &mut Vec<u8>, column: &Column, rows: usize) {
    let values = column.plain();
    let mut data = Compact::default();
    data.number(1, I32, rows as i64);
    data.number(2, I32, 0);
    data.number(3, I32, 3);
    data.number(4, I32, 3);
    let mut header = Compact::default();
    header.number(1, I32, 0);
    header.number(2, I32, values.len() as i64);
    header.number(3, I32, values.len() as i64);
    header.within(5, data);
    bytes.extend(header.end());
    bytes.extend(values);
}

/// The columns of rows.
fn columns(rows: &[Row]) -> Vec<Column> {
    let texts = |of: &dyn Fn(&Row) -> String| Column::Text(rows.iter().map(of).collect());
    let Some(first) = rows.first() else { return Vec::new() };
    let mut all = vec![Column::Whole(rows.iter().map(|row| row.run as i64).collect())];
    for place in 0..first.values.len() {
        let numbers: Option<Vec<f64>> = rows.iter().map(|row| row.values[place].parse().ok()).collect();
        all.push(numbers.map_or_else(|| texts(&|row| row.values[place].clone()), Column::Float));
    }
    all.push(texts(&|row| row.outcome.clone()));
    all.push(Column::Float(rows.iter().map(|row| row.error).collect()));
    for place in 0..first.measured.len() {
        all.push(Column::Float(rows.iter().map(|row| row.measured[place]).collect()));
    }
    all.push(texts(&|row| row.reason.clone()));
    all
}

impl Column {
    /// The number of its type in the format: INT64, DOUBLE, BYTE_ARRAY.
    fn kind(&self) -> i64 {
        match self {
            Self::Whole(_) => 2,
            Self::Float(_) => 5,
            Self::Text(_) => 6,
        }
    }

    /// The same as text, where the whole column is: one group may have numbers alone.
    fn of_kind_of(self, whole: &Self) -> Self {
        match (self, whole) {
            (Self::Float(own), Self::Text(_)) => Self::Text(own.iter().map(|value| format!("{value:?}")).collect()),
            (own, _) => own,
        }
    }

    fn plain(&self) -> Vec<u8> {
        match self {
            Self::Whole(all) => all.iter().flat_map(|own| own.to_le_bytes()).collect(),
            Self::Float(all) => all.iter().flat_map(|own| own.to_le_bytes()).collect(),
            Self::Text(all) => {
                let one =
                    |own: &String| (own.len() as u32).to_le_bytes().into_iter().chain(own.bytes()).collect::<Vec<u8>>();
                all.iter().flat_map(one).collect()
            }
        }
    }
}

/// A structure of Thrift's compact protocol, as far as it has come.
#[derive(Debug, Default)]
struct Compact {
    bytes: Vec<u8>,
    last: u8,
}

impl Compact {
    /// A field's head: how far its number is from the last one, and its kind.
    fn head(&mut self, field: u8, kind: u8) {
        self.bytes.push(((field - self.last) << 4) | kind);
        self.last = field;
    }

    fn varint(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.bytes.push((value as u8 & 0x7f) | 0x80);
            value >>= 7;
        }
        self.bytes.push(value as u8);
    }

    fn number(&mut self, field: u8, kind: u8, value: i64) {
        self.head(field, kind);
        self.varint(((value << 1) ^ (value >> 63)) as u64);
    }

    fn text(&mut self, field: u8, text: &str) {
        self.head(field, BINARY);
        self.bytes_of(text);
    }

    fn bytes_of(&mut self, text: &str) {
        self.varint(text.len() as u64);
        self.raw(text.as_bytes());
    }

    fn raw(&mut self, bytes: &[u8]) {
        self.bytes.extend(bytes);
    }

    fn list(&mut self, field: u8, kind: u8, count: usize) {
        self.head(field, LIST);
        if count < 15 {
            self.bytes.push(((count as u8) << 4) | kind);
        } else {
            self.bytes.push(0xf0 | kind);
            self.varint(count as u64);
        }
    }

    fn within(&mut self, field: u8, other: Self) {
        self.head(field, STRUCT);
        self.element(other);
    }

    /// An element of a list of structures.
    fn element(&mut self, other: Self) {
        let bytes = other.end();
        self.raw(&bytes);
    }

    fn end(mut self) -> Vec<u8> {
        self.bytes.push(0);
        self.bytes
    }
}
