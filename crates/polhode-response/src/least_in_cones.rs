//! The least forces within the cones of friction, among those that hold what some forces hold.
//!
//! Where rows depend on each other, many forces hold them. Those of least norm ([`least_norm_sliding_forces`]) know no
//! cones: where some contacts slide and others stick they may pull, or ask a contact that sticks for more than friction
//! bears. With forces `f_0` that hold all rows, and `A` the accelerations of the held rows for unit forces along them
//! (with the friction that each normal force of a sliding contact brings), sought are
//!
//! ```text
//! minimise |f|^2 / 2   subject to   A f = A f_0,   f_n >= 0,   |f_t| <= mu f_n of every contact that sticks
//! ```
//!
//! Method: let the columns of `Q` be an orthonormal basis of the range of `A^T` (QR with column pivoting). Then
//! `f = P(Q y)`, with `P` the projection onto the cones, where `y` minimises the convex function
//! `|P(Q y)|^2 / 2 - y.Q^T f_0`. Its gradient is `Q^T P(Q y) - Q^T f_0`; Newton's method with a line search finds its
//! zero. Rolling and spinning that are held are cones of their own, each with a copy of the normal force that the
//! constraints equate with it. Forces along rows with scales are minimised as their blocks take them. Sources: Malick
//! 2004 (the dual method), Qi and Sun 1993 (Newton's method where the projection has kinks). Symbols: `f` force (N),
//! `mu` coefficient of friction.
//!
//! Failure: `None` where no forces lie in the cones (the dual function falls without end), or those that do use all of
//! them.
//!
//! [`least_norm_sliding_forces`]: crate::least_norm_sliding_forces

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::delassus::Delassus;
use crate::dense::cholesky::GrowingCholesky;
use crate::dense::householder::PivotedQr;
use crate::dense::kernels::{dot, largest};
use crate::dense::scalar::Scalar;
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::Blocks;
#[cfg(feature = "census")]
use crate::report::SolverStatus;
use crate::sliding::{SlidingRow, check_rows, held_by_forces};
use crate::tolerances::DECREASE;
use crate::tolerances::DEPENDENT;
use polhode_spatial::rounding;

/// A force exceeds its cone from this much above it on, relative to the largest force (no unit, 1e-11 to 1e-10).
pub(crate) const EXCEEDED: f64 = 5e-11;

/// Most steps of Newton's method: some ten come to rounding where forces lie well within the cones.
const MOST_NEWTON_STEPS: u32 = 60;

/// Least that is added to the diagonal of Newton's matrix, whose entries are at most 1 (no unit). Far from the answer
/// it is the gradient, relative to the largest force: in directions in which the projection does not change, steps stay
/// as long as forces are, and near the answer they are as good as Newton's.
const LEAST_DUAL_DAMPING: f64 = 1e-12;

/// One cone: a normal force, and forces along rows that it bounds.
#[derive(Debug)]
struct ForceCone {
    normal: usize,
    /// Variables, their squares added up.
    bounded: Vec<usize>,
    friction: f64,
}

/// Blocks as cones over variables: those of the rows that are held, then copies of normal forces.
#[derive(Debug, Default)]
struct Cones {
    of_contacts: Vec<ForceCone>,
    /// What the variable of each held row is multiplied by to give its force.
    scales: Vec<f64>,
    /// The normal force of each copy.
    copies: Vec<usize>,
}

impl Cones {
    /// Those of the contacts among `blocks`.
    ///
    /// # Errors
    /// When a force that a cone bounds is not among the first `held` rows.
    fn of(blocks: &Blocks, held: usize) -> Result<Self, ResponseError> {
        let mut own = Self { scales: vec![1.0; held], ..Self::default() };
        let scales: Vec<f64> = blocks.scales().collect();
        let mut first = 0;
        for law in blocks.laws() {
            let range = first..first + law.rows();
            first = range.end;
            let (rows, scales) = match (blocks.rows().get(range.clone()), scales.get(range)) {
                (Some(rows), Some(scales)) if law.pushes() => (rows, scales),
                _ => continue,
            };
            let parts = law.parts().into_iter().filter(|(rows, part)| !rows.is_empty() && !part.slides);
            let mut cones: Vec<_> = parts.collect();
            if cones.is_empty() {
                cones.push(Default::default());
            }
            for (place, (part, law)) in cones.into_iter().enumerate() {
                let bounded = rows[part.clone()].to_vec();
                if let Some(&row) = bounded.iter().chain(&rows[..1]).find(|&&row| row >= held) {
                    return Err(ResponseError::UnknownRow { row, rows: held });
                }
                bounded.iter().zip(&scales[part]).for_each(|(&row, scale)| own.scales[row] = *scale);
                let normal = if place == 0 { rows[0] } else { own.copy(rows[0]) };
                own.of_contacts.push(ForceCone { normal, bounded, friction: law.friction });
            }
        }
        Ok(own)
    }

    /// A copy of the normal force of a row.
    fn copy(&mut self, normal: usize) -> usize {
        self.copies.push(normal);
        self.scales.len() + self.copies.len() - 1
    }

    fn variables(&self) -> usize {
        self.scales.len() + self.copies.len()
    }

    /// Forces of the held rows as variables.
    fn variables_of(&self, forces: &[f64]) -> Vec<f64> {
        let own = forces.iter().zip(&self.scales).map(|(force, scale)| force / scale);
        let mut x: Vec<f64> = own.collect();
        x.extend(self.copies.iter().map(|&normal| forces[normal]));
        x
    }

    /// Whether variables lie in all cones, to rounding.
    fn contain(&self, x: &[f64]) -> bool {
        let rounding = EXCEEDED * largest(x);
        self.of_contacts.iter().all(|cone| {
            let normal = x[cone.normal];
            normal >= -rounding && cone.length(x) <= cone.friction * normal.max(0.0) + rounding
        })
    }

    /// The nearest variables in the cones, in place.
    fn project(&self, x: &mut [f64]) {
        for cone in &self.of_contacts {
            cone.project(x);
        }
    }
}

impl ForceCone {
    fn length(&self, x: &[f64]) -> f64 {
        self.bounded.iter().fold(0.0, |sum: f64, &row| libm::hypot(sum, x[row]))
    }

    fn project(&self, x: &mut [f64]) {
        let (normal, size, friction) = (x[self.normal], self.length(x), self.friction);
        if normal >= 0.0 && size <= friction * normal {
            return;
        }
        let projected = ((normal + friction * size) / (1.0 + friction * friction)).max(0.0);
        x[self.normal] = projected;
        let share = if size > 0.0 { friction * projected / size } else { 0.0 };
        self.bounded.iter().for_each(|&row| x[row] *= share);
    }

    /// `V d` in place of the direction `d`, with `V` the derivative of the projection at `x`, which is symmetric.
    fn differentiate(&self, x: &[f64], d: &mut [f64]) {
        let (normal, size, friction) = (x[self.normal], self.length(x), self.friction);
        if normal >= 0.0 && size <= friction * normal {
            return;
        }
        let projected = (normal + friction * size) / (1.0 + friction * friction);
        if projected <= 0.0 || size == 0.0 {
            d[self.normal] = if projected > 0.0 { d[self.normal] / (1.0 + friction * friction) } else { 0.0 };
            self.bounded.iter().for_each(|&row| d[row] = 0.0);
            return;
        }
        let along: f64 = self.bounded.iter().map(|&row| x[row] / size * d[row]).sum();
        let change = (d[self.normal] + friction * along) / (1.0 + friction * friction);
        d[self.normal] = change;
        let share = friction * projected / size;
        for &row in &self.bounded {
            let axis = x[row] / size;
            d[row] = friction * change * axis + share * (d[row] - along * axis);
        }
    }
}

/// The least forces (N) of all rows of a problem within the cones of `blocks` that hold what `forces` hold: the first
/// `held` rows, with friction along the rows of `sliding` behind them. `forces` themselves where they lie in the cones;
/// none where no forces do.
///
/// ```
/// use polhode_response::{Blocks, ContactProblem, Law, SlidingRow, least_forces_in_cones};
/// // A plate of 1 kg on two feet at one place, one of them with friction 0.1: least norm shares the weight of 10 N
/// // and the push of 1 N evenly between the rows, more than the rough foot bears.
/// let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0])?;
/// problem.push_row(&[(0, &[0.0, 1.0])])?;
/// problem.push_row(&[(0, &[0.0, 1.0])])?;
/// problem.push_held_row(&[(0, &[1.0, 0.0])])?;
/// let mut blocks = Blocks::default();
/// blocks.push(Law::Push, [0]);
/// blocks.push(Law::Cone { rows: 2, friction: 0.125 }, [1, 2]);
/// let forces = least_forces_in_cones(&problem.delassus(), 3, &[], &blocks, &[5.0, 5.0, 1.0])?;
/// let forces = forces.ok_or("there are forces in the cones")?;
/// assert!((forces[0] - 2.0).abs() < 1e-12 && (forces[1] - 8.0).abs() < 1e-12 && (forces[2] - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When lengths differ, a row does not exist, or a number is not finite.
#[cfg_attr(feature = "census", track_caller)]
pub fn least_forces_in_cones(
    delassus: &Delassus,
    held: usize,
    sliding: &[SlidingRow],
    blocks: &Blocks,
    forces: &[f64],
) -> Result<Option<Vec<f64>>, ResponseError> {
    delassus.check_finite()?;
    check_finite("forces", forces)?;
    let rows = delassus.len();
    check_length("forces", rows, forces.len())?;
    check_length("rows held and sliding", rows, held + sliding.len())?;
    check_rows(sliding, held, rows)?;
    let cones = Cones::of(blocks, held)?;
    let first = cones.variables_of(&forces[..held]);
    #[cfg(feature = "census")]
    let size = Size { bodies: 0, rows, cones: cones.of_contacts.len() };
    if cones.contain(&first) {
        #[cfg(feature = "census")]
        census::note_single(Chain::LeastInCones, size, "as they are", SolverStatus::Solved, 0.0);
        return Ok(Some(forces.to_vec()));
    }
    let dual = Dual::new(delassus, sliding, &cones, &first);
    if dual.determines_forces() {
        #[cfg(feature = "census")]
        census::note_single(Chain::LeastInCones, size, "determined", SolverStatus::Infeasible, 0.0);
        return Ok(None);
    }
    let minimum = dual.minimise();
    #[cfg(feature = "census")]
    {
        let status = if minimum.is_some() { SolverStatus::Solved } else { SolverStatus::Inaccurate };
        census::note_single(Chain::LeastInCones, size, "dual newton", status, 0.0);
    }
    let Some(x) = minimum else { return Ok(None) };
    let mut found: Vec<f64> = x.iter().zip(&cones.scales).map(|(x, scale)| x * scale).collect();
    found.resize(rows, 0.0);
    for slide in sliding {
        found[slide.tangent] -= slide.coefficient * found[slide.normal];
    }
    Ok(Some(found))
}

/// The dual function, in an orthonormal basis of the constraints.
struct Dual<'a> {
    cones: &'a Cones,
    factor: PivotedQr,
    /// `Q^T f_0`.
    wanted: Vec<f64>,
    /// The largest of `f_0`, N.
    scale: f64,
}

impl<'a> Dual<'a> {
    fn new(delassus: &Delassus, sliding: &[SlidingRow], cones: &'a Cones, first: &[f64]) -> Self {
        let (held, variables) = (cones.scales.len(), cones.variables());
        let accelerations = held_by_forces(delassus, held, sliding);
        let mut constraints = Vec::with_capacity(variables * variables);
        for (row, line) in accelerations.chunks_exact(held.max(1)).enumerate() {
            // Rows of one size, so that light and heavy bodies count alike.
            let diagonal = delassus.get(row, row);
            let row_scale = if diagonal > 0.0 { 1.0 / diagonal.sqrt() } else { 0.0 };
            constraints.extend(line.iter().zip(&cones.scales).map(|(entry, scale)| entry * scale * row_scale));
            constraints.resize((row + 1) * variables, 0.0);
        }
        for (copy, &normal) in cones.copies.iter().enumerate() {
            let start = constraints.len();
            constraints.resize(start + variables, 0.0);
            constraints[start + normal] = 1.0;
            constraints[start + held + copy] = -1.0;
        }
        let factor = PivotedQr::factor(variables, held + cones.copies.len(), constraints, DEPENDENT);
        let mut wanted = first.to_vec();
        factor.apply_transpose(&mut wanted);
        wanted.truncate(factor.rank());
        Self { cones, factor, wanted, scale: largest(first) }
    }

    /// Whether no other forces hold the same.
    fn determines_forces(&self) -> bool {
        self.factor.rank() == self.cones.variables()
    }

    /// `Q y`.
    fn spread(&self, y: &[f64]) -> Vec<f64> {
        let mut x = y.to_vec();
        x.resize(self.cones.variables(), 0.0);
        self.factor.apply(&mut x);
        x
    }

    /// `Q^T x`.
    fn gather(&self, mut x: Vec<f64>) -> Vec<f64> {
        self.factor.apply_transpose(&mut x);
        x.truncate(self.factor.rank());
        x
    }

    fn projected(&self, x: &[f64]) -> Vec<f64> {
        let mut projected = x.to_vec();
        self.cones.project(&mut projected);
        projected
    }

    /// What the dual function is at `y`, whose projected forces are these.
    fn value(&self, y: &[f64], projected: &[f64]) -> f64 {
        dot(projected, projected) / 2.0 - dot(y, &self.wanted)
    }

    /// The forces at the minimum; none where Newton's method does not come there.
    fn minimise(&self) -> Option<Vec<f64>> {
        let mut y = self.wanted.clone();
        for _ in 0..MOST_NEWTON_STEPS {
            let spread = self.spread(&y);
            let projected = self.projected(&spread);
            let gradient: Vec<f64> =
                self.gather(projected.clone()).iter().zip(&self.wanted).map(|(own, wanted)| own - wanted).collect();
            if largest(&gradient) <= rounding::HUNDREDS_OF_TERMS * self.scale {
                return Some(projected);
            }
            let step = self.newton_step(&spread, &gradient)?;
            let slope = dot(&step, &gradient);
            let value = self.value(&y, &projected);
            let slack = f64::ROUNDING * (value.abs() + dot(&projected, &projected));
            let shorter = |length: f64| {
                let tried: Vec<f64> = y.iter().zip(&step).map(|(y, step)| y + length * step).collect();
                let found = self.value(&tried, &self.projected(&self.spread(&tried)));
                (found <= value + DECREASE * length * slope + slack).then_some(tried)
            };
            // A length that is rounding of the whole step is no step.
            let halved = |length: &f64| Some(0.5 * length).filter(|length| *length > rounding::FEW_TERMS);
            y = std::iter::successors(Some(1.0), halved).find_map(shorter)?;
        }
        None
    }

    /// `-H^-1 g` with `H = Q^T V Q`; none where the numbers are not finite.
    fn newton_step(&self, spread: &[f64], gradient: &[f64]) -> Option<Vec<f64>> {
        let rank = gradient.len();
        let column = |place: usize| {
            let mut unit = vec![0.0; rank];
            unit[place] = 1.0;
            let mut direction = self.spread(&unit);
            self.cones.of_contacts.iter().for_each(|cone| cone.differentiate(spread, &mut direction));
            self.gather(direction)
        };
        let damping = (largest(gradient) / self.scale).max(LEAST_DUAL_DAMPING);
        let mut factor = GrowingCholesky::default();
        factor.reset(rank);
        for row in 0..rank {
            let own = column(row);
            let mut line = own[..row].to_vec();
            factor.solve_lower(&mut line);
            let pivot = own[row] + damping - dot(&line, &line);
            if !pivot.is_finite() {
                return None;
            }
            factor.push(&line, pivot.max(LEAST_DUAL_DAMPING));
        }
        let mut step: Vec<f64> = gradient.iter().map(|g| -g).collect();
        factor.solve(&mut step);
        Some(step)
    }
}

#[cfg(test)]
mod tests {
    //! The forces lie in the cones, hold what the given ones hold, and are the least that do: no direction that changes
    //! neither the held accelerations nor leaves a cone makes them smaller.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::{ContactProblem, Law};

    /// A block of 1 kg that a wall with friction 0.5 pushes over a floor, in a plane: the floor's friction is `mu`
    /// times what it bears, and what the wall lifts is at most half of its push.
    fn pushed_block() -> ContactProblem {
        let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0]).unwrap();
        problem.push_row(&[(0, &[0.0, 1.0])]).unwrap();
        problem.push_row(&[(0, &[1.0, 0.0])]).unwrap();
        problem.push_held_row(&[(0, &[0.0, 1.0])]).unwrap();
        problem.push_held_row(&[(0, &[1.0, 0.0])]).unwrap();
        problem
    }

    fn pushed_blocks(wall: f64, floor: f64) -> Blocks {
        let mut blocks = Blocks::default();
        blocks.push(Law::Slide { friction: floor }, [0, 3]);
        blocks.push(Law::Cone { rows: 2, friction: wall }, [1, 2]);
        blocks
    }

    /// Least norm lets the wall lift more than its friction bears; within the cones it lifts just that:
    /// `N = W - mu_w P`, `P = mu N`.
    #[test]
    fn a_wall_that_pushes_a_block_lifts_at_most_what_its_friction_bears() {
        let (problem, weight) = (pushed_block(), 2.0);
        for (floor, wall) in [(0.5, 0.5), (0.5, 0.25), (3.0, 0.125)] {
            let sliding = [SlidingRow { normal: 0, tangent: 3, coefficient: floor }];
            let b = [-weight, 0.0, -weight];
            let free = crate::least_norm_sliding_forces(&problem, &problem.delassus(), &b, &sliding).unwrap().forces;
            let blocks = pushed_blocks(wall, floor);
            let found = least_forces_in_cones(&problem.delassus(), 3, &sliding, &blocks, &free).unwrap();
            let Some(found) = found else { panic!("there are forces in the cones") };
            let normal = weight / (1.0 + wall * floor);
            assert!(free[2] > wall * free[1] && (found[0] - normal).abs() < 1e-12, "{free:?} {found:?}");
            assert!((found[1] - floor * normal).abs() < 1e-12 && (found[2] - wall * floor * normal).abs() < 1e-12);
        }
    }

    /// What lies in the cones stays as it is, bit by bit; where no forces lie in them there is none.
    #[test]
    fn forces_in_the_cones_stay_and_impossible_ones_are_refused() {
        let (problem, floor) = (pushed_block(), 0.5);
        let sliding = [SlidingRow { normal: 0, tangent: 3, coefficient: floor }];
        let forces = [1.7, 0.85, 0.3, -0.85];
        let blocks = pushed_blocks(0.5, floor);
        let found = least_forces_in_cones(&problem.delassus(), 3, &sliding, &blocks, &forces).unwrap();
        assert_eq!(found.as_deref(), Some(&forces[..]));
        // The block hangs on the wall, which it does not press.
        let mut alone = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0]).unwrap();
        alone.push_row(&[(0, &[1.0, 0.0])]).unwrap();
        alone.push_held_row(&[(0, &[0.0, 1.0])]).unwrap();
        let mut hanging = Blocks::default();
        hanging.push(Law::Cone { rows: 2, friction: 0.5 }, [0, 1]);
        assert!(least_forces_in_cones(&alone.delassus(), 2, &[], &hanging, &[0.0, 9.81]).unwrap().is_none());
    }

    /// A contact that resists its slip and its spinning: each has the whole normal force to itself.
    #[test]
    fn slip_and_spinning_are_bounded_apart() {
        let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        problem.push_row(&[(0, &[0.0, 1.0, 0.0])]).unwrap();
        problem.push_row(&[(0, &[0.0, 1.0, 0.0])]).unwrap();
        problem.push_held_row(&[(0, &[1.0, 0.0, 0.0])]).unwrap();
        problem.push_held_row(&[(0, &[0.0, 0.0, 1.0])]).unwrap();
        let resists = |friction: f64| crate::Resistance { rows: 1, friction, slides: false };
        let mut blocks = Blocks::default();
        blocks.push(Law::Push, [0]);
        blocks.push(Law::Resist { parts: [resists(0.25), crate::Resistance::default(), resists(0.125)] }, [1, 2, 3]);
        let found = least_forces_in_cones(&problem.delassus(), 4, &[], &blocks, &[5.0, 5.0, 1.0, 1.0]).unwrap();
        let found = found.unwrap();
        assert!([2.0, 8.0, 1.0, 1.0].iter().zip(&found).all(|(wanted, own)| (wanted - own).abs() < 1e-12), "{found:?}");
    }
}
