//! Contacts with friction: Coulomb's law holds to rounding whatever the problem, and a problem without a solution is
//! said to have none. Judged by the law itself, written here afresh: open, stick or slide, each with its inequalities.

use polhode_response::Law;
use polhode_response::SolverStatus;
use polhode_response::friction::{
    BlockMatrix, ContactStatus, FrictionProblem, FrictionSettings, FrictionSolution, solve_friction,
};
use proptest::prelude::*;

/// Numbers between -1 and 1 from a seed.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.next())
    }
}

fn contact(rows: usize, friction: f64) -> Law {
    Law::Cone { rows, friction }
}

fn solve(problem: &FrictionProblem) -> FrictionSolution {
    solve_friction(problem, None, &FrictionSettings::default()).unwrap()
}

/// Largest violation of Signorini's and Coulomb's law, in units of velocity, relative to the largest constant.
fn violation(problem: &FrictionProblem, reactions: &[f64]) -> f64 {
    let u = problem.velocities(reactions).unwrap();
    let size = problem.constant().iter().fold(0.0, |most: f64, q| most.max(q.abs()));
    let length = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let mut worst: f64 = 0.0;
    for (block, kind) in problem.blocks().iter().enumerate() {
        let (r, u) = (&reactions[problem.range(block)], &u[problem.range(block)]);
        worst = worst.max(match *kind {
            Law::Hold { .. } => length(u),
            Law::Slide { friction } => {
                assert!((r[1] + friction * r[0]).abs() <= 1e-12 * size, "{r:?}");
                if r[0] == 0.0 { (-u[0]).max(0.0) } else { u[0].abs() }
            }
            Law::Push | Law::Cone { .. } => {
                let friction = kind.friction().unwrap_or(0.0);
                assert!(length(&r[1..]) <= friction * r[0] * (1.0 + 1e-9) + 1e-12 * size, "{r:?}");
                if length(r) == 0.0 {
                    (-u[0]).max(0.0)
                } else {
                    // In contact: no normal velocity, and either no slip or the full friction against it.
                    let limit = friction * r[0];
                    let along: f64 = r[1..].iter().zip(&u[1..]).map(|(r, u)| r * u).sum();
                    let against = if limit > 0.0 { length(&u[1..]) + along / limit } else { 0.0 };
                    u[0].abs().max(against.abs())
                }
            }
            _ => unreachable!("`resisted_rotations` judges these"),
        });
    }
    worst / size
}

/// Bodies with random contacts, each between one body and the next (a chain) or any other or the ground; `ratio` is the
/// largest mass over the smallest. Velocities without reactions are those of bodies, so that a solution exists.
fn random_problem(
    seed: u64,
    bodies: usize,
    per_body: usize,
    dimension: usize,
    ratio: f64,
    friction: f64,
) -> FrictionProblem {
    let mut numbers = Numbers(seed);
    let width = if dimension == 3 { 6 } else { 3 };
    let inverse: Vec<f64> = (0..bodies).map(|body| ratio.powf(-((body % 3) as f64) / 2.0)).collect();
    let velocities: Vec<Vec<f64>> = (0..bodies).map(|_| numbers.vector::<6>()[..width].to_vec()).collect();
    let mut rows: Vec<[(usize, Vec<Vec<f64>>); 2]> = Vec::new();
    for body in 0..bodies {
        for k in 0..per_body {
            let other = if k % 2 == 0 { body + 1 } else { ((numbers.next() + 1.0) * 0.5 * bodies as f64) as usize };
            let other = if other == body { bodies } else { other };
            // Axes of the contact: random, orthogonal; two arms.
            let axes = axes(&mut numbers, dimension);
            let jacobian = |arm: [f64; 3], sign: f64| {
                let row = |n: &[f64; 3]| {
                    let spin =
                        [arm[1] * n[2] - arm[2] * n[1], arm[2] * n[0] - arm[0] * n[2], arm[0] * n[1] - arm[1] * n[0]];
                    let full = if dimension == 3 {
                        vec![n[0], n[1], n[2], spin[0], spin[1], spin[2]]
                    } else {
                        vec![n[0], n[1], spin[2]]
                    };
                    full.into_iter().map(|x| sign * x).collect::<Vec<f64>>()
                };
                axes.iter().map(row).collect::<Vec<_>>()
            };
            let mut arms = [numbers.vector::<3>(), numbers.vector::<3>()];
            if dimension == 2 {
                for arm in &mut arms {
                    arm[2] = 0.0;
                }
            }
            rows.push([(body, jacobian(arms[0], 1.0)), (other, jacobian(arms[1], -1.0))]);
        }
    }
    let mut blocks = Vec::new();
    let mut constant = vec![0.0; rows.len() * dimension];
    for (i, a) in rows.iter().enumerate() {
        for (body, jacobian) in a.iter().filter(|(body, _)| *body < bodies) {
            for (k, row) in jacobian.iter().enumerate() {
                constant[i * dimension + k] += row.iter().zip(&velocities[*body]).map(|(j, v)| j * v).sum::<f64>();
            }
        }
        for (j, b) in rows.iter().enumerate() {
            let mut block = vec![0.0; dimension * dimension];
            for (body, left) in a {
                for (_, right) in b.iter().filter(|(other, _)| other == body && *body < bodies) {
                    for (at, value) in block.iter_mut().enumerate() {
                        let (l, r) = (&left[at / dimension], &right[at % dimension]);
                        *value += inverse[*body] * l.iter().zip(r).map(|(a, b)| a * b).sum::<f64>();
                    }
                }
            }
            if block.iter().any(|value| *value != 0.0) {
                blocks.push((i, j, block));
            }
        }
    }
    let kinds: Vec<Law> =
        (0..rows.len()).map(|k| contact(dimension, friction * f64::from(u8::from(k % 5 != 4)))).collect();
    let matrix = BlockMatrix::from_blocks(&vec![dimension; rows.len()], blocks).unwrap();
    FrictionProblem::new(kinds, matrix, constant).unwrap()
}

/// Orthonormal axes, `dimension` of them, in the plane of the first two coordinates for a plane problem.
fn axes(numbers: &mut Numbers, dimension: usize) -> Vec<[f64; 3]> {
    let mut axes: Vec<[f64; 3]> = Vec::new();
    while axes.len() < dimension {
        let mut v = numbers.vector::<3>();
        if dimension == 2 {
            v[2] = 0.0;
        }
        for axis in &axes {
            let inner: f64 = axis.iter().zip(&v).map(|(a, b)| a * b).sum();
            v.iter_mut().zip(axis).for_each(|(v, a)| *v -= inner * a);
        }
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length > 0.1 {
            axes.push(v.map(|x| x / length));
        }
    }
    axes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Chains and piles, in space and in a plane, of equal masses or up to 1 : 1e6, redundant or not, mu from 0 to 10.
    /// Solved always up to mass ratios of 10 and mu of 1; beyond, what is said to be solved is.
    #[test]
    fn coulombs_law_holds_to_rounding(
        seed in 0_u64..1_000_000, bodies in 1_usize..16, per_body in 1_usize..5, dimension in 2_usize..4,
        exponent in 0_i32..7, friction in prop_oneof![Just(0.0), 0.0_f64..1.0, 1.0_f64..10.0],
    ) {
        let problem = random_problem(seed, bodies, per_body, dimension, 10_f64.powi(exponent), friction);
        let solution = solve(&problem);
        // Bodies wedged at random at large mass ratios and coefficients: not always solved, and then never said to be.
        if friction <= 1.0 && exponent <= 1 {
            prop_assert_eq!(solution.report.status, SolverStatus::Solved, "{:?}", solution.report);
        }
        if solution.report.status == SolverStatus::Solved {
            let bound = 1e-8_f64.max(100.0 * solution.report.residual);
            let found = violation(&problem, &solution.reactions);
            prop_assert!(found <= bound, "{found:e} {:?}", solution.report);
        }
    }

    /// The same problem in other units of mass and velocity has the same residual, and its reactions are scaled alike.
    #[test]
    fn units_do_not_matter(seed in 0_u64..1_000_000, mass in -20_i32..20, velocity in -20_i32..20) {
        let problem = random_problem(seed, 4, 2, 3, 1.0, 0.5);
        let (m, v) = (2_f64.powi(mass), 2_f64.powi(velocity));
        let sizes = vec![3; problem.len()];
        let mut dense = vec![0.0; problem.rows() * problem.rows()];
        let mut unit = vec![0.0; problem.rows()];
        for column in 0..problem.rows() {
            unit[column] = 1.0;
            for (row, (u, q)) in problem.velocities(&unit).unwrap().iter().zip(problem.constant()).enumerate() {
                dense[row * problem.rows() + column] = u - q;
            }
            unit[column] = 0.0;
        }
        let (blocks, constant) = (problem.blocks().to_vec(), problem.constant().to_vec());
        let matrix = BlockMatrix::from_dense(&sizes, &dense).unwrap();
        let first = FrictionProblem::new(blocks, matrix, constant).unwrap();
        for g in &mut dense {
            *g /= m;
        }
        let constant = problem.constant().iter().map(|q| q * v).collect();
        let second = FrictionProblem::from_dense(problem.blocks().to_vec(), &dense, constant).unwrap();
        let (first, second) = (solve(&first), solve(&second));
        prop_assert_eq!(first.report.residual, second.report.residual);
        for (a, b) in first.reactions.iter().zip(&second.reactions) {
            prop_assert_eq!(a * m * v, *b);
        }
    }
}

#[test]
fn a_point_opens_sticks_and_slides() {
    let matrix = [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5];
    let result = |q: [f64; 3]| {
        let solution = solve(&FrictionProblem::from_dense(vec![contact(3, 0.5)], &matrix, q.to_vec()).unwrap());
        (solution.reactions, solution.statuses[0])
    };
    assert_eq!(result([1.0, 2.0, 3.0]), (vec![0.0; 3], ContactStatus::Open));
    assert_eq!(result([-3.0, 1.0, 0.0]), (vec![6.0, -2.0, 0.0], ContactStatus::Stick));
    assert_eq!(result([-3.0, 0.0, -4.0]), (vec![6.0, 0.0, 3.0], ContactStatus::Slide));
}

/// A contact that slides does not lift off, as it would by the associated law (a cone programme without De Saxce's
/// correction).
#[test]
fn sliding_does_not_lift() {
    let matrix = [1.0, 0.2, 0.1, 0.2, 1.5, 0.0, 0.1, 0.0, 1.2];
    let problem = FrictionProblem::from_dense(vec![contact(3, 0.3)], &matrix, vec![-1.0, 3.0, 2.0]).unwrap();
    let solution = solve(&problem);
    assert!(solution.velocities[0].abs() < 1e-15 && solution.velocities[1] > 1.0, "{solution:?}");
}

/// A ball of unit mass pressed into a corner whose wall is held by a joint row and whose floor has friction: the
/// joint's reaction has either sign, and its velocity is zero.
#[test]
fn held_rows_take_reactions_of_either_sign() {
    let matrix = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    for side in [1.0, -1.0] {
        let blocks = vec![contact(2, 0.5), Law::Hold { rows: 1 }];
        let problem = FrictionProblem::from_dense(blocks, &matrix, vec![-1.0, 0.0, side]).unwrap();
        assert_eq!(solve(&problem).reactions, [1.0, 0.0, -side]);
    }
    // Tangents that stick beside a normal that only pushes.
    let blocks = vec![contact(1, 0.0), Law::Hold { rows: 2 }];
    let problem = FrictionProblem::from_dense(blocks, &matrix, vec![-1.0, 2.0, -3.0]).unwrap();
    assert_eq!(solve(&problem).reactions, [1.0, -2.0, 3.0]);
}

/// Two walls that close on a body from both sides leave it nowhere to go: no solution, and the reactions that prove it.
#[test]
fn a_squeezed_body_is_proven_to_have_no_solution() {
    // Normal and tangent of each wall; the body is free along the tangent, turned the other way round on the other
    // side.
    let matrix = [1.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
    let problem = FrictionProblem::from_dense(vec![contact(2, 0.5); 2], &matrix, vec![-1.0, 0.3, -1.0, 0.3]).unwrap();
    let solution = solve(&problem);
    assert_eq!(solution.report.status, SolverStatus::Infeasible);
    for (z, expected) in solution.squeeze.iter().zip([1.0, 0.0, 1.0, 0.0]) {
        assert!((z - expected).abs() < 1e-9, "{:?}", solution.squeeze);
    }
}

/// The reactions of a solution are a start from which nothing is left to do, and any start gives a solution.
#[test]
fn a_solution_is_its_own_start() {
    let problem = random_problem(7, 8, 4, 3, 1e3, 0.6);
    let first = solve(&problem);
    let again = solve_friction(&problem, Some(&first.reactions), &FrictionSettings::default()).unwrap();
    assert_eq!((again.report.newton_steps, &again.reactions), (0, &first.reactions));
    let far: Vec<f64> = first.reactions.iter().map(|r| 1e3 - r).collect();
    let other = solve_friction(&problem, Some(&far), &FrictionSettings::default()).unwrap();
    assert_eq!(other.report.status, SolverStatus::Solved);
    assert_eq!(solve(&problem), first, "the same bits every time");
}

#[test]
fn wrong_problems_are_refused() {
    let build = |kinds: Vec<Law>, matrix: &[f64], q: &[f64]| {
        FrictionProblem::from_dense(kinds, matrix, q.to_vec()).unwrap_err().to_string()
    };
    let one = |friction| vec![contact(1, friction)];
    assert!(build(one(-0.1), &[1.0], &[0.0]).contains("contact 0 must be at least 0"));
    assert!(build(one(f64::NAN), &[1.0], &[0.0]).contains("finite"));
    assert!(build(vec![contact(4, 0.0)], &[1.0; 16], &[0.0; 4]).contains("1 to 3"));
    assert!(build(one(0.0), &[f64::INFINITY], &[0.0]).contains("not finite"));
    assert!(build(one(0.0), &[1.0], &[f64::NAN]).contains("not finite"));
    assert!(build(one(0.0), &[-1.0], &[0.0]).contains("semidefinite"));
    assert!(build(vec![contact(2, 0.0)], &[1.0, 0.5, -0.5, 1.0], &[0.0; 2]).contains("symmetric"));
    assert!(build(one(0.0), &[1.0], &[0.0; 2]).contains("expected 1"));
    assert!(FrictionProblem::from_dense(vec![], &[], vec![]).is_ok_and(|problem| solve(&problem).reactions.is_empty()));
}
