//! Resolution of one instant: impacts, contact breaks, resting contacts.
//!
//! Stages: find the touching contacts; apply impacts to those that approach; end sequences of bounces too small to
//! resolve; determine the active set (which contacts hold); project the held contacts onto zero separation; give every
//! body its mode until the next event; report. Only the bodies of the instant (`instant.rs`) take part.

use super::hold::{Forces, FoundMode};
use super::instant::Instant;
use super::motions::{Mode, Motions};
use super::schedule::Schedule;
use crate::collision::contact_modes::ContactModes;
use crate::collision::friction_mode::{FrictionMode, Slide};
use crate::collision::passing::SUSTAINED_RELATIVE;
use crate::collision::touch::{FoundContact, Hold, Pair, Touch};
use crate::collision::{contact_kinematics, contact_set, covered_borders, friction};
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::ContactId;
use crate::joints::breaking;
use crate::model::{prescribed, reported, tolerances};
use crate::report::event::{Event, EventKind};
use crate::rows::groups::{Group, groups};
use crate::scene::ImpactLaw;
use crate::solve::frictional_impact::Restitution;
use crate::solve::impact::{Struck, impulse_event, raised_energy, strike_group};
use crate::solve::open_loads;
use crate::solve::overlap::is_excess;
use crate::solve::projection::{self, Projected};
use crate::tier::core::Core;
use polhode_response::impact::{ImpactSettings, ImpactStatus};
use polhode_spatial::DVec3;
use std::collections::BTreeSet;

/// The same, as a fraction of the largest speed that the bodies of the instant have had: the rounding error of
/// velocities that cancelled.
const SUSTAINED_SCENE_RELATIVE: f64 = 1e-14;

/// Bodies in equilibrium slower than this fraction of the largest speed that the bodies of the instant have had are at
/// rest: rounding and the projection of velocities leave such speeds after the last impact.
const STOPPED_RELATIVE: f64 = 1e-13;

/// Rounding error of a slip as a fraction of the largest speed that the bodies of the instant have had (1e-14 to
/// 1e-11): that of velocities that cancelled, over some thousand steps.
const SLIP_NOISE: f64 = 1e-13;

/// Component of a slip across its direction at the start of the step that counts as rounding, as a fraction of the
/// speed of a fall by the body's own size (1e-13 to 1e-11). In a slow slip that lasts long, the rounding of forces that
/// cancel adds up to such a component; friction would oppose it at the rate `mu g / |u_T|`, which no step could follow.
const GATHERED_SLIP: f64 = 1e-12;

/// What is counted where friction lowers the restitution of an impact.
const LOWERED: &str = "restitution of impacts with friction was lowered: the full one would give back too much work";

/// What is said of contacts that slide in different directions with forces that are not unique, before the names.
const LEAST_NORM: &str =
    "normal forces of contacts that slide are not unique, and those of least norm are taken: the motion of";

/// What is said of contacts that propagation strikes one after the other, before the names.
const STRUCK_IN_ORDER: &str = "contacts that approach at one instant are struck one after the other: the motion of";

/// The warning of bearings with friction in a mechanism that has more supports than it needs, before the names.
const OPEN_LOADS: &str =
    "loads of bearings with friction are not unique, and those of least norm are taken: the motion of";

/// An impulse below this fraction of the largest impulse of an impact is rounding error. It is not reported as an
/// event.
const NEGLIGIBLE_IMPULSE: f64 = 1e-12;

/// Most impacts that ending bounces may cause at one instant. Each is weaker than the one before.
const MOST_IMPACTS_OF_BOUNCES: usize = 32;

/// A contact force below this fraction of the largest force of the group counts as zero.
const DEPARTED_FORCE: f64 = 1e-6;

/// The same as a fraction of the weight and the forces on a body of the group: if all contacts of a group break at
/// once, their largest force is only rounding error too.
const DEPARTED_LOAD: f64 = 1e-9;

/// A contact breaks if its acceleration exceeds this fraction of the threshold that the location of contact changes
/// uses. The fraction is below one so that both sides of a mirror-symmetric scene break contact together.
const OPENING_FRACTION: f64 = 0.5;

/// The resolution of an instant: what it reads and changes.
#[derive(Debug)]
pub(super) struct Resolution<'a> {
    pub(super) core: &'a mut Core,
    pub(super) motions: &'a mut Motions,
    pub(super) schedule: &'a Schedule,
    pub(super) instant: &'a mut Instant,
}

impl Resolution<'_> {
    /// Resolves an instant.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    pub(super) fn resolve(&mut self) -> Result<(), SimulationError> {
        self.let_go_at_ends_of_tracks()?;
        let held_before = self.instant.held_pairs();
        let released = self.instant.release_from_plane(&mut self.core.model, &self.motions.states);
        let passing = self.detect(&released);
        self.lift_onto_faces(&passing);
        self.strike_approaching()?;
        let broken: Vec<usize> = std::mem::take(&mut self.instant.change.breaking).into_iter().collect();
        self.core.break_joints(self.instant.t, &self.motions.states, &broken)?;
        for group in self.groups_in_motion() {
            self.decide_holds(&group)?;
        }
        self.remove_overlaps()?;
        self.wake_coupled();
        self.release_free_bodies();
        self.report_pairs(&held_before);
        Ok(())
    }

    /// Finds the contacts of all pairs that touched or are near each other, except between bodies that have not moved
    /// and are not `released` from their plane. Returns the pairs that pass each other along a face, ascending.
    fn detect(&mut self, released: &BTreeSet<usize>) -> Vec<(usize, usize)> {
        let still = |body: usize| matches!(self.motions.tracks[body].mode, Mode::Rest | Mode::Fixed);
        let mut found = Vec::with_capacity(self.instant.touches.len());
        let mut passing = Vec::new();
        for &(a, b) in &self.instant.pairs {
            if still(a) && still(b) && !released.contains(&a) && !released.contains(&b) {
                found.extend(self.instant.touches.iter().filter(|touch| (touch.id.a, touch.id.b) == (a, b)).copied());
                continue;
            }
            let reach = tolerances::touch_distance(&self.core.model, &self.motions.states, a, b);
            let Pair { separation, contacts, is_passing } =
                contact_set::pair(&self.core.model, &self.motions.states, a, b, reach);
            // The overlap of two bodies may be larger than the penetration of each contact.
            let rate = contacts.iter().fold(0.0, |rate, contact| contact.kinematics.separation_rate.min(rate));
            self.core.note_separation(self.instant.t, &self.motions.states, (a, b), (separation, rate));
            if is_passing {
                passing.push((a, b));
            }
            found.extend(contacts.into_iter().map(|contact| {
                let FoundContact { id, kinematics } = contact;
                match self.instant.touches.binary_search_by(|known| known.id.cmp(&id)) {
                    Ok(index) => Touch { id, kinematics, known: true, is_defined: true, ..self.instant.touches[index] },
                    Err(_) => Touch::from(contact),
                }
            }));
        }
        found.sort_by_key(|touch| touch.id);
        covered_borders::remove_covered_borders(&self.core.model, &self.motions.states, &mut found);
        self.instant.touches = found;
        // A contact point outside its features measures no penetration, nor does one with the plane of a face that the
        // bodies are about to pass onto.
        let measures = |touch: &&Touch| {
            touch.kinematics.geometry.margin >= 0.0 && passing.binary_search(&(touch.id.a, touch.id.b)).is_err()
        };
        for touch in self.instant.touches.iter().filter(measures) {
            self.core.note_contact(self.instant.t, &self.motions.states, (touch.id.a, touch.id.b), &touch.kinematics);
        }
        passing
    }

    /// Applies the impact law to every group in which a contact approaches.
    fn strike_approaching(&mut self) -> Result<(), SimulationError> {
        for group in groups(&self.core.model, self.instant.numbered()) {
            if group.contacts.iter().any(|&i| self.approaches(&self.instant.touches[i])) {
                self.strike_group(&group)?;
            }
        }
        self.refresh_kinematics();
        Ok(())
    }

    fn strike_group(&mut self, group: &Group) -> Result<(), SimulationError> {
        for &body in &group.bodies {
            self.motions.book_flight(self.core, body, self.instant.t);
            if matches!(self.motions.tracks[body].mode, Mode::Rest) {
                self.instant.woken.insert(body);
            }
            self.motions.tracks[body].mode = Mode::Constrained;
        }
        let law = self.core.settings.impact;
        let approaching = group.contacts.iter().filter(|&&i| self.approaches(&self.instant.touches[i])).count();
        if law == ImpactLaw::Propagation && approaching > 1 {
            let names = reported::names_of(&self.core.model, &group.bodies);
            self.core.accounts.choose(self.instant.t, format!("{STRUCK_IN_ORDER} {names} depends on their order"));
        }
        let settings = ImpactSettings::default();
        let struck = strike_group(
            &self.core.model,
            &mut self.motions.states,
            group,
            &self.instant.touches,
            law,
            &settings,
            &mut self.core.memory,
        )
        .map_err(|source| {
            SimulationError::of_response(self.instant.t, source).among(&self.core.model, &group.bodies)
        })?;
        let outcome = &struck.outcome;
        if outcome.status == ImpactStatus::NotSolved {
            let unsolved = (self.instant.t, outcome.residual);
            return Err(SimulationError::not_solved(&self.core.model, unsolved, &group.bodies));
        }
        self.book_struck(&group.contacts, &struck, EventKind::Impact);
        self.core.accounts.note_impact(&self.core.model, self.instant.t, law, &group.bodies, outcome);
        if outcome.status == ImpactStatus::LimitReached {
            let names = reported::names_of(&self.core.model, &group.bodies);
            let what = format!("an impact of {names} by {} was not resolved within its limit", law.name());
            self.core.accounts.note_unsolved(self.instant.t, what);
        }
        Ok(())
    }

    /// Books the impulses of some contacts of an instant, and reports each as an event of this kind.
    pub(super) fn book_struck(&mut self, contacts: &[usize], struck: &Struck, kind: EventKind) {
        let outcome = &struck.outcome;
        let members: Vec<Touch> = contacts.iter().map(|&i| self.instant.touches[i]).collect();
        let work = struck.work(&self.core.model, &self.motions.states, &members);
        let about = self.core.accounts.books.ledger.momentum.about;
        let given = struck.support(&self.core.model, about, &members);
        self.core.accounts.books.impact((outcome.energy_change, struck.friction_j), given, work);
        self.core.note_friction(self.instant.t, struck.violation);
        self.instant.change.breaking.extend(breaking::broken_by(&self.core.model, &struck.reactions.bilaterals));
        let largest = outcome.applications.iter().fold(0.0, |most: f64, one| most.max(one.impulse.abs()));
        let is_event = |impulse: f64| impulse.abs() > NEGLIGIBLE_IMPULSE * largest;
        let applications = outcome.applications.iter().zip(&struck.constraints);
        for (application, constraint) in applications.filter(|(application, _)| is_event(application.impulse)) {
            // The impulse of a pivot is not a contact event. It is booked in the momentum ledger.
            let Some(id) = constraint.and_then(|constraint| constraint.contact()) else { continue };
            let Ok(index) = self.instant.touches.binary_search_by(|touch| touch.id.cmp(&id)) else { continue };
            let touch = self.instant.touches[index];
            self.core.accounts.add_contact_event(
                &self.core.model,
                &self.motions.states,
                impulse_event(self.instant.t, kind, &touch, application),
                touch.id,
            );
        }
        match struck.restitution {
            Restitution::Full => {}
            Restitution::Lowered => self.core.accounts.tolerate(self.instant.t, LOWERED),
            Restitution::RaisesEnergy => {
                let law = self.core.model.scene.method().restitution_law.unwrap_or_default().name();
                self.core.accounts.warn(self.instant.t, raised_energy(law));
            }
        }
    }

    /// Groups with a body that is not at rest or that touches a moving kinematic body.
    fn groups_in_motion(&self) -> Vec<Group> {
        let mut moving = groups(&self.core.model, self.instant.numbered());
        moving.retain(|group| {
            let ids: Vec<ContactId> = group.contacts.iter().map(|&i| self.instant.touches[i].id).collect();
            group.bodies.iter().any(|&body| !matches!(self.motions.tracks[body].mode, Mode::Rest))
                || !allow_rest(self.core, self.instant.t, &ids)
        });
        moving
    }

    /// Determines the active contacts of a group until the next event, and whether its bodies rest.
    fn decide_holds(&mut self, group: &Group) -> Result<(), SimulationError> {
        let (mut candidates, mut forces, mut has_ended) = self.candidates_after_jams(group)?;
        let mut impacts = 0;
        // Ending the bounces of one contact may make other contacts approach.
        while has_ended && group.contacts.iter().any(|&i| self.approaches(&self.instant.touches[i])) {
            if impacts == MOST_IMPACTS_OF_BOUNCES {
                self.core
                    .accounts
                    .tolerate(self.instant.t, "bounces were ended while bodies still approach each other");
                break;
            }
            impacts += 1;
            self.strike_group(group)?;
            self.refresh_kinematics();
            (candidates, forces, has_ended) = self.candidates_after_jams(group)?;
        }
        for &i in &group.contacts {
            let hold = match candidates.binary_search(&i) {
                Ok(row) => hold_of(self.instant, &self.instant.touches[i], &forces, row),
                Err(_) => Hold::Open,
            };
            self.set_hold(i, hold);
            let row = candidates.binary_search(&i).ok().filter(|_| hold == Hold::Held);
            self.set_friction(i, row.and_then(|row| forces.mode(row)));
            if self.core.model.surfaces.have_rotational_friction() {
                self.set_rotation(i, row.map(|row| (row, &forces)));
            }
        }
        self.settle(group, &candidates, &forces)
    }

    /// Contacts of a group that may hold, their forces, and whether bounces have been ended.
    pub(super) fn candidates(&mut self, group: &Group) -> Result<(Vec<usize>, Forces, bool), SimulationError> {
        let sustained =
            |&i: &usize| self.motions.is_sustained(self.core, self.instant.speed_scale, &self.instant.touches[i]);
        let mut candidates: Vec<usize> = group.contacts.iter().copied().filter(sustained).collect();
        let mut forces = self.forces(group, &candidates)?;
        if self.end_slips(group, (&candidates, &forces))? {
            forces = self.forces(group, &candidates)?;
        }
        let mut has_ended_bounces = false;
        let mut going_on = BTreeSet::new();
        // A contact may close again only because the one below it holds. The contacts found so far are therefore held
        // before the others are tested.
        loop {
            let bounces = self.negligible_bounces(group, (&candidates, &forces), &going_on);
            if bounces.is_empty() {
                break;
            }
            let ended = self.end_bounces(group, (&candidates, &bounces))?;
            going_on.extend(bounces.iter().map(|bounce| bounce.contact).filter(|i| !ended.contains(i)));
            if ended.is_empty() {
                break;
            }
            candidates.extend(ended);
            candidates.sort_unstable();
            has_ended_bounces = true;
            forces = self.forces(group, &candidates)?;
        }
        Ok((candidates, forces, has_ended_bounces))
    }

    /// Whether the bodies of a contact approach each other there.
    fn approaches(&self, touch: &Touch) -> bool {
        touch.is_defined
            && touch.kinematics.separation_rate
                < -self.motions.sustained_speed(self.core, self.instant.speed_scale, touch)
    }

    pub(super) fn forces(&mut self, group: &Group, candidates: &[usize]) -> Result<Forces, SimulationError> {
        let with_mode = |&i: &usize| self.with_friction_mode(&self.instant.touches[i]);
        let members: Vec<Touch> = candidates.iter().map(with_mode).collect();
        let forces = Forces::solve(
            &self.core.model,
            self.instant.t,
            &self.motions.states,
            &group.bodies,
            &members,
            &mut self.core.memory,
        )
        .map_err(|source| {
            SimulationError::of_response(self.instant.t, source).among(&self.core.model, &group.bodies)
        })?;
        if forces.jams {
            let unsolved = (self.instant.t, forces.solution.report.residual);
            return Err(SimulationError::not_solved(&self.core.model, unsolved, &group.bodies));
        }
        let noted = self.core.accounts.note_solve(self.instant.t, &forces.solution.report);
        noted.map_err(|error| error.among(&self.core.model, &group.bodies))?;
        self.core.note_friction(self.instant.t, forces.violation);
        if forces.motion_depends_on_choice {
            let names = reported::names_of(&self.core.model, &group.bodies);
            self.core.accounts.choose(self.instant.t, format!("{LEAST_NORM} {names} depends on that choice"));
        }
        self.tell_open_loads(group)?;
        Ok(forces)
    }

    /// Warns of bearings with friction whose load is not determined.
    fn tell_open_loads(&mut self, group: &Group) -> Result<(), SimulationError> {
        let is_open = open_loads::leave_open(&self.core.model, &self.motions.states, &group.bodies)
            .map_err(|source| SimulationError::of_response(self.instant.t, source))?;
        if is_open {
            let names = reported::names_of(&self.core.model, &group.bodies);
            self.core.accounts.warn(self.instant.t, format!("{OPEN_LOADS} {names} depends on that choice"));
        }
        Ok(())
    }

    /// A contact with its friction at this instant: it slides if it has a slip, or can stick no longer. Otherwise its
    /// forces decide.
    pub(super) fn with_friction_mode(&self, touch: &Touch) -> Touch {
        let change = &self.instant.change;
        let noise = slip_noise(self.core, self.instant.speed_scale, touch);
        let friction = match change.slipping.get(&touch.id) {
            Some(&direction) if friction::friction_of(&self.core.model, touch.id).is_some() => {
                Some(FrictionMode::Sliding(Slide::beginning(direction, noise)))
            }
            _ if change.stopping.contains(&touch.id) => None,
            _ => self.motions.slide_of(self.core, self.instant.speed_scale, touch),
        };
        Touch { modes: ContactModes { friction, rotation: self.rotation_at(touch) }, ..*touch }
    }

    fn set_hold(&mut self, i: usize, hold: Hold) {
        let touch = self.instant.touches[i];
        if touch.known && touch.hold == Hold::Held && hold == Hold::Open {
            self.core.accounts.add_contact_event(
                &self.core.model,
                &self.motions.states,
                contact_event(self.instant.t, EventKind::Detach, &touch),
                touch.id,
            );
        }
        self.instant.touches[i].hold = hold;
        self.instant.touches[i].known = true;
    }

    /// Sets whether an active contact sticks or slides, and reports a change.
    fn set_friction(&mut self, i: usize, found: Option<FoundMode>) {
        let noise = slip_noise(self.core, self.instant.speed_scale, &self.instant.touches[i]);
        let mode = found.map(|found| match found {
            FoundMode::Known(mode) => mode,
            FoundMode::Begins(direction) => FrictionMode::Sliding(Slide::beginning(direction, noise)),
            FoundMode::Sticks => FrictionMode::Sticking,
        });
        let touch = self.instant.touches[i];
        let kind = match (touch.modes.friction, mode) {
            (Some(FrictionMode::Sliding(_)), Some(FrictionMode::Sticking)) => Some(EventKind::Stick),
            (Some(FrictionMode::Sticking), Some(FrictionMode::Sliding(_))) => Some(EventKind::Slide),
            _ => None,
        };
        if let Some(kind) = kind {
            let ended = self.instant.slip_ends.get(&touch.id).copied();
            let t = ended.filter(|_| kind == EventKind::Stick).unwrap_or(self.instant.t);
            let event = contact_event(t, kind, &touch);
            self.core.accounts.add_contact_event(&self.core.model, &self.motions.states, event, touch.id);
        }
        self.instant.touches[i].modes.friction = mode;
    }

    /// Projects held contacts onto zero separation and sets the mode of their bodies: at rest or constrained motion.
    fn settle(&mut self, group: &Group, candidates: &[usize], forces: &Forces) -> Result<(), SimulationError> {
        let members: Vec<Touch> = candidates.iter().map(|&i| self.instant.touches[i]).collect();
        let balanced = forces.balanced_bodies(&self.core.model, &self.motions.states, &members);
        let held = group.contacts.iter().filter(|&&i| self.instant.touches[i].hold == Hold::Held);
        let components =
            groups(&self.core.model, held.map(|&i| (i, self.instant.touches[i].id.a, self.instant.touches[i].id.b)));
        for component in components {
            self.motions.end_flights(self.core, self.instant.t, &component.bodies);
            let ids: Vec<_> = component.contacts.iter().map(|&i| self.instant.touches[i].id).collect();
            let touching = self.with_overlaps(&ids, &component);
            let before = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &component.bodies);
            let turns = component.contacts.iter().flat_map(|&i| self.instant.touches[i].held_turns());
            let turns: Vec<_> = turns.collect();
            let sticks = |i: &&usize| self.instant.touches[**i].modes.friction == Some(FrictionMode::Sticking);
            let sticking: Vec<_> =
                component.contacts.iter().filter(sticks).map(|&i| self.instant.touches[i].id).collect();
            let projected = Projected { touching: &touching, held: &ids, sticking: &sticking, turns: &turns };
            self.motions.project_held_contacts(
                self.core,
                self.schedule,
                &component.bodies,
                projected,
                self.instant.t,
                before,
            )?;
            let scale = self.instant.speed_scale;
            let stands = |driver| prescribed::stands_still(&self.core.model, driver, self.instant.t, f64::INFINITY);
            let rests = allow_rest(self.core, self.instant.t, &ids)
                && self.core.model.joints.drivers_of(&component.bodies).all(stands)
                && component.bodies.iter().all(|&body| {
                    balanced.contains(&body)
                        && self.motions.is_slow(self.core, scale, body)
                        && self.forces_stay_constant(scale, body)
                });
            for &body in &component.bodies {
                if rests {
                    self.stop(body);
                } else if let Mode::Rest = std::mem::replace(&mut self.motions.tracks[body].mode, Mode::Constrained) {
                    self.instant.woken.insert(body);
                }
            }
        }
        self.refresh_kinematics();
        Ok(())
    }

    /// Removes the penetration of bodies that no contact holds together. Each impact leaves a small penetration, and
    /// those of several impacts in a row must not accumulate.
    fn remove_overlaps(&mut self) -> Result<(), SimulationError> {
        for group in groups(&self.core.model, self.instant.numbered()) {
            let touches: Vec<Touch> = group.contacts.iter().map(|&i| self.instant.touches[i]).collect();
            let overlaps =
                |touch: &Touch| is_excess(&self.core.model, &self.motions.states, touch.id, &touch.kinematics.geometry);
            if !touches.iter().any(overlaps) {
                continue;
            }
            self.motions.end_flights(self.core, self.instant.t, &group.bodies);
            let mut pairs: Vec<_> = touches.iter().map(|touch| (touch.id.a, touch.id.b)).collect();
            pairs.dedup();
            let before = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &group.bodies);
            let (bodies, solver) = (&group.bodies, &mut self.core.memory);
            let done = projection::remove_overlap(&self.core.model, &mut self.motions.states, bodies, &pairs, solver)
                .map_err(|source| SimulationError::of_response(self.instant.t, source))?;
            let after = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &group.bodies);
            self.core.book_projection(self.instant.t, &self.motions.states, &done, (before, after));
            self.refresh_kinematics();
        }
        Ok(())
    }

    /// The held contacts of a component, and its open contacts that penetrate although they separate: the projection
    /// removes their penetration too.
    fn with_overlaps(&self, held: &[ContactId], component: &Group) -> Vec<ContactId> {
        let within =
            |body: usize| component.bodies.binary_search(&body).is_ok() || !self.core.model.bodies[body].moves();
        let overlaps = self.instant.touches.iter().filter(|touch| {
            touch.hold == Hold::Open
                && touch.kinematics.geometry.separation
                    < -tolerances::rounding(&self.core.model, &self.motions.states, touch.id.a, touch.id.b)
                && within(touch.id.a)
                && within(touch.id.b)
        });
        held.iter().copied().chain(overlaps.map(|touch| touch.id)).collect()
    }

    /// Sets a body in equilibrium exactly to rest and books its remaining kinetic energy.
    fn stop(&mut self, body: usize) {
        let before = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &[body]);
        self.motions.states[body].linear_velocity = DVec3::ZERO;
        self.motions.states[body].angular_momentum = DVec3::ZERO;
        let after = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &[body]);
        self.core.accounts.books.rest(before, after, 0.0);
        let rested = matches!(self.motions.tracks[body].mode, Mode::Rest);
        self.motions.tracks[body].mode = Mode::Rest;
        self.instant.woken.remove(&body);
        let t = self.instant.rest_times.remove(&body).unwrap_or(self.instant.t);
        if !rested && self.instant.t > 0.0 {
            self.core.accounts.add_event(body_event(
                t,
                EventKind::Rest,
                body,
                self.motions.states[body].pose.translation,
            ));
        }
    }

    /// Bodies without a held contact begin free motion. Bodies woken from rest are reported.
    fn release_free_bodies(&mut self) {
        let held = self.instant.touches.iter().filter(|touch| touch.hold == Hold::Held);
        let held: BTreeSet<usize> = held.flat_map(|touch| [touch.id.a, touch.id.b]).collect();
        // Bodies that joints connect to a held one moved or came to rest with it.
        let held = self.core.model.joints.with_jointed(held.into_iter().collect());
        for &body in &self.instant.bodies {
            if matches!(self.motions.tracks[body].mode, Mode::Constrained | Mode::Rest)
                && held.binary_search(&body).is_err()
            {
                self.motions.begin_free_motion(self.core, body, self.instant.t);
            }
        }
        for body in std::mem::take(&mut self.instant.woken) {
            let place = self.motions.states[body].pose.translation;
            self.core.accounts.add_event(body_event(self.instant.t, EventKind::Wake, body, place));
        }
    }

    /// Reports pairs between which contact has begun or ended.
    fn report_pairs(&mut self, before: &BTreeSet<(usize, usize)>) {
        if self.instant.t == 0.0 {
            return;
        }
        let after = self.instant.held_pairs();
        for &(a, b) in before.difference(&after) {
            let mut event =
                body_event(self.instant.t, EventKind::ContactEnd, a, self.motions.states[a].pose.translation);
            event.body_b = (b != a).then(|| BodyId::new(b));
            if let Some(touch) = self.instant.touches.iter().find(|touch| (touch.id.a, touch.id.b) == (a, b)) {
                event = contact_event(self.instant.t, EventKind::ContactEnd, touch);
            }
            self.core.accounts.add_event(event);
        }
        for pair in after.difference(before) {
            if let Some(touch) = self.instant.touches.iter().find(|touch| (touch.id.a, touch.id.b) == *pair) {
                self.core.accounts.add_event(contact_event(self.instant.t, EventKind::ContactBegin, touch));
            }
        }
    }

    /// Whether the forces on a body remain constant while it rests: none depends on time, and the bodies coupled to it
    /// by forces rest too or are slow enough to rest.
    fn forces_stay_constant(&self, speed_scale: f64, body: usize) -> bool {
        let couplings = self.core.model.couplings_of(body);
        let still = |&other: &usize| {
            matches!(self.motions.tracks[other].mode, Mode::Rest) || self.motions.is_slow(self.core, speed_scale, other)
        };
        !self.core.model.forces.is_driven(body) && couplings.flatten().all(still)
    }

    /// Wakes resting bodies that a force couples to a moving body, and the bodies that rest in contact with them.
    fn wake_coupled(&mut self) {
        let rests = |engine: &Self, body: usize| matches!(engine.motions.tracks[body].mode, Mode::Rest);
        loop {
            let mut wake = BTreeSet::new();
            for coupled in &self.core.model.forces.couplings {
                if coupled.iter().any(|&body| !rests(self, body)) {
                    wake.extend(coupled.iter().copied().filter(|&body| rests(self, body)));
                }
            }
            for touch in self.instant.touches.iter().filter(|touch| touch.hold == Hold::Held) {
                for (body, other) in [(touch.id.a, touch.id.b), (touch.id.b, touch.id.a)] {
                    if matches!(self.motions.tracks[other].mode, Mode::Constrained) && rests(self, body) {
                        wake.insert(body);
                    }
                }
            }
            if wake.is_empty() {
                return;
            }
            for body in wake {
                self.motions.tracks[body].mode = Mode::Constrained;
                self.instant.woken.insert(body);
            }
        }
    }

    /// Evaluates every contact of the instant at the current states. One whose features no longer define it keeps its
    /// place, by which groups know it, but neither holds nor approaches.
    pub(super) fn refresh_kinematics(&mut self) {
        for touch in &mut self.instant.touches {
            let kinematics = contact_kinematics::kinematics(&self.core.model, &self.motions.states, touch.id);
            touch.is_defined = kinematics.is_some();
            touch.kinematics = kinematics.unwrap_or(touch.kinematics);
        }
    }
}

impl Motions {
    /// The friction of a contact that has a slip; none without a slip or friction.
    pub(super) fn slide_of(&self, core: &Core, speed_scale: f64, touch: &Touch) -> Option<FrictionMode> {
        friction::friction_of(&core.model, touch.id)?;
        let slip = contact_kinematics::tangential_kinematics(&core.model, &self.states, touch.id)?.slip_velocity;
        let speed = slip.length();
        let slides = speed > self.sustained_speed(core, speed_scale, touch);
        let noise = slip_noise(core, speed_scale, touch);
        slides.then(|| FrictionMode::Sliding(Slide { direction: slip / speed, speed, noise }))
    }

    /// Ends the free flight of some bodies.
    pub(super) fn end_flights(&mut self, core: &mut Core, t: f64, bodies: &[usize]) {
        for &body in bodies {
            self.book_flight(core, body, t);
            if matches!(self.tracks[body].mode, Mode::Flight(_) | Mode::Stepped) {
                self.tracks[body].mode = Mode::Constrained;
            }
        }
    }

    /// Relative speed below which a contact counts as neither approaching nor separating, m/s.
    pub(super) fn sustained_speed(&self, core: &Core, speed_scale: f64, touch: &Touch) -> f64 {
        let speed = |body: usize| tolerances::point_speed(&core.model, &self.states, body);
        SUSTAINED_RELATIVE * (speed(touch.id.a) + speed(touch.id.b)) + SUSTAINED_SCENE_RELATIVE * speed_scale
    }

    pub(super) fn is_sustained(&self, core: &Core, speed_scale: f64, touch: &Touch) -> bool {
        touch.is_defined && touch.kinematics.separation_rate.abs() <= self.sustained_speed(core, speed_scale, touch)
    }

    fn is_slow(&self, core: &Core, speed_scale: f64, body: usize) -> bool {
        tolerances::point_speed(&core.model, &self.states, body) <= STOPPED_RELATIVE * speed_scale
    }
}

/// Whether other bodies can rest from `t` (s) on all kinematic members of the contacts.
fn allow_rest(core: &Core, t: f64, contacts: &[ContactId]) -> bool {
    contacts.iter().flat_map(|id| [id.a, id.b]).all(|body| prescribed::allows_rest(&core.model, body, t))
}

/// Rounding error of the slips of a contact of bodies whose largest speed has been `speed_scale`, m/s.
pub(super) fn slip_noise(core: &Core, speed_scale: f64, touch: &Touch) -> f64 {
    let size = |body: usize| if core.model.bodies[body].rigid.is_some() { core.model.bodies[body].size } else { 0.0 };
    let fall = core.model.gravity().length() * size(touch.id.a).max(size(touch.id.b));
    SLIP_NOISE * speed_scale + GATHERED_SLIP * fall.sqrt()
}

/// Whether a candidate holds: it carries force, or it does not break and was not open before.
fn hold_of(instant: &Instant, touch: &Touch, forces: &Forces, row: usize) -> Hold {
    let opens = forces.solution.velocities[row] > OPENING_FRACTION * forces.opening;
    let was_open = touch.known && touch.hold == Hold::Open;
    // The force of a breaking contact has fallen to zero. A contact that still carries load is not breaking.
    let largest = forces.of_contacts().iter().fold(0.0f64, |most, &f| most.max(f));
    let departed = (DEPARTED_FORCE * largest).max(DEPARTED_LOAD * forces.load);
    if instant.change.departing.contains(&touch.id) && forces.solution.reactions[row] <= departed {
        return Hold::Open;
    }
    if forces.solution.reactions[row] > 0.0 || !(opens || was_open) { Hold::Held } else { Hold::Open }
}

fn contact_event(t: f64, kind: EventKind, touch: &Touch) -> Event {
    Event {
        t_s: t,
        kind,
        body_a: BodyId::new(touch.id.a),
        body_b: touch.id.second().map(BodyId::new),
        point: touch.kinematics.geometry.point,
        normal: touch.kinematics.geometry.normal,
        impulse: 0.0,
        energy_change_j: 0.0,
    }
}

fn body_event(t: f64, kind: EventKind, body: usize, point: DVec3) -> Event {
    Event {
        t_s: t,
        kind,
        body_a: BodyId::new(body),
        body_b: None,
        point,
        normal: DVec3::ZERO,
        impulse: 0.0,
        energy_change_j: 0.0,
    }
}
