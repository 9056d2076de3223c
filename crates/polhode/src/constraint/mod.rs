//! Constraints of all kinds, with a common identity.
//!
//! | constraint | law of its rows | signed event functions |
//! |---|---|---|
//! | contact | push; with tangents a cone, or a slide | separation; margin of features; margin to contact break |
//! | the same, with friction | | besides: slip and rotation against their directions; margin of the cone |
//! | pivot | hold, three rows | none: it never breaks |
//! | joint | hold, rows of its kind (`joint.rs`) | its strength less its load, if it has one (`breaking.rs`) |
//! | tie: a gear, or a prescribed motion of a joint (`tie.rs`) | hold, one row | none: it never breaks |
//! | stop: a limit of a joint (`stop.rs`) | push, as a contact without friction | separation; margin to contact break |
//! | track with one side: a stop across it (`track.rs`) | push, as a stop | as of a stop |
//! | the end of an open track (`released.rs`) | none | where the joint lets go |
//! | friction of a joint (`joint_friction.rs`) | a rough contact that a force presses | slip; margin of the cone |
//!
//! Whoever adds a kind of joint adds one file, its line in the list of `joint.rs`, and its data in `scene/joint.rs`.
//!
//! An event function is positive before the event and crosses zero there. Within a step of bodies that hold each other
//! one locator (`crate::constraint::locator`) finds the time, on the motion of the step; at how many times it looks,
//! and what it does not see between two of them, `accurate/locate.rs` says. When bodies that are apart meet is found by
//! bounds on their motions, which overlook nothing (`polhode-contact`).
//!
//! | module | holds |
//! |---|---|
//! | `joint`, `kept` | the kinds of joints, and the parts that each keeps of the relative motion |
//! | `point`, `line`, `perpendicular`, `thread` | the rows that joints are put together from |
//! | `hinge`, `slider`, `fixed`, `universal`, `cylindrical`, `screw`, `planar`, `on_track` | one kind of joint each |
//! | `tree_joint` | the kinds whose relative motion has coordinates of its own |
//! | `coordinate`, `coordinate_at`, `joint_coordinate`, `turns` | coordinates of joints: value, rate, row, turns |
//! | `joint_forces`, `motors`, `joint_power` | springs, dampers and motors along coordinates; what they give |
//! | `softness`, `soft_rows` | the same as soft rows of a time step |
//! | `tie`, `ties` | gears and prescribed motions of coordinates |
//! | `stop`, `joint_friction`, `joint_contacts` | limits and dry friction of coordinates: contacts at joints |
//! | `track`, `track_frame`, `track_springs` | curves that bodies follow |
//! | `bilateral`, `row`, `end`, `held` | rows of forces of either sign, their bodies, and whom they hold |
//! | `breaking`, `released`, `added` | joints that break, let go, or are added by a program |
//! | `joint_error` | how far joints are from what they keep |
//! | `at_start`, `tie_checks` | whether the velocities of a scene at the start are what joints and ties leave free |
//! | `start_velocities` | velocities at the start of mechanisms that are driven |
//! | `locator` | the time of an event within a step |

mod at_start;
pub(crate) mod coordinate;
pub(crate) mod coordinate_at;
mod cylindrical;
pub(crate) mod end;
mod fixed;
mod hinge;
pub(crate) mod joint;
pub(crate) mod joint_coordinate;
pub(crate) mod joint_forces;
pub(crate) mod kept;
mod line;
pub(crate) mod locator;
mod on_track;
mod perpendicular;
mod planar;
mod point;
pub(crate) mod row;
mod screw;
mod slider;
pub(crate) mod softness;
mod start_velocities;
pub(crate) mod stop;
mod thread;
pub(crate) mod tie;
mod tie_checks;
pub(crate) mod track;
pub(crate) mod track_frame;
pub(crate) mod track_springs;
pub(crate) mod tree_joint;
mod universal;

use crate::identity::contact_id::ContactId;
use polhode_contact::ContactKinematics;

/// Identity of a constraint: contacts before pivots, then joints, then ties, each in its own order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum ConstraintId {
    /// A contact point, by its bodies and the features that meet.
    Contact(ContactId),
    /// The pivot of a body.
    Pivot {
        /// The body's number.
        body: usize,
    },
    /// A joint.
    Joint {
        /// Its number in the scene.
        joint: usize,
        /// Its bodies; the same body twice if it connects the body to the world.
        bodies: (usize, usize),
    },
    /// A tie.
    Tie {
        /// Its number.
        tie: usize,
        /// Two of its movable bodies; the same body twice if it has one.
        bodies: (usize, usize),
    },
}

impl ConstraintId {
    /// The two bodies that it connects; the same body twice if it connects the body to the world.
    pub(crate) fn bodies(&self) -> (usize, usize) {
        match *self {
            Self::Contact(id) => (id.a, id.b),
            Self::Pivot { body } => (body, body),
            Self::Joint { bodies, .. } | Self::Tie { bodies, .. } => bodies,
        }
    }

    /// The contact, if it is one.
    pub(crate) fn contact(&self) -> Option<ContactId> {
        match *self {
            Self::Contact(id) => Some(id),
            Self::Pivot { .. } | Self::Joint { .. } | Self::Tie { .. } => None,
        }
    }
}

/// Signed event functions of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ContactEvent {
    /// The contact closes: the separation, m.
    Closing,
    /// The contact point leaves its features: the margin, m.
    Leaving,
}

impl ContactEvent {
    /// The value at these kinematics, m.
    pub(crate) fn value(self, contact: &ContactKinematics) -> f64 {
        match self {
            Self::Closing => contact.geometry.separation,
            Self::Leaving => contact.geometry.margin,
        }
    }
}
