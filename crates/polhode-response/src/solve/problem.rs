//! What is asked of the door: rows, what is known of them, and what is kept from one solve to the next.

use crate::complementarity::{ComplementaritySolver, WarmStart};
use crate::delassus::Delassus;
use crate::friction::Blocks;
use crate::problem::ContactProblem;
use crate::sliding::SlidingFactors;
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
    /// Reactions of least norm with which all rows hold: of joints under given loads.
    Hold,
    /// The same by the matrix of all rows, with what they leave of the constant terms: not rounding where rows
    /// contradict each other, which is seen among all of them.
    HoldAll,
    /// Forces of contacts by the linear programmes of the thesis ([`least_force`](crate::least_force())).
    LeastForce,
    /// Forces of contacts by the guesses of the thesis ([`guesses`](crate::guesses())).
    Guesses,
}

/// What is known of rows.
#[derive(Debug, Clone, Copy, Default)]
pub struct Question<'a> {
    /// The laws of the rows; none where those are said with the rows.
    pub blocks: Option<&'a Blocks>,
    /// `b`: accelerations without forces (m/s^2), velocities without impulses (m/s), or gaps (m), one for each row; at
    /// a stage, of the rows that are held.
    pub constants: &'a [f64],
    /// The rows that bore something in a similar problem.
    pub start: Option<&'a WarmStart>,
    /// The forces of all rows in a problem that is nearly the same, with other constant terms.
    pub near: Option<&'a [f64]>,
    /// Rounding that the constant terms carry already, in their unit.
    pub noise_floor: f64,
    /// Whether the rows and their laws are those of the last question to the same [`Memory`].
    pub rows: Rows,
}

/// Whether rows are known already: what was made of them then serves other constant terms, and changes no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rows {
    /// They are not.
    #[default]
    New,
    /// They and their laws are those of the last question.
    AsBefore,
}

/// Rows, and what is known of them.
#[derive(Debug, Clone)]
pub struct RowProblem<'a> {
    /// Bodies and rows.
    pub rows: &'a ContactProblem,
    /// Those of the rows that are of joints.
    pub joints: Range<usize>,
    /// What is known of them.
    pub known: Question<'a>,
}

impl<'a> RowProblem<'a> {
    /// Rows with constant terms, none of which is known to be of a joint.
    pub fn new(rows: &'a ContactProblem, constants: &'a [f64]) -> Self {
        Self { rows, joints: 0..0, known: Question { constants, ..Question::default() } }
    }
}

/// What solves keep from one to the next: room for their numbers. It changes no answer.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    pub(super) active_set: ComplementaritySolver,
    pub(super) delassus: Delassus,
    /// Of rows at a stage where contacts slide.
    pub(super) sliding: Option<SlidingFactors>,
}
