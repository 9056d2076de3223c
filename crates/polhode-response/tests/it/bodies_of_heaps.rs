//! How many factorisations the solver in the velocities of bodies takes, and how small the residual is then.
//!
//! Piles of redundant contacts are what interior points are for and sweeps are not: the number of steps must not grow
//! with the number of boxes, nor with the ratio of masses. The residual is the natural map per unit of the largest
//! reaction; the velocities must obey Coulomb's law in the sense of mechanics too, which is checked apart from it.

use super::body_scenes::{BodyScene, Dice, GRAVITY_OF_A_STEP, chain, heap, pyramid, tower, wall};
use polhode_response::sparse::{BodySettings, BodySolution, BodySolver};
use polhode_response::{Law, SolverStatus};

fn solved(scene: &BodyScene) -> BodySolution {
    BodySolver::default().solve(&scene.problem(), None, &BodySettings::default()).unwrap()
}

/// Solved to 1e-12 within so many factorisations.
fn takes(name: &str, scene: &BodyScene, most: usize) {
    comes_to(1e-12, name, scene, most);
}

/// Solved to this residual within so many factorisations: 1e-9 where contacts nearly depend on each other and many of
/// them are about to slip, for which the path of compliance is followed.
fn comes_to(residual: f64, name: &str, scene: &BodyScene, most: usize) {
    let report = solved(scene).report;
    assert_eq!(report.status, SolverStatus::Solved, "{name}: {report:?}");
    assert!(report.residual <= residual && report.factorisations <= most, "{name}: {report:?}");
}

fn at_rest(rows: usize, top: f64) -> BodyScene {
    let mut scene = pyramid(rows, 0.5);
    *scene.masses.last_mut().unwrap() = top;
    scene.pull(0.0);
    scene
}

#[test]
fn pyramids_at_rest_take_eight_factorisations_whatever_their_height() {
    for rows in [5, 10, 20] {
        takes("rest", &at_rest(rows, 1.0), 8);
        let mut tilted = pyramid(rows, 0.5);
        takes("tilted by 20 degrees", tilted.pull(20_f64.to_radians()), 10);
    }
}

#[test]
fn a_push_or_a_hit_takes_a_few_more() {
    for rows in [5, 10, 20] {
        let mut pushed = at_rest(rows, 1.0);
        pushed.velocities.last_mut().unwrap()[0] += 0.1;
        takes("pushed", &pushed, 8);
        let mut hit = at_rest(rows, 1.0);
        let middle = hit.masses.len() / 2;
        hit.velocities[middle][0] += 1.0;
        takes("hit", &hit, 13);
    }
}

#[test]
fn a_heavy_top_takes_no_more_than_a_light_one() {
    for top in [1e3, 1e6] {
        for rows in [5, 10, 20] {
            takes("heavy top", &at_rest(rows, top), 11);
            let mut hit = at_rest(rows, top);
            let middle = hit.masses.len() / 2;
            hit.velocities[middle][0] += 1.0;
            takes("hit under a heavy top", &hit, 11);
        }
        let mut heavy = tower(10, 0.5);
        heavy.masses[9] = top;
        takes("tower", heavy.pull(0.3), 14);
    }
}

/// Masses from a gram to a tonne, one beside the other.
#[test]
fn random_masses_take_some_more() {
    for rows in [5, 10] {
        for seed in 1..12 {
            let mut scene = pyramid(rows, 0.5);
            let mut dice = Dice(seed);
            for mass in &mut scene.masses {
                *mass = 10_f64.powf(3.0 * dice.roll());
            }
            takes("random masses", scene.pull(0.0), 45);
        }
    }
}

/// The light boxes below have to find slips of their own under a load a million times theirs.
#[test]
fn a_heavy_top_that_slides_on_light_boxes_takes_fifty_at_the_most() {
    for (top, most) in [(1e3, 26), (1e6, 50)] {
        for rows in [5, 10, 20] {
            let mut pushed = at_rest(rows, top);
            pushed.velocities.last_mut().unwrap()[0] += 0.1;
            takes("pushed heavy top", &pushed, most);
        }
    }
}

/// All boxes slide with one acceleration: every contact between them is at the limit of sticking, without slip.
#[test]
fn boxes_that_all_slide_reach_the_end_although_their_contacts_are_at_the_limit() {
    for rows in [5, 10, 20] {
        let mut scene = pyramid(rows, 0.5);
        scene.pull(30_f64.to_radians());
        comes_to(1e-9, "all slide", &scene, 100);
        let expected = GRAVITY_OF_A_STEP * (30_f64.to_radians().sin() - 0.5 * 30_f64.to_radians().cos());
        for velocity in solved(&scene).velocities {
            assert!((velocity[0] - expected).abs() < 1e-9, "{velocity:?} instead of {expected}");
        }
    }
}

#[test]
fn random_velocities_of_small_pyramids_reach_the_end() {
    for (rows, most) in [(5, 32), (10, 90)] {
        for seed in 1..4 {
            let mut scene = pyramid(rows, 0.5);
            comes_to(1e-9, "random", scene.pull(0.0).shake(0.3, seed), most);
        }
    }
}

/// 1600 contacts that all slide another way. What the budget does not reach is told.
#[test]
fn random_velocities_of_a_large_pyramid_come_to_five_digits_and_are_told() {
    for seed in 1..4 {
        let mut scene = pyramid(20, 0.5);
        let report = solved(scene.pull(0.0).shake(0.3, seed)).report;
        assert!(report.residual <= 1e-5, "{report:?}");
        assert_eq!(report.status == SolverStatus::Solved, report.residual <= 1e-8, "{report:?}");
    }
}

#[test]
fn walls_chains_and_heaps_are_solved() {
    takes("wall", wall(12, 8, 0.5).pull(0.1), 12);
    takes("chain", chain(200).pull(0.0), 4);
    for seed in 1..6 {
        takes("heap", heap(60, 0.4, seed).pull(0.0).shake(0.1, seed), 40);
    }
}

/// Velocities alone: no contact approaches, and reactions take energy from slips.
#[test]
fn contacts_neither_approach_nor_give_energy() {
    let mut scene = pyramid(8, 0.5);
    scene.pull(0.3).shake(0.05, 7);
    let (solution, size) =
        (solved(&scene), scene.velocities.as_flattened().iter().fold(0.0, |m: f64, v| m.max(v.abs())));
    for (r, u) in solution.reactions.chunks_exact(3).zip(solution.rates.chunks_exact(3)) {
        assert!(u[0] >= -1e-11 * size && r[0] >= 0.0);
        assert!(r[1] * u[1] + r[2] * u[2] <= 1e-11 * size);
        assert!(r[1].hypot(r[2]) <= 0.5 * r[0] + 1e-11);
    }
}

/// Four corners a face, or forty of them: the same motion, since redundant contacts share what one would bear.
#[test]
fn redundant_contacts_change_no_motion() {
    let few = at_rest(6, 100.0);
    let mut many = few.clone();
    for _ in 0..9 {
        many.contacts.extend_from_slice(&few.contacts);
    }
    let (few, many) = (solved(&few), solved(&many));
    assert!(many.report.factorisations <= 11, "{:?}", many.report);
    for (a, b) in few.velocities.as_flattened().iter().zip(many.velocities.as_flattened()) {
        assert!((a - b).abs() < 1e-11, "{a} {b}");
    }
}

#[test]
fn without_friction_boxes_come_apart_as_they_must() {
    let mut scene = pyramid(6, 0.0);
    scene.pull(0.3);
    takes("frictionless", &scene, 12);
    for contact in &mut scene.contacts {
        contact.law = Law::Push;
    }
    takes("pushes", &scene, 12);
}
