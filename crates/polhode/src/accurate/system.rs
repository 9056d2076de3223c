//! The equations of motion of a group of bodies whose held contacts stay.
//!
//! Within a smooth phase the set of held contacts is frozen and each keeps `chi'' = 0` (thesis 3.4). That makes the
//! right-hand side smooth over the whole step, also past the instant at which a contact would let go, which is what
//! an integrator of high order and the location of that instant need. Whether the forces may really act (push, not
//! pull) is checked on the result, not here.
//!
//! `p' = v`, `q' = w q / 2`, `v' = g + sum f n / m`, `L' = sum r x f n`, with f from `G f = -b` at the stage's state.

use crate::interaction::assembly::Assembly;
use crate::interaction::contact_set::ContactId;
use crate::world::World;
use polhode_contact::ContactKinematics;
use polhode_dynamics::free_fall::quaternion_rate;
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH};
use polhode_dynamics::{BodyState, System};
use polhode_response::{LeastNormHold, ResponseError};
use polhode_spatial::{DQuat, DVec3};

/// A moving group with its held contacts.
#[derive(Debug)]
pub(super) struct ContactSystem<'a> {
    world: &'a World,
    bodies: &'a [usize],
    held: &'a [ContactId],
    /// States of all bodies; those of `bodies` are overwritten at every stage.
    states: Vec<BodyState>,
    /// Those of the held contacts whose features define a contact at the stage. One that has lost its features (edges
    /// that have turned parallel) bears no force; the location of contact changes ends the step where that begins.
    contacts: Vec<(ContactId, ContactKinematics)>,
}

impl<'a> ContactSystem<'a> {
    pub(super) fn new(world: &'a World, states: &[BodyState], bodies: &'a [usize], held: &'a [ContactId]) -> Self {
        Self { world, bodies, held, states: states.to_vec(), contacts: Vec::with_capacity(held.len()) }
    }

    /// The group's bodies.
    pub(super) fn bodies(&self) -> &'a [usize] {
        self.bodies
    }

    /// Flat state of the group.
    pub(super) fn pack(&self) -> Vec<f64> {
        self.bodies.iter().flat_map(|&body| self.states[body].to_array()).collect()
    }

    /// Forces of the held contacts at the present states.
    fn held_forces(&self) -> Result<Vec<f64>, ResponseError> {
        let rows = self.contacts.iter().map(|(id, k)| (*id, k.geometry));
        let assembly = Assembly::new(self.world, &self.states, self.bodies, rows)?;
        let free = assembly.free_accelerations(self.world, &self.states);
        let b = assembly.acceleration_constants(&free, self.contacts.iter().map(|(_, k)| k))?;
        let delassus = assembly.problem.delassus();
        LeastNormHold::factor(&delassus)?.solve(&delassus, &b)
    }

    /// Rates without contact forces.
    fn free_rates(&self, state: &[f64], rates: &mut [f64]) {
        let numbers = state.as_chunks::<WIDTH>().0;
        for ((&body, number), rate) in self.bodies.iter().zip(numbers).zip(rates.as_chunks_mut::<WIDTH>().0) {
            let velocity = self.world.velocity(body, &self.states[body]);
            let quaternion = DQuat::from_xyzw(
                number[QUATERNION + 1],
                number[QUATERNION + 2],
                number[QUATERNION + 3],
                number[QUATERNION],
            );
            rate[POSITION..QUATERNION].copy_from_slice(&velocity.linear.to_array());
            rate[QUATERNION..LINEAR_VELOCITY].copy_from_slice(&quaternion_rate(quaternion, velocity.angular));
            rate[LINEAR_VELOCITY..ANGULAR_MOMENTUM].copy_from_slice(&self.world.gravity().to_array());
            rate[ANGULAR_MOMENTUM..].fill(0.0);
        }
    }
}

impl System for ContactSystem<'_> {
    type Error = ResponseError;

    fn dimension(&self) -> usize {
        self.bodies.len() * WIDTH
    }

    fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), ResponseError> {
        for (&body, numbers) in self.bodies.iter().zip(state.as_chunks::<WIDTH>().0) {
            self.states[body] = BodyState::from_array(numbers);
        }
        let (world, states) = (self.world, &self.states);
        self.contacts.clear();
        self.contacts.extend(self.held.iter().filter_map(|&id| Some((id, world.kinematics(states, id)?))));
        let forces = self.held_forces()?;
        self.free_rates(state, rates);
        for ((id, k), &force) in self.contacts.iter().zip(&forces) {
            for (body, signed) in [(id.a, force), (id.b, -force)] {
                let (Ok(index), Some(rigid)) = (self.bodies.binary_search(&body), &self.world.bodies[body].rigid)
                else {
                    continue;
                };
                let vector = k.geometry.normal * signed;
                let moment = (k.geometry.point - self.states[body].pose.translation).cross(vector);
                let rate = &mut rates[index * WIDTH..(index + 1) * WIDTH];
                add(&mut rate[LINEAR_VELOCITY..], vector * rigid.inverse_mass());
                add(&mut rate[ANGULAR_MOMENTUM..], moment);
            }
        }
        Ok(())
    }
}

/// Adds a vector to the first three numbers of a slice.
fn add(numbers: &mut [f64], vector: DVec3) {
    for (number, component) in numbers.iter_mut().zip(vector.to_array()) {
        *number += component;
    }
}
