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
use crate::problem::ContactProblem;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus, ZeroConeT,
};

/// Gap and feasibility tolerance, relative to data of unit size (no unit); below 1e-12 there is no gain.
const TOLERANCE: f64 = 1e-12;

/// Tolerance of the refinement of clarabel's linear systems (no unit): a few rounding units.
const REFINEMENT: f64 = 1e-15;

/// A pivot of an inverse mass block below this fraction of its diagonal is rounding of zero (no unit).
const PIVOT_ROUNDING: f64 = 1e-14;

/// Tolerances of linear programmes, tried in turn: singular matrices do not always allow the first. The answer is made
/// exact afterwards, and its residual is checked.
const PROGRAMME_TOLERANCES: [f64; 3] = [1e-12, 1e-10, 1e-8];

/// What a margin may be off by where the first tolerance is not met, relative to data of unit size (no unit, 1e-9 to
/// 1e-7): it is told to six digits.
const MARGIN_TOLERANCE: f64 = 1e-7;

/// Contact forces by interior point.
#[derive(Debug, Clone)]
pub(crate) struct InteriorPointForces {
    /// Forces, not negative.
    pub(crate) forces: Vec<f64>,
    /// Rows whose force outweighs their acceleration (both scaled): the guess of the active set.
    pub(crate) active: Vec<usize>,
    /// Iterations.
    pub(crate) iterations: usize,
}

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

/// The forces of `rows` with constant terms `b` (in the order of `rows`).
pub(crate) fn contact_forces(problem: &ContactProblem, rows: &[usize], b: &[f64]) -> Option<InteriorPointForces> {
    let (width, variables) = (problem.width(), problem.bodies() * problem.width());
    let factors: Vec<Vec<f64>> =
        (0..problem.bodies()).map(|body| semidefinite_factor(problem.inverse_mass(body), width)).collect();
    let mut triplets = (Vec::new(), Vec::new(), Vec::new());
    let mut lengths = Vec::with_capacity(rows.len());
    for (line, &row) in rows.iter().enumerate() {
        let mut blocks = Vec::with_capacity(2 * width);
        for entry in problem.entries(row) {
            let factor = &factors[entry.body];
            for component in 0..width {
                let value: f64 = (component..width).map(|k| entry.jacobian[k] * factor[k * width + component]).sum();
                blocks.push((entry.body * width + component, value));
            }
        }
        let length = blocks.iter().map(|(_, value)| value * value).sum::<f64>().sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        lengths.push(length);
        for (column, value) in blocks {
            triplets.0.push(line);
            triplets.1.push(column);
            triplets.2.push(-value / length);
        }
    }
    let scaled: Vec<f64> = b.iter().zip(&lengths).map(|(b, length)| b / length).collect();
    let size = largest(&scaled);
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let right: Vec<f64> = scaled.iter().map(|value| value / size).collect();
    let identity = CscMatrix::identity(variables);
    let constraints = CscMatrix::new_from_triplets(rows.len(), variables, triplets.0, triplets.1, triplets.2);
    let cones = [NonnegativeConeT(rows.len())];
    let mut solver =
        DefaultSolver::new(&identity, &vec![0.0; variables], &constraints, &right, &cones, settings(TOLERANCE)).ok()?;
    solver.solve();
    if solver.solution.status != SolverStatus::Solved {
        return None;
    }
    let (multipliers, slacks) = (&solver.solution.z, &solver.solution.s);
    Some(InteriorPointForces {
        forces: multipliers.iter().zip(&lengths).map(|(z, length)| (z * size / length).max(0.0)).collect(),
        active: (0..rows.len()).filter(|&k| multipliers[k] > slacks[k]).collect(),
        iterations: solver.solution.iterations as usize,
    })
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
        iterative_refinement_reltol: REFINEMENT,
        iterative_refinement_abstol: REFINEMENT,
        ..DefaultSettings::default()
    }
}

/// Lower triangular `C` with `C C^T` the matrix; columns of zero pivots are zero.
fn semidefinite_factor(matrix: &[f64], width: usize) -> Vec<f64> {
    let mut factor: Vec<f64> = vec![0.0; width * width];
    for column in 0..width {
        let square: f64 = (0..column).map(|k| factor[column * width + k] * factor[column * width + k]).sum();
        let pivot = matrix[column * width + column] - square;
        // What rounding leaves of a zero pivot would, as a divisor, make columns out of noise.
        if pivot <= PIVOT_ROUNDING * matrix[column * width + column] {
            continue;
        }
        let root = pivot.sqrt();
        factor[column * width + column] = root;
        for row in column + 1..width {
            let inner: f64 = (0..column).map(|k| factor[row * width + k] * factor[column * width + k]).sum();
            factor[row * width + column] = (matrix[row * width + column] - inner) / root;
        }
    }
    factor
}
