//! What a solver says about its own answer.

use crate::method_set::{ChainMethod, MethodSet};

/// How a solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SolverStatus {
    /// The residual is within the acceptance.
    #[default]
    Solved,
    /// There is an answer, its residual is larger than the acceptance.
    Inaccurate,
    /// No non-negative forces keep every row from approaching: bodies are squeezed between immovable ones.
    Infeasible,
}

impl SolverStatus {
    /// The name in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Inaccurate => "inaccurate",
            Self::Infeasible => "infeasible",
        }
    }
}

/// Which method gave the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Method {
    /// One row: equation (14) in complementarity form. Also problems without rows.
    #[default]
    ClosedForm,
    /// The active set given was right: one factorisation.
    WarmStart,
    /// The active set, after pivots.
    ActiveSet,
    /// Contacts with friction: a method that begins from nothing.
    ColdStart,
    /// The active set in twice the working precision: rows that nearly depend on each other, or squeeze bodies.
    PreciseActiveSet,
    /// Tried only: refinement in twice the working precision, at large mass ratios. What it refines keeps its method.
    Refinement,
    /// Tried only: all methods once more, with the rounding of the constant terms as noise.
    RoundingAsNoise,
    /// Interior point: forces that hold bodies at rest, of the greatest reserve of friction.
    InteriorPoint,
    /// Linear programme (the `thesis` tier).
    LinearProgramme,
    /// Guesses of which contacts vanish (the `thesis` tier).
    Guesses,
}

impl Method {
    /// The name in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed-form",
            Self::WarmStart => "warm-start",
            Self::ActiveSet => "active-set",
            Self::ColdStart => "cold-start",
            Self::PreciseActiveSet => "precise-active-set",
            Self::InteriorPoint => "interior-point",
            Self::Refinement => "refinement",
            Self::RoundingAsNoise => "rounding-as-noise",
            Self::LinearProgramme => "linear-programme",
            Self::Guesses => "guesses",
        }
    }

    /// Whether the first method tried did not succeed.
    pub fn is_fallback(self) -> bool {
        matches!(self, Self::ColdStart | Self::InteriorPoint)
    }
}

impl ChainMethod for Method {
    const ALL: &'static [Self] = &[
        Self::ClosedForm,
        Self::WarmStart,
        Self::ActiveSet,
        Self::ColdStart,
        Self::PreciseActiveSet,
        Self::InteriorPoint,
        Self::Refinement,
        Self::RoundingAsNoise,
        Self::LinearProgramme,
        Self::Guesses,
    ];

    fn name(self) -> &'static str {
        Self::name(self)
    }
}

/// The certificate of one solve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SolverReport {
    /// How it ended.
    pub status: SolverStatus,
    /// Which method gave the answer.
    pub method: Method,
    /// Which were tried.
    pub tried: MethodSet<Method>,
    /// Pivots of the active set, or iterations of another method.
    pub iterations: usize,
    /// Natural map residual, relative, before rows that are held are set to exactly zero:
    /// see [`natural_map_residual`](crate::certificate::natural_map_residual).
    pub residual: f64,
    /// Bound of the error of the motion in the energy norm, `|a - a*|_M` (sqrt(kg) m/s^2; impulses, sqrt(kg) m/s):
    /// linear in the residual where the active set is [certified](Self::certified), else `sqrt(f.w)`, before rows that
    /// are held are set to exactly zero. See [`certificate`](crate::certificate).
    pub bound: f64,
    /// Whether the forces are those of an active set that has been shown to be right: `bound` is then of the order of
    /// the rounding of the forces, and not of its root.
    pub certified: bool,
    /// Number of independent rows that carry the forces.
    pub rank: usize,
    /// What the answer takes for rounding in the constant terms, in their unit: the
    /// [`noise_floor`](crate::SolverSettings::noise_floor) of the settings, or more where an answer was found only so.
    pub noise_floor: f64,
    /// The residual that rounding of the terms of the problem alone leaves, where it is known (relative): large forces
    /// that cancel leave more. A solution to this is solved as exactly as its numbers allow.
    pub rounding: f64,
}

#[cfg(feature = "census")]
impl SolverReport {
    /// The method that answered, as the set of those tried names it; `noise_floor` is that of the settings.
    pub(crate) fn answered_by(&self, noise_floor: f64) -> Method {
        let has = |method| self.tried.contains(method);
        if self.noise_floor > noise_floor {
            return Method::RoundingAsNoise;
        }
        // After pivots the warm start is told as an active set.
        match self.method {
            Method::ActiveSet if !has(Method::ActiveSet) => Method::WarmStart,
            method => method,
        }
    }
}
