//! How the error of a run is estimated: not at all, quickly, or in full.

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
}
