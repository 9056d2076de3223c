//! Comma-separated values: one record a line, fields quoted where they must be (RFC 4180).

use std::borrow::Cow;
use std::io::{self, BufRead, Write};

/// Longest record read, bytes: a hundred times a row of a trajectory; more is no trajectory.
const LONGEST_RECORD: usize = 1 << 16;

/// Writes one field, in quotes when it holds a comma, a quote or a line's end.
///
/// # Errors
/// When it cannot be written.
pub fn write_field(out: &mut (impl Write + ?Sized), field: &str) -> io::Result<()> {
    out.write_all(quoted(field).as_bytes())
}

/// A field, in quotes when it holds a comma, a quote or a line's end.
pub fn quoted(field: &str) -> Cow<'_, str> {
    if field.contains([',', '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", field.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(field)
    }
}

/// Writes `,` and a number in the fewest digits that give the same bits when read.
///
/// # Errors
/// When it cannot be written.
pub fn write_number(out: &mut (impl Write + ?Sized), number: f64) -> io::Result<()> {
    write!(out, ",{number:?}")
}

/// Reads records one by one.
#[derive(Debug)]
pub struct Records<R> {
    input: R,
    line: u64,
    ends_with_line_end: bool,
}

/// Why a record could not be read.
#[derive(Debug)]
pub enum Fault {
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
    /// Of this text.
    pub fn new(input: R) -> Self {
        Self { input, line: 0, ends_with_line_end: true }
    }

    /// The line, from 1, at which the last record read ends.
    pub fn line(&self) -> u64 {
        self.line
    }

    /// Whether the last record read has a line's end behind it.
    pub fn ends_with_line_end(&self) -> bool {
        self.ends_with_line_end
    }

    /// Reads the next record; false at the end of the file.
    ///
    /// # Errors
    /// When the text cannot be read, or is no record.
    pub fn read(&mut self, fields: &mut Vec<String>) -> Result<bool, Fault> {
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
        fields.extend(self::fields(text.trim_end_matches(['\n', '\r'])));
        Ok(true)
    }
}

/// The fields of a record, without its end.
pub fn fields(record: &str) -> Vec<String> {
    let (mut all, mut field, mut is_quoted) = (Vec::new(), String::new(), false);
    let mut characters = record.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '"' if is_quoted && characters.peek() == Some(&'"') => {
                characters.next();
                field.push('"');
            }
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => all.push(std::mem::take(&mut field)),
            c => field.push(c),
        }
    }
    all.push(field);
    all
}

#[cfg(test)]
mod tests {
    //! What is written as a field is read as the same one, whatever it holds.
    use super::*;

    #[test]
    fn a_record_is_split_into_the_fields_that_were_written() {
        for own in [vec![""], vec!["plain", "", "1.5"], vec!["a,b", "say \"no\"", "\"", "two\r\nlines", ",\",\""]] {
            let record = own.iter().map(|field| quoted(field)).collect::<Vec<_>>().join(",");
            assert_eq!(fields(&record), own);
            let mut read = Vec::new();
            assert!(Records::new(format!("{record}\n").as_bytes()).read(&mut read).is_ok_and(|found| found));
            assert_eq!(read, own);
        }
    }
}
