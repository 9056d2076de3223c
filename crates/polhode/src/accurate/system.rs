//! The equations of motion of a group of bodies with fixed active contacts and pivots.
//!
//! Within a smooth phase the set of held contacts is frozen and each keeps `chi'' = 0` (thesis 3.4). That makes the
//! right-hand side smooth over the whole step, also past the instant at which a contact would break. An integrator of
//! high order and the location of that instant need this. Whether the forces may really act (push, not pull) is checked
//! on the result, not here.
//!
//! `p' = v`, `q' = w q / 2`, `v' = g + sum f n / m`, `L' = sum r x f n`, with f from `G f = -b` at the stage's state.
//! A pivot adds three rows `a_Q = 0`, with a force at its point. Under force fields, and for a body whose motion is
//! reduced to rotation about its pivot, g and L' are those of [`polhode_dynamics::FreeMotion`].
//!
//! Contacts with friction add the forces along their tangent planes (`held_forces.rs`).
//!
//! Twenty more numbers follow those of the bodies, for the ledgers: the impulses of fixed bodies, of the weights and of
//! the fields, each with its moment about the ledger's point; the energy lost to drag and dampers; and the work of
//! external forces and kinematic bodies. Where contacts have friction, one more follows: the energy lost to it.

use super::flat_positions::Stages;
use super::held_forces::{self, FrictionContact, HeldForces};
use crate::accounting::books::Received;
use crate::collision::active_contacts::ActiveContacts;
use crate::collision::contact_kinematics;
use crate::identity::contact_id::ContactId;
use crate::model::{Loads, Model, prescribed, work};
use crate::reduced::tree::Tree;
use crate::report::momentum_ledger::Momentum;
use crate::solve::cone_violation::ConeViolation;
use crate::tier::smooth_rates::{add, add_outside_rates, free_rates};
use polhode_contact::{ContactGeometry, ContactKinematics};
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, WIDTH};
use polhode_dynamics::{BodyState, RigidBody, System};
use polhode_response::{Memory, ResponseError};
use polhode_spatial::DVec3;

/// Number of components after those of the bodies: momentum and energy from external agents.
const TAIL: usize = 20;

/// Ratio of the largest mass of an island to the smallest above which contacts share their normals (1e3 to 1e6). Below
/// it the rounding of normals moves the light body by less than 1e-12 of what the contacts hold.
const DISPARATE_MASSES: f64 = 1e4;

/// Normals whose components differ by less count as equal (2e-16 to 1e-14): the rounding of the attitudes of bodies
/// whose faces lie flush on each other makes such a difference.
const SAME_NORMAL: f64 = 8.0 * f64::EPSILON;

/// Momentum and energy from external agents, and the energy lost to friction, since the start of the step: from the
/// numbers after those of `bodies` bodies in a flat state.
pub(super) fn received(flat: &[f64], bodies: usize) -> Received {
    let after = flat.get(bodies * WIDTH..).unwrap_or_default();
    let Some((tail, friction)) = after.split_first_chunk::<TAIL>() else { return Received::default() };
    let vector = |first: usize| DVec3::new(tail[first], tail[first + 1], tail[first + 2]);
    let momentum = |first: usize| Momentum { linear: vector(first), angular: vector(first + 3) };
    Received {
        support: momentum(0),
        gravity: momentum(6),
        fields: momentum(12),
        damping_j: tail[18],
        external_j: tail[19],
        friction_j: friction.first().copied().unwrap_or(0.0),
    }
}

/// A moving group with its held contacts.
#[derive(Debug)]
pub(super) struct ContactSystem<'a> {
    model: &'a Model,
    bodies: &'a [usize],
    active: &'a ActiveContacts,
    /// The point of the ledger of momentum.
    about: DVec3,
    /// States of all bodies; those of `bodies` and of kinematic bodies are overwritten at every stage.
    states: &'a mut [BodyState],
    /// The held contacts whose features define a contact at the stage. A contact whose features no longer do (edges
    /// that have become parallel) bears no force; the location of contact changes ends the step where that begins.
    contacts: Vec<(ContactId, ContactKinematics)>,
    /// Those of them with friction.
    friction: Vec<FrictionContact>,
    /// Room of the solvers.
    memory: Memory,
    /// For each body of the group, the sums of the magnitudes of contact forces (N) and of their moments (N m), the
    /// largest of all stages so far. The rounding error of the resultant is proportional to these sums.
    cancelling: Vec<[f64; 2]>,
    /// Whether a stage has been evaluated: the first one is where a step begins.
    has_begun: bool,
    /// How far the forces of that stage are from Coulomb's law.
    violation_at_start: Option<ConeViolation>,
    /// Whether the masses differ so much that contacts share their normals.
    is_disparate: bool,
    stages: Stages,
}

impl<'a> ContactSystem<'a> {
    pub(super) fn new(
        model: &'a Model,
        states: &'a mut [BodyState],
        bodies: &'a [usize],
        active: &'a ActiveContacts,
        about: DVec3,
    ) -> Self {
        Self {
            model,
            bodies,
            active,
            about,
            states,
            contacts: Vec::with_capacity(active.held().len()),
            friction: Vec::new(),
            memory: Memory::default(),
            cancelling: vec![[0.0; 2]; bodies.len()],
            has_begun: false,
            violation_at_start: None,
            is_disparate: masses_differ(model, bodies),
            stages: Stages::AsTheyAre,
        }
    }

    /// Evaluates stages at these poses.
    pub(super) fn evaluate_at(&mut self, stages: Stages) {
        self.stages = stages;
    }

    /// The group's bodies.
    pub(super) fn bodies(&self) -> &'a [usize] {
        self.bodies
    }

    /// The world.
    pub(super) fn model(&self) -> &'a Model {
        self.model
    }

    /// Whether contacts hold bodies of the group.
    pub(super) fn is_held_by_contacts(&self) -> bool {
        !self.active.held().is_empty()
    }

    /// The point of the ledger of momentum, m.
    pub(super) fn about(&self) -> DVec3 {
        self.about
    }

    /// States of all bodies, those of the group as they were set last.
    pub(super) fn states(&self) -> &[BodyState] {
        self.states
    }

    /// Sets the states of the group from its flat state.
    pub(super) fn set_states(&mut self, flat: &[f64]) {
        for (&body, numbers) in self.bodies.iter().zip(flat.as_chunks::<WIDTH>().0) {
            self.states[body] = BodyState::from_array(numbers);
        }
    }

    /// What fields do at `t` when the bodies of the group have these coordinates.
    pub(super) fn loads_of_tree(&mut self, t: f64, tree: &Tree, flat: &[f64]) -> Loads {
        let states = &mut *self.states;
        tree.states(self.model, flat, |node, state| states[node.body] = state);
        prescribed::prescribe(self.model, t, self.states);
        self.model.loads_on(t, self.states, self.bodies)
    }

    /// What fields do at `t` when the bodies of the group have these states.
    pub(super) fn loads_at(&mut self, t: f64, own: impl Iterator<Item = BodyState>) -> Loads {
        for (&body, state) in self.bodies.iter().zip(own) {
            self.states[body] = state;
        }
        prescribed::prescribe(self.model, t, self.states);
        self.model.loads_on(t, self.states, self.bodies)
    }

    /// Of each body of the group, the sums of the magnitudes of contact forces (N) and of their moments (N m).
    pub(super) fn cancelling(&self) -> &[[f64; 2]] {
        &self.cancelling
    }

    /// How far the forces where a step begins are from Coulomb's law.
    pub(super) fn violation_at_start(&self) -> Option<ConeViolation> {
        self.violation_at_start
    }

    /// Updates the largest sums of magnitudes with the forces of a stage.
    fn note_magnitudes(&mut self, held: &HeldForces) {
        let mut sums = vec![[0.0; 2]; self.bodies.len()];
        for (id, geometry, force) in self.contact_forces(held) {
            for (body, _) in id.members() {
                if let Ok(index) = self.bodies.binary_search(&body) {
                    let arm = geometry.point - self.states[body].pose.translation;
                    sums[index][0] += force.abs();
                    sums[index][1] += force.abs() * arm.length();
                }
            }
        }
        for (bilateral, reaction) in held.reactions.of_bilaterals() {
            for (body, force, moment) in bilateral.magnitudes(reaction) {
                if let Ok(index) = self.bodies.binary_search(&body) {
                    sums[index][0] += force;
                    sums[index][1] += moment;
                }
            }
        }
        for (largest, sum) in self.cancelling.iter_mut().zip(sums) {
            *largest = [largest[0].max(sum[0]), largest[1].max(sum[1])];
        }
    }

    /// Forces on A at contacts, along normals and then along tangents, which stand in the place of the normals.
    fn contact_forces<'b>(
        &'b self,
        held: &'b HeldForces,
    ) -> impl Iterator<Item = (ContactId, &'b ContactGeometry, f64)> + Clone {
        held.reactions.at_contacts(self.geometries())
    }

    /// The contacts with their geometry.
    fn geometries(&self) -> impl Iterator<Item = (ContactId, &ContactGeometry)> + Clone {
        self.contacts.iter().map(|(id, kinematics)| (*id, &kinematics.geometry))
    }

    /// How many numbers follow those of the bodies.
    pub(super) fn tail(&self) -> usize {
        TAIL + usize::from(self.active.rub())
    }

    /// Flat state of the group.
    pub(super) fn pack(&self) -> Vec<f64> {
        let bodies = self.bodies.iter().flat_map(|&body| self.states[body].to_array());
        bodies.chain(std::iter::repeat_n(0.0, self.tail())).collect()
    }

    /// Forces of the held contacts and bilateral constraints at the present states.
    fn held_forces(&mut self, t: f64, loads: &Loads) -> Result<HeldForces, ResponseError> {
        if self.contacts.is_empty() && !self.model.joints.has_rows() {
            return Ok(HeldForces::default());
        }
        let at = (t, &*self.states);
        held_forces::solve(self.model, at, self.bodies, &self.contacts, &self.friction, loads, &mut self.memory)
    }

    /// Adds the forces to the rates one by one.
    fn add_forces(&self, held: &HeldForces, rates: &mut [f64]) {
        for (bilateral, reaction) in held.reactions.of_bilaterals() {
            for (body, force, moment) in bilateral.loads(reaction) {
                self.add_load(body, force, moment, rates);
            }
        }
        for (id, geometry, force) in self.contact_forces(held) {
            for (body, sign) in id.members() {
                let signed = force * sign;
                let vector = geometry.normal * signed;
                let moment = (geometry.point - self.states[body].pose.translation).cross(vector);
                self.add_load(body, vector, moment, rates);
            }
        }
    }

    /// Adds the moments of friction of rolling and spinning to the rates.
    fn add_moments(&self, held: &HeldForces, rates: &mut [f64]) {
        for (id, moment) in held.reactions.of_rotations() {
            self.add_load(id.a, DVec3::ZERO, moment, rates);
            self.add_load(id.b, DVec3::ZERO, -moment, rates);
        }
    }

    /// Adds what the contact forces and moments add up to on each body.
    fn add_sums(&self, sums: &[(usize, DVec3, DVec3)], rates: &mut [f64]) {
        for &(body, force, moment) in sums {
            self.add_load(body, force, moment, rates);
        }
    }

    fn add_load(&self, body: usize, force: DVec3, moment: DVec3, rates: &mut [f64]) {
        let (Ok(index), Some(rigid)) = (self.bodies.binary_search(&body), &self.model.bodies[body].rigid) else {
            return;
        };
        let rate = &mut rates[index * WIDTH..(index + 1) * WIDTH];
        add(&mut rate[LINEAR_VELOCITY..], force * rigid.inverse_mass());
        add(&mut rate[ANGULAR_MOMENTUM..], moment);
    }

    /// Rates of the momentum and energy from external agents.
    pub(super) fn outside_rates(&self, t: f64, held: &HeldForces, rates: &mut [f64]) {
        rates.fill(0.0);
        rates[19] = held.reactions.work(self.model, self.states, self.geometries());
        let support = held.reactions.support(self.model, self.about, self.geometries());
        add(&mut rates[..], support.linear);
        add(&mut rates[3..], support.angular);
        add_outside_rates(self.model, t, (self.bodies, self.states), self.about, rates);
        if let Some(friction) = rates.get_mut(TAIL) {
            *friction = held.dissipation;
        }
    }
}

impl System for ContactSystem<'_> {
    type Error = ResponseError;

    fn dimension(&self) -> usize {
        self.bodies.len() * WIDTH + self.tail()
    }

    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), ResponseError> {
        for (&body, numbers) in self.bodies.iter().zip(state.as_chunks::<WIDTH>().0) {
            self.states[body] = BodyState::from_array(numbers);
        }
        self.model.work.add(self.bodies.len() * work::OF_BODY);
        prescribed::prescribe(self.model, t, self.states);
        self.stages.place(self.model, self.states, self.bodies)?;
        let (model, states) = (self.model, &*self.states);
        self.contacts.clear();
        self.contacts.extend(
            self.active.held().iter().filter_map(|&id| Some((id, contact_kinematics::kinematics(model, states, id)?))),
        );
        if self.is_disparate {
            share_normals(self.model, &mut self.contacts);
        }
        if self.active.rub() {
            self.friction.clear();
            self.friction.extend(held_forces::friction_contacts(model, states, &self.contacts, self.active));
        }
        let loads = self.model.loads_on(t, self.states, self.bodies);
        let held = self.held_forces(t, &loads)?;
        self.note_magnitudes(&held);
        if !std::mem::replace(&mut self.has_begun, true) {
            self.violation_at_start = held.violation;
        }
        free_rates(self.model, (self.bodies, self.states), &loads, state, rates);
        if let Some(sums) = &held.sums {
            self.add_sums(sums, rates);
        } else {
            self.add_forces(&held, rates);
            self.add_moments(&held, rates);
        }
        self.outside_rates(t, &held, &mut rates[self.bodies.len() * WIDTH..]);
        Ok(())
    }
}

/// Whether the masses of these bodies differ by [`DISPARATE_MASSES`].
fn masses_differ(model: &Model, bodies: &[usize]) -> bool {
    let masses = bodies.iter().filter_map(|&body| model.bodies[body].rigid.as_ref()).map(RigidBody::mass);
    let (least, most) = masses.fold((f64::INFINITY, 0.0f64), |(least, most), mass| (least.min(mass), most.max(mass)));
    most > DISPARATE_MASSES * least
}

/// Gives contacts whose normals are one direction to rounding the same normal, that of a contact with an immovable body
/// where there is one.
///
/// Under a heavy body that stands flush, forces of its weight W go through a light one from contact to contact. Normals
/// that differ by the rounding u of attitudes leave a lateral force of `u W` on the light body, as a wedge would: it
/// moved a box of 1 kg under 1e9 kg on a slope by 2e-7 m in a second. Attitudes in double precision cannot resolve
/// this; the information that the faces are flush does.
fn share_normals(model: &Model, contacts: &mut [(ContactId, ContactKinematics)]) {
    let is_supported = |id: &ContactId| !model.bodies[id.a].moves() || !model.bodies[id.b].moves();
    let mut directions: Vec<DVec3> = Vec::new();
    for supported in [true, false] {
        for (_, k) in contacts.iter_mut().filter(|(id, _)| is_supported(id) == supported) {
            let normal = &mut k.geometry.normal;
            let is_one = |one: DVec3, other: DVec3| (one - other).abs().max_element() <= SAME_NORMAL;
            let shared = directions.iter().find_map(|&direction| match () {
                () if is_one(*normal, direction) => Some(direction),
                () if is_one(*normal, -direction) => Some(-direction),
                () => None,
            });
            match shared {
                Some(direction) => *normal = direction,
                None => directions.push(*normal),
            }
        }
    }
}
