//! The report of a run: outcome, plan, energies, ledger, certificate, warnings.

use crate::identity::body_id::BodyId;
use crate::plan::decisions::Plan;
pub use crate::report::body_sample::ReportedBody;
pub use crate::report::broken_promise::BrokenPromise;
pub use crate::report::energy::Energy;
use crate::report::ledger::Ledger;
use crate::report::run_error::RunError;
use crate::report::springs::SpringReport;
use std::fmt;

/// What is known for certain about the accuracy of a run: the largest value of each measure over all steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Certificate {
    /// Largest residual of a contact-force or impact problem (natural map, relative).
    pub max_residual: f64,
    /// The same relative to its limit: above 1 the run is degraded. Zero for a tier without a promise.
    pub max_residual_of_limit: f64,
    /// By how much the loads that a step tells of contacts, joints and fields are off Newton's law of a body, relative
    /// to the sum of their magnitudes, at most. Measured in time steps; zero elsewhere.
    pub max_load_defect: f64,
    /// The same relative to its limit: above 1 the run is degraded.
    pub max_load_defect_of_limit: f64,
    /// Largest penetration, m; zero when no bodies overlapped.
    pub max_penetration_m: f64,
    /// Largest penetration relative to the limit that the tier promises for the pair: above 1 the run is degraded. Zero
    /// for a tier without a promise.
    pub max_penetration_of_limit: f64,
    /// The pair and the time of that penetration.
    pub max_penetration_at: Option<PairAt>,
    /// Largest penetration in a sample that was written, m: of all pairs, measured by the distance of their shapes.
    /// Zero when no bodies overlapped in one, or none was written.
    pub max_sample_penetration_m: f64,
    /// The same relative to the limit that the tier promises for the pair.
    pub max_sample_penetration_of_limit: f64,
    /// The pair and the time of that sample.
    pub max_sample_penetration_at: Option<PairAt>,
    /// Largest displacement of a body by one projection, m: of its origin, plus its rotation times its size.
    pub max_projection_m: f64,
    /// Largest such displacement relative to the limit that the tier promises for the pair: above 1 the run is
    /// degraded. Projections of overlaps at the start that count as touch are left out.
    pub max_projection_of_limit: f64,
    /// The pair and the time of that projection.
    pub max_projection_at: Option<PairAt>,
    /// Largest change of energy by one projection, J.
    pub max_projection_j: f64,
    /// The same, relative to the largest energy of the run.
    pub max_projection_relative: f64,
    /// The pair and the time of that projection.
    pub max_projection_j_at: Option<PairAt>,
    /// Largest energy that the end of bounces at one instant took beyond that of the bounces themselves, J: of motion
    /// along a surface, for example. Bounces too small to resolve are ended by a projection of the velocities.
    pub max_ended_bounces_j: f64,
    /// The pair and the time of that.
    pub max_ended_bounces_at: Option<PairAt>,
    /// The same energy of all instants, J: above 1e-9 of the largest energy of the run it is degraded.
    pub ended_bounces_j: f64,
    /// Largest violation of Coulomb's law by forces or impulses of contacts with friction: what a tangential force
    /// exceeds `mu` times the normal one by, or what pulls, relative to the largest force of the problem; or the
    /// acceleration of a slip that is held although friction does not hold it, relative to the largest without contact
    /// forces. Judged at every instant, impact and time step, and at the end of every step between them.
    pub max_friction_violation: f64,
    /// The same relative to its limit: above 1 the run is degraded.
    pub max_friction_violation_of_limit: f64,
    /// The pair and the time of that violation.
    pub max_friction_violation_at: Option<PairAt>,
    /// Largest bound `sqrt(f.w)` on the error of the accelerations from a solve for contact forces, in the norm of
    /// mass, N^(1/2) (m/s^2)^(1/2); zero to rounding for exact solves. None where no contact force was solved for: in
    /// the tier `stepped`, which solves for impulses, and in runs without contact.
    pub max_acceleration_error_bound: Option<f64>,
    /// Largest estimated local error of a step under error control, of free or constrained motion, relative to its
    /// tolerance. None where no step was under error control.
    pub max_step_error: Option<f64>,
    /// Largest distance of a joint from what it keeps, m, at any observation: at samples, and at least once in a
    /// longest step. None without joints.
    pub max_joint_error_m: Option<f64>,
    /// The same of its rotations, rad.
    pub max_joint_error_rad: Option<f64>,
    /// The larger one of both relative to its limit: above 1 the run is degraded.
    pub max_joint_error_of_limit: f64,
    /// The bodies and the time of the largest distance; one body twice where the joint holds it to the world.
    pub max_joint_error_at: Option<PairAt>,
    /// The largest energy that the integrator had lost or gained at any time, relative to the largest energy of the run
    /// until then: above the promised part the run is degraded.
    pub max_numerical_relative: f64,
    /// Factorisations by which time steps have solved for the velocities of bodies with many rough contacts: what they
    /// cost, whatever the machine. Those of samples within a step are left out.
    pub factorisations: u64,
    /// Number of fallbacks: a fallback solver answered, an event was postponed (backoff), a contact was not projected.
    /// [`RunReport::tolerated`] names them.
    pub fallbacks: u64,
}

/// A pair of bodies and a time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PairAt {
    /// Time, s.
    pub t_s: f64,
    /// Body A.
    pub body_a: BodyId,
    /// Body B.
    pub body_b: BodyId,
}

/// Something that happened in a run once or more often: a tolerated violation, a fallback, or a choice.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Occurrence {
    /// What it was, with the names of the bodies.
    pub what: String,
    /// How often it occurred.
    pub count: u64,
    /// Time of the first occurrence, s.
    pub first_s: f64,
    /// Time of the last occurrence, s.
    pub last_s: f64,
}

impl fmt::Display for Occurrence {
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
#[non_exhaustive]
pub enum Outcome {
    /// The whole duration was simulated.
    Completed,
    /// The observer stopped it.
    Stopped,
    /// The run ended, or the observer stopped it, but it did not keep its promise ([`Promise`](crate::scene::Promise)):
    /// a penetration, the gap of a joint, the displacement of a projection, the energy of projections, what the
    /// integrator lost or gained, a residual or a violation of Coulomb's law exceeded its limit, or fixed steps were
    /// too long and the estimated error exceeds the size of a body. The first warnings say which bodies, when, and by
    /// how much.
    Degraded,
}

impl Outcome {
    /// The name used in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Completed => "completed",
            Self::Stopped => "stopped",
            Self::Degraded => "degraded",
        }
    }
}

/// A stretch of time in which events followed each other so closely that time hardly advanced. The bodies were advanced
/// through it by time steps.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CrowdedStretch {
    /// Beginning of the stretch, s.
    pub from_s: f64,
    /// End of the stretch, s.
    pub to_s: f64,
    /// Number of bodies at its beginning.
    pub bodies: usize,
    /// Number of time steps.
    pub steps: u64,
    /// Sum of the errors of the steps, each estimated by halving the step: largest displacement of a body relative to
    /// its size.
    pub error: f64,
    /// Largest residual of the contact problems solved in it (natural map, relative).
    pub max_residual: f64,
}

/// A change of the plan, which is derived again after every action of the program.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PlanChange {
    /// Time of the action, s.
    pub t_s: f64,
    /// Name of the method of [`Simulation`](crate::Simulation) that acted.
    pub action: String,
    /// What changed, in words.
    pub changes: Vec<String>,
}

/// The report of a run.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct RunReport {
    /// Name of the scene.
    pub scene: String,
    /// The plan of the run.
    pub plan: Plan,
    /// How the run ended.
    pub outcome: Outcome,
    /// Duration of the scene, s.
    pub duration_s: f64,
    /// Time simulated, s.
    pub simulated_s: f64,
    /// Number of steps. While all bodies are in free flight or at rest, every call of a method that advances the
    /// simulation counts as a step.
    pub steps: u64,
    /// Number of events of all kinds.
    pub events: u64,
    /// Energies.
    pub energy: Energy,
    /// Energy and momentum, booked by cause.
    pub ledger: Ledger,
    /// The estimated error of the run.
    pub error: RunError,
    /// What is certain about the accuracy.
    pub certificate: Certificate,
    /// The limits of the promise that were exceeded: a run without one may be degraded too, as a warning says.
    pub broken: Vec<BrokenPromise>,
    /// Warnings: exceeded limits of the promise first, then the others in order of time.
    pub warnings: Vec<String>,
    /// Stretches of crowded events, passed by time steps: the events in them are not located exactly.
    pub crowded: Vec<CrowdedStretch>,
    /// Changes of the plan by actions of the program.
    pub plan_changes: Vec<PlanChange>,
    /// Occurrence violations and fallbacks, in the order of their first occurrence. Their counts add up to
    /// [`Certificate::fallbacks`].
    pub tolerated: Vec<Occurrence>,
    /// Where the laws of contact allow several motions, and the method has chosen one, in the order of first
    /// occurrence. The choices are those of the bodies, whatever the axes of the world: they are no defect of the run.
    pub choices: Vec<Occurrence>,
    /// What springs were asked for and reached; none but in the tier `penalty`.
    pub springs: Option<SpringReport>,
    /// The bodies at the end, by [`BodyId::index`].
    pub bodies: Vec<ReportedBody>,
}

impl RunReport {
    /// Total time in stretches of crowded events, s; where those of two islands overlap in time it counts once.
    pub fn crowded_s(&self) -> f64 {
        let mut intervals: Vec<(f64, f64)> =
            self.crowded.iter().map(|stretch| (stretch.from_s, stretch.to_s)).collect();
        intervals.sort_by(|x, y| x.0.total_cmp(&y.0));
        let (mut total, mut covered_to) = (0.0, f64::NEG_INFINITY);
        for (from, to) in intervals {
            total += (to - from.max(covered_to)).max(0.0);
            covered_to = covered_to.max(to);
        }
        total
    }

    /// Largest residual of the contact problems in stretches of crowded events (natural map, relative).
    pub fn crowded_residual(&self) -> f64 {
        self.crowded.iter().map(|stretch| stretch.max_residual).fold(0.0, f64::max)
    }
}
