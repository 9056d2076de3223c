//! Forces of pivots, and forces and moments of joints, at one instant.
//!
//! A joint does what its reactions do, what gears and prescribed motions do along its coordinates, and what its stops and its
//! friction do at levers.
//!
//! If constraint rows hold the body, it is the force of these rows. If the motion is reduced to rotation about the
//! pivot, it follows from Newton's law for the centre of mass, `F = m (a_cm - g) - F_fields - sum +-n f`, with
//! `a_cm = alpha x r + w x (w x r)`, r from the pivot to the centre of mass.

use super::engine::Engine;
use super::hold::Forces;
use crate::collision::contact_set::Touch;
use crate::constraint::ConstraintId;
use crate::constraint::bilateral::Reaction;
use crate::constraint::ties::LoadOfTie;
use crate::core::Core;
use crate::frame::{JointView, PivotView};
use crate::rows::assembly::free_acceleration;
use crate::{BodyId, JointId};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::ComplementaritySolver;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

impl Engine {
    /// The force of every pivot at `t` (s) at these states.
    pub(super) fn pivot_views(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<PivotView> {
        let world = &core.world;
        let is_turning = |body: &usize| world.bodies[*body].rigid.as_ref().is_some_and(RigidBody::is_pivoted);
        let turning: Vec<usize> = world.movable.iter().copied().filter(is_turning).collect();
        if turning.is_empty() && !world.has_rows() {
            return Vec::new();
        }
        let loads = world.loads(t, states);
        let mut needed: BTreeMap<usize, DVec3> = BTreeMap::new();
        let newton = |body: usize, linear: DVec3, angular: DVec3| {
            let mass = world.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
            let of_center = world.reported_acceleration(body, &states[body], linear, angular).linear;
            (of_center - world.gravity()) * mass - loads.of(body).force
        };
        for &body in &turning {
            let (linear, angular) = free_acceleration(world, states, &loads, body);
            needed.insert(body, newton(body, linear, angular));
        }
        let mut by_rows: Vec<PivotView> = Vec::new();
        let mut solver = ComplementaritySolver::default();
        for (group, members) in self.present_groups(core, states) {
            let Ok(forces) = Forces::solve(world, t, states, &group, &members, &mut solver) else {
                let unknown = group.iter().filter(|body| is_turning(body) || world.is_held_by_rows(**body));
                needed.extend(unknown.map(|&body| (body, DVec3::NAN)));
                continue;
            };
            for (body, linear, angular) in forces.accelerations().filter(|(body, ..)| is_turning(body)) {
                let sign = |touch: &Touch| (touch.id.a == body, touch.id.b == body);
                let by_contacts = members.iter().zip(forces.of_contacts()).map(|(touch, &force)| match sign(touch) {
                    (true, _) => touch.kinematics.geometry.normal * force,
                    (_, true) => touch.kinematics.geometry.normal * -force,
                    _ => DVec3::ZERO,
                });
                needed.insert(body, newton(body, linear, angular) - by_contacts.sum::<DVec3>());
            }
            let reactions = forces.assembly.reactions(&forces.solution.forces);
            let pivots = reactions.filter(|(of, _)| matches!(of.id, ConstraintId::Pivot { .. }));
            by_rows.extend(pivots.map(|(of, Reaction { force, .. })| PivotView {
                body: BodyId::new(of.id.bodies().0),
                point_m: of.point,
                force_n: force,
            }));
        }
        let place = |body: usize| world.pivot(states, body).map_or(states[body].pose.translation, |pivot| pivot.point);
        let view = |(body, force_n)| PivotView { body: BodyId::new(body), point_m: place(body), force_n };
        let mut views: Vec<PivotView> = needed.into_iter().map(view).chain(by_rows).collect();
        views.sort_by_key(|view| view.body);
        views
    }

    /// What every joint does at `t` (s) at these states.
    pub(super) fn joint_views(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<JointView> {
        let world = &core.world;
        let mut views: BTreeMap<usize, JointView> = BTreeMap::new();
        if world.joints.is_empty() {
            return Vec::new();
        }
        let mut solver = ComplementaritySolver::default();
        for (group, members) in self.present_groups(core, states) {
            let none = (DVec3::NAN, DVec3::NAN);
            let Ok(forces) = Forces::solve(world, t, states, &group, &members, &mut solver) else {
                let joints = group.iter().filter_map(|body| world.joints_of.get(body)).flatten();
                for joint in joints.map(|&place| &world.joints[place]) {
                    let (number, point_m) = (joint.number(), world.anchor_of(states, joint));
                    views.insert(number, view(number, point_m, none));
                }
                continue;
            };
            for (of, reaction) in forces.assembly.reactions(&forces.solution.forces) {
                if let ConstraintId::Joint { joint, .. } = of.id {
                    views.insert(joint, view(joint, of.point, (reaction.force, reaction.moment)));
                }
                for LoadOfTie { joint, point, force, moment } in world.joint_loads_of_tie(of, reaction) {
                    let own = views.entry(joint).or_insert_with(|| view(joint, point, (DVec3::ZERO, DVec3::ZERO)));
                    own.force_n += force;
                    own.moment_n_m += moment + (point - own.point_m).cross(force);
                }
            }
            for (index, (touch, normal)) in members.iter().zip(forces.of_contacts()).enumerate() {
                let tangential = forces.friction(index).map_or(DVec3::ZERO, |friction| friction.force);
                let on_first = touch.kinematics.geometry.normal * *normal + tangential;
                let Some((joint, force)) = world.joint_force_of(touch.id, on_first) else { continue };
                let anchor = world.joints.iter().find(|own| own.number() == joint);
                let anchor = anchor.map_or(touch.kinematics.geometry.point, |own| world.anchor_of(states, own));
                let own = views.entry(joint).or_insert_with(|| view(joint, anchor, (DVec3::ZERO, DVec3::ZERO)));
                own.force_n += force;
                own.moment_n_m += (touch.kinematics.geometry.point - own.point_m).cross(force);
            }
        }
        views.into_values().collect()
    }
}

fn view(joint: usize, point_m: DVec3, (force_n, moment_n_m): (DVec3, DVec3)) -> JointView {
    JointView { joint: JointId::new(joint), point_m, force_n, moment_n_m }
}
