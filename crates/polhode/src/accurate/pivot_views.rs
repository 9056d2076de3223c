//! Forces of pivots and joints at one instant.
//!
//! If constraint rows hold the body, it is the force of these rows. If the motion is reduced to rotation about the
//! pivot, it follows from Newton's law for the centre of mass, `F = m (a_cm - g) - F_fields - sum +-n f`, with
//! `a_cm = alpha x r + w x (w x r)`, r from the pivot to the centre of mass.

use super::engine::Engine;
use super::hold::Forces;
use crate::BodyId;
use crate::collision::contact_set::Touch;
use crate::constraint::bilateral::Reaction;
use crate::core::Core;
use crate::frame::PivotView;
use crate::rows::assembly::free_acceleration;
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
            by_rows.extend(reactions.map(|(of, Reaction { force, .. })| PivotView {
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
}
