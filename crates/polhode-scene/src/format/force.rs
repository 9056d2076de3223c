//! Forces besides uniform gravity and contact.

use super::exactly::{Exactly, Vector};
use super::signal::SignalEntry;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::json;

/// A force.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ForceEntry {
    /// What kind of force.
    #[serde(rename = "type")]
    pub kind: ForceKind,
}

/// Kinds of force.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ForceKind {
    /// Attraction of every body that moves by a fixed point.
    PointGravity(PointGravityEntry),
    /// Attraction between the centres of mass of all pairs of bodies that move.
    MutualGravity(MutualGravityEntry),
    /// A force on one body.
    Force(AppliedForceEntry),
    /// A torque on one body.
    Torque(AppliedTorqueEntry),
    /// Drag of a medium.
    Drag(DragEntry),
    /// A spring, with a damper along it when damping is given.
    Spring(SpringEntry),
}

/// Attraction by a fixed point.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointGravityEntry {
    /// The point, m, world; the origin when absent.
    pub center: Option<Vector>,
    /// Gravitational parameter G M, m^3/s^2.
    #[schemars(range(min = 0))]
    pub mu: f64,
}

/// Attraction between bodies.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MutualGravityEntry {
    /// Constant of gravitation, m^3/(kg s^2); nature's, 6.6743e-11, when absent.
    #[schemars(range(min = 0))]
    pub constant: Option<f64>,
}

/// A force on one body.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AppliedForceEntry {
    /// Name of the body.
    pub body: String,
    /// The force, N, along the axes of the frame.
    pub force: Vector,
    /// The axes that the force is along; world when absent.
    pub frame: Option<FrameName>,
    /// Where the force acts, m, in the body's own frame; the centre of mass when absent.
    pub point: Option<Vector>,
    /// What the force is multiplied by; 1 when absent.
    pub signal: Option<SignalEntry>,
}

/// A torque on one body.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AppliedTorqueEntry {
    /// Name of the body.
    pub body: String,
    /// The torque, N m, along the axes of the frame.
    pub torque: Vector,
    /// The axes that the torque is along; world when absent.
    pub frame: Option<FrameName>,
    /// What the torque is multiplied by; 1 when absent.
    pub signal: Option<SignalEntry>,
}

/// Axes that a vector is along.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FrameName {
    /// The world's.
    World,
    /// The body's own: the vector turns with the body.
    Body,
}

/// Drag of a medium.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("anyOf" = json!([{ "required": ["translational"] }, { "required": ["rotational"] }])))]
pub struct DragEntry {
    /// Name of the body; or bodies. Every body that moves when both are absent.
    pub body: Option<String>,
    /// Names of the bodies; or body.
    #[schemars(length(min = 1))]
    pub bodies: Option<Vec<String>>,
    /// How drag grows with speed.
    pub law: DragLawName,
    /// Coefficient of translation, N s/m (linear) or N s^2/m^2 (quadratic); 0 when absent.
    #[schemars(range(min = 0))]
    pub translational: Option<f64>,
    /// Coefficient of rotation, N m s (linear) or N m s^2 (quadratic); 0 when absent.
    #[schemars(range(min = 0))]
    pub rotational: Option<f64>,
    /// Velocity of the medium, m/s, world; [0, 0, 0] when absent.
    pub wind: Option<Vector>,
}

/// How drag grows with speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DragLawName {
    /// In proportion: slow, in a viscous medium.
    Linear,
    /// With its square: fast, the coefficient of translation is density C_d area/2.
    Quadratic,
}

/// A spring between two bodies (bodies, points), or a body and the world (body, point, anchor).
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = json!([{ "required": ["bodies"] }, { "required": ["body", "anchor"] }])))]
pub struct SpringEntry {
    /// Names of the two bodies that it joins.
    pub bodies: Option<Exactly<String, 2>>,
    /// Where it is fastened to each of them, m, in their own frames; their origins when absent.
    pub points: Option<Exactly<Vector, 2>>,
    /// Name of the one body that it joins to the world.
    pub body: Option<String>,
    /// Where it is fastened to that body, m, in its own frame; its origin when absent.
    pub point: Option<Vector>,
    /// Where it is fastened to the world, m.
    pub anchor: Option<Vector>,
    /// Stiffness, N/m.
    #[schemars(range(min = 0))]
    pub stiffness: f64,
    /// Length at which it pulls nothing, m; its length at the start when absent.
    #[schemars(range(min = 0))]
    pub rest_length: Option<f64>,
    /// Damping along it, N s/m; 0 when absent.
    #[schemars(range(min = 0))]
    pub damping: Option<f64>,
}
