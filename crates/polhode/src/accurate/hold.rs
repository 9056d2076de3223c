//! Active contacts and their forces, from the complementarity problem of accelerations.
//!
//! The complementarity problem of thesis 3.4, `0 <= f _|_ chi'' = G f + b >= 0`, decides: a contact with a positive
//! force holds; a contact whose bodies accelerate apart breaks. The accelerations are unique, the forces may not be
//! (erratum E13).

use crate::collision::friction_mode::FrictionMode;
use crate::collision::touch::Touch;
use crate::collision::turn::Turn;
use crate::identity::contact_id::ContactId;
use crate::model::Model;
use crate::rows::assembly::{self, Assembly};
use crate::solve::accelerations::{Accelerations, ContactTangent, ContactTurn, Wanted, violation_of_bearings};
use crate::solve::cone_violation::{ConeViolation, largest_violation};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::{Answer, Memory, ResponseError, SolverStatus};
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// A contact breaks if its bodies accelerate apart by more than this, relative to the largest relative acceleration of
/// the group's contacts without contact forces. The rounding error of the solution is some 1e-15.
const OPENING_RELATIVE: f64 = 1e-11;

/// The net force on a body in equilibrium is at most this fraction of the sum of the magnitudes of the forces on it;
/// likewise for moments. The rounding error of a few hundred contacts is below 1e-13.
const EQUILIBRIUM_RELATIVE: f64 = 1e-12;

/// Forces of some contacts of a group, and the accelerations of its bodies, at one instant.
#[derive(Debug)]
pub(super) struct Forces {
    pub(super) solution: Answer,
    pub(super) assembly: Assembly,
    /// How many contacts.
    contacts: usize,
    /// Generalised accelerations of the group's bodies.
    accelerations: Vec<f64>,
    /// Time of the forces, s.
    t: f64,
    /// Relative acceleration above which a contact breaks, m/s^2.
    pub(super) opening: f64,
    /// Largest sum of weight and field force on a body of the group, N: a scale for the rounding error of contact
    /// forces.
    pub(super) load: f64,
    /// Friction of rolling and spinning.
    turns: BTreeMap<(ContactId, Turn), ContactTurn>,
    /// Friction of the contacts, in their order; none of those without friction.
    friction: Vec<Option<ContactFriction>>,
    /// Whether other normal forces that hold all contacts as well would move the bodies in another way.
    pub(super) motion_depends_on_choice: bool,
    /// Whether contacts slide and no forces were found: they may jam.
    pub(super) jams: bool,
    /// How far contacts with friction are from Coulomb's law.
    pub(super) violation: Option<ConeViolation>,
    /// The modes that the contacts were known to have.
    known_modes: Vec<Option<FrictionMode>>,
}

/// Whether a contact sticks or slides from an instant on.
#[derive(Debug, Clone, Copy)]
pub(super) enum FoundMode {
    /// As was known before its forces.
    Known(FrictionMode),
    /// It begins to slide in this direction (unit vector, world).
    Begins(DVec3),
    /// It sticks.
    Sticks,
}

/// Friction of a contact at one instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContactFriction {
    /// Force on A in the tangent plane, N.
    pub(super) force: DVec3,
    /// `u_T'`, m/s^2.
    slip_acceleration: DVec3,
    /// The direction in which it slides from this instant on (unit vector, world); none when it sticks.
    pub(super) sliding: Option<DVec3>,
    /// Whether its forces hold it.
    pub(super) is_held: bool,
}

impl ContactFriction {
    /// How fast a slip along this direction grows, m/s^2.
    pub(super) fn growth_along(&self, direction: DVec3) -> f64 {
        self.slip_acceleration.dot(direction)
    }
}

impl Forces {
    /// Solves for the forces of `contacts` on `bodies` (movable, ascending) at time `t`.
    ///
    /// # Errors
    /// When the problem is not finite.
    pub(super) fn solve(
        model: &Model,
        t: f64,
        states: &[BodyState],
        bodies: &[usize],
        contacts: &[Touch],
        memory: &mut Memory,
    ) -> Result<Self, ResponseError> {
        let loads = model.loads_on(t, states, bodies);
        let load = bodies.iter().map(|&body| {
            let mass = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
            mass * model.gravity().length() + loads.of(body).force.length()
        });
        let load = load.fold(0.0, f64::max);
        let wanted = (Wanted::Future, memory);
        let found = Accelerations::solve(model, (t, states), bodies, contacts, &loads, wanted)?;
        let opening = OPENING_RELATIVE * found.scale;
        let friction = found.contacts.iter().map(|contact| {
            contact.map(|contact| {
                let ContactTangent { force, slip_acceleration, sliding, is_held, .. } = contact;
                let begins = !is_held && slip_acceleration.length() > opening;
                let begins_along = if begins { contact.begins_along() } else { None };
                let is_held = sliding.is_none() && !begins;
                ContactFriction { force, slip_acceleration, sliding: sliding.or(begins_along), is_held }
            })
        });
        let friction: Vec<Option<ContactFriction>> = friction.collect();
        let slides = found.contacts.iter().flatten().any(|contact| contact.sliding.is_some());
        let violation = violation_of(&found, &friction, load);
        Ok(Self {
            violation,
            motion_depends_on_choice: found.motion_depends_on_choice,
            jams: slides && found.solution.report.status != SolverStatus::Solved,
            known_modes: contacts.iter().map(|touch| touch.modes.friction).collect(),
            turns: found.turns,
            friction,
            contacts: contacts.len(),
            solution: found.solution,
            assembly: found.assembly,
            accelerations: found.of_bodies,
            t,
            opening,
            load,
        })
    }

    /// Whether a contact, by its place in the list, sticks or slides from this instant on; none without friction.
    pub(super) fn mode(&self, contact: usize) -> Option<FoundMode> {
        let sliding = self.friction(contact)?.sliding;
        let known = self.known_modes.get(contact).copied().flatten();
        Some(match (known, sliding) {
            (Some(mode), _) => FoundMode::Known(mode),
            (None, Some(direction)) => FoundMode::Begins(direction),
            (None, None) => FoundMode::Sticks,
        })
    }

    /// Whether a rotation at a contact is held or turns from this instant on; none without friction of its kind.
    pub(super) fn turn_mode(&self, touch: &Touch, turn: Turn) -> Option<FoundMode> {
        let found = self.turns.get(&(touch.id, turn))?;
        Some(match (touch.modes.rotation.get(turn), found.turning) {
            (Some(mode @ FrictionMode::Sliding(_)), _) => FoundMode::Known(mode),
            (_, Some(direction)) => FoundMode::Begins(direction),
            (_, None) => FoundMode::Sticks,
        })
    }

    /// The rotations at `contacts` that friction holds no longer, with the direction in which they begin.
    pub(super) fn turning<'a>(
        &'a self,
        contacts: &'a [Touch],
    ) -> impl Iterator<Item = ((ContactId, Turn), DVec3)> + 'a {
        let held = contacts.iter().flat_map(|touch| Turn::ALL.map(|turn| (touch, turn)));
        let held = held.filter(|(touch, turn)| touch.modes.rotation.get(*turn) == Some(FrictionMode::Sticking));
        held.filter_map(|(touch, turn)| {
            let key = (touch.id, turn);
            Some((key, self.turns.get(&key)?.turning?))
        })
    }

    /// Friction of a contact, by its place in the list; none without friction.
    pub(super) fn friction(&self, contact: usize) -> Option<ContactFriction> {
        *self.friction.get(contact)?
    }

    /// The contacts among `contacts` that stick and whose slips grow nevertheless: they can stick no longer. With the
    /// direction of the slip.
    pub(super) fn slipping<'a>(&'a self, contacts: &'a [Touch]) -> impl Iterator<Item = (ContactId, DVec3)> + 'a {
        contacts.iter().zip(&self.friction).filter_map(|(touch, friction)| {
            let friction = friction.as_ref()?;
            let slips = touch.modes.friction == Some(FrictionMode::Sticking)
                && friction.slip_acceleration.length() > self.opening;
            if slips { Some((touch.id, friction.sliding?)) } else { None }
        })
    }

    /// Largest relative acceleration at contacts that break or begin to slide, m/s^2.
    pub(super) fn largest_opening(&self, contacts: &[Touch]) -> f64 {
        let opening = self.solution.velocities.iter().fold(0.0f64, |most, &w| most.max(w));
        let slips = contacts
            .iter()
            .zip(&self.friction)
            .filter(|(touch, _)| touch.modes.friction == Some(FrictionMode::Sticking));
        let slips = slips.filter_map(|(_, friction)| Some(friction.as_ref()?.slip_acceleration.length()));
        slips.fold(opening, f64::max)
    }

    /// Forces of the contacts, without those of pivots.
    pub(super) fn of_contacts(&self) -> &[f64] {
        self.solution.reactions.get(..self.contacts).unwrap_or_default()
    }

    /// The event function of contact break, for each contact, m/s^2: the threshold acceleration minus the relative
    /// acceleration. It is positive while a force holds the contact, and negative when the contact breaks.
    pub(super) fn opening_margins(&self) -> impl Iterator<Item = f64> + '_ {
        let accelerations = self.solution.velocities.iter().take(self.contacts);
        accelerations.map(|w| self.opening - w)
    }

    /// Accelerations of the bodies: (body, linear, angular).
    pub(super) fn accelerations(&self) -> impl Iterator<Item = (usize, DVec3, DVec3)> + '_ {
        self.assembly.split(&self.accelerations)
    }

    /// Relative acceleration under these forces along the normal of another contact of these bodies, which was not part
    /// of the problem, m/s^2.
    pub(super) fn relative_acceleration(&self, model: &Model, states: &[BodyState], touch: &Touch) -> f64 {
        let geometry = &touch.kinematics.geometry;
        let at = (self.t, states);
        let along = (geometry, touch.kinematics.acceleration_bias);
        assembly::relative_acceleration(model, at, touch.id, along, self.accelerations())
    }

    /// Bodies in equilibrium: net force and net moment are negligible against the sums of their magnitudes.
    pub(super) fn balanced_bodies(&self, model: &Model, states: &[BodyState], contacts: &[Touch]) -> BTreeSet<usize> {
        let mut force_sums = vec![0.0; model.bodies.len()];
        let mut moment_sums = vec![0.0; model.bodies.len()];
        for (index, (touch, normal)) in contacts.iter().zip(&self.solution.reactions).enumerate() {
            let force = self.friction(index).map_or(*normal, |friction| normal + friction.force.length());
            for (body, _) in touch.id.members() {
                let arm = touch.kinematics.geometry.point - states[body].pose.translation;
                force_sums[body] += force;
                moment_sums[body] += force * arm.length();
            }
        }
        for (bilateral, reaction) in self.assembly.reactions(&self.solution.reactions) {
            for (body, force, moment) in bilateral.magnitudes(reaction) {
                force_sums[body] += force;
                moment_sums[body] += moment;
            }
        }
        self.accelerations()
            .filter(|&(body, linear, angular)| {
                model.bodies[body].rigid.as_ref().is_some_and(|rigid| {
                    let weight = rigid.mass() * model.gravity().length();
                    let net_force = rigid.mass() * linear.length();
                    let rotation = states[body].pose.rotation;
                    let net_moment = (rigid.inertia() * rotation.inverse_rotate(angular)).length();
                    let weight_moment = weight * model.bodies[body].size;
                    net_force <= EQUILIBRIUM_RELATIVE * (force_sums[body] + weight)
                        && net_moment <= EQUILIBRIUM_RELATIVE * (moment_sums[body] + weight_moment)
                })
            })
            .map(|(body, _, _)| body)
            .collect()
    }
}

/// The largest violation of Coulomb's law: of the cones by forces, relative to the largest of them or to `load` (N);
/// and by contacts that go on sticking although their slips grow, the acceleration of the slip relative to the largest
/// without contact forces.
fn violation_of(found: &Accelerations, friction: &[Option<ContactFriction>], load: f64) -> Option<ConeViolation> {
    let by_forces = largest_violation(found.contacts.iter().flatten().map(|contact| contact.rubbing), load);
    let by_forces = ConeViolation::larger(by_forces, violation_of_bearings(&found.assembly));
    let sticks = found.contacts.iter().flatten().zip(friction.iter().flatten()).filter(|(_, own)| own.is_held);
    let slip = |(contact, own): (&ContactTangent, &ContactFriction)| {
        let value = own.slip_acceleration.length() / found.scale;
        (value > 0.0).then_some(ConeViolation { value, pair: contact.rubbing.pair })
    };
    sticks.filter_map(slip).fold(by_forces, |worst, one| ConeViolation::larger(worst, Some(one)))
}
