//! Small degenerate problems: rows that repeat, oppose, vanish or depend on each other, at any mass ratio.
//!
//! The rows are whole numbers, so a certificate of infeasibility is checked exactly: the rows of the squeeze have one
//! relation, found by elimination without rounding, and it must be positive and outweighed by the constant terms.

use crate::cases::few;
use crate::forces::solve;
use crate::scenes::{Row, Scene};
use polhode_response::{ContactSolution, SolverStatus};
use proptest::prelude::*;

/// Constant terms are whole multiples of this.
const UNIT: f64 = 1e-9;

/// A problem of bodies with three components.
#[derive(Debug, Clone)]
pub(crate) struct Small {
    /// Masses of all components, body by body.
    masses: Vec<f64>,
    /// Rows over all components; at most two bodies each.
    rows: Vec<Vec<i8>>,
    /// Constant terms in units of [`UNIT`].
    constants: Vec<i64>,
}

impl Small {
    pub(crate) fn scene(&self) -> Scene {
        let split = |row: &Vec<i8>| -> Row {
            let blocks = row.chunks_exact(3).map(|block| block.iter().map(|&value| f64::from(value)).collect());
            let mut row: Row = blocks.enumerate().collect();
            if row.len() > 1 {
                row.retain(|(_, block): &(usize, Vec<f64>)| block.iter().any(|value| *value != 0.0));
            }
            if row.is_empty() { vec![(0, vec![0.0; 3])] } else { row }
        };
        let rows: Vec<Row> = self.rows.iter().map(split).collect();
        let diagonals: Vec<Vec<f64>> = self.masses.chunks_exact(3).map(<[f64]>::to_vec).collect();
        let mut scene = Scene::new(3, &diagonals, &rows, &[0.0; 3]);
        scene.b = self.constants.iter().map(|&constant| constant as f64 * UNIT).collect();
        scene
    }

    /// Solves the problem and checks the verdict.
    fn check(&self) -> Result<(), TestCaseError> {
        let scene = self.scene();
        let solution = solve(&scene);
        let label = format!("{self:?}\n{:?}\n{:?}", solution.report, solution.forces);
        match solution.report.status {
            SolverStatus::Solved => self.check_solved(&scene, &solution, &label),
            SolverStatus::Infeasible => self.check_squeeze(&solution.squeeze, &label),
            SolverStatus::Inaccurate => Err(TestCaseError::fail(label)),
        }
    }

    /// The law of contact holds to 1e-12 of the terms that make up a row, and a row approaches by no more than 1e-10 of
    /// what is left of them after they have cancelled: forces that go off along a ray would hide it behind their size.
    ///
    /// The terms are `sqrt(G_ii G_kk) f_k`, not `|G_ik| f_k`: an entry of `G` is a sum too, and between rows of heavy
    /// bodies that happen to be orthogonal the rounding of its terms is all that there is.
    fn check_solved(&self, scene: &Scene, solution: &ContactSolution, label: &str) -> Result<(), TestCaseError> {
        let (forces, delassus) = (&solution.forces, scene.problem.delassus());
        prop_assert!(forces.iter().all(|force| *force >= 0.0), "{label}");
        prop_assert!(solution.report.residual <= 1e-12, "{label}");
        let motion = scene.problem.response(forces).unwrap();
        let root = |row: usize| delassus.get(row, row).sqrt();
        let terms: f64 = (0..forces.len()).map(|k| root(k) * forces[k]).sum();
        let largest = scene.b.iter().fold(0.0, |most: f64, b| most.max(b.abs()));
        for (line, (row, b)) in self.rows.iter().zip(&scene.b).enumerate() {
            let products = row.iter().zip(&motion).map(|(j, a)| f64::from(*j) * a);
            let w = products.clone().sum::<f64>() + b;
            let law = w.min(root(line) * root(line) * forces[line]).abs();
            let scale = b.abs() + root(line) * terms;
            prop_assert!(law <= 1e-12 * scale, "{label}: {law:e} of {scale:e}");
            let left = products.map(f64::abs).sum::<f64>() + largest;
            prop_assert!(w >= -1e-10 * left - 1e-12 * scale, "{label}: {w:e} of {left:e} and {scale:e}");
        }
        Ok(())
    }

    /// The relation of the rows of the squeeze, exactly.
    fn check_squeeze(&self, squeeze: &[f64], label: &str) -> Result<(), TestCaseError> {
        prop_assert_eq!(squeeze.len(), self.rows.len());
        let support: Vec<usize> = (0..squeeze.len()).filter(|&row| squeeze[row] != 0.0).collect();
        let relation = relation(&support.iter().map(|&row| &self.rows[row][..]).collect::<Vec<_>>());
        let Some(relation) = relation else { return Err(TestCaseError::fail(format!("{label}: {squeeze:?}"))) };
        prop_assert!(relation.iter().all(|&value| value > 0), "{label}: {relation:?}");
        let balance: i128 =
            support.iter().zip(&relation).map(|(&row, &value)| i128::from(self.constants[row]) * value).sum();
        prop_assert!(balance < 0, "{label}: {relation:?}");
        let largest = relation.iter().fold(0.0, |most: f64, &value| most.max(value as f64));
        for (&row, &value) in support.iter().zip(&relation) {
            prop_assert!((squeeze[row] - value as f64 / largest).abs() < 1e-14, "{label}: {squeeze:?} {relation:?}");
        }
        Ok(())
    }
}

/// The one relation `sum z_i r_i = 0` between rows, with its last number positive; `None` when there is none or more
/// than one. Elimination without fractions (Bareiss): every number is a minor of the rows.
fn relation(rows: &[&[i8]]) -> Option<Vec<i128>> {
    let (count, width) = (rows.len(), rows.first()?.len());
    // Row k carries its combination of the rows behind its entries.
    let mut work: Vec<Vec<i128>> = (0..count)
        .map(|k| {
            let unit = (0..count).map(|i| i128::from(i == k));
            rows[k].iter().map(|&value| i128::from(value)).chain(unit).collect()
        })
        .collect();
    let (mut done, mut last) = (0, 1);
    for column in 0..width {
        let Some(pivot) = (done..count).find(|&k| work[k][column] != 0) else { continue };
        work.swap(done, pivot);
        for k in done + 1..count {
            for entry in (0..width + count).rev().filter(|&entry| entry != column) {
                work[k][entry] = (work[done][column] * work[k][entry] - work[k][column] * work[done][entry]) / last;
            }
            work[k][column] = 0;
        }
        last = work[done][column];
        done += 1;
    }
    let mut relation = (done + 1 == count).then(|| work[done][width..].to_vec())?;
    if relation.iter().any(|&value| value < 0) {
        for value in &mut relation {
            *value = -*value;
        }
    }
    Some(relation)
}

/// How a row comes about.
#[derive(Debug, Clone)]
enum Recipe {
    /// Numbers of one or two bodies.
    Fresh(usize, usize, [i8; 6]),
    /// A multiple of a row before it.
    Again(usize, i8),
    /// The sum of two rows before it, of the same bodies or of one.
    Zero,
}

/// Up to three bodies of the given sizes and 14 rows.
pub(crate) fn small(sizes: Vec<f64>) -> impl Strategy<Value = Small> {
    let recipe = prop_oneof![
        6 => (0_usize..3, 0_usize..3, prop::array::uniform6(-3_i8..=3)).prop_map(|(a, b, n)| Recipe::Fresh(a, b, n)),
        3 => (0_usize..14, prop::sample::select(vec![1_i8, -1, 2, -2]))
            .prop_map(|(row, factor)| Recipe::Again(row, factor)),
        1 => Just(Recipe::Zero),
    ];
    let constant = (-3_i64..=3, prop::sample::select(vec![1_i64, 1_000_000_000])).prop_map(|(a, b)| a * b);
    let magnitude = prop::sample::select(sizes);
    let body = (magnitude, prop::array::uniform3(prop::sample::select(vec![1.0, 2.0, 0.5, 3.0])));
    (prop::collection::vec(body, 1..=3), prop::collection::vec((recipe, constant), 1..=14)).prop_map(
        |(bodies, list)| {
            let count = bodies.len();
            let mut rows: Vec<Vec<i8>> = Vec::new();
            for (recipe, _) in &list {
                let mut row = vec![0; 3 * count];
                match recipe {
                    Recipe::Fresh(a, b, numbers) => {
                        for (half, body) in [a, b].iter().enumerate() {
                            let start = *body % count * 3;
                            row[start..start + 3].copy_from_slice(&numbers[3 * half..3 * half + 3]);
                        }
                    }
                    Recipe::Again(earlier, factor) if !rows.is_empty() => {
                        let earlier = &rows[earlier % rows.len()];
                        row = earlier.iter().map(|value| (value * factor).clamp(-6, 6)).collect();
                    }
                    Recipe::Again(..) | Recipe::Zero => {}
                }
                rows.push(row);
            }
            let masses = bodies.iter().flat_map(|(size, parts)| parts.map(|part| size * part)).collect();
            Small { masses, rows, constants: list.iter().map(|(_, constant)| *constant).collect() }
        },
    )
}

/// One body of three components with the rows and constant terms given.
fn one_body(rows: &[[i8; 3]], constants: &[i64]) -> Small {
    let constants = constants.iter().map(|constant| constant * 1_000_000_000).collect();
    Small { masses: vec![1.0, 2.0, 0.5], rows: rows.iter().map(|row| row.to_vec()).collect(), constants }
}

/// Rows 0 and 3 oppose each other, and twice the first constant outweighs the second: there are no forces. The other
/// rows that carried force took no part in it, rounding gave them a share of 1e-14, and the solver went along the ray
/// until one of those reached zero: forces of 1e8.
#[test]
fn opposite_rows_behind_others_are_infeasible() {
    let rows = [[-1, 1, -1], [-1, 2, 0], [1, -2, -2], [2, -2, 2], [-1, 2, 1]];
    let small = one_body(&rows, &[-1, -2, 0, 1, -2]);
    let solution = solve(&small.scene());
    assert_eq!(solution.report.status, SolverStatus::Infeasible, "{:?} {:?}", solution.report, solution.forces);
    assert_eq!(solution.squeeze, [1.0, 0.0, 0.0, 0.5, 0.0]);
    small.check().unwrap();
}

/// Rows 5 and 7 oppose each other behind four others, at a mass ratio of 1e6. The ray of the two went along with a
/// share of 1e-10 of the others, all of it rounding; its forces of 1e16 hid the violation, and the answer passed for
/// solved.
#[test]
fn forces_along_a_ray_do_not_pass_for_a_solution() {
    let rows: [[i8; 6]; 9] = [
        [-3, -2, 1, 0, 0, 0],
        [3, 2, 3, 2, -2, 1],
        [3, 1, -2, 1, -1, -1],
        [-3, 3, 1, -1, 2, -2],
        [2, 2, 0, -3, 0, -3],
        [-3, -1, 2, -1, 1, 1],
        [3, 2, 3, 2, -2, 1],
        [6, 2, -4, 2, -2, -2],
        [-1, -3, 2, 2, 3, 3],
    ];
    let constants = [-1, -3_000_000_000, 0, 2_000_000_000, 0, 0, 0, -1_000_000_000, 3_000_000_000].to_vec();
    let masses = vec![2.0, 2.0, 2.0, 1e6, 2e6, 2e6];
    let small = Small { masses, rows: rows.iter().map(|row| row.to_vec()).collect(), constants };
    assert_eq!(solve(&small.scene()).report.status, SolverStatus::Infeasible);
    small.check().unwrap();
}

proptest! {
    #![proptest_config(few(2000))]

    /// Up to three bodies and 14 rows of whole numbers, repeated, opposite or zero, mass ratios up to 1e6, constant
    /// terms that are zero, of size 1 or 1e-9: the solver ends with a solution of the law of contact or with a proof
    /// that there is none.
    #[test]
    fn every_small_problem_is_decided(small in small(vec![1.0, 1.0, 1e1, 1e3, 1e6])) {
        small.check()?;
    }
}

/// A box in a wedge, held by four corner contacts below with lever arms of 1 and four above, whose normals are tilted
/// by `angle` to the one side. Components: heave, two rotations, sideways; masses are one.
///
/// Below, `h - a s >= 1`; above, `-h - a s >= -1 + 2 c a`: the wedge closes, and the box must leave it at `s <= -c`.
/// The least motion is `s = -c`, `h = 1 - c a`, whatever the angle, by forces that add up to `c / a`.
fn wedge(angle: f64, speed: f64) -> Scene {
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let row = |(x, y): (f64, f64), up: f64| -> Row { vec![(0, vec![up, up * y, -up * x, -angle])] };
    let rows: Vec<Row> = [1.0, -1.0].iter().flat_map(|&up| corners.map(|corner| row(corner, up))).collect();
    let mut scene = Scene::new(4, &[vec![1.0; 4]], &rows, &[0.0; 4]);
    scene.b = [-1.0, 1.0 - 2.0 * speed * angle].iter().flat_map(|&b| [b; 4]).collect();
    scene
}

/// Directions in which contacts differ by 1e-12 of the lever arm are told apart (beyond it the wedge closes by less
/// than the tolerance of 1e-13). The heave is the difference of forces
/// of `c / a` and as good as their rounding; the sideways acceleration is as good as `G` in twice the precision, whose
/// pivots are `a^2`. What is below the rank cut of 1e-14 is a squeeze.
#[test]
fn nearly_parallel_contacts_are_told_apart() {
    for exponent in 2..=12 {
        let angle = 10.0_f64.powi(-exponent);
        let scene = wedge(angle, 0.5);
        let solution = solve(&scene);
        assert_eq!(solution.report.status, SolverStatus::Solved, "{angle:e}: {:?}", solution.report);
        let motion = scene.problem.response(&solution.forces).unwrap();
        // The constant terms as they are stored, not as they were meant.
        let speed = 0.5 * (scene.b[0] + scene.b[4]) / -angle;
        let errors = [(motion[0] - (1.0 - speed * angle)).abs(), (motion[3] + speed).abs()];
        assert!(errors[0] <= 4.0 * f64::EPSILON / angle, "{angle:e}: {errors:?}");
        assert!(errors[1] <= 1e-14 + 1e-31 / (angle * angle), "{angle:e}: {errors:?}");
    }
    assert_eq!(solve(&wedge(1e-15, 0.5e4)).report.status, SolverStatus::Infeasible);
}
