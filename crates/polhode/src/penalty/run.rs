//! A group of bodies on its way through a longest step: its states, its springs, and what its accounts receive.
//!
//! What error-controlled and fixed steps share: which contacts there are at the start of a step, the booking of a step,
//! and what is measured of it.

use super::contact::{ContactSpring, Evaluated};
use super::events::Peak;
use super::laws::Laws;
use super::system::SpringSystem;
use crate::accounting::books::{Balance, Books};
use crate::collision::contact_set;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances;
use crate::report::event::{Event, EventKind};
use crate::report::springs::SpringReport;
use crate::solve::projection::{Projection, Removal, project_positions, project_velocities};
use crate::tier::core::Core;
use polhode_contact::ContactKinematics;
use polhode_dynamics::{BodyState, DenseStep, System};

/// Bodies that may meet each other, and those that they may meet.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Group {
    /// Those that forces move, ascending.
    pub(super) bodies: Vec<usize>,
    /// Pairs that may touch, ascending.
    pub(super) pairs: Vec<(usize, usize)>,
}

/// A step that was made, from which states within it are evaluated.
#[derive(Debug)]
pub(super) struct Segment {
    pub(super) dense: DenseStep,
    /// The springs that acted.
    pub(super) springs: Vec<ContactSpring>,
}

/// What a group has done in a longest step.
#[derive(Debug)]
pub(super) struct GroupRun {
    pub(super) group: Group,
    pub(super) segments: Vec<Segment>,
    /// States of the bodies of the group at the end.
    pub(super) ends: Vec<BodyState>,
    pub(super) springs: Vec<ContactSpring>,
    pub(super) books: Books,
    pub(super) measured: SpringReport,
    pub(super) events: Vec<Event>,
    /// Penetrations: pair, time (s), separation (m) and its rate (m/s).
    pub(super) separations: Vec<Separation>,
    /// Of bodies back onto their joints.
    pub(super) projections: Vec<JointProjection>,
    /// Steps made.
    pub(super) steps: u64,
    /// Largest error of a step relative to what is allowed; none of fixed steps.
    pub(super) largest_error: Option<f64>,
    /// Length that error control proposes next, s.
    pub(super) proposed_s: f64,
}

/// A projection of bodies back onto their joints.
#[derive(Debug)]
pub(super) struct JointProjection {
    pub(super) t_s: f64,
    pub(super) done: Projection,
    /// Before and after.
    pub(super) balances: (Balance, Balance),
}

/// The separation of a pair at the end of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Separation {
    pub(super) pair: (usize, usize),
    pub(super) t_s: f64,
    /// m and m/s.
    pub(super) distance: f64,
    pub(super) rate: f64,
}

/// A group on its way.
#[derive(Debug)]
pub(super) struct Run<'a> {
    pub(super) core: &'a Core,
    pub(super) laws: &'a Laws,
    /// States of all bodies; those of the group are of time `t`.
    pub(super) states: Vec<BodyState>,
    pub(super) t: f64,
    /// Where the last step began, s.
    before_s: f64,
    pub(super) done: GroupRun,
}

impl<'a> Run<'a> {
    /// A group that begins at the present with these springs.
    pub(super) fn new(
        core: &'a Core,
        laws: &'a Laws,
        (group, springs): (Group, Vec<ContactSpring>),
        states: &[BodyState],
        proposed_s: f64,
    ) -> Self {
        let done = GroupRun {
            group,
            segments: Vec::new(),
            ends: Vec::new(),
            springs,
            books: Books::blank(core.accounts.books.ledger.momentum.about),
            measured: SpringReport::default(),
            events: Vec::new(),
            separations: Vec::new(),
            projections: Vec::new(),
            steps: 0,
            largest_error: None,
            proposed_s,
        };
        Self { core, laws, states: states.to_vec(), t: core.t, before_s: core.t, done }
    }

    /// The end of the run.
    pub(super) fn finished(mut self) -> GroupRun {
        self.done.ends = self.done.group.bodies.iter().map(|&body| self.states[body]).collect();
        self.done
    }

    /// Contacts of the pairs of the group within reach of a step of `h` (s), ascending.
    pub(super) fn near(&self, h: f64) -> Vec<(ContactId, ContactKinematics)> {
        let model = &self.core.model;
        let fall = model.gravity().length() * h * h;
        let mut found = Vec::new();
        for &(a, b) in &self.done.group.pairs {
            let speed =
                tolerances::point_speed(model, &self.states, a) + tolerances::point_speed(model, &self.states, b);
            let reach = REACH * (speed * h + fall) + tolerances::rounding(model, &self.states, a, b);
            let contacts = contact_set::contacts_of_pair(model, &self.states, a, b, reach).into_iter();
            found.extend(contacts.map(|found| (found.id, found.kinematics)));
        }
        found.sort_by_key(|(id, _)| *id);
        found
    }

    /// Elastic energy of the springs in the present states, J.
    pub(super) fn energy(&mut self) -> f64 {
        let (about, t) = (self.done.books.ledger.momentum.about, self.t);
        let Self { core, states, done, .. } = self;
        let mut system =
            SpringSystem { model: &core.model, bodies: &done.group.bodies, springs: &done.springs, about, states };
        let flat = system.pack();
        system.energies(t, &flat).0
    }

    /// A spring in the present states.
    pub(super) fn evaluated(&self, spring: &ContactSpring) -> Option<Evaluated> {
        Evaluated::new(&self.core.model, &self.states, spring.id, spring.friction.is_some())
    }

    /// The spring of a contact that begins in the present states.
    ///
    /// # Errors
    /// When its bodies have no law.
    pub(super) fn begun(
        &self,
        id: ContactId,
        kinematics: &ContactKinematics,
    ) -> Result<ContactSpring, SimulationError> {
        let (model, approach) = (&self.core.model, -kinematics.separation_rate);
        let law = self.laws.of_contact(model, &self.states, (id, &kinematics.geometry), approach)?;
        let at = Evaluated::new(model, &self.states, id, law.friction.is_some());
        let at = at.unwrap_or_else(|| Evaluated::of(*kinematics));
        // It has overlapped since then, at most since the last step began.
        let since = if at.depth > 0.0 && at.rate > 0.0 { self.t - at.depth / at.rate } else { self.t };
        Ok(ContactSpring::begun(id, law, &at, since.max(self.before_s)))
    }

    /// Takes a step to the flat state `end` at `t` (s) as made: books it and measures it.
    pub(super) fn commit(&mut self, flat: &[f64], mut end: Vec<f64>, t: f64) {
        let about = self.done.books.ledger.momentum.about;
        let Self { core, states, done, .. } = self;
        let (model, bodies) = (&core.model, &done.group.bodies);
        let springs = done.springs.clone();
        let mut system = SpringSystem { model, bodies, springs: &springs, about, states };
        let before = system.energies(self.t, flat);
        let before_balance = done.books.balance(model, system.states, bodies).with_energy(before.0);
        system.normalize(&mut end);
        let after = system.energies(t, &end);
        let after_balance = done.books.balance(model, system.states, bodies).with_energy(after.0);
        let mut received = system.received(&end);
        received.friction_j -= after.1 - before.1;
        let held: Vec<ContactSpring> = (0..springs.len()).map(|index| system.spring(&end, index)).collect();
        done.books.smooth_stage(before_balance, after_balance, received);
        done.springs = held;
        done.steps += 1;
        let h = t - self.t;
        self.before_s = self.t;
        self.t = t;
        self.project(after_balance);
        self.measure(h);
    }

    /// Puts the bodies that joints hold back onto them at the end of a step: what the integrator has let them drift.
    /// `before` is their balance.
    fn project(&mut self, before: Balance) {
        let model = &self.core.model;
        if !model.joints.has_rows() || model.joints.held_among(&self.done.group.bodies).is_empty() {
            return;
        }
        let bodies = self.done.group.bodies.clone();
        let kept = self.states.clone();
        let projected = project_positions(model, &mut self.states, &bodies, &[]).and_then(|mut done| {
            let none = (&[][..], &[][..], &[][..]);
            let removed = project_velocities(model, &mut self.states, &bodies, none, Removal::OfDrift)?;
            done.work_j += removed.work_j;
            Ok(done)
        });
        // A state that is not finite is refused where it is observed.
        let Ok(done) = projected else {
            self.states = kept;
            return;
        };
        let energy = self.energy();
        let after = self.done.books.balance(&self.core.model, &self.states, &bodies).with_energy(energy);
        self.done.projections.push(JointProjection { t_s: self.t, done, balances: (before, after) });
    }

    /// Measures the springs at the end of a step of `h` (s).
    fn measure(&mut self, h: f64) {
        let shared = self.shared_bodies();
        for index in 0..self.done.springs.len() {
            let spring = self.done.springs[index];
            let Some(at) = self.evaluated(&spring) else { continue };
            let force = spring.normal_force(&at);
            self.done.measured.note_step(&spring, at.depth.max(spring.passage.deepest), h);
            let passage = &mut self.done.springs[index].passage;
            passage.deepest = passage.deepest.max(at.depth);
            passage.hardest = passage.hardest.max(force);
            passage.alone &= !shared.contains(&spring.id.a) && !shared.contains(&spring.id.b);
            let pair = (spring.id.a, spring.id.b);
            self.done.separations.push(Separation { pair, t_s: self.t, distance: -at.depth, rate: -at.rate });
        }
    }

    /// Movable bodies with several springs.
    fn shared_bodies(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.done.springs.iter().flat_map(|spring| [spring.id.a, spring.id.b]).collect();
        all.retain(|&body| self.core.model.bodies[body].rigid.is_some());
        all.sort_unstable();
        let mut shared: Vec<usize> = all.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]).collect();
        shared.dedup();
        shared
    }

    /// Adds a spring, and its event.
    pub(super) fn insert(&mut self, spring: &ContactSpring) {
        if let Err(place) = self.done.springs.binary_search_by_key(&spring.id, |known| known.id) {
            self.done.springs.insert(place, *spring);
            self.note_event(EventKind::ContactBegin, spring);
            // Features that come into the place of others may overlap deeply at once.
            let (pair, distance) = ((spring.id.a, spring.id.b), -spring.passage.deepest);
            self.done.separations.push(Separation { pair, t_s: self.t, distance, rate: -spring.passage.approach });
        }
    }

    /// Removes a spring whose contact has ended at `t` (s) at a speed of separation (m/s), and records what it did.
    pub(super) fn remove(&mut self, id: ContactId, t: f64, separation: f64) {
        let Ok(place) = self.done.springs.binary_search_by_key(&id, |known| known.id) else { return };
        let spring = self.done.springs.remove(place);
        self.done.measured.note_impact(spring.ended(t, separation));
        self.note_event(EventKind::ContactEnd, &spring);
    }

    /// The same of a contact that ends at the present.
    pub(super) fn remove_now(&mut self, id: ContactId) {
        let rate = Evaluated::new(&self.core.model, &self.states, id, false).map_or(0.0, |at| at.rate);
        self.remove(id, self.t, -rate);
    }

    /// Changes a spring.
    pub(super) fn with_spring(&mut self, id: ContactId, change: impl FnOnce(&mut ContactSpring)) {
        if let Some(spring) = self.done.springs.iter_mut().find(|spring| spring.id == id) {
            change(spring);
        }
    }

    /// Takes in the greatest overlaps and forces within the step that is to be booked.
    pub(super) fn note_peaks(&mut self, peaks: &[Peak]) {
        for (spring, peak) in self.done.springs.iter_mut().zip(peaks) {
            let passage = &mut spring.passage;
            passage.hardest = passage.hardest.max(peak.force);
            if peak.depth > passage.deepest {
                passage.deepest = peak.depth;
                let pair = (spring.id.a, spring.id.b);
                self.done.separations.push(Separation { pair, t_s: self.t, distance: -peak.depth, rate: 0.0 });
            }
        }
    }

    pub(super) fn note_event(&mut self, kind: EventKind, spring: &ContactSpring) {
        let event = Event::new(self.t, kind, BodyId::new(spring.id.a));
        let body_b = Some(BodyId::new(spring.id.b));
        let at = self.evaluated(spring);
        let (point, normal) = at.map_or((event.point, event.normal), |at| (at.point, at.kinematics.geometry.normal));
        self.done.events.push(Event { body_b, point, normal, ..event });
    }
}

/// How much farther than bodies move at their present speeds contacts are looked for (1 to 4): springs accelerate them.
const REACH: f64 = 2.0;
