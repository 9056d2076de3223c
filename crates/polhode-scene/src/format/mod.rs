//! The scene format, version 1, as it is written in a file.
//!
//! Plain data with the keys, and nothing but the keys, of docs/scene-format.md: what is not a member here is refused
//! by name. The engine's own types are in [`polhode`] and are not the file format; [`crate::load()`] goes from one to
//! the other. SI units throughout; quaternions are `[w, x, y, z]`.
//!
//! | module | holds |
//! |---|---|
//! | `scene` | the document: [`SceneFile`], [`OutputEntry`], [`MaterialEntry`], [`PairEntry`], |
//! | | [`NoContactEntry`], [`StartEntry`] |
//! | `method` | [`MethodEntry`] and the members of each knob |
//! | `penalty` | [`PenaltyEntry`]: springs at contacts |
//! | `integrator`, `broad_phase`, `tier` | [`IntegratorName`], [`BroadPhaseName`], [`TierName`] |
//! | `array` | [`ArrayEntry`], [`LayoutEntry`]: many equal bodies |
//! | `body` | [`BodyEntry`], [`ShapeEntry`], [`InertiaEntry`] |
//! | `friction` | [`FrictionEntry`], [`StaticFrictionEntry`]: coefficients that may depend on the direction |
//! | `force` | [`ForceEntry`] and the kinds of force |
//! | `joint` | [`JointEntry`] and the kinds of joint, [`GearEntry`] |
//! | `model` | [`ModelEntry`]: robots from files of their own |
//! | `motion` | [`MotionEntry`] and the kinds of prescribed motion |
//! | `signal` | [`SignalEntry`]: numbers as functions of time |
//! | `exactly` | [`Exactly`]: arrays of an exact length |
//! | `planned` | members that are designed but not built, refused as `not yet available` |
//! | `promise` | what a run promises, where a scene sets other limits than its tier |
//! | `track` | tracks that joints hold bodies to |
//! | `uncertain` | [`UncertainEntry`]: what a sweep draws |
//! | `view` | [`ViewEntry`], [`ColorEntry`]: how a scene is shown |

mod array;
mod body;
mod broad_phase;
mod exactly;
mod force;
mod friction;
mod integrator;
mod joint;
mod method;
mod model;
mod motion;
mod penalty;
pub(crate) mod planned;
mod promise;
mod scene;
mod signal;
mod tier;
mod track;
mod uncertain;
mod view;

pub(crate) use array::LAYOUTS;
pub use array::{
    ArchEntry, ArrayEntry, DropEntry, GridEntry, LayoutEntry, PyramidEntry, RingEntry, SpringersName, WallEntry,
};
pub use body::{
    ApproximateEntry, BodyEntry, BoxEntry, CompoundEntry, FileEntry, HalfSpaceEntry, InertiaEntry, MeshEntry,
    PartEntry, PointsEntry, PrismEntry, RadiusHeightEntry, ShapeEntry, SphereEntry, TorusEntry, WedgeEntry,
};
pub use broad_phase::BroadPhaseName;
pub use exactly::{Exactly, Vector};
pub use force::{
    AppliedForceEntry, AppliedTorqueEntry, DragEntry, DragLawName, ForceEntry, ForceKind, FrameName,
    MutualGravityEntry, PointGravityEntry, SpringEntry,
};
pub use friction::{FrictionEntry, GrainEntry, NumberOr, StaticFrictionEntry, StaticGrainEntry};
pub use integrator::IntegratorName;
pub(crate) use joint::{COORDINATE_MOTIONS, JOINTS};
pub use joint::{
    CoordinateMotionEntry, CoordinateName, CoordinateSineEntry, CoordinateTableEntry, CylindricalEntry, FreedomEntry,
    GearEntry, HingeEntry, JointEntry, JointFrictionEntry, JointKindEntry, MotorEntry, PlanarJointEntry,
    PointJointEntry, RodEntry, RopeEntry, ScrewEntry, SliderEntry, StrengthEntry, TrackJointEntry, UniversalJointEntry,
};
pub use method::{
    ContactName, CoordinatesName, CrowdingName, ErrorEstimationName, ImpactName, MethodEntry, OrientationName,
    PropagationOrderName, PulseExponentName, ResponseName, RestitutionLawName, RotationRateName,
};
pub use model::{BaseName, DriveEntry, ModelEntry, UnphysicalName};
pub use motion::{ConstantMotionEntry, InterpolationEntry, MotionEntry, SineMotionEntry, TableMotionEntry};
pub use penalty::{PenaltyEntry, SpringDampingName, SpringFrictionName, SpringLawName};
pub use promise::PromiseEntry;
pub use scene::{MATERIAL_KEYS, MaterialEntry, NoContactEntry, OutputEntry, PairEntry, SceneFile, StartEntry};
pub use signal::{SignalEntry, SinusoidEntry};
pub use tier::TierName;
pub(crate) use track::CURVES;
pub use track::{
    BendEntry, CircleEntry, CurveEntry, CycloidEntry, FollowsName, HelixEntry, LineEntry, PathEntry, PolynomialEntry,
    SplineEntry, TrackEndsName, TrackEntry, TrackSpringsEntry, WaveEntry,
};
pub(crate) use uncertain::SPREADS;
pub use uncertain::{AxesEntry, ChoiceEntry, DrawName, LimitsEntry, LogNormalEntry, NormalEntry, UncertainEntry};
pub use view::{CameraEntry, ColorEntry, ViewEntry, ViewName};

/// Version of the format that this crate reads.
pub const VERSION: u32 = 1;

/// Kinds of shape, for messages.
pub(crate) const SHAPES: &str =
    "box, sphere, cylinder, cone, capsule, torus, prism, wedge, half_space, points, convex, mesh or compound";

/// Kinds of prescribed motion, for messages.
pub(crate) const MOTIONS: &str = "constant, sine or table";

/// Kinds of force, for messages.
pub(crate) const FORCES: &str = "point_gravity, mutual_gravity, force, torque, drag or spring";
