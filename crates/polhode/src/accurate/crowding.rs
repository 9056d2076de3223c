//! Stretches of crowded events: intervals of time in which an island advances by time steps at velocity level.
//!
//! Events are crowded if steps no longer advance time (`pace.rs`): bounces that accumulate at several contacts at once
//! (Zeno behaviour), contacts whose point jumps, piles that settle. The affected bodies then advance by the time steps
//! of `crate::time_stepping`, with all their touching and nearly touching contacts, for a stretch of one longest step.
//! After it events are located again. Every further stretch of a body is twice as long as its last one, up to
//! [`LONGEST_STRETCH`].
//!
//! A stretch has its own error control: each time step is compared with two of half its length, and the tolerance of
//! crowding determines its length; so does the energy that its projections and the integrator take, relative to that
//! of its bodies. The sum of the estimates is reported with the stretch. The bodies of a stretch are
//! called its crowd. A body of another island that may touch the crowd within a time step joins it. For the impact
//! search of other islands, a body moves within one time step along a straight line at constant angular velocity.
//!
//! Bodies of a crowd that cannot touch each other within a step make steps of their own (`crowd_parts.rs`), and a part
//! without any body whose events crowded leaves the stretch.
//!
//! Where the error of a step does not fall with its length, as where rounding decides which of two contacts gives way,
//! shorter steps add up to a larger error. If no step down to the shortest one is exact enough, the one of those tried
//! with the least error per time is made.
//!
//! Limit: at the shortest step a stretch continues whatever its error, which the reported estimate contains.

use super::crowd_parts::{CrowdPart, SWEEP_FACTOR, may_touch_within};
use super::crowd_step::{Crowd, CrowdStep, motions};
use super::engine::Engine;
use super::instant::Instant;
use super::island::{Island, Step};
use super::motions::{Mode, Motions};
use super::pace::{NoAdvance, Pace};
use crate::accounting::time_step_report::TimeStepReport;
use crate::collision::active_contacts::ActiveContacts;
use crate::collision::contact_set;
use crate::error::SimulationError;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, tolerances};
use crate::solve::cone_violation::CONE_LIMIT;
use crate::solve::overlap::Overlaps;
use crate::tier::core::Core;
use crate::time_stepping::{MOST_SPLITS, TimeStepper};
use polhode_contact::aabb_of;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use std::collections::{BTreeMap, BTreeSet};

/// First time step that is tried, as a fraction of the longest step.
const FIRST_STEP: f64 = 1e-2;

/// Shortest time step, as a fraction of the longest step. It is accepted whatever its error.
const SHORTEST_STEP: f64 = 1e-5;

/// Longest stretch, in longest steps.
const LONGEST_STRETCH: f64 = 16.0;

/// Remaining penetration, relative to the smallest body, beyond which the run ends: the bodies cannot be separated, as
/// a ball under a closing press.
const NO_WAY_OUT: f64 = 1e-3;

/// The next time step aims at this fraction of what is allowed.
const SAFETY: f64 = 0.8;

/// Least and largest change of the time step from one to the next: every length that is tried costs the solution of
/// three contact problems, and of steps that grow eightfold almost every second one is refused.
const STEP_CHANGE: (f64, f64) = (0.1, 3.0);

/// Largest change of a time step that is refused again: a contact that begins within it leaves an error that falls only
/// with its length.
const SHORTENED_AGAIN: f64 = 0.2;

/// Share of the error allowed that is spread over a stretch evenly (no unit). The rest is spare, for steps
/// within which a contact begins to stick or to slide: their error falls only with the square of their length, but
/// there are few of them.
const EVEN_SHARE: f64 = 0.5;

/// The share of the spare error that is left which one step may use (no unit): what is left never ends.
const SHARE_OF_SPARE: f64 = 0.125;

/// The length after one of `h` (s) that was refused with this ratio of the optimal length to it, `refused` times now.
fn shorter_length(h: f64, ratio: f64, refused: usize) -> f64 {
    h * ratio.clamp(STEP_CHANGE.0, if refused > 1 { SHORTENED_AGAIN } else { SAFETY })
}

/// The length after an accepted one.
fn next_length(h: f64, ratio: f64) -> f64 {
    h * ratio.clamp(STEP_CHANGE.0, STEP_CHANGE.1)
}

/// A time step that is accepted, or the parts of a crowd that need shorter ones.
enum Attempted {
    Made(Box<Made>),
    Divided(Vec<CrowdPart>),
}

/// A time step that is accepted.
struct Made {
    /// Its end, s.
    end: f64,
    report: TimeStepReport,
    /// Its estimated error, relative to the size of a body.
    error: f64,
    /// The stretch with the length of the next step.
    next: Crowd,
}

/// A time step that was tried and has too large an error.
struct Refused {
    /// Its length, s.
    h: f64,
    end: f64,
    report: TimeStepReport,
    error: f64,
    states: Vec<BodyState>,
}

impl Refused {
    /// Its error per time, 1/s: a stretch of such steps adds it up.
    fn rate(&self) -> f64 {
        self.error / self.h
    }
}

/// The time stepper of a crowd.
fn stepper(core: &Core) -> TimeStepper {
    let about = core.accounts.books.ledger.momentum.about;
    let stepper = TimeStepper::new(core.settings.impact, about, MOST_SPLITS);
    stepper.following_bounces(core.settings.crowd_error_allowed())
}

/// A time step from `t` over `h` (s) with its error estimate.
///
/// # Errors
/// When it is not possible.
fn time_step(
    model: &Model,
    stepper: &mut TimeStepper,
    states: &mut [BodyState],
    (bodies, pairs): (&[usize], &[(usize, usize)]),
    (t, h): (f64, f64),
) -> Result<(TimeStepReport, f64), ResponseError> {
    stepper.advance_with_estimate(model, states, bodies, pairs, (t, h))
}

/// The warning of a stretch of crowded events.
const CROWD: &str = "crowded events: the affected bodies advance by time steps for a while, in which the impulses of \
                     each step obey the laws of contact and friction: they decide where these allow several motions, \
                     or no forces";

impl Engine {
    /// Begins a stretch of time steps for the bodies of an instant with crowded events.
    ///
    /// # Errors
    /// [`SimulationError::NoProgress`] when the settings end a run at crowded events; or when a time step is not
    /// possible.
    pub(super) fn begin_stretch(
        &mut self,
        core: &mut Core,
        instant: Instant,
        stuck: NoAdvance,
    ) -> Result<(), SimulationError> {
        if !core.settings.crowding.steps() {
            return Err(instant.no_progress(core, stuck));
        }
        let longest = core.settings.step_s;
        let last = instant.bodies.iter().map(|&body| self.motions.tracks[body].last_stretch_s).fold(0.0, f64::max);
        let span = (2.0 * last).clamp(longest, LONGEST_STRETCH * longest);
        for &body in &instant.bodies {
            self.motions.tracks[body].last_stretch_s = span;
        }
        let number = core.accounts.begin_crowding(instant.t, instant.bodies.len(), CROWD);
        let spare_error = (1.0 - EVEN_SHARE) * core.settings.crowd_error_allowed() * span / longest;
        let step_s = FIRST_STEP * longest * core.settings.crowd_step_factor;
        let crowd = Crowd { until: instant.t + span, step_s, number, spare_error };
        for &body in &instant.bodies {
            self.motions.book_flight(core, body, instant.t);
            self.motions.tracks[body].mode = Mode::Crowded(crowd);
        }
        self.crowd_step(core, instant, crowd)
    }

    /// Latest end of a time step from `t`, s.
    fn limit_of_crowd_step(&self, core: &Core, t: f64) -> f64 {
        let longest = core.settings.step_s * core.settings.crowd_step_factor;
        core.horizon(t).min(t + longest).min(self.schedule.end_of_kinematic_boxes(core, t))
    }

    /// Makes one time step of the bodies of an instant and of all bodies that may meet them within it: of each part by
    /// itself. Parts that no longer belong to a stretch leave it.
    pub(super) fn crowd_step(
        &mut self,
        core: &mut Core,
        mut instant: Instant,
        crowd: Crowd,
    ) -> Result<(), SimulationError> {
        let t = instant.t;
        let limit = self.limit_of_crowd_step(core, t);
        let pairs = self.gather(core, &mut instant, crowd.step_s.min(limit - t))?;
        for pair in instant.pairs.iter().chain(&pairs) {
            self.schedule.contacts.set(*pair, Vec::new());
        }
        let crowd = self.motions.ongoing_stretch(&instant).unwrap_or(crowd);
        let whole = CrowdPart { bodies: instant.bodies.clone(), pairs: pairs.clone(), crowd, refused: 0 };
        let mut states = std::mem::take(&mut self.motions.scratch);
        set_states(&mut states, &instant.bodies, &states_of(&self.motions.states, &instant.bodies));
        let parts = whole.divided(&core.model, &states);
        self.motions.restore_scratch(core, states, &instant.bodies);
        let (mut staying, leaving): (Vec<_>, Vec<_>) =
            parts.into_iter().partition(|part| self.motions.belongs_to_stretch(&part.bodies, t));
        let mut firsts = Vec::new();
        while let Some(part) = staying.pop() {
            firsts.extend(self.motions.step_of_part(core, part, (t, limit), &mut staying)?);
        }
        let islands = firsts.iter().filter_map(|&first| self.motions.island(first));
        let mut bodies: Vec<usize> = islands.flat_map(|island| island.bodies.iter().copied()).collect();
        bodies.sort_unstable();
        self.look_ahead(core, &bodies, &firsts, t)?;
        for part in leaving {
            let left = instant.part(core, part.bodies, &pairs);
            self.end_stretch(core, left)?;
        }
        Ok(())
    }

    /// Adds to an instant all bodies that may meet its bodies within `h` seconds. Returns the pairs that may meet.
    fn gather(
        &mut self,
        core: &mut Core,
        instant: &mut Instant,
        h: f64,
    ) -> Result<Vec<(usize, usize)>, SimulationError> {
        let t = instant.t;
        // The states of bodies of other islands at `t`: within a time step each costs as much as the step.
        let mut seen = BTreeMap::new();
        loop {
            for &body in &instant.bodies {
                self.motions.book_flight(core, body, t);
                if !matches!(self.motions.tracks[body].mode, Mode::Crowded(_)) {
                    self.motions.tracks[body].mode = Mode::Constrained;
                }
                self.set_crowd_box(core, body, h);
            }
            let mut pairs = BTreeSet::new();
            let mut joins = BTreeSet::new();
            for &body in &instant.bodies {
                for other in self.schedule.near_boxes(core, body) {
                    if core.model.bodies[other].moves() && instant.bodies.binary_search(&other).is_err() {
                        if !self.motions.may_join(core, (body, other), (t, h), &mut seen)? {
                            continue;
                        }
                        joins.insert(other);
                    }
                    pairs.insert((body.min(other), body.max(other)));
                }
                pairs.extend(
                    core.model.joints.joint_contact_partners(body).map(|other| (body.min(other), body.max(other))),
                );
                let coupled = core.model.couplings_of(body).flatten();
                joins.extend(coupled.copied().filter(|other| instant.bodies.binary_search(other).is_err()));
            }
            if joins.is_empty() {
                return Ok(pairs.into_iter().collect());
            }
            let mut more = self.affected_bodies(core, t, &joins.into_iter().collect::<Vec<_>>())?;
            more.retain(|body| instant.bodies.binary_search(body).is_err());
            let more = self.end_islands(core, t, more)?;
            for &body in &more.bodies {
                self.motions.scratch[body] = self.motions.states[body];
            }
            instant.bodies.extend(more.bodies);
            instant.bodies.sort_unstable();
            instant.pairs.extend(more.pairs);
        }
    }

    /// Sets the bounding box of a body of a crowd: the region it may reach within `h` seconds.
    fn set_crowd_box(&mut self, core: &Core, body: usize, h: f64) {
        let travel = reach(core, &self.motions.states, body, h);
        let shape = core.model.bodies[body].shape.as_ref();
        let aabb =
            shape.map(|shape| aabb_of(shape, &self.motions.states[body].pose).and_then(|aabb| aabb.inflated(travel)));
        self.schedule.set_box(body, aabb.and_then(Result::ok));
    }

    /// Removes the penetration that the time steps of a stretch have left, of all pairs: a step checks only those that
    /// move in it. The removal is booked but is not measured as drift.
    fn remove_overlap_at_end(&mut self, core: &mut Core, instant: &Instant) -> Result<(), SimulationError> {
        let failed = |source: ResponseError| SimulationError::of_response(instant.t, source);
        let overlaps = Overlaps::find(&core.model, &self.motions.states, &instant.pairs);
        if !overlaps.is_excess {
            return Ok(());
        }
        let deepest = overlaps.deepest;
        let before = core.accounts.books.balance(&core.model, &self.motions.states, &instant.bodies);
        let (of, problem) = ((&instant.bodies[..], &instant.pairs[..]), &mut core.memory);
        overlaps.remove(&core.model, &mut self.motions.states, of, problem).map_err(failed)?;
        let after = core.accounts.books.balance(&core.model, &self.motions.states, &instant.bodies);
        let taken_j = core.accounts.books.projection(before, after, 0.0);
        if let Some(id) = deepest {
            core.note_crowd_projection(instant.t, (id.a, id.b), taken_j);
        }
        Ok(())
    }

    /// Ends the time step of a crowd. Then the next step begins, or the stretch ends.
    ///
    /// # Errors
    /// When a time step is not possible, or the instant at the end of the stretch cannot be resolved.
    pub(super) fn next_crowd_step(&mut self, core: &mut Core, first: usize, t: f64) -> Result<(), SimulationError> {
        let bodies = self.motions.island(first).map(|island| island.bodies.clone()).unwrap_or_default();
        let instant = self.end_islands(core, t, bodies)?;
        for &body in &instant.bodies {
            self.motions.scratch[body] = self.motions.states[body];
        }
        let Some(crowd) = self.motions.ongoing_stretch(&instant) else { return Ok(()) };
        if t < crowd.until && !core.is_end_of_run(t) {
            return self.crowd_step(core, instant, crowd);
        }
        self.end_stretch(core, instant)
    }

    /// Ends the stretch for the bodies of an instant: events are located again.
    ///
    /// # Errors
    /// When the instant cannot be resolved.
    fn end_stretch(&mut self, core: &mut Core, mut instant: Instant) -> Result<(), SimulationError> {
        let t = instant.t;
        for &body in &instant.bodies {
            self.motions.tracks[body].mode = Mode::Constrained;
        }
        self.remove_overlap_at_end(core, &instant)?;
        match self.resolve(core, &mut instant) {
            Ok(()) => self.continue_motion(core, instant),
            Err(SimulationError::ContactSolve { .. }) if core.is_end_of_run(t) => {
                // Only the forces of the last instant are unknown, not the motion.
                core.accounts.tolerate(t, "contact forces at the end of the run were not found");
                instant.touches.clear();
                self.continue_motion(core, instant)
            }
            Err(error) => self.begin_stretch_if_unsolved(core, instant, error),
        }
    }
}

impl Motions {
    /// The stretch that bodies of the instant are in, if there is one: of several, their union.
    pub(super) fn ongoing_stretch(&self, instant: &Instant) -> Option<Crowd> {
        let crowds = instant.bodies.iter().filter_map(|&body| match self.tracks[body].mode {
            Mode::Crowded(crowd) => Some(crowd),
            _ => None,
        });
        crowds.reduce(|one, other| one.together_with(&other))
    }

    /// Whether the stretch goes on at `t` (s) for a part of a crowd: the events of one of its bodies crowded.
    fn belongs_to_stretch(&self, bodies: &[usize], t: f64) -> bool {
        let began = |&body: &usize| matches!(self.tracks[body].mode, Mode::Crowded(crowd) if crowd.until > t);
        bodies.iter().any(began)
    }

    /// Makes one time step of a part of a crowd from `t` that ends by `limit` (s), and returns the first body of its
    /// island. Where its step has to be so short that it falls into smaller parts, these are added to `parts` instead.
    fn step_of_part(
        &mut self,
        core: &mut Core,
        part: CrowdPart,
        (t, limit): (f64, f64),
        parts: &mut Vec<CrowdPart>,
    ) -> Result<Option<usize>, SimulationError> {
        let before = stepper(core);
        let start = states_of(&self.states, &part.bodies);
        let mut scratch = std::mem::take(&mut self.scratch);
        let attempted = attempt(core, &mut scratch, &start, &part, (t, limit));
        let states = states_of(&scratch, &part.bodies);
        let stuck = match &attempted {
            Ok(Attempted::Made(made)) => no_way_out(core, &made.report, &scratch, &part.pairs, made.end),
            _ => None,
        };
        self.restore_scratch(core, scratch, &part.bodies);
        if let Some(stuck) = stuck {
            return Err(stuck);
        }
        let Made { end, report, error, next } = match attempted? {
            Attempted::Made(made) => *made,
            Attempted::Divided(smaller) => {
                parts.extend(smaller);
                return Ok(None);
            }
        };
        core.accounts.crowded.step(part.crowd.number, end, &report, error);
        let CrowdPart { bodies, pairs, .. } = part;
        for &body in &bodies {
            let until = match self.tracks[body].mode {
                // Apart from all others it stays for the rest of the stretch of those that it came with.
                _ if pairs.is_empty() => next.until,
                Mode::Crowded(own) => own.until,
                _ => t,
            };
            self.tracks[body].mode = Mode::Crowded(Crowd { until, ..next });
            self.tracks[body].pace = Pace::after_stretch(t);
        }
        let motions = motions((t, &start), (end, &states));
        let step = Box::new(CrowdStep { t, end, start, states, pairs, report, stepper: before, motions });
        let island = Island::beginning(bodies, ActiveContacts::default(), t, Step::Crowd(step));
        Ok(self.insert_island(island))
    }

    /// Repeats the time step of a crowd from its start, bit for bit.
    ///
    /// # Errors
    /// When it is not possible.
    pub(super) fn repeated_crowd_step(
        &mut self,
        core: &Core,
        bodies: &[usize],
        pairs: Vec<(usize, usize)>,
        (t, end): (f64, f64),
    ) -> Result<CrowdStep, SimulationError> {
        let before = stepper(core);
        let mut scratch = std::mem::take(&mut self.scratch);
        let start = states_of(&scratch, bodies);
        let of = (bodies, pairs.as_slice());
        let made = time_step(&core.model, &mut before.clone(), &mut scratch, of, (t, end - t));
        let states = states_of(&scratch, bodies);
        self.restore_scratch(core, scratch, bodies);
        let (report, _) = made.map_err(|source| SimulationError::of_response(t, source))?;
        let motions = motions((t, &start), (end, &states));
        Ok(CrowdStep { t, end, start, states, pairs, report, stepper: before, motions })
    }

    /// Whether another body, whose box overlaps that of a body of a crowd, may touch it within `h` seconds. `seen`
    /// keeps the states of other bodies at `t`.
    ///
    /// # Errors
    /// When the state of the other body cannot be evaluated.
    fn may_join(
        &mut self,
        core: &Core,
        (body, other): (usize, usize),
        (t, h): (f64, f64),
        seen: &mut BTreeMap<usize, BodyState>,
    ) -> Result<bool, SimulationError> {
        if !seen.contains_key(&other) {
            seen.extend(self.states_with(core, other, t)?);
        }
        let state = seen.get(&other).copied().unwrap_or(self.states[other]);
        let mut states = std::mem::take(&mut self.scratch);
        (states[body], states[other]) = (self.states[body], state);
        let joins = may_touch_within(&core.model, &states, (body, other), h);
        self.restore_scratch(core, states, &[body, other]);
        Ok(joins)
    }

    /// States at `t` of the bodies of a crowd's step, and the report of the step up to then.
    pub(super) fn crowd_end(
        &mut self,
        core: &Core,
        step: &CrowdStep,
        bodies: &[usize],
        t: f64,
    ) -> Result<(Vec<BodyState>, TimeStepReport), SimulationError> {
        if t >= step.end {
            return Ok((step.states.clone(), step.report.clone()));
        }
        let mut scratch = std::mem::take(&mut self.scratch);
        let made = step.advance_to(&core.model, bodies, t, &mut scratch);
        let states = states_of(&scratch, bodies);
        self.restore_scratch(core, scratch, bodies);
        made.map(|report| (states, report)).map_err(|source| SimulationError::of_response(step.t, source))
    }
}

/// A time step of a part of a crowd from the states `start` at `t` that ends by `limit` (s): the longest whose error is
/// allowed, or if there is none, that with the least error per time. Where a step has to be shorter, the part may fall
/// into smaller ones. `states` are those at its end, or at its start where none is made.
///
/// # Errors
/// When a time step is not possible.
fn attempt(
    core: &Core,
    states: &mut [BodyState],
    start: &[BodyState],
    part: &CrowdPart,
    (t, limit): (f64, f64),
) -> Result<Attempted, SimulationError> {
    let CrowdPart { bodies, pairs, crowd, .. } = part;
    let mut refused = part.refused;
    let longest = core.settings.step_s;
    let shortest = SHORTEST_STEP * longest * core.settings.crowd_step_factor;
    let before = stepper(core);
    let mut h = crowd.step_s.min(limit - t);
    let mut least: Option<Refused> = None;
    loop {
        set_states(states, bodies, start);
        let mut stepper = before.clone();
        // The length is the difference of the rounded ends, so that the step can be repeated from them exactly.
        let end = if h >= limit - t { limit } else { t + h };
        let made = time_step(&core.model, &mut stepper, states, (bodies, pairs), (t, end - t));
        let (report, error) = made.map_err(|source| SimulationError::of_response(t, source))?;
        let even = EVEN_SHARE * core.settings.crowd_error_allowed() * h / longest;
        let allowed = even.max(SHARE_OF_SPARE * crowd.spare_error);
        let taken = taken_of_limit(core, (bodies, start), &report, even);
        let error = error.max(allowed * taken.max(violation_of_limit(&report)));
        let ratio = if error > 0.0 { SAFETY * (allowed / error).sqrt() } else { f64::INFINITY };
        let rate = error / h;
        let better = least.take_if(|least| error > allowed && h <= shortest && least.rate() < rate);
        if let Some(Refused { h, end, report, error, states: ends }) = better {
            set_states(states, bodies, &ends);
            let next = Crowd { step_s: h, spare_error: 0.0, ..*crowd };
            return Ok(Attempted::Made(Box::new(Made { end, report, error, next })));
        }
        if error <= allowed || h <= shortest {
            let spare_error = (crowd.spare_error - (error - even).max(0.0)).max(0.0);
            let step_s = next_length(h, ratio).max(shortest);
            let next = Crowd { step_s, spare_error, ..*crowd };
            return Ok(Attempted::Made(Box::new(Made { end, report, error, next })));
        }
        if least.as_ref().is_none_or(|least| rate < least.rate()) {
            least = Some(Refused { h, end, report, error, states: states_of(states, bodies) });
        }
        refused += 1;
        h = shorter_length(h, ratio, refused).max(shortest);
        set_states(states, bodies, start);
        let crowd = Crowd { step_s: h, ..*crowd };
        let shorter = CrowdPart { bodies: bodies.clone(), pairs: pairs.clone(), crowd, refused };
        let parts = shorter.divided(&core.model, states);
        if parts.len() > 1 {
            return Ok(Attempted::Divided(parts));
        }
    }
}

/// How far the forces of a time step are beyond what they may violate Coulomb's law by, in such limits; zero within it
/// (no unit). Contact problems that a solver leaves unsolved are others in a shorter step.
fn violation_of_limit(report: &TimeStepReport) -> f64 {
    let of_limit = report.cone_violation.map_or(0.0, |violation| violation.value / CONE_LIMIT);
    if of_limit > 1.0 { of_limit } else { 0.0 }
}

/// The energy that projections and the integrator took in a time step of these bodies from these states, in what they
/// may: `allowed` times the kinetic energy of the bodies and that of lifting them by their size; zero within it (no
/// unit). What they take adds up, always in one direction, and falls with the length of a step also where contacts
/// begin within it, so that no error is spared for it. No energy of the whole run: bodies elsewhere, and samples,
/// change no step.
fn taken_of_limit(
    core: &Core,
    (bodies, start): (&[usize], &[BodyState]),
    report: &TimeStepReport,
    allowed: f64,
) -> f64 {
    let taken = &report.books.ledger;
    let taken_j = taken.projection.value().abs() + taken.numerical.value().abs();
    let gravity = core.model.gravity().length();
    let energy = |(&body, state): (&usize, &BodyState)| {
        let size = core.model.bodies[body].size;
        core.model.bodies[body]
            .rigid
            .as_ref()
            .map_or(0.0, |rigid| rigid.kinetic_energy(state) + rigid.mass() * gravity * size)
    };
    let scale_j: f64 = bodies.iter().zip(start).map(energy).sum();
    let limit_j = allowed * scale_j;
    if taken_j > limit_j && limit_j > 0.0 { taken_j / limit_j } else { 0.0 }
}

/// How far a body in these states may travel within `h` (s), m.
fn reach(core: &Core, states: &[BodyState], body: usize, h: f64) -> f64 {
    let speed = tolerances::point_speed(&core.model, states, body) + core.model.gravity().length() * h;
    tolerances::touch_distance(&core.model, states, body, body) + SWEEP_FACTOR * h * speed
}

/// The error of a time step that ends at `t` (s) with a large remaining penetration in one of `pairs`.
fn no_way_out(
    core: &Core,
    report: &TimeStepReport,
    states: &[BodyState],
    pairs: &[(usize, usize)],
    t: f64,
) -> Option<SimulationError> {
    let overlap =
        |&(a, b): &(usize, usize)| Some((-contact_set::separation_without_memory(&core.model, states, a, b)?, (a, b)));
    let is_large =
        |&(depth, (a, b)): &(f64, (usize, usize))| depth > NO_WAY_OUT * tolerances::pair_size(&core.model, a, b);
    // The remaining penetration bounds that of all pairs, and is usually zero.
    let smallest = pairs.iter().map(|&(a, b)| tolerances::pair_size(&core.model, a, b)).fold(f64::INFINITY, f64::min);
    if report.left_penetration_m <= NO_WAY_OUT * smallest {
        return None;
    }
    let deepest = pairs.iter().filter_map(overlap).filter(is_large).max_by(|x, y| x.0.total_cmp(&y.0));
    deepest.map(|(overlap_m, (a, b))| {
        let [body_a, body_b] = [a, b].map(|body| core.model.bodies[body].name.clone());
        SimulationError::NoWayOut { t_s: t, body_a, body_b, overlap_m }
    })
}
