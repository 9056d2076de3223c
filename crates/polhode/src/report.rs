//! What a run returns: energies, ledger, certificate, warnings.

use crate::body_sample::BodySample;
pub use crate::energy::Energy;
use crate::{BodyId, Ledger, Plan};
use std::fmt;

/// What is known for certain about the accuracy of a run: the worst over all steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Certificate {
    /// Largest residual of a contact-force or impact problem (natural map, relative).
    pub max_residual: f64,
    /// Largest penetration, m (zero when no body ever penetrated).
    pub max_penetration_m: f64,
    /// Largest penetration in units of what the method promises for its pair: above 1 the run is degraded. Zero for a
    /// tier that promises nothing.
    pub max_penetration_of_limit: f64,
    /// Where and when that was.
    pub max_penetration_at: Option<PairAt>,
    /// Largest displacement of a body by one projection, m: of its origin, plus its rotation times its size.
    pub max_projection_m: f64,
    /// The largest such displacement in units of what the method promises for its pair: above 1 the run is degraded.
    /// Overlaps within touch at the start are moved out and do not count.
    pub max_projection_of_limit: f64,
    /// Where and when that was.
    pub max_projection_at: Option<PairAt>,
    /// Largest change of energy by one projection, J.
    pub max_projection_j: f64,
    /// The same, relative to the largest energy of the run, as the closure of the ledger.
    pub max_projection_relative: f64,
    /// Where and when that was.
    pub max_projection_j_at: Option<PairAt>,
    /// Largest bound on the error of an acceleration that a contact-force solve committed, `sqrt(f'w)`, in units of
    /// the mass norm, N^(1/2) (m/s^2)^(1/2) (zero to round-off for exact solves).
    pub max_acceleration_error_bound: f64,
    /// Largest estimated local error of a step in a contact phase, relative to its tolerance.
    pub max_step_error: f64,
    /// How often the method did something else than it promises by itself: a fallback solver answered, an event was put
    /// off, a contact was left alone. [`RunReport::tolerated`] names them.
    pub fallbacks: u64,
}

/// Two bodies at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairAt {
    /// s.
    pub t_s: f64,
    /// Body A.
    pub body_a: BodyId,
    /// Body B.
    pub body_b: BodyId,
}

/// Something that a run has tolerated, skipped or approximated, once or more often.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerated {
    /// What, with the names of its bodies.
    pub what: String,
    /// How often.
    pub count: u64,
    /// When first, s.
    pub first_s: f64,
    /// When last, s.
    pub last_s: f64,
}

impl fmt::Display for Tolerated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, count, first_s, last_s } = self;
        if *count == 1 {
            write!(f, "t = {first_s} s: {what}")
        } else {
            write!(f, "t = {first_s} s to {last_s} s, {count} times: {what}")
        }
    }
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The whole duration was simulated.
    Completed,
    /// The observer stopped it.
    Stopped,
    /// It ended, or the observer stopped it, but it has not kept what its method promises: bodies overlapped by more, a
    /// projection moved them or took energy by more, or a problem was not solved as asked. The first warnings say which
    /// bodies, when, and by how much.
    Degraded,
}

/// A stretch of crowded events (they followed each other so closely that time hardly advanced), in which the bodies
/// advanced by time steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrowdedStretch {
    /// From, s.
    pub from_s: f64,
    /// To, s.
    pub to_s: f64,
    /// Bodies at its begin.
    pub bodies: usize,
    /// Time steps made.
    pub steps: u64,
    /// Sum of the estimated errors of the steps, by halving them: largest displacement of a body relative to its size.
    pub error: f64,
}

/// The plan was derived again after an action of the program, and some of it changed.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanChange {
    /// When, s.
    pub t_s: f64,
    /// The action, by the name of its method.
    pub action: String,
    /// What changed, in words.
    pub changes: Vec<String>,
}

/// The report of a run.
#[derive(Debug, Clone)]
pub struct RunReport {
    /// Name of the scene.
    pub scene: String,
    /// The plan that was followed.
    pub plan: Plan,
    /// How the run ended.
    pub outcome: Outcome,
    /// Time asked for, s.
    pub duration_s: f64,
    /// Time simulated, s.
    pub simulated_s: f64,
    /// Steps taken. While all bodies fly or rest they are those of the caller, so that they depend on how a run is cut.
    pub steps: u64,
    /// Events, of every kind.
    pub events: u64,
    /// Energies.
    pub energy: Energy,
    /// Every joule accounted for.
    pub ledger: Ledger,
    /// What is certain.
    pub certificate: Certificate,
    /// Things a user should know: broken promises first, then the others in order of time.
    pub warnings: Vec<String>,
    /// Stretches of crowded events, passed by time steps: the events in them are not located exactly.
    pub crowded: Vec<CrowdedStretch>,
    /// When actions of the program changed the plan.
    pub plan_changes: Vec<PlanChange>,
    /// What was tolerated, skipped or approximated, in the order in which each came first; their counts add up to
    /// [`Certificate::fallbacks`].
    pub tolerated: Vec<Tolerated>,
    /// Names and final states of the bodies, in the order of the scene.
    pub bodies: Vec<(String, BodySample)>,
}
