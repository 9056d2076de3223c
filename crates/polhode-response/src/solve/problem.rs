//! What is asked of the door: rows, what is known of them, and what is kept from one solve to the next.

use crate::complementarity::{ComplementaritySolver, WarmStart};
use crate::delassus::Delassus;
use crate::problem::ContactProblem;
use std::ops::Range;

/// What is asked of rows, never how.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Ask {
    /// Forces at one instant.
    Instant,
    /// Impulses of a time step.
    Step,
    /// Displacements out of overlaps.
    Displacement {
        /// How exactly they are worth being found, relative to the largest overlap (no unit).
        accuracy: f64,
    },
}

/// Rows, and what is known of them.
#[derive(Debug, Clone)]
pub struct RowProblem<'a> {
    /// Bodies and rows.
    pub rows: &'a ContactProblem,
    /// Those of the rows that are of joints.
    pub joints: Range<usize>,
    /// `b`: accelerations without forces (m/s^2), velocities without impulses (m/s), or gaps (m), one for each row.
    pub constants: &'a [f64],
    /// The rows that bore something in a similar problem.
    pub start: Option<&'a WarmStart>,
    /// Rounding that the constant terms carry already, in their unit.
    pub noise_floor: f64,
}

impl<'a> RowProblem<'a> {
    /// Rows with constant terms, none of which is known to be of a joint.
    pub const fn new(rows: &'a ContactProblem, constants: &'a [f64]) -> Self {
        Self { rows, joints: 0..0, constants, start: None, noise_floor: 0.0 }
    }
}

/// What solves keep from one to the next: room for their numbers. It changes no answer.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    pub(super) active_set: ComplementaritySolver,
    pub(super) delassus: Delassus,
}

impl Memory {
    /// The solver of the impact laws, which strike rows one after the other.
    pub fn active_set(&mut self) -> &mut ComplementaritySolver {
        &mut self.active_set
    }
}
