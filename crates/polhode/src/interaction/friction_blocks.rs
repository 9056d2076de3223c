//! The rows of an assembly in the blocks that Coulomb's law is stated for.
//!
//! An assembly holds all normal rows first, then those of pivots, then those along tangents. The solver takes the rows of
//! one contact together. Solutions come back in the order of the assembly. Rows along and across a grain are scaled, so
//! that their ellipse of friction becomes a circle (`crate::collision::friction_ellipse`), and their solutions scaled
//! back.

use super::resisted_rotation::ResistedRotation;
use crate::collision::turn::Turn;
use crate::scene::FrictionEllipse;
use polhode_response::friction::{
    BlockMatrix, BlocksOfRows, ContactStatus, FrictionBlock, FrictionMethod, FrictionProblem, FrictionSettings,
    Resistance, solve_friction,
};
use polhode_response::{Delassus, Method, ResponseError, SolverReport};
use std::ops::Range;

/// Most rows of one block that is held.
const MOST_ROWS: usize = 3;

/// Blocks of rows.
#[derive(Debug, Clone, Default)]
pub(crate) struct FrictionBlocks {
    blocks: Vec<FrictionBlock>,
    /// The rows of the assembly, in the order of the blocks.
    rows: Vec<usize>,
    /// What each row is multiplied by, so that the ellipse of friction along and across a grain becomes a circle. Empty
    /// while all are 1.
    scales: Vec<f64>,
}

/// Reactions and velocities (forces and accelerations) of all rows, in the order of the assembly.
#[derive(Debug)]
pub(crate) struct RowSolution {
    pub(crate) reactions: Vec<f64>,
    pub(crate) velocities: Vec<f64>,
    /// What the block of each contact does.
    pub(crate) statuses: Vec<ContactStatus>,
    /// And its slip, rolling and spinning by themselves.
    pub(crate) parts: Vec<[ContactStatus; 3]>,
    pub(crate) report: SolverReport,
}

impl RowSolution {
    /// The direction, in the rows of a rotation, in which the bodies turn, or begin to turn; none while friction holds them. A
    /// moment opposes it; where nothing presses there is no moment, and the rotation follows its acceleration.
    pub(crate) fn direction_of(&self, rotation: &ResistedRotation) -> Option<Vec<f64>> {
        if rotation.turns {
            return Some(vec![1.0; rotation.rows.len()]);
        }
        let part = self.parts.get(rotation.normal).map(|[_, rolls, spins]| match rotation.turn {
            Turn::Rolling => *rolls,
            Turn::Spinning => *spins,
        });
        if part == Some(ContactStatus::Stick) {
            return None;
        }
        let own = |of: &[f64], sign: f64| {
            rotation.rows.clone().filter_map(|row| of.get(row)).map(|part| sign * part).collect::<Vec<f64>>()
        };
        unit(&own(&self.reactions, -1.0)).or_else(|| unit(&own(&self.velocities, 1.0)))
    }
}

/// A vector over its length; none of one that is zero.
fn unit(parts: &[f64]) -> Option<Vec<f64>> {
    let size = parts.iter().fold(0.0, |sum: f64, part| libm::hypot(sum, *part));
    (size > 0.0).then(|| parts.iter().map(|part| part / size).collect())
}

impl FrictionBlocks {
    /// Adds a block of these rows.
    pub(crate) fn push(&mut self, block: FrictionBlock, rows: impl Iterator<Item = usize>) {
        self.blocks.push(block);
        self.rows.extend(rows);
        if !self.scales.is_empty() {
            self.scales.resize(self.rows.len(), 1.0);
        }
    }

    /// Adds the block of a contact with its normal row and its tangents, friction along which lies in this ellipse.
    pub(crate) fn push_contact(&mut self, ellipse: FrictionEllipse, normal: usize, tangents: Range<usize>) {
        let block = FrictionBlock::Contact { rows: 1 + tangents.len(), friction: ellipse.largest() };
        if tangents.is_empty() || ellipse.is_circle() {
            return self.push(block, std::iter::once(normal).chain(tangents));
        }
        self.scales.resize(self.rows.len() + 1, 1.0);
        self.scales.extend(ellipse.scales().iter().take(tangents.len()));
        self.push(block, std::iter::once(normal).chain(tangents));
    }

    /// The same blocks with rotations that contacts resist, each in the block of its contact.
    pub(crate) fn with_rotations(self, rotations: &[ResistedRotation]) -> Self {
        if rotations.is_empty() {
            return self;
        }
        let mut whole = Self::default();
        let mut first = 0;
        for (place, &block) in self.blocks.iter().enumerate() {
            let rows = first..first + block.rows();
            first = rows.end;
            let own = rotations.iter().filter(|rotation| rotation.normal == place);
            whole.push(block, self.rows[rows.clone()].iter().copied());
            if !self.scales.is_empty() {
                whole.scales.resize(whole.rows.len(), 1.0);
                let start = whole.rows.len() - rows.len();
                whole.scales[start..].copy_from_slice(&self.scales[rows]);
            }
            for rotation in own {
                whole.resist(place, rotation);
            }
        }
        whole
    }

    /// Adds a rotation to the last block, which is that of its contact.
    fn resist(&mut self, block: usize, rotation: &ResistedRotation) {
        let slip = match self.blocks[block] {
            FrictionBlock::Contact { rows, friction } => Resistance { rows: rows - 1, friction, slides: false },
            FrictionBlock::Sliding { friction } => Resistance { rows: 1, friction, slides: true },
            FrictionBlock::Resisted { parts: [slip, ..] } => slip,
            FrictionBlock::Bilateral { .. } => return,
        };
        let mut parts = match self.blocks[block] {
            FrictionBlock::Resisted { parts } => parts,
            _ => [slip, Resistance::default(), Resistance::default()],
        };
        let place = match rotation.turn {
            Turn::Rolling => 1,
            Turn::Spinning => 2,
        };
        let ResistedRotation { friction, turns: slides, .. } = *rotation;
        parts[place] = Resistance { rows: rotation.rows.len(), friction, slides };
        self.blocks[block] = FrictionBlock::Resisted { parts };
        self.rows.extend(rotation.rows.clone());
        if !self.scales.is_empty() {
            self.scales.resize(self.rows.len(), 1.0);
        }
    }

    /// How many blocks.
    pub(crate) fn len(&self) -> usize {
        self.blocks.len()
    }

    /// Adds rows that are held, whatever the sign of their reactions.
    pub(crate) fn push_held(&mut self, rows: Range<usize>) {
        for start in rows.clone().step_by(MOST_ROWS) {
            let end = (start + MOST_ROWS).min(rows.end);
            self.push(FrictionBlock::Bilateral { rows: end - start }, start..end);
        }
    }

    /// The problem of these blocks: `delassus` and `constants` are of the rows of the assembly.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn problem(&self, delassus: &Delassus, constants: &[f64]) -> Result<FrictionProblem, ResponseError> {
        let sizes: Vec<usize> = self.blocks.iter().map(|block| block.rows()).collect();
        let matrix = BlockMatrix::from_entries(&sizes, |i, j| {
            let entry = delassus.get(self.rows[i], self.rows[j]);
            if self.scales.is_empty() { entry } else { entry * (self.scales[i] * self.scales[j]) }
        })?;
        FrictionProblem::new(self.blocks.clone(), matrix, self.of_rows(constants))
    }

    /// What the blocks ask of the rows of the assembly.
    pub(crate) fn of_rows_of_assembly(&self) -> BlocksOfRows<'_> {
        BlocksOfRows { blocks: &self.blocks, rows: &self.rows, scales: &self.scales }
    }

    /// Reactions in the order of the blocks, put into that of the assembly; rows without a block have zero.
    pub(crate) fn reactions_in_rows(&self, of_blocks: &[f64]) -> Vec<f64> {
        self.in_rows(of_blocks, |value, scale| value * scale)
    }

    /// Velocities in the order of the blocks, put into that of the assembly, likewise.
    pub(crate) fn velocities_in_rows(&self, of_blocks: &[f64]) -> Vec<f64> {
        self.in_rows(of_blocks, |value, scale| value / scale)
    }

    fn in_rows(&self, of_blocks: &[f64], unscaled: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let rows = self.rows.iter().max().map_or(0, |row| row + 1);
        let mut of_rows = vec![0.0; rows];
        let scales = self.scales.iter().copied().chain(std::iter::repeat(1.0));
        for ((&row, &value), scale) in self.rows.iter().zip(of_blocks).zip(scales) {
            of_rows[row] = unscaled(value, scale);
        }
        of_rows
    }

    /// Velocities of the rows of the assembly, put into the order of the blocks.
    pub(crate) fn of_rows(&self, of_rows: &[f64]) -> Vec<f64> {
        let mut of_blocks: Vec<f64> = self.rows.iter().map(|&row| of_rows[row]).collect();
        of_blocks.iter_mut().zip(&self.scales).for_each(|(value, scale)| *value *= scale);
        of_blocks
    }

    /// Solves for the reactions; `start` are reactions of a similar problem, in the order of the assembly.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn solve(
        &self,
        delassus: &Delassus,
        constants: &[f64],
        start: Option<&[f64]>,
        settings: &FrictionSettings,
    ) -> Result<RowSolution, ResponseError> {
        let problem = self.problem(delassus, constants)?;
        let mut first = vec![0.0; self.rows.len()];
        if let Some(start) = start {
            first.iter_mut().zip(&self.rows).for_each(|(first, &row)| *first = start[row]);
            first.iter_mut().zip(&self.scales).for_each(|(first, scale)| *first /= scale);
        }
        let solved = solve_friction(&problem, Some(&first), settings)?;
        let method = match solved.report.method {
            FrictionMethod::WarmNewton => Method::WarmStart,
            FrictionMethod::GaussSeidel | FrictionMethod::Newton => Method::ActiveSet,
            _ => Method::ColdStart,
        };
        let report = SolverReport {
            status: solved.report.status,
            method,
            iterations: solved.report.iterations(),
            residual: solved.report.residual,
            ..SolverReport::default()
        };
        Ok(RowSolution {
            reactions: self.reactions_in_rows(&solved.reactions),
            velocities: self.velocities_in_rows(&solved.velocities),
            statuses: solved.statuses,
            parts: solved.parts,
            report,
        })
    }
}
