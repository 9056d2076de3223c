//! What an impact with friction at several contacts did.

use crate::impact::ImpactStatus;

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
    pub status: ImpactStatus,
    /// Number of cone problems solved.
    pub solves: usize,
    /// The largest residual of their reports.
    pub residual: f64,
    /// Number of impulses at single contacts.
    pub applications: usize,
}
