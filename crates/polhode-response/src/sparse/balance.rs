//! Forces made to balance: what they leave on each body is taken out by a small change of those that bear something.
//!
//! Let `a` be the accelerations of the bodies without the forces `r`, all masses scaled away. What is left is
//!
//! ```text
//! e = a + H^T r,     sought are changes   dr = -K H (I + H^T K H)^-1 e   with   K large,
//! ```
//!
//! which minimise `|e + H^T dr|^2 + dr^T K^-1 dr`: a factorisation whose size goes with the bodies, however many
//! contacts are redundant, repeated on what is still left until that is rounding. `K` of a contact is in proportion to
//! its normal force and zero where it bears nothing, so that forces within their cones stay there. Symbols: `H` rows of
//! contacts (1/kg^1/2), `r` (N), `a`, `e` (m/s^2 kg^1/2), `K` (kg).
//!
//! Failure: forces that bear nothing where they would have to leave a rest, which is told.

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::Blocks;
use crate::law::{Law, MOST_ROWS};
use crate::problem::ContactProblem;
#[cfg(feature = "census")]
use crate::report::SolverStatus;
use crate::sparse::block6::{Vector6, WIDTH};
use crate::sparse::elimination::Elimination;
use crate::sparse::from_blocks::Converted;
use crate::sparse::problem::{BodyProblem, RowBlock};
use crate::sparse::system::{BodySystem, RowMatrix, Sides};

/// `K` of the contact that bears most, in units of the mass that its rows meet (no unit, 1e6 to 1e10): a larger one
/// leaves less in one round, and more to rounding of the factors.
const STIFFNESS: f64 = 1e8;

/// What is left on a body is rounding when it is at most this part of the sum of the magnitudes of the forces on it (no
/// unit, 1e-16 to 1e-14).
const BALANCED: f64 = 2e-15;

/// Forces in balance.
#[derive(Debug, Clone, PartialEq)]
pub struct BalancedForces {
    /// Of all rows, N.
    pub forces: Vec<f64>,
    /// The largest of what is left on a body, relative to the sum of the magnitudes of the forces on it (no unit).
    pub left: f64,
}

impl Blocks {
    /// Forces near `forces` (N, of all rows) that balance the bodies' accelerations `free` (m/s^2 and rad/s^2, in
    /// blocks of the problem's width) without them.
    ///
    /// ```
    /// use polhode_response::{Blocks, ContactProblem, Law};
    /// // A point of 2 kg on a floor, under 10 m/s^2, with forces that are a little off.
    /// let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
    /// problem.push_row(&[(0, &[0.0, 1.0])])?;
    /// problem.push_held_row(&[(0, &[1.0, 0.0])])?;
    /// let mut blocks = Blocks::default();
    /// blocks.push(Law::Cone { rows: 2, friction: 0.5 }, [0, 1]);
    /// let balanced = blocks.balance_in_bodies(&problem, &[0.0, -10.0], &[20.1, 0.01])?;
    /// assert!((balanced.forces[0] - 20.0).abs() < 1e-13 && balanced.left < 1e-14);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// When a length differs, a number is not finite, a row does not exist, or as [`Blocks::solve_in_bodies`].
    #[cfg_attr(feature = "census", track_caller)]
    pub fn balance_in_bodies(
        &self,
        problem: &ContactProblem,
        free: &[f64],
        forces: &[f64],
    ) -> Result<BalancedForces, ResponseError> {
        check_length("forces", problem.len(), forces.len())?;
        check_finite("forces", forces)?;
        let Converted { mut bodies, .. } = self.in_bodies(problem, &vec![0.0; self.rows().len()])?;
        bodies.set_free_velocities(&padded(problem, free)?)?;
        let of_rows = self.rows().iter().map(|&row| forces.get(row).copied().unwrap_or(0.0));
        let mut found: Vec<f64> = of_rows.zip(self.scales()).map(|(force, scale)| force / scale).collect();
        let left = balance(&bodies, &mut found);
        #[cfg(feature = "census")]
        {
            let size = Size { bodies: problem.bodies(), rows: problem.len(), cones: self.len() };
            let status = if left <= BALANCED { SolverStatus::Solved } else { SolverStatus::Inaccurate };
            census::note_single(Chain::Limit, size, "balance", status, left);
        }
        let mut in_rows = self.reactions_in_rows(&found);
        in_rows.resize(problem.len(), 0.0);
        Ok(BalancedForces { forces: in_rows, left })
    }
}

/// Generalised accelerations of all bodies with six coordinates each.
pub(super) fn padded(problem: &ContactProblem, of_bodies: &[f64]) -> Result<Vec<Vector6>, ResponseError> {
    let width = problem.width();
    check_length("accelerations of bodies", problem.bodies() * width, of_bodies.len())?;
    let of = |own: &[f64]| {
        let mut six = [0.0; WIDTH];
        six.iter_mut().zip(own).for_each(|(six, own)| *six = *own);
        six
    };
    Ok(of_bodies.chunks_exact(width.max(1)).map(of).collect())
}

/// Changes reactions so that all bodies balance; returns what is left, relative.
fn balance(problem: &BodyProblem, reactions: &mut Vec<f64>) -> f64 {
    let mut unbalanced = Vec::new();
    let mut left = left_on_bodies(problem, reactions, &mut unbalanced);
    if left <= BALANCED {
        return left;
    }
    let elimination = Elimination::of(problem);
    let mut system = BodySystem::default();
    system.factor(problem, &elimination, &stiffnesses(problem, reactions));
    let (mut moved, mut change) = (Vec::new(), vec![0.0; reactions.len()]);
    // Each round leaves a part of 1e-6, and of a heavy body on light ones a part of 1e-2; what is left must fall.
    loop {
        change.fill(0.0);
        system.solve(problem, &elimination, Sides { bodies: &unbalanced, rows: &mut change }, 0, &mut moved);
        let tried: Vec<f64> = reactions.iter().zip(&change).map(|(reaction, change)| reaction + change).collect();
        let now = left_on_bodies(problem, &tried, &mut unbalanced);
        // Written so that NaN ends it.
        let is_better = now < left;
        if !is_better {
            return left;
        }
        (*reactions, left) = (tried, now);
        if left <= BALANCED {
            return left;
        }
    }
}

/// What forces leave on each body, and the largest relative to the sum of the magnitudes of the forces on the body.
fn left_on_bodies(problem: &BodyProblem, reactions: &[f64], unbalanced: &mut Vec<Vector6>) -> f64 {
    problem.scaled_velocities(reactions, unbalanced);
    let mut sizes: Vec<f64> = problem.free.iter().map(length).collect();
    for block in &problem.blocks {
        for side in block.movable() {
            for (line, reaction) in problem.lines(block, side).iter().zip(&reactions[block.rows.clone()]) {
                sizes[side.node] += reaction.abs() * length(line);
            }
        }
    }
    let relative = |(left, size): (&Vector6, f64)| if size > 0.0 { length(left) / size } else { 0.0 };
    unbalanced.iter().zip(sizes).map(relative).fold(0.0, f64::max)
}

fn length(vector: &Vector6) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// `K` of every block.
fn stiffnesses(problem: &BodyProblem, reactions: &[f64]) -> Vec<RowMatrix> {
    let most = problem.blocks.iter().filter(|block| block.law.pushes()).map(|block| reactions[block.rows.start]);
    let most = most.fold(0.0, f64::max);
    let of = |(block, inverse_mass): (&RowBlock, f64)| {
        let share = match block.law {
            Law::Hold { .. } => 1.0,
            Law::Push | Law::Cone { .. } if most > 0.0 => reactions[block.rows.start].max(0.0) / most,
            _ => 0.0,
        };
        let mut stiffness: RowMatrix = [[0.0; MOST_ROWS]; MOST_ROWS];
        for row in 0..block.rows.len() {
            stiffness[row][row] = STIFFNESS * share / inverse_mass;
        }
        stiffness
    };
    problem.blocks.iter().zip(problem.inverse_masses()).map(of).collect()
}

#[cfg(test)]
mod tests {
    //! Forces that are off by a part of a thousandth balance afterwards, on every body to rounding of its own forces,
    //! with many redundant contacts and with masses that differ by 1e6; where nothing bears what is missing, that is
    //! told.
    #![expect(clippy::unwrap_used, reason = "a failed step fails the test")]
    use super::*;

    const CORNERS: [[f64; 2]; 4] = [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
    const GRAVITY: f64 = 9.81;

    /// Cubes on each other, four corners each with normal and tangents.
    fn tower(masses: &[f64]) -> (ContactProblem, Blocks) {
        let inverse = masses.iter().flat_map(|mass| {
            (0..36).map(move |k| match (k % 7, k / 7) {
                (0, 0..3) => 1.0 / mass,
                (0, _) => 6.0 / mass,
                _ => 0.0,
            })
        });
        let mut problem = ContactProblem::new(6, inverse.collect()).unwrap();
        let mut blocks = Blocks::default();
        for body in 0..masses.len() {
            for [x, y] in CORNERS {
                let first = problem.len();
                for axis in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
                    let row = |z: f64, sign: f64| {
                        let [a, b, c] = axis;
                        [a, b, c, y * c - z * b, z * a - x * c, x * b - y * a].map(|entry| sign * entry)
                    };
                    let (upper, lower) = (row(-0.5, 1.0), row(0.5, -1.0));
                    let mut entries: Vec<(usize, &[f64])> = vec![(body, &upper)];
                    if body > 0 {
                        entries.push((body - 1, &lower));
                    }
                    if problem.len() == first { problem.push_row(&entries) } else { problem.push_held_row(&entries) }
                        .unwrap();
                }
                blocks.push(Law::Cone { rows: 3, friction: 0.5 }, first..first + 3);
            }
        }
        (problem, blocks)
    }

    fn free(bodies: usize) -> Vec<f64> {
        (0..bodies).flat_map(|_| [0.3, 0.0, -GRAVITY, 0.0, 0.0, 0.0]).collect()
    }

    #[test]
    fn forces_of_a_tower_balance() {
        for masses in [vec![1.0; 6], vec![1e6, 1.0, 1e6, 1.0], vec![1.0, 1e6, 1.0]] {
            let (problem, blocks) = tower(&masses);
            let mut forces = vec![0.0; problem.len()];
            for (body, own) in forces.chunks_exact_mut(12).enumerate() {
                let above: f64 = masses.iter().skip(body).sum();
                for (corner, own) in own.chunks_exact_mut(3).enumerate() {
                    own[0] = 0.25 * above * GRAVITY * (1.0 + 1e-3 * corner as f64);
                    own[1] = -0.25 * above * 0.3;
                }
            }
            let found = blocks.balance_in_bodies(&problem, &free(masses.len()), &forces).unwrap();
            assert!(found.left < 1e-14, "{masses:?}: {}", found.left);
            for (found, given) in found.forces.chunks_exact(3).zip(forces.chunks_exact(3)) {
                assert!((found[0] / given[0] - 1.0).abs() < 0.3, "{found:?} near {given:?}");
            }
        }
    }

    #[test]
    fn what_nothing_bears_is_left() {
        let (problem, blocks) = tower(&[1.0]);
        let found = blocks.balance_in_bodies(&problem, &free(1), &[0.0; 12]).unwrap();
        assert!(found.left > 0.5 && found.forces.iter().all(|force| *force == 0.0), "{found:?}");
    }
}
