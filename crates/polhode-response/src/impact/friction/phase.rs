//! What a contact does in a part of an impact: slip, stick, reversal, jam.

/// What the contact does in a phase.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum PhaseKind {
    /// It slips, and friction acts against the slip.
    Slip,
    /// It slips, and the impulse drives the bodies further into each other (Painleve): `u_n` falls.
    Jam,
    /// It does not slip.
    Stick,
    /// It slips again after it had stopped, in the direction that the impulse drives it.
    Reversal,
}

/// One phase of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactPhase {
    /// What the contact does.
    pub kind: PhaseKind,
    /// The normal impulse of the phase, N s.
    pub normal_impulse: f64,
    /// Slip at its end along the two tangents, m/s.
    pub slip_after: [f64; 2],
}
