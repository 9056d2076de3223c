//! The contacts at joints: their stops (`stop.rs`) and their dry friction (`joint_friction.rs`).

use crate::collision::touch::{FoundContact, Touch};
use crate::constraint::joint::ModelJoint;
use crate::constraint::stop::Stop;
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::joint_friction;
use crate::model::{Joints, Model, tolerances};
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Velocity};
use std::collections::BTreeSet;

impl Joints {
    /// Whether any joint has limits or friction.
    pub(crate) fn has_joint_contacts(&self) -> bool {
        !self.contacts.is_empty()
    }

    /// The contacts at joints between two bodies, A <= B, ascending; the same body twice for those with the world.
    pub(crate) fn joint_contacts_of_pair(&self, pair: (usize, usize)) -> &[Feature] {
        self.contacts.get(&pair).map_or(&[], Vec::as_slice)
    }

    /// The pairs with such contacts that have one of these bodies, A <= B, ascending.
    pub(crate) fn joint_contact_pairs_among(&self, bodies: &[usize]) -> impl Iterator<Item = (usize, usize)> + use<> {
        let bodies = if self.has_joint_contacts() { bodies } else { &[] };
        let of_body =
            |&body: &usize| self.joint_contact_partners(body).map(move |other| (body.min(other), body.max(other)));
        let pairs: BTreeSet<(usize, usize)> = bodies.iter().flat_map(of_body).collect();
        pairs.into_iter()
    }

    /// All pairs with contacts at joints, A <= B, ascending.
    pub(crate) fn joint_contact_pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.contacts.keys().copied()
    }

    /// The bodies that have contacts at joints with this one, itself for those with the world.
    pub(crate) fn joint_contact_partners(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        self.contact_partners.get(&body).into_iter().flatten().copied()
    }

    /// Whether a contact is the side of a track that pushes.
    pub(crate) fn is_side_of_track(&self, id: ContactId) -> bool {
        let Feature::Stop(stop) = id.feature else { return false };
        let of = self.joint_numbered(stop.joint).and_then(|joint| joint.stop(stop.stop));
        of.is_some_and(Stop::is_side_of_track)
    }

    /// The largest coefficient of restitution of any stop; zero without stops.
    pub(crate) fn largest_restitution_of_stops(&self) -> f64 {
        let own = |joint: &ModelJoint| {
            (0..joint.stops()).filter_map(|place| joint.stop(place)).map(|stop| stop.restitution).fold(0.0, f64::max)
        };
        self.list.iter().map(own).fold(0.0, f64::max)
    }

    /// The joint of a contact at a joint, and the force on its first body where this one is on the first body of the
    /// contact.
    pub(crate) fn joint_force_of(&self, id: ContactId, force: DVec3) -> Option<(usize, DVec3)> {
        let joint = match id.feature {
            Feature::Shapes(_) => return None,
            Feature::Stop(stop) => stop.joint,
            Feature::JointFriction(of) => of.joint,
        };
        Some((joint, force * self.joint_numbered(joint)?.order().sign()))
    }

    /// The movable bodies of a joint, with the sign of its load on them.
    pub(crate) fn ends_of_joint(&self, joint: usize) -> impl Iterator<Item = (usize, f64)> {
        let ends = self.joint_numbered(joint).map(ModelJoint::ends).into_iter().flatten();
        ends.zip([1.0, -1.0]).filter_map(|(body, sign)| Some((body?, sign)))
    }

    /// The joint of this number; none where there is none, or it was removed with a body.
    pub(crate) fn joint_numbered(&self, joint: usize) -> Option<&ModelJoint> {
        let place = self.list.binary_search_by_key(&joint, ModelJoint::number).ok()?;
        self.list.get(place)
    }
}

/// The contacts at joints of a pair with a separation of at most `reach` (m), in order.
pub(crate) fn joint_contacts_within(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
) -> Vec<FoundContact> {
    let found = model.joints.joint_contacts_of_pair((a, b)).iter().filter_map(|&feature| {
        let id = ContactId { a, b, feature };
        let kinematics = joint_contact_kinematics(model, states, id)?;
        (kinematics.geometry.separation <= reach).then_some(FoundContact { id, kinematics })
    });
    found.collect()
}

/// A contact at a joint in these states; none where its coordinate has no direction, and of contacts of shapes.
pub(crate) fn joint_contact_kinematics(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
) -> Option<ContactKinematics> {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    match id.feature {
        Feature::Shapes(_) => None,
        Feature::Stop(stop) => model.joints.joint_numbered(stop.joint)?.stop_at(stop.stop, motion),
        Feature::JointFriction(of) => joint_friction::friction_kinematics(model, states, of),
    }
}

/// Coefficient of restitution of a contact at its speed of approach.
pub(crate) fn restitution_at(model: &Model, touch: &Touch) -> f64 {
    match touch.id.feature {
        Feature::Shapes(_) => {
            let speed = -touch.kinematics.separation_rate;
            let of_materials = model.scene.pair_material(touch.id.a, touch.id.b).restitution_at(speed);
            let gap_m = touch.kinematics.geometry.separation;
            model.envelope.map_or(of_materials, |envelope| envelope.restitution(of_materials, gap_m, speed))
        }
        _ => restitution_of(model, touch.id),
    }
}

/// Coefficient of restitution of a contact that approaches slowly.
pub(crate) fn restitution_of(model: &Model, id: ContactId) -> f64 {
    match id.feature {
        Feature::Shapes(_) => model.scene.pair_material(id.a, id.b).restitution(),
        Feature::Stop(stop) => {
            let of = model.joints.joint_numbered(stop.joint).and_then(|joint| joint.stop(stop.stop));
            of.map_or(0.0, |stop| stop.restitution)
        }
        Feature::JointFriction(_) => 0.0,
    }
}

/// Whether a body is beyond a limit of a joint by more than counts as touch.
pub(crate) fn exceeds_limits(model: &Model, states: &[BodyState], body: usize) -> bool {
    let is_beyond = |pair: (usize, usize)| {
        let touch = tolerances::touch_distance(model, states, pair.0, pair.1);
        !joint_contacts_within(model, states, pair, -touch).is_empty()
    };
    model.joints.joint_contact_pairs_among(&[body]).any(is_beyond)
}

/// Where a joint holds its first body, world, m.
pub(crate) fn anchor_of(model: &Model, states: &[BodyState], joint: &ModelJoint) -> DVec3 {
    let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
    joint.anchor(motion)
}
