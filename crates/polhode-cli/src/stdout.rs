//! Writing results.

use crate::failure::Failure;
use std::borrow::Cow;
use std::io::{self, Write};

/// Writes text to stdout. Names may hold any character: what would steer a terminal is written out.
pub(crate) fn text(text: &str) -> Result<(), Failure> {
    raw(&harmless(text))
}

/// The text with its control characters, but for ends of lines and tabs, written as escapes.
pub(crate) fn harmless(text: &str) -> Cow<'_, str> {
    let steers = |c: char| c.is_control() && c != '\n' && c != '\t';
    if !text.contains(steers) {
        return Cow::Borrowed(text);
    }
    let escaped = |c: char| if steers(c) { c.escape_default().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(escaped).collect())
}

/// Writes text to stdout as it is.
fn raw(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(())
}

/// Writes one JSON value, indented, to stdout.
pub(crate) fn json(value: &serde_json::Value) -> Result<(), Failure> {
    raw(&format!("{value:#}\n"))
}
