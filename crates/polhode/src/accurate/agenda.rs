//! The agenda of the run: the times at which the steps of islands end, pairs collide, the boxes of bodies in flight are
//! renewed, and the motions of kinematic bodies are not smooth.
//!
//! Entries are ordered by time, and entries of one time by kind and bodies, so that the order of insertion does not
//! matter.

use std::cmp::Ordering;
use std::collections::BTreeSet;

/// What is due.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Due {
    /// The step of the island with this first body ends, at a change of its contacts or as planned.
    Island(usize),
    /// Two bodies collide.
    Impact(usize, usize),
    /// The boxes of bodies in flight cease to be valid.
    FlightBoxes,
    /// The motion of a kinematic body is not smooth.
    Corner(usize),
}

/// A time with a total order.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Time(f64);

impl Eq for Time {}

impl PartialOrd for Time {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Time {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The agenda of a run.
#[derive(Debug, Clone, Default)]
pub(super) struct Agenda {
    entries: BTreeSet<(Time, Due)>,
}

impl Agenda {
    /// Puts an entry in; one at a time that is not finite is never due.
    pub(super) fn add(&mut self, t: f64, due: Due) {
        if t.is_finite() {
            self.entries.insert((Time(t), due));
        }
    }

    /// Takes an entry out.
    pub(super) fn remove(&mut self, t: f64, due: Due) {
        self.entries.remove(&(Time(t), due));
    }

    /// The first entry: when (s) and what.
    pub(super) fn first(&self) -> Option<(f64, Due)> {
        self.entries.first().map(|&(Time(t), due)| (t, due))
    }
}

#[cfg(test)]
mod tests {
    use super::{Agenda, Due};

    #[test]
    fn entries_are_ordered_by_time_then_kind_and_not_by_insertion() {
        let mut agenda = Agenda::default();
        agenda.add(2.0, Due::FlightBoxes);
        agenda.add(1.0, Due::Impact(1, 2));
        agenda.add(1.0, Due::Island(7));
        agenda.add(f64::INFINITY, Due::Island(3));
        let mut order = Vec::new();
        while let Some((t, due)) = agenda.first() {
            order.push((t, due));
            agenda.remove(t, due);
        }
        assert_eq!(order, [(1.0, Due::Island(7)), (1.0, Due::Impact(1, 2)), (2.0, Due::FlightBoxes)]);
    }
}
