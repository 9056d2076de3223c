//! Compression and restitution: where an impact ends.
//!
//! The compression ends where the normal velocity `u_n` reaches zero. What follows lasts until
//!
//! - Newton: `u_n = -e u_n-`;
//! - Poisson: the normal impulse since then is `e` times that of the compression;
//! - Stronge: the normal impulse has given back `e^2` of the work that it took.
//!
//! Should `u_n` become negative again before that (slip in space may turn into a direction that jams), the bodies are
//! compressed once more, and the last end of compression counts.
//!
//! Source: Poisson 1811; Stronge 1990.

/// What restitution is measured by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    Velocity,
    Impulse,
    Work,
}

/// The law of restitution of one impact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Restitution {
    pub(super) measure: Measure,
    /// `e`, from 0 to 1.
    pub(super) coefficient: f64,
    /// `-u_n-`, m/s.
    pub(super) approach: f64,
}

/// What is left to be reached.
#[derive(Debug, Clone, Copy)]
pub(super) enum Stage {
    /// Until `u_n = 0`.
    Compression,
    /// Until `u_n` is this, m/s.
    UntilVelocity(f64),
    /// For this normal impulse more, N s.
    ForImpulse(f64),
    /// Until the normal impulse has done this work more, J.
    ForWork(f64),
}

impl Restitution {
    /// What follows a compression with a total normal impulse (N s) and work (J, negative); none when nothing does.
    pub(super) fn after_compression(&self, impulse: f64, work: f64) -> Option<Stage> {
        let e = self.coefficient;
        let (stage, amount) = match self.measure {
            Measure::Velocity => (Stage::UntilVelocity(e * self.approach), e * self.approach),
            Measure::Impulse => (Stage::ForImpulse(e * impulse), e * impulse),
            Measure::Work => (Stage::ForWork(-e * e * work), -e * e * work),
        };
        (amount > 0.0).then_some(stage)
    }
}

/// What an increment of a path has added, and where it has come to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Added {
    pub(super) impulse: f64,
    pub(super) work: f64,
}

impl Stage {
    /// What is left after an increment.
    pub(super) fn after(self, added: Added) -> Self {
        match self {
            Self::Compression | Self::UntilVelocity(_) => self,
            Self::ForImpulse(left) => Self::ForImpulse((left - added.impulse).max(0.0)),
            Self::ForWork(left) => Self::ForWork((left - added.work).max(0.0)),
        }
    }
}

/// What happens at the end of a piece of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Happening {
    /// The piece was as long as it may be, nothing else.
    PieceEnds,
    /// The contact stops slipping.
    SlipStops,
    /// `u_n` reaches zero from below.
    CompressionEnds,
    /// `u_n` falls to zero again.
    CompressionBegins,
    /// The restitution is over.
    ImpactEnds,
    /// No impulse, however large, leads on.
    Wedged,
}
