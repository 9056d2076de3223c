//! What can be plotted of a run.

/// What can be plotted of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunPlot {
    /// Kinetic, potential and total energy.
    Energy,
    /// Where the energy went: the terms of the ledger.
    Ledger,
    /// How deep bodies overlap.
    Penetration,
    /// How many contacts touch and bear a load, and how many bodies rest.
    Contacts,
    /// How long the steps are.
    Steps,
    /// Angles and displacements of joints.
    JointCoordinates,
    /// Their rates.
    JointRates,
    /// Magnitudes of the forces in joints.
    JointForces,
    /// Magnitudes of the moments in joints.
    JointMoments,
    /// What motors, springs, dampers, prescribed motions and gears of joints give.
    JointPowers,
}

impl RunPlot {
    /// All that every scene has, in the order in which they are drawn.
    pub const ALL: [Self; 5] = [Self::Energy, Self::Ledger, Self::Penetration, Self::Contacts, Self::Steps];

    /// All of joints, which are drawn after those.
    pub const OF_JOINTS: [Self; 5] =
        [Self::JointCoordinates, Self::JointRates, Self::JointForces, Self::JointMoments, Self::JointPowers];

    /// The name by which users ask for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Ledger => "ledger",
            Self::Penetration => "penetration",
            Self::Contacts => "contacts",
            Self::Steps => "steps",
            Self::JointCoordinates => "joint-coordinates",
            Self::JointRates => "joint-rates",
            Self::JointForces => "joint-forces",
            Self::JointMoments => "joint-moments",
            Self::JointPowers => "joint-powers",
        }
    }
}
