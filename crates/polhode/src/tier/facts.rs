//! What a tier is: its name, its methods, its promise, and what it takes.
//!
//! Each tier has one value of [`TierFacts`] in a folder of its own, and `list.rs` lists them. All other files read them
//! and name no kind of tier: whoever adds a tier adds a folder, its line there, and its name in `scene/tiers.rs`.

use crate::report::run_error::ReferenceKind;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, Promise, Response, Tier};

/// Upper bound of a step under error control when none is given, s.
pub(crate) const LONGEST_STEP_S: f64 = 0.01;

/// What a tier is. [`Tier::facts`](crate::scene::Tier::facts) gives those of a tier.
///
/// ```
/// use polhode::scene::Tier;
/// use polhode::tier::TierFeature;
/// for tier in Tier::ALL.into_iter().filter(|tier| tier.facts().takes(TierFeature::Joints)) {
///     println!("{}: {}", tier.name(), tier.facts().summary);
/// }
/// assert_eq!(Tier::default().facts().promise.residual, Some(1e-8));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TierFacts {
    /// The name used in scenes and reports.
    pub name: &'static str,
    /// What it does, in a sentence.
    pub summary: &'static str,
    /// How long its steps are.
    pub steps: StepLength,
    /// Step when none is given, s: the fixed step, or the upper bound of a step.
    pub step_s: f64,
    /// Substeps of a step when none are given.
    pub substeps: u32,
    /// Integrator of free motion when none is given and the plan chooses none.
    pub integrator: Integrator,
    /// Who chooses the integrator.
    pub integrator_choice: IntegratorChoice,
    /// Impact law when none is given.
    pub impact: ImpactLaw,
    /// Method of contact forces when none is given.
    pub contact: ContactMethod,
    /// The response that this tier alone has, so that a scene which names it need not name the tier.
    pub own_response: Option<Response>,
    /// Which bodies under gravity alone follow a flight record.
    pub flight: FlightRecords,
    /// How its error falls with the step.
    pub order: ErrorOrder,
    /// The tier by which a run is computed again to estimate its error.
    pub second_opinion: Tier,
    /// With what a run is compared first: with other steps, or with another method, where the tier has errors that
    /// shorter steps do not take away.
    pub compared_first: ReferenceKind,
    /// What it promises at its default tolerance.
    pub promise: Promise,
    /// What would help where a run does not keep it, in words.
    pub remedy: &'static str,
    /// What it takes besides bodies, shapes and fields of force.
    pub features: &'static [TierFeature],
}

impl TierFacts {
    /// Whether the tier takes this.
    pub fn takes(&self, feature: TierFeature) -> bool {
        self.features.contains(&feature)
    }

    /// Whether error control chooses the lengths of its steps.
    pub fn controls_error(&self) -> bool {
        self.steps == StepLength::ErrorControlled
    }
}

/// How long the steps of a tier are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StepLength {
    /// Fixed; an event may end one earlier.
    Fixed,
    /// Chosen by error control, with an upper bound.
    ErrorControlled,
}

/// Who chooses the integrator of free motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum IntegratorChoice {
    /// Nobody: the tier has its own.
    Tier {
        /// What it is, in words.
        reason: &'static str,
        /// Why a scene cannot name another, in words.
        instead: &'static str,
    },
    /// The scene; the tier's default when it names none.
    Scene {
        /// What the default is, in words.
        reason: &'static str,
    },
    /// The plan, when the scene names none.
    Plan,
}

/// Which bodies under gravity alone follow a flight record, which gives their states at any time in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlightRecords {
    /// None: the integrator advances them.
    None,
    /// All.
    All,
    /// Those whose integrator is exact without other forces, or chosen by the plan.
    WhereExact,
}

/// Order of the error of a run in the length of its steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorOrder {
    /// That of the integrator.
    OfIntegrator,
    /// This one.
    Fixed(u32),
    /// This one where bodies may collide, else that of the integrator.
    WithContact(u32),
}

/// What some tiers take and others do not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TierFeature {
    /// Friction of contacts.
    Friction,
    /// Joints.
    Joints,
    /// All that joints have: gears, prescribed motions, forces, friction and strengths along their coordinates, limits
    /// that bounce, tracks, and kinematic members.
    AllOfJoints,
    /// Pivots held by constraint rows; without it a pivoted body only turns about its pivot.
    PivotRows,
    /// [`ContactMethod::LeastForce`].
    LeastForce,
    /// [`ContactMethod::SequentialImpulses`].
    SequentialImpulses,
    /// Static friction above kinetic, friction along a grain, of rolling and of spinning, and surfaces that move.
    SurfaceEffects,
    /// Every [`Response`], not only that by constraint.
    Responses,
    /// RK4 for constrained motion too, where the scene names it.
    ConstrainedRk4,
    /// Friction of contacts in planar motion, in the coordinates of the plane.
    PlanarFriction,
    /// Planar motion of some bodies of a scene, until they meet others.
    PlanarGroups,
    /// Trees of joints in the coordinates of the joints.
    ReducedCoordinates,
    /// Stretches of crowded events, advanced by time steps whose error is controlled.
    CrowdedStretches,
}
