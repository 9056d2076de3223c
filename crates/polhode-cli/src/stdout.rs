//! Writing results.

use crate::failure::Failure;
use crate::harmless::harmless;
use std::io::{self, Write};

/// Writes text to stdout. Names may hold any character: what would steer a terminal is written out.
pub(crate) fn text(text: &str) -> Result<(), Failure> {
    raw(&harmless(text))
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
