//! What the tier `penalty` is.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, OverlapLimit, Promise, Response, Tier};
use crate::tier::facts::{
    ErrorOrder, FlightRecords, IntegratorChoice, LONGEST_STEP_S, StepLength, TierFacts, TierFeature,
};

/// What it promises (`crate::scene::promise`): a blow that was not expected compresses springs by more than they are
/// made for.
const PROMISE: Promise = Promise {
    overlap: OverlapLimit::OfStatedPenetration(2.0),
    joint_gap: Some(1e-6),
    energy: 1e-2,
    residual: None,
    friction: None,
    loads: None,
    error: 1e-2,
};

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: Tier::Penalty.name(),
    summary: "Springs and dampers where bodies overlap: nothing is solved for, and bodies interpenetrate.",
    steps: StepLength::ErrorControlled,
    step_s: LONGEST_STEP_S,
    substeps: 1,
    integrator: Integrator::Dop853,
    integrator_choice: IntegratorChoice::Scene {
        reason: "under error control, with the begin and end of contacts located",
    },
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: Some(Response::Penalty),
    flight: FlightRecords::None,
    order: ErrorOrder::OfIntegrator,
    second_opinion: Tier::Penalty,
    compared_first: ReferenceKind::OtherSteps,
    promise: PROMISE,
    remedy: "a smaller method.penalty.penetration_m would help, or method.tier = \"accurate\"",
    features: &[TierFeature::Friction, TierFeature::Joints, TierFeature::SurfaceEffects],
};
