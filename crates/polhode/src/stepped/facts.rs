//! What the tier `stepped` is.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, OverlapLimit, Promise, Tier};
use crate::solve::cone_violation::CONE_LIMIT;
use crate::tier::facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

/// Step when none is given, s. A body of some tenths of a metre that has fallen for a second moves by about a hundredth
/// of its size in one step; bounces that last less than two steps have speeds below 0.02 m/s.
const TIME_STEP_S: f64 = 1e-3;

/// Order in the step of time steps between changes of contact.
const ORDER_OF_TIME_STEPS: u32 = 2;

/// What it promises (`crate::scene::promise`): what no picture shows, and what steps of the default length keep.
const PROMISE: Promise = Promise {
    overlap: OverlapLimit::OfSize(1e-3),
    joint_gap: Some(1e-6),
    energy: 1e-3,
    residual: Some(1e-8),
    friction: Some(CONE_LIMIT),
    loads: Some(1e-9),
    error: 1e-2,
};

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: Tier::Stepped.name(),
    summary: "Fixed steps with all contacts solved together at the level of velocities; it always gets through.",
    steps: StepLength::Fixed,
    step_s: TIME_STEP_S,
    substeps: 1,
    integrator: Integrator::ExactStrang,
    integrator_choice: IntegratorChoice::Tier {
        reason: "the tier has its own: exact flight, forces as one kick in the middle of the step",
        instead: "tier = \"stepped\" without an integrator (it has its own: exact flight with forces as a kick)",
    },
    impact: ImpactLaw::Reflection,
    contact: ContactMethod::ActiveSet,
    own_response: None,
    flight: FlightRecords::All,
    order: ErrorOrder::Fixed(ORDER_OF_TIME_STEPS),
    second_opinion: Tier::Accurate,
    compared_first: ReferenceKind::OtherSteps,
    promise: PROMISE,
    remedy: "a shorter method.step would help, or method.tier = \"accurate\"",
    features: &[
        TierFeature::Friction,
        TierFeature::Joints,
        TierFeature::AllOfJoints,
        TierFeature::SurfaceEffects,
        TierFeature::PlanarGroups,
    ],
};
