//! Which integrator moves bodies that no contact holds, and why.
//!
//! | forces besides uniform gravity | integrator |
//! |---|---|
//! | none | closed-form flight (`exact`) |
//! | conservative, no body may collide, at most sixteen splittings a step at the start | `exact-adaptive` |
//! | any others | `dop853` |
//!
//! What a scene asks for is used literally. Splitting costs nothing for the spin, however fast, does not let the energy
//! of a bound motion drift, and leaves an attitude that no torque turns exact; its order is 4, so that forces that are
//! strong within a step are left to DOP853. Both are under error control: a comet that begins far from its sun, where
//! all is slow, is followed by shorter steps near it, and by DOP853 from where a step would need more than 64.

use crate::scene::{Integrator, Tier};
use crate::settings::Settings;
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Account, Dependence};
use polhode_dynamics::integrator::{AdaptiveExact, Integrator as _, Tolerance};

/// Splittings of one step at the most: about what DOP853 spends on a step that it cannot make at once.
const MOST_SPLITTINGS: u32 = 16;

/// Steps from the start over which the splittings are counted.
const TRIAL_STEPS: u32 = 8;

/// The integrator of free motion and the reason.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Choice {
    pub(crate) integrator: Integrator,
    pub(crate) reason: String,
}

/// Chooses for a scene at its start.
pub(crate) fn choose(world: &World, states: &[BodyState], settings: &Settings) -> Choice {
    let choice = |integrator, reason: &str| Choice { integrator, reason: reason.to_owned() };
    match settings.asked_integrator {
        _ if settings.tier == Tier::Stepped => {
            choice(settings.integrator, "the tier's: exact drift, forces as one kick in the middle of the step")
        }
        Some(Integrator::Rk4) if settings.tier == Tier::Accurate && world.may_collide_at_all() => choice(
            Integrator::Rk4,
            "asked for; bodies that contacts hold go by it too, with the contact forces at every stage",
        ),
        Some(integrator) if integrator != Integrator::Dop853 && world.any_coupled_may_collide() => {
            choice(integrator, "asked for; bodies that forces couple and that may collide go by dop853")
        }
        Some(integrator) => choice(integrator, "asked for"),
        None if settings.tier == Tier::Thesis => choice(settings.integrator, "the thesis's"),
        None if !world.has_loads() => {
            choice(Integrator::Exact, "no force but gravity acts between contacts: closed form")
        }
        None if world.has_rows() => {
            choice(Integrator::Dop853, "rows hold bodies at pivots: error control, with the forces of constraint")
        }
        None if !is_conservative(world) => {
            choice(Integrator::Dop853, "forces take or give energy: error control at order 8")
        }
        None if world.may_collide_at_all() => {
            choice(Integrator::Dop853, "forces act on bodies that may collide: error control, with the contact forces")
        }
        None => match splittings(world, states, settings) {
            Some(count) => {
                let reason = format!(
                    "conservative forces: exact flight with kicks under error control, {count} splittings a step at \
                     the start"
                );
                choice(Integrator::ExactAdaptive, &reason)
            }
            None => choice(
                Integrator::Dop853,
                "conservative, but splitting would need more than sixteen steps for one: error control at order 8",
            ),
        },
    }
}

/// Whether all forces derive from potentials that do not depend on time.
fn is_conservative(world: &World) -> bool {
    let fields = world.free_motion().fields();
    fields.iter().all(|field| field.account() == Account::Potential && field.dependence() == Dependence::Poses)
}

/// The most splittings that one of the first steps needs at the tolerance; nothing when they are too many.
fn splittings(world: &World, states: &[BodyState], settings: &Settings) -> Option<u32> {
    let motion = world.free_motion();
    let tolerance = Tolerance::new(settings.tolerance).unwrap_or_default();
    let mut integrator = AdaptiveExact::new(tolerance).limited_to(MOST_SPLITTINGS);
    integrator.start(&motion, 0.0, &world.movable_states(states));
    let mut most = 0;
    for _ in 0..TRIAL_STEPS {
        integrator.step(&motion, settings.step_s).ok()?;
        most = most.max(integrator.inner_steps());
    }
    Some(most)
}
