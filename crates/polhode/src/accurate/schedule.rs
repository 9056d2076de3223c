//! What is due, and between whom: the agenda of a run, the pairs that may meet, and the contacts of those that touch.
//!
//! `impact_search.rs` finds the pairs that may meet and the times at which they do.

use super::agenda::{Agenda, Due};
use super::contacts::Contacts;
use super::near_pairs::NearPairs;
use crate::model::prescribed;
use crate::tier::core::Core;

/// What is due in a run.
#[derive(Debug)]
pub(super) struct Schedule {
    pub(super) contacts: Contacts,
    pub(super) near: NearPairs,
    pub(super) agenda: Agenda,
}

impl Schedule {
    /// Adds the next time at which the motion of a kinematic body is not smooth to the agenda.
    pub(super) fn expect_corner(&mut self, core: &Core, body: usize, t: f64) {
        self.agenda.add(prescribed::next_corner(&core.model, body, t), Due::Corner(body));
    }

    /// The bodies that a body may meet or touches, itself where it has stops with the world; some are repeated.
    pub(super) fn partners<'a>(&'a self, core: &'a Core, body: usize) -> impl Iterator<Item = usize> + 'a {
        let near = self.near.partners(body).iter().copied().chain(self.contacts.partners(body));
        near.chain(core.model.joints.joint_contact_partners(body))
    }
}
