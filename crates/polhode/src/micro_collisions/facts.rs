//! What the tier `micro-collisions` is.

use crate::scene::{ContactMethod, ImpactLaw, Integrator, Response};
use crate::tier::facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

/// Step when none is given, s: a body at rest vibrates by a micrometre.
const STEP_S: f64 = 1e-3;

/// Order in the step where bodies may collide: an impact is in time to a step.
const ORDER_WITH_CONTACT: u32 = 1;

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: "micro-collisions",
    summary: "Impulses alone, after Mirtich: bodies at rest are held by many small collisions.",
    steps: StepLength::Fixed,
    step_s: STEP_S,
    integrator: Integrator::Rk4,
    integrator_choice: IntegratorChoice::Scene { reason: "exact for a parabola, between two collisions" },
    // One after the other, as Mirtich strikes them, collisions at several corners lose energy to each other, which the body pays for by
    // sinking.
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: Some(Response::Impulse),
    flight: FlightRecords::None,
    order: ErrorOrder::WithContact(ORDER_WITH_CONTACT),
    promise: None,
    features: &[TierFeature::Friction],
};
