//! What the tier `accurate` is.

use crate::scene::{ContactMethod, ImpactLaw, Integrator};
use crate::tier::facts::{
    ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature, TierPromise,
};

/// Upper bound of a step when none is given, s.
const LONGEST_STEP_S: f64 = 0.01;

/// Promised limit of penetration at the default tolerance and tighter ones, relative to the size of the smaller body.
/// Closing contacts are located far more accurately, whatever the tolerance.
const PENETRATION_RELATIVE: f64 = 1e-12;

/// Promised limit of projections at the default tolerance, in units of that tolerance (dimensionless, 1 to 100). The
/// error of a step is a fraction of the tolerance, and the touch distance is of its order; the projection of contacts
/// that are close to each other turns a body by a few times more.
const DRIFT_FACTOR: f64 = 10.0;

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: "accurate",
    summary: "Closed-form flight, error-controlled contact phases, located impacts and force events.",
    steps: StepLength::ErrorControlled,
    step_s: LONGEST_STEP_S,
    integrator: Integrator::Exact,
    integrator_choice: IntegratorChoice::Plan,
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: None,
    flight: FlightRecords::WhereExact,
    order: ErrorOrder::OfIntegrator,
    promise: Some(TierPromise { penetration_relative: PENETRATION_RELATIVE, drift_factor: DRIFT_FACTOR }),
    features: &[
        TierFeature::Friction,
        TierFeature::Joints,
        TierFeature::AllOfJoints,
        TierFeature::SurfaceEffects,
        TierFeature::PivotRows,
        TierFeature::ConstrainedRk4,
        TierFeature::PlanarFriction,
        TierFeature::CrowdedStretches,
        TierFeature::ReducedCoordinates,
    ],
};
