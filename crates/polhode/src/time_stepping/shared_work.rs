//! The work that contacts and forces with a potential share when both act in one step.
//!
//! Such forces give the momentum `K` as one kick in the middle of a step, the contacts then `P`. The bodies move half of the
//! step with the velocities before both and half of it with those after both, so that the force does the work
//! `K.(v- + v+)/2` along the way that they go: half of `P` counts. Booked in the order in which they act, the force would
//! do `K.(v- + K/2M)` instead, and the integrator would seem to lose or gain `K.P/2M`: a body that rests under a spring
//! would gain `K^2/2M` in each step and lose it at its contact. Half of the kick is therefore counted before the impulses
//! of the contacts and half of it after them: of each contact's work `p.du/2` is booked as the integrator's, with the
//! change `du` of its rate by the kick.
//!
//! This changes no motion. Contacts give no energy: where their work in this order would, it is zero. Source: the
//! symmetric splitting of Strang 1968 (docs/REFERENCES.md).

use super::kick::Kick;
use crate::collision::contact_id::ContactId;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// The kick of a step as its contacts see it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kicked<'a> {
    pub(super) states: &'a [BodyState],
    /// Movable bodies, ascending.
    pub(super) bodies: &'a [usize],
    pub(super) kick: &'a Kick,
}

impl Kicked<'_> {
    /// The changes of the velocity of a body's centre of mass (m/s) and of its angular velocity (rad/s).
    fn change(&self, body: usize) -> (DVec3, DVec3) {
        let change = self.bodies.binary_search(&body).ok().and_then(|place| self.kick.stored.get(place));
        change.map_or((DVec3::ZERO, DVec3::ZERO), |change| (change.linear, change.angular))
    }

    /// By how much the kick has changed the rate of a contact along the normal of its geometry, m/s.
    fn rate(&self, id: ContactId, geometry: &ContactGeometry) -> f64 {
        let change = |body: usize| {
            let (linear, angular) = self.change(body);
            linear + angular.cross(geometry.point - self.states[body].pose.translation)
        };
        geometry.normal.dot(id.relative(change))
    }

    /// The work that impulses along the normals of these geometries (N s) share with the kick, J.
    pub(super) fn shared_j<'g>(&self, impulses: impl Iterator<Item = (ContactId, &'g ContactGeometry, f64)>) -> f64 {
        if self.kick.stored.is_empty() {
            return 0.0;
        }
        0.5 * impulses.map(|(id, geometry, impulse)| impulse * self.rate(id, geometry)).sum::<f64>()
    }

    /// The work that impulses of moments on the bodies A (N m s) share with it, J.
    pub(super) fn shared_by_moments_j(&self, moments: impl Iterator<Item = (ContactId, DVec3)>) -> f64 {
        if self.kick.stored.is_empty() {
            return 0.0;
        }
        0.5 * moments.map(|(id, moment)| moment.dot(self.change(id.a).1 - self.change(id.b).1)).sum::<f64>()
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
