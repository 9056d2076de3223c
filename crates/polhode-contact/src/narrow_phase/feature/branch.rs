//! Names of the two points at which a circle may be nearest to another curve.

use crate::SurfaceFeature;

/// Which of the two points is meant.
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
    /// The feature of this point on a rim.
    pub(crate) const fn of_rim(self, index: u32) -> SurfaceFeature {
        match self {
            Self::Nearest => SurfaceFeature::Rim(index),
            Self::Exit => SurfaceFeature::RimExit(index),
            Self::Entry => SurfaceFeature::RimEntry(index),
        }
    }
}
