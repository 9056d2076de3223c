//! What an impact law did: impulses, velocities after, energy, and how it ended.

/// How an impact ended, the gravest last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum ImpactStatus {
    /// No row approached: nothing to do.
    #[default]
    NoApproach,
    /// No row approaches any more.
    Separated,
    /// Restitutions that differ would have raised the energy, or no impulses give them all: the smallest of them was
    /// used for all rows. With friction the full one would have given back more work than it may.
    RestitutionLowered,
    /// A warning: the impulses form a decaying sequence without end, cut off at the threshold; the remaining approach
    /// was removed by one inelastic solve. With friction also at the limit of rounds.
    StoppedAtThreshold,
    /// The limit of applications or rounds was reached; the remaining approach was removed by one inelastic solve.
    LimitReached,
    /// The cone problem of all contacts was not solved: they were struck one at a time instead.
    StruckInOrder,
    /// A complementarity or cone problem was not solved: the outcome is not to be trusted.
    NotSolved,
}

impl ImpactStatus {
    /// The name in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NoApproach => "no-approach",
            Self::Separated => "separated",
            Self::RestitutionLowered => "restitution-lowered",
            Self::StoppedAtThreshold => "stopped-at-threshold",
            Self::LimitReached => "limit-reached",
            Self::StruckInOrder => "struck-in-order",
            Self::NotSolved => "not-solved",
        }
    }
}

/// One impulse at one row, in the order applied.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Application {
    /// The row.
    pub row: usize,
    /// N s.
    pub impulse: f64,
    /// Change of kinetic energy by this impulse, J.
    pub energy_change: f64,
}

/// What an impact law did.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ImpactOutcome {
    /// Total impulse of each row, N s.
    pub impulses: Vec<f64>,
    /// The impulses in order. Propagation: each application, without the final inelastic solve; the other laws: one for
    /// each row with an impulse, all of it.
    pub applications: Vec<Application>,
    /// The part of `impulses` that the final inelastic solve added; empty when none was needed.
    pub finishing: Vec<f64>,
    /// `u+`, m/s: not negative, exactly 0 where complementarity says so.
    pub velocities_after: Vec<f64>,
    /// How it ended.
    pub status: ImpactStatus,
    /// Change of kinetic energy, J: `p.(u- + u+)/2` of the total impulses.
    pub energy_change: f64,
    /// Number of complementarity problems solved.
    pub solves: usize,
    /// The largest residual of their reports.
    pub residual: f64,
}
