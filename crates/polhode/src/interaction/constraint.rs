//! Constraints: whatever holds bodies, by one kind of identity.
//!
//! | constraint | row block | signed event functions |
//! |---|---|---|
//! | contact | unilateral (a cone where there is friction) | separation; margin of its features; how far it is from opening |
//! | pivot | bilateral, three rows | none: it never opens |
//!
//! An event function is positive while all is as it was and passes zero where it changes; one locator
//! (`crate::interaction::locator`) finds where.

use crate::collision::contact_set::ContactId;
use polhode_contact::ContactKinematics;
use polhode_response::RowBlock;

/// Identity of a constraint: contacts before pivots, each in its own order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum ConstraintId {
    /// A contact point, by its bodies and the features that meet.
    Contact(ContactId),
    /// The pivot of a body.
    Pivot {
        /// The body's number.
        body: usize,
    },
}

impl ConstraintId {
    /// What its rows ask for together.
    pub(crate) fn block(&self) -> RowBlock {
        match self {
            Self::Contact(_) => RowBlock::Unilateral,
            Self::Pivot { .. } => RowBlock::Bilateral,
        }
    }

    /// The bodies that it is between; the one body twice where the world is the other.
    pub(crate) fn bodies(&self) -> (usize, usize) {
        match *self {
            Self::Contact(id) => (id.a, id.b),
            Self::Pivot { body } => (body, body),
        }
    }

    /// The contact, if it is one.
    pub(crate) fn contact(&self) -> Option<ContactId> {
        match *self {
            Self::Contact(id) => Some(id),
            Self::Pivot { .. } => None,
        }
    }
}

/// Signed event functions of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ContactEvent {
    /// From apart to closed: the separation, m.
    Closing,
    /// From on its features to beside them: the margin, m.
    Leaving,
}

impl ContactEvent {
    /// The value at these kinematics, m.
    pub(crate) fn value(self, contact: &ContactKinematics) -> f64 {
        match self {
            Self::Closing => contact.geometry.separation,
            Self::Leaving => contact.geometry.margin,
        }
    }
}
