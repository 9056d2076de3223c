//! What happens at an instant.

use polhode_spatial::DVec3;

/// Kinds of event; the words are those of the events file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// The force of one contact point has reached zero and the contact opens.
    Detach,
}

impl EventKind {
    /// The word used in files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Impact => "impact",
            Self::ContactBegin => "contact_begin",
            Self::ContactEnd => "contact_end",
            Self::Rest => "rest",
            Self::Wake => "wake",
            Self::Detach => "detach",
        }
    }
}

/// An event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// When, s.
    pub t: f64,
    /// What.
    pub kind: EventKind,
    /// Body A, by its number in the scene.
    pub body_a: usize,
    /// Body B, when there is one.
    pub body_b: Option<usize>,
    /// Where, world, m.
    pub point: DVec3,
    /// Contact normal, from B to A, world; zero where there is none.
    pub normal: DVec3,
    /// Impulse on A along the normal, N s.
    pub impulse: f64,
    /// Change of kinetic energy, J.
    pub energy_change_j: f64,
}
