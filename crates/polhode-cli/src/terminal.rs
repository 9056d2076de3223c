//! Stderr: messages, and below them, on a terminal, one line that is drawn again and again.
//!
//! The line is written over with spaces and a carriage return: no colour and no escape sequence goes out, so that
//! `NO_COLOR` has nothing to switch off. Whoever writes a message takes the line away first; the next drawing brings
//! it back below.

use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Columns of a terminal that does not say how many it has.
const USUAL_WIDTH: usize = 80;

/// How many columns of the present line are drawn on.
static DRAWN: Mutex<usize> = Mutex::new(0);

/// How many columns the terminal at stderr has at present; nothing where a line cannot be drawn again: stderr is no
/// terminal, or one that calls itself `dumb`.
pub(crate) fn width() -> Option<usize> {
    if !io::stderr().is_terminal() || std::env::var_os("TERM").is_some_and(|term| term == "dumb") {
        return None;
    }
    let columns = console::Term::stderr().size_checked().map_or(0, |(_rows, columns)| usize::from(columns));
    Some(if columns == 0 { USUAL_WIDTH } else { columns })
}

/// Draws a line in place of the last one; it must be shorter than the terminal is wide, and hold no end of line.
pub(crate) fn draw(line: &str) {
    let mut drawn = lock();
    // One call, so that no half of a line is seen.
    write(&format!("\r{line:<width$}", width = *drawn));
    *drawn = line.chars().count();
}

/// Takes the line away.
pub(crate) fn erase() {
    write(&taken_away(&mut lock()));
}

/// Writes a message and an end of line; when stderr is closed there is nobody to tell.
pub(crate) fn message(text: &str) {
    let mut drawn = lock();
    let before = taken_away(&mut drawn);
    write(&format!("{before}{text}\n"));
}

/// What takes a line of so many columns away.
fn taken_away(drawn: &mut usize) -> String {
    let width = std::mem::take(drawn);
    if width == 0 { String::new() } else { format!("\r{:width$}\r", "") }
}

fn lock() -> MutexGuard<'static, usize> {
    DRAWN.lock().unwrap_or_else(PoisonError::into_inner)
}

fn write(text: &str) {
    if !text.is_empty() {
        let _ = io::stderr().write_all(text.as_bytes());
    }
}
