//! The interior-point backend: the only module that names clarabel.
//!
//! Contact forces come from the lifted form of the complementarity problem, in which the accelerations are the
//! variables and the forces the multipliers: Gauss's principle `min 1/2 x.M x` subject to `J x + b >= 0`, with
//! `x = a - a_free`. With `M_b^-1 = C_b C_b^T` and `x = C y` it reads `min 1/2 |y|^2` subject to `J C y + b >= 0`:
//! the masses, whatever their ratio, and inverse masses that are only semidefinite, are inside `C`. Rows are scaled
//! to unit length and `b` to unit size. The Delassus form loses digits with the mass ratio and is not used.
//!
//! Source: Goulart and Chen 2024 (the method); settings by measurement on towers and piles. Only the status `Solved` is
//! accepted. Failure: `None`.

use crate::dense::kernels::largest;
use crate::tolerances::LEAST_CHANGE;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus, ZeroConeT,
};

/// Gap and feasibility tolerance, relative to data of unit size (no unit); below 1e-12 there is no gain.
const TOLERANCE: f64 = 1e-12;

/// What an answer of the interior point may be off by, relative to data of unit size (no unit, 1e-10 to 1e-8): its
/// tolerance with a margin.
pub(crate) const ANSWER_ERROR: f64 = 1e-9;

/// Tolerances of linear programmes, tried in turn: singular matrices do not always allow the first. The answer is made
/// exact afterwards, and its residual is checked.
const PROGRAMME_TOLERANCES: [f64; 3] = [1e-12, 1e-10, 1e-8];

/// What a margin may be off by where the first tolerance is not met, relative to data of unit size (no unit, 1e-9 to
/// 1e-7): it is told to six digits.
const MARGIN_TOLERANCE: f64 = 1e-7;

/// Answer of a linear programme.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum LinearProgramme {
    /// A minimum.
    Solved {
        /// The variables.
        x: Vec<f64>,
        /// Iterations.
        iterations: usize,
        /// The tolerance that was met (no unit).
        tolerance: f64,
    },
    /// No point satisfies the constraints.
    Infeasible,
    /// The solver gave up.
    Failed,
}

/// `min sum x` subject to `E x = e`, `A x >= a`, `x >= 0`; `E` and `A` are row-major and dense.
pub(crate) fn least_sum(variables: usize, equal: (&[f64], &[f64]), at_least: (&[f64], &[f64])) -> LinearProgramme {
    let (equations, inequalities) = (equal.1.len(), at_least.1.len());
    let rows = equations + inequalities + variables;
    let mut triplets = (Vec::new(), Vec::new(), Vec::new());
    let mut push = |row: usize, column: usize, value: f64| {
        if value != 0.0 {
            triplets.0.push(row);
            triplets.1.push(column);
            triplets.2.push(value);
        }
    };
    for (row, line) in equal.0.chunks_exact(variables.max(1)).enumerate() {
        line.iter().enumerate().for_each(|(column, &value)| push(row, column, value));
    }
    for (row, line) in at_least.0.chunks_exact(variables.max(1)).enumerate() {
        line.iter().enumerate().for_each(|(column, &value)| push(equations + row, column, -value));
    }
    (0..variables).for_each(|column| push(equations + inequalities + column, column, -1.0));
    let mut right = equal.1.to_vec();
    right.extend(at_least.1.iter().map(|value| -value));
    right.resize(rows, 0.0);
    let constraints = CscMatrix::new_from_triplets(rows, variables, triplets.0, triplets.1, triplets.2);
    let objective = CscMatrix::<f64>::zeros((variables, variables));
    let mut cones = Vec::new();
    if equations > 0 {
        cones.push(ZeroConeT(equations));
    }
    cones.push(NonnegativeConeT(inequalities + variables));
    for tolerance in PROGRAMME_TOLERANCES {
        let gradient = vec![1.0; variables];
        let solver = DefaultSolver::new(&objective, &gradient, &constraints, &right, &cones, settings(tolerance));
        let Ok(mut solver) = solver else { return LinearProgramme::Failed };
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved => {
                let iterations = solver.solution.iterations as usize;
                return LinearProgramme::Solved { x: solver.solution.x.clone(), iterations, tolerance };
            }
            SolverStatus::PrimalInfeasible => return LinearProgramme::Infeasible,
            _ => {}
        }
    }
    LinearProgramme::Failed
}

/// What some rows of a cone programme ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ConeRows {
    /// All zero.
    Zero(usize),
    /// None negative.
    Nonnegative(usize),
    /// The first at least as large as the length of the others.
    SecondOrder(usize),
}

/// Answer of a cone programme.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum ConeProgramme {
    /// A minimum: the point and its multipliers.
    Solved {
        /// The variables `y`.
        point: Vec<f64>,
        /// One for each row.
        multipliers: Vec<f64>,
        /// Iterations.
        iterations: usize,
    },
    /// No point satisfies the constraints: multipliers `z` in the dual cones with `B^T z = 0` and `q.z < 0`.
    Infeasible {
        /// One for each row.
        multipliers: Vec<f64>,
        /// Iterations.
        iterations: usize,
    },
    /// The solver gave up.
    Failed,
}

/// `min 1/2 |y|^2` subject to `B y + q` in cones; `rows` of `B` are given by their entries `(row, column, value)`.
pub(crate) fn least_motion(
    variables: usize,
    entries: &[(usize, usize, f64)],
    constant: &[f64],
    cones: &[ConeRows],
) -> ConeProgramme {
    let size = largest(constant);
    if !(size > 0.0 && size.is_finite()) {
        return ConeProgramme::Failed;
    }
    let right: Vec<f64> = constant.iter().map(|value| value / size).collect();
    let identity = CscMatrix::identity(variables);
    let attempts = PROGRAMME_TOLERANCES.map(settings);
    in_cones((&identity, &vec![0.0; variables]), entries, (right, size), cones, &attempts)
}

/// `min c.y` subject to `B y + q` in cones, as above, to [`MARGIN_TOLERANCE`] at least; data should be of unit size.
pub(crate) fn least_cost(
    gradient: &[f64],
    entries: &[(usize, usize, f64)],
    constant: &[f64],
    cones: &[ConeRows],
) -> ConeProgramme {
    let nothing = CscMatrix::zeros((gradient.len(), gradient.len()));
    let attempt = DefaultSettings {
        reduced_tol_gap_abs: MARGIN_TOLERANCE,
        reduced_tol_gap_rel: MARGIN_TOLERANCE,
        reduced_tol_feas: MARGIN_TOLERANCE,
        ..settings(TOLERANCE)
    };
    match in_cones((&nothing, gradient), entries, (constant.to_vec(), 1.0), cones, &[attempt]) {
        // Where even that is not met a looser end may be.
        ConeProgramme::Failed => {
            let attempt = settings(MARGIN_TOLERANCE);
            in_cones((&nothing, gradient), entries, (constant.to_vec(), 1.0), cones, &[attempt])
        }
        found => found,
    }
}

/// The programme with this quadratic and linear objective, and `q` divided by `size`, by the first of some settings
/// that meets its tolerance or its reduced one.
fn in_cones(
    (quadratic, gradient): (&CscMatrix<f64>, &[f64]),
    entries: &[(usize, usize, f64)],
    (right, size): (Vec<f64>, f64),
    cones: &[ConeRows],
    attempts: &[DefaultSettings<f64>],
) -> ConeProgramme {
    let rows = entries.iter().map(|entry| entry.0).collect();
    let columns = entries.iter().map(|entry| entry.1).collect();
    let values = entries.iter().map(|entry| -entry.2).collect();
    let constraints = CscMatrix::new_from_triplets(right.len(), gradient.len(), rows, columns, values);
    let cones: Vec<_> = cones
        .iter()
        .map(|cone| match *cone {
            ConeRows::Zero(rows) => ZeroConeT(rows),
            ConeRows::Nonnegative(rows) => NonnegativeConeT(rows),
            ConeRows::SecondOrder(rows) => SecondOrderConeT(rows),
        })
        .collect();
    for attempt in attempts {
        let accepts_reduced = attempt.reduced_tol_feas == MARGIN_TOLERANCE;
        let Ok(mut solver) = DefaultSolver::new(quadratic, gradient, &constraints, &right, &cones, attempt.clone())
        else {
            return ConeProgramme::Failed;
        };
        solver.solve();
        let iterations = solver.solution.iterations as usize;
        let multipliers = || solver.solution.z.iter().map(|z| z * size).collect();
        match solver.solution.status {
            SolverStatus::Solved => {
                let point = solver.solution.x.iter().map(|y| y * size).collect();
                return ConeProgramme::Solved { point, multipliers: multipliers(), iterations };
            }
            SolverStatus::AlmostSolved if accepts_reduced => {
                let point = solver.solution.x.iter().map(|y| y * size).collect();
                return ConeProgramme::Solved { point, multipliers: multipliers(), iterations };
            }
            SolverStatus::PrimalInfeasible => {
                return ConeProgramme::Infeasible { multipliers: multipliers(), iterations };
            }
            _ => {}
        }
    }
    ConeProgramme::Failed
}

fn settings(tolerance: f64) -> DefaultSettings<f64> {
    DefaultSettings {
        verbose: false,
        presolve_enable: false,
        tol_gap_abs: tolerance,
        tol_gap_rel: tolerance,
        tol_feas: tolerance,
        iterative_refinement_reltol: LEAST_CHANGE,
        iterative_refinement_abstol: LEAST_CHANGE,
        ..DefaultSettings::default()
    }
}
