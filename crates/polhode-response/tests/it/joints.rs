//! Bilateral rows: joints beside contacts.

use crate::exact::{Long, dense_jacobian, inverse_masses, row_accelerations};
use crate::scenes::{GRAVITY, Noise, Row, Scene, pile};
use polhode_response::{
    ComplementaritySolver, ContactProblem, ContactSolution, ImpactLaw, ImpactSettings, ResponseError, RowKind,
    SolverSettings, SolverStatus, WarmStart, minimum_norm, solve_complementarity,
};

/// The problem of a scene whose rows have these kinds, each taken `times` (-1 for a bilateral row taken backwards).
fn with_kinds(scene: &Scene, rows: &[(usize, RowKind, f64)]) -> (ContactProblem, Vec<f64>) {
    let jacobian = dense_jacobian(scene);
    let (width, bodies) = (scene.problem.width(), scene.problem.bodies());
    let mut blocks = Vec::new();
    for k in inverse_masses(scene).chunks_exact(width) {
        for line in 0..width {
            blocks.extend((0..width).map(|column| if line == column { k[line] } else { 0.0 }));
        }
    }
    let mut problem = ContactProblem::new(width, blocks).unwrap();
    let mut b = Vec::new();
    for &(row, kind, times) in rows {
        let block = |body: usize| -> Vec<f64> {
            jacobian[row][body * width..(body + 1) * width].iter().map(|value| times * value).collect()
        };
        let blocks: Vec<(usize, Vec<f64>)> = (0..bodies).map(|body| (body, block(body))).collect();
        let entries: Vec<(usize, &[f64])> = blocks
            .iter()
            .filter(|(_, block)| block.iter().any(|value| *value != 0.0))
            .map(|(body, block)| (*body, &block[..]))
            .collect();
        match kind {
            RowKind::Unilateral => problem.push_row(&entries),
            RowKind::Bilateral => problem.push_bilateral_row(&entries),
        }
        .unwrap();
        b.push(times * scene.b[row]);
    }
    (problem, b)
}

fn solved(problem: &ContactProblem, b: &[f64]) -> ContactSolution {
    solve_complementarity(problem, &problem.delassus(), b, None, &SolverSettings::default()).unwrap()
}

/// Largest difference of the motions of two answers, relative to the largest of their terms.
fn difference(a: (&ContactProblem, &[f64]), b: (&ContactProblem, &[f64])) -> f64 {
    let (a, b) = (a.0.response(a.1).unwrap(), b.0.response(b.1).unwrap());
    let size = a.iter().chain(&b).fold(GRAVITY, |most: f64, x| most.max(x.abs()));
    a.iter().zip(&b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / size
}

/// A pendulum of length l in a plane, at the angle t from the vertical with the rate w, as a point on a bilateral row:
/// the row pulls with `m (g cos t + w^2 l)`, and pushes when the pendulum is upside down and slow.
#[test]
fn pendulum_has_the_force_of_its_closed_form() {
    let (mass, length) = (2.5, 0.7);
    for (angle, rate) in [(0.0_f64, 0.0_f64), (0.4, 1.5), (2.8, 0.1), (3.1, 4.0), (-1.2, -2.0)] {
        let mut problem = ContactProblem::new(2, vec![1.0 / mass, 0.0, 0.0, 1.0 / mass]).unwrap();
        // From the pivot to the bob, the direction in which the distance grows.
        let outward = [angle.sin(), -angle.cos()];
        problem.push_bilateral_row(&[(0, &outward)]).unwrap();
        assert_eq!((problem.kind(0), problem.kind(1)), (Some(RowKind::Bilateral), None));
        let b = GRAVITY * angle.cos() + rate * rate * length;
        let solution = solved(&problem, &[b]);
        let pull = mass * (GRAVITY * angle.cos() + rate * rate * length);
        assert!((solution.forces[0] + pull).abs() < 1e-14 * pull.abs().max(mass * GRAVITY), "{solution:?}");
        assert!(solution.report.certified && solution.residual_accelerations == [0.0], "{:?}", solution.report);
    }
}

/// A bilateral row moves bodies as a pair of opposite unilateral rows does, wherever the row takes part with contacts
/// that hold and open; and neither its sign nor the order of the rows changes the motion.
#[test]
fn a_bilateral_row_is_a_pair_of_opposite_contacts() {
    let mut noise = Noise(404);
    let (mut pulled, mut opened, mut certified) = (0, 0, 0);
    for round in 0..400 {
        let scene = pile(2 + noise.below(3), 2 + noise.below(4), 10.0_f64.powi(round % 4), &mut noise);
        let kinds: Vec<RowKind> = (0..scene.b.len())
            .map(|_| if noise.unit() < 0.3 { RowKind::Bilateral } else { RowKind::Unilateral })
            .collect();
        let joined: Vec<_> = kinds.iter().enumerate().map(|(row, &kind)| (row, kind, 1.0)).collect();
        let pairs: Vec<_> = kinds
            .iter()
            .enumerate()
            .flat_map(|(row, kind)| {
                let sides: &[f64] = if *kind == RowKind::Bilateral { &[1.0, -1.0] } else { &[1.0] };
                sides.iter().map(move |&times| (row, RowKind::Unilateral, times))
            })
            .collect();
        let turned: Vec<_> = noise
            .permutation(joined.len())
            .into_iter()
            .map(|k| (joined[k].0, joined[k].1, if joined[k].1 == RowKind::Bilateral { -3.0 } else { 0.5 }))
            .collect();
        let (problem, b) = with_kinds(&scene, &joined);
        let (pair_problem, pair_b) = with_kinds(&scene, &pairs);
        let (turned_problem, turned_b) = with_kinds(&scene, &turned);
        let solution = solved(&problem, &b);
        assert_eq!(solution.report.status, SolverStatus::Solved, "{round}: {:?}", solution.report);
        for (other, other_b) in [(&pair_problem, &pair_b), (&turned_problem, &turned_b)] {
            let answer = solved(other, other_b);
            assert_eq!(answer.report.status, SolverStatus::Solved, "{round}: {:?}", answer.report);
            let change = difference((&problem, &solution.forces), (other, &answer.forces));
            assert!(change < 1e-10, "{round}: {change:e}");
        }
        // Warm from its own answer, and from rows that do not carry anything.
        for start in [solution.warm_start.clone(), WarmStart::new((0..b.len()).rev().collect())] {
            let mut solver = ComplementaritySolver::default();
            let again = solver.solve(&problem, &problem.delassus(), &b, Some(&start)).unwrap();
            assert!(difference((&problem, &solution.forces), (&problem, &again.forces)) < 1e-10, "{round}");
        }
        for (row, kind) in kinds.iter().enumerate() {
            let (force, w) = (solution.forces[row], solution.residual_accelerations[row]);
            assert!(w >= 0.0 && (*kind == RowKind::Bilateral || force >= 0.0), "{round}: {force:e} {w:e}");
            pulled += usize::from(force < 0.0);
            opened += usize::from(w > 0.0);
            assert!(*kind == RowKind::Unilateral || (w == 0.0 && solution.held[row]));
        }
        // The truth of the rows in twice the precision: complementary to rounding.
        let forces: Vec<Long> = solution.forces.iter().map(|&force| Long::new(force)).collect();
        let w = row_accelerations(&dense_jacobian(&scene), &inverse_masses(&scene), &b, &forces);
        let size = b.iter().fold(GRAVITY, |most: f64, b| most.max(b.abs()));
        for (row, w) in w.iter().enumerate() {
            let wrong = if kinds[row] == RowKind::Bilateral || solution.forces[row] > 0.0 { w.abs() } else { -w };
            assert!(wrong < 1e-9 * size, "{round}: {wrong:e}");
        }
        certified += usize::from(solution.report.certified);
    }
    assert!(pulled > 100 && opened > 100 && certified > 390, "{pulled} {opened} {certified}");
}

/// A beam hung by a joint at one end and resting on a support at the other, the joint's row given several times: the
/// motion does not know, and the least forces share the joint's load among its copies.
#[test]
fn joints_that_are_given_twice_share_their_load() {
    let row = |x: f64| -> Row { vec![(0, vec![0.0, 1.0, x])] };
    let rows = [row(-1.0), row(-1.0), row(-1.0), row(0.25), vec![(0, vec![1.0, 0.0, 0.0])]];
    let scene = Scene::new(3, &[vec![1.0, 1.0, 1.0 / 3.0]], &rows, &[0.5, -GRAVITY, 0.0]);
    let bilateral = |row: usize| (row, RowKind::Bilateral, 1.0);
    let kinds = [bilateral(0), bilateral(1), bilateral(2), (3, RowKind::Unilateral, 1.0), bilateral(4)];
    let (problem, b) = with_kinds(&scene, &kinds);
    let settings = SolverSettings::default();
    let solution = solved(&problem, &b);
    assert_eq!(solution.report.status, SolverStatus::Solved);
    let least = minimum_norm(&problem, &solution, &settings).unwrap();
    // Moments about the support: the joint carries 1/5 of the weight, the support 4/5; the push along the beam is held.
    let third = GRAVITY / 15.0;
    for (force, expected) in least.forces.iter().zip([third, third, third, 0.8 * GRAVITY, -0.5]) {
        assert!((force - expected).abs() < 1e-13, "{:?}", least.forces);
    }
    assert!(least.minimal && least.freedom == 2);
    // The support beyond the centre of mass on the joint's side would have to hold the beam by pulling at the joint.
    let rows = [row(-1.0), row(-1.0), row(-0.25)];
    let scene = Scene::new(3, &[vec![1.0, 1.0, 1.0 / 3.0]], &rows, &[0.0, -GRAVITY, 0.0]);
    let (problem, b) = with_kinds(&scene, &[bilateral(0), bilateral(1), (2, RowKind::Unilateral, 1.0)]);
    let solution = solved(&problem, &b);
    let least = minimum_norm(&problem, &solution, &settings).unwrap();
    for (force, expected) in least.forces.iter().zip([-GRAVITY / 6.0, -GRAVITY / 6.0, 4.0 * GRAVITY / 3.0]) {
        assert!((force - expected).abs() < 1e-13, "{:?}", least.forces);
    }
}

/// Bilateral rows that contradict each other are not solved, and laws that know contacts only refuse joints.
#[test]
fn what_cannot_be_held_is_said() {
    let mut problem = ContactProblem::new(1, vec![1.0]).unwrap();
    problem.push_bilateral_row(&[(0, &[1.0])]).unwrap();
    problem.push_bilateral_row(&[(0, &[1.0])]).unwrap();
    let solution = solved(&problem, &[1.0, 2.0]);
    assert!(solution.report.status != SolverStatus::Solved && !solution.report.certified, "{solution:?}");
    let mut solver = ComplementaritySolver::default();
    let (delassus, settings) = (problem.delassus(), ImpactSettings::default());
    for law in [ImpactLaw::Propagation, ImpactLaw::Simultaneous, ImpactLaw::Reflection] {
        let refused = law.resolve(&problem, &delassus, &[-1.0, -1.0], &[0.5; 2], &settings, &mut solver);
        assert!(matches!(refused, Err(ResponseError::BilateralRow { row: 0, .. })));
    }
    problem.clear_rows();
    assert!(problem.kind(0).is_none());
}
