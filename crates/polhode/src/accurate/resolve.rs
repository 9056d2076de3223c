//! Everything that happens at one instant.
//!
//! Stages: find what touches; strike what approaches; sum up bounces too small to see; decide which contacts hold;
//! put held contacts exactly together; give every body its mode until the next event; report.

use super::engine::{Engine, Mode};
use super::hold::Forces;
use super::projection;
use crate::SimulationError;
use crate::event::{Event, EventKind};
use crate::interaction::contact_set::{ContactId, Hold, Touch};
use crate::interaction::groups::{Group, groups};
use crate::interaction::impact::{impulse_event, strike, support};
use polhode_response::impact::{ImpactOutcome, ImpactSettings, ImpactStatus};
use polhode_spatial::DVec3;
use std::collections::BTreeSet;

/// A contact whose relative speed is below this fraction of the speeds of its bodies neither approaches nor parts:
/// some thousand roundings.
const SUSTAINED_RELATIVE: f64 = 1e-12;

/// The same, as a fraction of the largest speed of the run: what rounding leaves of velocities that cancelled.
const SUSTAINED_SCENE_RELATIVE: f64 = 1e-14;

/// Bodies in equilibrium slower than this fraction of the largest speed of the run are at rest: what rounding and the
/// projection of velocities leave after the last impact.
const STOPPED_RELATIVE: f64 = 1e-13;

/// Bounces up to this many times the distance that counts as touch are summed up: lower ones could not be told from
/// touch while they last.
const INVISIBLE_HEIGHT: f64 = 64.0;

/// A contact whose force is below this fraction of the group's largest carries none.
const DEPARTED_FORCE: f64 = 1e-6;

/// The same as a fraction of the weight and the forces on a body of the group: where all contacts of a group let go at
/// once, the largest of their forces is a rounding too.
const DEPARTED_LOAD: f64 = 1e-9;

/// Contacts that open are told from those that hold at this fraction of the threshold by which the location of
/// contact changes found them, so that both sides of a mirror-symmetric scene open together.
const OPENING_FRACTION: f64 = 0.5;

impl Engine {
    /// Resolves the present instant; `near` are pairs that may have come to touch besides those that did.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    pub(super) fn resolve(&mut self, near: &[(usize, usize)]) -> Result<(), SimulationError> {
        let held_before = self.held_pairs();
        self.detect(near);
        self.strike_approaching()?;
        for group in self.groups_in_motion() {
            self.decide_holds(&group)?;
        }
        self.wake_coupled();
        self.release_free_bodies();
        self.report_pairs(&held_before);
        Ok(())
    }

    /// Finds the contacts of all pairs that touched or are near, except between bodies that have not moved.
    fn detect(&mut self, near: &[(usize, usize)]) {
        let still = |body: usize| matches!(self.modes[body], Mode::Rest | Mode::Fixed);
        let mut pairs: BTreeSet<_> = near.iter().copied().collect();
        pairs.extend(self.touches.iter().map(|touch| (touch.id.a, touch.id.b)));
        let mut found = Vec::with_capacity(self.touches.len());
        for (a, b) in pairs {
            if still(a) && still(b) {
                found.extend(self.touches.iter().filter(|touch| (touch.id.a, touch.id.b) == (a, b)).copied());
                continue;
            }
            let reach = self.world.touch_distance(&self.states, a, b);
            let mut contacts = self.world.contacts_of_pair(&self.states, a, b, reach);
            for touch in &mut contacts {
                if let Ok(index) = self.touches.binary_search_by(|known| known.id.cmp(&touch.id)) {
                    touch.hold = self.touches[index].hold;
                    touch.known = true;
                }
            }
            found.extend(contacts);
        }
        found.sort_by_key(|touch| touch.id);
        self.touches = found;
        // A point beside its features overlaps nothing.
        let on_features = self.touches.iter().filter(|touch| touch.kinematics.geometry.margin >= 0.0);
        let deepest = on_features.fold(0.0f64, |depth, touch| depth.max(-touch.kinematics.geometry.separation));
        self.certificate.max_penetration_m = self.certificate.max_penetration_m.max(deepest);
    }

    /// Strikes every group in which a contact approaches.
    fn strike_approaching(&mut self) -> Result<(), SimulationError> {
        let all = self.touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
        for group in groups(&self.world, all) {
            let approaches = |&i: &usize| {
                let touch = &self.touches[i];
                touch.kinematics.separation_rate < -self.sustained_speed(touch)
            };
            if group.contacts.iter().any(approaches) {
                self.strike_group(&group)?;
            }
        }
        self.refresh_kinematics();
        Ok(())
    }

    fn strike_group(&mut self, group: &Group) -> Result<(), SimulationError> {
        for &body in &group.bodies {
            self.land(body);
            if matches!(self.modes[body], Mode::Rest) {
                self.woken.insert(body);
            }
            self.modes[body] = Mode::Constrained;
        }
        let law = self.settings.impact;
        let settings = ImpactSettings::default();
        let outcome = strike(&self.world, &mut self.states, group, &self.touches, law, &settings, &mut self.solver)
            .map_err(|source| self.response_error(source))?;
        self.certificate.max_residual = self.certificate.max_residual.max(outcome.residual);
        let impulses = group.contacts.iter().zip(&outcome.impulses);
        let impulses = impulses.map(|(&i, &p)| (self.touches[i].id, &self.touches[i].kinematics.geometry, p));
        let given = support(&self.world, self.books.ledger.momentum.about, impulses);
        self.books.impact(outcome.energy_change, given);
        for application in &outcome.applications {
            let touch = self.touches[group.contacts[application.row]];
            self.report_contact(&impulse_event(self.t, &touch, application), touch.id);
        }
        self.warn_about_impact(&outcome);
        if outcome.status == ImpactStatus::NotSolved {
            return Err(SimulationError::ContactSolve { t: self.t, residual: outcome.residual });
        }
        Ok(())
    }

    fn warn_about_impact(&mut self, outcome: &ImpactOutcome) {
        let what = match outcome.status {
            ImpactStatus::StoppedAtThreshold => {
                "an impact by propagation does not end: stopped when every speed of approach was below the threshold"
            }
            ImpactStatus::LimitReached => {
                "an impact reached its limit of applications: the rest was resolved inelastically"
            }
            ImpactStatus::RestitutionLowered => {
                "an impact between contacts of different restitution would have gained energy: the smallest was used"
            }
            ImpactStatus::NoApproach | ImpactStatus::Separated | ImpactStatus::NotSolved => return,
        };
        self.warn(what);
    }

    /// Groups with a body that is not at rest.
    fn groups_in_motion(&self) -> Vec<Group> {
        let all = self.touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
        let mut moving = groups(&self.world, all);
        moving.retain(|group| group.bodies.iter().any(|&body| !matches!(self.modes[body], Mode::Rest)));
        moving
    }

    /// Decides which contacts of a group hold until the next event, and whether its bodies rest.
    fn decide_holds(&mut self, group: &Group) -> Result<(), SimulationError> {
        let mut candidates: Vec<usize> =
            group.contacts.iter().copied().filter(|&i| self.is_sustained(&self.touches[i])).collect();
        let mut forces = self.forces(group, &candidates)?;
        // A contact may come back only because the one below it is held, so those found hold before others are judged.
        loop {
            let bounces = self.invisible_bounces(group, &candidates, &forces);
            if bounces.is_empty() {
                break;
            }
            candidates.extend(bounces);
            candidates.sort_unstable();
            self.end_bounces(group, &candidates)?;
            forces = self.forces(group, &candidates)?;
        }
        for &i in &group.contacts {
            let hold = match candidates.binary_search(&i) {
                Ok(row) => self.hold_of(&self.touches[i], &forces, row),
                Err(_) => Hold::Open,
            };
            self.set_hold(i, hold);
        }
        self.settle(group, &candidates, &forces)
    }

    fn forces(&mut self, group: &Group, candidates: &[usize]) -> Result<Forces, SimulationError> {
        let members: Vec<Touch> = candidates.iter().map(|&i| self.touches[i]).collect();
        let forces = Forces::solve(&self.world, self.t, &self.states, &group.bodies, &members, &mut self.solver)
            .map_err(|source| self.response_error(source))?;
        self.note_solve(&forces.solution.report)?;
        Ok(forces)
    }

    /// Whether a candidate holds: it carries force, or it neither opens nor has been open.
    fn hold_of(&self, touch: &Touch, forces: &Forces, row: usize) -> Hold {
        let opens = forces.solution.residual_accelerations[row] > OPENING_FRACTION * forces.opening;
        let was_open = touch.known && touch.hold == Hold::Open;
        // The force of a contact that departs has fallen to zero; one that still carries load was found by mistake.
        let largest = forces.solution.forces.iter().fold(0.0f64, |most, &f| most.max(f));
        let departed = (DEPARTED_FORCE * largest).max(DEPARTED_LOAD * forces.load);
        if self.departing.contains(&touch.id) && forces.solution.forces[row] <= departed {
            return Hold::Open;
        }
        if forces.solution.forces[row] > 0.0 || !(opens || was_open) { Hold::Held } else { Hold::Open }
    }

    /// Reports an event at a contact point; one that stands for its mirror image too is reported at both.
    fn report_contact(&mut self, event: &Event, id: ContactId) {
        let Some(aside) = self.world.mirrored(&self.states, id) else {
            self.events.push(*event);
            return;
        };
        let (impulse, energy_change_j) = (0.5 * event.impulse, 0.5 * event.energy_change_j);
        for point in [event.point - aside, event.point + aside] {
            self.events.push(Event { point, impulse, energy_change_j, ..*event });
        }
    }

    fn set_hold(&mut self, i: usize, hold: Hold) {
        let touch = self.touches[i];
        if touch.known && touch.hold == Hold::Held && hold == Hold::Open {
            self.report_contact(&contact_event(self.t, EventKind::Detach, &touch), touch.id);
        }
        self.touches[i].hold = hold;
        self.touches[i].known = true;
    }

    /// Contacts that part so slowly that they would come back without ever leaving touch: their endless sequence of
    /// bounces is summed up. A contact with restitution 1 never ends bouncing and is not among them.
    fn invisible_bounces(&mut self, group: &Group, candidates: &[usize], forces: &Forces) -> Vec<usize> {
        let mut bounces = Vec::new();
        for &i in group.contacts.iter().filter(|i| candidates.binary_search(i).is_err()) {
            let touch = self.touches[i];
            let restitution = self.world.scene.pair_material(touch.id.a, touch.id.b).restitution();
            let speed = touch.kinematics.separation_rate;
            let acceleration = forces.relative_acceleration(&self.states, &touch);
            if restitution >= 1.0 || speed <= 0.0 || acceleration >= 0.0 {
                continue;
            }
            let height = speed * speed / (-2.0 * acceleration);
            let touch_distance = self.world.touch_distance(&self.states, touch.id.a, touch.id.b);
            if height <= INVISIBLE_HEIGHT * touch_distance {
                // The bounces to come last 2w/a (1 + e + e^2 + ...) together (thesis 3.3).
                let rest = self.t + 2.0 * speed / (-acceleration * (1.0 - restitution));
                for body in [touch.id.a, touch.id.b] {
                    let known = self.rest_times.entry(body).or_insert(rest);
                    *known = known.max(rest);
                }
                bounces.push(i);
            }
        }
        bounces
    }

    /// Ends the bounces that have been summed up: all candidates lose what is left of their relative velocity.
    fn end_bounces(&mut self, group: &Group, candidates: &[usize]) -> Result<(), SimulationError> {
        self.ground(group);
        let ids: Vec<_> = candidates.iter().map(|&i| self.touches[i].id).collect();
        let before = self.books.balance(&self.world, &self.states, &group.bodies);
        projection::project_velocities(&self.world, &mut self.states, &group.bodies, &ids)
            .map_err(|source| self.response_error(source))?;
        let after = self.books.balance(&self.world, &self.states, &group.bodies);
        self.books.rest(before, after);
        self.refresh_kinematics();
        Ok(())
    }

    /// Puts held contacts exactly together and gives their bodies their mode: at rest, or constrained.
    fn settle(&mut self, group: &Group, candidates: &[usize], forces: &Forces) -> Result<(), SimulationError> {
        let members: Vec<Touch> = candidates.iter().map(|&i| self.touches[i]).collect();
        let balanced = forces.balanced_bodies(&self.world, &self.states, &members);
        let held = group.contacts.iter().filter(|&&i| self.touches[i].hold == Hold::Held);
        let components = groups(&self.world, held.map(|&i| (i, self.touches[i].id.a, self.touches[i].id.b)));
        for component in components {
            self.ground(&component);
            let ids: Vec<_> = component.contacts.iter().map(|&i| self.touches[i].id).collect();
            let touching = self.with_overlaps(&ids, &component);
            let before = self.books.balance(&self.world, &self.states, &component.bodies);
            projection::project_positions(&self.world, &mut self.states, &component.bodies, &touching)
                .and_then(|()| projection::project_velocities(&self.world, &mut self.states, &component.bodies, &ids))
                .map_err(|source| self.response_error(source))?;
            let after = self.books.balance(&self.world, &self.states, &component.bodies);
            self.books.projection(before, after);
            let rests = component
                .bodies
                .iter()
                .all(|&body| balanced.contains(&body) && self.is_slow(body) && self.forces_last(body));
            for &body in &component.bodies {
                if rests { self.stop(body) } else { self.modes[body] = Mode::Constrained }
            }
        }
        self.refresh_kinematics();
        Ok(())
    }

    /// The held contacts of a component, and those of its contacts that overlap though they part: they are moved out
    /// of each other too.
    fn with_overlaps(&self, held: &[ContactId], component: &Group) -> Vec<ContactId> {
        let within = |body: usize| component.bodies.binary_search(&body).is_ok() || !self.world.bodies[body].moves();
        let overlaps = self.touches.iter().filter(|touch| {
            touch.hold == Hold::Open
                && touch.kinematics.geometry.separation < -self.world.rounding(&self.states, touch.id.a, touch.id.b)
                && within(touch.id.a)
                && within(touch.id.b)
        });
        held.iter().copied().chain(overlaps.map(|touch| touch.id)).collect()
    }

    /// Ends the flights of a group's bodies.
    fn ground(&mut self, group: &Group) {
        for &body in &group.bodies {
            self.land(body);
            if matches!(self.modes[body], Mode::Flight(_) | Mode::Stepped) {
                self.modes[body] = Mode::Constrained;
                self.stepper.interrupt();
            }
        }
    }

    /// Sets a body in equilibrium exactly to rest; what kinetic energy it had left is booked.
    fn stop(&mut self, body: usize) {
        let before = self.books.balance(&self.world, &self.states, &[body]);
        self.states[body].linear_velocity = DVec3::ZERO;
        self.states[body].angular_momentum = DVec3::ZERO;
        self.books.rest(before, self.books.balance(&self.world, &self.states, &[body]));
        let rested = matches!(self.modes[body], Mode::Rest);
        self.modes[body] = Mode::Rest;
        self.woken.remove(&body);
        let t = self.rest_times.remove(&body).unwrap_or(self.t);
        if !rested && self.t > 0.0 {
            self.events.push(body_event(t, EventKind::Rest, body, self.states[body].pose.translation));
        }
    }

    /// Bodies whose last held contact has gone fly; those woken from rest are reported.
    fn release_free_bodies(&mut self) {
        let mut held = vec![false; self.world.bodies.len()];
        for touch in self.touches.iter().filter(|touch| touch.hold == Hold::Held) {
            held[touch.id.a] = true;
            held[touch.id.b] = true;
        }
        for body in 0..self.world.bodies.len() {
            if matches!(self.modes[body], Mode::Constrained | Mode::Rest) && !held[body] {
                self.take_off(body);
            }
        }
        for body in std::mem::take(&mut self.woken) {
            self.events.push(body_event(self.t, EventKind::Wake, body, self.states[body].pose.translation));
        }
        self.rest_times.clear();
    }

    /// Pairs that are held together.
    fn held_pairs(&self) -> BTreeSet<(usize, usize)> {
        let held = self.touches.iter().filter(|touch| touch.hold == Hold::Held);
        held.map(|touch| (touch.id.a, touch.id.b)).collect()
    }

    /// Reports pairs that have begun or ceased to be held together.
    fn report_pairs(&mut self, before: &BTreeSet<(usize, usize)>) {
        if self.t == 0.0 {
            return;
        }
        let after = self.held_pairs();
        for &(a, b) in before.difference(&after) {
            let mut event = body_event(self.t, EventKind::ContactEnd, a, self.states[a].pose.translation);
            event.body_b = Some(b);
            if let Some(touch) = self.touches.iter().find(|touch| (touch.id.a, touch.id.b) == (a, b)) {
                event = contact_event(self.t, EventKind::ContactEnd, touch);
            }
            self.events.push(event);
        }
        for pair in after.difference(before) {
            if let Some(touch) = self.touches.iter().find(|touch| (touch.id.a, touch.id.b) == *pair) {
                self.events.push(contact_event(self.t, EventKind::ContactBegin, touch));
            }
        }
    }

    /// Relative speed below which a contact neither approaches nor parts, m/s.
    fn sustained_speed(&self, touch: &Touch) -> f64 {
        let speed = |body: usize| self.speed(body);
        SUSTAINED_RELATIVE * (speed(touch.id.a) + speed(touch.id.b)) + SUSTAINED_SCENE_RELATIVE * self.speed_scale
    }

    pub(super) fn is_sustained(&self, touch: &Touch) -> bool {
        touch.kinematics.separation_rate.abs() <= self.sustained_speed(touch)
    }

    /// Whether the forces on a body stay as they are while it rests: none changes with time, and the bodies that forces
    /// couple it to rest too or are about to.
    fn forces_last(&self, body: usize) -> bool {
        let couplings = self.world.couplings.iter().filter(|together| together.contains(&body));
        let still = |&other: &usize| matches!(self.modes[other], Mode::Rest) || self.is_slow(other);
        !self.world.is_driven(body) && couplings.flatten().all(still)
    }

    /// Wakes what rests and is coupled by a force to a body that moves, and what rests with it.
    fn wake_coupled(&mut self) {
        let rests = |modes: &[Mode], body: usize| matches!(modes[body], Mode::Rest);
        loop {
            let mut wake = BTreeSet::new();
            for together in &self.world.couplings {
                if together.iter().any(|&body| !rests(&self.modes, body)) {
                    wake.extend(together.iter().copied().filter(|&body| rests(&self.modes, body)));
                }
            }
            for touch in self.touches.iter().filter(|touch| touch.hold == Hold::Held) {
                for (body, other) in [(touch.id.a, touch.id.b), (touch.id.b, touch.id.a)] {
                    if matches!(self.modes[other], Mode::Constrained) && rests(&self.modes, body) {
                        wake.insert(body);
                    }
                }
            }
            if wake.is_empty() {
                return;
            }
            for body in wake {
                self.modes[body] = Mode::Constrained;
                self.woken.insert(body);
            }
        }
    }

    fn is_slow(&self, body: usize) -> bool {
        self.speed(body) <= STOPPED_RELATIVE * self.speed_scale
    }

    /// Largest speed of any point of a body, m/s (bounded by its size).
    pub(super) fn speed(&self, body: usize) -> f64 {
        let velocity = self.world.velocity(body, &self.states[body]);
        velocity.linear.length() + velocity.angular.length() * self.world.bodies[body].size
    }
}

fn contact_event(t: f64, kind: EventKind, touch: &Touch) -> Event {
    Event {
        t,
        kind,
        body_a: touch.id.a,
        body_b: Some(touch.id.b),
        point: touch.kinematics.geometry.point,
        normal: touch.kinematics.geometry.normal,
        impulse: 0.0,
        energy_change_j: 0.0,
    }
}

fn body_event(t: f64, kind: EventKind, body: usize, point: DVec3) -> Event {
    Event { t, kind, body_a: body, body_b: None, point, normal: DVec3::ZERO, impulse: 0.0, energy_change_j: 0.0 }
}
