//! What the tier `fast` is.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, OverlapLimit, Promise, Tier};
use crate::tier::facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

/// Step when none is given, s: that of a picture.
const PICTURE_STEP_S: f64 = 1.0 / 60.0;

/// Substeps of a step when none are given.
const SUBSTEPS: u32 = 4;

/// Order in the step where bodies may collide.
const ORDER_OF_SUBSTEPS: u32 = 1;

/// What it promises (`crate::scene::promise`): what can be seen, and is not taken for a fault of the scene. Sequential
/// impulses end with residuals that no limit fits.
const PROMISE: Promise = Promise {
    overlap: OverlapLimit::OfSize(0.1),
    joint_gap: Some(1e-2),
    energy: 5e-2,
    residual: None,
    friction: None,
    loads: None,
    error: 1e-2,
};

/// The facts.
pub(crate) const FACTS: TierFacts = TierFacts {
    name: Tier::Fast.name(),
    summary: "Real time: substeps of soft contacts by sequential impulses, contacts side by side in lanes.",
    steps: StepLength::Fixed,
    step_s: PICTURE_STEP_S,
    substeps: SUBSTEPS,
    integrator: Integrator::Splitting,
    integrator_choice: IntegratorChoice::Tier {
        reason: "the tier has its own: velocities first, then poses, rotation by its middle",
        instead: "tier = \"fast\" without an integrator (it has its own)",
    },
    impact: ImpactLaw::Simultaneous,
    contact: ContactMethod::SequentialImpulses,
    own_response: None,
    flight: FlightRecords::None,
    order: ErrorOrder::WithContact(ORDER_OF_SUBSTEPS),
    second_opinion: Tier::Accurate,
    compared_first: ReferenceKind::OtherMethod,
    promise: PROMISE,
    remedy: "a shorter method.step or more method.substeps would help, or method.tier = \"stepped\"",
    features: &[TierFeature::Friction, TierFeature::Joints, TierFeature::SequentialImpulses],
};
