//! What the tier `thesis` is.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, OverlapLimit, Promise, Tier};
use crate::tier::facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

/// Step when none is given, s.
const THESIS_STEP_S: f64 = 0.01;

/// Order in the step where bodies may collide: its contact forces are constant over a step.
const ORDER_WITH_CONTACT: u32 = 1;

/// What it promises (`crate::scene::promise`): what its steps of half a millisecond leave in scenes like its videos.
const PROMISE: Promise = Promise {
    overlap: OverlapLimit::OfSize(1e-2),
    joint_gap: None,
    energy: 1e-2,
    residual: None,
    friction: None,
    loads: None,
    error: 1e-2,
};

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: Tier::Thesis.name(),
    summary: "The thesis's section 3.5 to the letter.",
    steps: StepLength::Fixed,
    step_s: THESIS_STEP_S,
    substeps: 1,
    integrator: Integrator::Rk4,
    integrator_choice: IntegratorChoice::Scene { reason: "that of the thesis" },
    impact: ImpactLaw::Propagation,
    contact: ContactMethod::LeastForce,
    own_response: None,
    flight: FlightRecords::None,
    order: ErrorOrder::WithContact(ORDER_WITH_CONTACT),
    second_opinion: Tier::Accurate,
    compared_first: ReferenceKind::OtherMethod,
    promise: PROMISE,
    remedy: "a shorter method.step would help, or method.tier = \"accurate\"",
    features: &[TierFeature::LeastForce, TierFeature::Responses],
};
