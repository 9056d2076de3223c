//! Islands: bodies that move together until the next event.
//!
//! Bodies are in one island if they are connected by held contacts, or by forces that couple their motions. One
//! integrator advances them, with common variables. An island advances by its own steps, with its own contacts and
//! events; a body in flight or at rest is in none. Bodies of different islands interact only through the search for
//! their impact.

use super::constrained_step::ConstrainedStep;
use super::contact_change::ContactChange;
use super::crowd_step::CrowdStep;
use super::free_stepping::FreeStep;
use crate::collision::active_contacts::ActiveContacts;

/// Bodies that move together.
#[derive(Debug)]
pub(super) struct Island {
    /// Movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// Its active contacts.
    pub(super) active: ActiveContacts,
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
    /// Contacts that break, stop or begin to slide then.
    pub(super) change: ContactChange,
}

/// A step of an island.
#[derive(Debug)]
pub(super) enum Step {
    /// By DOP853 or RK4, with contact forces at every stage.
    Constrained(Box<ConstrainedStep>),
    /// By the integrator of free motion.
    Free(Box<FreeStep>),
    /// By one time step of a stretch of crowded events.
    Crowd(Box<CrowdStep>),
    /// No step, at this time (s). Either the run ends here: a step may not be needed, and prescribed quantities may be
    /// undefined beyond the end. Or error control accepts no step, and time steps will advance the island.
    Waiting(f64),
}

impl Island {
    /// Bodies (ascending) that begin a step at `t` (s) with these active contacts: the event that ends it is not
    /// located yet.
    pub(super) fn beginning(bodies: Vec<usize>, active: ActiveContacts, t: f64, step: Step) -> Self {
        let change = ContactChange { t: f64::INFINITY, ..ContactChange::default() };
        Self { bodies, active, t, step, due: f64::INFINITY, changes: false, is_unsolved: false, change }
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
