//! What is asked of the door: rows, what is known of them, and what is kept from one solve to the next.

use crate::complementarity::{ComplementaritySolver, WarmStart};
use crate::delassus::Delassus;
use crate::friction::Blocks;
use crate::problem::ContactProblem;
use std::fmt::{self, Debug, Formatter};
use std::ops::Range;

/// What is asked of rows, never how.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Ask<'a> {
    /// Forces at one instant: which contacts hold, stick and slide follows from them.
    Instant,
    /// The same where nothing goes on from them: of many contacts any forces that their laws allow.
    Present,
    /// Forces of bodies at rest, which stay so if any forces can hold them.
    Rest {
        /// Accelerations of the bodies without forces, in blocks of the problem's width.
        free: &'a [f64],
    },
    /// Forces that are a certificate of rest: within the cones, and balanced on each body to rounding. Not solved where
    /// none were found: the bodies may move.
    Balance {
        /// Accelerations of the bodies without forces, in blocks of the problem's width.
        free: &'a [f64],
    },
    /// Forces at a stage of a step, where contacts hold or slide as their laws say: of least norm, within cones where
    /// some slide.
    Stage,
    /// Impulses of a time step.
    Step,
    /// Displacements out of overlaps.
    Displacement {
        /// How exactly they are worth being found, relative to the largest overlap (no unit).
        accuracy: f64,
    },
}

/// Rows, and what is known of them.
#[derive(Clone)]
pub struct RowProblem<'a> {
    /// Bodies and rows.
    pub rows: &'a ContactProblem,
    /// The laws of the rows; none where those are said with the rows.
    pub blocks: Option<&'a Blocks>,
    /// Those of the rows that are of joints.
    pub joints: Range<usize>,
    /// `b`: accelerations without forces (m/s^2), velocities without impulses (m/s), or gaps (m), one for each row; at
    /// a stage, of the rows that are held.
    pub constants: &'a [f64],
    /// The rows that bore something in a similar problem.
    pub start: Option<&'a WarmStart>,
    /// Rounding that the constant terms carry already, in their unit.
    pub noise_floor: f64,
}

impl<'a> RowProblem<'a> {
    /// Rows with constant terms, none of which is known to be of a joint.
    pub const fn new(rows: &'a ContactProblem, constants: &'a [f64]) -> Self {
        Self { rows, blocks: None, joints: 0..0, constants, start: None, noise_floor: 0.0 }
    }
}

impl Debug for RowProblem<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        let mut shown = formatter.debug_struct("RowProblem");
        shown.field("rows", self.rows).field("blocks", &self.blocks).field("constants", &self.constants);
        shown.finish_non_exhaustive()
    }
}

/// What solves keep from one to the next: room for their numbers. It changes no answer.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    pub(super) active_set: ComplementaritySolver,
    pub(super) delassus: Delassus,
}
