//! The texts of a document, and from byte ranges to lines and columns.

use crate::error::{Place, Refusal};
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use std::ops::Range;

/// Lines longer than this (bytes) are shown in part.
const LONGEST_LINE: usize = 4096;

/// Bytes shown on either side of the place in a line that is shown in part.
const CONTEXT: usize = 60;

/// One text.
#[derive(Debug, Clone)]
pub(crate) struct Source {
    origin: String,
    text: String,
    start: usize,
}

impl Source {
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Where the ranges of this text begin.
    pub(crate) fn start(&self) -> usize {
        self.start
    }

    /// What stands before the `=`: the key, of a text that sets one.
    pub(crate) fn key(&self) -> &str {
        self.text.split('=').next().unwrap_or_default().trim()
    }
}

/// The texts of a document: the file first, then one for each value set from outside.
#[derive(Debug, Clone)]
pub(crate) struct Sources {
    file: Source,
    rest: Vec<Source>,
}

impl Sources {
    pub(crate) fn new(origin: &str, text: String) -> Self {
        Self { file: Source { origin: origin.to_owned(), text, start: 0 }, rest: Vec::new() }
    }

    pub(crate) fn push(&mut self, origin: &str, text: String) {
        let last = self.rest.last().unwrap_or(&self.file);
        // One byte apart, so that the end of one text is not the start of the next.
        let start = last.start + last.text.len() + 1;
        self.rest.push(Source { origin: origin.to_owned(), text, start });
    }

    /// The file, and the texts that change it.
    pub(crate) fn texts(&self) -> (&Source, &[Source]) {
        (&self.file, &self.rest)
    }

    /// Place of a range, named by `key`.
    pub(crate) fn place(&self, span: &Range<usize>, key: String) -> Place {
        let (source, at) = self.find(span);
        let line = Line::around(&source.text, at.start);
        let column = source.text[line.range.start..at.start].chars().count() + 1;
        Place { origin: source.origin.clone(), line: line.number, column, key }
    }

    /// The message with the line shown.
    pub(crate) fn render(&self, span: &Range<usize>, place: &Place, cause: &Refusal) -> String {
        let (source, at) = self.find(span);
        let line = Line::around(&source.text, at.start);
        let end = at.end.clamp(at.start, line.range.end);
        let message = cause.to_string();
        let title = Level::ERROR.primary_title(message.as_str());
        let long = line.range.len() > LONGEST_LINE;
        let shown = if long {
            let from = boundary(&source.text, at.start.saturating_sub(CONTEXT).max(line.range.start));
            from..boundary(&source.text, (at.start + CONTEXT).min(line.range.end))
        } else {
            line.range.clone()
        };
        let marked = at.start - shown.start..end.clamp(at.start, shown.end) - shown.start;
        let snippet = Snippet::source(&source.text[shown])
            .line_start(line.number)
            .annotation(AnnotationKind::Primary.span(marked));
        let group = Group::with_title(title);
        // The column is counted within what is shown, so a line shown in part names its place by itself.
        let mut group = if long {
            group
                .element(Origin::path(place.origin.as_str()).line(place.line).char_column(place.column))
                .element(snippet)
        } else {
            group.element(snippet.path(place.origin.as_str()))
        };
        let key = format!("key `{}`", place.key);
        if !place.key.is_empty() {
            group = group.element(Level::NOTE.message(key.as_str()));
        }
        let accepted = cause.accepted().unwrap_or_default();
        if !accepted.is_empty() {
            group = group.element(Level::HELP.message(accepted.as_str()));
        }
        Renderer::plain().render(&[group])
    }

    /// The text a range is in, and the range within it, cut to the text.
    fn find(&self, span: &Range<usize>) -> (&Source, Range<usize>) {
        let source = self.rest.iter().rev().find(|source| span.start >= source.start).unwrap_or(&self.file);
        let length = source.text.len();
        let start = boundary(&source.text, (span.start - source.start).min(length));
        let end = boundary(&source.text, span.end.saturating_sub(source.start).clamp(start, length));
        (source, start..end)
    }
}

/// The nearest character boundary at or below `at`.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}

/// A line of a text.
struct Line {
    /// From 1.
    number: usize,
    /// Its bytes, without the line's end.
    range: Range<usize>,
}

impl Line {
    /// The line that holds byte `at`.
    fn around(text: &str, at: usize) -> Self {
        let before = &text.as_bytes()[..at];
        let start = before.iter().rposition(|&b| b == b'\n').map_or(0, |newline| newline + 1);
        let end = text.as_bytes()[at..].iter().position(|&b| b == b'\n').map_or(text.len(), |length| at + length);
        let end = if text[start..end].ends_with('\r') && end > at { end - 1 } else { end };
        Self { number: before.split(|&b| b == b'\n').count(), range: start..end }
    }
}
