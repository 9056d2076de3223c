//! Blocks of rows: for which rows of a problem each law is stated.
//!
//! The rows of a block need not follow each other: a problem may hold all normal rows first, and those along tangents
//! after them. Rows may be scaled within their blocks, so that an ellipse of friction along and across a grain becomes
//! a circle; what comes out is scaled back, and in the order of the rows of the problem.
//!
//! Assumption: no row is in two blocks. Failure: a block with another number of rows than its law has is refused where
//! the problem is made.

use crate::delassus::Delassus;
use crate::error::{ResponseError, check_length};
use crate::friction::block_matrix::BlockMatrix;
use crate::friction::linearisation::ContactStatus;
use crate::friction::problem::FrictionProblem;
use crate::friction::rows_behind::RowsBehind;
use crate::friction::settings::FrictionSettings;
use crate::friction::solution::{FrictionMethod, FrictionSolution};
use crate::friction::solver::solve_friction;
use crate::law::{Law, Resistance};
use crate::problem::ContactProblem;
use crate::report::{Method, SolverReport};
use std::ops::Range;
use std::sync::Arc;

/// Rows that are held together in one block: those of a point.
const HELD_TOGETHER: usize = 3;

/// A rotation that a contact may resist beside its slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResistedPart {
    /// About two axes in the tangent plane.
    Rolling,
    /// About the normal.
    Spinning,
}

/// Which rows of a problem each law is stated for.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Blocks {
    laws: Vec<Law>,
    /// The rows of the problem, in the order of the blocks.
    rows: Vec<usize>,
    /// What the reaction along each row is multiplied by in its block (no unit); empty while all are 1.
    scales: Vec<f64>,
}

/// Reactions and velocities (forces and accelerations) of all rows, in the order of the problem.
#[derive(Debug, Clone, PartialEq)]
pub struct BlocksSolution {
    /// N s (N); zero of rows without a block.
    pub reactions: Vec<f64>,
    /// m/s (m/s^2); zero of rows without a block.
    pub velocities: Vec<f64>,
    /// What the contact of each block does.
    pub statuses: Vec<ContactStatus>,
    /// What it does in its slip, its rolling and its spinning; open for what it does not resist.
    pub parts: Vec<[ContactStatus; 3]>,
    /// The certificate.
    pub report: SolverReport,
}

impl Blocks {
    /// The blocks of a problem: those of [`ContactProblem::push_block`] with friction, and all other rows one by one.
    pub fn of(problem: &ContactProblem) -> Self {
        let mut blocks = Self::default();
        let (mut row, mut frictional) = (0, problem.frictional().iter().peekable());
        while row < problem.len() {
            let law = match frictional.next_if(|(first, _)| *first == row) {
                Some((_, law)) => *law,
                None if problem.is_bilateral(row) => Law::Hold { rows: 1 },
                None => Law::Push,
            };
            blocks.push(law, row..row + law.rows());
            row += law.rows();
        }
        blocks
    }

    /// Adds a block of these rows of the problem.
    pub fn push(&mut self, law: Law, rows: impl IntoIterator<Item = usize>) {
        self.laws.push(law);
        self.rows.extend(rows);
        if !self.scales.is_empty() {
            self.scales.resize(self.rows.len(), 1.0);
        }
    }

    /// Adds rows that are held, whatever the sign of their reactions: a few of them in each block.
    pub fn hold(&mut self, rows: Range<usize>) {
        for start in rows.clone().step_by(HELD_TOGETHER) {
            let end = (start + HELD_TOGETHER).min(rows.end);
            self.push(Law::Hold { rows: end - start }, start..end);
        }
    }

    /// Adds a block whose reactions are multiplied by these numbers (no unit, above 0); rows beyond them are not
    /// scaled.
    pub fn push_scaled(
        &mut self,
        law: Law,
        rows: impl IntoIterator<Item = usize>,
        scales: impl IntoIterator<Item = f64>,
    ) {
        self.scales.resize(self.rows.len(), 1.0);
        self.scales.extend(scales);
        self.push(law, rows);
    }

    /// The contact of the last block resists a rotation as well, along these rows of the problem. Rows that are held
    /// have no normal reaction that could resist: they stay as they are.
    pub fn resist(&mut self, part: ResistedPart, resistance: Resistance, rows: impl IntoIterator<Item = usize>) {
        let Some(law) = self.laws.last_mut() else { return };
        if !law.pushes() {
            return;
        }
        let mut parts = law.parts().map(|(_, part)| part);
        let place = match part {
            ResistedPart::Rolling => 1,
            ResistedPart::Spinning => 2,
        };
        parts[place] = resistance;
        *law = Law::Resist { parts };
        self.rows.extend(rows);
        if !self.scales.is_empty() {
            self.scales.resize(self.rows.len(), 1.0);
        }
    }

    /// Adds the block of a number of this list to another list.
    pub fn push_to(&self, other: &mut Self, block: usize) {
        let first: usize = self.laws.iter().take(block).map(|law| law.rows()).sum();
        let Some(&law) = self.laws.get(block) else { return };
        let own = first..first + law.rows();
        let rows = self.rows.get(own.clone()).unwrap_or_default().iter().copied();
        match self.scales.get(own) {
            Some(scales) => other.push_scaled(law, rows, scales.iter().copied()),
            None => other.push(law, rows),
        }
    }

    /// How many blocks.
    pub fn len(&self) -> usize {
        self.laws.len()
    }

    /// Whether there is no block.
    pub fn is_empty(&self) -> bool {
        self.laws.is_empty()
    }

    /// That each law can be stated, for rows of a problem of so many.
    ///
    /// # Errors
    /// A row that does not exist, another number of rows than the law has, a coefficient that is none.
    pub(crate) fn check(&self, rows: usize) -> Result<(), ResponseError> {
        let mut expected = 0;
        for (block, law) in self.laws.iter().enumerate() {
            law.check(block)?;
            expected += law.rows();
        }
        check_length("rows of blocks", expected, self.rows.len())?;
        let unknown = self.rows.iter().find(|&&row| row >= rows);
        unknown.map_or(Ok(()), |&row| Err(ResponseError::UnknownRow { row, rows }))
    }

    /// That each of so many rows is in one block.
    ///
    /// # Errors
    /// The first row that is in none, or in several.
    pub(crate) fn check_whole(&self, rows: usize) -> Result<(), ResponseError> {
        let mut counts = vec![0; rows];
        for row in &self.rows {
            counts[*row] += 1;
        }
        let wrong = counts.iter().position(|count| *count != 1);
        wrong.map_or(Ok(()), |row| Err(ResponseError::BlocksOfRow { row, blocks: counts[row] }))
    }

    /// How many of them are contacts.
    pub(crate) fn contacts(&self) -> usize {
        self.laws.iter().filter(|law| law.pushes()).count()
    }

    /// Whether some contact has rows that friction acts along.
    pub(crate) fn have_friction(&self) -> bool {
        self.laws.iter().any(|law| law.has_friction())
    }

    /// The law of each block.
    pub fn laws(&self) -> &[Law] {
        &self.laws
    }

    /// The rows of the problem, in the order of the blocks.
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// What the reaction along each row is multiplied by in its block, in their order.
    pub fn scales(&self) -> impl Iterator<Item = f64> + '_ {
        self.scales.iter().copied().chain(std::iter::repeat(1.0)).take(self.rows.len())
    }

    /// The problem of these blocks; `delassus` and `constants` are of the rows of the problem.
    ///
    /// # Errors
    /// Those of [`FrictionProblem::new`], and when a row does not exist.
    pub fn problem(&self, delassus: &Delassus, constants: &[f64]) -> Result<FrictionProblem, ResponseError> {
        self.check(delassus.len().min(constants.len()))?;
        let sizes: Vec<usize> = self.laws.iter().map(|law| law.rows()).collect();
        let matrix = BlockMatrix::from_entries(&sizes, |i, j| {
            let entry = delassus.get(self.rows[i], self.rows[j]);
            if self.scales.is_empty() { entry } else { entry * (self.scales[i] * self.scales[j]) }
        })?;
        let behind = |rows: &Arc<ContactProblem>| RowsBehind {
            problem: rows.clone(),
            rows: self.rows.clone(),
            scales: self.scales().collect(),
        };
        let rows = delassus.rows().map(behind);
        let problem = FrictionProblem::new(self.laws.clone(), matrix, self.velocities_in_blocks(constants))?;
        #[cfg(feature = "census")]
        let problem = problem.with_origin(delassus.origin().map(behind));
        Ok(problem.with_rows(rows))
    }

    /// Reactions in the order of the blocks, put into that of the problem; rows without a block have zero.
    pub fn reactions_in_rows(&self, in_blocks: &[f64]) -> Vec<f64> {
        self.in_rows(in_blocks, |value, scale| value * scale)
    }

    /// Velocities in the order of the blocks, put into that of the problem, likewise.
    pub fn velocities_in_rows(&self, in_blocks: &[f64]) -> Vec<f64> {
        self.in_rows(in_blocks, |value, scale| value / scale)
    }

    /// Velocities in the order of the problem, put into that of the blocks; zero of rows that do not exist.
    pub fn velocities_in_blocks(&self, in_rows: &[f64]) -> Vec<f64> {
        let mut in_blocks: Vec<f64> = self.rows.iter().map(|&row| in_rows.get(row).copied().unwrap_or(0.0)).collect();
        in_blocks.iter_mut().zip(&self.scales).for_each(|(value, scale)| *value *= scale);
        in_blocks
    }

    fn in_rows(&self, in_blocks: &[f64], unscaled: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let rows = self.rows.iter().max().map_or(0, |row| row + 1);
        let mut in_rows = vec![0.0; rows];
        for ((&row, &value), scale) in self.rows.iter().zip(in_blocks).zip(self.scales()) {
            in_rows[row] = unscaled(value, scale);
        }
        in_rows
    }

    /// Solves for the reactions of all rows; `start` are those of a similar problem.
    ///
    /// ```
    /// use polhode_response::friction::FrictionSettings;
    /// use polhode_response::{Blocks, ContactProblem, Law};
    /// // A point of 2 kg on a floor of friction 0.5, pushed down with 3 m/s and along with 4 m/s.
    /// let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
    /// problem.push_row(&[(0, &[0.0, 1.0])])?;
    /// problem.push_held_row(&[(0, &[1.0, 0.0])])?;
    /// let mut blocks = Blocks::default();
    /// blocks.push(Law::Cone { rows: 2, friction: 0.5 }, [0, 1]);
    /// let solved = blocks.solve(&problem.delassus(), &[-3.0, 4.0], None, &FrictionSettings::default())?;
    /// assert_eq!(solved.velocities, [0.0, 2.5]);
    /// # Ok::<(), polhode_response::ResponseError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`problem`](Self::problem) and [`solve_friction`].
    #[cfg_attr(feature = "census", track_caller)]
    pub fn solve(
        &self,
        delassus: &Delassus,
        constants: &[f64],
        start: Option<&[f64]>,
        settings: &FrictionSettings,
    ) -> Result<BlocksSolution, ResponseError> {
        let problem = self.problem(delassus, constants)?;
        let mut first = vec![0.0; self.rows.len()];
        if let Some(start) = start {
            let of_rows = self.rows.iter().map(|&row| start.get(row).copied().unwrap_or(0.0));
            first.iter_mut().zip(of_rows).zip(self.scales()).for_each(|((first, own), scale)| *first = own / scale);
        }
        Ok(self.solution(solve_friction(&problem, Some(&first), settings)?))
    }

    fn solution(&self, solved: FrictionSolution) -> BlocksSolution {
        let report = SolverReport {
            status: solved.report.status,
            method: in_general(solved.report.method),
            tried: solved.report.tried.iter().map(in_general).collect(),
            iterations: solved.report.iterations(),
            residual: solved.report.residual,
            rounding: solved.report.rounding,
            ..SolverReport::default()
        };
        BlocksSolution {
            reactions: self.reactions_in_rows(&solved.reactions),
            velocities: self.velocities_in_rows(&solved.velocities),
            statuses: solved.statuses,
            parts: solved.parts,
            report,
        }
    }
}

/// A method of friction in the words of all problems.
const fn in_general(method: FrictionMethod) -> Method {
    match method {
        FrictionMethod::WarmNewton => Method::WarmStart,
        FrictionMethod::GaussSeidel | FrictionMethod::Newton | FrictionMethod::NewtonFromZero => Method::ActiveSet,
        _ => Method::ColdStart,
    }
}
