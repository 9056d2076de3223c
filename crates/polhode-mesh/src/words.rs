//! Words of a text file, with their lines.
//!
//! Lines end with `\n`, `\r\n` or `\r`; `#` at the start of a word begins a comment to the end of the line. Where the
//! format joins lines, a `\` right before the end joins the next one, except in comments. A byte order mark is skipped.
//! Nothing is copied, and nothing is asked of the encoding: bytes that are not UTF-8 are parts of words.

use crate::decimal;
use crate::read_error::{Place, ReadError, ReadErrorKind, shown};

/// A word and its line, from 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Word<'a> {
    pub(crate) text: &'a [u8],
    pub(crate) line: usize,
}

/// Whether a `\` at the end of a line joins the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Joining {
    /// As in OBJ.
    Backslash,
    /// As everywhere else.
    Never,
}

impl Word<'_> {
    /// An error about this word.
    pub(crate) fn error(&self, kind: impl FnOnce(String) -> ReadErrorKind) -> ReadError {
        ReadError { place: Place::Line(self.line), kind: kind(shown(self.text)) }
    }

    /// A finite number.
    pub(crate) fn finite(&self) -> Result<f64, ReadError> {
        match decimal::parse(self.text) {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(self.error(ReadErrorKind::NotFinite)),
            None => Err(self.error(ReadErrorKind::BadNumber)),
        }
    }

    /// A whole number of at least 0.
    pub(crate) fn count(&self) -> Result<u64, ReadError> {
        let number = decimal::whole(self.text).and_then(|number| u64::try_from(number).ok());
        number.ok_or_else(|| self.error(ReadErrorKind::BadCount))
    }
}

/// Fewest bytes of a number in text: a digit and what separates it from the next.
pub(crate) const FEWEST_BYTES: usize = 2;

/// Reads words from bytes.
#[derive(Debug, Clone)]
pub(crate) struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    joining: Joining,
}

impl<'a> Words<'a> {
    pub(crate) fn new(bytes: &'a [u8], joining: Joining) -> Self {
        let at = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
        Self { bytes, at, line: 1, joining }
    }

    /// From the middle of a file: byte `at` is in line `line`.
    pub(crate) fn within(bytes: &'a [u8], at: usize, line: usize) -> Self {
        Self { bytes, at, line, joining: Joining::Never }
    }

    /// The line reached.
    pub(crate) fn place(&self) -> Place {
        Place::Line(self.line)
    }

    /// The bytes not yet read.
    pub(crate) fn remaining(&self) -> usize {
        self.bytes.len().saturating_sub(self.at)
    }

    /// The first word of the next line that has any; the line before must have been read to its end.
    pub(crate) fn next_statement(&mut self) -> Option<Word<'a>> {
        loop {
            if let Some(word) = self.next_word() {
                return Some(word);
            }
            let end = line_end(self.bytes, self.at);
            if end == 0 {
                return None;
            }
            self.at += end;
            self.line += 1;
        }
    }

    /// Passes over the rest of the line.
    pub(crate) fn skip_statement(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'\n' | b'\r' => return,
                b'\\' => self.at += self.join().unwrap_or(1),
                // Only at the start of a word.
                b'#' if self
                    .at
                    .checked_sub(1)
                    .and_then(|before| self.bytes.get(before))
                    .is_none_or(|&b| ends_word(b)) =>
                {
                    return self.skip_comment();
                }
                _ => self.at += 1,
            }
        }
    }

    /// The next word of the line.
    #[inline]
    pub(crate) fn next_word(&mut self) -> Option<Word<'a>> {
        loop {
            match *self.bytes.get(self.at)? {
                b' ' | b'\t' | 0x0B | 0x0C => self.at += 1,
                b'\n' | b'\r' => return None,
                b'#' => {
                    self.skip_comment();
                    return None;
                }
                b'\\' => match self.join() {
                    Some(length) => self.at += length,
                    None => break,
                },
                _ => break,
            }
        }
        let start = self.at;
        let mut end = start;
        while let Some(&byte) = self.bytes.get(end) {
            if ends_word(byte) && (byte != b'\\' || self.joined_line_end(end).is_some()) {
                break;
            }
            end += 1;
        }
        self.at = end;
        (end > start).then(|| Word { text: &self.bytes[start..end], line: self.line })
    }

    fn skip_comment(&mut self) {
        while self.bytes.get(self.at).is_some_and(|byte| !matches!(byte, b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    /// Length of the joined line end that comes next, which is counted as a line.
    fn join(&mut self) -> Option<usize> {
        let length = self.joined_line_end(self.at)?;
        self.line += 1;
        Some(length)
    }

    /// Length of the `\` and line end at `at`; the end of the text counts as one.
    fn joined_line_end(&self, at: usize) -> Option<usize> {
        if self.joining == Joining::Never || self.bytes.get(at) != Some(&b'\\') {
            return None;
        }
        match line_end(self.bytes, at + 1) {
            0 => (at + 1 == self.bytes.len()).then_some(1),
            length => Some(1 + length),
        }
    }
}

/// Blanks and line ends; and `\`, which ends a word when a line end follows.
fn ends_word(byte: u8) -> bool {
    ENDS_WORD[byte as usize]
}

/// One look-up a byte.
const ENDS_WORD: [bool; 256] = {
    let mut table = [false; 256];
    let ends = b" \t\x0B\x0C\n\r\\";
    let mut i = 0;
    while i < ends.len() {
        table[ends[i] as usize] = true;
        i += 1;
    }
    table
};

/// Length of the line end at `at`, 0 when there is none.
fn line_end(bytes: &[u8], at: usize) -> usize {
    match (bytes.get(at), bytes.get(at + 1)) {
        (Some(b'\r'), Some(b'\n')) => 2,
        (Some(b'\r' | b'\n'), _) => 1,
        _ => 0,
    }
}
