//! How fine the mesh of a curved primitive is.

use super::error::{MOST_HALVINGS, PrimitiveError};

/// How often the edges of a primitive's coarsest mesh are halved: each time the triangles are four times as many and
/// the errors of volume and inertia a quarter.
///
/// A circle has `8 * 2^level` segments (the ring of a torus twice as many), a sphere `20 * 4^level` triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Refinement(u32);

impl Refinement {
    /// Circles of 8 segments.
    pub const COARSEST: Self = Self(0);
    /// Largest level: a torus then has 17 million triangles, about a gigabyte while its mesh is made.
    pub const FINEST: u32 = MOST_HALVINGS;

    /// With edges halved `level` times.
    ///
    /// # Errors
    /// [`PrimitiveError::Refinement`] above [`Refinement::FINEST`].
    pub const fn new(level: u32) -> Result<Self, PrimitiveError> {
        if level <= Self::FINEST { Ok(Self(level)) } else { Err(PrimitiveError::Refinement(level)) }
    }

    /// How often edges are halved.
    pub const fn level(self) -> u32 {
        self.0
    }

    /// Segments of a circle; a multiple of 8.
    pub(super) const fn segments(self) -> u32 {
        8 << self.0
    }
}
