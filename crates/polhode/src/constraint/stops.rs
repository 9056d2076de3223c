//! The stops between bodies of the world, as contacts (`stop.rs` says what a stop is).

use super::joint::WorldJoint;
use super::stop_id::StopId;
use crate::collision::contact_id::{ContactId, Feature};
use crate::collision::contact_set::FoundContact;
use crate::world::World;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_spatial::{Pose, Velocity};
use std::collections::BTreeSet;

impl World {
    /// Whether any joint has limits.
    pub(crate) fn has_stops(&self) -> bool {
        !self.stops.is_empty()
    }

    /// The stops between two bodies, A <= B; the same body twice for those with the world.
    pub(crate) fn stops_of_pair(&self, pair: (usize, usize)) -> &[StopId] {
        self.stops.get(&pair).map_or(&[], Vec::as_slice)
    }

    /// The pairs with stops that have one of these bodies, A <= B, ascending.
    pub(crate) fn stop_pairs_among(&self, bodies: &[usize]) -> impl Iterator<Item = (usize, usize)> + use<> {
        let bodies = if self.has_stops() { bodies } else { &[] };
        let of_body = |&body: &usize| self.stop_partners(body).map(move |other| (body.min(other), body.max(other)));
        let pairs: BTreeSet<(usize, usize)> = bodies.iter().flat_map(of_body).collect();
        pairs.into_iter()
    }

    /// All pairs with stops, A <= B, ascending.
    pub(crate) fn stop_pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.stops.keys().copied()
    }

    /// The bodies that have stops with this one, itself for stops with the world.
    pub(crate) fn stop_partners(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        self.stop_partners.get(&body).into_iter().flatten().copied()
    }

    /// The stops of a pair with a separation of at most `reach` (m), as contacts in order.
    pub(crate) fn stops_within(&self, states: &[BodyState], (a, b): (usize, usize), reach: f64) -> Vec<FoundContact> {
        let found = self.stops_of_pair((a, b)).iter().filter_map(|&stop| {
            let kinematics = self.stop_kinematics(states, stop)?;
            let id = ContactId { a, b, feature: Feature::Stop(stop) };
            (kinematics.geometry.separation <= reach).then_some(FoundContact { id, kinematics })
        });
        found.collect()
    }

    /// A stop in these states; none where its coordinate has no direction.
    pub(crate) fn stop_kinematics(&self, states: &[BodyState], stop: StopId) -> Option<ContactKinematics> {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, self.velocity(body, &states[body])) };
        self.joint_of(stop)?.stop_at(stop.stop, motion)
    }

    /// Coefficient of restitution of a contact.
    pub(crate) fn restitution_of(&self, id: ContactId) -> f64 {
        match id.feature {
            Feature::Shapes(_) => self.scene.pair_material(id.a, id.b).restitution(),
            Feature::Stop(stop) => {
                self.joint_of(stop).and_then(|joint| joint.stop(stop.stop)).map_or(0.0, |stop| stop.restitution)
            }
        }
    }

    /// Whether a body is beyond a limit of a joint by more than counts as touch.
    pub(crate) fn exceeds_limits(&self, states: &[BodyState], body: usize) -> bool {
        let is_beyond = |pair: (usize, usize)| {
            let touch = self.touch_distance(states, pair.0, pair.1);
            !self.stops_within(states, pair, -touch).is_empty()
        };
        self.stop_pairs_among(&[body]).any(is_beyond)
    }

    /// The largest coefficient of restitution of any stop; zero without stops.
    pub(crate) fn largest_restitution_of_stops(&self) -> f64 {
        let own = |joint: &WorldJoint| {
            (0..joint.stops()).filter_map(|place| joint.stop(place)).map(|stop| stop.restitution).fold(0.0, f64::max)
        };
        self.joints.iter().map(own).fold(0.0, f64::max)
    }

    fn joint_of(&self, stop: StopId) -> Option<&WorldJoint> {
        let place = self.joints.binary_search_by_key(&stop.joint, WorldJoint::number).ok()?;
        self.joints.get(place)
    }
}
