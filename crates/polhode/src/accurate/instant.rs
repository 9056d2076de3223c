//! The instant of an event: its time, affected bodies and contacts (`events.rs` collects them).

use super::contact_change::ContactChange;
use super::pace::NoAdvance;
use crate::collision::contact_set;
use crate::collision::touch::{Hold, Touch};
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::{Model, tolerances};
use crate::tier::core::Core;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Time, bodies and contacts of an event.
#[derive(Debug)]
pub(super) struct Instant {
    /// s.
    pub(super) t: f64,
    /// Movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// Pairs of these, and of these and immovable bodies, that may touch, ascending.
    pub(super) pairs: Vec<(usize, usize)>,
    /// Contacts, sorted by identity.
    pub(super) touches: Vec<Touch>,
    /// What changes at its contacts: steps that end at this instant have located it.
    pub(super) change: ContactChange,
    /// Bodies that this instant wakes from rest.
    pub(super) woken: BTreeSet<usize>,
    /// When the bounces that are ended at this instant would have ended, by body, s.
    pub(super) rest_times: BTreeMap<usize, f64>,
    /// When the slips that are ended at this instant would have ended, s.
    pub(super) slip_ends: BTreeMap<ContactId, f64>,
    /// Largest speed of any of the bodies so far, at least that of a fall over a body's size, m/s.
    pub(super) speed_scale: f64,
}

impl Instant {
    /// The same instant for some of its bodies (ascending) alone, none of whose contacts is known. Of `pairs` and its
    /// own pairs it has those that concern no other of its movable bodies.
    pub(super) fn part(&self, core: &Core, bodies: Vec<usize>, pairs: &[(usize, usize)]) -> Self {
        let concerns = |body: usize| bodies.binary_search(&body).is_ok();
        let is_given = |body: usize| !core.model.bodies[body].moves();
        let is_own =
            |&(a, b): &(usize, usize)| (concerns(a) && (concerns(b) || is_given(b))) || (is_given(a) && concerns(b));
        let own: BTreeSet<_> = self.pairs.iter().chain(pairs).copied().filter(is_own).collect();
        Self {
            t: self.t,
            pairs: own.into_iter().collect(),
            touches: Vec::new(),
            change: ContactChange { t: self.t, ..ContactChange::default() },
            woken: BTreeSet::new(),
            rest_times: BTreeMap::new(),
            slip_ends: BTreeMap::new(),
            speed_scale: self.speed_scale,
            bodies,
        }
    }

    /// Bodies in planar motion that touch others are simulated in space from now on. Returns them.
    pub(super) fn release_from_plane(&self, model: &mut Model, states: &[BodyState]) -> BTreeSet<usize> {
        let mut released = BTreeSet::new();
        let touch = |model: &Model, (a, b): (usize, usize)| {
            let reach = tolerances::touch_distance(model, states, a, b);
            model.planar.part((a, b)) && !contact_set::pair(model, states, a, b, reach).contacts.is_empty()
        };
        while let Some(&pair) = self.pairs.iter().find(|&&pair| touch(model, pair)) {
            released.extend(model.planar.meet(&[pair]));
        }
        released
    }

    /// Pairs with a held contact.
    pub(super) fn held_pairs(&self) -> BTreeSet<(usize, usize)> {
        let held = self.touches.iter().filter(|touch| touch.hold == Hold::Held);
        held.map(|touch| (touch.id.a, touch.id.b)).collect()
    }

    /// The error of steps that no longer advance time.
    pub(super) fn no_progress(&self, core: &Core, stuck: NoAdvance) -> SimulationError {
        let held = |touch: &&Touch| touch.hold == Hold::Held;
        let touch = self.touches.iter().find(held).or(self.touches.first());
        let point = touch.map_or(DVec3::ZERO, |touch| touch.kinematics.geometry.point);
        let name = |body: usize| core.model.bodies[body].name.clone();
        let touching = touch.map(|touch| [touch.id.a, touch.id.b]);
        // Without a contact, the bodies of the event are named.
        let members = touching
            .unwrap_or_else(|| [self.bodies.first(), self.bodies.last()].map(|body| body.copied().unwrap_or(0)));
        let [body_a, body_b] = members.map(name);
        let (steps, advanced_s) = (stuck.steps, stuck.advanced_s);
        SimulationError::NoProgress { t_s: self.t, steps, advanced_s, body_a, body_b, point }
    }

    /// All contacts with their indices, as input of group formation.
    pub(super) fn numbered(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        self.touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b))
    }
}
