//! Islands that rest, which the steps leave out until something comes near them.
//!
//! Bodies at rest whose contacts have forces that hold all of them (`crate::solve::held_at_rest`) stay at rest.
//! Likewise, a step that begins and ends with all bodies of an island at rest, in the same poses, ends so again as long
//! as nothing else changes: its contacts, their forces and what holds the bodies are the same. Such an island is not
//! stepped again. It keeps its states, contacts and forces; its weight and what bears it are entered in the books. It
//! is stepped again as soon as another body may touch one of its own within a step, or a program acts.
//!
//! Every few steps each group of bodies that touch each other is looked at whose speeds are no more than a step leaves
//! of rest: where forces hold it, it rests from then on, and its motion is entered in the books as ended.
//!
//! Assumption: nothing on the bodies depends on time. Islands with force fields, joints, or beside them a body of
//! prescribed motion or with a moving surface, are always stepped.
//!
//! Simulating all effects ([`Effects::All`](crate::Effects)) makes the steps of these islands, too, to find their
//! contacts and forces anew, and goes on from what was there before: the motion has the same bits.

use super::islands::{Island, travel_of};
use crate::accounting::books::Books;
use crate::collision::{contact_set, moving_surfaces};
use crate::model::{Model, prescribed, tolerances};
use crate::report::momentum_ledger::Momentum;
use polhode_dynamics::{BodyState, Flight};
use polhode_spatial::DisjointSets;
use std::collections::BTreeSet;

/// Which bodies rest.
#[derive(Debug, Clone, Default)]
pub(super) struct Resting {
    of_body: Vec<bool>,
    /// Their weight with its moment, N and N m, while they are the same.
    weight: Option<Momentum>,
    /// Whether all that could move rests, while they are the same.
    everything: Option<bool>,
}

impl Resting {
    /// None of this many bodies.
    pub(super) fn none(bodies: usize) -> Self {
        Self { of_body: vec![false; bodies], ..Self::default() }
    }

    /// These bodies.
    pub(super) fn restored(of_body: Vec<bool>) -> Self {
        Self { of_body, ..Self::default() }
    }

    /// As plain data.
    pub(super) fn save(&self) -> Vec<bool> {
        self.of_body.clone()
    }

    /// Takes up a body that has been added.
    pub(super) fn add_body(&mut self) {
        self.of_body.push(false);
        self.changed();
    }

    /// Whether a body rests.
    pub(super) fn contains(&self, body: usize) -> bool {
        self.of_body[body]
    }

    /// Whether one of the bodies of a pair rests.
    pub(super) fn holds_pair(&self, (a, b): (usize, usize)) -> bool {
        self.of_body[a] || self.of_body[b]
    }

    /// Whether all bodies of an island rest.
    pub(super) fn contains_all(&self, island: &Island) -> bool {
        island.bodies.iter().all(|&body| self.of_body[body])
    }

    /// Whether all that could move rests.
    pub(super) fn is_everything(&mut self, model: &Model) -> bool {
        let rests = |body: &usize| self.of_body[*body] || !model.bodies[*body].moves();
        *self.everything.get_or_insert_with(|| model.movable.iter().all(rests))
    }

    fn changed(&mut self) {
        (self.weight, self.everything) = (None, None);
    }

    /// Bodies in planar motion that may touch others are simulated in space from now on.
    pub(super) fn release_from_plane(
        &mut self,
        model: &mut Model,
        flights: &mut [Option<Box<Flight>>],
        pairs: &[(usize, usize)],
    ) {
        for body in model.planar.meet(pairs) {
            (flights[body], self.of_body[body]) = (None, false);
            self.changed();
        }
    }

    /// Wakes all.
    pub(super) fn wake_all(&mut self) {
        self.of_body.fill(false);
        self.changed();
    }

    /// These pairs, which may touch in a step of `h` (s), without those that a resting body cannot: two such bodies
    /// that do not touch, and one beside a body that is too far away to reach it. So what passes a pile does not wake
    /// it.
    pub(super) fn without_idle_pairs(
        &self,
        model: &Model,
        states: &[BodyState],
        mut pairs: Vec<(usize, usize)>,
        (touching, h): (&BTreeSet<(usize, usize)>, f64),
    ) -> Vec<(usize, usize)> {
        pairs.retain(|&(a, b)| {
            let moves = [a, b].map(|body| model.bodies[body].moves());
            match [self.of_body[a], self.of_body[b]] {
                [false, false] => true,
                [true, true] => touching.contains(&(a, b)),
                _ if moves != [true, true] => true,
                _ => {
                    let reach = travel_of(model, states, a, h) + travel_of(model, states, b, h);
                    let reach = reach + tolerances::touch_distance(model, states, a, b);
                    !contact_set::contacts_of_pair(model, states, a, b, reach).is_empty()
                }
            }
        });
        pairs
    }

    /// Notes whether an island that was stepped rests now.
    pub(super) fn note(&mut self, model: &Model, island: &Island, is_at_rest: bool) {
        let rests = is_at_rest && may_rest(model, island);
        for &body in &island.bodies {
            if self.of_body[body] != rests {
                self.of_body[body] = rests;
                self.changed();
            }
        }
    }

    /// Enters `dt` seconds of rest of all of them in the books.
    pub(super) fn book(&mut self, model: &Model, states: &[BodyState], books: &mut Books, dt: f64) {
        let resting = || model.movable.iter().copied().filter(|&body| self.of_body[body]);
        let weight = *self.weight.get_or_insert_with(|| books.weight_of(model, states, resting()));
        books.borne(weight, dt);
    }
}

/// The groups of bodies of an island that touch each other, by pairs that touch, with the pairs of the island that are
/// of each and of it with bodies that do not move.
pub(super) fn touching_groups(model: &Model, island: &Island, touching: &[(usize, usize)]) -> Vec<Island> {
    let place = |body: usize| island.bodies.binary_search(&body).ok();
    let mut sets = DisjointSets::new(island.bodies.len());
    for &(a, b) in touching {
        if let (Some(a), Some(b)) = (place(a), place(b)) {
            sets.join(a, b);
        }
    }
    let mut slots: Vec<Option<usize>> = vec![None; island.bodies.len()];
    let mut groups: Vec<Island> = Vec::new();
    for (index, &body) in island.bodies.iter().enumerate() {
        let slot = *slots[sets.smallest(index)].get_or_insert_with(|| {
            groups.push(Island::default());
            groups.len() - 1
        });
        groups[slot].bodies.push(body);
    }
    for &(a, b) in &island.pairs {
        let of = [a, b].map(|body| place(body).and_then(|index| slots[sets.smallest(index)]));
        let is_beside = |body: usize| !model.bodies[body].moves();
        match of {
            [Some(x), Some(y)] if x == y => groups[x].pairs.push((a, b)),
            [Some(x), None] if is_beside(b) => groups[x].pairs.push((a, b)),
            [None, Some(y)] if is_beside(a) => groups[y].pairs.push((a, b)),
            _ => {}
        }
    }
    groups
}

/// Whether nothing that acts on an island depends on time.
pub(super) fn may_rest(model: &Model, island: &Island) -> bool {
    let is_driven =
        |body: usize| prescribed::trajectory(model, body).is_some() || moving_surfaces::has_moving_surface(model, body);
    let is_loaded = |&body: &usize| model.is_loaded(body) || moving_surfaces::has_moving_surface(model, body);
    !island.bodies.iter().any(is_loaded) && !island.pairs.iter().any(|&(a, b)| is_driven(a) || is_driven(b))
}
