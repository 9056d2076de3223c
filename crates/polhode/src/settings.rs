//! The numbers a run is governed by, resolved from the scene's method and the defaults of its tier.

use crate::scene::{
    BroadPhaseMethod, ContactMethod, Crowding, ImpactLaw, Integrator, Method, Orientation, RotationRate, Tier,
};
use polhode_dynamics::integrator::{self, MethodSettings, Tolerance};

/// Upper bound of a step when none is given, s; the step of tier `thesis`.
const DEFAULT_STEP_S: f64 = 0.01;

/// Step of tier `stepped` when none is given, s: bodies of tenths of a metre that fall for a second move by a hundredth
/// of their size in it, and bounces that last less than two steps have speeds below 0.02 m/s.
const DEFAULT_TIME_STEP_S: f64 = 1e-3;

/// Local error of a step in a contact phase when none is given, relative to size and speed (dimensionless).
const DEFAULT_TOLERANCE: f64 = 1e-11;

/// What projections may move or take at the default tolerance, in units of it (dimensionless, 1 to 100). The error of a
/// step is a part of the tolerance and touch is of its order; putting contacts that lie close together exactly in place
/// turns a body by some times more.
const DRIFT_FACTOR: f64 = 10.0;

/// Error of a stretch of crowded events when none is given, relative to the size of a body (dimensionless).
const DEFAULT_CROWDING_TOLERANCE: f64 = 1e-6;
/// Penetration that `accurate` promises to stay below at the default tolerance and tighter ones, relative to the size
/// of the smaller body: where contacts close is located far below it whatever the tolerance.
const PENETRATION_RELATIVE: f64 = 1e-12;

/// Events in one step when no cap is given.
const DEFAULT_MAX_EVENTS_PER_STEP: u64 = 1_000_000;

/// Every knob, decided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Settings {
    pub(crate) tier: Tier,
    pub(crate) integrator: Integrator,
    /// What the scene asks for.
    pub(crate) asked_integrator: Option<Integrator>,
    pub(crate) orientation: Orientation,
    pub(crate) rotation_rate: RotationRate,
    pub(crate) impact: ImpactLaw,
    pub(crate) contact: ContactMethod,
    pub(crate) broad_phase: BroadPhaseMethod,
    pub(crate) step_s: f64,
    /// Whether the scene asks for that step.
    pub(crate) step_is_asked: bool,
    pub(crate) tolerance: f64,
    pub(crate) max_events_per_step: u64,
    pub(crate) crowding: Crowding,
    /// Error of a stretch of crowded events per longest step, relative to the size of each body.
    pub(crate) crowding_tolerance: f64,
}

impl Settings {
    /// Whether bodies that nothing loads follow their flight records.
    pub(crate) fn flies(&self) -> bool {
        self.tier == Tier::Stepped
            || self.tier == Tier::Accurate
                && match self.integrator {
                    // Chosen for bodies under forces, it leaves the others their flight; asked for, it moves all.
                    Integrator::Dop853 => self.asked_integrator.is_none(),
                    integrator => integrator.is_exact_without_loads(),
                }
    }

    /// Whether bodies that contacts or pivots hold are integrated by the classical method of order 4 at the fixed step,
    /// because the scene asks for it, and not by DOP853 under error control.
    pub(crate) fn constrains_by_rk4(&self) -> bool {
        self.tier == Tier::Accurate && self.asked_integrator == Some(Integrator::Rk4)
    }

    /// Penetration that the tier promises to stay below, relative to the size of the smaller body of a pair; none where
    /// it promises nothing. A tolerance above the default is the promise itself: errors of that size decide where held
    /// contacts go within a step.
    pub(crate) fn promised_penetration(&self) -> Option<f64> {
        match self.tier {
            Tier::Thesis | Tier::Stepped => None,
            Tier::Accurate if self.tolerance > DEFAULT_TOLERANCE => Some(self.tolerance),
            Tier::Accurate => Some(PENETRATION_RELATIVE),
        }
    }

    /// What projections may move a body by or take, as a fraction of the size of its pair or of the energy of the scene
    /// (dimensionless); none for a tier that promises nothing, and for a method whose error is known by its
    /// step alone.
    pub(crate) fn promised_drift(&self) -> Option<f64> {
        match self.tier {
            Tier::Thesis | Tier::Stepped => None,
            Tier::Accurate if self.constrains_by_rk4() => None,
            Tier::Accurate => Some(self.tolerance.max(DRIFT_FACTOR * DEFAULT_TOLERANCE)),
        }
    }

    /// What a step of constrained motion errs by at the most (dimensionless): the tolerance under error control,
    /// anything by a method whose error is known by its step.
    pub(crate) fn step_error(&self) -> f64 {
        if self.constrains_by_rk4() { f64::INFINITY } else { self.tolerance }
    }

    /// Whether splitting under error control is the plan's choice, not the scene's.
    pub(crate) fn splits_by_choice(&self) -> bool {
        self.asked_integrator.is_none() && self.integrator == Integrator::ExactAdaptive
    }

    /// The settings as they were before the plan chose an integrator.
    pub(crate) fn as_resolved(self) -> Self {
        let chosen = match self.tier {
            Tier::Thesis | Tier::Stepped => self.integrator,
            Tier::Accurate => self.asked_integrator.unwrap_or(Integrator::Exact),
        };
        Self { integrator: chosen, ..self }
    }

    /// The integrator of free motion.
    pub(crate) fn build_integrator(&self) -> Box<dyn integrator::Integrator> {
        self.integrator.build(&MethodSettings {
            tolerance: Tolerance::new(self.tolerance).unwrap_or_default(),
            orientation: self.orientation,
            rotation_rate: self.rotation_rate,
            ..MethodSettings::default()
        })
    }

    /// What the method asks for, and the tier's choice for the rest.
    pub(crate) fn resolve(method: &Method) -> Self {
        let tier = method.tier.unwrap_or(Tier::Accurate);
        let (integrator, impact, contact) = match tier {
            Tier::Thesis => (Integrator::Rk4, ImpactLaw::Propagation, ContactMethod::LeastForce),
            Tier::Stepped => (Integrator::ExactStrang, ImpactLaw::Reflection, ContactMethod::ActiveSet),
            Tier::Accurate => (Integrator::Exact, ImpactLaw::Reflection, ContactMethod::ActiveSet),
        };
        Self {
            tier,
            integrator: method.integrator.unwrap_or(integrator),
            asked_integrator: method.integrator,
            orientation: method.orientation.unwrap_or_default(),
            rotation_rate: method.rotation_rate.unwrap_or_default(),
            impact: method.impact.unwrap_or(impact),
            contact: method.contact.unwrap_or(contact),
            broad_phase: method.broad_phase.unwrap_or_default(),
            step_s: method.step_s.unwrap_or(if tier == Tier::Stepped { DEFAULT_TIME_STEP_S } else { DEFAULT_STEP_S }),
            step_is_asked: method.step_s.is_some(),
            tolerance: method.tolerance.unwrap_or(DEFAULT_TOLERANCE),
            max_events_per_step: method.max_events_per_step.unwrap_or(DEFAULT_MAX_EVENTS_PER_STEP),
            crowding: method.crowding.unwrap_or_default(),
            crowding_tolerance: method.crowding_tolerance.unwrap_or(DEFAULT_CROWDING_TOLERANCE),
        }
    }
}
