//! Two solvers that share no method of elimination: in the velocities of bodies, and over the Delassus matrix.
//!
//! Reactions of redundant contacts are not unique, motions are (for friction as small as here): velocities are
//! compared. All laws take part: contacts with friction, without, those that slide already, that resist rolling and
//! spinning, and joints.

use super::body_scenes::{BodyScene, Contact, Dice, heap, pyramid, tower};
use polhode_response::friction::{FrictionProblem, FrictionSettings, solve_friction};
use polhode_response::sparse::{BodySettings, BodySolver};
use polhode_response::{Law, Resistance, SolverStatus};

/// `v_free + M^-1 H^T r` with the reactions of the solver over the Delassus matrix.
fn velocities_by_delassus(scene: &BodyScene) -> Option<Vec<[f64; 6]>> {
    let masses = scene.diagonal_masses();
    let mut lines: Vec<Vec<(usize, Vec<f64>)>> = Vec::new();
    let mut constant = Vec::new();
    let mut compliances = Vec::new();
    for contact in &scene.contacts {
        let parts = scene.jacobian(contact);
        for row in 0..contact.law.rows() {
            let own: Vec<(usize, Vec<f64>)> =
                parts.iter().map(|(body, lines)| (*body, lines[6 * row..6 * row + 6].to_vec())).collect();
            let rate = |(body, line): &(usize, Vec<f64>)| -> f64 {
                line.iter().zip(scene.velocities[*body]).map(|(h, v)| h * v).sum()
            };
            constant.push(own.iter().map(rate).sum::<f64>() + if row == 0 { contact.bias } else { 0.0 });
            compliances.push(contact.compliance);
            lines.push(own);
        }
    }
    let entry = |i: usize, j: usize| -> f64 {
        let mut sum = if i == j { compliances[i] } else { 0.0 };
        for (a, first) in &lines[i] {
            for (_, second) in lines[j].iter().filter(|(b, _)| a == b) {
                sum += (0..6).map(|k| first[k] * second[k] / masses[*a][k]).sum::<f64>();
            }
        }
        sum
    };
    let size = lines.len();
    let matrix: Vec<f64> = (0..size * size).map(|k| entry(k / size, k % size)).collect();
    let laws = scene.contacts.iter().map(|contact| contact.law).collect();
    let problem = FrictionProblem::from_dense(laws, &matrix, constant).unwrap();
    let solution = solve_friction(&problem, None, &FrictionSettings::default()).unwrap();
    if solution.report.status != SolverStatus::Solved {
        return None;
    }
    let mut velocities = scene.velocities.clone();
    for (row, r) in lines.iter().zip(&solution.reactions) {
        for (body, line) in row {
            for k in 0..6 {
                velocities[*body][k] += line[k] * r / masses[*body][k];
            }
        }
    }
    Some(velocities)
}

/// Solves; the largest difference of the motions. None where the other solver finds no answer.
fn difference(name: &str, scene: &BodyScene) -> Option<f64> {
    let solution = BodySolver::default().solve(&scene.problem(), None, &BodySettings::default()).unwrap();
    assert!(solution.report.residual <= 1e-12, "{name}: {:?}", solution.report);
    let expected = velocities_by_delassus(scene)?;
    let pairs = solution.velocities.as_flattened().iter().zip(expected.as_flattened());
    Some(pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())))
}

fn agree(name: &str, scene: &BodyScene) {
    if let Some(difference) = difference(name, scene) {
        assert!(difference < 1e-9, "{name}: motions differ by {difference}");
    }
}

#[test]
fn small_heaps_move_the_same() {
    for seed in 1..40 {
        agree("heap", heap(6, 0.3, seed).pull(0.0).shake(0.2, seed));
    }
}

#[test]
fn pyramids_and_towers_move_the_same() {
    agree("pyramid", pyramid(4, 0.5).pull(0.2));
    agree("tower", tower(4, 0.3).pull(0.4));
}

#[test]
fn compliant_contacts_move_the_same() {
    for compliance in [1e-3, 0.1, 10.0] {
        let mut scene = pyramid(3, 0.5);
        scene.pull(0.3).shake(0.05, 3);
        for contact in &mut scene.contacts {
            contact.compliance = compliance;
        }
        agree("compliant", &scene);
    }
}

/// Contacts of all laws among each other.
#[test]
fn all_laws_move_the_same() {
    for seed in 1..25 {
        let mut scene = heap(5, 0.3, seed);
        scene.pull(0.0).shake(0.2, seed);
        let mut dice = Dice(100 + seed);
        for contact in &mut scene.contacts {
            contact.law = match (dice.roll() * 4.0) as i32 {
                0 => Law::Push,
                1 => Law::Slide { friction: 0.2 },
                2 => Law::Cone { rows: 2, friction: 0.3 },
                _ => contact.law,
            };
        }
        agree("laws", &scene);
    }
}

/// Rows that are held among contacts.
#[test]
fn joints_among_contacts_move_the_same() {
    for seed in 1..10 {
        let mut scene = heap(4, 0.3, seed);
        let rider = scene.add_box([1.5, 0.0, 2.0], [0.4; 3], 0.5);
        let (point, normal, law) = ([0.5, 0.0, 2.0], [0.0, 0.0, 1.0], Law::Hold { rows: 3 });
        scene.contacts.push(Contact { a: rider, b: Some(1), point, normal, law, bias: 0.0, compliance: 0.0 });
        agree("joint", scene.pull(0.1).shake(0.1, seed));
    }
}

/// With six rows a contact two motions may satisfy all laws: each solver is held to its residual, and nearly all
/// motions agree.
#[test]
fn contacts_that_resist_rolling_and_spinning_move_the_same() {
    let mut others = 0;
    for seed in 1..15 {
        let mut scene = heap(4, 0.3, seed);
        scene.pull(0.0).shake(0.3, seed);
        for contact in &mut scene.contacts {
            let resists = |rows, friction| Resistance { rows, friction, slides: false };
            contact.law = Law::Resist { parts: [resists(2, 0.3), resists(2, 0.1), resists(1, 0.2)] };
        }
        let Some(difference) = difference("resist", &scene) else { continue };
        others += usize::from(difference > 1e-9);
    }
    assert!(others <= 1, "{others} of 14 move in another way");
}
