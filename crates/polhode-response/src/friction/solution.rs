//! What comes out of a frictional contact problem.

use crate::friction::linearisation::ContactStatus;
use crate::method_set::{ChainMethod, MethodSet};
use crate::report::SolverStatus;

/// Which method gave the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum FrictionMethod {
    /// Block Gauss-Seidel: one contact, or contacts that do not move each other, are solved by a sweep or two.
    #[default]
    GaussSeidel,
    /// Newton's method from the start given.
    WarmNewton,
    /// Newton's method from some sweeps of block Gauss-Seidel.
    Newton,
    /// Newton's method from zero, after that.
    NewtonFromZero,
    /// Newton's method for contacts that yield a little around the last answer, until there is nothing left to yield
    /// to.
    ProximalNewton,
    /// Newton's method without damping, with the least of all steps where contacts are redundant.
    LeastNormNewton,
    /// The same from zero, after other cold starts.
    LeastNormFromZero,
    /// Newton's method once more, with damping that gives way: large mass ratios.
    YieldingNewton,
    /// Newton's method from a convex cone programme.
    ConeProgrammeNewton,
    /// The last resort: many sweeps of block Gauss-Seidel, then Newton's method.
    GaussSeidelNewton,
}

impl FrictionMethod {
    /// The name of the method in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::GaussSeidel => "gauss-seidel",
            Self::WarmNewton => "warm-newton",
            Self::Newton => "newton",
            Self::NewtonFromZero => "newton-from-zero",
            Self::ProximalNewton => "proximal-newton",
            Self::LeastNormNewton => "least-norm-newton",
            Self::LeastNormFromZero => "least-norm-from-zero",
            Self::YieldingNewton => "yielding-newton",
            Self::ConeProgrammeNewton => "cone-programme-newton",
            Self::GaussSeidelNewton => "gauss-seidel-newton",
        }
    }

    /// Whether the first methods tried did not succeed.
    pub const fn is_fallback(self) -> bool {
        matches!(self, Self::YieldingNewton | Self::ConeProgrammeNewton | Self::GaussSeidelNewton)
    }
}

impl ChainMethod for FrictionMethod {
    const ALL: &'static [Self] = &[
        Self::WarmNewton,
        Self::GaussSeidel,
        Self::ProximalNewton,
        Self::LeastNormNewton,
        Self::Newton,
        Self::NewtonFromZero,
        Self::LeastNormFromZero,
        Self::YieldingNewton,
        Self::ConeProgrammeNewton,
        Self::GaussSeidelNewton,
    ];

    fn name(self) -> &'static str {
        Self::name(self)
    }
}

/// The certificate of one solve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct FrictionReport {
    /// How it ended.
    pub status: SolverStatus,
    /// Which method gave the answer.
    pub method: FrictionMethod,
    /// Which were tried.
    pub tried: MethodSet<FrictionMethod>,
    /// Steps of Newton's method, of all starts.
    pub newton_steps: usize,
    /// Sweeps of block Gauss-Seidel.
    pub sweeps: usize,
    /// Iterations of the interior point.
    pub cone_iterations: usize,
    /// See [`FrictionProblem::residual`](crate::friction::FrictionProblem::residual).
    pub residual: f64,
    /// The residual that rounding of `G r + q` alone leaves (no unit): a solution to this is solved.
    pub rounding: f64,
}

impl FrictionReport {
    /// Iterations of all methods.
    pub const fn iterations(&self) -> usize {
        self.newton_steps + self.sweeps + self.cone_iterations
    }
}

/// Reactions that satisfy Coulomb's law.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct FrictionSolution {
    /// `r`: for each block the normal reaction, then the tangential ones.
    pub reactions: Vec<f64>,
    /// `u = G r + q`.
    pub velocities: Vec<f64>,
    /// What each contact does.
    pub statuses: Vec<ContactStatus>,
    /// What each contact does in its slip, its rolling and its spinning; open for what it does not resist.
    pub parts: Vec<[ContactStatus; 3]>,
    /// When the problem is [infeasible](SolverStatus::Infeasible): normal reactions `z >= 0`, the largest 1, that move
    /// nothing, `G z = 0`, and with `q.z < 0`. Since `z.u = z.(G r + q) = q.z` for all `r` (`G` symmetric), no
    /// reactions make all normal velocities `u_n >= 0`: the contacts of its positive entries squeeze bodies between
    /// them. Otherwise empty.
    pub squeeze: Vec<f64>,
    /// The certificate.
    pub report: FrictionReport,
}
