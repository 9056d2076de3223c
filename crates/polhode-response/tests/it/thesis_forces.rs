//! The thesis's forces of section 3.4 by its heuristic and by guesses: what they take for vanishing contacts, and how
//! far they are from the exact motion. Guesses are exact wherever a set fits, which the active set confirms on random
//! bodies.

use crate::scenes::{Noise, pile};
use polhode_response::{
    ContactProblem, Delassus, LeastForceSolution, LeastForceStage, MOST_GUESSED, ResponseError, SolverSettings,
    SolverStatus, guesses, least_force, solve_complementarity,
};

/// Contacts at these distances from the centre of a beam of unit mass and radius of gyration.
fn beam(places: &[f64]) -> ContactProblem {
    let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0]).unwrap();
    for &place in places {
        problem.push_row(&[(0, &[1.0, place])]).unwrap();
    }
    problem
}

fn accelerations(delassus: &Delassus, forces: &[f64], b: &[f64]) -> Vec<f64> {
    delassus.times(forces).unwrap().iter().zip(b).map(|(own, b)| own + b).collect()
}

/// The contacts that the forces of least sum open: those taken for vanishing.
fn vanishing(delassus: &Delassus, solution: &LeastForceSolution, b: &[f64]) -> Vec<usize> {
    let opened = solution.least_sum.iter().flat_map(|forces| accelerations(delassus, forces, b));
    opened.enumerate().filter(|(_, w)| *w > 1e-12).map(|(row, _)| row).collect()
}

/// The power that forces add, `f.w` (N m/s^2).
fn added(solution: &LeastForceSolution) -> f64 {
    let products = solution.forces.iter().zip(&solution.residual_accelerations);
    products.map(|(force, w)| force * w.max(0.0)).sum()
}

/// Case RC-07: on three pillars no contact vanishes; forces are not unique, and the beam rests by both methods.
#[test]
fn no_contact_of_a_beam_on_pillars_vanishes() {
    let delassus = beam(&[-1.0, 0.0, 1.0]).delassus();
    let (b, settings) = ([-1.0; 3], SolverSettings::default());
    let first = least_force(&delassus, &b, &settings).unwrap();
    assert_eq!((first.stage, vanishing(&delassus, &first, &b).len()), (LeastForceStage::NoneVanish, 0));
    let guessed = guesses(&delassus, &b, &settings).unwrap();
    assert_eq!((guessed.report.status, guessed.vanishing.len()), (SolverStatus::Solved, 0));
    for forces in [&first.forces, &guessed.forces] {
        assert!(accelerations(&delassus, forces, &b).iter().all(|w| w.abs() < 1e-12), "{forces:?}");
    }
}

/// Case RC-08: over the edge of a table (contacts at 1/2 and 2 on one side) least force takes the wrong contact; its
/// bound says how wrong. Guesses find that the outer one carries nothing: G = 5/4, f = 4/5 at 1/2, and w = 2 * 4/5 - 1
/// at 2.
#[test]
fn a_beam_over_the_edge_of_a_table() {
    let delassus = beam(&[0.5, 2.0]).delassus();
    let (b, settings) = ([-1.0; 2], SolverSettings::default());
    let guessed = guesses(&delassus, &b, &settings).unwrap();
    assert!((guessed.forces[0] - 0.8).abs() < 1e-14 && guessed.forces[1] == 0.0, "{guessed:?}");
    assert!((guessed.residual_accelerations[1] - 0.6).abs() < 1e-14);
    assert_eq!((guessed.vanishing.as_slice(), guessed.guesses), (&[1][..], 3));
    let first = least_force(&delassus, &b, &settings).unwrap();
    // min f_1 + f_2 with 5/4 f_1 + 2 f_2 >= 1 and 2 f_1 + 5 f_2 >= 1: f = (0, 1/2), which opens the outer contact.
    assert_eq!(vanishing(&delassus, &first, &b), [1]);
    assert_eq!(first.stage, LeastForceStage::GuessOfVanishing);
    assert!(first.report.bound < 1e-6 && added(&first) < 1e-12, "{first:?}");
}

/// On random piles a set fits and is exact: the accelerations are those of the active set, and what vanishes opens in
/// them. The heuristic is exact in its first two stages, and its error is below its bound in the third.
#[test]
fn guesses_are_exact() {
    let mut noise = Noise::new(7);
    let settings = SolverSettings::default();
    let mut stages = [0; 3];
    for _ in 0..200 {
        let scene = pile(1 + noise.below(3), 1 + noise.below(3), 1.0, &mut noise);
        let b = scene.problem.row_velocities(&scene.free).unwrap();
        if b.len() > 12 {
            continue;
        }
        let delassus = scene.problem.delassus();
        let exact = solve_complementarity(&scene.problem, &delassus, &b, None, &settings).unwrap();
        let exact = accelerations(&delassus, &exact.forces, &b);
        let size = b.iter().fold(1.0, |most: f64, b| most.max(b.abs()));
        let guessed = guesses(&delassus, &b, &settings).unwrap();
        assert_eq!(guessed.report.status, SolverStatus::Solved);
        for (row, (found, exact)) in guessed.residual_accelerations.iter().zip(&exact).enumerate() {
            assert!((found - exact).abs() < 1e-9 * size, "{found} {exact}");
            assert!(!guessed.vanishing.contains(&row) || *exact > 0.0);
        }
        let first = least_force(&delassus, &b, &settings).unwrap();
        let of_heuristic = accelerations(&delassus, &first.forces, &b);
        match first.stage {
            LeastForceStage::LeastSum => {
                stages[2] += 1;
                assert!(added(&first) > 0.0 && first.report.bound > 0.0);
            }
            stage => {
                stages[usize::from(stage == LeastForceStage::GuessOfVanishing)] += 1;
                for (found, exact) in of_heuristic.iter().zip(&exact) {
                    assert!((found - exact).abs() < 1e-8 * size, "{stage:?}: {found} {exact}");
                }
            }
        }
    }
    assert!(stages[0] + stages[1] > 100, "{stages:?}");
}

/// More contacts than can be guessed are refused, with what is accepted.
#[test]
fn too_many_contacts_are_refused() {
    let places: Vec<f64> = (0..=MOST_GUESSED).map(|place| place as f64).collect();
    let delassus = beam(&places).delassus();
    let refused = guesses(&delassus, &vec![-1.0; places.len()], &SolverSettings::default());
    assert_eq!(refused, Err(ResponseError::TooManyGuesses { contacts: 21, limit: 20 }));
    let delassus = beam(&[0.0]).delassus();
    assert!(guesses(&delassus, &[f64::NAN], &SolverSettings::default()).is_err());
}
