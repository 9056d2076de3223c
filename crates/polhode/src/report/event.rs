//! Events: impacts, and bodies that begin or cease to touch, to rest or to move.

use crate::identity::body_id::BodyId;
use polhode_spatial::DVec3;

/// The kind of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventKind {
    /// An impulse at one contact point.
    Impact,
    /// Two bodies begin to touch.
    ContactBegin,
    /// Two bodies cease to touch.
    ContactEnd,
    /// A body comes to rest.
    Rest,
    /// A resting body begins to move.
    Wake,
    /// The force of one contact point has reached zero, and the contact opens; or a body has run off the end of its
    /// track.
    Detach,
    /// The slip of a contact point with friction has vanished, and the contact sticks.
    Stick,
    /// A contact point that stuck begins to slide.
    Slide,
    /// An impulse at one contact point without a collision: the contact slides, and no system of finite forces
    /// satisfies Coulomb's law (Painleve).
    Jam,
    /// A joint has broken.
    Break,
}

impl EventKind {
    /// The name of the kind in files of events.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Impact => "impact",
            Self::ContactBegin => "contact_begin",
            Self::ContactEnd => "contact_end",
            Self::Rest => "rest",
            Self::Wake => "wake",
            Self::Detach => "detach",
            Self::Stick => "stick",
            Self::Slide => "slide",
            Self::Jam => "jam",
            Self::Break => "break",
        }
    }
}

/// An event.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Event {
    /// Time, s.
    pub t_s: f64,
    /// Kind.
    pub kind: EventKind,
    /// Body A.
    pub body_a: BodyId,
    /// Body B; none for an event of a single body.
    pub body_b: Option<BodyId>,
    /// Position of the contact point or body, world, m.
    pub point: DVec3,
    /// Unit contact normal, from B to A, world; zero for an event without a contact.
    pub normal: DVec3,
    /// Impulse on A along the normal, N s; zero unless the event is an impact or a jam.
    pub impulse: f64,
    /// Change of kinetic energy, J; negative when energy is lost.
    pub energy_change_j: f64,
}

impl Event {
    /// An event of one body at `t_s`, at the world's origin, without a contact and without a change of energy: what
    /// else is known is set afterwards.
    pub const fn new(t_s: f64, kind: EventKind, body_a: BodyId) -> Self {
        let (point, normal) = (DVec3::ZERO, DVec3::ZERO);
        Self { t_s, kind, body_a, body_b: None, point, normal, impulse: 0.0, energy_change_j: 0.0 }
    }
}
