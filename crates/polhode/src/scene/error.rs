//! What can be wrong with a scene.

use super::MotionError;
use polhode_contact::ShapeError;
use polhode_dynamics::field::FieldError;
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
    /// Friction is not a number of at least zero.
    #[error("friction of material {material} is {value}: a number of at least 0 is needed")]
    Friction {
        /// The material.
        material: String,
        /// The value found.
        value: f64,
    },
    /// Restitution is outside [0, 1].
    #[error("restitution of material {material} is {value}: a number in [0, 1] is needed")]
    Restitution {
        /// The material.
        material: String,
        /// The value found.
        value: f64,
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
    #[error("two bodies are named {0}: names must differ")]
    DuplicateName(String),
    /// A name is empty.
    #[error("body number {0} has an empty name")]
    EmptyName(usize),
    /// A fixed body is given a velocity.
    #[error("body {0} is fixed and has a velocity: fixed bodies do not move")]
    FixedBodyMoves(String),
    /// A kinematic body is given a velocity.
    #[error("body {0} has a prescribed motion and a velocity: its velocity is that of the motion, leave it out")]
    KinematicBodyHasVelocity(String),
    /// A kinematic body is given a pivot.
    #[error("body {0} has a prescribed motion and a pivot: its motion is all that moves it, leave the pivot out")]
    KinematicBodyPivots(String),
    /// A kinematic body is given another pose than its motion has at the start.
    #[error("body {body}: {source}")]
    Motion {
        /// The body.
        body: String,
        /// Why.
        source: MotionError,
    },
    /// A half-space is given to a body that moves.
    #[error("body {0} is a half-space, which is unbounded: it must be fixed or kinematic")]
    MovingHalfSpace(String),
    /// A surface of triangles is given to a body that moves.
    #[error(
        "body {0} is a surface of triangles: it must be fixed or kinematic; a body that moves by forces needs a closed mesh"
    )]
    MovingSurface(String),
    /// A group of bodies names one that is not there.
    #[error("no_contact names body number {0}, which does not exist")]
    UnknownBody(usize),
    /// A force names a body that is not there.
    #[error("force number {force} names body number {body}, which does not exist")]
    ForceOnUnknownBody {
        /// Which force.
        force: usize,
        /// The body named.
        body: usize,
    },
    /// A number of a force is out of range.
    #[error("force number {force}: {source}")]
    Force {
        /// Which force.
        force: usize,
        /// Why.
        source: FieldError,
    },
    /// The integrator asked for cannot take a force of the scene.
    #[error(
        "integrator {integrator} cannot take a force that depends on velocities (drag, damping): use dop853 or rk4"
    )]
    IntegratorTakesNoVelocities {
        /// Its name.
        integrator: &'static str,
    },
    /// A fixed body is given a pivot.
    #[error("body {0} is fixed and has a pivot: fixed bodies do not turn")]
    FixedBodyPivots(String),
    /// A pivoted body is given a velocity that moves its pivot.
    #[error(
        "body {body} has a pivot, but its velocity is off by {difference:e} m/s from that of its rotation about it, \
         {needed:?}: give that, or leave the velocity out"
    )]
    PivotMoves {
        /// The body.
        body: String,
        /// How far the velocity is off, m/s.
        difference: f64,
        /// The velocity of the centre of mass that the rotation gives, m/s.
        needed: [f64; 3],
    },
    /// The scene asks for something that is planned but not built.
    #[error("not yet available: {what}; use {instead}")]
    NotYetAvailable {
        /// What was asked for.
        what: String,
        /// What can be used instead.
        instead: String,
    },
    /// A shape cannot be moved into the body's central frame.
    #[error("body {body}: {source}")]
    Shape {
        /// The body.
        body: String,
        /// Why.
        source: ShapeError,
    },
    /// Two bodies overlap at the start by more than touch.
    #[error(
        "bodies {body_a} and {body_b} overlap by {depth_m:e} m at the start; at most {allowed_m:e} m counts as touch: move them apart"
    )]
    InitialOverlap {
        /// One body.
        body_a: String,
        /// The other body.
        body_b: String,
        /// How deep they overlap, m.
        depth_m: f64,
        /// What counts as touch, m.
        allowed_m: f64,
    },
}

/// `value` when it is positive and finite.
pub(super) fn positive(key: &'static str, value: f64) -> Result<f64, SceneError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(SceneError::Number { key, value, accepted: "a positive number" })
    }
}
