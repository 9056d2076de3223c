//! Which matrix and which method solve a set of rows, by its size: all thresholds stand here, and nowhere else.
//!
//! | asked for | few | from | many |
//! |---|---|---|---|
//! | impulses of a step | the matrix of all rows | 16 contacts | the velocities of bodies |
//! | displacements out of overlaps | the matrix of all rows | 64 contacts | the displacements of bodies |
//! | forces on bodies at rest | the matrix of all rows, least norm | 100 contacts | the accelerations of bodies |
//! | any, beside joints | the matrix of all rows | 24 rows of joints, 100 with loops | trees are eliminated first |
//! | impulses of an impact with friction | the matrix of all rows | 144 rows | the velocities of bodies |
//! | forces, impulses of steps, displacements | | 4000 rows | no matrix: the velocities of bodies |
//! | impacts, rows that hold, forces by the thesis | the matrix of all rows | 4000 rows | an error |
//!
//! The matrix of `n` rows takes `n^2` numbers and its factors `n^3` products; factors of bodies take as many as there
//! are bodies and contacts between them. Where one way does not come to the residual asked for, the other is tried,
//! unless the rows are too many for their matrix. Measured by `cargo xtask census` (docs/census.md) and the benches of
//! this crate.

use crate::problem::ContactProblem;
use crate::sparse::{HeldForest, are_movable};
use std::ops::Range;

/// From so many contacts in a group on the impulses of a step are found in the velocities of bodies (8 to 50).
pub(super) const STEP_IN_BODIES: usize = 16;

/// Most rows whose matrix is formed where the velocities of bodies were not solved for exactly enough (200 to 600).
pub(super) const STEP_MOST_ROWS: usize = 400;

/// From so many contacts in a group on overlaps are removed in the displacements of bodies (48 to 200).
pub(super) const DISPLACEMENT_IN_BODIES: usize = 64;

/// From so many contacts on bodies at rest are held by forces found in their accelerations (50 to 300): of fewer the
/// matrix of all rows is small, and its forces are the least ones.
const REST_IN_BODIES: usize = 100;

/// From so many rows of joints on they are eliminated first (15 to 60).
const TREES: usize = 24;

/// The same where some of them close loops (60 to 200): the rows of a mechanism may depend on each other, and which of
/// them do is seen best among all of them.
const TREES_WITH_LOOPS: usize = 100;

/// From so many rows with friction on an impact is solved for in the velocities of bodies (100 to 300): with as many
/// the factors of the matrix of rows take longer than those of the bodies. The rows are kept beside it for that.
pub(crate) const IMPACT_IN_BODIES: usize = 144;

/// Most rows of an impact whose matrix is factorised where the velocities of bodies were not solved for exactly enough
/// (200 to 600).
pub(crate) const IMPACT_MOST_ROWS: usize = 400;

/// Most rows whose matrix is formed (2000 to 8000): it has 128 MB then, and its factorisation takes 2e10 products.
pub(super) const MATRIX_MOST_ROWS: usize = 4000;

/// Most rows for Newton's method with steps of least norm, whose factorisation is dense.
pub(crate) const LEAST_NORM_MOST_ROWS: usize = 120;

/// Rows of a front from which on its nodes are reduced (48 to 144): elimination of smaller ones costs less than
/// reduction.
pub(crate) const REDUCED_FRONT: usize = 96;

/// Rows up to which the dense factor of a programme over cones is formed.
pub(crate) const CONE_PROGRAMME_MOST_ROWS: usize = 1500;

/// Coordinates of the velocity of a body in space.
const SPACE_WIDTH: usize = 6;

/// Two bodies with more contacts than this have many (no unit, 26 to 64): more than any two of the basic shapes have.
const MANY_OF_A_PAIR: usize = 32;

/// Whether so many contacts of a group are many: the impulses of a step are then found in the velocities of bodies.
pub const fn are_many(contacts: usize) -> bool {
    contacts >= STEP_IN_BODIES
}

/// Whether so many contacts of a problem are many, and can be solved for in the velocities of bodies.
pub fn is_in_bodies(problem: &ContactProblem, contacts: usize) -> bool {
    are_many(contacts) && is_plain(problem)
}

/// Whether the contacts of bodies at rest are many; in a plane, where a velocity has fewer coordinates, each counts as
/// two.
pub(super) fn is_many_at_rest(problem: &ContactProblem, contacts: usize) -> bool {
    let each_for = if problem.width() < SPACE_WIDTH { 2 } else { 1 };
    each_for * contacts >= REST_IN_BODIES
}

/// Whether so many rows have no matrix.
pub(super) const fn have_no_matrix(rows: usize) -> bool {
    rows > MATRIX_MOST_ROWS
}

/// Whether so many contacts of one pair of bodies are many: some of them stand for all.
pub const fn are_many_of_a_pair(contacts: usize) -> bool {
    contacts > MANY_OF_A_PAIR
}

/// Whether a problem can be solved in the velocities of bodies: soft rows have no place there yet, nor have rows of
/// gears between more than two bodies, nor bodies that some force cannot move.
pub fn is_plain(problem: &ContactProblem) -> bool {
    problem.compliances().is_empty() && problem.is_of_pairs() && are_movable(problem)
}

/// The trees of the joints that these rows are of; none where they are few, where they have no factors, and where gears
/// couple more than two bodies by a row.
pub fn trees(problem: &ContactProblem, joints: Range<usize>) -> Option<HeldForest> {
    if joints.len() < TREES || !problem.is_of_pairs() {
        return None;
    }
    let forest = HeldForest::of(problem, joints.clone())?;
    let has_loops = forest.others().iter().any(|row| joints.contains(row));
    let least = if has_loops { TREES_WITH_LOOPS } else { TREES };
    (forest.held() >= least && !have_no_matrix(forest.others().len())).then_some(forest)
}
