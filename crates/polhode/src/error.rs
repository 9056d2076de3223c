//! What can go wrong while simulating.

use crate::action_error::ActionError;
use crate::scene::SceneError;
use crate::snapshot::SnapshotError;
use polhode_contact::{BroadPhaseError, ImpactError};
use polhode_dynamics::integrator::IntegrationError;
use polhode_response::ResponseError;
use polhode_spatial::DVec3;
use thiserror::Error;

/// Why a simulation could not be made or could not go on.
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
    #[error("the state of body {body} is not finite at t = {t} s: the run diverged")]
    Diverged {
        /// The body.
        body: String,
        /// When, s.
        t: f64,
    },
    /// The total energy is too large for a number.
    #[error("the energy of the scene is no longer a finite number at t = {t} s: speeds or accelerations are too large")]
    EnergyOverflow {
        /// When, s.
        t: f64,
    },
    /// More events in one step than allowed.
    #[error(
        "more than {limit} events within one step at t = {t} s: raise method.max_events_per_step, or give the contact a restitution below 1"
    )]
    TooManyEvents {
        /// The limit.
        limit: u64,
        /// When, s.
        t: f64,
    },
    /// A contact-force or impact problem could not be solved to its tolerance, even by the fallback.
    #[error("contact forces not found at t = {t} s: the residual stays at {residual:e}")]
    ContactSolve {
        /// When, s.
        t: f64,
        /// Residual reached (relative).
        residual: f64,
    },
    /// There are more bodies than pairs can be numbered for.
    #[error("pairs of bodies that may touch cannot be found: {0}")]
    BroadPhase(#[source] BroadPhaseError),
    /// The integrator could not make a step.
    #[error("no step possible from t = {t} s: {source}")]
    Integration {
        /// Start of the step, s.
        t: f64,
        /// Why.
        source: IntegrationError,
    },
    /// A contact problem was not valid.
    #[error("contact problem refused at t = {t} s: {source}")]
    ContactProblem {
        /// When, s.
        t: f64,
        /// Why.
        source: ResponseError,
    },
    /// Steps became too short to make progress.
    #[error(
        "the step fell below {smallest_s:e} s at t = {t} s: the motion cannot be resolved to the tolerance asked for"
    )]
    StepTooSmall {
        /// When, s.
        t: f64,
        /// Shortest step allowed, s.
        smallest_s: f64,
    },
    /// A force of the scene is infinite or not a number where a body is: at the place of what attracts it, say.
    #[error("{force} on body {body} is not finite at t = {t} s: its formula is singular where the body is")]
    ForceNotFinite {
        /// When, s.
        t: f64,
        /// The body.
        body: String,
        /// The force: its number in the scene, from one, and its kind.
        force: String,
    },
    /// A body has come so near to a place where a force grows beyond all bounds that no step is short enough. There is no
    /// motion through such a place that the equations would determine.
    #[error(
        "{force} on body {body} grows without bound: it has reached {force_n:e} N at t = {t} s, where the body runs into a \
         place at which its formula is singular; end the run before, or start the body past that place"
    )]
    SingularForce {
        /// When, s.
        t: f64,
        /// The body.
        body: String,
        /// The force: its number in the scene, from one, and its kind.
        force: String,
        /// How large it has become, N.
        force_n: f64,
    },
    /// Bodies overlap where nothing can move them apart: a prescribed motion leaves one no way out.
    #[error(
        "{body_a} and {body_b} overlap by {overlap_m:e} m at t = {t} s, and nothing moves them apart: leave the body a way \
         out, or end the prescribed motion before"
    )]
    NoWayOut {
        /// When, s.
        t: f64,
        /// A body of the pair that overlaps most.
        body_a: String,
        /// The other one.
        body_b: String,
        /// How far they overlap, m.
        overlap_m: f64,
    },
    /// Many steps have not advanced time.
    #[error(
        "no progress at t = {t} s: {steps} steps have advanced by {advanced_s:e} s while {body_a} touches {body_b} at {point} m: \
         the contact changes faster than it can be followed; raise method.tolerance, or move the start a little"
    )]
    NoProgress {
        /// When, s.
        t: f64,
        /// How many steps.
        steps: u64,
        /// How far they advanced, s.
        advanced_s: f64,
        /// A body of a contact then; empty when there is none.
        body_a: String,
        /// The other body.
        body_b: String,
        /// Where they touch, m.
        point: DVec3,
    },
    /// A time to go on to is not finite, or has passed.
    #[error("cannot go on to t = {t_s} s from t = {now_s} s: a finite time that has not passed is needed")]
    TimeInThePast {
        /// The time asked for, s.
        t_s: f64,
        /// The present, s.
        now_s: f64,
    },
    /// A time of impact could not be found.
    #[error("time of impact of bodies {body_a} and {body_b} not found at t = {t} s: {source}")]
    ImpactSearch {
        /// When, s.
        t: f64,
        /// One body.
        body_a: String,
        /// The other body.
        body_b: String,
        /// Why.
        source: ImpactError,
    },
}
