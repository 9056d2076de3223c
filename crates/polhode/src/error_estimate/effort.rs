//! How much of the work of a run its estimated error may cost.

use crate::scene::ErrorEstimation;

impl ErrorEstimation {
    /// The work that references may take together, of that of the run.
    pub(crate) const fn share(self) -> f64 {
        match self {
            Self::Off => 0.0,
            Self::Quick => 0.24,
            Self::Full => 2.5,
        }
    }

    /// How many times longer the fixed steps of a reference are, when so many have begun: longer ones where the first
    /// cost too much, and for pieces as at first.
    pub(crate) const fn step_factor(self, begun: u32) -> f64 {
        match (self, begun) {
            (Self::Full, _) => 2.0,
            (_, 1) => 12.0,
            _ => 6.0,
        }
    }
}
