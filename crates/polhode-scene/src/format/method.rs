//! The method: one tier and the knobs behind it.

use super::broad_phase::BroadPhaseName;
use super::integrator::IntegratorName;
use super::penalty::PenaltyEntry;
use super::tier::TierName;
use schemars::JsonSchema;
use serde::Deserialize;

/// How the scene is simulated. A knob that is given is used literally; what is absent follows the tier.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MethodEntry {
    /// A set of methods with one promise.
    pub tier: Option<TierName>,
    /// Step, s: the fixed step of the tiers thesis and stepped, the upper bound of a step of tier accurate.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub step: Option<f64>,
    /// Substeps of a step of tier fast; 4 when absent.
    #[schemars(range(min = 1, max = 1000))]
    pub substeps: Option<u32>,
    /// How bodies are integrated that no contact holds.
    pub integrator: Option<IntegratorName>,
    /// How the integrator rk4 represents orientation.
    pub orientation: Option<OrientationName>,
    /// The variable of rotation of the integrator rk4.
    pub rotation_rate: Option<RotationRateName>,
    /// What happens when bodies hit each other.
    pub impact: Option<ImpactName>,
    /// Which contact `impact = "propagation"` strikes first: `key` (when absent), `depth`, or `{ random = SEED }`.
    pub propagation_order: Option<PropagationOrderName>,
    /// The springs of `impact = "pulse"`; hertz when absent.
    pub pulse_exponent: Option<PulseExponentName>,
    /// The law of restitution of an impact with friction at a contact that is struck alone; stronge when absent.
    pub restitution_law: Option<RestitutionLawName>,
    /// By how much restitution reverses the slip of an impact, in [-1, 1]: 0 sticks, 1 is a super ball. It needs
    /// `restitution_law = "chatterjee-ruina"`; 0 when absent.
    #[schemars(range(min = -1, max = 1))]
    pub tangential_restitution: Option<f64>,
    /// How the forces of resting contacts are found.
    pub contact: Option<ContactName>,
    /// How pairs that may touch are found; a choice of time alone.
    pub broad_phase: Option<BroadPhaseName>,
    /// How bodies in contact act on each other.
    pub response: Option<ResponseName>,
    /// Depth of the envelope of tier micro-collisions, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub collision_envelope: Option<f64>,
    /// Local error per step of contact phases, relative to size and speed of each body.
    #[schemars(extend("exclusiveMinimum" = 0), range(max = 0.1))]
    pub tolerance: Option<f64>,
    /// In which coordinates tier accurate integrates bodies that joints hold.
    pub coordinates: Option<CoordinatesName>,
    /// Largest number of events within one step.
    #[schemars(range(min = 1))]
    pub max_events_per_step: Option<u64>,
    /// What happens where the events of some bodies crowd.
    pub crowding: Option<CrowdingName>,
    /// Error of a stretch of crowded events for each longest step, relative to the size of each body.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub crowding_tolerance: Option<f64>,
    /// How the error of the run is estimated; quick when absent.
    pub error: Option<ErrorEstimationName>,
    /// The springs of response = "penalty".
    pub penalty: Option<PenaltyEntry>,
}

/// In which coordinates bodies that joints hold are integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CoordinatesName {
    /// Position and attitude of each body; reactions hold joints.
    Maximal,
    /// The coordinates of the joints of trees: ball joints, hinges and sliders without limits, friction and contacts.
    Reduced,
}

/// What happens where the events of some bodies crowd.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CrowdingName {
    /// They go on by time steps at the level of velocities until events thin out.
    Step,
    /// The run ends with an error.
    Error,
}

/// How the error of a run is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorEstimationName {
    /// Not at all.
    Off,
    /// By runs beside the run that are to add at most three tenths to its time.
    Quick,
    /// By whole runs beside the run, which are to take at most three times its time.
    Full,
}

/// How the integrator rk4 represents orientation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OrientationName {
    /// By a quaternion, normalised after each step.
    Quaternion,
    /// By a quaternion that is never normalised.
    QuaternionUnnormalized,
    /// By the three numbers x, y, z of a unit quaternion with w >= 0, as the thesis suggests to store it.
    QuaternionThreeNumbers,
    /// By a matrix, brought to the nearest rotation after each step.
    Matrix,
    /// By a matrix that drifts from a rotation.
    MatrixUnorthogonalized,
    /// By Euler angles about z, x, z; singular where the z axis of the body lies along that of the world.
    EulerAngles,
}

/// The variable of rotation of the integrator rk4.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RotationRateName {
    /// Angular momentum, constant in free motion.
    AngularMomentum,
    /// Angular velocity, by equation 9 of the thesis.
    AngularVelocity,
}

/// What happens when bodies hit each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ImpactName {
    /// One contact after the other until none approaches (thesis 3.3).
    Propagation,
    /// All contacts at once after Newton and Moreau (thesis 3.4, end).
    Simultaneous,
    /// Generalised reflection: symmetric, and momentum still travels through chains.
    Reflection,
    /// A compression and an expansion of all contacts after Poisson.
    Poisson,
    /// Each contact gives back a part of the work that it took, after Stronge.
    Energetic,
    /// The contacts as springs that spend their energy (Liu, Zhao and Brogliato); without friction.
    Pulse,
}

/// Which of several contacts that approach propagation strikes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PropagationOrderName {
    /// The first by the numbers of its bodies and features.
    Key,
    /// The one that overlaps most.
    Depth,
    /// In an order drawn anew for each impact.
    Random(u64),
}

/// The springs of impact law pulse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PulseExponentName {
    /// Force in proportion to indentation.
    Linear,
    /// Force with the power 3/2 of indentation, as between curved surfaces.
    Hertz,
}

/// The law of restitution of an impact with friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RestitutionLawName {
    /// The normal impulse gives back e^2 of the work that it took. Energy never rises.
    Stronge,
    /// The normal impulse of restitution is e times that of compression.
    Poisson,
    /// The normal velocity is reversed by -e, along the path of the impact; energy may rise, with a warning.
    Newton,
    /// The same by algebra on the velocities before and after; energy may rise, with a warning.
    Whittaker,
    /// Algebra with restitution of slip as well: cheap, and energy never rises.
    ChatterjeeRuina,
}

/// How the forces of resting contacts are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactName {
    /// The thesis's linear programme of least total force with its guesses of vanishing contacts.
    LeastForce,
    /// The exact complementarity problem by the active set.
    ActiveSet,
    /// The thesis's heuristic in its three stages, each told (thesis 3.4).
    Heuristic,
    /// Guesses of which contacts vanish, one after the other until forces fit (thesis 3.4).
    Guesses,
    /// One contact after the other, from the impulses of the step before; tier fast.
    SequentialImpulses,
    /// The same with steps of nonsmooth nonlinear conjugate gradients between several sweeps; tier fast.
    Nncg,
}

/// How bodies in contact act on each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ResponseName {
    /// By forces that keep bodies from overlapping, and impulses where they hit.
    Constraint,
    /// By impulses alone, where bodies approach: tier micro-collisions when no tier is named. With tier thesis (thesis
    /// 3.3) resting bodies sink.
    Impulse,
    /// By impulses, and bodies that overlap are moved apart; tier thesis (thesis 3.3): resting bodies vibrate.
    ImpulseProjection,
    /// By impulses wherever bodies overlap, also where they separate; tier thesis (thesis 3.3): bodies stay caught.
    ImpulseUnconditional,
    /// By springs and dampers where bodies overlap; tier penalty.
    Penalty,
}
