//! One time step, and steps that are split at impacts.

use super::NO_WORK_J;
use super::closed_joints::close_joints;
use super::cone_problem::ConeSolvers;
use super::contacts::{NearContact, Span, await_impacts, may_change_features, near_contacts, slips_at_start};
use super::drift;
use super::kick::Kick;
use super::last_forces::LastForces;
use super::made::Made;
use super::middle::{Middle, Problem, Stops};
use super::newton_law::newton_residual;
use crate::accounting::books::Received;
use crate::accounting::time_step_report::{Stop, TimeStepReport};
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::states_of::states_of;
use crate::model::{Model, prescribed, tolerances};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use crate::scene::ImpactLaw;
use crate::snapshot::{SnapshotError, content};
use crate::solve::overlap::Overlaps;
use polhode_dynamics::BodyState;
use polhode_response::solve::way;
use polhode_response::{Memory, ResponseError};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Impacts closer to each other than this fraction of a step belong to one instant. It is far too short for their order
/// to matter, and above the error of predicted times (of order h^2).
const SAME_INSTANT: f64 = 1e-4;

/// Where no impact is resolved at the start of a step for being there (s): no contact closes before its start.
const NO_INSTANT: f64 = -1.0;

/// Most slips at whose ends a step is split, besides its impacts, and most impacts of a crowd: further ones end with
/// the last part of the step.
pub(crate) const MOST_SPLITS: u32 = 4;

/// Bodies are at rest if their speeds at the start and end of a step are below this fraction of the sum of velocity
/// changes by gravity and by each impulse of the step: some thousand rounding units.
const REST_RELATIVE: f64 = 1e-12;

/// The contacts that carried an impulse in the last step of their pair: the warm start of the next problem.
#[derive(Debug, Clone, Default)]
pub(super) struct Carried {
    by_pair: BTreeMap<(usize, usize), Vec<Feature>>,
}

impl Carried {
    pub(super) fn contains(&self, id: ContactId) -> bool {
        self.by_pair.get(&(id.a, id.b)).is_some_and(|features| features.binary_search(&id.feature).is_ok())
    }

    /// Replaces the entries of `pairs`; `carrying` are sorted.
    fn replace(&mut self, pairs: &[(usize, usize)], carrying: impl Iterator<Item = ContactId>) {
        for pair in pairs {
            self.by_pair.remove(pair);
        }
        for id in carrying {
            self.by_pair.entry((id.a, id.b)).or_default().push(id.feature);
        }
    }
}

/// A step, or a part of a step that is split.
#[derive(Debug, Clone, Copy)]
pub(super) struct Substep {
    /// Its start, s.
    pub(super) t: f64,
    /// Its length, s.
    pub(super) h: f64,
    /// Impacts closer than this belong to one instant, s.
    pub(super) instant: f64,
}

/// How the impacts of islands with many contacts are resolved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Heaps {
    /// As those of few: each at its time.
    OneByOne,
    /// At the end of a step, all together.
    Together,
}

/// Makes time steps. Keeps its buffers and the warm start from step to step.
#[derive(Debug, Clone)]
pub(crate) struct TimeStepper {
    pub(super) law: ImpactLaw,
    /// The reference point of moments in the books, m.
    pub(super) about: DVec3,
    /// Most impacts at which [`TimeStepper::advance_by`] splits a step.
    splits: u32,
    heaps: Heaps,
    /// Largest height of a bounce that need not be resolved, relative to the size of the smaller body ([`Span`]).
    pub(super) unseen_bounce: f64,
    pub(super) memory: Memory,
    pub(super) carried: Carried,
    pub(super) cones: ConeSolvers,
    /// Those of the problems at the start of steps.
    pub(super) cones_at_start: ConeSolvers,
}

impl TimeStepper {
    /// Steps by this impact law, with moments booked about a point (m), split at no more than `splits` impacts each.
    pub(crate) fn new(law: ImpactLaw, about: DVec3, splits: u32) -> Self {
        Self {
            law,
            about,
            splits,
            heaps: Heaps::OneByOne,
            unseen_bounce: f64::INFINITY,
            memory: Memory::default(),
            carried: Carried::default(),
            cones: ConeSolvers::default(),
            cones_at_start: ConeSolvers::default(),
        }
    }

    /// The same stepper for heaps: where an island has many contacts its step is not split at impacts. Those without
    /// restitution are resolved together, by the problem of the step, which leaves no contact approaching at its end: a
    /// step that is split at each of them would solve a problem of all contacts every time.
    pub(crate) fn for_heaps(mut self) -> Self {
        self.heaps = Heaps::Together;
        self.cones = ConeSolvers::of_heaps();
        self.cones_at_start = ConeSolvers::of_heaps();
        self
    }

    /// Whether the impacts of an island with so many contacts are resolved together.
    pub(super) fn resolves_together(&self, contacts: usize) -> bool {
        self.heaps == Heaps::Together && way::are_many(contacts)
    }

    /// The point about which moments are booked, m.
    pub(crate) fn about(&self) -> DVec3 {
        self.about
    }

    /// The contacts that carried an impulse in the last step of their pair, in order.
    pub(crate) fn carried(&self) -> impl Iterator<Item = ContactId> + '_ {
        let of_pair = |(&(a, b), features): (&(usize, usize), &Vec<Feature>)| {
            features.iter().map(move |&feature| ContactId { a, b, feature }).collect::<Vec<_>>()
        };
        self.carried.by_pair.iter().flat_map(of_pair)
    }

    /// Takes over the warm start of these bodies and pairs from another stepper, which has stepped them.
    pub(crate) fn take_from(&mut self, other: &Self, bodies: &[usize], pairs: &[(usize, usize)]) {
        self.cones.last.take_from(&other.cones.last, bodies, pairs);
        for pair in pairs {
            match other.carried.by_pair.get(pair) {
                Some(features) => self.carried.by_pair.insert(*pair, features.clone()),
                None => self.carried.by_pair.remove(pair),
            };
        }
    }

    /// Keeps what these contacts bore in the last step of their pair, and forgets that of all others.
    pub(crate) fn keep_contacts(&mut self, stays: impl Fn(ContactId) -> bool) {
        for (&(a, b), features) in &mut self.carried.by_pair {
            features.retain(|&feature| stays(ContactId { a, b, feature }));
        }
        self.carried.by_pair.retain(|_, features| !features.is_empty());
        self.cones.last.keep_contacts(stays);
    }

    /// Sets the warm start to these contacts, which are sorted, as if they had carried an impulse in the last step of
    /// their pair.
    pub(crate) fn carry(&mut self, contacts: Vec<ContactId>) {
        self.carried.replace(&[], contacts.into_iter());
    }

    /// Starts the next problems from forces of contacts on A: along the normal and in the tangent plane, world, N.
    pub(crate) fn start_from(&mut self, forces: impl Iterator<Item = (ContactId, f64, DVec3)>) {
        self.cones.last.take_held(forces);
    }

    /// The forces of the last step as plain data.
    pub(crate) fn save_last_forces(&self) -> content::LastForces {
        self.cones.last.save()
    }

    /// Takes the forces of the last step from plain data.
    ///
    /// # Errors
    /// When they are not of this scene.
    pub(crate) fn restore_last_forces(
        &mut self,
        model: &Model,
        saved: &content::LastForces,
    ) -> Result<(), SnapshotError> {
        self.cones.last = LastForces::restored(model, saved)?;
        Ok(())
    }

    /// Advances `bodies` (movable, ascending) from `t` by `h` (s). `pairs` (A < B, ascending) are all that may touch
    /// within it; one of a pair may be immovable or kinematic, and no body beside these may be touched or coupled by a
    /// field. Kinematic members of pairs are set to their prescribed poses during and at the end of the step.
    ///
    /// The step is split where contacts close fast enough to bounce, at times predicted from the free flight of the
    /// bodies, up to the number of splits: impacts are then resolved where and when they happen. Without splits it is
    /// one step.
    ///
    /// # Errors
    /// When a number is not finite; the states are those at the start of the substep that failed.
    pub(super) fn advance_by(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        (t, h): (f64, f64),
    ) -> Result<TimeStepReport, ResponseError> {
        let mut report = TimeStepReport::new(self.about);
        let (mut done, instant) = (0.0, SAME_INSTANT * h);
        let (mut splits_left, mut stops) = (self.splits, MOST_SPLITS);
        while done < h {
            let left = h - done;
            let span = Span { h: left, unseen_bounce: self.unseen_bounce };
            let mut near = near_contacts(model, states, bodies, pairs, t + done, span);
            let together = self.resolves_together(near.len());
            let (splits, instant) = if together { (0, NO_INSTANT) } else { (splits_left, instant) };
            let first = if splits > 0 { first_impact(&near, instant, left) } else { None };
            let interval = Substep { t: t + done, h: first.unwrap_or(left), instant };
            if first.is_some() {
                await_impacts(model, &mut near, (interval.h, left), instant);
            }
            let made = self.step_by(model, states, bodies, (near, pairs), (interval, Stops::Sought))?;
            if made.stops.is_empty() {
                report.append(made);
                splits_left = splits.saturating_sub(1);
                if first.is_none() {
                    break;
                }
                done += interval.h;
                continue;
            }
            let (interval, ending) = up_to_stop(interval, &made.stops, stops);
            stops = stops.saturating_sub(1);
            let mut near = near_contacts(model, states, bodies, pairs, t + done, span);
            if first.is_some() {
                await_impacts(model, &mut near, (interval.h, left), instant);
            }
            report.append(self.step_by(model, states, bodies, (near, pairs), (interval, Stops::At(&ending)))?);
            done = if interval.h < left { done + interval.h } else { h };
        }
        Ok(report)
    }

    /// Makes a step of some bodies with these contacts and pairs, but for the removal of what overlaps at its end.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn make_step(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        (mut near, pairs): (Vec<NearContact>, &[(usize, usize)]),
        (part, stops): (Substep, Stops<'_>),
    ) -> Result<Made, ResponseError> {
        let Substep { t, h, .. } = part;
        let mut report = TimeStepReport::new(self.about);
        report.steps = 1;
        let struck_from = states_of(states, bodies);
        self.strike_closing(model, states, bodies, &mut near, part, &mut report)?;
        self.stop_closing(model, states, bodies, &mut near, part, &mut report)?;
        let start = states_of(states, bodies);
        let slips = slips_at_start(model, states, &near);
        let speeds: Vec<f64> = bodies.iter().map(|&body| tolerances::point_speed(model, states, body)).collect();

        let before = report.books.balance(model, states, bodies);
        let mut received = self.fly(model, states, bodies, 0.5 * h);
        prescribed::prescribe_members(model, pairs, t + 0.5 * h, states);
        let middle = (t + 0.5 * h, h, stops);
        let Some(kick) = self.kick(model, states, bodies, (&near, &slips), middle, &mut report)? else {
            return Ok(Made { report, struck: start, pairs: Vec::new(), overlaps: Overlaps::default() });
        };
        let kicked = report.books.balance(model, states, bodies);

        let middle = Middle { problem: Problem::Sustained, t: t + 0.5 * h, h, stops, kick: &kick };
        let carrying = self.sustain(model, states, bodies, (&near, &slips), middle, &mut report)?;
        if !report.stops.is_empty() {
            return Ok(Made { report, struck: start, pairs: Vec::new(), overlaps: Overlaps::default() });
        }
        received += kick.received(model, states, bodies, h, &report.books);
        report.books.smooth_stage(before, kicked, received);
        let before = report.books.balance(model, states, bodies);
        let received = self.fly(model, states, bodies, 0.5 * h);
        prescribed::prescribe_members(model, pairs, t + h, states);
        let after = report.books.balance(model, states, bodies);
        report.books.smooth_stage(before, after, received);

        let ids: Vec<ContactId> = carrying.iter().map(|&contact| near[contact].id).collect();
        self.cones.last.keep(pairs, &ids);
        self.carried.replace(pairs, ids.into_iter());
        if prescribed::members_stand_still(model, bodies, pairs, (t, t + h)) {
            rest_exactly(model, states, bodies, (&start, &speeds), h, &mut report);
        }
        let (mut overlaps, mut near_pairs) = (Overlaps::default(), Vec::new());
        if !report.at_rest {
            let has_contact = |pair: &(usize, usize)| near.binary_search_by(|n| (n.id.a, n.id.b).cmp(pair)).is_ok();
            let may_overlap =
                |pair: &&(usize, usize)| has_contact(pair) || may_change_features(model, states, **pair, h);
            near_pairs.extend(pairs.iter().filter(may_overlap).copied());
            close_joints(model, states, bodies, &mut report)?;
            overlaps = Overlaps::find(model, states, &near_pairs);
            report.newton_residual = newton_residual(model, (&struck_from, states), bodies, (&kick, h), &report);
        }
        if let Some(index) = bodies.iter().position(|&body| !states[body].is_finite()) {
            return Err(ResponseError::NotFinite { what: "states after a time step", index });
        }
        report.touching = carrying.iter().map(|&contact| (near[contact].id.a, near[contact].id.b)).collect();
        report.touching.dedup();
        Ok(Made { report, struck: start, pairs: near_pairs, overlaps })
    }

    /// Kicks the bodies by the fields. Where these resist motion, they do that at the velocity that constraints leave
    /// the bodies: a first solution shows it, and is taken back. Nothing when slips end within the step, which the
    /// report then names.
    fn kick(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        contacts: (&[NearContact], &[f64]),
        (t, h, stops): (f64, f64, Stops<'_>),
        report: &mut TimeStepReport,
    ) -> Result<Option<Kick>, ResponseError> {
        let first = Kick::of(model, states, bodies, (t, h), &[]);
        if !first.is_resisting() {
            return Ok(Some(first));
        }
        let mut aside = TimeStepReport::new(self.about);
        self.sustain(
            model,
            states,
            bodies,
            contacts,
            Middle { problem: Problem::Sustained, t, h, stops, kick: &first },
            &mut aside,
        )?;
        if !aside.stops.is_empty() {
            report.stops = aside.stops;
            return Ok(None);
        }
        let by_constraints = first.changes_since(model, states, bodies);
        first.undo(states, bodies);
        Ok(Some(Kick::of(model, states, bodies, (t, h), &by_constraints)))
    }

    /// Free flight of all bodies for `h`. Returns the momentum from gravity.
    fn fly(&self, model: &Model, states: &mut [BodyState], bodies: &[usize], h: f64) -> Received {
        let mut sum = MomentumSum::default();
        for &body in bodies {
            let start = states[body];
            states[body] = drift(model, body, &start, h);
            if model.carries_momentum(body) {
                sum.add(given_by_gravity(model, body, &start, h, self.about));
            }
        }
        Received { gravity: sum.value(), ..Received::default() }
    }
}

/// Sets bodies that are at rest at the start and at the end of the step back to their initial poses.
fn rest_exactly(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    (start, speeds): (&[BodyState], &[f64]),
    h: f64,
    report: &mut TimeStepReport,
) {
    let mut given = vec![h * model.gravity().length(); bodies.len()];
    for impulse in &report.impulses {
        for (body, _) in impulse.id.members() {
            if let (Ok(index), Some(rigid)) = (bodies.binary_search(&body), &model.bodies[body].rigid) {
                given[index] += impulse.impulse / rigid.mass();
            }
        }
    }
    // Each is compared by itself: the larger of a number and of what is none is that number.
    let rests = |((&body, &speed), &given): ((&usize, &f64), &f64)| {
        [speed, tolerances::point_speed(model, states, body)].iter().all(|own| *own <= REST_RELATIVE * given)
    };
    report.at_rest = !bodies.is_empty() && bodies.iter().zip(speeds).zip(&given).all(rests);
    if report.at_rest {
        let before = report.books.balance(model, states, bodies);
        for (&body, start) in bodies.iter().zip(start) {
            states[body] = BodyState::at_rest(start.pose);
        }
        let after = report.books.balance(model, states, bodies);
        report.books.rest(before, after, NO_WORK_J);
    }
}

/// The part of a step up to the first of these stops, with the contacts that come to rest there; the whole of it where
/// the first is at its start or its end, or where no more parts may be made.
fn up_to_stop(interval: Substep, stops: &[Stop], parts: u32) -> (Substep, Vec<ContactId>) {
    let Substep { h, instant, .. } = interval;
    let first = stops.iter().fold(f64::INFINITY, |first: f64, stop| first.min(stop.part * h));
    if parts == 0 || first <= instant || h - first <= instant {
        return (interval, stops.iter().map(|stop| stop.id).collect());
    }
    let together = stops.iter().filter(|stop| stop.part * h - first <= instant);
    (Substep { h: first, ..interval }, together.map(|stop| stop.id).collect())
}

/// Time to the first impact after this instant, s, within the rest of a step.
fn first_impact(near: &[NearContact], instant: f64, left: f64) -> Option<f64> {
    let times = near.iter().filter_map(|contact| contact.impact_time(left));
    times.filter(|&time| time > instant).min_by(f64::total_cmp)
}

/// The impulse of a body's weight in a flight of `h` (s) from a state, its moment integrated over the parabola.
pub(crate) fn given_by_gravity(model: &Model, body: usize, start: &BodyState, h: f64, about: DVec3) -> Momentum {
    let mass = model.bodies[body].rigid.as_ref().map_or(0.0, polhode_dynamics::RigidBody::mass);
    let linear = model.gravity() * (mass * h);
    let mean = start.pose.translation + start.linear_velocity * (0.5 * h) + model.gravity() * (h * h / 6.0);
    Momentum { linear, angular: (mean - about).cross(linear) }
}
