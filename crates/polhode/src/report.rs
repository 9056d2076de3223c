//! What a run returns: energies, ledger, certificate, warnings.

use crate::observer::BodySample;
use crate::{Ledger, Plan};

/// Energies of the whole scene, J. The potential is `-sum m g.x_cm`, zero at the world's origin.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Total at t = 0.
    pub initial_j: f64,
    /// Total at the end.
    pub final_j: f64,
    /// Kinetic at the end.
    pub kinetic_j: f64,
    /// Potential at the end.
    pub potential_j: f64,
}

/// What is known for certain about the accuracy of a run: the worst over all steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Certificate {
    /// Largest residual of a contact-force or impact problem (natural map, relative).
    pub max_residual: f64,
    /// Largest penetration, m (zero when no body ever penetrated).
    pub max_penetration_m: f64,
    /// Largest bound on the error of an acceleration that a contact-force solve committed, `sqrt(f'w)`, in units of
    /// the mass norm, N^(1/2) (m/s^2)^(1/2) (zero to round-off for exact solves).
    pub max_acceleration_error_bound: f64,
    /// Largest estimated local error of a step in a contact phase, relative to its tolerance.
    pub max_step_error: f64,
    /// How often a fallback solver answered.
    pub fallbacks: u64,
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The whole duration was simulated.
    Completed,
    /// The observer stopped it.
    Stopped,
}

/// A stretch of time in which the events of some bodies crowded, so that they went on by time steps.
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
    pub action: &'static str,
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
    /// Steps taken.
    pub steps: u64,
    /// Events, of every kind.
    pub events: u64,
    /// Energies.
    pub energy: Energy,
    /// Every joule accounted for.
    pub ledger: Ledger,
    /// What is certain.
    pub certificate: Certificate,
    /// Things a user should know, in order of time.
    pub warnings: Vec<String>,
    /// Stretches of time that were passed by time steps because events crowded: there the events are not exact.
    pub crowded: Vec<CrowdedStretch>,
    /// When actions of the program changed the plan.
    pub plan_changes: Vec<PlanChange>,
    /// Names and final states of the bodies, in the order of the scene.
    pub bodies: Vec<(String, BodySample)>,
}
