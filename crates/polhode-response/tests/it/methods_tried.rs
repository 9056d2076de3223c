//! Reports name the method that answered, and all that were tried before it.

use polhode_response::friction::{FrictionMethod, FrictionProblem, FrictionSettings, solve_friction};
use polhode_response::sparse::{BodyMass, BodyMethod, BodyProblem, BodyRows, BodySettings, BodySolver};
use polhode_response::{
    ContactProblem, Law, Method, MethodSet, SolverSettings, SolverStatus, WarmStart, solve_complementarity,
};

/// A point of 2 kg on a floor of friction 0.5 that comes down with 3 m/s and along with 4 m/s.
fn sliding_point() -> FrictionProblem {
    let matrix = [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5];
    let contact = Law::Cone { rows: 3, friction: 0.5 };
    FrictionProblem::from_dense(vec![contact], &matrix, vec![-3.0, 4.0, 0.0]).unwrap()
}

#[test]
fn a_single_contact_is_tried_from_its_start_and_answered_by_a_sweep() {
    let (problem, settings) = (sliding_point(), FrictionSettings::default());
    let cold = solve_friction(&problem, None, &settings).unwrap().report;
    assert_eq!((cold.method, cold.tried.to_string().as_str()), (FrictionMethod::GaussSeidel, "gauss-seidel"));
    let warm = solve_friction(&problem, Some(&[1.0, 0.0, 0.0]), &settings).unwrap().report;
    let expected = [FrictionMethod::WarmNewton, FrictionMethod::GaussSeidel].into_iter().collect();
    assert_eq!((warm.method, warm.tried), (FrictionMethod::GaussSeidel, expected));
}

/// Two pads squeeze a block from both sides by more than they can yield: no reactions keep both from approaching.
#[test]
fn a_squeeze_is_found_after_all_that_comes_before_the_cone_programme() {
    let pad = Law::Cone { rows: 2, friction: 0.5 };
    let matrix = [1.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
    let problem = FrictionProblem::from_dense(vec![pad, pad], &matrix, vec![-1.0, 0.1, -1.0, 0.1]).unwrap();
    let report = solve_friction(&problem, None, &FrictionSettings::default()).unwrap().report;
    assert_eq!(report.status, SolverStatus::Infeasible);
    let before = [
        FrictionMethod::GaussSeidel,
        FrictionMethod::Newton,
        FrictionMethod::NewtonFromZero,
        FrictionMethod::LeastNormFromZero,
        FrictionMethod::YieldingNewton,
        FrictionMethod::ConeProgrammeNewton,
    ];
    assert_eq!(report.tried, before.into_iter().collect());
}

#[test]
fn bodies_tell_the_stage_that_answered_and_those_before_it() {
    let stiff = [1e12, 0.0, 0.0, 0.0, 1e12, 0.0, 0.0, 0.0, 1e12];
    let ball = BodyMass::rigid(2.0, &stiff);
    let mut problem = BodyProblem::new(&[ball], &[[4.0, 0.0, -3.0, 0.0, 0.0, 0.0]]).unwrap();
    let mut jacobian = [0.0; 18];
    (jacobian[2], jacobian[6], jacobian[13]) = (1.0, 1.0, 1.0);
    let law = Law::Cone { rows: 3, friction: 0.5 };
    problem.push(&BodyRows { law, bodies: &[(0, &jacobian)], bias: &[0.0; 3], compliance: &[] }).unwrap();
    let mut solver = BodySolver::default();
    let cold = solver.solve(&problem, None, &BodySettings::default()).unwrap();
    assert_eq!(cold.report.stage, BodyMethod::InteriorPoint);
    assert!(cold.report.tried.contains(BodyMethod::InteriorPoint) && !cold.report.tried.contains(BodyMethod::Warm));
    let start = [5.5, -2.7, 0.0];
    let warm = solver.solve(&problem, Some(&start), &BodySettings::default()).unwrap();
    assert_eq!((warm.report.stage, warm.report.tried.to_string().as_str()), (BodyMethod::Warm, "warm-newton"));
    let known = solver.solve(&problem, Some(&warm.reactions), &BodySettings::default()).unwrap();
    assert_eq!(known.report.stage, BodyMethod::Start);
}

#[test]
fn an_active_set_tells_whether_the_warm_start_was_all() {
    let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0]).unwrap();
    for x in [-1.0, 0.5, 1.0] {
        problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
    }
    let (delassus, settings) = (problem.delassus(), SolverSettings::default());
    let solve = |warm: Option<&WarmStart>| solve_complementarity(&problem, &delassus, &[-9.81; 3], warm, &settings);
    let cold = solve(None).unwrap();
    assert_eq!((cold.report.method, cold.report.tried.to_string().as_str()), (Method::ActiveSet, "active-set"));
    let warm = solve(Some(&cold.warm_start)).unwrap();
    assert_eq!((warm.report.method, warm.report.tried.to_string().as_str()), (Method::WarmStart, "warm-start"));
    let alone = ContactProblem::new(1, vec![1.0]).unwrap();
    let none = solve_complementarity(&alone, &alone.delassus(), &[], None, &settings).unwrap();
    assert_eq!(none.report.tried, MethodSet::from_iter([Method::ClosedForm]));
}
