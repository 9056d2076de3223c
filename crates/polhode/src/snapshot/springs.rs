//! The content of a snapshot in the tier `penalty`: contacts with their springs, and what these have reached.

use super::numbers::{Contact, State, Vector};
use serde::{Deserialize, Serialize};

/// The tier `penalty`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Penalty {
    pub(crate) states: Vec<State>,
    pub(crate) springs: Vec<ContactSpring>,
    pub(crate) laws: SpringLaws,
    /// Length of step (s) proposed for the group of each body.
    pub(crate) proposed: Vec<f64>,
    /// Bodies of each group of the last step.
    pub(crate) islands: Vec<Vec<usize>>,
    pub(crate) measured: SpringReport,
}

/// What the stiffness of springs follows from: penetration (m), speed (m/s), and for each body the square of the speed
/// of its blows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct SpringLaws {
    pub(crate) depth_m: f64,
    pub(crate) speed: f64,
    pub(crate) blows: Vec<f64>,
}

/// A contact with its springs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[expect(clippy::struct_excessive_bools, reason = "plain data of a record, never passed as arguments")]
pub(crate) struct ContactSpring {
    pub(crate) id: Contact,
    pub(crate) is_hertz: bool,
    pub(crate) stiffness: f64,
    pub(crate) is_plain: bool,
    pub(crate) damping: f64,
    pub(crate) tangential: f64,
    /// Damper of a tangential spring that holds (N s/m), the slip (m) that makes its friction kinetic, the slip (m/s)
    /// that it stops; and what of the second is done.
    pub(crate) holding: [f64; 3],
    pub(crate) slipped: f64,
    /// At rest, sliding.
    pub(crate) friction: Option<[f64; 2]>,
    pub(crate) slip_speed: Option<f64>,
    /// Friction of rolling and spinning (m), and the rate of its regularisation (rad/s).
    pub(crate) resistance: Option<[f64; 3]>,
    pub(crate) restitution: f64,
    pub(crate) mass: f64,
    pub(crate) push: Push,
    pub(crate) loading: bool,
    pub(crate) grip: Grip,
    pub(crate) vector: Vector,
    /// Begin (s), rate of approach (m/s), greatest depth (m) and force (N).
    pub(crate) passage: [f64; 4],
    pub(crate) alone: bool,
}

/// What a normal spring does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Push {
    On,
    Off,
    Cut,
}

/// What friction of a spring does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Grip {
    Free,
    Stick,
    Yield,
    Slide,
    Cut,
    CutSliding,
}

/// What springs were asked for and reached.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct SpringReport {
    pub(crate) asked_m: Option<f64>,
    pub(crate) reached_m: f64,
    pub(crate) impacts: u64,
    pub(crate) first: Vec<SpringImpact>,
    pub(crate) worst: Option<SpringImpact>,
    /// Largest frequency (rad/s), and its largest product with a step.
    pub(crate) fastest: [f64; 2],
    /// Restitution asked and reached where no damper reaches it.
    pub(crate) out_of_reach: Option<[f64; 2]>,
}

/// A contact that has ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct SpringImpact {
    pub(crate) bodies: [usize; 2],
    pub(crate) is_alone: bool,
    pub(crate) numbers: [f64; 7],
}
