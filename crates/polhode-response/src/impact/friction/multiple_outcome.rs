//! What an impact with friction at several contacts did.

/// How an impact at several contacts ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MultipleImpactStatus {
    /// No contact approaches: nothing to do.
    #[default]
    NoApproach,
    /// No contact approaches any more.
    Separated,
    /// The restitution was lowered: with friction the full one would have given back more work than it may.
    RestitutionLowered,
    /// The impulses form a decaying sequence without end, cut off at the threshold, or the limit of rounds was reached;
    /// what remained was stopped by one inelastic solve.
    StoppedAtThreshold,
    /// The cone problem of all contacts was not solved: they were struck one at a time instead.
    StruckInOrder,
    /// A cone problem was not solved: the outcome is not to be trusted.
    NotSolved,
}

impl MultipleImpactStatus {
    /// The name in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NoApproach => "no-approach",
            Self::Separated => "separated",
            Self::RestitutionLowered => "restitution-lowered",
            Self::StoppedAtThreshold => "stopped-at-threshold",
            Self::StruckInOrder => "struck-in-order",
            Self::NotSolved => "not-solved",
        }
    }

    /// The graver of two.
    pub(super) fn and(self, other: Self) -> Self {
        let gravity = |status: Self| match status {
            Self::NoApproach => 0,
            Self::Separated => 1,
            Self::RestitutionLowered => 2,
            Self::StoppedAtThreshold => 3,
            Self::StruckInOrder => 4,
            Self::NotSolved => 5,
        };
        if gravity(other) > gravity(self) { other } else { self }
    }
}

/// What an impact with friction at several contacts did.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct MultipleImpact {
    /// Impulse of each row, N s.
    pub impulses: Vec<f64>,
    /// Velocity of each row afterwards, m/s: normal velocities are not negative, tangential ones exactly 0 where a
    /// contact sticks.
    pub velocities_after: Vec<f64>,
    /// Work of the normal row of each contact, J; for joints, of all rows. Where the contacts share an impact, that
    /// along the straight way from the velocities before to those afterwards.
    pub normal_work: Vec<f64>,
    /// Work of the tangential rows of each contact, J; likewise.
    pub friction_work: Vec<f64>,
    /// Change of kinetic energy, J: `p.(u- + u+)/2`, the sum of all works.
    pub energy_change: f64,
    /// A warning: the energy rose by more than rounding. Only where single contacts are struck by a law that may do so.
    pub energy_rises: bool,
    /// How it ended.
    pub status: MultipleImpactStatus,
    /// Number of cone problems solved.
    pub solves: usize,
    /// The largest residual of their reports.
    pub residual: f64,
    /// Number of impulses at single contacts.
    pub applications: usize,
}
