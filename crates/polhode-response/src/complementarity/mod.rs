//! Contact forces by complementarity: `0 <= f _|_ w = G f + b >= 0`.
//!
//! `f_i` is the force of contact `i` (N; impulse, N s), `w_i` its acceleration of separation (m/s^2; velocity, m/s),
//! `b_i` that without contact forces (thesis, equation 18). The law is the thesis's (a), (b), (c) of section 3.4 with
//! the signs of errata E11 and E16. `G` is positive semidefinite, so this is the optimality condition of the convex
//! problem `min 1/2 f.G f + b.f, f >= 0`: the motion is unique (Gauss's principle), the forces in general are not
//! (errata E13, E14); [`minimum_norm`](crate::minimum_norm()) chooses among them.
//!
//! A bilateral row asks for `w_i = 0` instead, with a force of either sign: it is always in the active set, or depends
//! on bilateral rows that are. Rows that contradict each other end as [`Inaccurate`](crate::SolverStatus::Inaccurate).
//!
//! Method: an active set, exact up to rounding, warm-started from the rows that carried force last time; where
//! rows depend on each other nearly, or squeeze bodies, the same active set in twice the precision, which tells
//! directions apart down to 1e-14 and certifies that there are no forces. (Starts from all rows, a cold start after a
//! warm one, and an interior point behind the active set, never gave an answer: docs/census.md.)
//!
//! | module | holds |
//! |---|---|
//! | `active_set` | the active set |
//! | `rank` | whether a row depends on the rows that carry force |
//! | `solver` | the solver with its fallbacks and its certificate |
//! | `with_forest` | problems of bodies in trees of joints |

pub(crate) mod active_set;
pub(crate) mod rank;
mod solver;
mod with_forest;

pub use solver::{ComplementaritySolver, solve_complementarity};

use crate::report::SolverReport;

/// The rows that carried force, to start the next solve from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct WarmStart {
    rows: Vec<usize>,
}

impl WarmStart {
    /// Starts from these rows; rows that do not exist and repetitions are ignored.
    pub fn new(rows: Vec<usize>) -> Self {
        Self { rows }
    }

    /// The rows, in the order in which they entered.
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }
}

/// Forces and accelerations that satisfy the law of contact.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ContactSolution {
    /// `f`, never negative on unilateral rows.
    pub forces: Vec<f64>,
    /// `w`: exactly 0 for held rows.
    pub residual_accelerations: Vec<f64>,
    /// Which rows are held: `w = 0` to within `closed_cut`, with or without a force. This set is unique.
    pub held: Vec<bool>,
    /// When the problem is [infeasible](crate::SolverStatus::Infeasible): forces `z >= 0`, the largest 1, that move no
    /// body, `J^T z = 0`, and with `b.z < 0`. The rows of its positive entries squeeze bodies between them. Since
    /// `z.w = z.(G f + b) = b.z`, no forces `f` make all `w >= 0` (lemma of Farkas). Otherwise empty.
    pub squeeze: Vec<f64>,
    /// Start for a similar problem.
    pub warm_start: WarmStart,
    /// The certificate.
    pub report: SolverReport,
}
