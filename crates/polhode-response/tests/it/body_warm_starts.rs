//! Warm starts of the solver in the velocities of bodies: the reactions of the last step, where little has changed.

use super::body_scenes::{BodyScene, pyramid};
use polhode_response::SolverStatus;
use polhode_response::sparse::{BodyMethod, BodySettings, BodySolution, BodySolver};

fn warm(scene: &BodyScene, start: &[f64]) -> BodySolution {
    BodySolver::default().solve(&scene.problem(), Some(start), &BodySettings::default()).unwrap()
}

fn at_rest(rows: usize) -> (BodyScene, Vec<f64>) {
    let mut scene = pyramid(rows, 0.5);
    scene.pull(0.0);
    let solution = BodySolver::default().solve(&scene.problem(), None, &BodySettings::default()).unwrap();
    (scene, solution.reactions)
}

#[test]
fn nothing_changed_takes_one_factorisation_at_the_most() {
    for rows in [5, 10, 20] {
        let (scene, reactions) = at_rest(rows);
        let solution = warm(&scene, &reactions);
        assert!(solution.report.factorisations <= 1, "{:?}", solution.report);
        // Reactions that are right to a millionth are made right in one or two.
        let nearly: Vec<f64> = reactions.iter().enumerate().map(|(k, r)| r * (1.0 + 1e-6 * (k % 3) as f64)).collect();
        let solution = warm(&scene, &nearly);
        assert!(solution.report.factorisations <= 2, "{:?}", solution.report);
        assert_eq!(solution.report.method, BodyMethod::Warm);
    }
}

/// Velocities of all boxes change at random, those of piles that rest or stick on a slope.
#[test]
fn small_changes_take_two_to_four() {
    for rows in [5, 10, 20] {
        for angle in [0.0_f64, 20.0] {
            let mut base = pyramid(rows, 0.5);
            base.pull(angle.to_radians());
            let first = BodySolver::default().solve(&base.problem(), None, &BodySettings::default()).unwrap();
            for (size, most) in [(1e-6, 2), (1e-4, 3), (1e-3, 4)] {
                let mut next = base.clone();
                let report = warm(next.shake(size, 5), &first.reactions).report;
                assert!(report.residual <= 1e-12 && report.factorisations <= most, "{size}: {report:?}");
                assert_eq!(report.method, BodyMethod::Warm);
            }
        }
    }
}

#[test]
fn a_top_that_is_pushed_takes_no_cold_start() {
    for rows in [5, 10, 20] {
        let (mut scene, reactions) = at_rest(rows);
        scene.velocities.last_mut().unwrap()[0] += 0.1;
        let report = warm(&scene, &reactions).report;
        assert!(report.residual <= 1e-12 && report.factorisations <= 8, "{report:?}");
        assert!(!report.tried.contains(BodyMethod::InteriorPoint));
    }
}

/// A start that misleads costs no more than its own steps: the cold chain follows.
#[test]
fn a_start_that_misleads_is_left_behind() {
    let (mut scene, reactions) = at_rest(10);
    scene.velocities[20][2] += 1.0;
    scene.velocities[20][0] -= 2.0;
    let wrong: Vec<f64> = reactions.iter().map(|r| -1e3 * r).collect();
    for start in [&reactions, &wrong] {
        let solution = warm(&scene, start);
        assert_eq!(solution.report.status, SolverStatus::Solved);
        assert!(solution.report.residual <= 1e-12 && solution.report.warm <= 8, "{:?}", solution.report);
    }
}
