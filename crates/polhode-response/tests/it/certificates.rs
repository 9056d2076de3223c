//! The bound of the error of accelerations, compared with truth in twice the precision.

use crate::exact::{Long, dense_jacobian, inverse_masses, loads, row_accelerations, solve_equations};
use crate::scenes::{GRAVITY, Noise, Row, Scene, beam, diamond, pile, tower};
use polhode_response::{ContactSolution, SolverSettings, SolverStatus, solve_complementarity};

fn solved(scene: &Scene) -> ContactSolution {
    let delassus = scene.problem.delassus();
    solve_complementarity(&scene.problem, &delassus, &scene.b, None, &SolverSettings::default()).unwrap()
}

/// `|a - a*|_M` of forces, where the truth is that nothing accelerates.
fn error_at_rest(scene: &Scene, forces: &[f64]) -> f64 {
    let forces: Vec<Long> = forces.iter().map(|&force| Long::new(force)).collect();
    let inverse = inverse_masses(scene);
    let loads = loads(&dense_jacobian(scene), &forces);
    let terms = loads.iter().zip(&inverse).zip(&scene.free);
    let squares = terms.map(|((load, m), free)| {
        let acceleration = load.times(Long::new(*m)).plus(Long::new(*free)).value();
        acceleration * acceleration / m
    });
    squares.sum::<f64>().sqrt()
}

/// `|a - a*|_M` between two sets of forces.
fn error_between(scene: &Scene, forces: &[f64], truth: &[Long]) -> f64 {
    let change: Vec<Long> = forces.iter().zip(truth).map(|(&f, truth)| Long::new(f).minus(*truth)).collect();
    let loads = loads(&dense_jacobian(scene), &change);
    loads.iter().zip(inverse_masses(scene)).map(|(load, m)| load.value() * load.value() * m).sum::<f64>().sqrt()
}

/// The diamonds stand still exactly. The bound of the 4-diamond was the root of a rounding, 4e-6; it is of the order of
/// the rounding, and never below the error.
#[test]
fn the_bound_of_a_standing_diamond_is_of_the_order_of_its_rounding() {
    for m in 2..=4 {
        let (scene, _) = diamond(m);
        let solution = solved(&scene);
        let (error, bound) = (error_at_rest(&scene, &solution.forces), solution.report.bound);
        assert!(solution.report.certified, "m = {m}");
        assert!(error <= bound && bound < 1e-13, "m = {m}: {error:e} {bound:e}");
    }
}

/// A tower whose lowest box is 1 kg and whose highest is up to 1e9 kg: the bound grows as the rounding of the weights
/// that the light box bears, and not as its root (0.25 at a ratio of 1e6).
#[test]
fn the_bound_grows_with_the_mass_ratio_as_rounding_does() {
    let mut noise = Noise::new(5);
    for exponent in 0..10 {
        let ratio = 10.0_f64.powi(exponent);
        for masses in [vec![1.0, ratio], vec![1.0, 3.0, ratio], vec![ratio, 1.0], vec![ratio, 1.0, ratio]] {
            let scene = tower(&masses, 0.2, &mut noise);
            let solution = solved(&scene);
            let (error, bound) = (error_at_rest(&scene, &solution.forces), solution.report.bound);
            assert!(solution.report.certified, "{masses:?}: {:?}", solution.report);
            assert!(error <= bound && bound < 1e-13 * ratio.max(10.0), "{masses:?}: {error:e} {bound:e}");
        }
    }
}

/// Random piles with masses over up to six decades, whose contacts hold or open: the truth is the solution of the
/// equations of the active set in twice the precision, checked to be complementary.
#[test]
fn the_bound_is_never_below_the_error_on_random_piles() {
    let mut noise = Noise::new(101);
    let (mut compared, mut sharpest, mut widest) = (0, 0.0_f64, 0.0_f64);
    for round in 0..300 {
        let ratio = 10.0_f64.powi(round % 7);
        let scene = pile(2 + noise.below(4), 1 + noise.below(4), ratio, &mut noise);
        let solution = solved(&scene);
        let active: Vec<usize> = (0..scene.b.len()).filter(|&row| solution.forces[row] > 0.0).collect();
        let (jacobian, inverse) = (dense_jacobian(&scene), inverse_masses(&scene));
        let truth = solve_equations(&jacobian, &inverse, &scene.b, &active);
        let w = row_accelerations(&jacobian, &inverse, &scene.b, &truth);
        let complementary = truth.iter().all(|force| force.value() >= 0.0)
            && (0..w.len()).all(|row| w[row] >= -1e-25 * ratio || active.contains(&row) && w[row].abs() < 1e-12);
        if !complementary || !solution.report.certified {
            continue;
        }
        compared += 1;
        let (error, bound) = (error_between(&scene, &solution.forces, &truth), solution.report.bound);
        assert!(error <= bound, "{round}: {error:e} {bound:e}");
        if error > 0.0 {
            (sharpest, widest) = (sharpest.max(error / bound), widest.max(bound / error));
        }
    }
    assert!(compared > 270 && sharpest > 0.9 && widest < 2.0, "{compared} {sharpest} {widest}");
}

/// One row, and none: the bound covers the rounding of the quotient and of the matrix.
#[test]
fn one_row_has_a_bound_too() {
    let mut noise = Noise::new(8);
    for _ in 0..200 {
        let row: Row = vec![(0, vec![noise.signed(), 0.1 + noise.unit(), noise.signed()])];
        let mass = 10.0_f64.powf(6.0 * noise.signed());
        let scene = Scene::new(3, &[vec![mass, mass, 0.3 * mass]], &[row], &[0.0, -GRAVITY, 0.0]);
        let solution = solved(&scene);
        let truth = solve_equations(&dense_jacobian(&scene), &inverse_masses(&scene), &scene.b, &[0]);
        let (error, bound) = (error_between(&scene, &solution.forces, &truth), solution.report.bound);
        assert!(solution.report.certified && error <= bound, "{error:e} {bound:e}");
        assert!(bound < 1e-12 * GRAVITY * mass.sqrt(), "{bound:e}");
    }
}

/// What is not solved is not certified; a beam that falls past its supports needs no forces, which is certain.
#[test]
fn only_what_is_shown_is_certified() {
    let mut scene = beam(&[-1.0, 1.0]);
    scene.b = vec![1.0, 2.0];
    let report = solved(&scene).report;
    assert!(report.certified && report.bound == 0.0, "{report:?}");
    // Two rows against each other: no forces keep both from approaching.
    let rows: Vec<Row> = vec![vec![(0, vec![1.0])], vec![(0, vec![-1.0])]];
    let mut squeezed = Scene::new(1, &[vec![1.0]], &rows, &[0.0]);
    squeezed.b = vec![-1.0, -1.0];
    let report = solved(&squeezed).report;
    assert!(report.status == SolverStatus::Infeasible && !report.certified, "{report:?}");
}
