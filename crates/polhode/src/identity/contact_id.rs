//! Identity of a contact: which bodies touch, and by what.

use crate::identity::coordinate_id::CoordinateId;
use crate::identity::stop_id::StopId;
use polhode_contact::ContactFeature;
use polhode_spatial::DVec3;

/// What touches at a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Feature {
    /// Features of two shapes.
    Shapes(ContactFeature),
    /// A joint at one of its limits.
    Stop(StopId),
    /// Dry friction of a joint along one of its coordinates.
    JointFriction(CoordinateId),
}

/// Identity of a contact point: two bodies (by index, A before B) and the features that touch. A stop or the friction
/// of a joint between a body and the world has that body twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct ContactId {
    pub(crate) a: usize,
    pub(crate) b: usize,
    pub(crate) feature: Feature,
}

impl ContactId {
    /// The second body; none where the first one is in contact with the world.
    pub(crate) fn second(&self) -> Option<usize> {
        (self.b != self.a).then_some(self.b)
    }

    /// A vector of its first body (a velocity at the contact, say) relative to that of its second one; the world has
    /// zero.
    pub(crate) fn relative(&self, of: impl Fn(usize) -> DVec3) -> DVec3 {
        let first = of(self.a);
        self.second().map_or(first, |second| first - of(second))
    }

    /// Its bodies, each with the sign of its part in relative velocities.
    pub(crate) fn members(&self) -> impl Iterator<Item = (usize, f64)> + use<> {
        std::iter::once((self.a, 1.0)).chain(self.second().map(|second| (second, -1.0)))
    }
}
