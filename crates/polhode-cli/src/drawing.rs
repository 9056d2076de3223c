//! Drawing of pictures after a run: its progress, and its end by Ctrl-C.

use crate::interrupt::Interrupt;
use crate::progress::Progress;
use polhode::Flow;

/// How drawing is watched.
pub(crate) struct Drawing<'a> {
    interrupt: &'a Interrupt,
    /// Whether an end had been asked for before drawing began: what a run has reached by then is drawn all the same.
    was_asked: bool,
    progress: Progress,
}

impl<'a> Drawing<'a> {
    /// Drawing that begins now.
    pub(crate) fn watched_by(interrupt: &'a Interrupt) -> Self {
        Self { interrupt, was_asked: interrupt.has_come(), progress: Progress::new("drawing") }
    }

    /// A moving picture of so many frames begins.
    pub(crate) fn begin(&self, frames: usize) {
        self.progress.phase("drawing frames", frames);
    }

    /// So many frames of it are drawn.
    pub(crate) fn reached(&self, drawn: usize) -> Flow {
        if drawn > 0 {
            self.progress.part_done();
        }
        if self.interrupt.has_come() && !self.was_asked { Flow::Stop } else { Flow::Continue }
    }

    /// The exit code where it was stopped.
    pub(crate) fn code(&self) -> u8 {
        self.interrupt.code()
    }
}
