//! The states of crowded bodies (`crowd_step.rs`) at the present, kept while a program reads them one by one.
//!
//! A state within a time step is that of a shorter time step, which all bodies of the crowd make together. It is made
//! once for each crowd and time, in one buffer of the states of all bodies, so that reading every body costs what
//! reading all at once does. The cache is no part of the simulation state.

use polhode_dynamics::BodyState;
use std::collections::BTreeSet;
use std::sync::Mutex;

/// A time step of a crowd: its first body, and the bits of its start and of its end (s).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct StepKey {
    first: usize,
    start: u64,
    end: u64,
}

impl StepKey {
    /// That of the crowd whose first body is `first`, from `start` to `end` (s).
    pub(super) fn new(first: usize, start: f64, end: f64) -> Self {
        Self { first, start: start.to_bits(), end: end.to_bits() }
    }
}

/// What has been made so far.
#[derive(Debug, Default)]
struct Made {
    /// When, s.
    t: f64,
    /// Of the movable bodies those of the crowds in `steps` are valid, of the fixed ones all.
    states: Vec<BodyState>,
    steps: BTreeSet<StepKey>,
}

/// States of crowded bodies at one time.
#[derive(Debug, Default)]
pub(super) struct PresentCrowds(Mutex<Made>);

impl PresentCrowds {
    /// The state of a body of the crowd `step` at `t` (s). Where it has not been made yet, `advance` writes the states
    /// of the crowd into those of all bodies, which are `all` at first.
    pub(super) fn state(
        &self,
        (body, step): (usize, StepKey),
        t: f64,
        all: &[BodyState],
        advance: impl FnOnce(&mut [BodyState]),
    ) -> Option<BodyState> {
        // It is not asked while it makes a step; if it were, the answer would be made without the buffer.
        let (mut kept, mut none) = (self.0.try_lock(), Made::default());
        let made = kept.as_deref_mut().unwrap_or(&mut none);
        if made.states.len() != all.len() {
            *made = Made { t, states: all.to_vec(), steps: BTreeSet::new() };
        }
        if made.t != t {
            made.t = t;
            made.steps.clear();
        }
        if made.steps.insert(step) {
            advance(&mut made.states);
        }
        made.states.get(body).copied()
    }

    /// Forgets all: a program has changed bodies.
    pub(super) fn invalidate(&mut self) {
        *self = Self::default();
    }
}

#[cfg(test)]
mod tests {
    //! A crowd makes its step once for each time, whichever of its bodies are read.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use polhode_spatial::{DVec3, Pose};

    fn at(x: f64) -> BodyState {
        BodyState::at_rest(Pose::from_translation(DVec3::X * x))
    }

    #[test]
    fn reading_all_bodies_of_a_crowd_makes_one_step() {
        const BODIES: usize = 100;
        let (present, all) = (PresentCrowds::default(), vec![at(0.0); BODIES]);
        let key = StepKey::new(0, 0.0, 1.0);
        let made = std::cell::Cell::new(0);
        for t in [0.25, 0.5] {
            for body in 0..BODIES {
                let advance = |states: &mut [BodyState]| {
                    made.set(made.get() + 1);
                    states.fill(at(t));
                };
                assert_eq!(present.state((body, key), t, &all, advance), Some(at(t)));
            }
        }
        assert_eq!(made.get(), 2);
    }

    /// Another step of the same crowd, at the same time, is made too.
    #[test]
    fn a_new_step_is_made() {
        let (present, all) = (PresentCrowds::default(), vec![at(0.0)]);
        present.state((0, StepKey::new(0, 0.0, 1.0)), 0.5, &all, |states| states[0] = at(1.0));
        let new = present.state((0, StepKey::new(0, 0.25, 1.0)), 0.5, &all, |states| states[0] = at(2.0));
        assert_eq!(new, Some(at(2.0)));
    }
}
