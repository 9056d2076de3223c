//! A circle may have two places at which it is nearest to another curve: their names.

use crate::SurfaceFeature;

/// Which of two places of a circle is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Branch {
    /// The nearest.
    Nearest,
    /// Where the other curve leaves the disc.
    Exit,
    /// Where it enters it.
    Entry,
}

impl Branch {
    /// The name of the place on a rim.
    pub(crate) const fn of_rim(self, index: u32) -> SurfaceFeature {
        match self {
            Self::Nearest => SurfaceFeature::Rim(index),
            Self::Exit => SurfaceFeature::RimExit(index),
            Self::Entry => SurfaceFeature::RimEntry(index),
        }
    }
}
