//! Answers do not depend on units, axes, or what the solver did before.

use super::body_scenes::{BodyScene, heap, pyramid};
use polhode_response::sparse::{BodySettings, BodySolution, BodySolver};

fn solved(scene: &BodyScene) -> BodySolution {
    BodySolver::default().solve(&scene.problem(), None, &BodySettings::default()).unwrap()
}

fn scene() -> BodyScene {
    let mut scene = pyramid(6, 0.5);
    scene.pull(0.25);
    scene.velocities[7][0] += 0.4;
    scene
}

/// Cubes that touch each other in single points: their motion is unique. (That of a box that slides on four corners
/// is not: it depends on which of them bear how much.)
fn cubes() -> BodyScene {
    let mut scene = heap(20, 0.3, 11);
    scene.sizes.fill([1.0; 3]);
    scene.pull(0.0).shake(0.2, 12);
    scene
}

/// Powers of two, and of four for masses since their roots are taken: all numbers are scaled exactly.
#[test]
fn units_that_are_powers_of_two_change_no_bit() {
    let plain = solved(&scene());
    let mut scaled = scene();
    let (mass, length, time) = (1024.0, 8.0, 0.25);
    for value in &mut scaled.masses {
        *value *= mass;
    }
    for value in scaled.sizes.as_flattened_mut().iter_mut().chain(scaled.centres.as_flattened_mut()) {
        *value *= length;
    }
    for contact in &mut scaled.contacts {
        contact.point = contact.point.map(|x| x * length);
    }
    for velocity in &mut scaled.velocities {
        for k in 0..3 {
            velocity[k] *= length / time;
            velocity[k + 3] /= time;
        }
    }
    let scaled = solved(&scaled);
    assert_eq!(plain.report, scaled.report);
    for (a, b) in plain.reactions.iter().zip(&scaled.reactions) {
        assert_eq!(a * (mass * length / time), *b);
    }
    for (a, b) in plain.velocities.iter().zip(&scaled.velocities) {
        assert_eq!(a.map(|x| x / time)[..3].iter().map(|x| x * length).collect::<Vec<_>>(), b[..3]);
    }
}

/// Cubes have the same inertia about all axes, so that the scene can be turned without it.
#[test]
fn turned_axes_turn_the_motion() {
    let plain = cubes();
    let turn = {
        // About (1, 2, 2)/3 by 1 rad, after Rodrigues.
        let (n, (s, c)) = ([1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0], 1_f64.sin_cos());
        move |x: [f64; 3]| -> [f64; 3] {
            let along: f64 = n.iter().zip(x).map(|(n, x)| n * x).sum();
            let across = super::body_scenes::cross(n, x);
            std::array::from_fn(|k| c * x[k] + s * across[k] + (1.0 - c) * along * n[k])
        }
    };
    let both = |v: [f64; 6]| -> [f64; 6] {
        let (linear, angular) = (turn([v[0], v[1], v[2]]), turn([v[3], v[4], v[5]]));
        std::array::from_fn(|k| if k < 3 { linear[k] } else { angular[k - 3] })
    };
    let mut turned = plain.clone();
    turned.centres = plain.centres.iter().copied().map(turn).collect();
    turned.velocities = plain.velocities.iter().copied().map(both).collect();
    for contact in &mut turned.contacts {
        (contact.point, contact.normal) = (turn(contact.point), turn(contact.normal));
    }
    let (plain, turned) = (solved(&plain), solved(&turned));
    assert!(turned.report.factorisations.abs_diff(plain.report.factorisations) <= 3);
    for (a, b) in plain.velocities.iter().zip(&turned.velocities) {
        for (a, b) in both(*a).iter().zip(b) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
    }
}

/// Order of contacts and of bodies: the same motion.
#[test]
fn order_changes_no_motion() {
    let plain = cubes();
    let mut reversed = plain.clone();
    let last = plain.masses.len() - 1;
    reversed.contacts.reverse();
    for contact in &mut reversed.contacts {
        (contact.a, contact.b) = (last - contact.a, contact.b.map(|b| last - b));
    }
    reversed.masses.reverse();
    reversed.sizes.reverse();
    reversed.centres.reverse();
    reversed.velocities.reverse();
    let (plain, reversed) = (solved(&plain), solved(&reversed));
    for (a, b) in plain.velocities.iter().zip(reversed.velocities.iter().rev()) {
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-11), "{a:?} {b:?}");
    }
}

/// A solver that is used again keeps its elimination, and gives the bits of a new one.
#[test]
fn a_solver_that_is_used_again_gives_the_same_bits() {
    let (first, mut other) = (scene(), scene());
    other.velocities[3][1] += 0.2;
    let (settings, mut solver) = (BodySettings::default(), BodySolver::default());
    solver.solve(&first.problem(), None, &settings).unwrap();
    let mut again = solver.solve(&other.problem(), None, &settings).unwrap();
    assert!(again.report.kept_elimination);
    again.report.kept_elimination = false;
    assert_eq!(again, solved(&other));
    let mut smaller = pyramid(3, 0.5);
    smaller.pull(0.0);
    let fresh = solver.solve(&smaller.problem(), None, &settings).unwrap();
    assert_eq!(fresh, solved(&smaller));
}
