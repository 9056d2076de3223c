//! Which integrator moves bodies that no contact holds, and why.
//!
//! | forces besides uniform gravity | integrator |
//! |---|---|
//! | none | closed-form flight (`exact`) |
//! | the torque of gravity on fast tops | splitting: exact drift with kicks of order 4 (`exact`) |
//! | any others | DOP853 under error control |
//!
//! What a scene asks for is used literally. Splitting costs nothing for the spin, however fast, and keeps the energy of a
//! conservative motion from drifting, but its step is fixed: it is chosen only where the error of a step at the start
//! bounds that of all others. That is so where the torque is bounded by `m g r` everywhere and the spin is fast against
//! what it does, `|L| >= 20 sqrt(I m g r)`. Where forces vary along the motion it is not: a comet that begins far from
//! its sun, where all is slow, would be lost near it.

use crate::scene::{Integrator, Tier};
use crate::settings::Settings;
use crate::world::World;
use polhode_dynamics::integrator::{Exact, Integrator as _};
use polhode_dynamics::{BodyState, FreeMotion};

/// A top is fast when its angular momentum is this many times what its weight could give it in one swing.
const FAST_SPIN: f64 = 20.0;

/// Share of the tolerance that one step of splitting may use: its step is fixed, and the errors of hundreds of steps
/// add up.
const STEP_SHARE: f64 = 1e-2;

/// Halvings of the step that splitting may take: sixteen steps are what DOP853 spends on one at most.
const MOST_HALVINGS: u32 = 4;

/// Steps from the start over which the error is measured.
const TRIAL_STEPS: u32 = 8;

/// What the difference from two steps of half the length falls short of the error, at order 4.
const RICHARDSON: f64 = 16.0 / 15.0;

/// The integrator of free motion, its step and the reason.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Choice {
    pub(crate) integrator: Integrator,
    pub(crate) step_s: f64,
    pub(crate) reason: String,
}

/// Chooses for a scene at its start.
pub(crate) fn choose(world: &World, states: &[BodyState], settings: &Settings) -> Choice {
    let choice = |integrator, reason: &str| Choice { integrator, step_s: settings.step_s, reason: reason.to_owned() };
    match settings.asked_integrator {
        Some(integrator) => choice(integrator, "asked for"),
        None if settings.tier == Tier::Thesis => choice(settings.integrator, "the thesis's"),
        None if !world.free_motion().has_loads() => {
            choice(Integrator::Exact, "no force but gravity acts between contacts: closed form")
        }
        None if world.has_fields() || world.may_collide_at_all() => {
            choice(Integrator::Dop853, "forces vary along the motion: error control")
        }
        None if !all_fast(world, states) => {
            choice(Integrator::Dop853, "gravity turns pivoted bodies as fast as they spin: error control")
        }
        None => splitting(world, states, settings).unwrap_or_else(|| {
            choice(Integrator::Dop853, "splitting would need more than sixteen steps for one: error control")
        }),
    }
}

/// Whether every body under the torque of gravity spins fast against what the torque does.
fn all_fast(world: &World, states: &[BodyState]) -> bool {
    let gravity = world.gravity().length();
    world.movable.iter().filter(|&&body| world.is_loaded(body)).all(|&body| {
        world.bodies[body].rigid.as_ref().is_some_and(|rigid| {
            let torque = rigid.mass() * gravity * rigid.arm().length();
            let swing = (rigid.moments().max_element() * torque).sqrt();
            states[body].angular_momentum.length() >= FAST_SPIN * swing
        })
    })
}

/// Splitting with the longest step that reaches the tolerance; nothing when none does.
fn splitting(world: &World, states: &[BodyState], settings: &Settings) -> Option<Choice> {
    let (motion, movable) = (world.free_motion(), world.movable_states(states));
    (0..=MOST_HALVINGS).find_map(|halvings| {
        let step_s = settings.step_s / f64::from(1_u32 << halvings);
        let error = splitting_error(&motion, &movable, step_s);
        let reason = format!("fast tops: exact drift with kicks, which err by {error:.1e} rad in a step of {step_s} s");
        let reached = error <= STEP_SHARE * settings.tolerance;
        reached.then_some(Choice { integrator: Integrator::Exact, step_s, reason })
    })
}

/// Error of a step of splitting, rad: infinite where it cannot be made.
fn splitting_error(motion: &FreeMotion<'_>, states: &[BodyState], step_s: f64) -> f64 {
    let end = |step_s: f64, count: u32| {
        let mut integrator = Exact::blanes_moan();
        integrator.start(motion, 0.0, states);
        for _ in 0..count {
            integrator.step(motion, step_s).ok()?;
        }
        Some(integrator.states().to_vec())
    };
    let (Some(coarse), Some(fine)) = (end(step_s, TRIAL_STEPS), end(0.5 * step_s, 2 * TRIAL_STEPS)) else {
        return f64::INFINITY;
    };
    let angles = coarse.iter().zip(&fine).map(|(a, b)| a.pose.rotation.angle_to(b.pose.rotation));
    let worst = angles.fold(0.0f64, |worst, angle| if angle.is_nan() { f64::INFINITY } else { worst.max(angle) });
    RICHARDSON * worst / f64::from(TRIAL_STEPS)
}
