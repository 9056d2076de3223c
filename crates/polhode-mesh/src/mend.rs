//! The mends that repair knows.

use std::fmt;

/// A mend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Repair {
    /// Merge vertices at the same place.
    Weld,
    /// Drop triangles that repeat an earlier one.
    DropDuplicates,
    /// Drop triangles without area, or swap their longest edge.
    DropDegenerate,
    /// Turn triangles round.
    Flip,
    /// Close holes.
    FillHoles,
    /// Drop vertices that no triangle uses.
    DropUnused,
}

impl Repair {
    /// A name for files and programs.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Weld => "weld",
            Self::DropDuplicates => "drop_duplicates",
            Self::DropDegenerate => "drop_degenerate",
            Self::Flip => "flip",
            Self::FillHoles => "fill_holes",
            Self::DropUnused => "drop_unused",
        }
    }

    /// What was done how often, in a sentence.
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::Weld => "vertices merged with earlier ones",
            Self::DropDuplicates => "repeated triangles dropped",
            Self::DropDegenerate => "degenerate triangles dropped or swapped",
            Self::Flip => "triangles turned round",
            Self::FillHoles => "holes filled",
            Self::DropUnused => "unused vertices dropped",
        }
    }
}

impl fmt::Display for Repair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
