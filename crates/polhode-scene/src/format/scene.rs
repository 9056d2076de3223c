//! The document: everything but methods, bodies and forces.

use super::exactly::{Exactly, Vector};
use super::{
    ArrayEntry, BodyEntry, ForceEntry, FrictionEntry, GearEntry, JointEntry, MethodEntry, ModelEntry, PromiseEntry,
    StaticFrictionEntry, TrackEntry, UncertainEntry, ViewEntry,
};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A scene of rigid bodies. SI units, z up unless gravity says otherwise, quaternions [w, x, y, z].
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Polhode scene, version 1")]
pub struct SceneFile {
    /// Version of the format: 1.
    #[schemars(range(min = 1, max = 1))]
    pub format: u32,
    /// Name of the scene; the name of the file when absent.
    pub name: Option<String>,
    /// What the scene is, in a few words: a heading.
    pub title: Option<String>,
    /// What the scene shows and what to look at, in a sentence or a few. Line breaks count as spaces.
    pub description: Option<String>,
    /// Simulated time, s; 1 when absent.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: Option<f64>,
    /// Acceleration of gravity, m/s^2; [0, 0, -9.81] when absent.
    pub gravity: Option<Vector>,
    /// How the scene is simulated; the plan chooses what is absent.
    #[serde(default)]
    pub method: MethodEntry,
    /// How far the run may be from its scene and still end well.
    #[serde(default)]
    pub promise: PromiseEntry,
    /// What is written.
    #[serde(default)]
    pub output: OutputEntry,
    /// Materials by name.
    #[serde(default)]
    pub materials: BTreeMap<String, MaterialEntry>,
    /// What two materials do to each other instead of the default rule.
    #[serde(default)]
    pub pairs: Vec<PairEntry>,
    /// The bodies.
    #[serde(default)]
    pub bodies: Vec<BodyEntry>,
    /// Many equal bodies each; they follow the others in this order.
    #[serde(default)]
    pub arrays: Vec<ArrayEntry>,
    /// Robots from files of their own; their bodies follow those of the arrays in this order.
    #[serde(default)]
    pub models: Vec<ModelEntry>,
    /// Forces besides uniform gravity and contact.
    #[serde(default)]
    pub forces: Vec<ForceEntry>,
    /// What holds two bodies, or a body and the world, together. Jointed bodies do not collide with each other.
    #[serde(default)]
    pub joints: Vec<JointEntry>,
    /// Curves that joints hold bodies to.
    #[serde(default)]
    pub tracks: Vec<TrackEntry>,
    /// Coordinates of two joints that move together.
    #[serde(default)]
    pub gears: Vec<GearEntry>,
    /// Groups of bodies that do not collide with each other.
    #[serde(default)]
    pub no_contact: Vec<NoContactEntry>,
    /// How the scene starts.
    #[serde(default)]
    pub start: StartEntry,
    /// What is uncertain: `polhode sweep` draws it, a run has what the scene says.
    #[serde(default)]
    pub uncertain: Vec<UncertainEntry>,
    /// From where pictures and pages show the scene. No motion depends on it.
    #[serde(default)]
    pub view: ViewEntry,
}

/// How the scene starts.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartEntry {
    /// Bodies that overlap at t = 0 by at most this, m, are moved apart, and the report says so; 0 when absent: bodies
    /// that overlap by more than counts as touch (1e-9 of their size) are refused.
    #[schemars(range(min = 0))]
    pub separate: Option<f64>,
}

/// What is written.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutputEntry {
    /// Time between samples, s; 0.01 when absent. The first sample is t = 0, the last exactly the duration.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub interval: Option<f64>,
}

/// The keys of a material.
pub const MATERIAL_KEYS: [&str; 9] = [
    "friction",
    "static_friction",
    "rolling_friction",
    "spinning_friction",
    "restitution",
    "restitution_yield_speed",
    "restitution_slope",
    "youngs_modulus_pa",
    "poisson_ratio",
];

/// A material.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialEntry {
    /// Coefficient of kinetic friction; 0 when absent. Two materials: the geometric mean. Or a table of coefficients
    /// along and across a grain: of two materials that meet one may have a grain, unless a rule for the pair says more.
    pub friction: Option<FrictionEntry>,
    /// Coefficient of static friction, at least that of kinetic friction; the same when absent. Two materials: the
    /// geometric mean. Or a table, if `friction` is one.
    pub static_friction: Option<StaticFrictionEntry>,
    /// Friction of rolling, m: the moment that resists rolling is at most this times the normal force; 0 when absent.
    /// Two materials: the geometric mean.
    #[schemars(range(min = 0))]
    pub rolling_friction: Option<f64>,
    /// Friction of spinning about the normal, m: the moment that resists it is at most this times the normal force; 0
    /// when absent. Two materials: the geometric mean.
    #[schemars(range(min = 0))]
    pub spinning_friction: Option<f64>,
    /// Coefficient of restitution in [0, 1]; 0 when absent. Two materials: the larger one at the speed.
    #[schemars(range(min = 0, max = 1))]
    pub restitution: Option<f64>,
    /// Speed of approach, m/s, above which restitution falls with the power -1/4 of the speed.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub restitution_yield_speed: Option<f64>,
    /// By how much restitution falls for each metre a second of the speed of approach, s/m; not below 0.
    #[schemars(range(min = 0))]
    pub restitution_slope: Option<f64>,
    /// Young's modulus, Pa, for springs after Hertz; a material without one is rigid.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio in [0, 0.5], for springs after Hertz and the tangential stiffness of linear ones; with
    /// `youngs_modulus_pa`, 0.3 when absent.
    #[schemars(range(min = 0, max = 0.5))]
    pub poisson_ratio: Option<f64>,
}

/// What two materials do to each other instead of the default rule; what is absent keeps the rule.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PairEntry {
    /// Names of the two materials, in any order, unless `friction` has a direction.
    pub materials: Exactly<String, 2>,
    /// Coefficient of kinetic friction, or a table of coefficients along and across a grain: that of the bodies of the
    /// first material if the table has a direction.
    pub friction: Option<FrictionEntry>,
    /// Coefficient of static friction, at least that of kinetic friction; the same when absent. Or a table.
    pub static_friction: Option<StaticFrictionEntry>,
    /// Friction of rolling, m.
    #[schemars(range(min = 0))]
    pub rolling_friction: Option<f64>,
    /// Friction of spinning, m.
    #[schemars(range(min = 0))]
    pub spinning_friction: Option<f64>,
    /// Coefficient of restitution in [0, 1].
    #[schemars(range(min = 0, max = 1))]
    pub restitution: Option<f64>,
    /// Speed of approach, m/s, above which restitution falls with the power -1/4 of the speed.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub restitution_yield_speed: Option<f64>,
    /// By how much restitution falls for each metre a second of the speed of approach, s/m; not below 0.
    #[schemars(range(min = 0))]
    pub restitution_slope: Option<f64>,
}

/// Bodies that do not collide with each other.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NoContactEntry {
    /// Names of two or more bodies.
    #[schemars(length(min = 2))]
    pub bodies: Vec<String>,
}
