//! A group over a longest step by fixed steps, of an integrator that the scene names: `rk4`, `semi-implicit-euler`,
//! `implicit-midpoint`.
//!
//! Nothing is located: at every stage contacts that overlap push, those that do not do not. A tangential spring is cut
//! to Coulomb's limit at the end of a step (return mapping), and its force at every stage: to that at rest, and once
//! it has slipped by its stretch to that of sliding, until a step ends within it. The step is that of the scene;
//! without one it is [`STEPS_PER_CONTACT`] to the half period of the fastest spring near.
//!
//! Explicit steps are stable up to `h w = 2` (semi-implicit Euler) and 2.78 (RK4) on a spring, and a damper's rate
//! c/m counts as a frequency; a longer step is refused with the step that would do. The implicit midpoint rule has no
//! such bound: it is solved by Newton's method (`implicit`). Semi-implicit Euler books its work at the start of a step,
//! so that its numerical error shows in the ledger. Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.6 (the
//! cubic polynomial that gives samples within a step). How it fails: [`SimulationError::StepTooLong`].

use super::contact::{ContactSpring, Evaluated, Grip, Push};
use super::implicit;
use super::run::{GroupRun, Run, Segment};
use super::system::SpringSystem;
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances;
use crate::model::tolerances::SAME_TIME_RELATIVE;
use crate::report::event::EventKind;
use crate::scene::Integrator;
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, QUATERNION, WIDTH};
use polhode_dynamics::{DenseStep, System, rk4};

/// Steps in half a period of the fastest spring when the scene gives no step (10 to 100).
const STEPS_PER_CONTACT: f64 = 40.0;

/// Bound of stability of a step times a frequency (no unit).
const BOUND_OF_RK4: f64 = 2.78;
const BOUND_OF_EULER: f64 = 2.0;

/// Whether an integrator makes fixed steps.
pub(super) fn is_fixed(integrator: Integrator) -> bool {
    integrator != Integrator::Dop853
}

/// Advances the group to `t_end` (s).
///
/// # Errors
/// When a step is too long for the springs, or Newton's method does not converge.
pub(super) fn advance(mut run: Run<'_>, t_end: f64) -> Result<GroupRun, SimulationError> {
    while run.t < t_end {
        let asked = run.core.settings.step_s.min(t_end - run.t);
        gather(&mut run, asked)?;
        let rate = run.done.springs.iter().map(|spring| stiffest_rate(&run, spring)).fold(0.0, f64::max);
        let h = length(&run, rate)?;
        let left = t_end - run.t;
        let (h, end) = if h * (1.0 + SAME_TIME_RELATIVE) >= left { (left, t_end) } else { (h, run.t + h) };
        step(&mut run, h, end)?;
        release(&mut run);
    }
    Ok(run.finished())
}

/// Frequency or rate of decay (1/s) of a spring at the depth that its impact reaches.
fn stiffest_rate(run: &Run<'_>, spring: &ContactSpring) -> f64 {
    let speed = spring.passage.approach.max(run.laws.resting_speed(&run.core.model));
    let depth = spring.normal.impact_depth(spring.mass, speed).max(spring.passage.deepest);
    spring.frequency(depth).max(spring.normal.damper(depth) / spring.mass)
}

/// Length of the next step (s), where springs have this rate (1/s).
fn length(run: &Run<'_>, rate: f64) -> Result<f64, SimulationError> {
    let settings = &run.core.settings;
    if !settings.step_is_given {
        let own = std::f64::consts::PI / (STEPS_PER_CONTACT * rate);
        let own = if own > 0.0 { settings.step_s.min(own) } else { settings.step_s };
        return Ok(own.max(CLOSING_PART * time_to_contact(run)).min(settings.step_s));
    }
    let bound = match settings.integrator {
        Integrator::Rk4 => BOUND_OF_RK4,
        Integrator::ImplicitMidpoint => f64::INFINITY,
        _ => BOUND_OF_EULER,
    };
    let limit_s = bound / rate;
    if settings.step_s > limit_s {
        return Err(SimulationError::StepTooLong { t_s: run.t, step_s: settings.step_s, limit_s, rate });
    }
    Ok(settings.step_s)
}

/// Part of the time to the next contact that a step may take before it begins (0.1 to 0.9).
const CLOSING_PART: f64 = 0.5;

/// The least time (s) in which bodies at their present speeds may come to overlap at a contact near; zero where one
/// does.
fn time_to_contact(run: &Run<'_>) -> f64 {
    let model = &run.core.model;
    let of = |spring: &ContactSpring| {
        let gap = run.evaluated(spring).map_or(0.0, |at| -at.depth).max(0.0);
        let speed = tolerances::point_speed(model, &run.states, spring.id.a)
            + tolerances::point_speed(model, &run.states, spring.id.b);
        if gap > 0.0 { gap / speed } else { 0.0 }
    };
    run.done.springs.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// Gives all contacts near springs, those that do not touch too, and takes away those whose features have gone.
fn gather(run: &mut Run<'_>, h: f64) -> Result<(), SimulationError> {
    let near = run.near(h);
    let known: Vec<ContactId> = run.done.springs.iter().map(|spring| spring.id).collect();
    let gone = known.iter().filter(|id| near.binary_search_by_key(*id, |(known, _)| *known).is_err());
    let gone: Vec<ContactId> = gone.copied().collect();
    let before = if gone.is_empty() { 0.0 } else { run.energy() };
    let has_gone = !gone.is_empty();
    for id in gone {
        run.remove_now(id);
    }
    for (id, kinematics) in &near {
        let Err(place) = run.done.springs.binary_search_by_key(id, |known| known.id) else { continue };
        let mut spring = run.begun(*id, kinematics)?;
        if spring.grip != Grip::Free {
            spring.grip = Grip::Cut;
            spring.vector = polhode_spatial::DVec3::ZERO;
        }
        spring.push = Push::Cut;
        spring.passage.deepest = 0.0;
        run.done.springs.insert(place, spring);
    }
    if has_gone {
        let lost = before - run.energy();
        run.done.books.ledger.numerical.add(lost);
    }
    Ok(())
}

/// One step of `h` (s), which ends at `end` (s).
fn step(run: &mut Run<'_>, h: f64, end: f64) -> Result<(), SimulationError> {
    let (springs, bodies) = (run.done.springs.clone(), run.done.group.bodies.clone());
    let (core, about, t) = (run.core, run.done.books.ledger.momentum.about, run.t);
    let mut states = run.states.clone();
    let mut system =
        SpringSystem { model: &core.model, bodies: &bodies, springs: &springs, about, states: &mut states };
    let flat = system.pack();
    let mut after = flat.clone();
    match core.settings.integrator {
        Integrator::Rk4 => {
            let Ok(()) = rk4::step(&mut system, t, h, &mut after);
        }
        Integrator::ImplicitMidpoint => implicit::step(&mut system, run.laws, (t, h), &mut after)?,
        _ => semi_implicit_euler(&mut system, t, h, &mut after),
    }
    let dense = cubic(&mut system, (t, h), &flat, &after);
    run.done.segments.push(Segment { dense, springs: springs.clone() });
    let begins: Vec<ContactId> =
        springs.iter().filter(|spring| spring.passage.deepest == 0.0).map(|spring| spring.id).collect();
    run.commit(&flat, after, end);
    let held = run.energy();
    for index in 0..run.done.springs.len() {
        let spring = run.done.springs[index];
        if let (Grip::Cut | Grip::CutSliding, Some(at)) = (spring.grip, run.evaluated(&spring)) {
            run.done.springs[index] = returned(&spring, &at);
        }
        if spring.passage.deepest > 0.0 && begins.contains(&spring.id) {
            run.note_event(EventKind::ContactBegin, &spring);
        }
    }
    // What springs give up where static friction becomes kinetic.
    let given_up = held - run.energy();
    run.done.books.ledger.friction.add(given_up);
    Ok(())
}

/// A tangential spring that is cut, as a step ends in this state.
fn returned(spring: &ContactSpring, at: &Evaluated) -> ContactSpring {
    let normal = spring.normal_force(at);
    let beyond = spring.vector.length() - spring.limit(normal);
    if beyond <= 0.0 {
        return ContactSpring { grip: Grip::Cut, slipped: 0.0, ..*spring };
    }
    let stiffness = spring.tangential.stiffness(at.depth);
    let slipped = spring.slipped + if stiffness > 0.0 { beyond / stiffness } else { 0.0 };
    let grip = if slipped > spring.holding.weakening { Grip::CutSliding } else { Grip::Cut };
    let spring = ContactSpring { grip, slipped, ..*spring };
    ContactSpring { vector: spring.vector.clamp_length_max(spring.limit(normal)), ..spring }
}

/// Drops springs of contacts that do not overlap.
fn release(run: &mut Run<'_>) {
    let open: Vec<ContactSpring> = run.done.springs.clone();
    for spring in open {
        if run.evaluated(&spring).is_some_and(|at| at.depth > 0.0) {
            continue;
        }
        if spring.passage.deepest > 0.0 {
            run.remove_now(spring.id);
        } else {
            run.done.springs.retain(|known| known.id != spring.id);
        }
    }
}

/// New velocities from the forces of the start, then new poses from the new velocities.
fn semi_implicit_euler(system: &mut SpringSystem<'_>, t: f64, h: f64, state: &mut [f64]) {
    let bodies = system.bodies.len() * WIDTH;
    let mut rates = vec![0.0; state.len()];
    let Ok(()) = system.derivative(t, state, &mut rates);
    for (index, (number, rate)) in state.iter_mut().zip(&rates).enumerate() {
        let is_velocity = index >= bodies || index % WIDTH >= LINEAR_VELOCITY;
        if is_velocity {
            *number += h * rate;
        }
    }
    let Ok(()) = system.derivative(t, state, &mut rates);
    for (body, rate) in
        state.as_chunks_mut::<WIDTH>().0.iter_mut().zip(rates.as_chunks::<WIDTH>().0).take(bodies / WIDTH)
    {
        for (number, rate) in body[..LINEAR_VELOCITY].iter_mut().zip(&rate[..LINEAR_VELOCITY]) {
            *number += h * rate;
        }
    }
    system.normalize(state);
}

/// States within a step: the cubic polynomials through states and rates at both ends.
fn cubic(system: &mut SpringSystem<'_>, (t, h): (f64, f64), start: &[f64], end: &[f64]) -> DenseStep {
    let rates_at = |system: &mut SpringSystem<'_>, t: f64, state: &[f64]| {
        let mut rates = vec![0.0; state.len()];
        let Ok(()) = system.derivative(t, state, &mut rates);
        rates
    };
    let (first, last) = (rates_at(system, t, start), rates_at(system, t + h, end));
    let dense = DenseStep::through_values::<std::convert::Infallible>(t, h, |x| {
        let component = |i: usize| {
            let change = end[i] - start[i];
            let bend = (x - 1.0) * ((1.0 - 2.0 * x) * change + (x - 1.0) * h * first[i] + x * h * last[i]);
            (1.0 - x) * start[i] + x * end[i] + x * bend
        };
        Ok((0..start.len()).map(component).collect())
    });
    let Ok(dense) = dense;
    dense
}

/// Where the numbers of a body that are no velocities end, and those of its rotation begin.
const _: () = assert!(QUATERNION < LINEAR_VELOCITY && LINEAR_VELOCITY < ANGULAR_MOMENTUM);
