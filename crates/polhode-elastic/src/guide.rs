//! How the nodes of a body may move.

/// How the nodes may move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guide {
    /// In the plane.
    Free,
    /// Along vertical lines: a confined body in uniaxial strain. A rectangle whose sides stand on rollers and that
    /// drops flat moves so by itself; here every node has its row, so that rounding cannot grow beside it.
    Vertical,
}
