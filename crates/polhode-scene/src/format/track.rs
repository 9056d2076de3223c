//! Tracks: curves that points of bodies follow, and how.

use super::exactly::{Exactly, Vector};
use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of curve, for messages.
pub(crate) const CURVES: &str = "line, circle, helix, path, spline, polynomial, wave or cycloid";

/// A track: a curve of the world at t = 0, which joints hold bodies to.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrackEntry {
    /// Its name, which no other track has.
    pub name: String,
    /// Its curve.
    pub curve: CurveEntry,
}

/// Kinds of curve.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CurveEntry {
    /// The straight line between two points.
    Line(LineEntry),
    /// A circle.
    Circle(CircleEntry),
    /// A helix.
    Helix(HelixEntry),
    /// Straight parts, arcs of circles and clothoids in a plane, one after the other.
    Path(PathEntry),
    /// The cubic spline through points.
    Spline(SplineEntry),
    /// Coordinates that are polynomials of a parameter.
    Polynomial(PolynomialEntry),
    /// A wave, which begins on a crest.
    Wave(WaveEntry),
    /// A cycloid.
    Cycloid(CycloidEntry),
}

/// A line.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineEntry {
    /// Its ends, m, world.
    pub points: Exactly<Vector, 2>,
}

/// A circle.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleEntry {
    /// Its center, m, world.
    pub center: Vector,
    /// Its axis, of any length but zero: the circle runs anticlockwise about it.
    pub axis: Vector,
    /// Its radius, m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: f64,
}

/// A helix.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HelixEntry {
    /// Its first point, m, world.
    pub start: Vector,
    /// A point of its axis, m, world.
    pub center: Vector,
    /// The direction of its axis, of any length but zero: the helix runs anticlockwise about it.
    pub axis: Vector,
    /// Displacement along the axis for each turn, m.
    pub advance: f64,
    /// How many turns.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub turns: f64,
}

/// A path in a plane.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PathEntry {
    /// Its first point, m, world.
    pub start: Vector,
    /// The direction in which it begins, of any length but zero.
    pub heading: Vector,
    /// The side to which positive curvature bends; with `heading` it spans the plane.
    pub up: Vector,
    /// Its parts.
    #[schemars(length(min = 1))]
    pub parts: Vec<BendEntry>,
}

/// A part of a path: by `length` and `curvature`, or an arc of a circle by `radius` and `angle`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BendEntry {
    /// Its length, m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub length: Option<f64>,
    /// Curvature at its start and its end, 1/m, between which it changes evenly; straight without this key.
    pub curvature: Option<Exactly<f64, 2>>,
    /// Radius of an arc, m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: Option<f64>,
    /// By which angle an arc bends, rad: positive up, negative down.
    pub angle: Option<f64>,
}

/// A spline.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SplineEntry {
    /// Points on it, m, world.
    #[schemars(length(min = 2))]
    pub points: Vec<Vector>,
    /// Whether it goes on from the last point to the first one.
    #[serde(default)]
    pub closed: bool,
}

/// Coordinates that are polynomials.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PolynomialEntry {
    /// Coefficients from the lowest, m, world: the point at `u` is the sum of the k-th one times `u^k`.
    #[schemars(length(min = 2))]
    pub coefficients: Vec<Vector>,
    /// The first and the last `u`.
    pub range: Exactly<f64, 2>,
}

/// A wave.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WaveEntry {
    /// The point in the middle of its height below its first crest, m, world.
    pub start: Vector,
    /// The direction in which it runs, of any length but zero.
    pub heading: Vector,
    /// The direction of its crests, at an angle to `heading`.
    pub up: Vector,
    /// Height of its crests above the middle, m; negative where it begins in a trough.
    pub amplitude: f64,
    /// From crest to crest, m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub wavelength: f64,
    /// Along `heading`, m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub length: f64,
}

/// A cycloid.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CycloidEntry {
    /// Its lowest point, m, world.
    pub lowest: Vector,
    /// Its direction there, of any length but zero.
    pub heading: Vector,
    /// The direction of its cusps, at an angle to `heading`.
    pub up: Vector,
    /// Radius of the wheel that makes it, m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: f64,
    /// By how much the wheel turns to either side, rad: below pi.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub angle: f64,
}

/// Springs across a track.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrackSpringsEntry {
    /// Force for each metre from the track, N/m.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub stiffness: f64,
    /// Force against each m/s across the track, N s/m.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub damping: f64,
    /// Distance from the track beyond which there is no force, m; without this key there is no such distance.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub reach: Option<f64>,
}

/// What of a body follows a track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FollowsName {
    /// The point: the body turns about it freely.
    #[default]
    Point,
    /// The tangent too: the body rolls about it freely.
    Tangent,
    /// The tangent and a direction across it: the body turns with the track.
    Frame,
}

/// What happens at the ends of an open track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TrackEndsName {
    /// The body leaves the track, and is free from then on.
    #[default]
    Free,
    /// The body is stopped, with the restitution of the joint.
    Stops,
    /// The track goes on straight.
    Straight,
}
