//! Errors of a scene: why it is refused.

use super::MotionError;
use crate::scene::few_digits::{self, length};
use polhode_contact::ShapeError;
use polhode_dynamics::field::FieldError;
use polhode_response::penalty::SpringError;
use thiserror::Error;

/// Why a scene is refused. Each message names the place, the value and what is accepted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A number is outside what is accepted.
    #[error("{key} = {value} is not accepted: {accepted} is needed")]
    Number {
        /// The key.
        key: &'static str,
        /// The value found.
        value: f64,
        /// What is accepted.
        accepted: &'static str,
    },
    /// A coefficient of friction is negative or not finite.
    #[error("friction of material {material} is {value}: a finite number of at least 0 is needed")]
    Friction {
        /// The material.
        material: String,
        /// The value found.
        value: f64,
    },
    /// A coefficient of static friction is below that of kinetic friction, or not finite.
    #[error(
        "static friction of material {material} is {value}: a finite number of at least its kinetic friction {kinetic} \
         is needed"
    )]
    StaticFriction {
        /// The material.
        material: String,
        /// The value found.
        value: f64,
        /// The coefficient of kinetic friction.
        kinetic: f64,
    },
    /// Coefficients of friction along and across a grain are not positive, or too different.
    #[error(
        "friction of material {material} is along = {along}, across = {across}: two finite positive numbers are \
         needed, neither more than {ratio} times the other"
    )]
    FrictionEllipse {
        /// The material.
        material: String,
        /// The coefficient along the grain.
        along: f64,
        /// That across it.
        across: f64,
        /// The largest ratio.
        ratio: f64,
    },
    /// The direction of a grain is zero or not finite.
    #[error(
        "the direction of friction of material {material} is {direction:?}: a finite vector that is not zero is needed"
    )]
    GrainDirection {
        /// The material.
        material: String,
        /// The vector found.
        direction: [f64; 3],
    },
    /// The velocity of a kinematic body jumps during the run, and it may touch a body that forces move.
    #[error(
        "the motion of body {body} has interpolation = \"linear\", so that its velocity jumps at t = {t_s} s: where it \
         touches body {other}, that is an impulse of which the table does not say how it passes (as a bounce, a push, \
         or a slip); use interpolation = \"monotone\" with samples close before and after the turn, or name both \
         bodies in a [[no_contact]] group"
    )]
    MotionJumps {
        /// The kinematic body.
        body: String,
        /// The first body that it may touch.
        other: String,
        /// When its velocity jumps first, s.
        t_s: f64,
    },
    /// Static friction along and across a grain for a material without one.
    #[error(
        "static friction of material {material} is given along and across a grain, but its friction has none: give \
         friction = {{ along, across, direction }} too, or one number for static friction"
    )]
    StaticGrain {
        /// The material.
        material: String,
    },
    /// Two materials that may meet both have a grain, or it is not clear which of two bodies has it.
    #[error(
        "it is not clear whose grain friction of materials {} and {} is along: give the pair friction of its own, as a \
         number, or with a direction where the materials differ (that of the first one)",
        materials[0], materials[1]
    )]
    TwoGrains {
        /// Their names.
        materials: [String; 2],
    },
    /// A rule gives friction along and across a grain that neither material has.
    #[error(
        "friction of materials {} and {} is given along and across a grain, but neither has one: give the rule a \
         direction, in the frame of bodies of the first material",
        materials[0], materials[1]
    )]
    NoGrain {
        /// Their names.
        materials: [String; 2],
    },
    /// Friction of rolling or spinning is negative or not finite.
    #[error("{kind}_friction of material {material} is {value}: a finite length of at least 0 m is needed")]
    RotationalFriction {
        /// The material.
        material: String,
        /// `rolling` or `spinning`.
        kind: &'static str,
        /// The value found, m.
        value: f64,
    },
    /// A modulus of elasticity or Poisson's ratio is out of range.
    #[error("{key} of material {material} is {value}: {accepted} is needed")]
    ElasticConstant {
        /// The material.
        material: String,
        /// The key.
        key: &'static str,
        /// The value found.
        value: f64,
        /// What is accepted.
        accepted: &'static str,
    },
    /// A knob of the springs contradicts another one.
    #[error("method.penalty.{key} cannot be given here: {reason}")]
    PenaltyKnob {
        /// The knob.
        key: &'static str,
        /// Why, and what to do.
        reason: &'static str,
    },
    /// Springs after Hertz between two materials without moduli.
    #[error(
        "law = \"hertz\" needs youngs_modulus_pa and poisson_ratio of material {} or {}, which may meet: one of both \
         may be left without (it is rigid), or give law = \"linear\"",
        materials[0], materials[1]
    )]
    HertzModulus {
        /// Their names.
        materials: [String; 2],
    },
    /// Springs after Hertz for a shape without radii of curvature.
    #[error(
        "law = \"hertz\" needs radii of curvature, and the shape of body {body} has none that it knows: it takes \
         balls, on balls and on half-spaces, boxes and other polyhedra that do not move by forces; give law = \
         \"linear\""
    )]
    HertzShape {
        /// The body.
        body: String,
    },
    /// A restitution that no damped spring reaches.
    #[error("materials {} and {}: {source}", materials[0], materials[1])]
    SpringRestitution {
        /// Their names.
        materials: [String; 2],
        /// What is reached.
        source: SpringError,
    },
    /// A joint that cannot hold anything.
    #[error("joint number {number} (counted from 0): {reason}")]
    Joint {
        /// Its number.
        number: usize,
        /// What is wrong, and what is accepted.
        reason: &'static str,
    },
    /// The velocities of the bodies of a joint would part them at the start.
    #[error(
        "joint number {number} (counted from 0): its bodies part by {apart_m_s} m/s at the anchor at the start: give \
         them velocities that agree there, v + w x (anchor - centre of mass)"
    )]
    JointMoves {
        /// Its number.
        number: usize,
        /// Their relative velocity at the anchor, m/s.
        apart_m_s: f64,
    },
    /// The angular velocities of the bodies of a joint would turn them out of it at the start.
    #[error(
        "joint number {number} (counted from 0): its bodies turn on each other by {across_rad_s} rad/s across its axis \
         at the start: give them angular velocities that differ along the axis alone"
    )]
    JointTurns {
        /// Its number.
        number: usize,
        /// Their relative angular velocity across the axis, rad/s.
        across_rad_s: f64,
    },
    /// A joint begins beyond a limit of one of its coordinates.
    #[error(
        "joint {number} begins at a {coordinate} of {start} {unit}, beyond its limits from {lower} to {upper}: limits \
         that contain the start are needed"
    )]
    JointBeyondLimits {
        /// Its number.
        number: usize,
        /// The coordinate.
        coordinate: &'static str,
        /// Its unit.
        unit: &'static str,
        /// Its value at the start.
        start: f64,
        /// The lower limit.
        lower: f64,
        /// The upper limit.
        upper: f64,
    },
    /// A body begins off its track.
    #[error(
        "joint {number} begins {how}, {} mm away: at most {} mm are taken as digits of a file, and its anchor is moved \
         onto the track; place the body on it",
        few_digits::number(*distance_mm),
        few_digits::number(*most_mm)
    )]
    OffTrack {
        /// Its number.
        number: usize,
        /// In which way.
        how: &'static str,
        /// How far, mm.
        distance_mm: f64,
        /// How far it may be, mm.
        most_mm: f64,
    },
    /// A gear that cannot couple two joints.
    #[error("gear number {number} (counted from 0): {reason}")]
    Gear {
        /// Its number.
        number: usize,
        /// What is wrong, and what is accepted.
        reason: &'static str,
    },
    /// The velocities at the start do not agree with a gear.
    #[error(
        "gear number {number} (counted from 0): its first joint moves at {found} at the start where the ratio times \
         the rate of the second one is {needed} (rad/s or m/s): give the bodies velocities that agree"
    )]
    GearRate {
        /// Its number.
        number: usize,
        /// The rate of the first joint, rad/s or m/s.
        found: f64,
        /// That of the second one times the ratio.
        needed: f64,
    },
    /// A prescribed motion of a coordinate that a joint cannot follow.
    #[error("the prescribed motion of joint number {joint} (counted from 0): {reason}")]
    CoordinateMotion {
        /// The number of the joint.
        joint: usize,
        /// What is wrong, and what is accepted.
        reason: &'static str,
    },
    /// The velocities at the start do not agree with a prescribed motion.
    #[error(
        "the prescribed motion of joint number {joint} (counted from 0) begins at a rate of {needed}, but its bodies \
         have {found} (rad/s or m/s): give them velocities that agree"
    )]
    CoordinateRate {
        /// The number of the joint.
        joint: usize,
        /// The rate that the bodies have, rad/s or m/s.
        found: f64,
        /// The rate with which the motion begins.
        needed: f64,
    },
    /// Joints in a tier that has none.
    #[error("joints are not yet available in tier `{tier}`: use tier {instead}")]
    JointsInTier {
        /// The tier.
        tier: &'static str,
        /// The tiers that have them, in words.
        instead: String,
    },
    /// Joints with an integrator that advances bodies one by one.
    #[error("integrator `{integrator}` does not solve for joints: leave it out, or use `dop853` or `rk4`")]
    JointsWithIntegrator {
        /// The integrator.
        integrator: &'static str,
    },
    /// Friction in a tier that has none.
    #[error("the tier `{tier}` has no friction: use tier {instead}, or friction 0 in all materials")]
    FrictionInTier {
        /// The tier.
        tier: &'static str,
        /// The tiers that have friction, in words.
        instead: String,
    },
    /// A coefficient of restitution is outside [0, 1].
    #[error("restitution of material {material} is {value}: a number in [0, 1] is needed")]
    Restitution {
        /// The material.
        material: String,
        /// The value found.
        value: f64,
    },
    /// Restitution would rise with speed, or its dependence on speed is no number.
    #[error("{quantity} of material {material} is {value}: {accepted} is needed")]
    RestitutionSpeed {
        /// The material.
        material: String,
        /// The key.
        quantity: &'static str,
        /// The value found.
        value: f64,
        /// What is accepted.
        accepted: &'static str,
    },
    /// A position or velocity is not finite.
    #[error("body {body}: {quantity} has a component that is not finite")]
    NotFinite {
        /// The body.
        body: String,
        /// What is not finite.
        quantity: &'static str,
    },
    /// Two bodies have one name.
    #[error("two bodies are named {0}: give each body a name of its own")]
    DuplicateName(String),
    /// A name is empty.
    #[error("body number {0} (counted from 0) has an empty name: give it a name")]
    EmptyName(usize),
    /// A fixed body is given a velocity.
    #[error("body {0} is fixed and has a velocity: leave the velocity out, or give the body a mass or a motion")]
    FixedBodyMoves(String),
    /// A kinematic body is given a velocity.
    #[error(
        "body {0} has a prescribed motion and a velocity: the motion determines its velocity, leave the velocity out"
    )]
    KinematicBodyHasVelocity(String),
    /// A kinematic body is given a pivot.
    #[error("body {0} has a prescribed motion and a pivot: the motion alone determines its poses, leave the pivot out")]
    KinematicBodyPivots(String),
    /// The initial pose of a kinematic body is not that of its motion at t = 0.
    #[error("body {body}: {source}")]
    Motion {
        /// The body.
        body: String,
        /// Why.
        source: MotionError,
    },
    /// A half-space is given to a body that forces move.
    #[error("body {0} is a half-space, which is unbounded: it must be fixed or kinematic")]
    MovingHalfSpace(String),
    /// A triangle surface is given to a body that forces move.
    #[error(
        "body {0} is a triangle surface, which encloses no volume: it must be fixed or kinematic; a body that forces \
         move needs a closed mesh"
    )]
    MovingSurface(String),
    /// A `no_contact` group names a body that does not exist.
    #[error("no_contact names body number {0} (counted from 0), which does not exist")]
    UnknownBody(usize),
    /// A force names a body that does not exist.
    #[error("force number {force} names body number {body}, which does not exist (both counted from 0)")]
    ForceOnUnknownBody {
        /// Index of the force.
        force: usize,
        /// Index of the body.
        body: usize,
    },
    /// A number of a force is out of range.
    #[error("force number {force} (counted from 0): {source}")]
    Force {
        /// Index of the force.
        force: usize,
        /// Why.
        source: FieldError,
    },
    /// The scene's integrator cannot integrate one of its forces.
    #[error(
        "integrator {integrator} cannot integrate a force that depends on velocities (drag, damping): use dop853 or rk4"
    )]
    IntegratorTakesNoVelocities {
        /// Its name.
        integrator: &'static str,
    },
    /// A fixed body is given a pivot.
    #[error(
        "body {0} is fixed and has a pivot, about which it cannot turn: leave the pivot out, or give the body a mass"
    )]
    FixedBodyPivots(String),
    /// The velocity of a pivoted body would move its pivot.
    #[error(
        "body {body} has a pivot, but its velocity differs by {difference:e} m/s from the one that its angular \
         velocity gives it about the pivot, {needed:?} m/s: give that one, or leave the velocity out"
    )]
    PivotMoves {
        /// The body.
        body: String,
        /// Magnitude of the difference, m/s.
        difference: f64,
        /// The velocity of the centre of mass that the angular velocity gives, m/s.
        needed: [f64; 3],
    },
    /// Reduced coordinates are asked for in a scene for which there are none.
    #[error("method.coordinates = \"reduced\" is not available here: {reason}; \"maximal\" always is")]
    ReducedCoordinates {
        /// What is in the way.
        reason: String,
    },
    /// The scene asks for something that is designed but not implemented.
    #[error("not yet available: {what}; use {instead}")]
    NotYetAvailable {
        /// What was asked for.
        what: String,
        /// What can be used instead.
        instead: String,
    },
    /// A shape cannot be expressed in the moving frame of its body.
    #[error("body {body}: {source}")]
    Shape {
        /// The body.
        body: String,
        /// Why.
        source: ShapeError,
    },
    /// Bodies overlap at the start by more than counts as touch.
    #[error("{}: move them apart, or name both in a no_contact group", overlapping(_0))]
    InitialOverlap(Vec<OverlapAtStart>),
    /// A run would have more samples than it can ever write.
    #[error(
        "a run of duration = {duration_s:e} s with a sample every output.interval = {interval_s:e} s has more than \
         1e12 samples: shorten the duration, or lengthen the interval"
    )]
    TooManySamples {
        /// The duration, s.
        duration_s: f64,
        /// Time between samples, s.
        interval_s: f64,
    },
    /// A run would have more steps than it can ever make.
    #[error(
        "a run of duration = {duration_s:e} s in steps of method.step = {step_s:e} s has more than 1e12 steps: shorten \
         the duration, or lengthen the step"
    )]
    TooManySteps {
        /// The duration, s.
        duration_s: f64,
        /// The step, s.
        step_s: f64,
    },
}

/// Two bodies that overlap at the start by more than counts as touch.
#[derive(Debug, Clone, PartialEq)]
pub struct OverlapAtStart {
    /// One body.
    pub body_a: String,
    /// The other body.
    pub body_b: String,
    /// How deep they overlap, m.
    pub depth_m: f64,
    /// Largest overlap that counts as touch, m.
    pub allowed_m: f64,
}

/// Most bodies that a sentence names: more do not help.
pub(crate) const MOST_NAMES: usize = 4;

/// Most pairs that a message tells in a line each.
const MOST_PAIRS: usize = 10;

/// That bodies overlap, in a line for each pair.
fn overlapping(pairs: &[OverlapAtStart]) -> String {
    let sentence = |pair: &OverlapAtStart| {
        let OverlapAtStart { body_a, body_b, depth_m, allowed_m } = pair;
        format!(
            "bodies {body_a} and {body_b} overlap by {} at the start, and at most {} counts as touch",
            length(*depth_m),
            length(*allowed_m)
        )
    };
    if let [pair] = pairs {
        return sentence(pair);
    }
    let mut lines = vec![format!("{} pairs of bodies overlap at the start", pairs.len())];
    lines.extend(pairs.iter().take(MOST_PAIRS).map(sentence));
    match pairs.len().saturating_sub(MOST_PAIRS) {
        0 => {}
        1 => lines.push("and one more pair".to_owned()),
        more => lines.push(format!("and {more} more pairs")),
    }
    lines.join("\n  ")
}

/// `value` when it is positive and finite.
pub(crate) fn positive(key: &'static str, value: f64) -> Result<f64, SceneError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(SceneError::Number { key, value, accepted: "a positive number" })
    }
}
