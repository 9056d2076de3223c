//! What the tier `micro-collisions` is.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, OverlapLimit, Promise, Response, Tier};
use crate::tier::facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

/// Step when none is given, s: a body at rest vibrates by a micrometre.
const STEP_S: f64 = 1e-3;

/// Order in the step where bodies may collide: an impact is in time to a step.
const ORDER_WITH_CONTACT: u32 = 1;

/// What it promises (`crate::scene::promise`): bodies at rest float within the envelope, and overlap by less than its
/// depth.
const PROMISE: Promise = Promise {
    overlap: OverlapLimit::OfEnvelope(1.0),
    joint_gap: None,
    energy: 1e-2,
    residual: Some(1e-8),
    friction: None,
    loads: None,
    error: 1e-2,
};

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: Tier::MicroCollisions.name(),
    summary: "Impulses alone, after Mirtich: bodies at rest are held by many small collisions.",
    steps: StepLength::Fixed,
    step_s: STEP_S,
    substeps: 1,
    integrator: Integrator::Rk4,
    integrator_choice: IntegratorChoice::Scene { reason: "exact for a parabola, between two collisions" },
    // One after the other, as Mirtich strikes them, collisions at several corners lose energy to each other, which the
    // body pays for by sinking.
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: Some(Response::Impulse),
    flight: FlightRecords::None,
    order: ErrorOrder::WithContact(ORDER_WITH_CONTACT),
    second_opinion: Tier::Accurate,
    compared_first: ReferenceKind::OtherMethod,
    promise: PROMISE,
    remedy: "a shorter method.step would help, or method.tier = \"accurate\"",
    features: &[TierFeature::Friction],
};
