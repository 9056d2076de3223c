//! Choice of the integrator for bodies without active contacts, with its reason.
//!
//! | forces besides uniform gravity | integrator |
//! |---|---|
//! | none | closed-form flight (`exact`) |
//! | conservative, no body may collide, at most sixteen splittings a step at the start | `exact-adaptive` |
//! | any others | `dop853` |
//!
//! An integrator that the scene names is used, except in a tier that has its own (`stepped`), and for coupled bodies
//! that may collide, which `dop853` integrates unless the scene names `rk4`. Splitting integrates free rotation
//! exactly, however fast the spin, and the energy of a bound motion does not drift. Its order is 4, so that DOP853 is
//! better for forces that change much within a step. Both are under error control: for a comet that starts far from its
//! sun the splitting takes shorter steps near the sun, and where a step would need more than 64 splittings DOP853 takes
//! over.

use crate::model::Model;
use crate::scene::Integrator;
use crate::tier::facts::IntegratorChoice;
use crate::tier::settings::Settings;
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Account, Dependence};
use polhode_dynamics::integrator::{AdaptiveExact, Integrator as _, Tolerance};

/// Largest number of splittings of one step at the start: they cost about as much as a step of DOP853 that error
/// control shortens.
pub(crate) const MOST_SPLITTINGS: u32 = 16;

/// Number of trial steps from the start in which the splittings are counted.
const TRIAL_STEPS: u32 = 8;

/// The integrator of free motion and the reason.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Choice {
    pub(crate) integrator: Integrator,
    pub(crate) reason: String,
}

/// Chooses the integrator for a scene in these states.
pub(crate) fn choose(model: &Model, states: &[BodyState], settings: &Settings) -> Choice {
    let choice = |integrator, reason: &str| Choice { integrator, reason: reason.to_owned() };
    let named = match (settings.tier.facts().integrator_choice, settings.named_integrator) {
        (IntegratorChoice::Tier { reason, .. }, _) | (IntegratorChoice::Scene { reason }, None) => {
            return choice(settings.integrator, reason);
        }
        (_, named) => named,
    };
    match named {
        Some(Integrator::Rk4) if settings.constrains_by_rk4() && model.surfaces.may_collide() => choice(
            Integrator::Rk4,
            "the scene names it; it integrates constrained motion too, with the contact forces at every stage",
        ),
        Some(integrator) if integrator != Integrator::Dop853 && model.any_coupled_may_collide() => {
            choice(integrator, "the scene names it; dop853 integrates bodies that forces couple and that may collide")
        }
        Some(integrator) => choice(integrator, "the scene names it"),
        None if !model.has_loads() => {
            choice(Integrator::Exact, "no force but gravity acts between contacts: closed form")
        }
        None if model.joints.has_rows() => choice(
            Integrator::Dop853,
            "bodies are held at pivots or joints: error control, with the forces of constraint at every stage",
        ),
        None if !is_conservative(model) => {
            choice(Integrator::Dop853, "forces take or give energy: error control at order 8")
        }
        None if model.surfaces.may_collide() => choice(
            Integrator::Dop853,
            "forces act on bodies that may collide: error control, with the contact forces at every stage",
        ),
        None => match splittings(model, states, settings) {
            Some(count) => {
                let reason = format!(
                    "conservative forces: exact flight with kicks under error control, {count} splittings a step at \
                     the start"
                );
                choice(Integrator::ExactAdaptive, &reason)
            }
            None => choice(
                Integrator::Dop853,
                "conservative forces, but a step would need more than sixteen splittings: error control at order 8",
            ),
        },
    }
}

/// Whether all forces derive from potentials that do not depend on time.
fn is_conservative(model: &Model) -> bool {
    let fields = model.free_motion().fields();
    fields.iter().all(|field| field.account() == Account::Potential && field.dependence() == Dependence::Poses)
}

/// Largest number of splittings that one of the trial steps needs at the tolerance; none when they are more than
/// [`MOST_SPLITTINGS`].
fn splittings(model: &Model, states: &[BodyState], settings: &Settings) -> Option<u32> {
    let motion = model.free_motion();
    let tolerance = Tolerance::new(settings.tolerance).unwrap_or_default();
    let mut integrator = AdaptiveExact::new(tolerance).limited_to(MOST_SPLITTINGS);
    integrator.start(&motion, 0.0, &model.movable_states(states));
    let mut most = 0;
    for _ in 0..TRIAL_STEPS {
        integrator.step(&motion, settings.step_s).ok()?;
        most = most.max(integrator.inner_steps());
    }
    Some(most)
}
