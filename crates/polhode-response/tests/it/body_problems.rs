//! Problems in the velocities of bodies: what is refused, and the simplest answers.

use polhode_response::sparse::{BodyMass, BodyProblem, BodyRows, BodySettings, BodySolution, BodySolver};
use polhode_response::{Law, ResponseError, SolverStatus};

const UNIT_INERTIA: [f64; 9] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
const UP: [f64; 6] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

fn ball() -> BodyMass {
    BodyMass::rigid(2.0, &UNIT_INERTIA)
}

fn push<'a>(bodies: &'a [(usize, &'a [f64])]) -> BodyRows<'a> {
    BodyRows { law: Law::Push, bodies, bias: &[0.0], compliance: &[] }
}

fn solved(problem: &BodyProblem) -> BodySolution {
    BodySolver::default().solve(problem, None, &BodySettings::default()).unwrap()
}

#[test]
fn wrong_bodies_are_refused() {
    let refused = |mass: BodyMass| BodyProblem::new(&[mass], &[[0.0; 6]]).unwrap_err();
    assert_eq!(refused(BodyMass::rigid(0.0, &UNIT_INERTIA)), ResponseError::BodyMass { body: 0 });
    assert_eq!(refused(BodyMass::rigid(-1.0, &UNIT_INERTIA)), ResponseError::BodyMass { body: 0 });
    let lopsided = [1.0, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    assert_eq!(refused(BodyMass::rigid(1.0, &lopsided)), ResponseError::BodyMass { body: 0 });
    assert!(matches!(refused(BodyMass::rigid(f64::NAN, &UNIT_INERTIA)), ResponseError::NotFinite { .. }));
    assert!(matches!(BodyProblem::new(&[ball()], &[]), Err(ResponseError::Length { .. })));
    assert!(matches!(BodyProblem::new(&[ball()], &[[f64::NAN; 6]]), Err(ResponseError::NotFinite { .. })));
}

#[test]
fn wrong_rows_are_refused() {
    let mut problem = BodyProblem::new(&[ball(), BodyMass::FIXED, ball()], &[[0.0; 6]; 3]).unwrap();
    let mut refused = |rows: &BodyRows<'_>| problem.push(rows).unwrap_err();
    assert_eq!(refused(&push(&[])), ResponseError::RowBodies(0));
    assert_eq!(refused(&push(&[(1, &UP)])), ResponseError::RowBodies(0));
    assert_eq!(refused(&push(&[(0, &UP), (1, &UP), (2, &UP)])), ResponseError::RowBodies(2));
    assert_eq!(refused(&push(&[(7, &UP)])), ResponseError::UnknownBody { body: 7, bodies: 3 });
    assert_eq!(refused(&push(&[(0, &UP), (0, &UP)])), ResponseError::RepeatedBody { body: 0 });
    assert!(matches!(refused(&push(&[(0, &UP[..5])])), ResponseError::Length { .. }));
    assert!(matches!(refused(&push(&[(0, &[f64::NAN; 6])])), ResponseError::NotFinite { .. }));
    assert!(matches!(refused(&push(&[(0, &[1e200; 6])])), ResponseError::NotFinite { .. }));
    let bodies: &[(usize, &[f64])] = &[(0, &UP)];
    assert!(matches!(refused(&BodyRows { bias: &[], ..push(bodies) }), ResponseError::Length { .. }));
    assert!(matches!(refused(&BodyRows { bias: &[f64::INFINITY], ..push(bodies) }), ResponseError::NotFinite { .. }));
    assert!(matches!(refused(&BodyRows { compliance: &[-1.0], ..push(bodies) }), ResponseError::Setting { .. }));
    let hold = BodyRows { law: Law::Hold { rows: 7 }, ..push(bodies) };
    assert!(matches!(refused(&hold), ResponseError::FrictionRows { rows: 7, .. }));
    let cone = BodyRows { law: Law::Cone { rows: 1, friction: f64::NAN }, ..push(bodies) };
    assert!(matches!(refused(&cone), ResponseError::Friction { .. }));
    // What is refused leaves nothing behind.
    assert_eq!((problem.len(), problem.rows()), (0, 0));
}

#[test]
fn wrong_starts_and_settings_are_refused() {
    let mut problem = BodyProblem::new(&[ball()], &[[0.0, 0.0, -1.0, 0.0, 0.0, 0.0]]).unwrap();
    problem.push(&push(&[(0, &UP)])).unwrap();
    let (settings, mut solver) = (BodySettings::default(), BodySolver::default());
    assert!(matches!(solver.solve(&problem, Some(&[]), &settings), Err(ResponseError::Length { .. })));
    assert!(matches!(solver.solve(&problem, Some(&[f64::NAN]), &settings), Err(ResponseError::NotFinite { .. })));
    let wrong = BodySettings { tolerance: f64::NAN, ..settings };
    assert!(matches!(solver.solve(&problem, None, &wrong), Err(ResponseError::Setting { .. })));
    // Without a factorisation there is no answer, and that is told.
    let none = BodySettings { factorisations: 0, ..settings };
    assert_eq!(solver.solve(&problem, None, &none).unwrap().report.status, SolverStatus::Inaccurate);
}

#[test]
fn nothing_to_do_is_done_at_once() {
    let problem = BodyProblem::new(&[], &[]).unwrap();
    assert_eq!(solved(&problem).report.status, SolverStatus::Solved);
    let velocity = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let mut problem = BodyProblem::new(&[ball()], &[velocity]).unwrap();
    // It moves away from the ground.
    problem.push(&push(&[(0, &UP)])).unwrap();
    let solution = solved(&problem);
    assert_eq!((solution.report.factorisations, solution.reactions), (0, vec![0.0]));
    assert!(solution.velocities[0].iter().zip(velocity).all(|(a, b)| (a - b).abs() < 1e-15));
}

/// A belt that is told to move carries a box along; a joint of six rows welds two bodies together.
#[test]
fn prescribed_motions_and_welds_are_followed() {
    let free = [[0.0, 0.0, -1.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0; 6]];
    let mut problem = BodyProblem::new(&[ball(), BodyMass::FIXED, ball()], &free).unwrap();
    let mut cone = [0.0; 18];
    (cone[2], cone[6], cone[13]) = (1.0, 1.0, 1.0);
    let opposite = cone.map(|x| -x);
    let law = Law::Cone { rows: 3, friction: 2.0 };
    let bodies: &[(usize, &[f64])] = &[(0, &cone), (1, &opposite)];
    problem.push(&BodyRows { law, bodies, bias: &[0.0; 3], compliance: &[] }).unwrap();
    let mut unit = [0.0; 36];
    for k in 0..6 {
        unit[7 * k] = 1.0;
    }
    let opposite = unit.map(|x: f64| -x);
    let bodies: &[(usize, &[f64])] = &[(0, &unit), (2, &opposite)];
    problem.push(&BodyRows { law: Law::Hold { rows: 6 }, bodies, bias: &[0.0; 6], compliance: &[] }).unwrap();
    let solution = solved(&problem);
    assert!(solution.report.residual <= 1e-12, "{:?}", solution.report);
    for body in [0, 2] {
        let expected = [0.5, 0.0, 0.0, 0.0, 0.0, 0.0];
        let velocity = solution.velocities[body];
        assert!(velocity.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-11), "{velocity:?}");
    }
    assert_eq!(solution.statuses.len(), 2);
}

/// Bodies squeezed between fixed ones: no reactions help, and that is told without panic.
#[test]
fn what_has_no_answer_is_told() {
    let mut problem = BodyProblem::new(&[ball()], &[[0.0; 6]]).unwrap();
    let down = UP.map(|x| -x);
    for jacobian in [&UP, &down] {
        let bodies: &[(usize, &[f64])] = &[(0, jacobian)];
        problem.push(&BodyRows { bias: &[-1.0], ..push(bodies) }).unwrap();
    }
    assert_eq!(solved(&problem).report.status, SolverStatus::Inaccurate);
}

/// Numbers near the ends of the range: an answer or its absence, never a panic.
#[test]
fn extreme_numbers_end_without_panic() {
    for size in [1e-150, 1e-30, 1e30, 1e150] {
        let Ok(mut problem) =
            BodyProblem::new(&[BodyMass::rigid(size, &UNIT_INERTIA)], &[[0.0, 0.0, -size, 0.0, 0.0, 0.0]])
        else {
            continue;
        };
        if problem.push(&push(&[(0, &UP)])).is_ok() {
            solved(&problem);
        }
    }
}
