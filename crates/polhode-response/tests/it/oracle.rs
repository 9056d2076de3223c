//! An independent answer: clarabel on the lifted form, accelerations as variables and forces as multipliers.

use crate::scenes::Scene;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus};

/// The changes of the accelerations by contact forces, and the forces; `None` when clarabel does not solve it.
pub(crate) fn lifted(scene: &Scene) -> Option<(Vec<f64>, Vec<f64>)> {
    let (width, rows) = (scene.problem.width(), scene.problem.len());
    let size = scene.free.len();
    let diagonal: Vec<f64> =
        scene.masses.chunks_exact(width * width).flat_map(|block| (0..width).map(|k| block[k * width + k])).collect();
    // Dividing all masses by their geometric mean scales the forces and leaves the accelerations.
    let mean = (diagonal.iter().map(|mass| mass.ln()).sum::<f64>() / size as f64).exp();
    let scaled = diagonal.iter().map(|mass| mass / mean).collect();
    let mass = CscMatrix::new(size, size, (0..=size).collect(), (0..size).collect(), scaled);
    let (mut i, mut j, mut v) = (Vec::new(), Vec::new(), Vec::new());
    let mut unit = vec![0.0; size];
    for column in 0..size {
        unit[column] = 1.0;
        for (row, value) in scene.problem.row_velocities(&unit).ok()?.iter().enumerate() {
            if *value != 0.0 {
                i.push(row);
                j.push(column);
                v.push(-value);
            }
        }
        unit[column] = 0.0;
    }
    let constraints = CscMatrix::new_from_triplets(rows, size, i, j, v);
    let mut settings = DefaultSettings::<f64> { verbose: false, presolve_enable: false, ..DefaultSettings::default() };
    (settings.tol_gap_abs, settings.tol_gap_rel, settings.tol_feas) = (1e-12, 1e-12, 1e-12);
    let cones = [NonnegativeConeT(rows)];
    let mut solver = DefaultSolver::new(&mass, &vec![0.0; size], &constraints, &scene.b, &cones, settings).ok()?;
    solver.solve();
    let forces = solver.solution.z.iter().map(|force| force * mean).collect();
    (solver.solution.status == SolverStatus::Solved).then(|| (solver.solution.x.clone(), forces))
}
