//! How deep bodies overlap, as plots and pages show it.
//!
//! The certificate measures penetration where the run makes its steps, a frame shows it at its own time. The largest so
//! far is of both, so that what is shown now is never above it.

use polhode::Frame;

/// The largest penetration up to a frame.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Penetration {
    largest_m: f64,
}

/// How deep bodies overlap at a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Depths {
    /// Now, m.
    pub(crate) now_m: f64,
    /// The largest so far, m.
    pub(crate) largest_m: f64,
}

impl Penetration {
    /// At the next frame.
    pub(crate) fn of(&mut self, frame: &Frame) -> Depths {
        let now_m = frame.contacts.iter().map(|contact| -contact.separation_m).fold(0.0, f64::max);
        self.largest_m = self.largest_m.max(frame.certificate.max_penetration_m).max(now_m);
        Depths { now_m, largest_m: self.largest_m }
    }
}
