//! Which touching contacts stay, and with what forces.
//!
//! The complementarity problem of thesis 3.4, `0 <= f _|_ chi'' = G f + b >= 0`, decides: a contact that needs a force
//! stays, one that accelerates apart opens. The motion it gives is unique though the forces may not be (erratum E13).

use crate::collision::contact_set::{Hold, Touch};
use crate::interaction::acceleration_problem::AccelerationProblem;
use crate::interaction::assembly::Assembly;
use crate::world::World;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::{ComplementaritySolver, ContactSolution, ResponseError, WarmStart};
use polhode_spatial::DVec3;
use std::collections::BTreeSet;

/// A contact that accelerates apart by more than this opens: relative to the largest relative acceleration that the
/// group's contacts would have without forces. Round-off of the solve is some 1e-15 of it.
const OPENING_RELATIVE: f64 = 1e-11;

/// The net force on a body in equilibrium is at most this fraction of the sum of the magnitudes of the forces on it;
/// likewise for moments. Round-off of a few hundred contacts stays below 1e-13.
const EQUILIBRIUM_RELATIVE: f64 = 1e-12;

/// Forces of some contacts of a group, and the accelerations of its bodies, at one instant.
#[derive(Debug)]
pub(super) struct Forces {
    pub(super) solution: ContactSolution,
    pub(super) assembly: Assembly,
    /// How many contacts.
    contacts: usize,
    /// Generalised accelerations of the group's bodies.
    accelerations: Vec<f64>,
    /// When they act, s.
    t: f64,
    /// What counts as opening, m/s^2.
    pub(super) opening: f64,
    /// Largest sum of weight and force of fields on a body of the group, N: what contact forces may cancel from.
    pub(super) load: f64,
}

impl Forces {
    /// Solves for the forces of `contacts` on `bodies` (movable, ascending) at time `t`.
    ///
    /// # Errors
    /// When the problem is not finite.
    pub(super) fn solve(
        world: &World,
        t: f64,
        states: &[BodyState],
        bodies: &[usize],
        contacts: &[Touch],
        solver: &mut ComplementaritySolver,
    ) -> Result<Self, ResponseError> {
        let loads = world.loads_on(t, states, bodies);
        let problem = AccelerationProblem::new(world, t, states, bodies, contacts, &loads)?;
        let AccelerationProblem { assembly, free, constants: b } = problem;
        let load = bodies.iter().map(|&body| {
            let mass = world.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
            mass * world.gravity().length() + loads.of(body).force.length()
        });
        let load = load.fold(0.0, f64::max);
        let held = (0..contacts.len()).filter(|&i| contacts[i].hold == Hold::Held).collect();
        let delassus = assembly.problem.delassus();
        let solution = solver.solve(&assembly.problem, &delassus, &b, Some(&WarmStart::new(held)))?.clone();
        let opening = OPENING_RELATIVE * b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let mut accelerations = assembly.problem.response(&solution.forces)?;
        for (a, f) in accelerations.iter_mut().zip(&free) {
            *a += f;
        }
        Ok(Self { solution, assembly, contacts: contacts.len(), accelerations, t, opening, load })
    }

    /// Forces of the contacts that were solved for, without those of pivots.
    pub(super) fn of_contacts(&self) -> &[f64] {
        self.solution.forces.get(..self.contacts).unwrap_or_default()
    }

    /// The event function by which each contact opens, m/s^2: what it may accelerate apart by before it counts as opening, less
    /// what it does. While a force holds it it is positive; it falls as the force that would be needed to pull grows.
    pub(super) fn holding(&self) -> impl Iterator<Item = f64> + '_ {
        let accelerations = self.solution.residual_accelerations.iter().take(self.contacts);
        accelerations.map(|w| self.opening - w)
    }

    /// Generalised accelerations: (body, linear, angular).
    pub(super) fn accelerations(&self) -> impl Iterator<Item = (usize, DVec3, DVec3)> + '_ {
        self.assembly.split(&self.accelerations)
    }

    /// Relative acceleration along the normal of a contact of these bodies that is not among those solved for, under
    /// these forces, m/s^2.
    pub(super) fn relative_acceleration(&self, world: &World, states: &[BodyState], touch: &Touch) -> f64 {
        let geometry = &touch.kinematics.geometry;
        let prescribed = world.prescribed_acceleration_of(self.t, states, touch.id, geometry);
        let mut relative = touch.kinematics.acceleration_bias + prescribed;
        for (body, linear, angular) in self.accelerations() {
            let sign = if body == touch.id.a {
                1.0
            } else if body == touch.id.b {
                -1.0
            } else {
                continue;
            };
            let arm = geometry.point - states[body].pose.translation;
            relative += sign * geometry.normal.dot(linear + angular.cross(arm));
        }
        relative
    }

    /// Bodies on which the forces certify equilibrium: net force and net moment vanish against their parts.
    pub(super) fn balanced_bodies(&self, world: &World, states: &[BodyState], contacts: &[Touch]) -> BTreeSet<usize> {
        let mut force_sums = vec![0.0; world.bodies.len()];
        let mut moment_sums = vec![0.0; world.bodies.len()];
        for (touch, force) in contacts.iter().zip(&self.solution.forces) {
            for body in [touch.id.a, touch.id.b] {
                let arm = touch.kinematics.geometry.point - states[body].pose.translation;
                force_sums[body] += force;
                moment_sums[body] += force * arm.length();
            }
        }
        for (pivot, force) in self.assembly.pivot_forces(&self.solution.forces) {
            force_sums[pivot.body] += force.length();
            moment_sums[pivot.body] += force.length() * pivot.arm.length();
        }
        self.accelerations()
            .filter(|&(body, linear, angular)| {
                world.bodies[body].rigid.as_ref().is_some_and(|rigid| {
                    let weight = rigid.mass() * world.gravity().length();
                    let net_force = rigid.mass() * linear.length();
                    let rotation = states[body].pose.rotation;
                    let net_moment = (rigid.inertia() * rotation.inverse_rotate(angular)).length();
                    let weight_moment = weight * world.bodies[body].size;
                    net_force <= EQUILIBRIUM_RELATIVE * (force_sums[body] + weight)
                        && net_moment <= EQUILIBRIUM_RELATIVE * (moment_sums[body] + weight_moment)
                })
            })
            .map(|(body, _, _)| body)
            .collect()
    }
}
