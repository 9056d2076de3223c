//! How much of the work of a run its estimated error may cost.

/// How the error of a run is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum ErrorEstimation {
    /// Not at all.
    Off,
    /// By runs beside the run that are to add at most three tenths to its time: whole ones where they are cheap, pieces
    /// elsewhere.
    #[default]
    Quick,
    /// By whole runs beside the run, which are to take at most three times its time.
    Full,
}

impl ErrorEstimation {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Off, Self::Quick, Self::Full];

    /// Its name, as options and scenes have it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Quick => "quick",
            Self::Full => "full",
        }
    }

    /// The one of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|one| one.name() == name)
    }

    /// The work that references may take together, of that of the run.
    pub(crate) const fn share(self) -> f64 {
        match self {
            Self::Off => 0.0,
            Self::Quick => 0.24,
            Self::Full => 2.7,
        }
    }

    /// How many times longer the fixed steps of a reference are, when so many have begun: longer ones where the first
    /// cost too much, and for pieces as at first.
    pub(crate) const fn step_factor(self, begun: u32) -> f64 {
        match (self, begun) {
            (Self::Full, _) => 2.0,
            (_, 1) => 20.0,
            _ => 10.0,
        }
    }
}
