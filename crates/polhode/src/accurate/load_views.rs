//! Forces of pivots, and forces and moments of joints, at one instant.
//!
//! A joint does what its reactions do, what gears and prescribed motions do along its coordinates, and what its stops
//! and its friction do at levers.
//!
//! If constraint rows hold the body, it is the force of these rows. If the motion is reduced to rotation about the
//! pivot, it follows from Newton's law for the centre of mass, `F = m (a_cm - g) - F_fields - sum +-n f`, with
//! `a_cm = alpha x r + w x (w x r)`, r from the pivot to the centre of mass.

use super::engine::Engine;
use super::hold::Forces;
use super::joint_breaks::loads_of;
use crate::collision::touch::Touch;
use crate::constraint::ConstraintId;
use crate::identity::body_id::BodyId;
use crate::joints::bilateral::Reaction;
use crate::joints::{held, joint_contacts};
use crate::model::reported;
use crate::report::frame::{JointView, PivotView};
use crate::rows::assembly::free_acceleration;
use crate::solve::joint_loads::joint_view;
use crate::tier::core::Core;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::Memory;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

impl Engine {
    /// The force of every pivot at `t` (s) at these states.
    pub(super) fn pivot_views(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<PivotView> {
        let model = &core.model;
        let is_turning = |body: &usize| model.bodies[*body].rigid.as_ref().is_some_and(RigidBody::is_pivoted);
        let turning: Vec<usize> = model.movable.iter().copied().filter(is_turning).collect();
        if turning.is_empty() && !model.joints.has_rows() {
            return Vec::new();
        }
        let loads = model.loads(t, states);
        let mut needed: BTreeMap<usize, DVec3> = BTreeMap::new();
        let newton = |body: usize, linear: DVec3, angular: DVec3| {
            let mass = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
            let of_center = reported::reported_acceleration(model, body, &states[body], linear, angular).linear;
            (of_center - model.gravity()) * mass - loads.of(body).force
        };
        for &body in &turning {
            let (linear, angular) = free_acceleration(model, states, &loads, body);
            needed.insert(body, newton(body, linear, angular));
        }
        let mut by_rows: Vec<PivotView> = Vec::new();
        let mut solver = Memory::default();
        for (group, members) in self.present_groups(core, states) {
            let Ok(forces) = Forces::solve(model, t, states, &group, &members, &mut solver) else {
                let unknown = group.iter().filter(|body| is_turning(body) || model.joints.is_held_by_rows(**body));
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
            let reactions = forces.assembly.reactions(&forces.solution.reactions);
            let pivots = reactions.filter(|(of, _)| matches!(of.id, ConstraintId::Pivot { .. }));
            by_rows.extend(pivots.map(|(of, Reaction { force, .. })| PivotView {
                body: BodyId::new(of.id.bodies().0),
                point_m: of.point,
                force_n: force,
            }));
        }
        let place =
            |body: usize| held::pivot(model, states, body).map_or(states[body].pose.translation, |pivot| pivot.point);
        let view = |(body, force_n)| PivotView { body: BodyId::new(body), point_m: place(body), force_n };
        let mut views: Vec<PivotView> = needed.into_iter().map(view).chain(by_rows).collect();
        views.sort_by_key(|view| view.body);
        views
    }

    /// What every joint does at `t` (s) at these states.
    pub(super) fn joint_views(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<JointView> {
        let model = &core.model;
        let mut views: BTreeMap<usize, JointView> = BTreeMap::new();
        if model.joints.list.is_empty() {
            return Vec::new();
        }
        let mut solver = Memory::default();
        for (group, members) in self.present_groups(core, states) {
            let none = (DVec3::NAN, DVec3::NAN);
            let Ok(forces) = Forces::solve(model, t, states, &group, &members, &mut solver) else {
                let joints = group.iter().filter_map(|body| model.joints.of_body.get(body)).flatten();
                for joint in joints.map(|&place| &model.joints.list[place]) {
                    let (number, point_m) = (joint.number(), joint_contacts::anchor_of(model, states, joint));
                    views.insert(number, joint_view(number, point_m, none));
                }
                continue;
            };
            views.extend(loads_of(core, states, (&forces, &members)));
        }
        views.into_values().collect()
    }
}
