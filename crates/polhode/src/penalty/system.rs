//! The equations of motion of a group of bodies with the springs between them.
//!
//! `p' = v`, `q' = w q / 2`, `v' = g + sum F/m`, `L' = sum r x F + M`, with the forces of `contact` at the state of the
//! stage, and the reactions of joints that leave their rows no acceleration under all of these
//! (`crate::solve::joint_reactions`). Which springs there are and their modes are frozen. The state is flat: the
//! bodies, four numbers for each spring (its tangential vector and its slip), and [`TAIL`] numbers for the ledgers:
//! impulses of fixed bodies, weights and fields, each with its moment, energy lost to dampers and drag, external work,
//! and energy lost to friction.

use super::contact::{ContactSpring, Evaluated, Force, Grip, SPRING};
use crate::accounting::books::Received;
use crate::identity::contact_id::ContactId;
use crate::joints::bilateral::{self, bilateral_support};
use crate::model::{Loads, Model, prescribed, work};
use crate::report::momentum_ledger::Momentum;
use crate::solve::joint_reactions::JointReactions;
use crate::tier::smooth_rates::{add, add_outside_rates, free_rates};
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, WIDTH};
use polhode_dynamics::{BodyState, System, state};
use polhode_spatial::DVec3;
use std::convert::Infallible;

/// Numbers for the ledgers after those of bodies and springs.
pub(super) const TAIL: usize = 21;

/// Place in the ledgers of what dampers, external agents and friction do, and how many numbers that is.
pub(super) const DISSIPATION: usize = 18;
pub(super) const DISSIPATIONS: usize = 3;

/// A group with its springs.
#[derive(Debug)]
pub(super) struct SpringSystem<'a> {
    pub(super) model: &'a Model,
    pub(super) bodies: &'a [usize],
    pub(super) springs: &'a [ContactSpring],
    /// The point of the ledger of momentum.
    pub(super) about: DVec3,
    /// States of all bodies; those of `bodies` and of kinematic bodies are overwritten at every stage.
    pub(super) states: &'a mut [BodyState],
}

impl SpringSystem<'_> {
    /// Flat state of the group, with empty ledgers.
    pub(super) fn pack(&self) -> Vec<f64> {
        let bodies = self.bodies.iter().flat_map(|&body| self.states[body].to_array());
        let springs = self.springs.iter().flat_map(ContactSpring::numbers);
        bodies.chain(springs).chain(std::iter::repeat_n(0.0, TAIL)).collect()
    }

    /// Sets the states of the group, and those of kinematic bodies, from its flat state at `t` (s).
    pub(super) fn set_states(&mut self, t: f64, flat: &[f64]) {
        self.model.work.add((self.bodies.len() + self.springs.len()) * work::OF_BODY);
        for (&body, numbers) in self.bodies.iter().zip(flat.as_chunks::<WIDTH>().0) {
            self.states[body] = BodyState::from_array(numbers);
        }
        prescribed::prescribe(self.model, t, self.states);
    }

    /// A spring with its vector of a flat state.
    pub(super) fn spring(&self, flat: &[f64], index: usize) -> ContactSpring {
        let first = self.bodies.len() * WIDTH + index * SPRING;
        self.springs[index].with_numbers(flat.get(first..).unwrap_or_default())
    }

    /// A spring in the states that were set last; none where its features define no contact.
    pub(super) fn evaluated(&self, spring: &ContactSpring) -> Option<Evaluated> {
        Evaluated::new(self.model, self.states, spring.id, spring.friction.is_some())
    }

    /// Elastic energy of all springs in a flat state, J, and that of the tangential springs that give way.
    pub(super) fn energies(&mut self, t: f64, flat: &[f64]) -> (f64, f64) {
        self.set_states(t, flat);
        let (mut all, mut yielding) = (0.0, 0.0);
        for index in 0..self.springs.len() {
            let spring = self.spring(flat, index);
            if let Some(at) = self.evaluated(&spring) {
                all += spring.energy(&at);
                if spring.gives_way() {
                    yielding += spring.tangential_energy(&at);
                }
            }
        }
        (all, yielding)
    }

    /// Momentum and energy received since the ledgers of a flat state were empty.
    pub(super) fn received(&self, flat: &[f64]) -> Received {
        let first = self.bodies.len() * WIDTH + self.springs.len() * SPRING;
        let Some(tail) = flat.get(first..).and_then(|tail| tail.first_chunk::<TAIL>()) else {
            return Received::default();
        };
        let vector = |first: usize| DVec3::new(tail[first], tail[first + 1], tail[first + 2]);
        let momentum = |first: usize| Momentum { linear: vector(first), angular: vector(first + 3) };
        Received {
            support: momentum(0),
            gravity: momentum(6),
            fields: momentum(12),
            damping_j: tail[18],
            external_j: tail[19],
            friction_j: tail[20],
        }
    }

    /// Adds the reactions of joints to the rates of bodies and ledgers, where springs do this to the bodies (by their
    /// places in the group: N, N m). Where they cannot be found the rates are no numbers, and the step is refused.
    fn add_reactions(&self, t: f64, (loads, springs): (&Loads, &[(DVec3, DVec3)]), rates: &mut [f64]) {
        let of_springs = self.bodies.iter().zip(springs).map(|(&body, &(force, moment))| (body, force, moment));
        let Ok(found) = JointReactions::solve(self.model, (t, self.states), self.bodies, &loads.with(of_springs))
        else {
            rates.fill(f64::NAN);
            return;
        };
        for (bilateral, reaction) in found.reactions() {
            for (body, force, moment) in bilateral.loads(reaction) {
                self.add_load(body, force, moment, rates);
            }
        }
        let tail = &mut rates[self.bodies.len() * WIDTH + self.springs.len() * SPRING..];
        let support = bilateral_support(self.about, found.reactions());
        add(tail, support.linear);
        add(&mut tail[3..], support.angular);
        tail[19] += bilateral::driven_work(self.model, self.states, found.reactions());
    }

    /// Adds a force on a body and its moment about the centre of mass to the rates.
    fn add_load(&self, body: usize, force: DVec3, moment: DVec3, rates: &mut [f64]) {
        let (Ok(index), Some(rigid)) = (self.bodies.binary_search(&body), &self.model.bodies[body].rigid) else {
            return;
        };
        let rate = &mut rates[index * WIDTH..(index + 1) * WIDTH];
        add(&mut rate[LINEAR_VELOCITY..], force * rigid.inverse_mass());
        add(&mut rate[ANGULAR_MOMENTUM..], moment);
    }

    /// What a contact does to one of its bodies, by the sign of its force there: N, and N m about the centre of mass.
    fn load(&self, body: usize, (at, force, sign): (&Evaluated, &Force, f64)) -> (DVec3, DVec3) {
        let on = force.on_a * sign;
        (on, (at.point - self.states[body].pose.translation).cross(on) + force.moment * sign)
    }

    /// Rates of the ledgers by one contact.
    fn contact_rates(&self, id: ContactId, at: &Evaluated, force: &Force, tail: &mut [f64]) {
        let carries = |body: usize| self.model.carries_momentum(body);
        let sign = match (carries(id.a), carries(id.b)) {
            (true, false) => 1.0,
            (false, true) => -1.0,
            _ => 0.0,
        };
        let given = force.on_a * sign;
        add(tail, given);
        add(&mut tail[3..], (at.point - self.about).cross(given) + force.moment * sign);
        tail[18] += force.damping;
        tail[20] += force.friction;
        // Kinematic bodies and driven surfaces give what movable bodies receive beyond the relative power.
        let is_driven = |body: usize| self.model.bodies[body].trajectory.is_some();
        if is_driven(id.a) || is_driven(id.b) || self.model.surfaces.are_driven() {
            let power = |body: usize, sign: f64| {
                let Some(rigid) = &self.model.bodies[body].rigid else { return 0.0 };
                let velocity = rigid.velocity(&self.states[body]);
                let (force, moment) = self.load(body, (at, force, sign));
                force.dot(velocity.linear) + moment.dot(velocity.angular)
            };
            let received = power(id.a, 1.0) + power(id.b, -1.0);
            let relative = force.tangential.dot(at.slip) + force.moment.dot(at.rotation);
            tail[19] += received + force.normal * at.rate - relative;
        }
    }
}

impl ContactSpring {
    /// Whether friction takes up more than slip, so that the elastic energy of its spring is part of what it takes.
    pub(super) fn gives_way(&self) -> bool {
        self.slides() || matches!(self.grip, Grip::Cut | Grip::CutSliding)
    }
}

impl System for SpringSystem<'_> {
    type Error = Infallible;

    fn dimension(&self) -> usize {
        self.bodies.len() * WIDTH + self.springs.len() * SPRING + TAIL
    }

    fn derivative(&mut self, t: f64, flat: &[f64], rates: &mut [f64]) -> Result<(), Infallible> {
        self.set_states(t, flat);
        let loads = self.model.loads_on(t, self.states, self.bodies);
        free_rates(self.model, (self.bodies, self.states), &loads, flat, rates);
        let first = self.bodies.len() * WIDTH;
        let end = first + self.springs.len() * SPRING;
        rates[first..].fill(0.0);
        let mut sums = vec![(DVec3::ZERO, DVec3::ZERO); self.bodies.len()];
        for index in 0..self.springs.len() {
            let spring = self.spring(flat, index);
            let Some(at) = self.evaluated(&spring) else { continue };
            let force = spring.force(&at);
            for (body, sign) in [(spring.id.a, 1.0), (spring.id.b, -1.0)] {
                let Ok(index) = self.bodies.binary_search(&body) else { continue };
                let (force, moment) = self.load(body, (&at, &force, sign));
                self.add_load(body, force, moment, rates);
                sums[index].0 += force;
                sums[index].1 += moment;
            }
            let place = first + index * SPRING;
            let [x, y, z] = force.vector_rate.to_array();
            rates[place..place + SPRING].copy_from_slice(&[x, y, z, spring.slipping(&at)]);
            self.contact_rates(spring.id, &at, &force, &mut rates[end..]);
        }
        if self.model.joints.has_rows() {
            self.add_reactions(t, (&loads, &sums), rates);
        }
        add_outside_rates(self.model, t, (self.bodies, self.states), self.about, &mut rates[end..]);
        Ok(())
    }

    fn normalize(&self, flat: &mut [f64]) {
        let bodies = self.bodies.len() * WIDTH;
        if let Some(bodies) = flat.get_mut(..bodies) {
            state::normalize(bodies);
        }
    }
}
