//! What sequential impulses are given of a joint: its bodies and law, and its rows.

use polhode_spatial::DVec3;

/// A row: what a unit of its multiplier does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointRow {
    /// Force on A, and its opposite on B (no unit).
    pub force: DVec3,
    /// Moments about the centres of mass of A and B, m.
    pub moments: [DVec3; 2],
    /// What the row keeps at zero, m; of a limit what is left of the way.
    pub gap: f64,
}

/// What the multipliers of a joint may be.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum JointLaw {
    /// Of either sign: gaps stay zero.
    #[default]
    Hold,
    /// A limit, with one row: not negative.
    Limit,
}

/// A joint without its rows, which change with the poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpulseJoint {
    /// Numbers of its bodies in the solver.
    pub bodies: [u32; 2],
    /// Its law.
    pub law: JointLaw,
    /// How many rows it has: 1 to 6.
    pub rows: usize,
}
