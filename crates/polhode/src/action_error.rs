//! Errors of actions: why a simulation refuses what a program wants to do to a body.

use crate::scene::MotionError;
use crate::scene::few_digits::length;
use thiserror::Error;

/// Why an action is refused. The simulation is as it was before.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ActionError {
    /// The handle belongs to no body of this simulation.
    #[error(
        "body number {index} (counted from 0) does not exist: the simulation has {bodies} bodies; use a handle that \
         this simulation gave"
    )]
    UnknownBody {
        /// Index of the handle.
        index: usize,
        /// How many bodies there are.
        bodies: usize,
    },
    /// The body has been removed.
    #[error("body {0} has been removed: nothing can be done to it any more")]
    RemovedBody(String),
    /// The body is fixed or kinematic, and no action moves it.
    #[error(
        "body {0} is fixed or has a prescribed motion: a program cannot give it a force, an impulse, a velocity or a \
         pose; set_motion steers a body with a prescribed motion"
    )]
    FixedBody(String),
    /// The body is not kinematic, and has no motion that a program could set.
    #[error("body {0} has no prescribed motion: only a kinematic body follows a motion that a program sets")]
    NotKinematic(String),
    /// The time within which a pose is to be reached is none.
    #[error(
        "body {body} cannot reach a pose within {within_s} s from t = {now_s} s on: a finite time is needed, large \
         enough to change t"
    )]
    Time {
        /// The body.
        body: String,
        /// The time, s.
        within_s: f64,
        /// The present, s.
        now_s: f64,
    },
    /// The motion that a program sets is too fast.
    #[error("the motion of body {body} is refused: {source}")]
    Motion {
        /// The body.
        body: String,
        /// Why.
        source: MotionError,
    },
    /// No body has a material of this name.
    #[error("no body has the material `{name}`: the materials of the bodies are {known}")]
    UnknownMaterial {
        /// The name.
        name: String,
        /// Those that there are.
        known: String,
    },
    /// A number is not finite.
    #[error("{what} of body {body} has a component that is not finite: finite numbers are needed")]
    NotFinite {
        /// The body.
        body: String,
        /// What is not finite.
        what: &'static str,
    },
    /// The body would overlap another one.
    #[error(
        "body {body_a} would overlap body {body_b} by {}, and at most {} counts as touch: choose another pose",
        length(*depth_m),
        length(*allowed_m)
    )]
    Overlap {
        /// The body.
        body_a: String,
        /// The other body.
        body_b: String,
        /// How deep, m.
        depth_m: f64,
        /// Largest overlap that counts as touch, m.
        allowed_m: f64,
    },
    /// The handle belongs to no joint of this simulation.
    #[error(
        "joint number {index} (counted from 0) does not exist: the simulation has {joints} joints; use a handle that \
         the scene or add_joint gave"
    )]
    UnknownJoint {
        /// Number of the joint.
        index: usize,
        /// How many joints there are.
        joints: usize,
    },
    /// The joint is not there any more.
    #[error(
        "joint number {0} (counted from 0) holds nothing any more: it was removed, with a body of its, or it has let go"
    )]
    RemovedJoint(usize),
    /// A body on a pivot, whose motion is that of its rotation alone, is to be held by a joint.
    #[error(
        "body {0} is on a pivot, and its motion is computed as a rotation about it alone: no joint can be added to it; \
         give it a ball joint in the place of the pivot"
    )]
    JointOnPivot(String),
    /// The joint does not exist, or does not have this coordinate.
    #[error(
        "joint number {joint} (counted from 0) has no coordinate `{coordinate}` that a motor can drive, or does not \
         exist: use a handle that the scene gave, a coordinate of its kind, and a joint without a kinematic body"
    )]
    NoCoordinate {
        /// Number of the joint.
        joint: usize,
        /// The coordinate.
        coordinate: &'static str,
    },
    /// The pose would move the body away from its pivot.
    #[error("the pose would move body {0} away from its pivot: choose a pose that turns it about the pivot")]
    PivotedBody(String),
    /// The pose would move the body beyond a limit of a joint.
    #[error(
        "the pose would move body {0} beyond a limit of a joint: choose a pose within the range of its coordinates"
    )]
    BeyondLimits(String),
    /// The pose would move the body out of a joint.
    #[error("the pose would move body {0} out of a joint: choose a pose that the joint leaves free")]
    JointedBody(String),
}
