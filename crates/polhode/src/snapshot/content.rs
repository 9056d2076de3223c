//! The content of a snapshot: plain data, from which everything else of a run is computed again.
//!
//! It leaves out buffers and what is a pure function of these data (polynomials of steps, the agenda, mass properties).
//! It includes what a program has changed in a running simulation.

use super::numbers::{Contact, Kinematics, State, Vector};
use super::springs::Penalty;
use crate::error_estimate::course::Course;
use crate::model::plane_of_motion::PlanarParts;
use crate::report::run_error::{BodyError, ReferenceKind};
use crate::scene::ErrorEstimation;
use serde::{Deserialize, Serialize};

/// A simulation at a time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Content {
    pub(crate) scene: String,
    pub(crate) scene_hash: u64,
    /// Whether all effects were asked for.
    pub(crate) all_effects: bool,
    /// The present, s.
    pub(crate) t: f64,
    /// Whether the end of the scene's duration has been reached.
    pub(crate) ended: bool,
    /// Forces and torques that a program applies, by body (N, N m).
    pub(crate) applied: Vec<(usize, [Vector; 2])>,
    /// Motions that a program has given kinematic bodies.
    pub(crate) steered: Vec<Steered>,
    /// Motors that a program has given joints.
    pub(crate) motors: Vec<Motor>,
    /// Joints that hold nothing any more.
    pub(crate) released: Vec<usize>,
    /// The angles whose revolutions gears count, rad, by the numbers of the gears.
    pub(crate) turns: Vec<(usize, f64)>,
    /// The bodies whose motion is still confined to the plane of its start.
    pub(crate) in_plane: Vec<usize>,
    /// Name of the integrator of free motion that the plan has chosen.
    pub(crate) integrator: String,
    /// The plan, if an action of the program has changed it or the facts in it.
    pub(crate) plan: Option<Plan>,
    pub(crate) plan_changes: Vec<PlanChange>,
    pub(crate) accounts: Accounts,
    pub(crate) tier: Tier,
    /// Units of work that the motion so far has cost.
    pub(crate) work: u64,
    pub(crate) error: ErrorEstimate,
}

/// A motion that a program has given a kinematic body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Steered {
    pub(crate) body: usize,
    /// When it was given, s.
    pub(crate) from_s: f64,
    /// Pose and velocity from then on, with the angular velocity in the place of the angular momentum.
    pub(crate) start: State,
    /// Acceleration and angular acceleration then.
    pub(crate) acceleration: [Vector; 2],
    /// When and where it ends.
    pub(crate) goal: Option<(f64, State)>,
}

/// A motor that a program has given a coordinate of a joint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Motor {
    /// Number of the joint.
    pub(crate) joint: usize,
    /// Name of the coordinate.
    pub(crate) coordinate: String,
    /// The numbers of its drive, and its largest effort; none where it has been taken away.
    pub(crate) drive: Option<(Vec<f64>, f64)>,
}

/// The estimated error of a run, and the runs beside it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ErrorEstimate {
    pub(crate) effort: ErrorEstimation,
    pub(crate) start: Option<StartOfRun>,
    pub(crate) before: Option<StartOfRun>,
    pub(crate) course: Course,
    pub(crate) running: Vec<Reference>,
}

/// The content of a run beside a run, and the plane of its planar bodies at its start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct RunBeside {
    pub(crate) content: Box<Content>,
    pub(crate) planar: Option<PlanarParts>,
}

/// Where references that begin with the run begin.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct StartOfRun {
    pub(crate) t_s: f64,
    pub(crate) states: Vec<State>,
    pub(crate) rested: Vec<bool>,
}

/// A run beside a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Reference {
    pub(crate) kind: ReferenceKind,
    pub(crate) run: RunBeside,
    /// The run with which a disturbed one is compared.
    pub(crate) partner: Option<RunBeside>,
    pub(crate) begun_s: f64,
    pub(crate) is_whole: bool,
    pub(crate) comparisons: u32,
    pub(crate) number: u32,
    pub(crate) base: Vec<BodyError>,
    pub(crate) since: Vec<BodyError>,
}

/// The parts of a [`crate::Plan`] that actions of a program may change, besides the integrator.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Plan {
    pub(crate) integrator_reason: String,
    pub(crate) effects: Vec<EffectDecision>,
}

/// [`crate::EffectDecision`], by its place in the plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct EffectDecision {
    pub(crate) is_on: bool,
    pub(crate) fact: String,
    pub(crate) saves: String,
}

/// [`crate::PlanChange`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PlanChange {
    pub(crate) t_s: f64,
    pub(crate) action: String,
    pub(crate) changes: Vec<String>,
}

/// Ledgers, certificate, warnings and events so far.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Accounts {
    pub(crate) books: Books,
    pub(crate) certificate: Certificate,
    pub(crate) warnings: Vec<Warning>,
    pub(crate) tolerated: Vec<Warning>,
    pub(crate) choices: Vec<Warning>,
    pub(crate) measures: Measures,
    pub(crate) crowded: Vec<CrowdedStretch>,
    pub(crate) step_errors: f64,
    pub(crate) events: Vec<Event>,
    pub(crate) event_count: u64,
    pub(crate) steps: u64,
    pub(crate) next_sample: u64,
    pub(crate) last_sample_s: Option<f64>,
}

/// A compensated sum: the sum and its compensation.
pub(crate) type Sum = [f64; 2];

/// [`crate::Ledger`], with the potential energy at the start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Books {
    pub(crate) impact: Sum,
    pub(crate) friction: Sum,
    pub(crate) rest: Sum,
    pub(crate) damping: Sum,
    pub(crate) external: Sum,
    pub(crate) projection: Sum,
    pub(crate) numerical: Sum,
    pub(crate) initial_j: f64,
    pub(crate) current_j: f64,
    pub(crate) scale_j: f64,
    pub(crate) initial_potential_j: f64,
    pub(crate) momentum: MomentumLedger,
}

/// [`crate::MomentumLedger`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct MomentumLedger {
    pub(crate) about: Vector,
    pub(crate) gravity: [Sum; 6],
    pub(crate) support: [Sum; 6],
    pub(crate) fields: [Sum; 6],
    pub(crate) program: [Sum; 6],
    pub(crate) rest: [Sum; 6],
    pub(crate) projection: [Sum; 6],
    pub(crate) numerical: [Sum; 6],
    pub(crate) initial: [Vector; 2],
    pub(crate) current: [Vector; 2],
    pub(crate) scale_linear: f64,
    pub(crate) scale_angular: f64,
}

/// [`crate::Certificate`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Certificate {
    pub(crate) max_penetration_m: f64,
    pub(crate) max_acceleration_error_bound: Option<f64>,
    pub(crate) max_step_error: Option<f64>,
    pub(crate) factorisations: u64,
    pub(crate) fallbacks: u64,
}

/// The measures that decide whether a run is degraded, so far.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Measures {
    pub(crate) penetration: Worst,
    pub(crate) sample_penetration: Worst,
    pub(crate) projection: Worst,
    pub(crate) projection_energy: Worst,
    pub(crate) friction: Worst,
    pub(crate) residual: Worst,
    pub(crate) loads: Worst,
    pub(crate) has_joints: bool,
    pub(crate) joint_gap: Worst,
    pub(crate) joint_rotation: Worst,
    pub(crate) drift_energy: Sum,
    pub(crate) lifts: Worst,
    pub(crate) lifts_sum: Sum,
    pub(crate) crowd_projection: Worst,
    pub(crate) crowd_projection_sum: Sum,
    pub(crate) ended_bounces: Worst,
    pub(crate) ended_bounces_sum: Sum,
    pub(crate) unsolved: Vec<Warning>,
    pub(crate) numerical: NumericalLoss,
    pub(crate) long_steps: LongSteps,
}

/// What the integrator lost or gained.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct NumericalLoss {
    pub(crate) energy_j: f64,
    pub(crate) relative: f64,
    /// When it first exceeded its limit.
    pub(crate) first: Option<FirstLoss>,
}

/// What the integrator lost when it first exceeded its limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct FirstLoss {
    pub(crate) t: f64,
    /// The fastest rates then, 1/s.
    pub(crate) oscillation: f64,
    pub(crate) decay: f64,
}

/// Fixed steps that were too long.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct LongSteps {
    pub(crate) count: u64,
    pub(crate) first_s: f64,
    pub(crate) worst: Option<Movement>,
}

/// How far a body moved in one step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Movement {
    pub(crate) body: usize,
    pub(crate) t: f64,
    pub(crate) step_s: f64,
    pub(crate) travel: f64,
    pub(crate) turn: f64,
    pub(crate) enough_s: f64,
}

/// The largest values of one quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Worst {
    pub(crate) largest: f64,
    pub(crate) worst: Option<Measure>,
}

/// A value measured for a pair of bodies.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Measure {
    pub(crate) t: f64,
    pub(crate) pair: (usize, usize),
    pub(crate) value: f64,
    pub(crate) allowed: f64,
}

/// [`crate::CrowdedStretch`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct CrowdedStretch {
    pub(crate) from_s: f64,
    pub(crate) to_s: f64,
    pub(crate) bodies: usize,
    pub(crate) steps: u64,
    pub(crate) error: f64,
    pub(crate) max_residual: f64,
}

/// A warning and how often it was given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Warning {
    pub(crate) what: String,
    pub(crate) first_s: f64,
    pub(crate) last_s: f64,
    pub(crate) count: u64,
}

/// [`crate::Event`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Event {
    pub(crate) t: f64,
    pub(crate) kind: EventKind,
    pub(crate) body_a: usize,
    pub(crate) body_b: Option<usize>,
    pub(crate) point: Vector,
    pub(crate) normal: Vector,
    pub(crate) impulse: f64,
    pub(crate) energy_change_j: f64,
}

/// [`crate::EventKind`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum EventKind {
    Impact,
    ContactBegin,
    ContactEnd,
    Rest,
    Wake,
    Detach,
    Stick,
    Slide,
    Jam,
    Break,
}

/// The data from which the tier continues.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) enum Tier {
    Accurate(Accurate),
    Stepped(Stepped),
    Fast(Fast),
    Thesis(Thesis),
    MicroCollisions(MicroCollisions),
    Penalty(Penalty),
}

/// The tier `accurate`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Accurate {
    pub(crate) states: Vec<State>,
    pub(crate) tracks: Vec<Track>,
    pub(crate) islands: Vec<Island>,
    pub(crate) contacts: Vec<Touch>,
    pub(crate) near: NearPairs,
    pub(crate) spins: Vec<(usize, Flight)>,
    pub(crate) begun: bool,
    pub(crate) goes_on: bool,
    pub(crate) observed_s: f64,
}

/// How a body moves, and what later steps need of its past motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Track {
    pub(crate) mode: Mode,
    pub(crate) pace: Pace,
    pub(crate) proposed_step_s: f64,
    pub(crate) speed_scale: f64,
    pub(crate) rest_booked_s: f64,
    pub(crate) last_stretch_s: f64,
    pub(crate) gave_up_splitting: bool,
}

/// How a body moves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) enum Mode {
    Fixed,
    Prescribed,
    Flight(Flight),
    Constrained,
    Stepped,
    Crowded { until: f64, step_s: f64, number: usize, spare_error: f64 },
    Rest,
}

/// A flight record.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Flight {
    pub(crate) t0: f64,
    pub(crate) start: State,
    pub(crate) acceleration: Vector,
    pub(crate) rotation: Rotation,
}

/// The rotation of a flight record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Rotation {
    /// Free rotation.
    Free,
    /// Steady rotation about a principal axis, in planar motion.
    Steady,
}

/// The counts of steps and events by which stalls and crowded events of a body, or of the slowest body of an island,
/// are detected (`accurate/pace.rs`).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Pace {
    /// When the present step began: at an event or at the end of a step, s.
    pub(crate) since: f64,
    /// Number of events in a row without an advance of time.
    pub(crate) stalls: u32,
    /// Events since a whole step was made.
    pub(crate) events: u64,
    /// When time last advanced, s.
    pub(crate) advanced_at: f64,
    /// Steps since then.
    pub(crate) steps: u64,
    /// Number of backoffs since then.
    pub(crate) backoffs: u32,
    /// Events within the present window of one longest step, and its start, s.
    pub(crate) window_events: u64,
    pub(crate) window_start: f64,
    /// Steps counted for the mean step length, and the start of the first, s.
    pub(crate) mean_steps: u64,
    pub(crate) mean_start: f64,
    /// Whether the body has passed a stretch of crowded events.
    pub(crate) has_crowded: bool,
}

/// An island.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Island {
    pub(crate) bodies: Vec<usize>,
    pub(crate) held: Vec<Contact>,
    pub(crate) t: f64,
    pub(crate) step: Step,
    pub(crate) due: f64,
    pub(crate) changes: bool,
    pub(crate) is_unsolved: bool,
    pub(crate) departing: Vec<Contact>,
    /// Modes of the contacts with friction.
    pub(crate) friction: Vec<(Contact, Friction)>,
    pub(crate) stopping: Vec<Contact>,
    pub(crate) fading: Vec<Contact>,
    /// Directions in which contacts begin to slide.
    pub(crate) slipping: Vec<(Contact, Vector)>,
    /// Rolling, then spinning.
    pub(crate) rotation: Vec<(Contact, [Option<Friction>; 2])>,
    /// Joints that break at its end.
    pub(crate) breaking: Vec<usize>,
    pub(crate) settling: Vec<(Contact, bool)>,
    /// Directions in which rotations (spinning: true) begin.
    pub(crate) turning: Vec<(Contact, bool, Vector)>,
    /// Joints whose bodies run off the ends of their tracks then.
    pub(crate) running_off: Vec<usize>,
}

/// [`FrictionMode`](crate::collision::friction_mode::FrictionMode).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Friction {
    Sticking,
    Sliding { direction: Vector, speed: f64, noise: f64 },
}

/// The present step of an island.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) enum Step {
    /// A constrained step of this length (s), which is repeated from its start.
    Constrained(f64),
    /// A step by an integrator of free motion.
    Free(FreeStep),
    /// A time step through crowded events to this time (s), with these pairs; it is repeated from its start.
    Crowd(f64, Vec<(usize, usize)>),
    /// No step; the island is at this time (s).
    Waiting(f64),
}

/// A step of an integrator of free motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct FreeStep {
    pub(crate) from: f64,
    pub(crate) end: f64,
    pub(crate) start: Vec<State>,
    pub(crate) present: Vec<State>,
    /// The variables from which the integrator continues.
    pub(crate) integrator: Vec<f64>,
    pub(crate) own_step_s: f64,
}

/// A contact that touched at the last detection.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Touch {
    pub(crate) id: Contact,
    pub(crate) kinematics: Kinematics,
    pub(crate) held: bool,
    pub(crate) known: bool,
    pub(crate) friction: Option<Friction>,
    /// Rolling, then spinning.
    pub(crate) rotation: [Option<Friction>; 2],
}

/// Pairs that may touch, and the search for their impacts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct NearPairs {
    /// Lower and upper bounds of the boxes.
    pub(crate) boxes: Vec<Option<[Vector; 2]>>,
    pub(crate) watches: Vec<Watch>,
    pub(crate) partners: Vec<Vec<usize>>,
    pub(crate) flight_end: f64,
}

/// What is known of a pair that may touch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Watch {
    pub(crate) a: usize,
    pub(crate) b: usize,
    pub(crate) until: f64,
    pub(crate) impact: f64,
}

/// What a joint bore in a step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct JointLoad {
    /// Number of the joint.
    pub(crate) joint: usize,
    pub(crate) force_n: Vector,
    pub(crate) moment_n_m: Vector,
    /// What of it acts along its coordinates, by cause, N m and N.
    pub(crate) efforts: [f64; 18],
}

/// The tier `stepped`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Stepped {
    pub(crate) states: Vec<State>,
    pub(crate) flights: Vec<Option<Flight>>,
    /// Contacts that carried an impulse in the last step of their pair.
    pub(crate) carried: Vec<Contact>,
    pub(crate) last_forces: LastForces,
    pub(crate) touching: Vec<(usize, usize)>,
    pub(crate) forces: Vec<(Contact, f64)>,
    pub(crate) islands: Vec<Vec<usize>>,
    /// Friction of the contacts of `forces`, N.
    pub(crate) friction: Vec<[f64; 3]>,
    /// What the joints bore in the last step; none before the first one.
    pub(crate) loads: Option<Vec<JointLoad>>,
    /// Whether each body rests and is left out of the steps.
    pub(crate) resting: Vec<bool>,
    pub(crate) grid: u64,
    pub(crate) begun: bool,
}

/// The forces that the next time step starts from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct LastForces {
    pub(crate) contacts: Vec<LastForce>,
    /// Of the rows of each bilateral constraint, N.
    pub(crate) bilaterals: Vec<(Held, Vec<f64>)>,
}

/// The force of a contact in the last time step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct LastForce {
    pub(crate) id: Contact,
    /// Along its normal, N.
    pub(crate) normal: f64,
    /// In its tangent plane, N.
    pub(crate) along: Vector,
    /// N m.
    pub(crate) moment: Vector,
}

/// A bilateral constraint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) enum Held {
    /// The pivot of a body.
    Pivot(usize),
    /// A joint and its bodies.
    Joint(usize, (usize, usize)),
    /// A gear or a prescribed motion, by its number, and two of its bodies.
    Tie(usize, (usize, usize)),
}

/// The tier `micro-collisions`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct MicroCollisions {
    pub(crate) states: Vec<State>,
    /// Contacts with their mean forces of the last step: along the normal, and friction, N.
    pub(crate) forces: Vec<(Contact, f64, Vector)>,
    pub(crate) touching_pairs: usize,
    /// The variables from which the integrator continues.
    pub(crate) integrator: Vec<f64>,
}

/// The tier `fast`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Fast {
    pub(crate) states: Vec<State>,
    /// Pairs of bodies near each other, ascending.
    pub(crate) pairs: Vec<PairPatches>,
    /// Length of a substep of the last step, s.
    pub(crate) last_h: f64,
    pub(crate) resting: Vec<bool>,
    /// How often in a row each body was slow.
    pub(crate) quiet: Vec<u32>,
    /// Pairs that pressed on each other in the last step, ascending.
    pub(crate) touching: Vec<(usize, usize)>,
    /// Joints and pivots after the last step.
    pub(crate) held: Vec<HeldJoint>,
    /// Limits of joints that pressed in the last substep, with their impulses, N s.
    pub(crate) limits: Vec<(Contact, f64)>,
    pub(crate) grid: u64,
    pub(crate) begun: bool,
}

/// What holds bodies after a step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct HeldJoint {
    pub(crate) kind: HeldKind,
    /// Of the joint, or of the body with the pivot.
    pub(crate) number: usize,
    /// The body that the load is on.
    pub(crate) body: usize,
    /// Impulses of the rows in the last substep, N s.
    pub(crate) multipliers: [f64; 6],
    /// Mean force (N), and moment about the centre of mass (N m), in the last step.
    pub(crate) load: [Vector; 2],
}

/// What holds a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum HeldKind {
    Joint,
    Pivot,
}

/// Where two bodies may touch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PairPatches {
    pub(crate) pair: (usize, usize),
    pub(crate) found: Option<FoundAt>,
    /// The normal of each patch in the frame of the second body, and its points.
    pub(crate) patches: Vec<(Vector, Vec<PatchPoint>)>,
}

/// At which relative pose patches were found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct FoundAt {
    /// w, x, y, z, and m.
    pub(crate) pose: ([f64; 4], Vector),
    /// m.
    pub(crate) reach: f64,
    pub(crate) separation: f64,
}

/// A point of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct PatchPoint {
    pub(crate) id: Contact,
    /// In the frames of the two bodies, m.
    pub(crate) on: [Vector; 2],
    /// Impulse of the last substep (N s) and mean force of the last step (N).
    pub(crate) normal: [f64; 2],
    pub(crate) friction: [Vector; 2],
}

/// The tier `thesis`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Thesis {
    pub(crate) states: Vec<State>,
    pub(crate) resting: Vec<(Contact, f64)>,
    pub(crate) touching_pairs: usize,
    /// The variables from which the integrator continues.
    pub(crate) integrator: Vec<f64>,
}
