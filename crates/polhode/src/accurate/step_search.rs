//! A search within a step of an island: for the first time at which its active set ceases to be valid (`locate.rs`),
//! and for contacts that penetrate (`penetration.rs`).

use super::constrained_step::ConstrainedStep;
use crate::identity::contact_id::ContactId;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use std::collections::BTreeSet;

/// What a search within a step reads and writes.
#[derive(Debug)]
pub(super) struct StepSearch<'a> {
    pub(super) core: &'a mut Core,
    pub(super) step: &'a ConstrainedStep,
    /// States of all bodies at the start of the step.
    pub(super) start: &'a [BodyState],
    /// Those at the time that is looked at; of bodies outside of the island, of some time.
    pub(super) states: &'a mut [BodyState],
    /// Contacts that no longer hold, and are tolerated for a short time.
    pub(super) tolerated: BTreeSet<ContactId>,
}
