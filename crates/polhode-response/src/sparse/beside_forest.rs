//! The rows beside trees of joints: a problem of their own, in which the joints have been eliminated.
//!
//! With `G_K` the matrix of the rows `K` that are in no tree and `H` those of the trees (`held_forest.rs`),
//! `G_K - G_KH G_H^-1 G_HK` says how a unit force along one of them accelerates all of them while the joints hold. It
//! is found column by column: a unit impulse passes through its tree from its bodies to the root and back to all bodies
//! that have such rows. So contacts, limits and loops of a robot are solved for in a matrix of their own size, whatever
//! the number of its joints.
//!
//! For solvers that ask for bodies and Jacobians the problem has one body with a coordinate for each row, whose inverse
//! mass is the matrix, and rows that are unit vectors.
//!
//! The forces of the trees follow from those of the others; what rounding leaves of `J v + C f + b` is solved for once
//! more.

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::certificate::nan_max;
use crate::delassus::Delassus;
use crate::dense::kernels::dot;
use crate::dense::scalar::Scalar;
use crate::error::{ResponseError, check_finite, check_length};
use crate::problem::ContactProblem;
#[cfg(feature = "census")]
use crate::report::SolverStatus;
use crate::sparse::forest_passes::ForestPasses;
use crate::sparse::held_forest::HeldForest;

/// Solves with the factors: the first one, and one for what rounding has left.
const ROUNDS: usize = 2;

/// Forces of all rows of a problem, with what they do.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ForestSolution {
    /// N (N s), of all rows.
    pub forces: Vec<f64>,
    /// `J v + C f + b` of all rows, m/s^2 (m/s).
    pub rates: Vec<f64>,
    /// The largest of those of the trees in relation to the terms of its row (no unit).
    pub residual: f64,
    /// How far the velocities of bodies are from the exact ones at most, in the norm of energy, before the last round
    /// (sqrt(kg) m/s^2; of impulses sqrt(kg) m/s).
    pub bound: f64,
}

/// The problem of the rows beside the trees.
#[derive(Debug, Clone)]
pub struct BesideForest {
    /// In the order of [`HeldForest::others`].
    pub problem: ContactProblem,
    /// Its matrix.
    pub delassus: Delassus,
    /// What each row would move without the trees under a unit force, 1/kg: the scale of what rounding leaves in the
    /// matrix.
    pub free: Vec<f64>,
}

impl HeldForest {
    /// The problem of the rows beside the trees of a problem.
    pub fn beside(&self, problem: &ContactProblem) -> BesideForest {
        let others = self.others();
        let size = others.len();
        let mut entries = vec![0.0; size * size];
        let touched = self.paths(others.iter().flat_map(|&row| problem.entries(row).map(|entry| entry.body)));
        let places: Vec<usize> = touched.iter().rev().copied().collect();
        let mut passes = ForestPasses::new(self);
        for (column, &row) in others.iter().enumerate() {
            let path = self.paths(problem.entries(row).map(|entry| entry.body));
            passes.velocities_by_row(self, (problem, row), (&path, &places));
            for (line, &other) in others.iter().enumerate().skip(column) {
                let rate = passes.rate(self, problem, other);
                entries[line * size + column] = rate;
                entries[column * size + line] = rate;
            }
        }
        let mobility = |&row: &usize| problem.entries(row).map(|own| dot(own.jacobian, own.response)).sum();
        let mut free: Vec<f64> = others.iter().map(mobility).collect();
        for (place, &free) in free.iter().enumerate() {
            if entries[place * size + place] <= f64::ROUNDING * free {
                for other in 0..size {
                    entries[place * size + other] = 0.0;
                    entries[other * size + place] = 0.0;
                }
            }
        }
        let holds: Vec<bool> = others.iter().map(|&row| problem.is_bilateral(row)).collect();
        let place = |row: usize| others.binary_search(&row).ok();
        let soft = problem.compliances().iter().filter_map(|&(row, compliance)| Some((place(row)?, compliance)));
        let own = ContactProblem::of_matrix(&entries, holds, soft.collect());
        for &(row, compliance) in own.compliances() {
            entries[row * size + row] += compliance;
            free[row] += compliance;
        }
        BesideForest { problem: own, delassus: Delassus::from_entries(size, entries), free }
    }

    /// The places, ascending, of these bodies and of all between them and the roots.
    fn paths(&self, bodies: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut places: Vec<usize> = Vec::new();
        let mut is_reached = vec![false; self.limbs().len()];
        for body in bodies {
            let mut next = Some(self.place(body));
            // A body that has been reached has been followed to its root.
            while let Some(place) = next.filter(|&place| !std::mem::replace(&mut is_reached[place], true)) {
                places.push(place);
                next = self.limbs()[place].up();
            }
        }
        places.sort_unstable();
        places
    }

    /// The constant terms of the rows beside the trees, where the joints hold against those of their own.
    ///
    /// # Errors
    /// When `constants` has not one finite number for each row.
    pub fn constants_beside(&self, problem: &ContactProblem, constants: &[f64]) -> Result<Vec<f64>, ResponseError> {
        let held = self.found(problem, constants, &vec![0.0; self.others().len()])?;
        Ok(self.others().iter().map(|&row| held.rates[row]).collect())
    }

    /// The forces of all rows from those of the rows beside the trees.
    ///
    /// # Errors
    /// When `constants` has not one finite number for each row, or `of_others` not one for each row beside the trees.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn with_others(
        &self,
        problem: &ContactProblem,
        constants: &[f64],
        of_others: &[f64],
    ) -> Result<ForestSolution, ResponseError> {
        let found = self.found(problem, constants, of_others)?;
        #[cfg(feature = "census")]
        {
            let size = Size { bodies: problem.bodies(), rows: problem.len(), cones: 0 };
            census::note_single(Chain::Forest, size, "passes", SolverStatus::Solved, found.residual);
        }
        Ok(found)
    }

    fn found(
        &self,
        problem: &ContactProblem,
        constants: &[f64],
        of_others: &[f64],
    ) -> Result<ForestSolution, ResponseError> {
        check_length("constant terms", problem.len(), constants.len())?;
        check_finite("constant terms", constants)?;
        check_length("forces", self.others().len(), of_others.len())?;
        let mut found = ForestSolution { forces: vec![0.0; problem.len()], ..ForestSolution::default() };
        for (&row, &force) in self.others().iter().zip(of_others) {
            found.forces[row] = force;
        }
        let mut passes = ForestPasses::new(self);
        let mut rates = problem.rates(constants, &found.forces);
        for _ in 0..ROUNDS {
            let corrections = passes.forces(self, self.rows().map(|row| rates[row]));
            let mut power = 0.0;
            for (row, &correction) in self.rows().zip(corrections) {
                found.forces[row] += correction;
                power += correction * rates[row];
            }
            found.bound = power.abs().sqrt();
            rates = problem.rates(constants, &found.forces);
        }
        let scales = problem.scales_of_rates(constants, &found.forces);
        // Terms that are rounding of those of other rows, as across a plane in which all moves, are not judged by
        // themselves.
        let least = f64::EPSILON * scales.iter().fold(0.0, |most: f64, scale| most.max(*scale));
        let relative = |row: usize| if scales[row] == 0.0 { 0.0 } else { rates[row].abs() / scales[row].max(least) };
        found.residual = self.rows().map(relative).fold(0.0, nan_max);
        found.rates = rates;
        Ok(found)
    }
}

impl ContactProblem {
    /// `J v + C f + b` of all rows with these forces.
    fn rates(&self, constants: &[f64], forces: &[f64]) -> Vec<f64> {
        let motion = self.motion_by(forces, |force, response| force * response);
        let mut rates = constants.to_vec();
        for (row, rate) in rates.iter_mut().enumerate() {
            *rate += self.along(row, &motion, |jacobian, own| jacobian * own);
        }
        for &(row, compliance) in self.compliances() {
            rates[row] += compliance * forces[row];
        }
        rates
    }

    /// The sums of the magnitudes of their terms.
    fn scales_of_rates(&self, constants: &[f64], forces: &[f64]) -> Vec<f64> {
        let motion = self.motion_by(forces, |force, response| (force * response).abs());
        let mut scales: Vec<f64> = constants.iter().map(|constant| constant.abs()).collect();
        for (row, scale) in scales.iter_mut().enumerate() {
            *scale += self.along(row, &motion, |jacobian, own| jacobian.abs() * own);
        }
        scales
    }

    fn motion_by(&self, forces: &[f64], term: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let width = self.width();
        let mut motion = vec![0.0; self.bodies() * width];
        for (row, &force) in forces.iter().enumerate() {
            if force != 0.0 {
                for entry in self.entries(row) {
                    let target = &mut motion[entry.body * width..(entry.body + 1) * width];
                    target.iter_mut().zip(entry.response).for_each(|(own, &response)| *own += term(force, response));
                }
            }
        }
        motion
    }

    fn along(&self, row: usize, motion: &[f64], term: impl Fn(f64, f64) -> f64) -> f64 {
        let width = self.width();
        let of = |body: usize| &motion[body * width..(body + 1) * width];
        let own =
            |(jacobian, motion): (&[f64], &[f64])| jacobian.iter().zip(motion).map(|(a, b)| term(*a, *b)).sum::<f64>();
        self.entries(row).map(|entry| own((entry.jacobian, of(entry.body)))).sum()
    }
}

#[cfg(test)]
mod tests {
    //! A chain with a loop and contacts: the forces are those that the matrix of all rows gives.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::least_norm_hold::LeastNormHold;

    /// Bodies in space with three rows between neighbours, the first with the world; a body beside the chain; rows that
    /// push at the ends, and a soft row between the first and the third body.
    fn chain(bodies: usize, heavy: f64) -> (ContactProblem, Vec<f64>) {
        let mut masses = Vec::new();
        for body in 0..bodies {
            let mass = if body + 1 == bodies { heavy } else { 1.0 };
            for i in 0..36 {
                let share = if i / 6 < 3 { 1.0 } else { 12.0 };
                masses.push(if i % 7 == 0 { share / mass } else { 0.0 });
            }
        }
        let mut problem = ContactProblem::new(6, masses).unwrap();
        let row = |axis: usize, sign: f64, arm: f64| {
            let mut row = [0.0; 6];
            row[axis] = sign;
            // Arm along z and a little along x.
            let r = [0.1 * arm, 0.0, arm];
            let d: [f64; 3] = std::array::from_fn(|k| if k == axis { sign } else { 0.0 });
            row[3] = r[1] * d[2] - r[2] * d[1];
            row[4] = r[2] * d[0] - r[0] * d[2];
            row[5] = r[0] * d[1] - r[1] * d[0];
            row
        };
        for body in 0..bodies - 1 {
            for axis in 0..3 {
                let own = row(axis, 1.0, 0.5);
                if body == 0 {
                    problem.push_held_row(&[(0, &own)]).unwrap();
                } else {
                    problem.push_held_row(&[(body, &own), (body - 1, &row(axis, -1.0, -0.5))]).unwrap();
                }
            }
        }
        let soft =
            problem.push_held_row(&[(2, &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0]), (0, &[0.0, 0.0, 0.0, 0.0, -1.0, 0.0])]);
        problem.soften(soft.unwrap(), 3.0).unwrap();
        problem.push_row(&[(bodies - 2, &row(0, 1.0, -0.5))]).unwrap();
        problem.push_row(&[(bodies - 1, &row(2, 1.0, 0.0)), (1, &row(2, -1.0, 0.3))]).unwrap();
        let constants = (0..problem.len()).map(|row| ((7 * row + 3) % 11) as f64 - 4.5).collect();
        (problem, constants)
    }

    #[test]
    fn the_forces_are_those_of_the_matrix_of_all_rows() {
        for heavy in [1.0, 1e4] {
            let (problem, constants) = chain(7, heavy);
            let forest = HeldForest::of(&problem, 0..problem.len()).unwrap();
            assert_eq!(forest.others(), [18, 19, 20]);
            let delassus = problem.delassus();
            let all = LeastNormHold::factor(&delassus).unwrap().solve(&delassus, &constants).unwrap();
            let beside = forest.beside(&problem);
            let of_others = forest.constants_beside(&problem, &constants).unwrap();
            let hold = LeastNormHold::factor(&beside.delassus).unwrap();
            let of_others = hold.solve(&beside.delassus, &of_others).unwrap();
            let found = forest.with_others(&problem, &constants, &of_others).unwrap();
            for (a, b) in found.forces.iter().zip(&all) {
                assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{a} instead of {b}");
            }
            assert!(found.residual < 1e-14 && found.rates.iter().all(|rate| rate.abs() < 1e-11), "{found:?}");
        }
    }

    /// A hundred links of 1 kg hang from the world, the last of them of a million: each joint bears the weight of what
    /// is below it.
    #[test]
    fn a_chain_bears_a_million_times_the_mass_of_a_link() {
        const LINKS: usize = 100;
        let mass = |link: usize| if link + 1 == LINKS { 1e6 } else { 1.0 };
        let entry = |link: usize, i: usize| if i < 3 { 1.0 / mass(link) } else { 1200.0 / mass(link) };
        let diagonal = |link: usize| (0..36).map(move |i| if i % 7 == 0 { entry(link, i / 7) } else { 0.0 });
        let mut problem = ContactProblem::new(6, (0..LINKS).flat_map(diagonal).collect()).unwrap();
        let mut constants = Vec::new();
        for link in 0..LINKS {
            for axis in 0..3 {
                // A force at the arm (0, 0, z): moments z x along.
                let row = |sign: f64, z: f64| {
                    let mut row = [0.0; 6];
                    row[axis] = sign;
                    match axis {
                        0 => row[4] = sign * z,
                        1 => row[3] = -sign * z,
                        _ => {}
                    }
                    row
                };
                let own = row(1.0, 0.05);
                let above = row(-1.0, -0.05);
                let is_first = link == 0;
                let entries: &[(usize, &[f64])] =
                    if is_first { &[(0, &own)] } else { &[(link, &own), (link - 1, &above)] };
                problem.push_held_row(entries).unwrap();
                constants.push(if is_first && axis == 2 { -9.81 } else { 0.0 });
            }
        }
        let forest = HeldForest::of(&problem, 0..problem.len()).unwrap();
        let found = forest.with_others(&problem, &constants, &[]).unwrap();
        let mut weight: f64 = (0..LINKS).map(|link| 9.81 * mass(link)).sum();
        for (link, force) in found.forces.chunks_exact(3).enumerate() {
            assert!((force[2] - weight).abs() < 1e-9 * weight, "{link}: {} instead of {weight}", force[2]);
            assert!(force[0].abs().max(force[1].abs()) < 1e-9 * weight, "{link}: {force:?}");
            weight -= 9.81 * mass(link);
        }
    }

    #[test]
    fn rows_that_depend_on_each_other_have_no_forest() {
        let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0]).unwrap();
        problem.push_held_row(&[(0, &[1.0, 0.5])]).unwrap();
        problem.push_held_row(&[(0, &[2.0, 1.0])]).unwrap();
        assert!(HeldForest::of(&problem, 0..problem.len()).is_none());
    }
}
