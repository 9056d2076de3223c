//! Words of a text whose statements end with the line.
//!
//! Lines end with `\n`, `\r\n` or `\r`; a `\` right before the end joins the next line; `#` at the start of a word
//! begins a comment to the end of the line, in which `\` means nothing. A byte order mark is skipped. Nothing is copied.

use super::{MAX_TOKEN, ObjError, ObjErrorKind};

/// A word and its line, from 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) text: &'a [u8],
    pub(super) line: usize,
}

impl Token<'_> {
    /// An error about this word.
    pub(super) fn error(&self, kind: impl FnOnce(String) -> ObjErrorKind) -> ObjError {
        ObjError { line: self.line, kind: kind(self.shortened()) }
    }

    /// The word as text, with at most [`MAX_TOKEN`] characters; control characters and bytes that are not UTF-8 are
    /// replaced, so that it can be shown.
    pub(super) fn shortened(&self) -> String {
        // A character has at most four bytes.
        let head = &self.text[..self.text.len().min(4 * MAX_TOKEN)];
        let text = String::from_utf8_lossy(head);
        let visible = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
        let mut shown: String = text.chars().take(MAX_TOKEN).map(visible).collect();
        if text.chars().nth(MAX_TOKEN).is_some() || head.len() < self.text.len() {
            shown.push_str("...");
        }
        shown
    }
}

/// Reads words from bytes.
#[derive(Debug)]
pub(super) struct Tokens<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes), line: 1 }
    }

    /// The line reached, from 1.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// The first word of the next statement; the previous one must have been read to its end.
    pub(super) fn next_statement(&mut self) -> Option<Token<'a>> {
        loop {
            if let Some(word) = self.next_word() {
                return Some(word);
            }
            let end = line_end(self.rest);
            if end == 0 {
                return None;
            }
            self.rest = &self.rest[end..];
            self.line += 1;
        }
    }

    /// Passes over the rest of the statement.
    pub(super) fn skip_statement(&mut self) {
        while self.next_word().is_some() {}
    }

    /// The next word of the statement.
    pub(super) fn next_word(&mut self) -> Option<Token<'a>> {
        self.skip_blank();
        if self.rest.first() == Some(&b'#') {
            let end = self.rest.iter().position(|&byte| matches!(byte, b'\n' | b'\r')).unwrap_or(self.rest.len());
            self.rest = &self.rest[end..];
        }
        let is_end = |at: usize| {
            let rest = &self.rest[at..];
            is_blank(rest[0]) || line_end(rest) > 0 || joined_line_end(rest).is_some()
        };
        let length = (0..self.rest.len()).find(|&at| is_end(at)).unwrap_or(self.rest.len());
        let (text, rest) = self.rest.split_at(length);
        self.rest = rest;
        (length > 0).then_some(Token { text, line: self.line })
    }

    /// Passes over blanks and joined line ends.
    fn skip_blank(&mut self) {
        loop {
            if self.rest.first().is_some_and(|&byte| is_blank(byte)) {
                self.rest = &self.rest[1..];
            } else if let Some(length) = joined_line_end(self.rest) {
                self.rest = &self.rest[length..];
                self.line += 1;
            } else {
                break;
            }
        }
    }
}

/// Space, tab, vertical tab, form feed.
fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0B | 0x0C)
}

/// Length of the line end that `text` begins with, 0 when it begins with none.
fn line_end(text: &[u8]) -> usize {
    match text {
        [b'\r', b'\n', ..] => 2,
        [b'\r' | b'\n', ..] => 1,
        _ => 0,
    }
}

/// Length of the `\` and line end that `text` begins with; the end of the text counts as one.
fn joined_line_end(text: &[u8]) -> Option<usize> {
    match text {
        [b'\\'] => Some(1),
        [b'\\', rest @ ..] if line_end(rest) > 0 => Some(1 + line_end(rest)),
        _ => None,
    }
}
