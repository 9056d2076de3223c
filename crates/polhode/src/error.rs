//! Errors of a simulation: why it cannot be made, cannot continue, or refuses what a program asks for.

use crate::action_error::ActionError;
use crate::scene::SceneError;
use crate::scene::few_digits::length;
use crate::snapshot::SnapshotError;
use polhode_contact::{BroadPhaseError, ImpactError};
use polhode_dynamics::integrator::IntegrationError;
use polhode_response::ResponseError;
use polhode_spatial::DVec3;
use thiserror::Error;

/// Why a simulation could not be made or could not continue.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// The scene is refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An action of the program is refused.
    #[error(transparent)]
    Action(#[from] ActionError),
    /// A snapshot is refused.
    #[error(transparent)]
    Snapshot(#[from] SnapshotError),
    /// The state is no longer finite.
    #[error(
        "the pose or velocity of body {body} is not finite at t = {t_s} s: the integration diverged; use a shorter \
         method.step, or leave the integrator to the plan"
    )]
    Diverged {
        /// The body.
        body: String,
        /// When, s.
        t_s: f64,
    },
    /// The total energy exceeds the largest number.
    #[error(
        "the total energy is not a finite number at t = {t_s} s: masses, speeds, forces or coordinates of the scene \
         are too large; check their units"
    )]
    EnergyOverflow {
        /// When, s.
        t_s: f64,
    },
    /// One step holds more events than `method.max_events_per_step` allows.
    #[error(
        "more than {limit} events within one step at t = {t_s} s: raise method.max_events_per_step, shorten \
         method.step, or give the materials a restitution below 1"
    )]
    TooManyEvents {
        /// The limit.
        limit: u64,
        /// When, s.
        t_s: f64,
    },
    /// A run beside a run, which estimates its error, has taken all the work that it may.
    #[error("at t = {t_s} s a run beside the run has taken all the work that the estimate of its error may")]
    TooMuchWork {
        /// When, s.
        t_s: f64,
    },
    /// A contact-force or impact problem could not be solved to its tolerance, even by the fallback.
    #[error(
        "the solver found no contact forces or impulses{} at t = {t_s} s: the relative residual stays at {residual:e}; \
         mass ratios or lengths of the scene may differ too much",
        of(bodies)
    )]
    ContactSolve {
        /// When, s.
        t_s: f64,
        /// Residual reached, relative.
        residual: f64,
        /// The bodies of the problem, of many the first; none where it is not known.
        bodies: Vec<String>,
    },
    /// There are more bodies than the broad phase can number.
    #[error("the broad phase cannot find the pairs of bodies that may touch: {0}")]
    BroadPhase(#[source] BroadPhaseError),
    /// The integrator could not make a step.
    #[error("the integrator cannot make a step from t = {t_s} s: {source}")]
    Integration {
        /// Start of the step, s.
        t_s: f64,
        /// Why.
        source: IntegrationError,
    },
    /// A fixed step is too long for a spring at a contact.
    #[error(
        "method.step = {step_s:e} s is too long for the springs at contacts at t = {t_s} s, whose fastest rate is \
         {rate:e} 1/s: an explicit step is stable up to {limit_s:e} s; give a shorter step or none, a larger \
         method.penalty.penetration_m, or method.integrator = \"implicit-midpoint\""
    )]
    StepTooLong {
        /// When, s.
        t_s: f64,
        /// The step of the scene, s.
        step_s: f64,
        /// The longest that is stable, s.
        limit_s: f64,
        /// Largest frequency, or rate of a damper, 1/s.
        rate: f64,
    },
    /// An implicit step on springs has too many bodies for its matrix.
    #[error(
        "the implicit step on springs factorises one matrix of all bodies that may meet, at most {limit}, and {bodies} \
         may at t = {t_s} s: leave out method.integrator, whose steps are under error control, or give \"rk4\" or \
         \"semi-implicit-euler\""
    )]
    ImplicitTooLarge {
        /// When, s.
        t_s: f64,
        /// Bodies that may meet within a step.
        bodies: usize,
        /// The most that are accepted.
        limit: usize,
    },
    /// Joints, gears or prescribed motions ask for what cannot be together.
    #[error(
        "{what}, of {}, contradicts other gears, prescribed motions or joints at t = {t_s} s: no motion of the bodies \
         keeps all of them; leave one of them out, or give it the motion that the others determine",
        bodies.join(" and ")
    )]
    JointsContradict {
        /// When, s.
        t_s: f64,
        /// One of them, by its number in the scene.
        what: String,
        /// The bodies that it holds.
        bodies: Vec<String>,
    },
    /// The data of a contact problem are not valid.
    #[error("the contact problem{} at t = {t_s} s cannot be set up: {source}", of(bodies))]
    ContactProblem {
        /// When, s.
        t_s: f64,
        /// The bodies of the problem, of many the first; none where it is not known.
        bodies: Vec<String>,
        /// Why.
        source: ResponseError,
    },
    /// Error control asks for a step that is too short to advance time.
    #[error(
        "error control asks for a step{} shorter than {smallest_s:e} s at t = {t_s} s, which no longer advances time: \
         raise method.tolerance, or remove what changes so fast (a stiff spring, a body of very small inertia)",
        of(bodies)
    )]
    StepTooSmall {
        /// When, s.
        t_s: f64,
        /// Shortest step allowed, s.
        smallest_s: f64,
        /// The bodies that make it, of many the first; none where it is not known.
        bodies: Vec<String>,
    },
    /// A force of the scene is infinite or not a number at the position of a body: at the centre of attraction, for
    /// example.
    #[error(
        "{force} on body {body} is not finite at t = {t_s} s: its formula is singular at the position of the body, or \
         the program that defines it gives no number there; move the body, or correct the field"
    )]
    ForceNotFinite {
        /// When, s.
        t_s: f64,
        /// The body.
        body: String,
        /// The force: its index in the scene, counted from 0, and its kind.
        force: String,
    },
    /// A body has come so near to a singularity of a force that no step is short enough. The equations of motion
    /// determine no motion through such a point.
    #[error(
        "{force} on body {body} grows without bound: it has reached {force_n:e} N at t = {t_s} s, where the body \
         approaches a point at which the formula of the force is singular; end the run before, or start the body so \
         that it misses that point"
    )]
    SingularForce {
        /// When, s.
        t_s: f64,
        /// The body.
        body: String,
        /// The force: its index in the scene, counted from 0, and its kind.
        force: String,
        /// Its magnitude then, N.
        force_n: f64,
    },
    /// A prescribed motion presses a body into another one that cannot yield.
    #[error(
        "{body_a} and {body_b} overlap by {} at t = {t_s} s, and no impulse can separate them: a prescribed motion \
         leaves a body no room; give it room, or end the prescribed motion before",
        length(*overlap_m)
    )]
    NoWayOut {
        /// When, s.
        t_s: f64,
        /// A body of the pair that overlaps most.
        body_a: String,
        /// The other one.
        body_b: String,
        /// How far they overlap, m.
        overlap_m: f64,
    },
    /// Many steps have advanced time by almost nothing.
    #[error(
        "no progress at t = {t_s} s: {steps} steps have advanced time by {advanced_s:e} s in all; the contacts of \
         {body_a} and {body_b} at {point} m change faster than steps can resolve: raise method.tolerance, change the \
         initial poses a little, or let method.crowding be \"step\""
    )]
    NoProgress {
        /// When, s.
        t_s: f64,
        /// How many steps.
        steps: u64,
        /// Time by which they advanced in all, s.
        advanced_s: f64,
        /// A body of a contact at that time; without a contact, a body of the event.
        body_a: String,
        /// The other body.
        body_b: String,
        /// The contact point, world, m; zero without a contact.
        point: DVec3,
    },
    /// A program asks to advance to a time that is not finite or lies in the past.
    #[error("cannot advance to t = {t_s} s: a finite time of at least the present, t = {now_s} s, is needed")]
    TimeInThePast {
        /// The time asked for, s.
        t_s: f64,
        /// The present, s.
        now_s: f64,
    },
    /// A time of impact could not be found.
    #[error(
        "the search from t = {t_s} s for the time of impact of bodies {body_a} and {body_b} failed: {}",
        impact_fault(source)
    )]
    ImpactSearch {
        /// When, s.
        t_s: f64,
        /// One body.
        body_a: String,
        /// The other body.
        body_b: String,
        /// Why.
        source: ImpactError,
    },
}

/// Whom an error concerns, in a message; nothing where it is not known.
fn of(bodies: &[String]) -> String {
    if bodies.is_empty() { String::new() } else { format!(" of {}", bodies.join(" and ")) }
}

/// Why a search for an impact failed, in the words of a scene: its limit of evaluations is no key of one.
fn impact_fault(source: &ImpactError) -> String {
    match source {
        ImpactError::EvaluationLimit { t, separation, limit } => format!(
            "no result after {limit} evaluations, at t = {t} s with a separation of {separation:e} m: bodies that turn \
             or move very fast for their size need too many; lower their speeds, or shorten method.step"
        ),
        other => other.to_string(),
    }
}

impl SimulationError {
    /// The error of a contact problem at `t_s` (s) that could not be set up.
    pub(crate) fn of_response(t_s: f64, source: ResponseError) -> Self {
        Self::ContactProblem { t_s, source, bodies: Vec::new() }
    }

    /// When it happened, s; none of what has no time.
    pub const fn time(&self) -> Option<f64> {
        match self {
            Self::Diverged { t_s, .. }
            | Self::EnergyOverflow { t_s }
            | Self::TooManyEvents { t_s, .. }
            | Self::TooMuchWork { t_s }
            | Self::ContactSolve { t_s, .. }
            | Self::Integration { t_s, .. }
            | Self::StepTooLong { t_s, .. }
            | Self::ImplicitTooLarge { t_s, .. }
            | Self::JointsContradict { t_s, .. }
            | Self::ContactProblem { t_s, .. }
            | Self::StepTooSmall { t_s, .. }
            | Self::ForceNotFinite { t_s, .. }
            | Self::SingularForce { t_s, .. }
            | Self::NoWayOut { t_s, .. }
            | Self::NoProgress { t_s, .. }
            | Self::ImpactSearch { t_s, .. } => Some(*t_s),
            Self::TimeInThePast { now_s, .. } => Some(*now_s),
            Self::Scene(_) | Self::Action(_) | Self::Snapshot(_) | Self::BroadPhase(_) => None,
        }
    }

    /// The names of the bodies that it happened to: at most two.
    pub fn bodies(&self) -> Vec<&str> {
        match self {
            Self::Diverged { body, .. } | Self::ForceNotFinite { body, .. } | Self::SingularForce { body, .. } => {
                vec![body]
            }
            Self::NoWayOut { body_a, body_b, .. }
            | Self::NoProgress { body_a, body_b, .. }
            | Self::ImpactSearch { body_a, body_b, .. } => vec![body_a, body_b],
            Self::JointsContradict { bodies, .. }
            | Self::ContactProblem { bodies, .. }
            | Self::ContactSolve { bodies, .. }
            | Self::StepTooSmall { bodies, .. } => bodies.iter().take(2).map(String::as_str).collect(),
            _ => Vec::new(),
        }
    }

    /// What would help: the end of its message; none of an error that wraps another one.
    pub fn cure(&self) -> Option<String> {
        let begins_with = match self {
            Self::Diverged { .. }
            | Self::EnergyOverflow { .. }
            | Self::ContactSolve { .. }
            | Self::StepTooLong { .. }
            | Self::JointsContradict { .. }
            | Self::ForceNotFinite { .. }
            | Self::SingularForce { .. }
            | Self::NoWayOut { .. } => "; ",
            Self::TooManyEvents { .. }
            | Self::ImplicitTooLarge { .. }
            | Self::StepTooSmall { .. }
            | Self::NoProgress { .. }
            | Self::TimeInThePast { .. } => ": ",
            _ => return None,
        };
        self.to_string().rsplit_once(begins_with).map(|(_, cure)| cure.to_owned())
    }
}

#[cfg(test)]
mod tests {
    //! What an error says of its time, its bodies and its cure is what its message says.
    use super::*;

    #[test]
    fn cures_are_the_ends_of_messages() {
        let diverged = SimulationError::Diverged { body: "top".to_owned(), t_s: 1.5 };
        assert_eq!((diverged.time(), diverged.bodies()), (Some(1.5), vec!["top"]));
        assert_eq!(diverged.cure().as_deref(), Some("use a shorter method.step, or leave the integrator to the plan"));
        let many = SimulationError::TooManyEvents { limit: 7, t_s: 2.0 };
        let cure = "raise method.max_events_per_step, shorten method.step, or give the materials a restitution below 1";
        assert_eq!((many.time(), many.cure().as_deref()), (Some(2.0), Some(cure)));
        assert_eq!(SimulationError::Snapshot(SnapshotError::Invalid("torn")).cure(), None);
    }
}
