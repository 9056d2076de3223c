//! Why an action of a program on a simulation is refused.

use thiserror::Error;

/// Why an action is refused. The simulation is as it was before.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ActionError {
    /// The handle is not one of this simulation's.
    #[error("body number {index} does not exist: the simulation has {bodies} bodies")]
    UnknownBody {
        /// The number of the handle.
        index: usize,
        /// How many bodies there are.
        bodies: usize,
    },
    /// The body has been removed.
    #[error("body {0} has been removed: its handle is no longer of use")]
    RemovedBody(String),
    /// The body never moves.
    #[error("body {0} is fixed: no force, impulse or velocity moves it")]
    FixedBody(String),
    /// A number is not finite.
    #[error("{what} of body {body} has a component that is not finite")]
    NotFinite {
        /// The body.
        body: String,
        /// What is not finite.
        what: &'static str,
    },
    /// The body would overlap another one.
    #[error(
        "body {body_a} would overlap body {body_b} by {depth_m:e} m; at most {allowed_m:e} m counts as touch: choose another pose"
    )]
    Overlap {
        /// The body.
        body_a: String,
        /// The other body.
        body_b: String,
        /// How deep, m.
        depth_m: f64,
        /// What counts as touch, m.
        allowed_m: f64,
    },
    /// The body is held at a pivot, which it cannot leave.
    #[error("body {0} is held at a pivot: it can be turned about it, not moved away from it")]
    PivotedBody(String),
}
