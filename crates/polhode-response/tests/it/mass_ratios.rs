//! Rows held by least forces where a light body carries a heavy one: what its forces add up to is small against each of
//! them, and must be right all the same.

use crate::scenes::{GRAVITY, Noise, Row, Scene, pile, tower};
use polhode_response::{LeastNormHold, ResponseError, least_norm_forces};

/// A tower of boxes of these masses, shifted against each other.
fn shifted(masses: &[f64]) -> Scene {
    tower(masses, 0.15, &mut Noise::new(29))
}

/// Accelerations of all bodies under the forces that hold all rows.
fn held(scene: &Scene) -> Vec<f64> {
    let delassus = scene.problem.delassus();
    let least = least_norm_forces(&scene.problem, &delassus, &scene.b).unwrap();
    let width = scene.problem.width();
    let Some(loads) = least.loads else { return scene.accelerations(&least.forces) };
    let accelerations = loads.iter().zip(&scene.free).enumerate().map(|(k, (load, free))| {
        let (body, line) = (k / width, k % width);
        free + load / scene.masses[(body * width + line) * width + line]
    });
    accelerations.collect()
}

/// A box of 1 kg between the floor and one of up to 1e10 kg stands still: forces of `1e10 g` cancel to the rounding of
/// `g`. Forces in working precision alone leave `1e-16` of them, 1e-5 m/s^2.
#[test]
fn a_light_body_under_a_heavy_one_is_not_shaken_by_rounding() {
    for exponent in [0, 2, 3, 5, 6, 7, 8, 9, 10] {
        let ratio = 10.0_f64.powi(exponent);
        for masses in [vec![1.0, ratio], vec![1.0, ratio.sqrt(), ratio], vec![ratio, 1.0, ratio], vec![ratio, 1.0]] {
            let worst = held(&shifted(&masses)).iter().fold(0.0, |most: f64, a| most.max(a.abs()));
            let limit = if ratio > 256.0 { 1e-15 } else { 1e-15 * ratio.max(10.0) };
            assert!(worst < limit * GRAVITY, "{masses:?}: {worst:e}");
        }
    }
}

/// Forces of working precision, for comparison: they do leave the rounding of the heavy body's weight.
#[test]
fn forces_in_working_precision_shake_it() {
    let scene = shifted(&[1.0, 1e8]);
    let delassus = scene.problem.delassus();
    let forces = LeastNormHold::factor(&delassus).unwrap().solve(&delassus, &scene.b).unwrap();
    let worst = scene.accelerations(&forces).iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    assert!(worst > 1e-9, "{worst:e}");
}

/// Which rows depend on each other is a matter of geometry: two contacts that all but coincide share their load alike
/// at every mass ratio, however their constant terms differ by rounding.
#[test]
fn contacts_that_all_but_coincide_share_their_load_at_every_mass_ratio() {
    for apart in [0.0, 1e-15, 1e-12, 1e-9, 1e-7] {
        for ratio in [1.0, 1e3, 1e6, 1e9] {
            // A light plate on the floor and a heavy beam on it, in a plane: contacts at x = -1, 1 and 1 + apart.
            let places = [-1.0, 1.0, 1.0 + apart];
            let floor = places.iter().map(|&x| -> Row { vec![(0, vec![0.0, 1.0, x])] });
            let between = places.iter().map(|&x| -> Row { vec![(1, vec![0.0, 1.0, x]), (0, vec![0.0, -1.0, -x])] });
            let rows: Vec<Row> = floor.chain(between).collect();
            let diagonals = [vec![1.0, 1.0, 1.0 / 3.0], vec![ratio, ratio, ratio / 3.0]];
            let mut scene = Scene::new(3, &diagonals, &rows, &[0.0, -GRAVITY, 0.0]);
            scene.b[2] += 1e-15 * GRAVITY;
            scene.b[4] -= 1e-15 * GRAVITY;
            let least = least_norm_forces(&scene.problem, &scene.problem.delassus(), &scene.b).unwrap();
            let (f, weight) = (least.forces, GRAVITY * ratio);
            for (force, share) in f.iter().zip([0.5, 0.25, 0.25]).skip(3) {
                assert!((force / weight - share).abs() < 1e-4, "{apart:e} {ratio:e}: {f:?}");
            }
        }
    }
}

/// Where masses differ by some hundreds, both precisions give the same motion, to the rounding of the coarser one.
#[test]
fn the_change_of_precision_does_not_change_the_motion() {
    let mut noise = Noise::new(71);
    for _ in 0..40 {
        let scene = pile(4, 4, 2000.0, &mut noise);
        let delassus = scene.problem.delassus();
        let coarse = LeastNormHold::factor(&delassus).unwrap().solve(&delassus, &scene.b).unwrap();
        let change: Vec<f64> = scene.accelerations(&coarse).iter().zip(held(&scene)).map(|(a, b)| a - b).collect();
        let size = scene.squared(&scene.accelerations(&coarse)).sqrt();
        let relative = scene.squared(&change).sqrt() / size;
        assert!(relative < 1e-9, "{relative:e}");
    }
}

/// What the forces add up to is `J^T f`, to the rounding of the forces.
#[test]
fn loads_are_the_sums_of_the_forces() {
    let scene = shifted(&[1.0, 1e6, 30.0]);
    let least = least_norm_forces(&scene.problem, &scene.problem.delassus(), &scene.b).unwrap();
    let response = scene.problem.response(&least.forces).unwrap();
    let largest = least.forces.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
    for (k, (load, acceleration)) in least.loads.unwrap().iter().zip(&response).enumerate() {
        let mass = scene.masses[(k / 6 * 6 + k % 6) * 6 + k % 6];
        assert!((load - acceleration * mass).abs() < 1e-14 * largest, "{k}: {load:e} {acceleration:e}");
    }
}

/// Lists of the wrong length and numbers that are not finite are refused; without rows there are no forces.
#[test]
fn bad_input_is_refused() {
    let scene = shifted(&[1.0, 1e6]);
    let (problem, delassus) = (&scene.problem, scene.problem.delassus());
    assert!(matches!(least_norm_forces(problem, &delassus, &scene.b[1..]), Err(ResponseError::Length { .. })));
    let other = shifted(&[1.0]).problem.delassus();
    assert!(matches!(least_norm_forces(problem, &other, &scene.b), Err(ResponseError::Length { .. })));
    let mut b = scene.b.clone();
    b[3] = f64::NAN;
    assert!(matches!(least_norm_forces(problem, &delassus, &b), Err(ResponseError::NotFinite { .. })));
    let mut none = problem.clone();
    none.clear_rows();
    assert!(least_norm_forces(&none, &none.delassus(), &[]).unwrap().forces.is_empty());
}

/// Forces of a heavy body that cancel on a light one leave what their loads do: `b + J M^-1 (J^T f)` from the forces is
/// that from their sums to the rounding of the forces, and from sums that balance it is zero to the rounding of
/// gravity.
#[test]
fn accelerations_do_not_contain_the_rounding_of_products() {
    let scene = shifted(&[1.0, 1e8, 1e4]);
    let least = least_norm_forces(&scene.problem, &scene.problem.delassus(), &scene.b).unwrap();
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let by_forces = largest(&scene.problem.accelerations(&scene.b, &least.forces).unwrap());
    // Each of the forces on the body of 1 kg is rounded to half a unit in its last place, and moves a corner by up to 7
    // / kg.
    let rounding = 0.5 * f64::EPSILON * least.forces.iter().map(|force| 7.0 * force.abs()).sum::<f64>();
    assert!(by_forces <= rounding, "{by_forces:e} of {rounding:e}");
    let loads = least.loads.unwrap();
    let by_loads = largest(&scene.problem.accelerations_under(&scene.b, &least.forces, &loads).unwrap());
    assert!(by_loads < 1e-14 * GRAVITY, "{by_loads:e}");
    let short = &scene.b[1..];
    assert!(matches!(scene.problem.accelerations(short, &least.forces), Err(ResponseError::Length { .. })));
    assert!(matches!(scene.problem.accelerations(&scene.b, short), Err(ResponseError::Length { .. })));
    assert!(matches!(
        scene.problem.accelerations_under(&scene.b, &least.forces, &[0.0]),
        Err(ResponseError::Length { .. })
    ));
}
