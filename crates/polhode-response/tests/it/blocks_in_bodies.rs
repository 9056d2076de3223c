//! The same rows and laws, solved with the matrix of all rows and in the velocities of bodies.
//!
//! Both must give the bodies the same motion, whatever the order of rows: normals first, then joints, then tangents, as
//! time steps have them. Scaled rows (an ellipse of friction), blocks of held rows that span two joints, and bodies
//! with the three coordinates of a plane take part.

use super::body_scenes::{BodyScene, Contact, heap, pyramid};
use polhode_response::friction::{ContactStatus, FrictionSettings};
use polhode_response::sparse::{BodySettings, BodySolver};
use polhode_response::{Blocks, BlocksSolution, ContactProblem, Law, ResponseError, SolverStatus};

/// Friction across the grain over that along it.
const ACROSS: f64 = 0.5;

/// Rows, blocks and constant terms of a scene: normals, held rows, tangents.
struct Rows {
    problem: ContactProblem,
    blocks: Blocks,
    constants: Vec<f64>,
}

fn rows_of(scene: &BodyScene, has_grain: bool) -> Rows {
    let masses = scene.diagonal_masses();
    let inverse = masses.iter().flat_map(|m| (0..36).map(|k| if k % 7 == 0 { 1.0 / m[k / 7] } else { 0.0 }));
    let mut problem = ContactProblem::new(6, inverse.collect()).unwrap();
    let mut constants = Vec::new();
    let mut push = |contact: &Contact, row: usize| {
        let parts = scene.jacobian(contact);
        let line = |lines: &[f64]| lines[6 * row..6 * row + 6].to_vec();
        let own: Vec<(usize, Vec<f64>)> = parts.iter().map(|(body, lines)| (*body, line(lines))).collect();
        let entries: Vec<(usize, &[f64])> = own.iter().map(|(body, line)| (*body, &line[..])).collect();
        let rate = |(body, line): &(usize, Vec<f64>)| -> f64 {
            line.iter().zip(scene.velocities[*body]).map(|(h, v)| h * v).sum()
        };
        constants.push(own.iter().map(rate).sum::<f64>());
        let is_held = row > 0 || matches!(contact.law, Law::Hold { .. });
        if is_held { problem.push_held_row(&entries) } else { problem.push_row(&entries) }.unwrap()
    };
    let is_joint = |contact: &&Contact| matches!(contact.law, Law::Hold { .. });
    let contacts: Vec<&Contact> = scene.contacts.iter().filter(|contact| !is_joint(contact)).collect();
    let normals: Vec<usize> = contacts.iter().map(|contact| push(contact, 0)).collect();
    let joints = scene.contacts.iter().filter(is_joint).flat_map(|joint| (0..3).map(move |row| (joint, row)));
    let held: Vec<usize> = joints.map(|(joint, row)| push(joint, row)).collect();
    let tangents: Vec<[usize; 2]> = contacts.iter().map(|contact| [1, 2].map(|row| push(contact, row))).collect();
    let mut blocks = Blocks::default();
    for ((contact, normal), [first, second]) in contacts.iter().zip(&normals).zip(&tangents) {
        let rows = [*normal, *first, *second];
        if has_grain {
            blocks.push_scaled(contact.law, rows, [1.0, 1.0, ACROSS]);
        } else {
            blocks.push(contact.law, rows);
        }
    }
    // Two held rows a block: some of them of two joints.
    for pair in held.chunks(2) {
        blocks.push(Law::Hold { rows: pair.len() }, pair.iter().copied());
    }
    Rows { problem, blocks, constants }
}

fn in_bodies(rows: &Rows) -> BlocksSolution {
    let mut solver = BodySolver::default();
    let system = (&mut solver, &BodySettings::default());
    let (solved, effort) = rows.blocks.solve_in_bodies(&rows.problem, &rows.constants, None, system).unwrap();
    assert_eq!(solved.report.status, SolverStatus::Solved, "{effort:?}");
    solved
}

/// The motions by both ways are the same. Reactions need not be, where contacts are redundant.
fn agree(name: &str, rows: &Rows) {
    let found = in_bodies(rows);
    let delassus = rows.problem.delassus();
    let other = rows.blocks.solve(&delassus, &rows.constants, None, &FrictionSettings::default()).unwrap();
    assert_eq!(other.report.status, SolverStatus::Solved, "{name}");
    let [one, two] = [&found, &other].map(|solved| rows.problem.response(&solved.reactions).unwrap());
    let apart = one.iter().zip(&two).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    assert!(apart < 1e-9, "{name}: motions differ by {apart}");
    for (a, b) in found.velocities.iter().zip(&other.velocities) {
        assert!((a - b).abs() < 1e-9, "{name}: a row moves with {a} and with {b}");
    }
    // Rows of the problem: u = b + G r with the reactions told.
    let given = delassus.times(&found.reactions).unwrap();
    for ((u, b), given) in found.velocities.iter().zip(&rows.constants).zip(&given) {
        assert!((u - b - given).abs() < 1e-10, "{name}: a row is told to move with {u}, not {}", b + given);
    }
}

/// A heap whose bodies also hang on each other by ball joints.
fn linked(seed: u64) -> BodyScene {
    let mut scene = heap(6, 0.3, seed);
    for a in [1, 3] {
        let (point, normal, law) = (scene.centres[a], [0.0, 0.0, 1.0], Law::Hold { rows: 3 });
        scene.contacts.push(Contact { a, b: Some(a + 1), point, normal, law, bias: 0.0, compliance: 0.0 });
    }
    scene
}

#[test]
fn motions_are_the_same_with_and_without_the_matrix() {
    for seed in 1..12 {
        agree("heap", &rows_of(heap(6, 0.3, seed).pull(0.0).shake(0.2, seed), false));
        agree("grain", &rows_of(heap(6, 0.3, seed).pull(0.0).shake(0.2, seed), true));
        agree("joints", &rows_of(linked(seed).pull(0.0).shake(0.2, seed), false));
    }
    agree("pyramid", &rows_of(pyramid(4, 0.5).pull(0.1), false));
}

/// A block of 2 kg in the plane (x, y and its turn) slides on two corners with 4 m/s and slows to 2.5 m/s at 3 m/s of
/// load.
#[test]
fn bodies_in_a_plane_have_three_coordinates() {
    let mut problem = ContactProblem::new(3, vec![0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1e-9]).unwrap();
    for corner in [-1.0, 1.0] {
        problem.push_row(&[(0, &[0.0, 1.0, corner])]).unwrap();
    }
    for _ in 0..2 {
        problem.push_held_row(&[(0, &[1.0, 0.0, 0.0])]).unwrap();
    }
    let mut blocks = Blocks::default();
    for contact in 0..2 {
        blocks.push(Law::Cone { rows: 2, friction: 0.5 }, [contact, 2 + contact]);
    }
    let solved = in_bodies(&Rows { problem, blocks, constants: vec![-3.0, -3.0, 4.0, 4.0] });
    assert!(solved.velocities[2..].iter().all(|slip| (slip - 2.5).abs() < 1e-9), "{solved:?}");
    assert_eq!(solved.statuses, [ContactStatus::Slide; 2]);
    assert!((solved.reactions[0] + solved.reactions[1] - 6.0).abs() < 1e-9);
}

/// The answer is an answer: started from it, no factorisation is needed, and the elimination is kept.
#[test]
fn an_answer_is_its_own_start() {
    let rows = rows_of(pyramid(4, 0.5).pull(0.1), false);
    let mut solver = BodySolver::default();
    let settings = BodySettings::default();
    let mut solve = |start: Option<&[f64]>| {
        rows.blocks.solve_in_bodies(&rows.problem, &rows.constants, start, (&mut solver, &settings)).unwrap()
    };
    let (first, cold) = solve(None);
    let (again, warm) = solve(Some(&first.reactions));
    assert!(cold.factorisations > 0 && warm.factorisations <= 1 && warm.kept_elimination, "{warm:?}");
    for (a, b) in first.velocities.iter().zip(&again.velocities) {
        assert!((a - b).abs() < 1e-11);
    }
}

/// What cannot be solved so is told by an error: a row that does not exist, another number of constant terms, a body
/// that a force along some direction does not move.
#[test]
fn what_is_not_a_problem_is_refused() {
    let mut rows = rows_of(pyramid(2, 0.5).pull(0.0), false);
    let mut solver = BodySolver::default();
    let settings = BodySettings::default();
    let short = rows.blocks.solve_in_bodies(&rows.problem, &rows.constants[1..], None, (&mut solver, &settings));
    assert!(matches!(short, Err(ResponseError::Length { .. })), "{short:?}");
    rows.blocks.push(Law::Push, [10_000]);
    let unknown = rows.blocks.solve_in_bodies(&rows.problem, &rows.constants, None, (&mut solver, &settings));
    assert!(matches!(unknown, Err(ResponseError::UnknownRow { .. })), "{unknown:?}");
    let mut on_a_rail = ContactProblem::new(2, vec![0.0, 0.0, 0.0, 1.0]).unwrap();
    on_a_rail.push_row(&[(0, &[0.0, 1.0])]).unwrap();
    let mut blocks = Blocks::default();
    blocks.push(Law::Push, [0]);
    let refused = blocks.solve_in_bodies(&on_a_rail, &[-1.0], None, (&mut solver, &settings));
    assert!(matches!(refused, Err(ResponseError::BodyMass { .. })), "{refused:?}");
}
