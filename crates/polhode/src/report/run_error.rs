//! The estimated error of a run: how far the motion that was computed is from the exact one of the scene as written.

use crate::identity::body_id::BodyId;
use crate::scene::ErrorEstimation;
use serde::{Deserialize, Serialize};

/// How far a body is from where it should be.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct BodyError {
    /// Of its own origin, m.
    pub position_m: f64,
    /// Of its attitude, rad.
    pub rotation_rad: f64,
}

impl BodyError {
    /// An error of so much, m and rad.
    pub const fn new(position_m: f64, rotation_rad: f64) -> Self {
        Self { position_m, rotation_rad }
    }

    /// How far any point of a body of this size (m) is off, at most, relative to its size; in metres for a body without
    /// one.
    pub fn of_size(&self, size_m: f64) -> f64 {
        if size_m > 0.0 { self.position_m / size_m + self.rotation_rad } else { self.position_m }
    }

    /// The larger ones of both.
    pub(crate) fn max(self, other: Self) -> Self {
        // A number that is not known is larger than any other.
        let larger = |a: f64, b: f64| if a >= b || a.is_nan() { a } else { b };
        Self::new(larger(self.position_m, other.position_m), larger(self.rotation_rad, other.rotation_rad))
    }

    /// The smaller ones of both.
    pub(crate) fn min(self, other: Self) -> Self {
        Self::new(self.position_m.min(other.position_m), self.rotation_rad.min(other.rotation_rad))
    }

    /// Both by so many times.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self::new(self.position_m * factor, self.rotation_rad * factor)
    }

    /// The sums of both.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self::new(self.position_m + other.position_m, self.rotation_rad + other.rotation_rad)
    }
}

/// The largest error of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LargestError {
    /// Of the size of the body (no unit).
    pub relative: f64,
    /// The same in metres and radians.
    pub error: BodyError,
    /// The body.
    pub body: BodyId,
    /// When, s.
    pub t_s: f64,
}

/// A kind of run beside a run, with which it is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[non_exhaustive]
pub enum ReferenceKind {
    /// By another method.
    OtherMethod,
    /// By the same method with other steps.
    OtherSteps,
    /// By the same method from a start that differs by rounding.
    Disturbed,
}

impl ReferenceKind {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::OtherMethod, Self::OtherSteps, Self::Disturbed];

    /// Its name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::OtherMethod => "another method",
            Self::OtherSteps => "other steps",
            Self::Disturbed => "a start disturbed by rounding",
        }
    }
}

/// The runs of one kind with which a run was compared.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ReferenceReport {
    /// The kind.
    pub kind: ReferenceKind,
    /// By which method and steps, in words.
    pub method: String,
    /// For how long, s.
    pub covered_s: f64,
    /// Their work, of that of the run, as it is counted (no unit).
    pub work: f64,
    /// How far the run was from them at most, of the size of a body.
    pub largest_distance: f64,
    /// Why the last one ended before the run did, in words.
    pub ended: Option<String>,
}

/// The estimated error of a run.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct RunError {
    /// How it was estimated.
    pub estimation: ErrorEstimation,
    /// The largest error of any body at any comparison before the horizon; none where nothing was compared.
    pub largest: Option<LargestError>,
    /// When an error first exceeded what the run promises, s; none where none did before the horizon.
    pub exceeds_s: Option<f64>,
    /// The errors at the end, by [`BodyId::index`]; empty where nothing was compared.
    pub bodies: Vec<BodyError>,
    /// When a difference of rounding at the start has grown to a hundredth of a body, s: what lies after it is one of
    /// many outcomes. None where it has not within the run, or that was not examined.
    pub horizon_s: Option<f64>,
    /// With what the run was compared.
    pub references: Vec<ReferenceReport>,
}

impl RunError {
    /// The largest error of the size of a body; none where nothing was compared.
    pub fn relative(&self) -> Option<f64> {
        self.largest.map(|largest| largest.relative)
    }
}
