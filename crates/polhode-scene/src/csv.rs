//! Comma-separated values: one record a line, fields quoted where they must be (RFC 4180).

use std::io::{self, BufRead, Write};

/// Longest record read, bytes: a hundred times a row of a trajectory; more is no trajectory.
const LONGEST_RECORD: usize = 1 << 16;

/// Writes one field, in quotes when it holds a comma, a quote or a line's end.
pub(crate) fn write_field(out: &mut (impl Write + ?Sized), field: &str) -> io::Result<()> {
    if field.contains([',', '"', '\n', '\r']) {
        write!(out, "\"{}\"", field.replace('"', "\"\""))
    } else {
        out.write_all(field.as_bytes())
    }
}

/// Writes `,` and a number in the fewest digits that give the same bits when read.
pub(crate) fn write_number(out: &mut (impl Write + ?Sized), number: f64) -> io::Result<()> {
    write!(out, ",{number:?}")
}

/// Reads records one by one.
#[derive(Debug)]
pub(crate) struct Records<R> {
    input: R,
    line: u64,
    ends_with_line_end: bool,
}

/// Why a record could not be read.
#[derive(Debug)]
pub(crate) enum Fault {
    /// The file could not be read.
    Io(io::Error),
    /// The text is no record.
    Content(&'static str),
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl<R: BufRead> Records<R> {
    pub(crate) fn new(input: R) -> Self {
        Self { input, line: 0, ends_with_line_end: true }
    }

    /// The line, from 1, at which the last record read ends.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// Whether the last record read has a line's end behind it.
    pub(crate) fn ends_with_line_end(&self) -> bool {
        self.ends_with_line_end
    }

    /// Reads the next record; false at the end of the file.
    pub(crate) fn read(&mut self, fields: &mut Vec<String>) -> Result<bool, Fault> {
        fields.clear();
        let mut record = Vec::new();
        // A record goes on to the next line while a quote is open.
        loop {
            let before = record.len();
            let room = LONGEST_RECORD.saturating_sub(before) as u64;
            io::Read::take(&mut self.input, room).read_until(b'\n', &mut record)?;
            if record.len() == before {
                return match before {
                    0 => Ok(false),
                    _ => Err(Fault::Content("a quote is not closed, or the line is too long")),
                };
            }
            self.line += 1;
            self.ends_with_line_end = record.ends_with(b"\n");
            let is_open = record.iter().fold(false, |open, &byte| open ^ (byte == b'"'));
            if !is_open {
                break;
            }
        }
        if record.len() >= LONGEST_RECORD {
            return Err(Fault::Content("the line is too long"));
        }
        let text = std::str::from_utf8(&record).map_err(|_| Fault::Content("the line is not UTF-8 text"))?;
        split(text.trim_end_matches(['\n', '\r']), fields);
        Ok(true)
    }
}

/// Splits a record into fields.
fn split(record: &str, fields: &mut Vec<String>) {
    let mut field = String::new();
    let mut quoted = false;
    let mut characters = record.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '"' if quoted && characters.peek() == Some(&'"') => {
                characters.next();
                field.push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(std::mem::take(&mut field)),
            c => field.push(c),
        }
    }
    fields.push(field);
}
