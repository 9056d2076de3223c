//! Equilibrium: forces within the cones that hold every contact.
//!
//! Where friction jams bodies against each other Coulomb's law may have several answers: forces that hold everything,
//! and others under which something moves. What is at rest stays at rest if it can. Let `f_0` be any forces, in the cones or
//! not, that hold all rows, `G f_0 + b = 0` (those of least norm). Others hold them too exactly if they add up to the same on
//! each body, since `G (f - f_0) = J M^-1 J^T (f - f_0) = 0` makes `J^T (f - f_0)` zero. Sought are
//!
//! ```text
//! minimise |S^-1 f|^2   subject to   J^T f = J^T f_0,   (1 - s) mu f_n >= |f_t| at every contact
//! ```
//!
//! with `s` the part of friction that is kept in reserve, and `S` the size of the forces on the lighter loaded body of each
//! contact: a convex programme over second-order cones. No mass is in it, so that light bodies under heavy ones are as well
//! conditioned as others, and what each body bears is balanced to a part of the forces on that body, however small they are
//! against those on others. Source: Heyman 1966 (a structure stands if forces within the cones balance it); Goulart and Chen
//! 2024 (the solver). Failure: `None` where no forces balance, and where the interior point finds none.

use crate::dense::kernels::largest;
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::blocks::Blocks;
use crate::interior_point::{ConeProgramme, ConeRows, least_motion};
use crate::law::Law;
use crate::precise;
use crate::problem::ContactProblem;
use polhode_spatial::DoubleDouble;

/// Contacts that bear less than this part of the forces on the lighter loaded of their bodies bear nothing (no unit, 1e-9 to
/// 1e-6): the tolerance of the interior point.
const UNLOADED: f64 = 1e-8;

/// Least size of the forces on a body, as a part of the largest on any (no unit, 1e-15 to 1e-9): bodies on which no force acts
/// must not divide by zero.
const LEAST_LOAD: f64 = 1e-12;

/// The least forces (N) of all rows of `problem` within the cones that add up to the same on every body as `holding`, to the
/// tolerance of the interior point (1e-12 to 1e-8 of the forces on the body). `reserve` is the part of the friction that they
/// leave unused (no unit). Contacts that bear nothing have zero. None where there are none, or a contact slides already
/// or resists rotations.
///
/// ```
/// use polhode_response::friction::balancing_forces;
/// use polhode_response::{Blocks, ContactProblem, Law};
/// // A point of 2 kg on a slope of 3 in 4 under 10 m/s^2: friction of 0.76 holds it, with hardly any reserve.
/// let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
/// problem.push_row(&[(0, &[1.0, 0.0])])?;
/// problem.push_held_row(&[(0, &[0.0, 1.0])])?;
/// let mut blocks = Blocks::default();
/// blocks.push(Law::Cone { rows: 2, friction: 0.76 }, [0, 1]);
/// assert!(balancing_forces(&problem, &[16.0, -12.0], &blocks, 0.01)?.is_some());
/// assert!(balancing_forces(&problem, &[16.0, -12.0], &blocks, 0.02)?.is_none());
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
///
/// # Errors
/// When the reserve is not in `[0, 1)`, lengths differ, a row does not exist, or a force is not finite.
pub fn balancing_forces(
    problem: &ContactProblem,
    holding: &[f64],
    blocks: &Blocks,
    reserve: f64,
) -> Result<Option<Vec<f64>>, ResponseError> {
    if !(0.0..1.0).contains(&reserve) {
        return Err(ResponseError::Setting { field: "reserve", accepted: "at least 0 and below 1", value: reserve });
    }
    check_length("forces", problem.len(), holding.len())?;
    check_finite("forces", holding)?;
    let variables = blocks.laws().iter().map(|law| law.rows()).sum();
    check_length("rows of the blocks", variables, blocks.rows().len())?;
    if let Some(&row) = blocks.rows().iter().find(|&&row| row >= problem.len()) {
        return Err(ResponseError::UnknownRow { row, rows: problem.len() });
    }
    let sizes = sizes_of_forces(problem, holding, blocks);
    let units: Vec<f64> = sizes.iter().zip(blocks.scales()).map(|(size, scale)| size * scale).collect();
    let mut programme = Programme::default();
    programme.push_balance(problem, holding, (blocks.rows(), &units));
    let mut first = 0;
    for law in blocks.laws() {
        if !programme.push_cone(*law, first, reserve) {
            return Ok(None);
        }
        first += law.rows();
    }
    let Programme { entries, constant, cones } = programme;
    let ConeProgramme::Solved { mut point, .. } = least_motion(variables, &entries, &constant, &cones) else {
        return Ok(None);
    };
    unload(&mut point, blocks);
    let mut forces = vec![0.0; problem.len()];
    for ((&row, part), unit) in blocks.rows().iter().zip(&point).zip(&units) {
        forces[row] = part * unit;
    }
    Ok(Some(forces))
}

/// Takes what bears nothing to the tolerance of the interior point out of forces in their units, in the order of the blocks.
pub(super) fn unload(parts: &mut [f64], blocks: &Blocks) {
    let mut first = 0;
    for law in blocks.laws() {
        let own = &mut parts[first..first + law.rows()];
        if matches!(law, Law::Push | Law::Cone { .. }) && own[0] <= UNLOADED {
            own.fill(0.0);
        }
        first += law.rows();
    }
}

/// For each row of the blocks the sum of the forces on the lighter loaded of its bodies, N.
fn sizes_of_forces(problem: &ContactProblem, holding: &[f64], blocks: &Blocks) -> Vec<f64> {
    let mut loads = vec![0.0; problem.bodies()];
    for (row, force) in holding.iter().enumerate() {
        for entry in problem.entries(row) {
            loads[entry.body] += force.abs();
        }
    }
    let most = largest(&loads);
    let least = if most > 0.0 { LEAST_LOAD * most } else { 1.0 };
    let on_lighter = |row: usize| problem.entries(row).map(|entry| loads[entry.body]).fold(f64::INFINITY, f64::min);
    blocks.rows().iter().map(|&row| on_lighter(row).max(least)).collect()
}

/// The rows of a cone programme.
#[derive(Debug, Default)]
struct Programme {
    /// Row, column and value.
    entries: Vec<(usize, usize, f64)>,
    constant: Vec<f64>,
    cones: Vec<ConeRows>,
}

impl Programme {
    /// Asks for `J^T f = J^T f_0`: a row for each component of each body that a force acts on, scaled to a largest entry 1.
    fn push_balance(&mut self, problem: &ContactProblem, holding: &[f64], (rows, units): (&[usize], &[f64])) {
        let width = problem.width();
        let all: Vec<usize> = (0..problem.len()).collect();
        let exact: Vec<DoubleDouble> = holding.iter().map(|&force| DoubleDouble::new(force)).collect();
        let wanted = precise::loads(problem, &all, &exact);
        let mut lines: Vec<Vec<(usize, f64)>> = vec![Vec::new(); wanted.len()];
        for (column, (&row, unit)) in rows.iter().zip(units).enumerate() {
            for entry in problem.entries(row) {
                for (component, value) in entry.jacobian.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                    lines[entry.body * width + component].push((column, value * unit));
                }
            }
        }
        for (line, wanted) in lines.iter().zip(wanted) {
            let size = line.iter().fold(0.0, |most: f64, (_, value)| most.max(value.abs()));
            if size > 0.0 {
                let row = self.constant.len();
                self.entries.extend(line.iter().map(|&(column, value)| (row, column, value / size)));
                self.constant.push(-wanted.value() / size);
            }
        }
        self.cones.push(ConeRows::Zero(self.constant.len()));
    }

    /// Asks a block, whose rows begin at `first`, to keep to its cone. Whether it can: what slides has none, and that of
    /// what resists rotations is another one.
    fn push_cone(&mut self, law: Law, first: usize, reserve: f64) -> bool {
        let weight = match law {
            Law::Hold { .. } => return true,
            Law::Slide { .. } | Law::Resist { .. } => return false,
            Law::Cone { rows, friction } if rows > 1 && friction > 0.0 => {
                self.cones.push(ConeRows::SecondOrder(rows));
                friction * (1.0 - reserve)
            }
            Law::Push | Law::Cone { .. } => {
                self.cones.push(ConeRows::Nonnegative(1));
                if law.rows() > 1 {
                    self.cones.push(ConeRows::Zero(law.rows() - 1));
                }
                1.0
            }
        };
        for column in first..first + law.rows() {
            self.entries.push((self.constant.len(), column, if column == first { weight } else { 1.0 }));
            self.constant.push(0.0);
        }
        true
    }
}

#[cfg(test)]
mod tests {
    //! What balances is found, and what cannot balance is told.
    #![expect(clippy::unwrap_used, reason = "a failed step fails the test")]
    use super::*;
    use crate::least_norm_hold::least_norm_forces;

    const RESERVE: f64 = 1e-6;

    /// Contacts of `friction` with these rows (normal, tangents) on one body of 1 kg in so many dimensions, under this
    /// acceleration of gravity.
    fn balanced(rows: &[Vec<f64>], gravity: &[f64], friction: f64) -> Option<Vec<f64>> {
        let width = gravity.len();
        let inverse_mass = (0..width * width).map(|k| if k % (width + 1) == 0 { 1.0 } else { 0.0 });
        let mut problem = ContactProblem::new(width, inverse_mass.collect()).unwrap();
        for (index, row) in rows.iter().enumerate() {
            let entries = [(0, row.as_slice())];
            if index % width == 0 { problem.push_row(&entries) } else { problem.push_held_row(&entries) }.unwrap();
        }
        let b = problem.row_velocities(gravity).unwrap();
        let holding = least_norm_forces(&problem, &problem.delassus(), &b).unwrap().forces;
        let mut blocks = Blocks::default();
        for first in (0..rows.len()).step_by(width) {
            blocks.push(Law::Cone { rows: width, friction }, first..first + width);
        }
        balancing_forces(&problem, &holding, &blocks, RESERVE).unwrap()
    }

    /// A point on a slope of 3 in 4: friction 0.76 holds it, 0.74 does not.
    fn on_a_slope(friction: f64) -> Option<Vec<f64>> {
        let rows = [vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 1.0]];
        balanced(&rows, &[-8.0, 6.0, 0.0], friction)
    }

    #[test]
    fn forces_balance_where_friction_bears_the_slope() {
        let forces = on_a_slope(0.76).unwrap();
        for (found, expected) in forces.iter().zip([8.0, -6.0, 0.0]) {
            assert!((found - expected).abs() < 1e-9, "{found} where {expected} balances");
        }
    }

    #[test]
    fn nothing_balances_where_friction_is_too_small() {
        assert_eq!(on_a_slope(0.74), None);
    }

    /// A wedge of 1 kg between two walls that lean apart below by 0.1 rad: its weight alone presses it on neither, so that it
    /// may fall, and friction of 0.2 > tan(0.1) can hold it all the same.
    #[test]
    fn a_wedge_that_may_fall_is_held() {
        let (s, c) = (libm::sin(0.1), libm::cos(0.1));
        // Rows along the normals and tangents of both walls, in the plane.
        let rows = [vec![c, -s], vec![s, c], vec![-c, -s], vec![-s, c]];
        let forces = balanced(&rows, &[0.0, -9.81], 0.2).unwrap();
        for (component, weight) in [(0, 0.0), (1, 9.81)] {
            let sum: f64 = rows.iter().zip(&forces).map(|(row, force)| row[component] * force).sum();
            assert!((sum - weight).abs() < 1e-8, "{sum} where {weight} balances");
        }
        for contact in forces.chunks(2) {
            assert!(contact[1].abs() <= 0.2 * contact[0], "{contact:?} is in the cone");
        }
    }

    /// Points in a column on a slope of 3 in 4, each on the one below, of masses 1 to 1e9 in either order: the balance of the
    /// lightest is as good as that of the heaviest.
    #[test]
    fn every_body_is_balanced_to_a_part_of_its_own_forces() {
        for masses in [[1.0, 1e3, 1e6, 1e9], [1e9, 1e6, 1e3, 1.0], [1e9, 1.0, 1e9, 1.0]] {
            let inverse = masses.iter().flat_map(|m| [1.0 / m, 0.0, 0.0, 1.0 / m]);
            let mut problem = ContactProblem::new(2, inverse.collect()).unwrap();
            let axes = [vec![1.0, 0.0], vec![0.0, 1.0]];
            let below = axes.each_ref().map(|axis| axis.iter().map(|value| -value).collect::<Vec<f64>>());
            for upper in 0..masses.len() {
                for (axis, below) in axes.iter().zip(&below) {
                    let entries = [(upper, axis.as_slice()), (upper.saturating_sub(1), below.as_slice())];
                    problem.push_held_row(&entries[..if upper == 0 { 1 } else { 2 }]).unwrap();
                }
            }
            let b = problem.row_velocities(&[-8.0, 6.0].repeat(masses.len())).unwrap();
            let holding = least_norm_forces(&problem, &problem.delassus(), &b).unwrap().forces;
            let mut blocks = Blocks::default();
            for first in (0..problem.len()).step_by(2) {
                blocks.push(Law::Cone { rows: 2, friction: 0.76 }, [first, first + 1]);
            }
            let forces = balancing_forces(&problem, &holding, &blocks, RESERVE).unwrap().unwrap();
            for upper in 0..masses.len() {
                let weight: f64 = masses.iter().skip(upper).sum();
                for (found, expected) in forces[2 * upper..].iter().zip([8.0 * weight, -6.0 * weight]) {
                    assert!((found / expected - 1.0).abs() < 1e-8, "{masses:?}: {found} where {expected} balances");
                }
            }
        }
    }
}
