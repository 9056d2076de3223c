//! What the tier `accurate` is.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, OverlapLimit, Promise, Tier};
use crate::solve::cone_violation::CONE_LIMIT;
use crate::tier::facts::{
    ErrorOrder, FlightRecords, IntegratorChoice, LONGEST_STEP_S, StepLength, TierFacts, TierFeature,
};

/// What it promises (`crate::scene::promise`): a hundred times the error of a step at the default tolerance. What
/// rounding adds up to in long runs stays below that, and what is wrong is far above.
const PROMISE: Promise = Promise {
    overlap: OverlapLimit::OfSize(1e-9),
    joint_gap: Some(1e-9),
    energy: 1e-9,
    residual: Some(1e-8),
    friction: Some(CONE_LIMIT),
    loads: None,
    error: 1e-6,
};

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: Tier::Accurate.name(),
    summary: "Closed-form flight, error-controlled contact phases, located impacts and force events.",
    steps: StepLength::ErrorControlled,
    step_s: LONGEST_STEP_S,
    substeps: 1,
    integrator: Integrator::Exact,
    integrator_choice: IntegratorChoice::Plan,
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: None,
    flight: FlightRecords::WhereExact,
    order: ErrorOrder::OfIntegrator,
    second_opinion: Tier::Accurate,
    compared_first: ReferenceKind::OtherSteps,
    promise: PROMISE,
    remedy: "a smaller method.tolerance may help",
    features: &[
        TierFeature::Friction,
        TierFeature::Joints,
        TierFeature::AllOfJoints,
        TierFeature::SurfaceEffects,
        TierFeature::PivotRows,
        TierFeature::ConstrainedRk4,
        TierFeature::PlanarFriction,
        TierFeature::PlanarGroups,
        TierFeature::CrowdedStretches,
        TierFeature::ReducedCoordinates,
    ],
};
