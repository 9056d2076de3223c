//! Methods of each chain, and problems of runs (fixtures/problems) that no other method solves, or that take others
//! more than twice as many steps. Not among them are starts, closed forms and refinement, which save work or digits,
//! and steps of least norm, which choose among reactions. `cargo xtask census` counts the same (docs/census.md).

use crate::problem_set::{Kept, all};
use polhode_response::friction::{FrictionMethod, FrictionSettings, solve_friction};
use polhode_response::sparse::{BodyMethod, BodySettings, BodySolver};
use polhode_response::{ChainMethod, Method, MethodSet, SolverSettings, SolverStatus, solve_complementarity};

/// Convex programmes with corrections, as many as forces of an instant are sought by.
const CORRECTIONS: u32 = 20;

/// What a chain says with all its methods, or without one: whether it is solved, and at which cost.
type Found = (bool, usize);

/// The problem of a name.
fn named<'a>(all: &'a [Kept], name: &str) -> &'a Kept {
    all.iter().find(|kept| kept.name() == name).unwrap_or_else(|| panic!("no problem is named {name}"))
}

fn by_rows(kept: &Kept, is_from_zero: bool, left_out: MethodSet<FrictionMethod>) -> Found {
    let (rows, blocks, constants) = kept.problem.problem().unwrap();
    let problem = blocks.problem(&rows.delassus(), &constants).unwrap();
    let zero = vec![0.0; problem.rows()];
    let settings = FrictionSettings { corrections: CORRECTIONS, left_out, ..FrictionSettings::default() };
    let report = solve_friction(&problem, is_from_zero.then_some(&zero), &settings).unwrap().report;
    (report.status == SolverStatus::Solved, report.iterations())
}

fn by_bodies(kept: &Kept, sweeps_first: bool, left_out: MethodSet<BodyMethod>) -> Found {
    let (rows, blocks, constants) = kept.problem.problem().unwrap();
    let settings = BodySettings { sweeps_first, left_out, ..BodySettings::default() };
    let system = (&mut BodySolver::default(), &settings);
    // Bodies that some force cannot move are refused.
    let Ok((_, report)) = blocks.solve_in_bodies(&rows, &constants, None, system) else { return (false, 0) };
    (report.status == SolverStatus::Solved, report.factorisations)
}

fn by_active_set(kept: &Kept, left_out: MethodSet<Method>) -> Found {
    let (rows, _, constants) = kept.problem.problem().unwrap();
    let settings = SolverSettings { left_out, ..SolverSettings::default() };
    let report = solve_complementarity(&rows, &rows.delassus(), &constants, None, &settings).unwrap().report;
    (report.status == SolverStatus::Solved, report.iterations)
}

/// One problem for each method: it is solved by the chain, and not without the method.
#[test]
fn each_method_answers_what_no_other_does() {
    let all = all();
    let check = |method: &str, name: &str, found: &dyn Fn(&Kept, bool) -> Found| {
        let kept = named(&all, name);
        let [with, without] = [true, false].map(|is_whole| found(kept, is_whole).0);
        assert!(with && !without, "{method}, {name}: solved with it {with}, without {without}");
    };
    let cases = [
        (FrictionMethod::WarmNewton, true, "step-gauss-seidel-newton-87884f5"),
        (FrictionMethod::NewtonFromZero, false, "step-compliance-path-5f708ae"),
        (FrictionMethod::LeastNormFromZero, true, "instant-least-norm-from-zero-b229cb6"),
        (FrictionMethod::YieldingNewton, true, "impact-yielding-newton-18f6754"),
        (FrictionMethod::ConeProgrammeNewton, true, "impact-cone-programme-newton-be60bbd"),
        (FrictionMethod::GaussSeidelNewton, true, "impact-gauss-seidel-newton-f86c27e"),
    ];
    for (method, is_from_zero, name) in cases {
        let found = |kept: &Kept, is_whole| by_rows(kept, is_from_zero, left_out(method, is_whole));
        check(method.name(), name, &found);
    }
    let cases = [
        (BodyMethod::Sweeps, true, "impact-gauss-seidel-newton-c8faacb"),
        (BodyMethod::InteriorPoint, false, "impact-least-norm-from-zero-b4abc2c"),
        (BodyMethod::Compliance, false, "step-compliance-path-5f9d881"),
        (BodyMethod::Smoothing, false, "impact-cone-programme-newton-7162cbc"),
        (BodyMethod::FarCompliance, false, "step-far-compliance-path-c772b1b"),
        (BodyMethod::LastNewton, false, "step-last-newton-02fd75a"),
    ];
    for (method, sweeps_first, name) in cases {
        check(method.name(), name, &|kept, is_whole| by_bodies(kept, sweeps_first, left_out(method, is_whole)));
    }
    let cases = [
        (Method::ActiveSet, "displacement-active-set-eb0cf6e"),
        (Method::PreciseActiveSet, "displacement-precise-active-set-76f8402"),
        (Method::RoundingAsNoise, "instant-rounding-as-noise-be1aa68"),
    ];
    for (method, name) in cases {
        check(method.name(), name, &|kept, is_whole| by_active_set(kept, left_out(method, is_whole)));
    }
}

/// Methods whose problems others solve as well, later: some take more than twice as many steps without them.
#[test]
fn other_methods_answer_sooner_than_those_after_them() {
    let all = all();
    let most = |is_asked: &dyn Fn(&Kept) -> bool, found: &dyn Fn(&Kept, bool) -> Found| {
        let ratio = |kept: &Kept| {
            let [with, without] = [true, false].map(|is_whole| found(kept, is_whole));
            if with.0 && without.0 && with.1 > 0 { without.1 as f64 / with.1 as f64 } else { 0.0 }
        };
        all.iter().filter(|kept| is_asked(kept)).map(ratio).fold(0.0, f64::max)
    };
    let has_friction = |kept: &Kept| !kept.fact("kind").ends_with("frictionless");
    for method in [FrictionMethod::GaussSeidel, FrictionMethod::Newton] {
        let ratio = most(&has_friction, &|kept, is_whole| by_rows(kept, false, left_out(method, is_whole)));
        assert!(ratio > 2.0, "{}: {ratio}", method.name());
    }
    let method = BodyMethod::Lagrangian;
    let ratio = most(&|kept| !has_friction(kept), &|kept, is_whole| by_bodies(kept, false, left_out(method, is_whole)));
    assert!(ratio > 2.0, "{}: {ratio}", method.name());
}

/// No method, or this one.
fn left_out<M: ChainMethod>(method: M, is_none: bool) -> MethodSet<M> {
    if is_none { MethodSet::NONE } else { [method].into_iter().collect() }
}
