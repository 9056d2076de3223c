//! Row blocks: what a constraint hands over together.

use polhode_response::{
    ComplementaritySolver, ContactProblem, ImpactLaw, ImpactProblem, ImpactSettings, ResponseError, RowBlock, RowKind,
    SolverSettings, solve_complementarity,
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
    assert_eq!(problem.push_block(RowBlock::Unilateral, &[z]).unwrap(), 0..1);
    assert_eq!(problem.push_block(RowBlock::Bilateral, &[x, y]).unwrap(), 1..3);
    assert_eq!(
        [0, 1, 2].map(|row| problem.kind(row).unwrap()),
        [RowKind::Unilateral, RowKind::Bilateral, RowKind::Bilateral]
    );
    let short = [1.0, 0.0];
    let wrong: &[(usize, &[f64])] = &[(0, &short)];
    assert!(problem.push_block(RowBlock::Bilateral, &[x, wrong]).is_err());
    assert_eq!(problem.len(), 3, "no row of a block that is refused");
    let b = [-9.81, 0.3, -0.4];
    let solution = solve_complementarity(&problem, &problem.delassus(), &b, None, &SolverSettings::default()).unwrap();
    assert_eq!(solution.forces, [9.81, -0.3, 0.4]);
    assert_eq!(
        problem.push_block(RowBlock::Unilateral, &[x, y]),
        Err(ResponseError::BlockRows { expected: 1, found: 2 })
    );
}

/// A cone without friction is its normal row; one with friction is refused, and so is what is no friction.
#[test]
fn a_cone_is_solved_without_friction_and_refused_with_it() {
    let rows = AXES.each_ref().map(|axis| [(0, axis.as_slice())]);
    let [x, y, z] = rows.each_ref().map(<[_; 1]>::as_slice);
    let mut problem = mass_point();
    assert_eq!(problem.push_block(RowBlock::Cone { friction: 0.0 }, &[z, x, y]).unwrap(), 0..1);
    assert_eq!(problem.kind(0), Some(RowKind::Unilateral));
    let refused = problem.push_block(RowBlock::Cone { friction: 0.3 }, &[z, x, y]).unwrap_err();
    assert_eq!(refused, ResponseError::FrictionNotAvailable { friction: 0.3 });
    assert!(refused.to_string().contains("not yet available"));
    for friction in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = problem.push_block(RowBlock::Cone { friction }, &[z, x, y]);
        assert!(matches!(refused, Err(ResponseError::Setting { field: "friction", .. })));
    }
    assert_eq!(
        problem.push_block(RowBlock::Cone { friction: 0.0 }, &[z]).unwrap_err(),
        ResponseError::BlockRows { expected: 3, found: 1 }
    );
    assert_eq!(problem.len(), 1);
}

/// Joints have no restitution of their own, which must not pass for one that differs from the contacts': of two contacts and a
/// joint, an elastic impact keeps its energy by every law, in one round.
#[test]
fn the_restitution_of_joints_is_not_asked_for() {
    // A plank of 1 kg and 1/3 kg m^2 in a plane, held at its left end, strikes supports in the middle and at the right.
    let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0]).unwrap();
    for x in [0.0, 1.0] {
        problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
    }
    problem.push_block(RowBlock::Bilateral, &[&[(0, &[1.0, 0.0, 0.0])], &[(0, &[0.0, 1.0, -1.0])]]).unwrap();
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
