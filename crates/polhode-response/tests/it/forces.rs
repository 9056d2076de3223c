//! Contact forces: closed forms, the law of contact to rounding, one motion whatever the description.

use crate::cases::few;
use crate::oracle;
use crate::scenes::{GRAVITY, Noise, Row, Scene, beam, pile, tower};
use polhode_response::certificate::natural_map_residual;
use polhode_response::{
    ComplementaritySolver, ContactProblem, ContactSolution, Method, ResponseError, SolverSettings, SolverStatus,
    WarmStart, minimum_norm, solve_complementarity,
};
use proptest::prelude::*;

pub(crate) fn solve(scene: &Scene) -> ContactSolution {
    let settings = SolverSettings::default();
    solve_complementarity(&scene.problem, &scene.problem.delassus(), &scene.b, None, &settings).unwrap()
}

fn least(scene: &Scene, solution: &ContactSolution) -> Vec<f64> {
    minimum_norm(&scene.problem, solution, &SolverSettings::default()).unwrap().forces
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let worst = found.iter().zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    assert!(worst <= tolerance, "{found:?} {expected:?}: {worst:e}");
}

/// `w = G f + b` computed anew, and its natural map residual.
fn residual(scene: &Scene, forces: &[f64]) -> f64 {
    let delassus = scene.problem.delassus();
    let mut w = delassus.times(forces).unwrap();
    w.iter_mut().zip(&scene.b).for_each(|(w, b)| *w += b);
    natural_map_residual(&delassus, forces, &w, &scene.b).unwrap()
}

/// Case RC-07 (thesis, Figure 20): the beam on three pillars rests exactly; the least forces share the load; without
/// the middle or the right pillar the forces are unique.
#[test]
fn beam_on_pillars() {
    let three = beam(&[-1.0, 0.0, 1.0]);
    let solution = solve(&three);
    assert_eq!(solution.residual_accelerations, [0.0; 3]);
    assert_close(&three.accelerations(&solution.forces), &[0.0; 3], 1e-14);
    let forces = least(&three, &solution);
    assert_close(&forces, &[3.27; 3], 3.27e-12);
    assert_close(&[forces.iter().sum::<f64>(), forces[0] - forces[2]], &[GRAVITY, 0.0], 1e-12);
    assert_close(&least(&beam(&[-1.0, 1.0]), &solve(&beam(&[-1.0, 1.0]))), &[4.905; 2], 4.905e-13);
    let two = beam(&[-1.0, 0.0]);
    assert_close(&least(&two, &solve(&two)), &[0.0, GRAVITY], 1e-12);
}

/// Case RC-17: a table on four legs with a weight off the middle stands on its legs as on equal springs.
#[test]
fn table_on_four_legs() {
    let legs = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    // Components: upward motion, tilt about x, tilt about y; the centre of mass is at (0.2, 0.1).
    let row = |&(x, y): &(f64, f64)| -> Row { vec![(0, vec![1.0, y - 0.1, 0.2 - x])] };
    let rows: Vec<Row> = legs.iter().map(row).collect();
    let scene = Scene::new(3, &[vec![1.0, 0.7, 0.9]], &rows, &[-100.0, 0.0, 0.0]);
    let solution = solve(&scene);
    assert_eq!(solution.report.rank, 3);
    let forces = least(&scene, &solution);
    assert_close(&forces, &[32.5, 22.5, 17.5, 27.5], 32.5e-12);
    // Without the second leg the weight is still inside, and the forces are unique.
    let three: Vec<Row> = [0, 2, 3].iter().map(|&leg| rows[leg].clone()).collect();
    let three = Scene::new(3, &[vec![1.0, 0.7, 0.9]], &three, &[-100.0, 0.0, 0.0]);
    assert_close(&solve(&three).forces, &[55.0, 40.0, 5.0], 1e-12);
}

/// Case RC-15: ten cubes of 1 kg, the top one 1, 1e3 or 1e6 times as heavy, g = 10: each level carries what is above.
#[test]
fn heavy_cube_on_light_ones() {
    for ratio in [1.0, 1e3, 1e6] {
        let mut masses = vec![1.0; 10];
        masses[9] = ratio;
        let scene = tower(&masses, 0.0, &mut Noise::new(1));
        let b: Vec<f64> = scene.b.iter().map(|b| b * 10.0 / GRAVITY).collect();
        let settings = SolverSettings::default();
        let delassus = scene.problem.delassus();
        let solution = solve_complementarity(&scene.problem, &delassus, &b, None, &settings).unwrap();
        let forces = minimum_norm(&scene.problem, &solution, &settings).unwrap().forces;
        for level in 0..10 {
            let load: f64 = forces[4 * level..4 * level + 4].iter().sum();
            let above = (ratio + (9 - level) as f64) * 10.0;
            assert!((load - above).abs() <= 1e-14 * above, "ratio {ratio}, level {level}: {load} {above}");
            for force in &forces[4 * level..4 * level + 4] {
                assert!((force - above / 4.0).abs() <= 1e-14 * above, "corners share the load");
            }
        }
    }
}

/// One contact is equation (14) in complementarity form: `f = max(0, -b / G)`.
#[test]
fn one_contact_is_closed_form() {
    let mut problem = ContactProblem::new(1, vec![0.25]).unwrap();
    problem.push_row(&[(0, &[2.0])]).unwrap();
    let delassus = problem.delassus();
    for (b, force, w) in [(-3.0, 3.0, 0.0), (0.0, 0.0, 0.0), (2.0, 0.0, 2.0)] {
        let solution = solve_complementarity(&problem, &delassus, &[b], None, &SolverSettings::default()).unwrap();
        assert_eq!((solution.forces[0], solution.residual_accelerations[0]), (force, w));
        assert_eq!(solution.report.method, Method::ClosedForm);
        assert_eq!(solution.held[0], w == 0.0);
    }
}

/// The law of contact holds to 1e-13 on random piles, towers, overhangs, mass ratios of 1e6, duplicated and nearly
/// duplicated rows, for the forces found and for the least forces; every problem is solved without fallback.
#[test]
fn law_of_contact_holds_to_rounding() {
    let mut noise = Noise::new(2024);
    for round in 0..400 {
        let boxes = 1 + noise.below(9);
        let masses = |noise: &mut Noise, ratio: f64| (0..boxes).map(|_| ratio.powf(noise.unit())).collect::<Vec<_>>();
        let scenes = [
            pile(1 + noise.below(7), 1 + noise.below(5), 1.0, &mut noise),
            pile(1 + noise.below(7), 1 + noise.below(5), 1e6, &mut noise),
            tower(&vec![1.0; boxes], 0.0, &mut noise),
            tower(&masses(&mut noise, 1e6), 0.2, &mut noise),
            tower(&masses(&mut noise, 1e3), 0.7, &mut noise),
            repeated(boxes, 0.0, &mut noise),
            repeated(boxes, 1e-13, &mut noise),
        ];
        for (kind, scene) in scenes.iter().enumerate() {
            let solution = solve(scene);
            let label = format!("round {round}, kind {kind}: {:?}", solution.report);
            assert_eq!(solution.report.status, SolverStatus::Solved, "{label}");
            assert!(!solution.report.method.is_fallback(), "{label}");
            let forces = least(scene, &solution);
            for forces in [&solution.forces, &forces] {
                assert!(forces.iter().all(|force| *force >= 0.0), "{label}");
                let residual = residual(scene, forces);
                assert!(residual <= 1e-13, "{label}: {residual:e}");
            }
            // At rest contact forces do no work.
            let power: f64 = solution.forces.iter().zip(&solution.residual_accelerations).map(|(f, w)| f * w).sum();
            assert_eq!(power, 0.0, "{label}");
            let norm = |forces: &[f64]| forces.iter().map(|force| force * force).sum::<f64>();
            assert!(norm(&forces) <= norm(&solution.forces) * (1.0 + 1e-12), "{label}");
        }
    }
}

/// A tower with every row of the floor given three times, changed by up to `spread` relative.
fn repeated(boxes: usize, spread: f64, noise: &mut Noise) -> Scene {
    let scene = tower(&vec![1.0; boxes], 0.0, noise);
    let mut rows: Vec<Row> = Vec::new();
    for (sx, sy) in [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
        for _ in 0..3 {
            let mut near = |value: f64| value * (1.0 + spread * noise.signed());
            rows.push(vec![(0, vec![0.0, 0.0, 1.0, near(sy), near(-sx), 0.0])]);
        }
    }
    for level in 1..boxes {
        for (sx, sy) in [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
            rows.push(vec![
                (level, vec![0.0, 0.0, 1.0, sy, -sx, 0.0]),
                (level - 1, vec![0.0, 0.0, -1.0, -sy, sx, 0.0]),
            ]);
        }
    }
    let diagonals: Vec<Vec<f64>> =
        scene.masses.chunks_exact(36).map(|block| (0..6).map(|k| block[7 * k]).collect()).collect();
    Scene::new(6, &diagonals, &rows, &scene.free[..6])
}

/// Clarabel, another method in another formulation, finds the same accelerations to its own accuracy (1e-12 in the
/// objective, hence about 1e-6 in accelerations that the objective barely sees).
#[test]
fn interior_point_finds_the_same_motion() {
    let mut noise = Noise::new(77);
    let mut compared = 0;
    for _ in 0..100 {
        let boxes = 1 + noise.below(5);
        for scene in
            [pile(1 + noise.below(6), 1 + noise.below(4), 10.0, &mut noise), tower(&vec![1.0; boxes], 0.6, &mut noise)]
        {
            let Some((change, _)) = oracle::lifted(&scene) else { continue };
            let own = scene.problem.response(&solve(&scene).forces).unwrap();
            assert_close(&own, &change, 1e-5 * GRAVITY);
            compared += 1;
        }
    }
    assert!(compared >= 190, "{compared}");
}

/// The motion and the least forces do not depend on the order of the rows.
#[test]
fn motion_does_not_depend_on_the_order_of_rows() {
    let mut noise = Noise::new(5);
    for round in 0..100 {
        let (boxes, shift) = (2 + noise.below(5), if round % 2 == 0 { 0.0 } else { 0.6 });
        let scene = tower(&vec![1.0; boxes], shift, &mut noise.clone());
        let order = noise.permutation(scene.problem.len());
        let shuffled = reordered(&scene, &order);
        let (one, two) = (solve(&scene), solve(&shuffled));
        assert_close(&scene.accelerations(&one.forces), &shuffled.accelerations(&two.forces), 1e-12 * GRAVITY);
        let (first, second) = (least(&scene, &one), least(&shuffled, &two));
        let back: Vec<f64> = order.iter().map(|&row| first[row]).collect();
        assert_close(&second, &back, 1e-11 * GRAVITY * boxes as f64);
        let held: Vec<bool> = order.iter().map(|&row| one.held[row]).collect();
        assert_eq!(held, two.held);
    }
}

/// The same scene with its rows in another order: row `k` is row `order[k]` of the original.
fn reordered(scene: &Scene, order: &[usize]) -> Scene {
    let (width, bodies) = (scene.problem.width(), scene.problem.bodies());
    let size = width * bodies;
    // The columns of J, one unit velocity at a time.
    let columns: Vec<Vec<f64>> = (0..size)
        .map(|k| {
            let unit: Vec<f64> = (0..size).map(|i| f64::from(u8::from(i == k))).collect();
            scene.problem.row_velocities(&unit).unwrap()
        })
        .collect();
    let block = |row: usize, body: usize| (0..width).map(|k| columns[body * width + k][row]).collect::<Vec<f64>>();
    let rows: Vec<Row> = order
        .iter()
        .map(|&row| {
            let blocks = (0..bodies).map(|body| (body, block(row, body)));
            blocks.filter(|(_, block)| block.iter().any(|value| *value != 0.0)).collect()
        })
        .collect();
    let diagonals: Vec<Vec<f64>> = scene
        .masses
        .chunks_exact(width * width)
        .map(|block| (0..width).map(|k| block[(width + 1) * k]).collect())
        .collect();
    Scene::new(width, &diagonals, &rows, &scene.free[..width])
}

/// Any warm start, right, wrong or nonsense, leads to the same motion.
#[test]
fn warm_start_never_changes_the_motion() {
    let mut noise = Noise::new(99);
    let settings = SolverSettings::default();
    let mut solver = ComplementaritySolver::new(settings);
    for _ in 0..200 {
        let scene = pile(1 + noise.below(6), 1 + noise.below(5), 100.0, &mut noise);
        let delassus = scene.problem.delassus();
        let cold = solve(&scene);
        let guess =
            (0..noise.below(2 * scene.problem.len() + 2)).map(|_| noise.below(scene.problem.len() + 3)).collect();
        for start in [cold.warm_start.clone(), WarmStart::new(guess)] {
            let warm = solver.solve(&scene.problem, &delassus, &scene.b, Some(&start)).unwrap();
            assert_eq!(warm.report.status, SolverStatus::Solved);
            assert_close(&scene.accelerations(&warm.forces), &scene.accelerations(&cold.forces), 1e-11 * GRAVITY);
        }
    }
}

/// Masses times 1e-9 or 1e9 and accelerations times 1e-6 or 1e6 scale the forces and change nothing else.
#[test]
fn forces_scale_with_mass_and_acceleration() {
    let scene = tower(&[1.0, 3.0, 2.0], 0.3, &mut Noise::new(8));
    let reference = least(&scene, &solve(&scene));
    for (mass, acceleration) in [(1e-9, 1e6), (1e9, 1e-6), (1e9, 1e6), (1e-9, 1e-6)] {
        let masses: Vec<f64> = [1.0, 3.0, 2.0].iter().map(|value| value * mass).collect();
        let mut scaled = tower(&masses, 0.3, &mut Noise::new(8));
        scaled.b.iter_mut().for_each(|b| *b *= acceleration);
        let forces: Vec<f64> = least(&scaled, &solve(&scaled)).iter().map(|f| f / mass / acceleration).collect();
        assert_close(&forces, &reference, 1e-12 * GRAVITY);
    }
}

/// A body between two immovable walls that close in has no forces: the status says so. A body that fits exactly is
/// fine.
#[test]
fn squeezed_body_is_infeasible() {
    let mut problem = ContactProblem::new(1, vec![1.0]).unwrap();
    problem.push_row(&[(0, &[1.0])]).unwrap();
    problem.push_row(&[(0, &[-1.0])]).unwrap();
    let delassus = problem.delassus();
    let solve = |b: &[f64]| solve_complementarity(&problem, &delassus, b, None, &SolverSettings::default()).unwrap();
    assert_eq!(solve(&[-1.0, -1.0]).report.status, SolverStatus::Infeasible);
    assert_eq!(solve(&[-1.0, 1.0]).report.status, SolverStatus::Solved);
    assert_eq!(solve(&[0.0, 0.0]).forces, [0.0, 0.0]);
    let zero = ContactProblem::new(1, vec![0.0]).map(|mut problem| {
        problem.push_row(&[(0, &[1.0])]).unwrap();
        problem.push_row(&[(0, &[1.0])]).unwrap();
        problem
    });
    let zero = zero.unwrap();
    let report = solve_complementarity(&zero, &zero.delassus(), &[-1.0, 2.0], None, &SolverSettings::default());
    assert_eq!(report.unwrap().report.status, SolverStatus::Infeasible);
}

/// A body that fits exactly between two walls is not squeezed by constant terms that are roundings of the others in the
/// problem, as they are where velocities cancel, whether the contact of these pushes it along the walls or towards one;
/// by more than that it is. Where the answer was found only so, its report says it.
#[test]
fn roundings_of_other_rows_squeeze_no_body() {
    for (push, noise) in [([0.6, 0.8], 0.0), ([0.0, 1.0], 64.0 * f64::EPSILON)] {
        let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0]).unwrap();
        for row in [[1.0, 0.0], [-1.0, 0.0], push] {
            problem.push_row(&[(0, &row)]).unwrap();
        }
        let delassus = problem.delassus();
        let settings = SolverSettings::default();
        let solve = |b: &[f64]| solve_complementarity(&problem, &delassus, b, None, &settings).unwrap();
        for speed in [1e-6, 1.0, 1e6] {
            let solution = solve(&[-3e-17 * speed, 1e-17 * speed, -speed]);
            assert_eq!(solution.report.status, SolverStatus::Solved, "{speed}: {:?}", solution.report);
            assert_eq!(solution.report.noise_floor, noise * speed, "{:?}", solution.report);
            let rate = problem.response(&solution.forces).unwrap();
            let along = speed / push[1];
            assert!(rate[0].abs() < 1e-14 * speed && (rate[1] - along).abs() < 1e-13 * speed, "{rate:?}");
            let squeezed = solve(&[-3e-12 * speed, 1e-12 * speed, -speed]);
            assert_eq!(squeezed.report.status, SolverStatus::Infeasible, "{speed}: {:?}", squeezed.report);
        }
    }
}

/// With too few pivots for the active set the status says that there is no accurate answer.
#[test]
fn too_few_pivots_are_told() {
    // Few such towers need more pivots than are allowed; this one does.
    let scene = tower(&[1.0; 60], 0.2, &mut Noise::new(4));
    // What is left are the 100 pivots that are always allowed; 240 rows of rank 180 need more.
    let settings = SolverSettings { pivots_per_row: 0, ..SolverSettings::default() };
    let refused = solve_complementarity(&scene.problem, &scene.problem.delassus(), &scene.b, None, &settings).unwrap();
    assert_eq!(refused.report.status, SolverStatus::Inaccurate);
    assert!(refused.report.residual > 1e-3 && refused.forces.iter().all(|force| *force >= 0.0));
}

/// No input makes the solver panic or hang: NaN and infinity are typed errors, extreme numbers end with a status.
#[test]
fn bad_numbers_are_refused() {
    let mut problem = ContactProblem::new(1, vec![1.0, 1.0]).unwrap();
    problem.push_row(&[(0, &[1.0]), (1, &[-1.0])]).unwrap();
    problem.push_row(&[(1, &[1.0])]).unwrap();
    let delassus = problem.delassus();
    let settings = SolverSettings::default();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = solve_complementarity(&problem, &delassus, &[1.0, bad], None, &settings).unwrap_err();
        assert!(matches!(error, ResponseError::NotFinite { index: 1, .. }), "{error}");
        assert!(ContactProblem::new(1, vec![bad]).is_err());
        assert!(problem.clone().push_row(&[(0, &[bad])]).is_err());
    }
    assert!(solve_complementarity(&problem, &delassus, &[1.0], None, &settings).is_err());
    let wrong = SolverSettings { tolerance: f64::NAN, ..settings };
    assert!(solve_complementarity(&problem, &delassus, &[1.0, 1.0], None, &wrong).is_err());
    for huge in [1e308, 1e-308, 5e-324] {
        let solution = solve_complementarity(&problem, &delassus, &[-huge, -huge], None, &settings).unwrap();
        assert!(solution.forces.iter().all(|force| force.is_finite()));
    }
    let mut overflowing = ContactProblem::new(1, vec![1e200]).unwrap();
    overflowing.push_row(&[(0, &[1e200])]).unwrap();
    let error = solve_complementarity(&overflowing, &overflowing.delassus(), &[-1.0], None, &settings).unwrap_err();
    assert!(matches!(error, ResponseError::NotFinite { .. }));
    let mut broken = solve_complementarity(&problem, &delassus, &[-1.0, -1.0], None, &settings).unwrap();
    broken.forces[1] = f64::NAN;
    assert!(minimum_norm(&problem, &broken, &settings).is_err());
    (broken.forces, broken.held, broken.report.rank) = (vec![0.0; 2], vec![false; 2], 1);
    assert_eq!(minimum_norm(&problem, &broken, &settings).unwrap().forces, [0.0; 2]);
    let empty = ContactProblem::new(6, Vec::new()).unwrap();
    let nothing = solve_complementarity(&empty, &empty.delassus(), &[], None, &settings).unwrap();
    assert_eq!((nothing.forces.len(), nothing.report.status), (0, SolverStatus::Solved));
}

proptest! {
    #![proptest_config(few(300))]

    /// Any rows and constant terms of one body, also repeated, parallel, opposite or zero: the solver ends with a
    /// solution of the law of contact or says that there is none.
    #[test]
    fn any_rows_of_one_body(
        rows in prop::collection::vec(prop::array::uniform3(-2_i8..=2), 1..9),
        constants in prop::collection::vec(-2_i8..=2, 9),
    ) {
        let rows: Vec<Row> =
            rows.iter().map(|row| vec![(0, row.iter().map(|value| f64::from(*value)).collect())]).collect();
        let mut scene = Scene::new(3, &[vec![1.0, 2.0, 0.5]], &rows, &[0.0; 3]);
        scene.b = constants[..rows.len()].iter().map(|value| f64::from(*value)).collect();
        let solution = solve(&scene);
        match solution.report.status {
            SolverStatus::Solved => prop_assert!(residual(&scene, &solution.forces) <= 1e-12),
            SolverStatus::Infeasible => prop_assert!(oracle::lifted(&scene).is_none()),
            SolverStatus::Inaccurate => prop_assert!(false, "{:?}", solution.report),
        }
    }
}
