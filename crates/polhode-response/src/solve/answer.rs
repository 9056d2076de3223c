//! What rows took: the answer of each solve.

use crate::complementarity::ContactSolution;
use crate::friction::{BlocksSolution, ContactStatus};
use crate::guesses::GuessedForces;
use crate::least_force::{LeastForceSolution, LeastForceStage};
use crate::least_norm_hold::LeastNormForces;
use crate::report::{SolverReport, SolverStatus};
use crate::sparse::ForestSolution;

/// Whether the motion depends on which of several forces are taken that hold all contacts as well.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    /// It does not.
    Idle,
    /// It does.
    DecidesMotion,
}

/// What rows took, in the order of the problem.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct Answer {
    /// Forces (N), impulses (N s), or what displaces bodies.
    pub reactions: Vec<f64>,
    /// What is left of the constant terms: accelerations (m/s^2), velocities (m/s) or gaps (m). Empty at a stage.
    pub velocities: Vec<f64>,
    /// What the contact of each block does; empty without blocks.
    pub statuses: Vec<ContactStatus>,
    /// What it does in its slip, its rolling and its spinning; open for what it does not resist.
    pub parts: Vec<[ContactStatus; 3]>,
    /// What the reactions add up to on each body, `J^T f`, in blocks of the problem's width: at large ratios of masses
    /// only, where the sum of the rounded ones would accelerate light bodies.
    pub on_bodies: Option<Vec<f64>>,
    /// Where the least forces with which all contacts hold while some slide are the answer: whether others would give
    /// another motion.
    pub choice: Option<Choice>,
    /// Whether no forces within the cones of the contacts that stick hold the rows, so that these are beyond them.
    pub beyond_cones: bool,
    /// By a method of the thesis: what it took for contacts that vanish.
    pub stage: Option<LeastForceStage>,
    /// What rounding of the reactions may leave of accelerations, m/s^2; 0 where it is not known.
    pub rounding: f64,
    /// The certificate.
    pub report: SolverReport,
}

impl From<BlocksSolution> for Answer {
    fn from(solved: BlocksSolution) -> Self {
        let BlocksSolution { reactions, velocities, statuses, parts, report } = solved;
        Self { reactions, velocities, statuses, parts, report, ..Self::default() }
    }
}

impl From<ContactSolution> for Answer {
    fn from(solved: ContactSolution) -> Self {
        let ContactSolution { forces: reactions, residual_accelerations: velocities, report, .. } = solved;
        Self { reactions, velocities, report, ..Self::default() }
    }
}

impl From<LeastNormForces> for Answer {
    fn from(least: LeastNormForces) -> Self {
        Self { reactions: least.forces, on_bodies: least.loads, ..Self::default() }
    }
}

impl From<ForestSolution> for Answer {
    fn from(held: ForestSolution) -> Self {
        Self { reactions: held.forces, velocities: held.rates, ..Self::default() }
    }
}

impl From<LeastForceSolution> for Answer {
    fn from(solved: LeastForceSolution) -> Self {
        let LeastForceSolution { forces: reactions, residual_accelerations: velocities, stage, report, .. } = solved;
        Self { reactions, velocities, stage: Some(stage), report, ..Self::default() }
    }
}

impl From<GuessedForces> for Answer {
    fn from(solved: GuessedForces) -> Self {
        let GuessedForces { forces: reactions, residual_accelerations: velocities, vanishing, report, .. } = solved;
        let stage = match report.status {
            SolverStatus::Infeasible => LeastForceStage::NoForces,
            _ if vanishing.is_empty() => LeastForceStage::NoneVanish,
            _ => LeastForceStage::GuessOfVanishing,
        };
        Self { reactions, velocities, stage: Some(stage), report, ..Self::default() }
    }
}
