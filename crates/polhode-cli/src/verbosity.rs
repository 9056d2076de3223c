//! How much the program says on stderr: asked for once, on the command line.

use std::sync::OnceLock;

/// How much is said besides results and errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verbosity {
    /// Nothing.
    Quiet,
    /// Progress of what takes long, and notes.
    Usual,
    /// Also what is being done.
    Verbose,
}

static ASKED: OnceLock<Verbosity> = OnceLock::new();

/// Keeps what the command line asks for; later calls change nothing.
pub(crate) fn set(verbosity: Verbosity) {
    let _ = ASKED.set(verbosity);
}

/// What the command line asks for.
pub(crate) fn asked() -> Verbosity {
    ASKED.get().copied().unwrap_or(Verbosity::Usual)
}
