//! The choice of an impact law with friction.

use super::springs::PulseExponent;

/// The law of restitution of an impact with friction at one contact that is struck alone.
///
/// The first three follow the velocity along the impact (Routh, Keller), so that slip may turn, stop and reverse in it;
/// they differ in where the restitution ends. The last two are algebra on the velocity before. Without friction, and
/// where slip neither stops nor turns, all measures of restitution agree.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum RestitutionLaw {
    /// The normal impulse gives back `e^2` of the work that it took (Stronge 1990). Never raises the energy.
    #[default]
    Stronge,
    /// The normal impulse of restitution is `e` times that of compression (Poisson).
    Poisson,
    /// `u_n+ = -e u_n-`. May raise the energy where slip stops or reverses.
    Newton,
    /// `u_n+ = -e u_n-`, and either the slip afterwards is zero, or friction is `mu p_n` against the slip before
    /// (Whittaker 1904). What Kane and Levinson found to raise the energy of a double pendulum.
    Whittaker,
    /// `u_n+ = -e u_n-`, and a tangential restitution `e_t`: `u_t+ = -e_t u_t-` where friction suffices and normal and
    /// tangential motion are not coupled; otherwise on the border of the cone (Chatterjee and Ruina 1998). Algebra
    /// alone, and never raises the energy. `e_t = 0` sticks, `e_t = 1` is a super ball (Garwin 1969).
    ChatterjeeRuina {
        /// `e_t`, from -1 (no friction) to 1.
        tangential_restitution: f64,
    },
}

impl RestitutionLaw {
    /// All laws; that of Chatterjee and Ruina without restitution of slip.
    pub const ALL: [Self; 5] = [
        Self::Stronge,
        Self::Poisson,
        Self::Newton,
        Self::Whittaker,
        Self::ChatterjeeRuina { tangential_restitution: 0.0 },
    ];

    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stronge => "stronge",
            Self::Poisson => "poisson",
            Self::Newton => "newton",
            Self::Whittaker => "whittaker",
            Self::ChatterjeeRuina { .. } => "chatterjee-ruina",
        }
    }
}

/// How several contacts that are struck at once share the impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum MultipleImpactLaw {
    /// All together: the normal velocities that the generalised reflection gives, and Coulomb's law for all contacts at
    /// the velocities afterwards, by the cone problem. Symmetric, and carries momentum through a row of balls.
    #[default]
    Simultaneous,
    /// One contact at a time, in the order of the blocks, each by the law of a single contact, until none approaches.
    Sequence,
    /// The contacts as springs that spend what they have taken, with Coulomb's friction meanwhile (Liu, Zhao and
    /// Brogliato). Symmetric, says how momentum spreads, and never raises the energy.
    Pulse(PulseExponent),
}
