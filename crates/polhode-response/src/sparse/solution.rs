//! What comes out of a problem in the velocities of bodies.

use crate::friction::ContactStatus;
use crate::method_set::{ChainMethod, MethodSet};
use crate::report::SolverStatus;

/// Which method gave the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum BodyMethod {
    /// No method was needed: reactions given, or none, are an answer.
    #[default]
    Start,
    /// Newton's method from the reactions given.
    Warm,
    /// The interior point alone.
    InteriorPoint,
    /// Newton's method from the interior point.
    Newton,
    /// The smoothing Newton method.
    Smoothing,
    /// The path of compliance.
    Compliance,
    /// Sweeps over all contacts.
    Sweeps,
    /// The augmented Lagrangian of a problem without friction.
    Lagrangian,
    /// As a stage only: the path of compliance from no reactions.
    FarCompliance,
    /// As a stage only: Newton's method from the best answer, at the end.
    LastNewton,
}

impl BodyMethod {
    /// The name of the method in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Warm => "warm-newton",
            Self::InteriorPoint => "interior-point",
            Self::Newton => "newton",
            Self::Smoothing => "smoothing-newton",
            Self::Compliance => "compliance-path",
            Self::Sweeps => "sweeps",
            Self::Lagrangian => "augmented-lagrangian",
            Self::FarCompliance => "far-compliance-path",
            Self::LastNewton => "last-newton",
        }
    }
}

impl ChainMethod for BodyMethod {
    const ALL: &'static [Self] = &[
        Self::Start,
        Self::Warm,
        Self::Sweeps,
        Self::Lagrangian,
        Self::InteriorPoint,
        Self::Newton,
        Self::Compliance,
        Self::Smoothing,
        Self::FarCompliance,
        Self::LastNewton,
    ];

    fn name(self) -> &'static str {
        Self::name(self)
    }
}

/// The certificate of one solve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct BodyReport {
    /// How it ended.
    pub status: SolverStatus,
    /// Which method gave the answer.
    pub method: BodyMethod,
    /// The stage of the chain that gave it: Newton's method ends several of them.
    pub stage: BodyMethod,
    /// Which stages were tried.
    pub tried: MethodSet<BodyMethod>,
    /// Natural map in units of impulse, per unit of the largest reaction: see the module's text.
    pub residual: f64,
    /// Natural map in units of velocity, balanced by the load of each contact, per unit of the largest velocity without
    /// reactions: under heavy loads that of light bodies.
    pub balanced_residual: f64,
    /// The residual, or the share of the balanced one that counts, where that is larger: what decides whether the
    /// problem is solved.
    pub rank: f64,
    /// Factorisations of all methods.
    pub factorisations: usize,
    /// Those of a warm start.
    pub warm: usize,
    /// Whether the elimination of the last solve was kept.
    pub kept_elimination: bool,
}

/// Reactions that satisfy the laws, and what they do.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct BodySolution {
    /// `r` of all rows.
    pub reactions: Vec<f64>,
    /// `u = H v + b + C r` of all rows.
    pub rates: Vec<f64>,
    /// `v` of every body.
    pub velocities: Vec<[f64; 6]>,
    /// What each contact does.
    pub statuses: Vec<ContactStatus>,
    /// What it does in its slip, its rolling and its spinning; open for what it does not resist.
    pub parts: Vec<[ContactStatus; 3]>,
    /// The certificate.
    pub report: BodyReport,
}
