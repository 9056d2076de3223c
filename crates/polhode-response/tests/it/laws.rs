//! Laws of blocks: what a constraint hands over together, and the one entry that solves it.

use polhode_response::{
    Ask, Blocks, ComplementaritySolver, ContactProblem, ImpactLaw, ImpactProblem, ImpactSettings, Law, Memory,
    Question, ResponseError, RowProblem, SolverSettings, solve, solve_complementarity,
};

/// A unit mass in space, without rotation.
fn mass_point() -> ContactProblem {
    ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).unwrap()
}

const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[test]
fn a_block_holds_together_or_not_at_all() {
    let rows = AXES.each_ref().map(|axis| [(0, axis.as_slice())]);
    let [x, y, z] = rows.each_ref().map(<[_; 1]>::as_slice);
    let mut problem = mass_point();
    assert_eq!(problem.push_block(Law::Push, &[z]).unwrap(), 0..1);
    assert_eq!(problem.push_block(Law::Hold { rows: 2 }, &[x, y]).unwrap(), 1..3);
    assert_eq!(Blocks::of(&problem).laws(), [Law::Push, Law::Hold { rows: 1 }, Law::Hold { rows: 1 }]);
    let short = [1.0, 0.0];
    let wrong: &[(usize, &[f64])] = &[(0, &short)];
    assert!(problem.push_block(Law::Hold { rows: 2 }, &[x, wrong]).is_err());
    assert_eq!(problem.len(), 3, "no row of a block that is refused");
    let b = [-9.81, 0.3, -0.4];
    let solution = solve_complementarity(&problem, &problem.delassus(), &b, None, &SolverSettings::default()).unwrap();
    assert_eq!(solution.forces, [9.81, -0.3, 0.4]);
    assert_eq!(problem.push_block(Law::Push, &[x, y]), Err(ResponseError::BlockRows { expected: 1, found: 2 }));
}

/// One entry solves blocks with friction and without it: a mass pressed on a floor, under a force along it, slides with
/// what friction leaves, in three dimensions, and a solver without friction refuses the block instead of holding it.
#[test]
fn one_entry_solves_cones_and_contacts_without_friction() {
    let rows = AXES.each_ref().map(|axis| [(0, axis.as_slice())]);
    let [x, y, z] = rows.each_ref().map(<[_; 1]>::as_slice);
    let b = [-10.0, 3.0, 4.0];
    for (friction, share) in [(0.6, 0.0), (0.5, 0.0), (0.2, 0.6), (0.0, 1.0)] {
        let mut problem = mass_point();
        let own = problem.push_block(Law::Cone { rows: 3, friction }, &[z, x, y]).unwrap();
        assert_eq!((own, problem.has_friction()), (0..3, true));
        let mut memory = Memory::default();
        let solution = solve(&RowProblem::new(&problem, &b), Ask::Instant, &mut memory).unwrap();
        for (found, expected) in solution.velocities.iter().zip([0.0, 3.0 * share, 4.0 * share]) {
            assert!((found - expected).abs() < 1e-12, "{friction}: {found} for {expected}");
        }
        let again = solve(&RowProblem::new(&problem, &b), Ask::Instant, &mut memory).unwrap();
        assert_eq!(again, solution, "a memory changes no answer");
        let refused = solve_complementarity(&problem, &problem.delassus(), &b, None, &SolverSettings::default());
        assert_eq!(refused.unwrap_err(), ResponseError::HasFriction { row: 0 });
    }
    let mut smooth = mass_point();
    smooth.push_row(z).unwrap();
    let solution = solve(&RowProblem::new(&smooth, &[-10.0]), Ask::Instant, &mut Memory::default()).unwrap();
    assert_eq!((solution.reactions, solution.velocities), (vec![10.0], vec![0.0]));
}

/// The rounding that the constant terms of one problem carry is not that of the next: a memory changes no answer. A
/// mass that falls a little into a corner is held; with the noise of an earlier problem it would pass for one that
/// rests without a force.
#[test]
fn the_noise_of_one_problem_is_not_that_of_the_next() {
    let rows = AXES.each_ref().map(|axis| [(0, axis.as_slice())]);
    let [x, _, z] = rows.each_ref().map(<[_; 1]>::as_slice);
    let mut smooth = mass_point();
    smooth.push_row(z).unwrap();
    smooth.push_row(x).unwrap();
    let mut memory = Memory::default();
    let known = Question { constants: &[-1e-3, -2e-3], noise_floor: 1.0, ..Question::default() };
    let noisy = RowProblem { rows: &smooth, joints: 0..0, known };
    let unmoved = solve(&noisy, Ask::Displacement { accuracy: 1e-12 }, &mut memory).unwrap();
    assert_eq!(unmoved.reactions, [0.0, 0.0]);
    let exact = RowProblem::new(&smooth, &[-1e-3, -2e-3]);
    let found = solve(&exact, Ask::Instant, &mut memory).unwrap();
    assert_eq!(found, solve(&exact, Ask::Instant, &mut Memory::default()).unwrap());
    assert!(found.reactions.iter().all(|force| *force > 0.0));
}

/// What is no coefficient of friction is refused, and so is a block with another number of rows than its law has.
#[test]
fn a_law_that_makes_no_sense_is_refused() {
    let rows = AXES.each_ref().map(|axis| [(0, axis.as_slice())]);
    let [x, y, z] = rows.each_ref().map(<[_; 1]>::as_slice);
    let mut problem = mass_point();
    for friction in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = problem.push_block(Law::Cone { rows: 3, friction }, &[z, x, y]);
        assert!(matches!(refused, Err(ResponseError::Friction { .. })));
    }
    assert_eq!(
        problem.push_block(Law::Cone { rows: 3, friction: 0.2 }, &[z]).unwrap_err(),
        ResponseError::BlockRows { expected: 3, found: 1 }
    );
    assert!(problem.is_empty() && !problem.has_friction());
}

/// Joints have no restitution of their own, which must not pass for one that differs from the contacts': of two
/// contacts and a joint, an elastic impact keeps its energy by every law, in one round.
#[test]
fn the_restitution_of_joints_is_not_asked_for() {
    // A plank of 1 kg and 1/3 kg m^2 in a plane, held at its left end, strikes supports in the middle and at the right.
    let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0]).unwrap();
    for x in [0.0, 1.0] {
        problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
    }
    problem.push_block(Law::Hold { rows: 2 }, &[&[(0, &[1.0, 0.0, 0.0])], &[(0, &[0.0, 1.0, -1.0])]]).unwrap();
    let u = problem.row_velocities(&[0.0, -1.0, -1.0]).unwrap();
    assert_eq!(u, [-1.0, -2.0, 0.0, 0.0]);
    let mut solver = ComplementaritySolver::default();
    for (law, e) in [ImpactLaw::Simultaneous, ImpactLaw::Reflection].into_iter().flat_map(|l| [(l, 1.0), (l, 0.4)]) {
        let (contacts, delassus, settings) = (&problem, &problem.delassus(), &ImpactSettings::default());
        let impact = ImpactProblem { contacts, delassus, u_before: &u, restitution: &[e, e, 0.0, 0.0], settings };
        let outcome = law.resolve(&impact, &mut solver).unwrap();
        for (after, before) in outcome.velocities_after.iter().zip(&u) {
            assert!((after + e * before).abs() < 1e-14, "{law:?} {outcome:?}");
        }
        assert!(outcome.finishing.is_empty(), "{law:?} {outcome:?}");
        let energy = 0.5 * (1.0 + 1.0 / 3.0);
        assert!((outcome.energy_change + energy * (1.0 - e * e)).abs() < 1e-14, "{law:?} {outcome:?}");
    }
}
