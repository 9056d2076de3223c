//! The work that the impulses of constraints share with force fields, when both act in one step.
//!
//! Fields give the momentum `K` as one kick in the middle of a step, constraints then `P`. The bodies move half of the
//! step with the velocities `v-` before both and half of it with those after both, `v+`, so that a field does the work
//! `K.(v- + v+)/2` along the way that they go, and constraints `P.(v- + v+)/2`: at one pose these add up to the change
//! of the kinetic energy. Booked in the order in which they act, a field would do `K.(v- + K/2M)` instead, and the
//! integrator would seem to lose or gain `K.P/2M`: a body that rests under a spring would gain `K^2/2M` in each step
//! and lose it at its contact, and a motor would do work on the parts of its effort that the joint takes.
//!
//! So all rates "before" are those before the kick: those from which restitution, the bounds without gain of energy and
//! the works of rows follow. What is measured in the order of action (`P.(v- + K/M + v+)/2`) shares `P.du/2` with the
//! kick, where `du` is the change of the rate of its row by the kick.
//!
//! Contacts give no energy: where their work in this order would, it is zero. Source: the symmetric splitting of Strang
//! 1968 (docs/REFERENCES.md).

use super::implicit_kick::Twist;
use super::kick::Kick;
use crate::constraint::row::{BilateralRow, Member};
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::{Bilateral, Reaction};
use crate::solve::closed_loops::ClosedLoops;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// The kick of a step as constraints see it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kicked<'a> {
    /// Of the middle of the step.
    pub(super) states: &'a [BodyState],
    /// Movable bodies, ascending.
    pub(super) bodies: &'a [usize],
    pub(super) kick: &'a Kick,
    /// Where the loops of their joints are closed.
    pub(super) loops: &'a ClosedLoops,
}

impl Kicked<'_> {
    /// Whether any field has acted.
    fn is_none(&self) -> bool {
        self.kick.changes.is_empty()
    }

    /// By how much the kick has changed the velocity of a body, about the origin of its frame.
    fn change(&self, body: usize) -> Twist {
        let change = self.bodies.binary_search(&body).ok().and_then(|place| self.kick.changes.get(place));
        change.copied().unwrap_or_default()
    }

    /// By how much it has changed the relative velocity of the bodies of a contact at a point (world, m), m/s.
    pub(super) fn change_at(&self, id: ContactId, point: DVec3) -> DVec3 {
        if self.is_none() {
            return DVec3::ZERO;
        }
        id.relative(|body| {
            let change = self.change(body);
            change.linear + change.angular.cross(point - self.states[body].pose.translation)
        })
    }

    /// By how much it has changed their relative rotation, rad/s.
    pub(super) fn change_of_rotation(&self, id: ContactId) -> DVec3 {
        if self.is_none() { DVec3::ZERO } else { id.relative(|body| self.change(body).angular) }
    }

    /// By how much it has changed the rate of a row of a bilateral constraint, m/s.
    pub(super) fn change_of_row(&self, of: &Bilateral, row: &BilateralRow) -> f64 {
        if self.is_none() {
            return 0.0;
        }
        let by_member = |member: &Member| {
            let ((along, about), change) = (row.entries(member), self.change(member.body));
            along.dot(change.linear) + about.dot(change.angular)
        };
        of.members.iter().map(by_member).sum()
    }

    /// The work that impulses along the normals of these geometries (N s) share with the kick, J.
    pub(super) fn shared_j<'g>(&self, impulses: impl Iterator<Item = (ContactId, &'g ContactGeometry, f64)>) -> f64 {
        if self.is_none() {
            return 0.0;
        }
        let shared = |(id, geometry, impulse): (ContactId, &ContactGeometry, f64)| {
            impulse * geometry.normal.dot(self.change_at(id, geometry.point))
        };
        0.5 * impulses.map(shared).sum::<f64>()
    }

    /// The work that impulses of moments on the bodies A (N m s) share with it, J.
    pub(super) fn shared_by_moments_j(&self, moments: impl Iterator<Item = (ContactId, DVec3)>) -> f64 {
        if self.is_none() {
            return 0.0;
        }
        0.5 * moments.map(|(id, moment)| moment.dot(self.change_of_rotation(id))).sum::<f64>()
    }

    /// The work that the impulse of a bilateral constraint shares with it, J.
    pub(super) fn shared_by_reaction_j(&self, of: &Bilateral, impulse: Reaction) -> f64 {
        let row = |row: &BilateralRow| row.multiplier(impulse) * self.change_of_row(of, row);
        if self.is_none() { 0.0 } else { 0.5 * of.rows.iter().map(row).sum::<f64>() }
    }
}

/// What the contacts of a group do to the energy, J.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactWork {
    /// Change of the energy by impulses along normals.
    pub(super) normal_j: f64,
    /// Lost to friction.
    pub(super) friction_j: f64,
}

impl ContactWork {
    /// The same in the symmetric order, with what belongs to the integrator (J, lost): `shared` is the work that normal
    /// and frictional impulses share with the kick.
    pub(super) fn in_symmetric_order(self, shared: Self) -> (Self, f64) {
        let normal_j = (self.normal_j - shared.normal_j).min(self.normal_j.max(0.0));
        let friction_j = (self.friction_j + shared.friction_j).max(self.friction_j.min(0.0));
        let of_integrator = (normal_j - self.normal_j) + (self.friction_j - friction_j);
        (Self { normal_j, friction_j }, of_integrator)
    }
}

#[cfg(test)]
mod tests {
    //! The sum of what contacts and integrator lose is the same in both orders, and contacts give nothing.
    use super::*;

    /// A body of 1 kg that rests under a force: the kick -K, the impulse K, the work -K^2/2 in the order of action.
    #[test]
    fn a_body_at_rest_under_a_force_loses_nothing() {
        let kick = 0.25;
        let acting = ContactWork { normal_j: -0.5 * kick * kick, friction_j: 0.0 };
        let shared = ContactWork { normal_j: -0.5 * kick * kick, friction_j: 0.0 };
        let (work, of_integrator) = acting.in_symmetric_order(shared);
        assert_eq!(work.normal_j, 0.0);
        // The integrator has gained K^2/2 by the kick alone.
        assert_eq!(of_integrator, 0.5 * kick * kick);
    }

    #[test]
    fn contacts_give_no_energy_in_either_order() {
        for shared in [-3.0, -0.5, 0.5, 3.0] {
            let acting = ContactWork { normal_j: -1.0, friction_j: 1.0 };
            let shared = ContactWork { normal_j: shared, friction_j: shared };
            let (work, of_integrator) = acting.in_symmetric_order(shared);
            assert!(work.normal_j <= 0.0 && work.friction_j >= 0.0);
            assert_eq!(-work.normal_j + work.friction_j + of_integrator, 2.0);
        }
    }
}
