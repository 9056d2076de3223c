//! What is written: our scene format, as far as the suite's scenes need it.

use serde::Serialize;
use std::collections::BTreeMap;

/// Name of the material of all bodies.
pub(super) const MATERIAL: &str = "all";

/// A scene file.
#[derive(Debug, Serialize)]
pub(super) struct SceneText {
    pub(super) format: u32,
    pub(super) name: String,
    /// Simulated time, s.
    pub(super) duration: f64,
    /// m/s^2.
    pub(super) gravity: [f64; 3],
    pub(super) output: OutputText,
    pub(super) materials: BTreeMap<&'static str, MaterialText>,
    pub(super) bodies: Vec<BodyText>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) forces: Vec<ForceText>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) no_contact: Vec<NoContactText>,
}

#[derive(Debug, Serialize)]
pub(super) struct OutputText {
    /// Time between samples, s.
    pub(super) interval: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct MaterialText {
    pub(super) friction: f64,
    pub(super) restitution: f64,
}

/// A body. Position is of the mesh's origin, velocity of the centre of mass: as in the suite.
#[derive(Debug, Serialize)]
pub(super) struct BodyText {
    pub(super) name: String,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) fixed: bool,
    pub(super) shape: ShapeText,
    /// kg/m^3.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) density: Option<f64>,
    pub(super) position: [f64; 3],
    pub(super) orientation: [f64; 4],
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) pivot: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) velocity: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) angular_velocity: Option<[f64; 3]>,
    pub(super) material: &'static str,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ShapeText {
    Mesh(MeshText),
    Points(PointsText),
}

#[derive(Debug, Serialize)]
pub(super) struct PointsText {
    pub(super) positions: Vec<[f64; 3]>,
}

#[derive(Debug, Serialize)]
pub(super) struct MeshText {
    pub(super) file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) scale: Option<f64>,
}

#[derive(Debug, Serialize)]
pub(super) struct ForceText {
    #[serde(rename = "type")]
    pub(super) kind: ForceKindText,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum ForceKindText {
    /// At the centre of mass, N.
    Force { body: String, force: [f64; 3] },
    /// N m.
    Torque { body: String, torque: [f64; 3] },
}

#[derive(Debug, Serialize)]
pub(super) struct NoContactText {
    pub(super) bodies: Vec<String>,
}
