//! Bytes of a text, with the line and column that they stand at.

use super::error::FilePlace;
use std::io::{self, BufRead, Read};

/// Bytes, of which the next one can be looked at, counted in lines and columns.
#[derive(Debug)]
pub(super) struct CountedBytes<R> {
    input: R,
    line: u64,
    column: u64,
}

impl<R: BufRead> CountedBytes<R> {
    pub(super) fn new(input: R) -> Self {
        Self { input, line: 1, column: 1 }
    }

    /// Where the next byte stands.
    pub(super) fn place(&self) -> FilePlace {
        FilePlace::LineAndColumn(self.line, self.column)
    }

    /// The next byte that is no space, which stays; none at the end.
    pub(super) fn next_mark(&mut self) -> io::Result<Option<u8>> {
        loop {
            let Some(&byte) = self.input.fill_buf()?.first() else { return Ok(None) };
            if !byte.is_ascii_whitespace() {
                return Ok(Some(byte));
            }
            self.skip();
        }
    }

    /// Passes over the byte that was looked at.
    pub(super) fn skip(&mut self) {
        let mut byte = [0];
        // It stands in the buffer already: this cannot fail.
        let _ = self.read(&mut byte);
    }
}

impl<R: BufRead> Read for CountedBytes<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.input.read(bytes)?;
        for &byte in &bytes[..count] {
            if byte == b'\n' {
                self.line += 1;
                self.column = 1;
            } else {
                self.column += 1;
            }
        }
        Ok(count)
    }
}
