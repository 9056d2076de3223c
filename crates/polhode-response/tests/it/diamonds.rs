//! Diamonds of bricks (thesis, Videos 12 to 15; cases RC-01, RC-02): no method that iterates gets them right, and the
//! linear programme of the thesis does not either.

use crate::scenes::{GRAVITY, diamond, diamond_bricks, diamond_in_space};
use polhode_response::{Method, SolverSettings, SolverStatus, minimum_norm, solve_complementarity};

/// The 2-, 3- and 4-diamonds stand: every acceleration is zero to 1e-12 g, every row is held, and the forces of least
/// norm are mirror symmetric and carry the weight.
#[test]
fn stable_diamonds_stand_still() {
    for m in 2..=4 {
        let (scene, contacts) = diamond(m);
        let settings = SolverSettings::default();
        let solution =
            solve_complementarity(&scene.problem, &scene.problem.delassus(), &scene.b, None, &settings).unwrap();
        assert_eq!(solution.report.status, SolverStatus::Solved, "{:?}", solution.report);
        assert!(solution.held.iter().all(|held| *held), "m = {m}");
        let least = minimum_norm(&scene.problem, &solution, &settings).unwrap();
        assert!(least.minimal);
        assert_eq!(least.freedom, [0, 0, 2, 8, 18][m], "dimension of the force family, m = {m}");
        for forces in [&solution.forces, &least.forces] {
            let worst = scene.accelerations(forces).iter().fold(0.0, |most: f64, a| most.max(a.abs()));
            assert!(worst < 1e-12 * GRAVITY, "m = {m}: {worst:e}");
        }
        assert_mirrored(&contacts, m, &least.forces);
    }
}

/// Forces at contacts that are mirror images of each other are equal to rounding.
fn assert_mirrored(contacts: &[(usize, i32, f64)], m: usize, forces: &[f64]) {
    let bricks = diamond_bricks(m);
    let image = |brick: usize| {
        bricks.iter().position(|other| other.level == bricks[brick].level && other.x == -bricks[brick].x).unwrap()
    };
    let size = forces.iter().fold(0.0, |most: f64, force| most.max(*force));
    for (row, &(upper, lower, x)) in contacts.iter().enumerate() {
        let mirrored = (image(upper), usize::try_from(lower).map_or(-1, |brick| image(brick) as i32), -x);
        let other = contacts.iter().position(|contact| *contact == mirrored).unwrap();
        assert!((forces[row] - forces[other]).abs() < 1e-13 * size, "m = {m}: {} {}", forces[row], forces[other]);
    }
}

/// Case RC-01: every force lies between the least and the largest that equilibrium allows, in brick weights; rows in
/// the order (upper, lower, x).
#[test]
fn forces_of_stable_diamonds_are_admissible() {
    let two = [
        (2.0, 2.0),
        (2.0, 2.0),
        (1.0, 1.5),
        (0.0, 1.0),
        (0.0, 1.0),
        (1.0, 1.5),
        (0.0, 0.5),
        (0.0, 1.0),
        (0.0, 1.0),
        (0.0, 0.5),
    ];
    let three = [
        (4.5, 4.5),
        (4.5, 4.5),
        (3.0, 4.0),
        (0.0, 2.0),
        (0.0, 2.0),
        (3.0, 4.0),
        (1.0, 1.5),
        (0.0, 1.0),
        (0.0, 1.0),
        (1.0, 3.0),
        (1.0, 3.0),
        (0.0, 1.0),
        (0.0, 1.0),
        (1.0, 1.5),
        (0.0, 0.5),
        (0.0, 1.0),
        (0.0, 1.5),
        (0.0, 1.5),
        (0.0, 1.5),
        (0.0, 1.5),
        (0.0, 1.0),
        (0.0, 0.5),
        (0.0, 0.5),
        (0.0, 1.0),
        (0.0, 1.0),
        (0.0, 0.5),
    ];
    for (m, limits) in [(2, &two[..]), (3, &three[..])] {
        let (scene, contacts) = diamond(m);
        assert_eq!(contacts.len(), limits.len());
        let settings = SolverSettings::default();
        let solution =
            solve_complementarity(&scene.problem, &scene.problem.delassus(), &scene.b, None, &settings).unwrap();
        let least = minimum_norm(&scene.problem, &solution, &settings).unwrap();
        for forces in [&solution.forces, &least.forces] {
            for (force, (low, high)) in forces.iter().zip(limits) {
                let weights = force / GRAVITY;
                assert!(weights >= low - 1e-12 && weights <= high + 1e-12, "{weights} not in {low}..{high}");
            }
        }
    }
}

/// The 5-diamond falls with the accelerations of the exact rational solution, to 1e-12 (case RC-02).
#[test]
fn five_diamond_falls_as_it_must() {
    let (scene, contacts) = diamond(5);
    assert_eq!(scene.problem.len(), 82);
    let settings = SolverSettings::default();
    let solution = solve_complementarity(&scene.problem, &scene.problem.delassus(), &scene.b, None, &settings).unwrap();
    assert_eq!(solution.report.status, SolverStatus::Solved);
    let least = minimum_norm(&scene.problem, &solution, &settings).unwrap();
    assert!(least.minimal);
    assert_mirrored(&contacts, 5, &least.forces);
    assert_eq!(solution.held.iter().filter(|held| !**held).count(), 16, "separating contacts");
    // (level, |x|) -> (ay, alpha for x > 0) in units of 1/96125 m/s^2.
    let exact = |level: usize, x: f64| match (level, (2.0 * x).abs() as usize) {
        (0, _) => (0.0, 0.0),
        (1, _) => (0.0, -70632.0),
        (2, 2) => (-35316.0, -141_264.0),
        (3, 3) => (-105_948.0, -282_528.0),
        (4, 4) => (-247_212.0, -282_528.0),
        _ => (35316.0, 0.0),
    };
    for forces in [&solution.forces, &least.forces] {
        let accelerations = scene.accelerations(forces);
        let mut worst: f64 = 0.0;
        for (brick, motion) in diamond_bricks(5).iter().zip(accelerations.chunks_exact(3)) {
            let (ay, alpha) = exact(brick.level, brick.x);
            let turn = if brick.x < 0.0 { -alpha } else { alpha };
            worst = worst.max(motion[0].abs());
            worst = worst.max((motion[1] - ay / 96125.0).abs()).max((motion[2] - turn / 96125.0).abs());
        }
        assert!(worst < 1e-12, "{worst:e}");
    }
}

/// The 4-diamond in space with touching sides (136 rows) stands, and its own active set solves it again at once.
#[test]
fn four_diamond_in_space_is_solved_again_by_one_factorisation() {
    let scene = diamond_in_space();
    assert_eq!(scene.problem.len(), 136);
    let (delassus, settings) = (scene.problem.delassus(), SolverSettings::default());
    let cold = solve_complementarity(&scene.problem, &delassus, &scene.b, None, &settings).unwrap();
    assert_eq!(cold.report.status, SolverStatus::Solved);
    assert!(cold.held.iter().all(|held| *held));
    let warm = solve_complementarity(&scene.problem, &delassus, &scene.b, Some(&cold.warm_start), &settings).unwrap();
    assert_eq!(warm.report.method, Method::WarmStart);
    assert_eq!(warm.report.iterations, 0);
    let worst = scene.accelerations(&warm.forces).iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    assert!(worst < 1e-12 * GRAVITY, "{worst:e}");
    let least = minimum_norm(&scene.problem, &cold, &settings).unwrap();
    assert!(least.minimal);
}
