//! What the program that asks for a study does for it: shows how far it is, ends it early, counts instructions.

use crate::candidate::Candidate;
use polhode::Flow;
use polhode_scene::Override;

/// The program that a study runs in.
pub trait Host {
    /// Work of `count` parts begins, which may turn out to be fewer.
    fn phase(&self, what: &'static str, count: usize) {
        let _ = (what, count);
    }

    /// One part of the present work is done.
    fn part_done(&self) {}

    /// Whether the study goes on; asked at every step of its runs.
    fn flow(&self) -> Flow {
        Flow::Continue
    }

    /// Instructions of the steps of one run of a candidate, with a change that sets the interval of its samples.
    ///
    /// # Errors
    /// Why they cannot be counted, in a line.
    fn instructions(&self, candidate: &Candidate, sampling: &Override) -> Result<u64, String> {
        let _ = (candidate, sampling);
        Err("this program cannot count instructions: `polhode cost --instructions` does".to_owned())
    }
}

/// A host that shows nothing and lets every study come to its end.
#[derive(Debug, Clone, Copy)]
pub struct Alone;

impl Host for Alone {}
