//! A group over a longest step by DOP853 under error control.
//!
//! At the start of each step the contacts that overlap have springs; those near are watched. The step is attempted
//! until its error is allowed, cut where something happens that it may not pass over (`events`), and then repeated with
//! that length. Errors are allowed in units of the tolerance: of velocities relative to the fastest body of the group,
//! of positions relative to the penetration that the springs keep, since a force follows from it. What rounding of
//! positions makes of forces is allowed too.
//!
//! How it fails: [`SimulationError::StepTooSmall`] where springs are so stiff that no step advances time, and
//! [`SimulationError::TooManyEvents`].

use super::change_modes;
use super::contact::{ContactSpring, Grip, SPRING};
use super::events::{Allowed, Happening, Looking, Passed};
use super::run::{GroupRun, Run, Segment};
use super::system::{DISSIPATION, DISSIPATIONS, SpringSystem};
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances;
use polhode_dynamics::error_allowance::{ErrorAllowance, LargestError};
use polhode_dynamics::state::WIDTH;
use polhode_dynamics::step_control::REFUSED_FACTOR;
use polhode_dynamics::{BodyState, Dop853, RigidBody, System};

/// Steps shorter than this many units in the last place of the time do not advance it.
const TIME_ULPS: f64 = 4.0;

/// Part of the size of the smaller body by which a pair may move against each other in a step, so that no body passes
/// through another unseen (0.1 to 0.5).
const PASSING: f64 = 0.25;

/// Rounding of a position, in units in its last place, that the error of a step may have (1 to 16).
const POSITION_ULPS: f64 = 4.0;

/// What is tracked within one longest step.
#[derive(Debug)]
struct Control {
    /// What has happened at the present time already.
    done: Vec<Happening>,
    /// Since time advanced last.
    still: usize,
    /// In all.
    events: u64,
}

impl Control {
    /// Time has advanced.
    fn advanced(&mut self) {
        self.done.clear();
        self.still = 0;
    }
}

/// Advances the group to `t_end` (s).
///
/// # Errors
/// See the module.
pub(super) fn advance(mut run: Run<'_>, t_end: f64) -> Result<GroupRun, SimulationError> {
    let mut control = Control { done: Vec::new(), still: 0, events: 0 };
    while run.t < t_end {
        let longest = longest(&run, t_end);
        let h = run.done.proposed_s.min(longest);
        let candidates = settle(&mut run, &control.done, h)?;
        let h = h.min(longest_on_springs(&run));
        step(&mut run, &mut control, &candidates, (h, longest, t_end))?;
    }
    Ok(run.finished())
}

/// The longest step from the present (s): bodies do not pass each other.
fn longest(run: &Run<'_>, t_end: f64) -> f64 {
    let model = &run.core.model;
    let own = (t_end - run.t).min(run.core.settings.step_s);
    run.done.group.pairs.iter().fold(own, |longest, &(a, b)| {
        let speed = tolerances::point_speed(model, &run.states, a) + tolerances::point_speed(model, &run.states, b);
        let passing = PASSING * tolerances::pair_size(model, a, b) / speed;
        if passing > 0.0 { longest.min(passing) } else { longest }
    })
}

/// A step times the frequency of a spring (no unit, 1 to 6): in a step that is a thousand times too long the first
/// stages throw the bodies apart, the later ones see no contact, and the error is that of free flight: none.
const MOST_PHASE: f64 = 4.0;

/// The longest step (s) that sees all springs of the group.
fn longest_on_springs(run: &Run<'_>) -> f64 {
    let resting = run.laws.resting_speed(&run.core.model);
    let frequency = |spring: &ContactSpring| {
        let depth = spring.normal.impact_depth(spring.mass, spring.passage.approach.max(resting));
        spring.frequency(depth.max(spring.passage.deepest))
    };
    MOST_PHASE / run.done.springs.iter().map(frequency).fold(0.0, f64::max)
}

/// Gives contacts that overlap springs, takes away those whose features have gone, and returns the other contacts near.
/// One that was found to end at this instant does not begin again.
fn settle(run: &mut Run<'_>, done: &[Happening], h: f64) -> Result<Vec<ContactId>, SimulationError> {
    let near = run.near(h);
    let gone: Vec<ContactId> = run.done.springs.iter().map(|spring| spring.id).collect();
    let gone = gone.into_iter().filter(|id| near.binary_search_by_key(id, |(known, _)| *known).is_err());
    let gone: Vec<ContactId> = gone.collect();
    let mut begun = Vec::new();
    let mut candidates = Vec::new();
    for (id, kinematics) in &near {
        if run.done.springs.binary_search_by_key(id, |known| known.id).is_ok() {
            continue;
        }
        let separation = kinematics.geometry.separation;
        let rounding = tolerances::rounding(&run.core.model, &run.states, id.a, id.b);
        let touches = separation <= rounding && kinematics.separation_rate <= 0.0;
        let has_ended = done.contains(&Happening::End(*id));
        if (touches || separation < -rounding) && !has_ended {
            begun.push(run.begun(*id, kinematics)?);
        } else {
            candidates.push(*id);
        }
    }
    if !(gone.is_empty() && begun.is_empty()) {
        let before = run.energy();
        for id in gone {
            run.remove_now(id);
        }
        for spring in begun {
            run.insert(&spring);
        }
        let lost = before - run.energy();
        run.done.books.ledger.numerical.add(lost);
    }
    Ok(candidates)
}

/// One step of the group: to its first event at most.
fn step(
    run: &mut Run<'_>,
    control: &mut Control,
    candidates: &[ContactId],
    (h, longest, t_end): (f64, f64, f64),
) -> Result<(), SimulationError> {
    let springs = run.done.springs.clone();
    let bodies = run.done.group.bodies.clone();
    let (core, about, t) = (run.core, run.done.books.ledger.momentum.about, run.t);
    core.model.work.check(t)?;
    let mut states = run.states.clone();
    let mut system =
        SpringSystem { model: &core.model, bodies: &bodies, springs: &springs, about, states: &mut states };
    let flat = system.pack();
    let mut method = Dop853::new(system.dimension());
    let smallest = TIME_ULPS * f64::EPSILON * t.abs().max(core.settings.step_s * f64::EPSILON);
    let mut h = h;
    let sliding_at_start = sliding_forces(&mut system, t, &flat);
    let error = loop {
        let Ok(()) = method.attempt_unscaled(&mut system, t, &flat, h);
        let mut sliding = sliding_forces(&mut system, t + h, method.end_state());
        sliding.iter_mut().zip(&sliding_at_start).for_each(|(end, start)| *end = end.max(*start));
        let error = largest_error(run, &method, (&springs, candidates), &sliding);
        if error <= 1.0 {
            break error;
        }
        let shorter = h * Dop853::next_step_factor(error).min(REFUSED_FACTOR);
        if shorter.is_nan() || shorter <= smallest {
            return Err(SimulationError::StepTooSmall { t_s: t, smallest_s: smallest, bodies: Vec::new() });
        }
        h = shorter;
    };
    let next = h * Dop853::next_step_factor(error);
    run.done.proposed_s = if h >= longest { next.max(run.done.proposed_s) } else { next };
    run.done.largest_error = Some(run.done.largest_error.unwrap_or(0.0).max(error));
    let Ok(mut dense) = method.dense(&mut system);
    let allowed = allowances(run, &method, (&springs, candidates)).least();
    let (laws, done) = (run.laws, control.done.as_slice());
    let shortest = smallest;
    let seen = Looking { system: &mut system, dense: &dense, laws, candidates, allowed, done, shortest }.seen();
    let Some((t_event, what)) = seen.first else {
        let end = if h >= t_end - t { t_end } else { t + h };
        run.done.segments.push(Segment { dense, springs });
        run.note_peaks(&seen.peaks);
        run.commit(&flat, method.end_state().to_vec(), end);
        control.advanced();
        return change_modes::make(run, &seen.passed);
    };
    control.events += 1;
    let cut = t_event - t;
    if cut > smallest {
        let Ok(()) = method.attempt_unscaled(&mut system, t, &flat, cut);
        let Ok(shorter) = method.dense(&mut system);
        dense = shorter;
        run.done.segments.push(Segment { dense, springs });
        run.note_peaks(&seen.peaks);
        run.commit(&flat, method.end_state().to_vec(), t_event);
        control.advanced();
    }
    control.done.push(what);
    control.still += 1;
    let most = run.core.settings.max_events_per_step;
    if control.events > most || control.still > STILL_PER_CONTACT * (1 + run.done.springs.len() + candidates.len()) {
        return Err(SimulationError::TooManyEvents { limit: most, t_s: run.t });
    }
    change_modes::make(run, &[Passed { what, t_s: run.t, rate: change_modes::rate(run, what) }])
}

/// Events without time passing, for each contact: each of its signals may change twice.
const STILL_PER_CONTACT: usize = 16;

/// What a step may err by.
#[derive(Debug)]
struct Allowances {
    /// Of each body of the group that forces move: its place in the group.
    bodies: Vec<(usize, ErrorAllowance)>,
    /// The greatest speed, m/s.
    speed: f64,
}

impl Allowances {
    /// The least of all bodies.
    fn least(&self) -> Allowed {
        let least =
            |of: fn(&ErrorAllowance) -> f64| self.bodies.iter().map(|(_, own)| of(own)).fold(f64::INFINITY, f64::min);
        Allowed { position: least(|own| own.position), velocity: least(|own| own.velocity) }
    }
}

/// What an attempt may err by.
fn allowances(run: &Run<'_>, method: &Dop853, (springs, candidates): (&[ContactSpring], &[ContactId])) -> Allowances {
    let model = &run.core.model;
    let tolerance = STEP_SHARE * run.core.settings.tolerance;
    let bodies = &run.done.group.bodies;
    let end = method.end_state();
    let ends = end.as_chunks::<WIDTH>().0.iter().map(BodyState::from_array);
    let speed_at_end = bodies.iter().zip(ends).map(|(&body, state)| {
        let velocity = model.velocity(body, &state);
        tolerances::fastest_point(model, body, &velocity)
    });
    let speeds = bodies.iter().map(|&body| tolerances::point_speed(model, &run.states, body)).chain(speed_at_end);
    let speed = speeds.fold(run.laws.resting_speed(model), f64::max);
    let near_contact = !(springs.is_empty() && candidates.is_empty());
    let frequency = springs.iter().map(|spring| spring.frequency(run.laws.depth_m)).fold(0.0, f64::max);
    let of_body = |(index, &body): (usize, &usize)| {
        let rigid = model.bodies[body].rigid.as_ref()?;
        let size = model.bodies[body].size.max(f64::MIN_POSITIVE);
        let length = if near_contact { run.laws.depth_m.min(size) } else { size };
        let coordinate = run.states[body].pose.translation.abs().max_element() + size;
        let rounding = POSITION_ULPS * f64::EPSILON * coordinate;
        let position = tolerance * length + rounding;
        let velocity = tolerance * speed + rounding * frequency;
        let allowance = ErrorAllowance {
            position,
            quaternion: ErrorAllowance::of_angle(position / size + POSITION_ULPS * f64::EPSILON),
            velocity,
            angular_momentum: velocity * rigid.moments().max_element() / size,
        };
        Some((index, allowance))
    };
    Allowances { bodies: bodies.iter().enumerate().filter_map(of_body).collect(), speed }
}

/// The forces of the tangential springs that give way (N), zero for others; none where there are no such springs.
fn sliding_forces(system: &mut SpringSystem<'_>, t: f64, flat: &[f64]) -> Vec<f64> {
    let springs = system.springs;
    if !springs.iter().any(ContactSpring::slides) {
        return Vec::new();
    }
    system.set_states(t, flat);
    let of = |spring: &ContactSpring| {
        let at = if spring.slides() { system.evaluated(spring) } else { None };
        at.map_or(0.0, |at| spring.limit(spring.normal_force(&at)).max(0.0))
    };
    springs.iter().map(of).collect()
}

/// The largest error of an attempt in units of what is allowed; `sliding` are the forces of springs that give way, the
/// greater ones of both ends.
fn largest_error(
    run: &Run<'_>,
    method: &Dop853,
    (springs, candidates): (&[ContactSpring], &[ContactId]),
    sliding: &[f64],
) -> f64 {
    let model = &run.core.model;
    let tolerance = STEP_SHARE * run.core.settings.tolerance;
    let bodies = &run.done.group.bodies;
    let allowances = allowances(run, method, (springs, candidates));
    let speed = allowances.speed;
    let mut largest = LargestError::default();
    for &(index, allowance) in &allowances.bodies {
        largest.include_body(method, index * WIDTH, allowance);
    }
    for (index, spring) in springs.iter().enumerate() {
        let first = bodies.len() * WIDTH + index * SPRING;
        let force = spring.normal.elastic_force(run.laws.depth_m);
        // Of a direction of sliding its force counts: that of a point without load directs none.
        let scale = match sliding.get(index) {
            Some(own) if spring.slides() => force / own,
            _ => force,
        };
        largest.include(method.error_of(first..first + VECTOR), tolerance * scale);
        if spring.grip == Grip::Yield {
            largest.include(method.error_of(first + VECTOR..first + SPRING), tolerance * spring.holding.weakening);
        }
    }
    // What dampers and friction take is booked as exactly as the motion.
    let mass: f64 = bodies.iter().filter_map(|&body| model.bodies[body].rigid.as_ref()).map(RigidBody::mass).sum();
    let first = bodies.len() * WIDTH + springs.len() * SPRING + DISSIPATION;
    if !springs.is_empty() {
        largest.include(method.error_of(first..first + DISSIPATIONS), tolerance * mass * speed * speed);
    }
    largest.get()
}

/// Numbers of a spring that are those of its vector.
const VECTOR: usize = 3;

/// Part of the tolerance that one step may err by: an impact takes some ten to a hundred of them (0.01 to 1).
const STEP_SHARE: f64 = 0.1;
