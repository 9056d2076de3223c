//! Islands: bodies that move together until the next event.
//!
//! Bodies are in one island if they are connected by held contacts, or by forces that couple their motions. One
//! integrator advances them, with common variables. An island advances by its own steps, with its own contacts and
//! events; a body in flight or at rest is in none. Bodies of different islands interact only through the search for
//! their impact.

use super::constrained_step::ConstrainedStep;
use super::crowd_step::CrowdStep;
use super::free_stepping::FreeStep;
use crate::collision::contact_set::ContactId;
use std::collections::BTreeSet;

/// Bodies that move together.
#[derive(Debug)]
pub(super) struct Island {
    /// Movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// Contacts held, ascending.
    pub(super) held: Vec<ContactId>,
    /// Start of the present step, s: the states of the bodies are those of that time.
    pub(super) t: f64,
    /// The present step.
    pub(super) step: Step,
    /// When the step ends, or its active set ceases to be valid, s.
    pub(super) due: f64,
    /// Whether the contacts change then.
    pub(super) changes: bool,
    /// Whether contact forces, or a step under them, could not be found: time steps then advance the island.
    pub(super) is_unsolved: bool,
    /// Contacts that break then: their forces reach zero.
    pub(super) departing: BTreeSet<ContactId>,
}

/// A step of an island.
#[derive(Debug)]
pub(super) enum Step {
    /// By DOP853 or RK4, with contact forces at every stage.
    Constrained(ConstrainedStep),
    /// By the integrator of free motion.
    Free(Box<FreeStep>),
    /// By one time step of a stretch of crowded events.
    Crowd(Box<CrowdStep>),
    /// No step, at this time (s). Either the run ends here: a step may not be needed, and prescribed quantities may be
    /// undefined beyond the end. Or error control accepts no step, and time steps will advance the island.
    Waiting(f64),
}

impl Island {
    /// Bodies (ascending) that begin a step at `t` (s) with these contacts held (ascending): the event that ends it is
    /// not located yet.
    pub(super) fn beginning(bodies: Vec<usize>, held: Vec<ContactId>, t: f64, step: Step) -> Self {
        let departing = BTreeSet::new();
        Self { bodies, held, t, step, due: f64::INFINITY, changes: false, is_unsolved: false, departing }
    }

    /// The first body, which identifies the island.
    pub(super) fn first(&self) -> Option<usize> {
        self.bodies.first().copied()
    }

    /// Whether it is in a stretch of crowded events and advances by time steps.
    pub(super) fn is_crowd(&self) -> bool {
        matches!(self.step, Step::Crowd(_))
    }

    /// End of the step, s.
    pub(super) fn end(&self) -> f64 {
        match &self.step {
            Step::Constrained(step) => step.end,
            Step::Free(step) => step.end,
            Step::Crowd(step) => step.end,
            Step::Waiting(t) => *t,
        }
    }
}
