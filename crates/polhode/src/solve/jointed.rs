//! Trees of joints in a problem: whether its joints are eliminated first, and not through the matrix of all rows.
//!
//! The matrix of `n` rows takes `n^2` numbers and its factors `n^3` products; trees take as many as there are bodies
//! (`polhode_response::sparse`). For a handful of joints the matrix is as fast.

use crate::rows::assembly::Assembly;
use polhode_response::sparse::HeldForest;

/// From so many rows of joints on they are eliminated first (15 to 60).
const LEAST_ROWS_OF_TREES: usize = 24;

/// The same where some of them close loops (60 to 200): the rows of a mechanism may depend on each other, and which of
/// them do is seen best among all of them.
const LEAST_ROWS_WITH_LOOPS: usize = 100;

/// The trees of the joints of an assembly; none where they have few rows, where they have no factors, and where gears
/// couple more than two bodies by a row.
pub(crate) fn trees_of(assembly: &Assembly) -> Option<HeldForest> {
    let rows = assembly.joint_rows();
    if rows.len() < LEAST_ROWS_OF_TREES || !assembly.problem.is_of_pairs() {
        return None;
    }
    let forest = HeldForest::of(&assembly.problem, rows.clone())?;
    let has_loops = forest.others().iter().any(|row| rows.contains(row));
    let least = if has_loops { LEAST_ROWS_WITH_LOOPS } else { LEAST_ROWS_OF_TREES };
    (forest.held() >= least).then_some(forest)
}
