//! The thesis's linear programme: right where it is right, wrong where the catalogue says so, and never worse than its
//! own bound.

use crate::forces::solve;
use crate::scenes::{Noise, Row, Scene, beam, diamond};
use polhode_response::{LeastForceStage, SolverSettings, SolverStatus, least_force};

/// One body of unit mass and inertia with these rows and `b = -1`.
fn unit_body(rows: &[&[f64]]) -> Scene {
    let rows: Vec<Row> = rows.iter().map(|row| vec![(0, row.to_vec())]).collect();
    let width = rows[0][0].1.len();
    let mut scene = Scene::new(width, &[vec![1.0; width]], &rows, &vec![0.0; width]);
    scene.b = vec![-1.0; rows.len()];
    scene
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let worst = found.iter().zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    assert!(worst <= tolerance, "{found:?} {expected:?}: {worst:e}");
}

/// Case RC-08: a beam over the edge of a table. The least sum of forces is at the wrong contact; the guess from it is
/// right.
#[test]
fn beam_over_the_edge_of_a_table() {
    let scene = unit_body(&[&[1.0, 0.5], &[1.0, 2.0]]);
    assert_close(scene.problem.delassus().row(0), &[1.25, 2.0], 0.0);
    let exact = solve(&scene);
    assert_close(&exact.forces, &[0.8, 0.0], 1e-14);
    assert_close(&exact.residual_accelerations, &[0.0, 0.6], 1e-14);
    let answer = least_force(&scene.problem.delassus(), &scene.b, &SolverSettings::default()).unwrap();
    assert_close(answer.least_sum.as_deref().unwrap(), &[0.0, 0.5], 1e-14);
    assert_eq!(answer.stage, LeastForceStage::GuessOfVanishing);
    assert_close(&answer.forces, &[0.8, 0.0], 1e-14);
    assert_eq!(answer.report.status, SolverStatus::Solved);
}

/// Case RC-09: both guesses fail, the thesis's method injects energy, and says how wrong it may be.
#[test]
fn plate_with_three_contacts() {
    let scene = unit_body(&[&[1.0, 4.0, -1.5], &[1.0, 0.0, 0.5], &[1.0, 3.0, 1.0]]);
    let exact = solve(&scene);
    assert_close(&exact.forces, &[1.0 / 24.0, 19.0 / 24.0, 0.0], 1e-13);
    assert_close(&exact.residual_accelerations, &[0.0, 0.0, 2.0 / 3.0], 1e-13);
    let answer = least_force(&scene.problem.delassus(), &scene.b, &SolverSettings::default()).unwrap();
    assert_eq!(answer.stage, LeastForceStage::LeastSum);
    assert_eq!(answer.report.status, SolverStatus::Inaccurate);
    assert_close(&answer.forces, &[0.0, 0.0, 2.0 / 3.0], 1e-9);
    let power: f64 = answer.forces.iter().zip(&answer.residual_accelerations).map(|(f, w)| f * w).sum();
    assert_close(&[power], &[4.222_222_222_222_221], 4.2e-9);
    assert_close(&[answer.report.bound], &[power.sqrt()], 1e-12);
}

/// Where nothing vanishes the first guess answers, also with forces that are not unique: beam and stable diamonds.
#[test]
fn first_guess_answers_at_rest() {
    for scene in [beam(&[-1.0, 0.0, 1.0]), diamond(3).0, diamond(4).0] {
        let answer = least_force(&scene.problem.delassus(), &scene.b, &SolverSettings::default()).unwrap();
        assert_eq!(answer.stage, LeastForceStage::NoneVanish, "{:?}", answer.report);
        assert_eq!(answer.report.status, SolverStatus::Solved, "{:?}", answer.report);
        let worst = scene.accelerations(&answer.forces).iter().fold(0.0, |most: f64, a| most.max(a.abs()));
        assert!(worst < 1e-11, "{worst:e}");
    }
}

/// The bound `sqrt(f.w)` is never violated by the true error in the energy norm, on random contacts of one to three
/// bodies; and each of the stages occurs.
#[test]
fn bound_is_never_violated() {
    let mut noise = Noise::new(13);
    let mut stages = [0; 4];
    let mut sharpest: f64 = 0.0;
    for _ in 0..600 {
        let bodies = 1 + noise.below(3);
        let count = 2 + noise.below(5);
        let rows: Vec<Row> = (0..count)
            .map(|_| {
                let body = noise.below(bodies);
                let mut row: Row = vec![(body, vec![0.3 * noise.signed(), 1.0, 2.0 * noise.signed()])];
                let other = noise.below(bodies);
                if other != body {
                    row.push((other, vec![0.3 * noise.signed(), -1.0, 2.0 * noise.signed()]));
                }
                row
            })
            .collect();
        let diagonals: Vec<Vec<f64>> = (0..bodies).map(|_| vec![1.0, 1.0, 0.2 + noise.unit()]).collect();
        let scene = Scene::new(3, &diagonals, &rows, &[0.0, -1.0, 0.0]);
        let exact = solve(&scene);
        let answer = least_force(&scene.problem.delassus(), &scene.b, &SolverSettings::default()).unwrap();
        if exact.report.status == SolverStatus::Infeasible {
            assert_eq!(answer.stage, LeastForceStage::NoForces);
            continue;
        }
        stages[answer.stage as usize] += 1;
        assert_ne!(answer.stage, LeastForceStage::NoForces, "{answer:?}");
        let own = scene.accelerations(&answer.forces);
        let difference: Vec<f64> = own.iter().zip(scene.accelerations(&exact.forces)).map(|(a, b)| a - b).collect();
        let error = scene.squared(&difference).sqrt();
        assert!(error <= answer.report.bound * (1.0 + 1e-9) + 1e-9, "{error:e} {:e}", answer.report.bound);
        if answer.stage == LeastForceStage::LeastSum {
            sharpest = sharpest.max(error / answer.report.bound);
        } else {
            assert!(error < 1e-9, "an exact stage: {error:e} {answer:?}");
        }
    }
    assert!(stages[0] > 0 && stages[1] > 0 && stages[2] > 0, "{stages:?}");
    assert!(sharpest > 0.5, "the bound says something: {sharpest}");
}

/// Separating contacts need no force; squeezed bodies have none; NaN is refused.
#[test]
fn edge_cases() {
    let scene = beam(&[-1.0, 1.0]);
    let (delassus, settings) = (scene.problem.delassus(), SolverSettings::default());
    let answer = least_force(&delassus, &[1.0, 2.0], &settings).unwrap();
    assert_close(&answer.forces, &[0.0, 0.0], 1e-12);
    assert!(least_force(&delassus, &[f64::NAN, 1.0], &settings).is_err());
    assert!(least_force(&delassus, &[1.0], &settings).is_err());
    assert_eq!(least_force(&delassus, &[0.0, 0.0], &settings).unwrap().forces, [0.0, 0.0]);
    let squeezed = unit_body(&[&[1.0], &[-1.0]]);
    let answer = least_force(&squeezed.problem.delassus(), &squeezed.b, &settings).unwrap();
    assert_eq!((answer.stage, answer.report.status), (LeastForceStage::NoForces, SolverStatus::Infeasible));
}
