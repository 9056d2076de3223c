//! Contacts whose terms contradict each other a little, as those of faces whose gaps differ: Coulomb's law has an
//! answer all the same, in which some corners slip or part by that little.
//!
//! The residual is computed here from reactions and velocities alone, by a projection that is found without a formula:
//! by bisection along the cone's boundary. Loads must not grow with the contradiction over some damping, which is what
//! they did: the interior point then began from nonsense.

use super::body_scenes::{BodyScene, Dice, GRAVITY_OF_A_STEP, pyramid, tower};
use polhode_response::sparse::{BodySettings, BodySolution, BodySolver};
use polhode_response::{Law, SolverStatus};

/// Gives every contact a term of its own, up to this speed (m/s), either way.
fn contradict(scene: &mut BodyScene, speed: f64, seed: u64) {
    let mut dice = Dice(seed);
    for contact in &mut scene.contacts {
        contact.bias = speed * dice.roll();
    }
}

fn solved(scene: &BodyScene) -> BodySolution {
    BodySolver::default().solve(&scene.problem(), None, &BodySettings::default()).unwrap()
}

/// The distance of `(n, t)` from the cone `t <= mu n`, and the nearest `n` on it, by bisection.
fn nearest(mu: f64, n: f64, t: f64) -> [f64; 2] {
    if t <= mu * n {
        return [n, t];
    }
    let (mut low, mut high) = (0.0_f64, n.abs() + t);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        // The derivative of the square of the distance to (x, mu x).
        if (middle - n) + mu * (mu * middle - t) > 0.0 { high = middle } else { low = middle }
    }
    [low, mu * low]
}

/// The natural map of all contacts in units of impulse, per unit of the largest reaction, from reactions and velocities
/// of bodies; and what is missing of `M (v - v_free) = H^T r`, relative to the largest momentum given.
fn residuals(scene: &BodyScene, solution: &BodySolution) -> [f64; 2] {
    let masses = scene.diagonal_masses();
    let mut momenta = vec![[0.0; 6]; masses.len()];
    let (mut most, mut largest) = (0.0_f64, 0.0_f64);
    for (contact, r) in scene.contacts.iter().zip(solution.reactions.chunks_exact(3)) {
        let Law::Cone { friction: mu, .. } = contact.law else { continue };
        let (mut u, mut mobility) = ([contact.bias, 0.0, 0.0], 0.0);
        for (body, lines) in scene.jacobian(contact) {
            for row in 0..3 {
                for k in 0..6 {
                    let h = lines[6 * row + k];
                    u[row] += h * solution.velocities[body][k];
                    momenta[body][k] += h * r[row];
                    mobility += if row == 0 { h * h / masses[body][k] } else { 0.0 };
                }
            }
        }
        let rho = 1.0 / mobility;
        let corrected = u[0] + mu * u[1].hypot(u[2]);
        let z = [r[0] - rho * corrected, r[1] - rho * u[1], r[2] - rho * u[2]];
        let size = z[1].hypot(z[2]);
        let [n, t] = nearest(mu, z[0], size);
        let along = if size > 0.0 { t / size } else { 0.0 };
        let map = (r[0] - n).hypot(r[1] - along * z[1]).hypot(r[2] - along * z[2]);
        most = most.max(map);
        largest = largest.max(r[0].hypot(r[1]).hypot(r[2]));
    }
    let (mut missing, mut given) = (0.0_f64, 0.0_f64);
    for (((mass, momentum), v), free) in masses.iter().zip(&momenta).zip(&solution.velocities).zip(&scene.velocities) {
        for k in 0..6 {
            missing = missing.max((mass[k] * (v[k] - free[k]) - momentum[k]).abs());
            given = given.max(momentum[k].abs());
        }
    }
    [most / largest, missing / given]
}

/// What is left is told as it is, and what is told as solved is: an answer to 1e-8.
fn told(name: &str, scene: &BodyScene, most: f64) -> BodySolution {
    let solution = solved(scene);
    let [map, missing] = residuals(scene, &solution);
    let is_solved = solution.report.status == SolverStatus::Solved;
    assert_eq!(is_solved, map <= 1e-8, "{name}: natural map {map}, {:?}", solution.report);
    assert!(map <= most && missing <= 1e-11, "{name}: natural map {map}, momentum {missing}, {:?}", solution.report);
    solution
}

/// Those of a size that matters are hard: all corners of a pile slip by that little, each another way.
#[test]
fn contradictions_of_any_size_are_solved_or_told() {
    for (speed, most) in [(1e-12, 1e-8), (1e-10, 1e-8), (1e-9, 1e-8), (1e-7, 1e-7), (1e-4, 1e-6), (1e-2, 1e-5)] {
        for seed in 1..4 {
            let mut scene = pyramid(5, 0.5);
            scene.pull(0.1);
            contradict(&mut scene, speed * GRAVITY_OF_A_STEP, seed);
            told(&format!("pyramid, {speed}"), &scene, most);
            let mut scene = tower(6, 0.4);
            scene.pull(0.2).shake(0.05, seed);
            contradict(&mut scene, speed * GRAVITY_OF_A_STEP, seed);
            told(&format!("tower, {speed}"), &scene, most);
        }
    }
}

/// Forces stay those of the weight, however small the contradiction is, and however many corners it has.
#[test]
fn contradictions_do_not_make_large_forces() {
    for speed in [1e-10, 1e-7, 1e-4] {
        let mut scene = pyramid(6, 0.5);
        scene.pull(0.0);
        contradict(&mut scene, speed * GRAVITY_OF_A_STEP, 5);
        let weight = scene.masses.len() as f64 * GRAVITY_OF_A_STEP;
        let solution = told("pyramid at rest", &scene, 1e-6);
        let largest = solution.reactions.iter().fold(0.0, |most: f64, r| most.max(r.abs()));
        assert!(largest < weight, "{largest} under {weight}");
    }
}
