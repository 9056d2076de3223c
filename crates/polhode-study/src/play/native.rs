//! The hashes of a run at many of its steps, to hold the same run on another platform against.

use super::error::PlayError;
use super::playground::Playground;

/// The hashes of a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hashes {
    /// The strict hash up to the end of a step, by the number of the step: of every power of two.
    pub marks: Vec<(u64, u64)>,
    /// The strict hash of the whole run, or of what was computed of it.
    pub hash: u64,
    /// Whether it has come to its end.
    pub ended: bool,
}

impl Hashes {
    /// The strict hash of the whole run; none where it was stopped before its end.
    pub fn whole(&self) -> Option<u64> {
        self.ended.then_some(self.hash)
    }
}

impl Playground {
    /// Runs to the end, or as long as it may go on, and takes the hashes of the run.
    ///
    /// # Errors
    /// When the engine ends the run.
    pub fn hashes(&mut self, mut goes_on: impl FnMut() -> bool) -> Result<Hashes, PlayError> {
        let mut marks = Vec::new();
        while !self.has_ended() && goes_on() {
            self.step()?;
            if self.steps().is_power_of_two() {
                marks.push((self.steps(), self.hash().value()));
            }
        }
        Ok(Hashes { marks, hash: self.hash().value(), ended: self.has_ended() })
    }
}
