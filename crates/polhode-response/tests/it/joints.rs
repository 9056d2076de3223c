//! Bilateral rows: joints beside contacts.

use crate::exact::{Long, dense_jacobian, inverse_masses, row_accelerations};
use crate::scenes::{GRAVITY, Noise, Row, Scene, pile};
use polhode_response::{
    Blocks, ComplementaritySolver, ContactProblem, ContactSolution, ImpactLaw, ImpactProblem, ImpactSettings, Law,
    SolverSettings, SolverStatus, WarmStart, minimum_norm, solve_complementarity,
};

/// The law of one row of a joint.
const HELD: Law = Law::Hold { rows: 1 };

/// The problem of a scene whose rows have these laws, each taken `times` (-1 for a bilateral row taken backwards).
fn with_kinds(scene: &Scene, rows: &[(usize, Law, f64)]) -> (ContactProblem, Vec<f64>) {
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
        problem.push_block(kind, &[&entries]).unwrap();
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
        problem.push_held_row(&[(0, &outward)]).unwrap();
        assert_eq!(Blocks::of(&problem).laws(), [HELD]);
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
    let mut noise = Noise::new(404);
    let (mut pulled, mut opened, mut certified) = (0, 0, 0);
    for round in 0..400 {
        let scene = pile(2 + noise.below(3), 2 + noise.below(4), 10.0_f64.powi(round % 4), &mut noise);
        let kinds: Vec<Law> = (0..scene.b.len()).map(|_| if noise.unit() < 0.3 { HELD } else { Law::Push }).collect();
        let joined: Vec<_> = kinds.iter().enumerate().map(|(row, &kind)| (row, kind, 1.0)).collect();
        let pairs: Vec<_> = kinds
            .iter()
            .enumerate()
            .flat_map(|(row, kind)| {
                let sides: &[f64] = if *kind == HELD { &[1.0, -1.0] } else { &[1.0] };
                sides.iter().map(move |&times| (row, Law::Push, times))
            })
            .collect();
        let turned: Vec<_> = noise
            .permutation(joined.len())
            .into_iter()
            .map(|k| (joined[k].0, joined[k].1, if joined[k].1 == HELD { -3.0 } else { 0.5 }))
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
            assert!(w >= 0.0 && (*kind == HELD || force >= 0.0), "{round}: {force:e} {w:e}");
            pulled += usize::from(force < 0.0);
            opened += usize::from(w > 0.0);
            assert!(*kind == Law::Push || (w == 0.0 && solution.held[row]));
        }
        // The truth of the rows in twice the precision: complementary to rounding.
        let forces: Vec<Long> = solution.forces.iter().map(|&force| Long::new(force)).collect();
        let w = row_accelerations(&dense_jacobian(&scene), &inverse_masses(&scene), &b, &forces);
        let size = b.iter().fold(GRAVITY, |most: f64, b| most.max(b.abs()));
        for (row, w) in w.iter().enumerate() {
            let wrong = if kinds[row] == HELD || solution.forces[row] > 0.0 { w.abs() } else { -w };
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
    let bilateral = |row: usize| (row, HELD, 1.0);
    let kinds = [bilateral(0), bilateral(1), bilateral(2), (3, Law::Push, 1.0), bilateral(4)];
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
    let (problem, b) = with_kinds(&scene, &[bilateral(0), bilateral(1), (2, Law::Push, 1.0)]);
    let solution = solved(&problem, &b);
    let least = minimum_norm(&problem, &solution, &settings).unwrap();
    for (force, expected) in least.forces.iter().zip([-GRAVITY / 6.0, -GRAVITY / 6.0, 4.0 * GRAVITY / 3.0]) {
        assert!((force - expected).abs() < 1e-13, "{:?}", least.forces);
    }
}

/// A joint keeps `u+ = 0` in an impact by every law, also when it moved before; the energy does not rise, and of an
/// elastic impact against joints that were at rest it is kept.
#[test]
fn joints_hold_through_impacts() {
    let mut noise = Noise::new(77);
    let mut struck = 0;
    for round in 0..200 {
        let scene = pile(2 + noise.below(3), 2 + noise.below(2), 10.0, &mut noise);
        let kinds: Vec<_> =
            (0..scene.b.len()).map(|row| (row, if row % 3 == 1 { HELD } else { Law::Push }, 1.0)).collect();
        let (problem, _) = with_kinds(&scene, &kinds);
        let (delassus, settings) = (problem.delassus(), ImpactSettings::default());
        let mut solver = ComplementaritySolver::default();
        let moving: Vec<f64> = (0..scene.free.len()).map(|_| noise.signed()).collect();
        let any = problem.row_velocities(&moving).unwrap();
        // The same with the joints at rest: an inelastic impact of all joints and no contact.
        let mut at_rest = any.clone();
        let joints: Vec<usize> = (0..any.len()).filter(|row| row % 3 == 1).collect();
        let alone: Vec<_> = joints.iter().map(|&row| (row, HELD, 1.0)).collect();
        let (joint_problem, _) = with_kinds(&scene, &alone);
        let b: Vec<f64> = joints.iter().map(|&row| any[row]).collect();
        let impulses = solved(&joint_problem, &b).forces;
        for (&row, impulse) in joints.iter().zip(&impulses) {
            for (u, entry) in at_rest.iter_mut().zip(delassus.row(row)) {
                *u += impulse * entry;
            }
        }
        for &row in &joints {
            at_rest[row] = 0.0;
        }
        for (u, elastic) in [(&any, false), (&at_rest, true)] {
            for law in [ImpactLaw::Propagation, ImpactLaw::Simultaneous, ImpactLaw::Reflection] {
                let e = if elastic { 1.0 } else { 0.6 };
                let restitution = vec![e; u.len()];
                let (contacts, delassus, restitution, settings) = (&problem, &delassus, &restitution[..], &settings);
                let impact = ImpactProblem { contacts, delassus, u_before: u, restitution, settings };
                let outcome = law.resolve(&impact, &mut solver).unwrap();
                let after = delassus.times(&outcome.impulses).unwrap();
                let size = u.iter().fold(1.0, |most: f64, u| most.max(u.abs()));
                for row in 0..u.len() {
                    let speed = u[row] + after[row];
                    let wrong = if row % 3 == 1 { speed.abs() } else { -speed };
                    assert!(wrong < 1e-9 * size, "{round} {law:?}: {wrong:e}");
                    assert!(row % 3 != 1 || outcome.velocities_after[row] == 0.0, "{round} {law:?}");
                    assert!(row % 3 == 1 || outcome.impulses[row] >= 0.0);
                    struck += usize::from(outcome.impulses[row] != 0.0);
                }
                assert!(outcome.energy_change <= 1e-12, "{round} {law:?}: {:e}", outcome.energy_change);
                let kept = law != ImpactLaw::Simultaneous || outcome.solves == 1;
                if elastic && kept && outcome.finishing.is_empty() {
                    assert!(outcome.energy_change.abs() < 1e-9, "{round} {law:?}: {:e}", outcome.energy_change);
                }
            }
        }
    }
    assert!(struck > 2000, "{struck}");
}

/// A bob on a rigid rod that hangs at rest is struck sideways at 45 degrees by a wall of restitution e: the rod takes
/// the vertical part, and the bob leaves along the circle. By every law the wall's row leaves with `-e u`.
#[test]
fn a_pendulum_that_meets_a_wall_leaves_along_its_circle() {
    let (mass, e, half) = (2.0, 0.5, 0.5_f64.sqrt());
    let mut problem = ContactProblem::new(2, vec![1.0 / mass, 0.0, 0.0, 1.0 / mass]).unwrap();
    problem.push_row(&[(0, &[-half, half])]).unwrap();
    problem.push_held_row(&[(0, &[0.0, 1.0])]).unwrap();
    let u = problem.row_velocities(&[3.0, 0.0]).unwrap();
    let mut solver = ComplementaritySolver::default();
    for law in [ImpactLaw::Propagation, ImpactLaw::Simultaneous, ImpactLaw::Reflection] {
        let (contacts, delassus, settings) = (&problem, &problem.delassus(), &ImpactSettings::default());
        let impact = ImpactProblem { contacts, delassus, u_before: &u, restitution: &[e, 0.0], settings };
        let outcome = law.resolve(&impact, &mut solver).unwrap();
        // m v (1 + e) along x, of which the wall gives p / sqrt 2 and the rod nothing; along z they cancel.
        let wall = mass * 3.0 * (1.0 + e) / half;
        for (impulse, expected) in outcome.impulses.iter().zip([wall, -wall * half]) {
            assert!((impulse - expected).abs() < 1e-13 * wall, "{law:?}: {:?}", outcome.impulses);
        }
        assert!((outcome.velocities_after[0] + e * u[0]).abs() < 1e-14 && outcome.velocities_after[1] == 0.0);
        assert!((outcome.energy_change + 0.5 * mass * 9.0 * (1.0 - e * e)).abs() < 1e-12, "{law:?}");
    }
}

/// Bilateral rows that contradict each other are not solved.
#[test]
fn what_cannot_be_held_is_said() {
    let mut problem = ContactProblem::new(1, vec![1.0]).unwrap();
    problem.push_held_row(&[(0, &[1.0])]).unwrap();
    problem.push_held_row(&[(0, &[1.0])]).unwrap();
    let solution = solved(&problem, &[1.0, 2.0]);
    assert!(solution.report.status != SolverStatus::Solved && !solution.report.certified, "{solution:?}");
    problem.clear_rows();
    assert!(Blocks::of(&problem).is_empty());
}
