//! What the tier `penalty` is.

use crate::scene::{ContactMethod, ImpactLaw, Integrator, Response};
use crate::tier::facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

/// Longest step when none is given, s.
const LONGEST_STEP_S: f64 = 0.01;

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: "penalty",
    summary: "Springs and dampers where bodies overlap: nothing is solved for, and bodies interpenetrate.",
    steps: StepLength::ErrorControlled,
    step_s: LONGEST_STEP_S,
    integrator: Integrator::Dop853,
    integrator_choice: IntegratorChoice::Scene {
        reason: "under error control, with the begin and end of contacts located",
    },
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: Some(Response::Penalty),
    flight: FlightRecords::None,
    order: ErrorOrder::OfIntegrator,
    promise: None,
    features: &[TierFeature::Friction, TierFeature::Joints, TierFeature::SurfaceEffects],
};
