//! Rows held at zero acceleration: rank, consistency, reuse of the choice, and whether pushing forces are enough.

use crate::scenes::{GRAVITY, Noise, Row, Scene, beam, diamond, tower};
use polhode_response::held_rows::RANK_CUT;
use polhode_response::{ComplementaritySolver, HeldRows, HoldCheck, ResponseError};

/// Towers of boxes have 4 rows a level of which 3 are independent: the rank is found with a wide gap, and all rows are
/// held to rounding, also the dropped ones.
#[test]
fn towers_are_held_by_their_independent_rows() {
    let mut noise = Noise::new(17);
    for boxes in 1..12 {
        for shift in [0.0, 0.2] {
            let scene = tower(&vec![1.0; boxes], shift, &mut noise);
            let (delassus, all) = (scene.problem.delassus(), (0..4 * boxes).collect::<Vec<_>>());
            let held = HeldRows::factor(&delassus, &all, RANK_CUT).unwrap();
            assert_eq!(held.independent_rows().len(), 3 * boxes);
            assert_eq!(held.dropped_rows().len(), boxes);
            let (kept, dropped) = held.pivot_gap();
            assert!(kept > 1e-4 && dropped < 1e-13, "{kept:e} {dropped:e}");
            let solution = held.solve(&scene.problem, &delassus, &scene.b).unwrap();
            assert!(solution.inconsistency < 1e-14, "{:e}", solution.inconsistency);
            let worst = scene.accelerations(&solution.forces).iter().fold(0.0, |most: f64, a| most.max(a.abs()));
            assert!(worst < 1e-12 * GRAVITY, "{worst:e}");
            // The choice taken over gives the same factor, to the bit.
            let again = HeldRows::factor_with_rows(&delassus, &all, held.independent_rows(), RANK_CUT).unwrap();
            assert_eq!(again.dropped_rows(), held.dropped_rows());
            let reused = again.solve(&scene.problem, &delassus, &scene.b).unwrap();
            let difference = reused.forces.iter().zip(&solution.forces).map(|(a, b)| (a - b).abs());
            assert!(difference.fold(0.0, f64::max) < 1e-10);
        }
    }
}

/// The rank of the diamonds is that of case RC-01: contacts less the dimension of the force family.
#[test]
fn rank_of_diamonds() {
    for (m, contacts, freedom) in [(2, 10, 2), (3, 26, 8), (4, 50, 18)] {
        let (scene, _) = diamond(m);
        let all: Vec<usize> = (0..scene.problem.len()).collect();
        let held = HeldRows::factor(&scene.problem.delassus(), &all, RANK_CUT).unwrap();
        assert_eq!((all.len(), held.dropped_rows().len()), (contacts, freedom));
    }
}

/// Rows that contradict each other show as inconsistency, and a choice that has become dependent is refused.
#[test]
fn contradiction_and_lost_rank_are_seen() {
    let rows: Vec<Row> = vec![vec![(0, vec![1.0, 0.0])], vec![(0, vec![2.0, 0.0])], vec![(0, vec![0.0, 1.0])]];
    let scene = Scene::new(2, &[vec![1.0, 1.0]], &rows, &[0.0, 0.0]);
    let delassus = scene.problem.delassus();
    let held = HeldRows::factor(&delassus, &[0, 1, 2], RANK_CUT).unwrap();
    assert_eq!(held.independent_rows().len(), 2);
    assert!(held.solve(&scene.problem, &delassus, &[1.0, 2.0, 3.0]).unwrap().inconsistency < 1e-15);
    assert!(held.solve(&scene.problem, &delassus, &[1.0, -2.0, 3.0]).unwrap().inconsistency > 0.1);
    let lost = HeldRows::factor_with_rows(&delassus, &[0, 1, 2], &[0, 1], RANK_CUT).unwrap_err();
    assert!(matches!(lost, ResponseError::LostRank { row: 1, .. }));
    assert!(HeldRows::factor(&delassus, &[3], RANK_CUT).is_err());
    assert!(HeldRows::factor(&delassus, &[0], f64::NAN).is_err());
    let none = HeldRows::factor(&delassus, &[], RANK_CUT).unwrap();
    assert_eq!(none.solve(&scene.problem, &delassus, &[1.0, 1.0, 1.0]).unwrap().forces, [0.0; 3]);
}

/// A force may pull: a beam hung up at two rows on one side of its centre of mass needs a negative one, so it cannot
/// be held by contacts; with supports on both sides it can.
#[test]
fn pushing_forces_may_not_be_enough() {
    let scene = beam(&[-1.0, -0.5, 0.7]);
    let delassus = scene.problem.delassus();
    let held = HeldRows::factor(&delassus, &[0, 1], RANK_CUT).unwrap();
    let forces = held.solve(&scene.problem, &delassus, &scene.b).unwrap().forces;
    assert!((forces[0] + GRAVITY).abs() < 1e-13 && (forces[1] - 2.0 * GRAVITY).abs() < 1e-13, "{forces:?}");
    let mut solver = ComplementaritySolver::default();
    let mut check = |rows: &[usize]| HoldCheck::new(&scene.problem, &delassus, &scene.b, rows, &mut solver).unwrap();
    assert!(!check(&[0, 1]).can_be_held);
    assert!(check(&[0, 2]).can_be_held);
    assert!(check(&[0, 1, 2]).can_be_held);
}
