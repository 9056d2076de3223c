//! The settings of a run: the scene's method, completed by the defaults of its tier.

use super::facts::{FlightRecords, TierFeature};
use crate::model::pivot_form::PivotRows;
use crate::scene::effects::Effects;
use crate::scene::{
    BroadPhaseMethod, ContactMethod, Coordinates, Crowding, ImpactLaw, Integrator, Method, Orientation, PenaltyMethod,
    Promise, Response, RotationRate, Tier,
};
use polhode_dynamics::integrator::{self, MethodSettings, Tolerance};

/// Local error of a step of constrained motion when none is given, relative to size and speed (dimensionless).
const DEFAULT_TOLERANCE: f64 = 1e-11;

/// Penetration that a step under error control leaves at the default tolerance and tighter ones, besides rounding,
/// relative to the size of the smaller body (no unit). Closing contacts are located far more accurately, whatever the
/// tolerance.
const PENETRATION_AIM: f64 = 1e-12;

/// Error of a stretch of crowded events when none is given, relative to the size of a body (dimensionless).
const DEFAULT_CROWDING_TOLERANCE: f64 = 1e-6;

/// Energy that an integrator of fixed steps which a scene names may lose or gain in a tier under error control,
/// relative to the largest of the run, and the error of such a run, of the size of a body (no unit, 1e-3 to 1e-1). A
/// speed is then wrong by half of that: such a motion looks the same.
const PROMISE_OF_NAMED_STEPS: f64 = 1e-2;

/// Largest number of events in one step when none is given.
const DEFAULT_MAX_EVENTS_PER_STEP: u64 = 1_000_000;

/// The settings of a run, all resolved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Settings {
    pub(crate) tier: Tier,
    pub(crate) integrator: Integrator,
    /// The integrator that the scene names, if any.
    pub(crate) named_integrator: Option<Integrator>,
    pub(crate) orientation: Orientation,
    pub(crate) rotation_rate: RotationRate,
    pub(crate) impact: ImpactLaw,
    pub(crate) contact: ContactMethod,
    /// In which coordinates bodies that joints hold are integrated.
    pub(crate) coordinates: Coordinates,
    /// How bodies that touch act on each other; other than by constraint only in a tier that takes such models.
    pub(crate) response: Response,
    /// The springs of the tier `penalty`.
    pub(crate) penalty: PenaltyMethod,
    pub(crate) broad_phase: BroadPhaseMethod,
    /// Substeps of a step, where they are given.
    pub(crate) substeps: u32,
    pub(crate) step_s: f64,
    /// Whether the scene gives that step.
    pub(crate) step_is_given: bool,
    pub(crate) tolerance: f64,
    /// What the run promises.
    pub(crate) promise: Promise,
    pub(crate) max_events_per_step: u64,
    pub(crate) crowding: Crowding,
    /// Error of a stretch of crowded events per longest step, relative to the size of each body.
    pub(crate) crowding_tolerance: f64,
    /// How many times longer the time steps of stretches of crowded events are than those of the run: 1, or more in a
    /// run beside it that estimates their error (`crate::run::beside`).
    pub(crate) crowd_step_factor: f64,
}

impl Settings {
    /// Error of a stretch of crowded events per longest step, relative to the size of each body. Between changes of
    /// contact it grows with the square of the length of the time steps.
    pub(crate) fn crowd_error_allowed(&self) -> f64 {
        self.crowding_tolerance * self.crowd_step_factor * self.crowd_step_factor
    }

    /// Whether the tier takes this.
    pub(crate) fn takes(&self, feature: TierFeature) -> bool {
        self.tier.facts().takes(feature)
    }

    /// Which pivots have constraint rows: none in the tiers of fixed steps, and by integrators that advance bodies one
    /// by one, but for those of jointed bodies.
    pub(crate) fn pivot_rows(&self, effects: Effects) -> PivotRows {
        let solves_rows = matches!(self.named_integrator, None | Some(Integrator::Dop853 | Integrator::Rk4));
        match effects {
            _ if !self.takes(TierFeature::PivotRows) || !solves_rows => PivotRows::None,
            Effects::Planned => PivotRows::WhereColliding,
            Effects::All => PivotRows::All,
        }
    }

    /// Whether bodies under gravity alone are in free flight, evaluated from flight records.
    pub(crate) fn flies(&self) -> bool {
        match (self.tier.facts().flight, self.integrator) {
            (FlightRecords::None, _) => false,
            (FlightRecords::All, _) => true,
            // When the plan chooses DOP853, bodies under gravity alone stay in free flight; when the scene names it, it
            // integrates all bodies.
            (FlightRecords::WhereExact, Integrator::Dop853) => self.named_integrator.is_none(),
            (FlightRecords::WhereExact, integrator) => integrator.is_exact_without_loads(),
        }
    }

    /// Whether constrained motion is integrated by RK4 at a fixed step, because the scene names it, and not by DOP853
    /// under error control.
    pub(crate) fn constrains_by_rk4(&self) -> bool {
        self.takes(TierFeature::ConstrainedRk4) && self.named_integrator == Some(Integrator::Rk4)
    }

    /// Whether the scene names an integrator of fixed steps.
    pub(crate) fn names_fixed_steps(&self) -> bool {
        self.named_integrator.is_some_and(|named| !named.controls_error())
    }

    /// Whether error control chooses the steps of all motion.
    pub(crate) fn controls_error(&self) -> bool {
        self.tier.facts().controls_error() && self.integrator.controls_error() && !self.constrains_by_rk4()
    }

    /// Penetration that a step under error control leaves, besides rounding, relative to the size of the smaller body:
    /// a tolerance above the default is itself that, because active contacts drift by errors of that size within a
    /// step.
    pub(crate) fn penetration_aim(&self) -> f64 {
        if self.tolerance > DEFAULT_TOLERANCE { self.tolerance } else { PENETRATION_AIM }
    }

    /// Whether what projections move is an error of controlled steps.
    pub(crate) fn projects_within_promise(&self) -> bool {
        self.tier.facts().controls_error() && !self.constrains_by_rk4()
    }

    /// Largest local error of a step of constrained motion (dimensionless): the tolerance under error control, infinite
    /// for a method without error control.
    pub(crate) fn step_error(&self) -> f64 {
        if self.constrains_by_rk4() { f64::INFINITY } else { self.tolerance }
    }

    /// Whether the integrator is splitting under error control, chosen by the plan and not named by the scene.
    pub(crate) fn splits_by_choice(&self) -> bool {
        self.named_integrator.is_none() && self.integrator == Integrator::ExactAdaptive
    }

    /// The settings as [`Settings::resolve`] gives them, before the plan chooses an integrator.
    pub(crate) fn as_resolved(self) -> Self {
        let chosen = self.named_integrator.unwrap_or(self.tier.facts().integrator);
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

    /// The settings that the method gives, and the defaults of this tier for the rest.
    pub(crate) fn resolve(method: &Method, tier: Tier) -> Self {
        let facts = tier.facts();
        let tolerance = method.tolerance.unwrap_or(DEFAULT_TOLERANCE);
        let mut promise = facts.promise.at_least(tolerance);
        if facts.controls_error() && method.integrator.is_some_and(|named| !named.controls_error()) {
            promise.energy = promise.energy.max(PROMISE_OF_NAMED_STEPS);
            promise.error = promise.error.max(PROMISE_OF_NAMED_STEPS);
        }
        Self {
            tier,
            integrator: method.integrator.unwrap_or(facts.integrator),
            named_integrator: method.integrator,
            orientation: method.orientation.unwrap_or_default(),
            rotation_rate: method.rotation_rate.unwrap_or_default(),
            impact: method.impact.unwrap_or(facts.impact),
            contact: method.contact.unwrap_or(facts.contact),
            coordinates: method.coordinates.unwrap_or_default(),
            response: method.response.or(facts.own_response).unwrap_or_default(),
            penalty: method.penalty.unwrap_or_default(),
            broad_phase: method.broad_phase.unwrap_or_default(),
            substeps: method.substeps.unwrap_or(facts.substeps),
            step_s: method.step_s.unwrap_or(facts.step_s),
            step_is_given: method.step_s.is_some(),
            tolerance,
            promise: promise.changed(&method.promise),
            max_events_per_step: method.max_events_per_step.unwrap_or(DEFAULT_MAX_EVENTS_PER_STEP),
            crowding: method.crowding.unwrap_or_default(),
            crowding_tolerance: method.crowding_tolerance.unwrap_or(DEFAULT_CROWDING_TOLERANCE),
            crowd_step_factor: 1.0,
        }
    }
}
