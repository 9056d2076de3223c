//! What a run has told and its files do not hold yet: a sample is written when its estimated errors are known, and
//! events and joints stay in their places among the samples, so that what a program that is killed leaves ends at one
//! time. What waits is bounded: a run may make a single step of many samples, or be compared late.

use polhode::{BodySample, ContactSample, Event, JointSample};
use std::collections::VecDeque;

/// Bytes of samples that wait at the most: 250 samples of ten thousand bodies. Beyond, the first are written without
/// errors.
const MOST_BYTES: usize = 1 << 28;

/// What a run tells an observer.
#[derive(Debug)]
pub(super) enum Told {
    /// All bodies at a time, s.
    Sample(f64, Vec<BodySample>),
    /// An event.
    Event(Event),
    /// The joints at a time, s.
    Joints(f64, Vec<JointSample>),
    /// The contacts at a time, s.
    Contacts(f64, Vec<ContactSample>),
}

/// What is held back, in the order in which it was told.
#[derive(Debug, Default)]
pub(super) struct HeldBack {
    queue: VecDeque<Told>,
    /// Bytes of the samples in it.
    bytes: usize,
}

impl HeldBack {
    /// Holds something back.
    pub(super) fn push(&mut self, told: Told) {
        self.bytes += told.bytes();
        self.queue.push_back(told);
    }

    /// When the first sample was taken, s, if it can wait no longer.
    pub(super) fn overdue_s(&self) -> Option<f64> {
        let first = |told: &Told| if let Told::Sample(t, _) = told { Some(*t) } else { None };
        if self.bytes > MOST_BYTES { self.queue.iter().find_map(first) } else { None }
    }

    /// What is to be written next when the errors of the samples until `t` (s) are known.
    pub(super) fn pop_until(&mut self, t: f64) -> Option<Told> {
        if matches!(self.queue.front()?, Told::Sample(sample_s, _) if *sample_s > t) {
            return None;
        }
        let told = self.queue.pop_front()?;
        self.bytes -= told.bytes();
        Some(told)
    }
}

impl Told {
    /// Bytes, of samples.
    fn bytes(&self) -> usize {
        if let Self::Sample(_, bodies) = self { size_of_val(bodies.as_slice()) } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    //! Samples wait until they are too many, and events keep their places among them.
    use super::*;
    use polhode::{BodyId, EventKind, spatial};

    fn sample(t: f64, bodies: usize) -> Told {
        let at_rest = BodySample { pose: spatial::Pose::IDENTITY, velocity: spatial::Velocity::ZERO };
        Told::Sample(t, vec![at_rest; bodies])
    }

    #[test]
    fn samples_wait_in_bounded_memory() {
        let bodies = MOST_BYTES / size_of::<BodySample>() / 2;
        let mut held = HeldBack::default();
        held.push(sample(0.0, bodies));
        held.push(Told::Event(Event::new(0.5, EventKind::Rest, BodyId::new(0))));
        held.push(sample(1.0, bodies));
        assert!(held.overdue_s().is_none() && held.pop_until(-1.0).is_none());
        held.push(sample(2.0, 2));
        assert_eq!(held.overdue_s(), Some(0.0));
        assert!(matches!(held.pop_until(0.0), Some(Told::Sample(0.0, _))));
        assert!(matches!(held.pop_until(0.0), Some(Told::Event(_))));
        assert!(held.pop_until(0.0).is_none() && held.overdue_s().is_none());
    }
}
