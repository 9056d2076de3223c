//! Bounces that are too small to resolve, and their end.
//!
//! A contact that separates with the speed `w`, while the forces accelerate it back by `a`, rises by `h = w^2/(2a)`.
//! Where that is below [`NEGLIGIBLE_HEIGHT`] touch distances, its bodies cannot be distinguished from bodies that
//! touch. The sequence of bounces that follows (2w/a in all for e = 0, and 2w/(a (1 - e)) in general; thesis 3.3) is
//! replaced by its end: the smallest change of velocities that makes the speeds of all contacts that hold zero, with
//! the friction that belongs to it (`solve/bounce_friction.rs`). It is booked as energy lost at rest.
//!
//! A bounce that is small at its contact need not be small elsewhere. A die that rocks on two contacts half a
//! millimetre apart separates there by a thousandth of what it does at its far corners. Such a bounce is no remainder
//! but a motion: it goes on. To tell them apart, the energy that the end takes is compared with that of lifting the
//! bodies,
//!
//! `dE <= m w^2/2 + m a d`,
//!
//! with the sum `m` of their masses (kg), the speed `w` (m/s) and acceleration `a` (m/s^2) of the fastest bounce, and
//! the touch distance `d` (m).
//!
//! Fails where bounces that are not small follow each other without end (restitution of almost 1): such events crowd,
//! and time steps take over (`crowding.rs`).

use super::hold::Forces;
use super::resolve::Resolution;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::joints::joint_contacts;
use crate::model::states_of::{set_states, states_of};
use crate::model::tolerances;
use crate::rows::groups::Group;
use crate::solve::bounce_friction;
use polhode_dynamics::RigidBody;
use std::collections::BTreeSet;

/// Bounces up to this many times the touch distance in height are not resolved one by one.
const NEGLIGIBLE_HEIGHT: f64 = 64.0;

/// A bounce that may be ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct SmallBounce {
    /// The index of its contact in the instant.
    pub(super) contact: usize,
    /// The rate at which it separates, m/s.
    speed: f64,
    /// The energy of lifting its bodies by the touch distance, `a d`, for each kilogram, J/kg.
    lifting: f64,
    /// When its sequence would end, s.
    rest: f64,
}

impl Resolution<'_> {
    /// Contacts that separate so slowly that they would close again at once. Those in `going_on` are known to be no
    /// remainders. A contact with restitution 1 never stops bouncing and is not included.
    pub(super) fn negligible_bounces(
        &self,
        group: &Group,
        (candidates, forces): (&[usize], &Forces),
        going_on: &BTreeSet<usize>,
    ) -> Vec<SmallBounce> {
        let mut bounces = Vec::new();
        let is_open = |i: &usize| candidates.binary_search(i).is_err() && !going_on.contains(i);
        for contact in group.contacts.iter().copied().filter(is_open) {
            let touch = self.instant.touches[contact];
            let restitution = joint_contacts::restitution_of(&self.core.model, touch.id);
            let speed = touch.kinematics.separation_rate;
            let acceleration = forces.relative_acceleration(&self.core.model, &self.motions.states, &touch);
            if restitution >= 1.0 || speed <= 0.0 || acceleration >= 0.0 {
                continue;
            }
            let height = speed * speed / (-2.0 * acceleration);
            let touch_distance =
                tolerances::touch_distance(&self.core.model, &self.motions.states, touch.id.a, touch.id.b);
            if height <= NEGLIGIBLE_HEIGHT * touch_distance {
                let rest = self.instant.t + 2.0 * speed / (-acceleration * (1.0 - restitution));
                bounces.push(SmallBounce { contact, speed, lifting: -acceleration * touch_distance, rest });
            }
        }
        bounces
    }

    /// Ends bounces, together if that takes as little energy as it may, or else one after the other. Returns the
    /// contacts whose bounces have ended.
    pub(super) fn end_bounces(
        &mut self,
        group: &Group,
        (candidates, bounces): (&[usize], &[SmallBounce]),
    ) -> Result<Vec<usize>, SimulationError> {
        self.motions.end_flights(self.core, self.instant.t, &group.bodies);
        if self.end_together(group, (candidates, bounces))? {
            return Ok(bounces.iter().map(|bounce| bounce.contact).collect());
        }
        let mut ended = Vec::new();
        if bounces.len() > 1 {
            for bounce in bounces {
                let held: Vec<usize> = candidates.iter().chain(&ended).copied().collect();
                if self.end_together(group, (&held, &[*bounce]))? {
                    ended.push(bounce.contact);
                }
            }
        }
        Ok(ended)
    }

    /// Sets the relative velocities of some bounces and of the contacts that hold to zero, unless that takes more
    /// energy than it may. Returns whether it did.
    fn end_together(
        &mut self,
        group: &Group,
        (candidates, bounces): (&[usize], &[SmallBounce]),
    ) -> Result<bool, SimulationError> {
        let mut contacts: Vec<usize> = candidates.iter().copied().chain(bounces.iter().map(|b| b.contact)).collect();
        contacts.sort_unstable();
        let ids: Vec<_> = contacts.iter().map(|&i| self.instant.touches[i].id).collect();
        let speed = |touch: &Touch| touch.kinematics.separation_rate.abs();
        let fastest = contacts.iter().map(|&i| self.instant.touches[i]).max_by(|x, y| speed(x).total_cmp(&speed(y)));
        let Some(fastest) = fastest else { return Ok(false) };
        let start = states_of(&self.motions.states, &group.bodies);
        let before = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &group.bodies);
        let largest = |of: fn(&SmallBounce) -> f64| bounces.iter().map(of).fold(0.0, f64::max);
        let w = largest(|bounce| bounce.speed);
        let ended = bounce_friction::end_bounces(&self.core.model, &mut self.motions.states, &group.bodies, (&ids, w))
            .map_err(|source| SimulationError::of_response(self.instant.t, source))?;
        let after = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &group.bodies);
        let taken = before.lost_until(after, ended.work_j) - ended.friction_j;
        let mass = |&body: &usize| self.core.model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
        let mass = group.bodies.iter().map(mass).sum::<f64>();
        if taken > mass * (0.5 * w * w + largest(|bounce| bounce.lifting)) {
            set_states(&mut self.motions.states, &group.bodies, &start);
            return Ok(false);
        }
        self.core.book_ended_bounces(self.instant.t, &group.bodies, &fastest, (before, after), &ended);
        for bounce in bounces {
            let id = self.instant.touches[bounce.contact].id;
            for body in [id.a, id.b] {
                let known = self.instant.rest_times.entry(body).or_insert(bounce.rest);
                *known = known.max(bounce.rest);
            }
        }
        self.refresh_kinematics();
        Ok(true)
    }
}
