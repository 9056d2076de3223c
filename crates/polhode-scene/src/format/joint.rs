//! Joints.

use super::exactly::{Exactly, Vector};
use super::motion::InterpolationEntry;
use super::track::{FollowsName, TrackEndsName, TrackSpringsEntry};
use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of joint, for messages.
pub(crate) const JOINTS: &str = "ball, hinge, universal, fixed, slider, cylindrical, planar, screw, rod, rope or track";

/// Kinds of prescribed motion of a coordinate, for messages.
pub(crate) const COORDINATE_MOTIONS: &str = "rate, sine or table";

/// A joint: what holds two bodies, or a body and the world, together.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointEntry {
    /// Its name, for gears; joints need none.
    pub name: Option<String>,
    /// What kind of joint.
    #[serde(rename = "type")]
    pub kind: JointKindEntry,
    /// The load at which it breaks; without this key none breaks it.
    pub breaks_at: Option<StrengthEntry>,
}

/// The load at which a joint breaks; at least one of the keys.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrengthEntry {
    /// The greatest force, N.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub force: Option<f64>,
    /// The greatest moment at the anchor, N m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub moment: Option<f64>,
    /// The greatest impulse of an impact, N s; without this key impacts do not break it.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub impulse: Option<f64>,
}

/// Kinds of joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum JointKindEntry {
    /// A point of both bodies: all rotations about it are free.
    Ball(PointJointEntry),
    /// A point and an axis of both bodies: the rotation about the axis is free.
    Hinge(HingeEntry),
    /// A point of both bodies, and an axis of each at right angles: the rotations about both are free.
    Universal(UniversalJointEntry),
    /// The bodies move as one.
    Fixed(PointJointEntry),
    /// A line of the second body, or of the world, on which a point of the first slides without a rotation.
    Slider(SliderEntry),
    /// An axis of both bodies: the rotation about it and the displacement along it are free.
    Cylindrical(Box<CylindricalEntry>),
    /// An axis of both bodies, and a displacement along it that goes with the rotation about it.
    Screw(ScrewEntry),
    /// A plane of the second body, or of the world, in which a point of the first slides; both keep its normal.
    Planar(PlanarJointEntry),
    /// A rod without mass: the distance of a point of each stays.
    Rod(RodEntry),
    /// A rope without mass between a point of each.
    Rope(RopeEntry),
    /// A curve of the second body, or of the world, along which a point of the first one moves.
    Track(Box<TrackJointEntry>),
}

/// A joint at a point.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The point at t = 0, m, world.
    pub anchor: Vector,
}

/// What acts along a coordinate of a joint. The coordinate is zero at t = 0; angles are in rad, displacements in m.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FreedomEntry {
    /// Limits: the smallest and the largest value; an angle has less than one revolution between them.
    pub range: Option<Exactly<f64, 2>>,
    /// Coefficient of restitution at the limits.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub restitution: f64,
    /// Stiffness of a spring, N m/rad or N/m.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub stiffness: f64,
    /// The value at which the spring is at rest.
    #[serde(default)]
    pub rest: f64,
    /// Constant of a damper, N m s/rad or N s/m.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub damping: f64,
    /// A motor.
    pub motor: Option<MotorEntry>,
    /// Dry friction.
    pub friction: Option<JointFrictionEntry>,
    /// A motion that the coordinate follows, whatever acts on the bodies.
    pub motion: Option<CoordinateMotionEntry>,
}

/// How a coordinate moves from its value at t = 0: exactly one of the kinds.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CoordinateMotionEntry {
    /// A constant rate, rad/s or m/s.
    Rate(f64),
    /// An oscillation, amplitude sin(2 pi frequency t + phase).
    Sine(CoordinateSineEntry),
    /// Values joined by a curve.
    Table(CoordinateTableEntry),
}

/// An oscillation of a coordinate.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoordinateSineEntry {
    /// Amplitude, rad or m.
    pub amplitude: f64,
    /// Frequency, Hz.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub frequency: f64,
    /// Phase at t = 0, rad; 0 when absent.
    pub phase: Option<f64>,
}

/// Values of a coordinate. Before the first and after the last one it stands still.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoordinateTableEntry {
    /// Times, s, that rise.
    #[schemars(length(min = 2))]
    pub times: Vec<f64>,
    /// Values, rad or m, one for each time; what counts is how they differ from the one at t = 0.
    #[schemars(length(min = 2))]
    pub values: Vec<f64>,
    /// What is between the values; monotone when absent. Linear is refused: the rate would jump.
    pub interpolation: Option<InterpolationEntry>,
}

/// A gear: the coordinate of one joint moves by a ratio times that of another one.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearEntry {
    /// Names of the two joints: the first one moves by `ratio` times what the second one moves.
    pub joints: Exactly<String, 2>,
    /// The coordinates of the joints; needed of cylindrical joints, which have two.
    pub coordinates: Option<Exactly<CoordinateName, 2>>,
    /// What the first coordinate moves for each unit of the second one: rad of hinges, m of sliders; not zero.
    pub ratio: f64,
}

/// A coordinate of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CoordinateName {
    /// The angle about the axis.
    Angle,
    /// The displacement along the axis.
    Displacement,
    /// The distance of the anchors.
    Distance,
}

/// Dry friction along a coordinate of a joint: `effort`, a bearing by `coefficient`, or both.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointFrictionEntry {
    /// Its torque (N m) or force (N) against the motion.
    pub effort: Option<f64>,
    /// The largest one that holds what is at rest; as large as `effort` without this key.
    pub breakaway: Option<f64>,
    /// Of a bearing: friction over the force on it across the axis.
    #[schemars(range(min = 0.0))]
    pub coefficient: Option<f64>,
    /// Of a bearing: the radius at which it rubs, m; of angles alone.
    #[schemars(range(min = 0.0))]
    pub radius: Option<f64>,
}

/// A motor: exactly one of `effort`, `velocity` and `position`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotorEntry {
    /// A constant torque (N m) or force (N).
    pub effort: Option<f64>,
    /// The rate that a servo is to reach, rad/s or m/s; needs `gain`.
    pub velocity: Option<f64>,
    /// Effort of that servo for each unit of the difference, N m s/rad or N s/m.
    #[schemars(range(min = 0.0))]
    pub gain: Option<f64>,
    /// The value that a servo is to reach, rad or m; needs `stiffness`.
    pub position: Option<f64>,
    /// Effort of that servo for each unit of the difference, N m/rad or N/m.
    #[schemars(range(min = 0.0))]
    pub stiffness: Option<f64>,
    /// Its effort against each unit of the rate, N m s/rad or N s/m.
    #[schemars(range(min = 0.0))]
    pub damping: Option<f64>,
    /// The largest effort, N m or N; without this key there is no bound.
    #[schemars(range(min = 0.0))]
    pub most: Option<f64>,
}

/// A hinge.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HingeEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the axis at t = 0, m, world.
    pub anchor: Vector,
    /// The direction of the axis at t = 0, world; of any length but zero.
    pub axis: Vector,
    /// What acts along the angle of the first body about the axis, relative to the second one or the world.
    pub angle: Option<FreedomEntry>,
}

/// A slider.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SliderEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the axis at t = 0, m, world.
    pub anchor: Vector,
    /// The direction of the axis at t = 0, world; of any length but zero.
    pub axis: Vector,
    /// What acts along the displacement of the first body along the axis.
    pub displacement: Option<FreedomEntry>,
}

/// A rod.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RodEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The points at its ends at t = 0, m, world: that of the first body, that of the second one or of the world.
    pub anchors: Exactly<Vector, 2>,
}

/// A rope.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RopeEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The points at its ends at t = 0, m, world: that of the first body, that of the second one or of the world.
    pub anchors: Exactly<Vector, 2>,
    /// Its length, m; without this key it is taut at t = 0.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub length: Option<f64>,
    /// Coefficient of restitution when it becomes taut.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub restitution: f64,
}

/// A cylindrical joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylindricalEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the axis at t = 0, m, world.
    pub anchor: Vector,
    /// The direction of the axis at t = 0, world; of any length but zero.
    pub axis: Vector,
    /// What acts along the angle of the first body about the axis, relative to the second one or the world.
    pub angle: Option<FreedomEntry>,
    /// What acts along its displacement along the axis.
    pub displacement: Option<FreedomEntry>,
}

/// A screw.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScrewEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the axis at t = 0, m, world.
    pub anchor: Vector,
    /// The direction of the axis at t = 0, world; of any length but zero.
    pub axis: Vector,
    /// The displacement along the axis for each revolution, m: positive for a right-handed thread, not zero.
    pub lead: f64,
    /// What acts along the angle of the first body about the axis, relative to the second one or the world.
    pub angle: Option<FreedomEntry>,
}

/// A universal joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniversalJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// The point at t = 0, m, world.
    pub anchor: Vector,
    /// The directions of the axes at t = 0, world, at right angles: the first of the first body, the second of the
    /// other or of the world.
    pub axes: Exactly<Vector, 2>,
}

/// A planar joint.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanarJointEntry {
    /// Names of the two bodies; of one that is held by the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// A point of the plane at t = 0, m, world.
    pub anchor: Vector,
    /// The normal of the plane at t = 0, world; of any length but zero.
    pub normal: Vector,
}

/// A joint that holds a point of a body to a track.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrackJointEntry {
    /// Names of the body, and of the one that the track is fixed in; without a second one that is the world.
    #[schemars(length(min = 1, max = 2))]
    pub bodies: Vec<String>,
    /// Name of the track.
    pub track: String,
    /// The point of the body at t = 0, m, world.
    pub anchor: Vector,
    /// What of the body follows the track.
    #[serde(default)]
    pub follows: FollowsName,
    /// With `follows = "frame"`: the direction at t = 0, world, against which the body does not lean; without this key
    /// the normal of the plane of the track.
    pub up: Option<Vector>,
    /// One-sided: the track only pushes, to the side to which this direction points at t = 0, world. Without this key
    /// it holds from both sides.
    pub side: Option<Vector>,
    /// Coefficient of restitution where the body lands on a one-sided track, and at `ends = "stops"`.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub restitution: Option<f64>,
    /// Springs and dampers in the place of a constraint.
    pub springs: Option<TrackSpringsEntry>,
    /// What happens at the ends of an open track.
    #[serde(default)]
    pub ends: TrackEndsName,
    /// What acts along the displacement of the body on the track.
    pub displacement: Option<FreedomEntry>,
}
