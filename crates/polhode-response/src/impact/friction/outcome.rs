//! What an impact with friction at one contact did.

use super::phase::ImpactPhase;

/// How an impact at one contact ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum FrictionalImpactStatus {
    /// The contact does not approach, and does not jam: nothing to do.
    #[default]
    NoApproach,
    /// The bodies separate, or stay in contact when the restitution is zero.
    Separated,
    /// The bodies are held by joints such that no impulse within the cone of friction moves the contact: it sticks, and
    /// does not rebound.
    Wedged,
    /// The path was not followed to its end: the outcome is not to be trusted.
    NotSolved,
}

/// What an impact with friction at one contact did. Vectors are in the order normal, first tangent, second tangent.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct FrictionalImpact {
    /// Impulse on A, N s: `p_n >= 0`, `|p_t| <= mu p_n`.
    pub impulse: [f64; 3],
    /// Velocity of A over B afterwards, m/s; exactly 0 where the contact sticks.
    pub velocity_after: [f64; 3],
    /// What the contact did, in order. The laws that are algebra alone have none.
    pub phases: Vec<ImpactPhase>,
    /// Normal impulse at the end of the compression, N s; 0 for the laws that are algebra alone.
    pub compression_impulse: f64,
    /// Work of the normal impulse, J. For the laws that are algebra alone, that along the straight way from the
    /// velocity before to that afterwards.
    pub normal_work: f64,
    /// Work of the tangential impulse, J; likewise.
    pub friction_work: f64,
    /// Change of kinetic energy, J: `p.(u- + u+)/2`, the sum of both works.
    pub energy_change: f64,
    /// A warning: the law has raised the energy by more than rounding.
    pub energy_rises: bool,
    /// How it ended.
    pub status: FrictionalImpactStatus,
}
