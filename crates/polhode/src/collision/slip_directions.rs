//! The directions in which bodies may slip and roll on each other at a contact: two in space, one in planar motion.
//!
//! In planar motion the normal `n` of a contact lies in the plane with unit normal `m`, and the bodies slip along
//! `t = m x n` and roll about `m`; the tangents `(t, m)` and `n` are right-handed. Coulomb's cone `|f_t| <= mu f_n`
//! becomes the interval `-mu f_n <= f_t <= mu f_n`: of a contact and its mirror image, which it stands for, the forces
//! along `m` cancel, and those along `t` add up as those along `n` do. Bodies do not spin about normals.

use crate::model::Model;
use polhode_spatial::DVec3;

/// The directions in which bodies may slip on each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SlipDirections {
    /// Both tangents.
    Both,
    /// The first tangent: the second is the normal of the plane of motion.
    First,
}

impl SlipDirections {
    /// How many.
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Both => 2,
            Self::First => 1,
        }
    }

    /// Those of these tangents along which bodies may slip.
    pub(crate) fn tangents(self, basis: &[DVec3; 2]) -> &[DVec3] {
        &basis[..self.count()]
    }

    /// Those of these tangents about which bodies may roll.
    pub(crate) fn rolling_axes(self, basis: &[DVec3; 2]) -> &[DVec3] {
        &basis[2 - self.count()..]
    }
}

/// The directions in which two bodies may slip on each other.
pub(crate) fn slip_directions(model: &Model, (a, b): (usize, usize)) -> SlipDirections {
    if model.planar.of_pair(a, b).is_some() { SlipDirections::First } else { SlipDirections::Both }
}
