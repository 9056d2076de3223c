//! Impact laws: impulses that stop touching bodies from approaching.
//!
//! All laws work on row velocities `u = J v` (m/s, negative while approaching), impulses `p >= 0` (N s) and the
//! Delassus matrix: `u+ = u- + G p`. A row with restitution `e` leaves with `u+ = -e u-` when it is struck alone
//! (Newton; [`single_contact_impulse`], thesis equation 14). With several rows at once rigid bodies leave the answer
//! open (thesis, Figure 16), so the law is a choice:
//!
//! | law | several rows | symmetric | ends |
//! |---|---|---|---|
//! | [`propagation`](propagation()) | one at a time, in order (thesis 3.3) | no | not always |
//! | [`simultaneous`](simultaneous()) | all at once (Moreau; thesis 3.4, end) | yes | yes |
//! | [`reflection`](reflection()) | those that approach, repeated (Smith et al. 2012) | yes | yes |
//!
//! At a bilateral row, a joint, `u+ = 0` after every application, whatever its restitution and whatever it was before:
//! the joints take part in each solve, with impulses of either sign.
//!
//! Energy: for any impulse `dT = p.(u- + u+)/2` exactly (thesis, Appendix B, for any number of rows), which is how
//! every outcome is booked. No law raises the energy; none leaves a row approaching.

mod finish;
mod propagation;
mod reflection;
mod simultaneous;
mod single_contact;

pub use propagation::propagation;
pub use reflection::reflection;
pub use simultaneous::simultaneous;
pub use single_contact::single_contact_impulse;

use crate::complementarity::ComplementaritySolver;
use crate::delassus::Delassus;
use crate::error::{ResponseError, check_finite, check_length};
use crate::problem::ContactProblem;
use crate::settings::SolverSettings;

/// Which impact law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ImpactLaw {
    /// One contact at a time, in order (thesis, section 3.3).
    Propagation,
    /// All touching contacts at once (Moreau).
    Simultaneous,
    /// Generalised reflection, blended with the inelastic impulse.
    #[default]
    Reflection,
}

/// Tolerances and limits of the impact laws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactSettings {
    /// A row approaches when `u < -threshold * max |u-|` over the rows that approach at first.
    pub threshold: f64,
    /// Limit of applications (propagation) or of rounds (the other laws).
    pub limit: usize,
    /// Settings of the complementarity problems.
    pub solver: SolverSettings,
}

impl Default for ImpactSettings {
    fn default() -> Self {
        Self { threshold: 1e-12, limit: 1_000_000, solver: SolverSettings::default() }
    }
}

/// How an impact ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ImpactStatus {
    /// No row approached: nothing to do.
    #[default]
    NoApproach,
    /// No row approaches any more.
    Separated,
    /// A warning: the impulses form a decaying sequence without end, cut off at the threshold; the remaining approach
    /// was removed by one inelastic solve.
    StoppedAtThreshold,
    /// The limit of applications or rounds was reached; the remaining approach was removed by one inelastic solve.
    LimitReached,
    /// Restitutions that differ would have raised the energy, or no impulses give them all: the smallest of them was
    /// used for all rows.
    RestitutionLowered,
    /// A complementarity problem was not solved: the outcome is not to be trusted.
    NotSolved,
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
    /// The impulses in order. Propagation: each application; the other laws: one for each row with an impulse.
    /// The final inelastic solve is not among them.
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

impl ImpactLaw {
    /// Resolves an impact by this law.
    ///
    /// # Errors
    /// When a list has the wrong length, a number is not finite, or a restitution is outside `[0, 1]`.
    pub fn resolve(
        self,
        problem: &ContactProblem,
        delassus: &Delassus,
        u_before: &[f64],
        restitution: &[f64],
        settings: &ImpactSettings,
        solver: &mut ComplementaritySolver,
    ) -> Result<ImpactOutcome, ResponseError> {
        match self {
            Self::Propagation => propagation(problem, delassus, u_before, restitution, settings, solver),
            Self::Simultaneous => simultaneous(problem, delassus, u_before, restitution, settings, solver),
            Self::Reflection => reflection(problem, delassus, u_before, restitution, settings, solver),
        }
    }
}

/// Checks the arguments of an impact law and returns the largest speed of approach (at bilateral rows, of either sign),
/// m/s.
fn check(
    problem: &ContactProblem,
    delassus: &Delassus,
    u_before: &[f64],
    restitution: &[f64],
    settings: &ImpactSettings,
) -> Result<f64, ResponseError> {
    let rows = problem.len();
    check_length("Delassus matrix", rows, delassus.len())?;
    check_length("row velocities", rows, u_before.len())?;
    check_length("restitution", rows, restitution.len())?;
    check_finite("row velocities", u_before)?;
    delassus.check_finite()?;
    settings.solver.check()?;
    if !(0.0..1.0).contains(&settings.threshold) {
        let (field, accepted) = ("threshold", "at least 0 and below 1");
        return Err(ResponseError::Setting { field, accepted, value: settings.threshold });
    }
    if let Some((row, &value)) = restitution.iter().enumerate().find(|(_, e)| !(0.0..=1.0).contains(*e)) {
        return Err(ResponseError::Restitution { row, value });
    }
    let speed = |(row, u): (usize, &f64)| if problem.is_bilateral(row) { u.abs() } else { -u };
    Ok(u_before.iter().enumerate().map(speed).fold(0.0, f64::max))
}
