//! What joints bear, from the forces of all rows of a group: their reactions, what gears and prescribed motions do
//! along their coordinates, and what their stops and their friction do at levers.

use crate::constraint::ConstraintId;
use crate::identity::contact_id::ContactId;
use crate::identity::joint_id::JointId;
use crate::joints::bilateral::{Bilateral, Reaction};
use crate::joints::ties::LoadOfTie;
use crate::joints::{breaking, efforts, joint_contacts};
use crate::model::Model;
use crate::report::frame::JointView;
use crate::report::joint_efforts::EffortsAlong;
use crate::rows::assembly::Assembly;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// The force of a contact on its body A, and where it acts, world, N and m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactForce {
    pub(crate) id: ContactId,
    pub(crate) point: DVec3,
    pub(crate) force: DVec3,
}

/// What the joints of a group bear, by their numbers, from the forces of all rows of its assembly, those of joints
/// the [least](Assembly::least), and those of its contacts.
pub(crate) fn joint_loads(
    model: &Model,
    states: &[BodyState],
    (assembly, forces): (&Assembly, &[f64]),
    contacts: impl Iterator<Item = ContactForce>,
) -> BTreeMap<usize, JointView> {
    let mut views: BTreeMap<usize, JointView> = BTreeMap::new();
    add_joint_loads(&mut views, model, states, (assembly.reactions(forces), contacts));
    views
}

/// Adds what the reactions of constraints and the forces of contacts do at joints (N, or impulses, N s). Soft rows are
/// springs and motors, which are no part of what a joint bears.
pub(crate) fn add_joint_loads<'a>(
    views: &mut BTreeMap<usize, JointView>,
    model: &Model,
    states: &[BodyState],
    (reactions, contacts): (impl Iterator<Item = (&'a Bilateral, Reaction)>, impl Iterator<Item = ContactForce>),
) {
    let none = (DVec3::ZERO, DVec3::ZERO);
    for (of, reaction) in reactions.filter(|(of, _)| of.softness.is_none()) {
        if let ConstraintId::Joint { joint, .. } = of.id {
            let own = views.entry(joint).or_insert_with(|| joint_view(joint, of.point, none));
            own.point_m = of.point;
            own.force_n += reaction.force;
            own.moment_n_m += reaction.moment;
        }
        for LoadOfTie { joint, along: (coordinate, cause), point, force, moment } in
            model.joints.joint_loads_of_tie(of, reaction)
        {
            let own = views.entry(joint).or_insert_with(|| joint_view(joint, point, none));
            own.force_n += force;
            own.moment_n_m += moment + (point - own.point_m).cross(force);
            let effort = efforts::along(model, states, (joint, coordinate), (point, force, moment));
            own.along.add(coordinate, cause, effort);
        }
    }
    for ContactForce { id, point, force } in contacts {
        let Some((joint, force)) = model.joints.joint_force_of(id, force) else { continue };
        let anchor = model.joints.list.iter().find(|own| own.number() == joint);
        let anchor = anchor.map_or(point, |own| joint_contacts::anchor_of(model, states, own));
        let own = views.entry(joint).or_insert_with(|| joint_view(joint, anchor, none));
        own.force_n += force;
        own.moment_n_m += (point - own.point_m).cross(force);
        if let Some((coordinate, cause)) = model.joints.cause_of(id) {
            let effort = efforts::along(model, states, (joint, coordinate), (point, force, DVec3::ZERO));
            own.along.add(coordinate, cause, effort);
        }
    }
}

/// The view of a joint with this force (N) and moment (N m) at a point (m).
pub(crate) fn joint_view(joint: usize, point_m: DVec3, (force_n, moment_n_m): (DVec3, DVec3)) -> JointView {
    let along = if force_n.is_nan() { EffortsAlong::UNKNOWN } else { EffortsAlong::default() };
    JointView { joint: JointId::new(joint), point_m, force_n, moment_n_m, along }
}

/// The joints among these that bear as much as they can.
pub(crate) fn overloaded(model: &Model, loads: &BTreeMap<usize, JointView>) -> Vec<usize> {
    let is_over = |(joint, load): (&usize, &JointView)| {
        let used = breaking::strength_of(model, *joint)?.used(load.force_n.length(), load.moment_n_m.length());
        (used >= 1.0).then_some(*joint)
    };
    loads.iter().filter_map(is_over).collect()
}
