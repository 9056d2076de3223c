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

/// Writes one JSON value that was asked for, indented, to stdout. Text of which a reader has seen enough is no mistake;
/// a value that is cut off is no value.
///
/// # Errors
/// When stdout is closed, or is so before the value is written.
pub(crate) fn json(value: &serde_json::Value) -> Result<(), Failure> {
    expect_open()?;
    raw(&format!("{value:#}\n")).map_err(|failure| match failure {
        Failure::StdoutClosed => closed(),
        other => other,
    })
}

/// That there is a stdout to which a value can be written.
///
/// # Errors
/// When it is closed.
pub(crate) fn expect_open() -> Result<(), Failure> {
    if was_closed() { Err(closed()) } else { Ok(()) }
}

fn closed() -> Failure {
    Failure::InputOutput("error: cannot write the JSON: stdout is closed".to_owned())
}

/// Whether the program was started without a stdout. The standard library then opens the null device in its place, for
/// reading and writing, as no shell does that is asked to discard an output; Linux says so, elsewhere it is not known.
#[cfg(target_os = "linux")]
fn was_closed() -> bool {
    /// The bits of the access mode in the flags of an open file, and that of reading and writing.
    const ACCESS_MODE: u32 = 0o3;
    const READ_AND_WRITE: u32 = 0o2;
    let is_null = std::fs::read_link("/proc/self/fd/1").is_ok_and(|path| path.as_os_str() == "/dev/null");
    let flags = std::fs::read_to_string("/proc/self/fdinfo/1").ok().and_then(|about| {
        let flags = about.lines().find_map(|line| line.strip_prefix("flags:"))?;
        u32::from_str_radix(flags.trim(), 8).ok()
    });
    is_null && flags.is_some_and(|flags| flags & ACCESS_MODE == READ_AND_WRITE)
}

#[cfg(not(target_os = "linux"))]
fn was_closed() -> bool {
    false
}
