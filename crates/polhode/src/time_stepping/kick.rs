//! Force fields as one kick: the wrenches in the middle of the step, over its whole length.
//!
//! Springs that are stiff in the step, and drag and dampers, act by `implicit_kick.rs`. Other fields that depend on
//! velocities are evaluated twice, at the velocity before the kick and at that with half the kick, so that the kick is
//! of order 2; beside motors that give their bound they are evaluated once.
//!
//! What constraints do in the same step belongs to the velocity in its middle: drag on a pendulum acts at the velocity
//! that the joint leaves it. So where a field resists motion and something is held, the step solves for its constraints
//! twice, and the second kick knows how they have changed the velocities the first time ([`Kick::is_resisting`]).
//! Without, such a step is of order 1.
//!
//! Kick and impulses of constraints act together in the middle of the step. At one pose the kinetic energy is quadratic
//! in the momenta, so that a wrench (F, T) over h does the work `h (F.v + T.w)` exactly, at the mean of the velocities
//! before the kick and after the impulses (`shared_work.rs`).

use super::implicit_kick::{Difference, ImplicitKick, Twist, change_velocities};
use crate::accounting::books::{Books, Received};
use crate::joints::soft_rows;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Loads, Model};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Account, Dependence};
use polhode_spatial::{DVec3, Velocity};

/// A kick that was given.
#[derive(Debug, Default)]
pub(super) struct Kick {
    /// The states of the bodies before it.
    before: Vec<BodyState>,
    /// How it has changed the velocities of the bodies, about the origins of their frames; empty where no field acts.
    pub(super) changes: Vec<Twist>,
    /// Mean wrenches of the step, as those of constant forces.
    accounts: Vec<(Account, Loads)>,
    /// The impulses by which an implicit kick differs from these.
    differences: Vec<Difference>,
    /// The forces at joints that were part of it, by number; the others are soft rows.
    pub(super) of_joints: Vec<usize>,
    /// Whether it depends on the velocities of the bodies, or resists their change.
    is_resisting: bool,
}

impl Kick {
    /// Kicks `bodies` by the fields at `t`, the middle of a step of `h` (s), in which constraints are known to change
    /// the velocities by this much (none: nothing is known of them).
    pub(super) fn of(
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        (t, h): (f64, f64),
        by_constraints: &[Twist],
    ) -> Self {
        if !bodies.iter().any(|&body| model.is_loaded(body)) {
            return Self::default();
        }
        let before = states_of(states, bodies);
        let of_joints = soft_rows::kicks_of_joints(model, states, bodies);
        let kicks = &of_joints[..];
        let responses = model.responses_on(states, bodies, kicks);
        if responses.are_known
            && let Some(kick) = ImplicitKick::new(model, states, bodies, responses.of_fields, h)
        {
            let loads = model.kick_loads_on(t, states, bodies, kicks);
            let accounts = wrenches(model, t, states, (bodies, kicks));
            let forces = |&body: &usize| Twist { linear: loads.of(body).force * h, angular: loads.of(body).torque * h };
            let changes = kick.solve(&bodies.iter().map(forces).collect::<Vec<_>>(), by_constraints);
            let differences = kick.differences(&changes, by_constraints);
            change_velocities(model, states, bodies, &changes);
            return Self { before, changes, accounts, differences, of_joints, is_resisting: true };
        }
        let mut loads = model.kick_loads_on(t, states, bodies, kicks);
        let (mut accounts, mut is_resisting) = (None, false);
        if model.forces.are_motors_at_bounds(kicks) {
            // What they give is known before. At velocities that no joint has held yet they would ask for something
            // else.
            accounts = Some(wrenches(model, t, states, (bodies, kicks)));
        } else if model.free_motion().dependence() == Dependence::Velocities {
            is_resisting = true;
            apply(model, states, bodies, &loads, 0.5 * h);
            let half = |change: &Twist| Twist { linear: change.linear * 0.5, angular: change.angular * 0.5 };
            change_velocities(model, states, bodies, &by_constraints.iter().map(half).collect::<Vec<_>>());
            loads = model.kick_loads_on(t, states, bodies, kicks);
            accounts = Some(wrenches(model, t, states, (bodies, kicks)));
            set_states(states, bodies, &before);
        }
        apply(model, states, bodies, &loads, h);
        let accounts = accounts.unwrap_or_else(|| wrenches(model, t, states, (bodies, kicks)));
        let change = |&body: &usize| {
            let Some(rigid) = &model.bodies[body].rigid else { return Twist::default() };
            let angular = rigid.inverse_inertia_world(states[body].pose.rotation) * (loads.of(body).torque * h);
            Twist { linear: loads.of(body).force * (h * rigid.inverse_mass()), angular }
        };
        let changes = bodies.iter().map(change).collect();
        Self { before, changes, accounts, differences: Vec::new(), of_joints, is_resisting }
    }

    /// How constraints have changed the velocities since this kick.
    pub(super) fn changes_since(&self, model: &Model, states: &[BodyState], bodies: &[usize]) -> Vec<Twist> {
        let change = |((&body, start), kicked): ((&usize, &BodyState), &Twist)| {
            let Some(rigid) = &model.bodies[body].rigid else { return Twist::default() };
            let (now, rotation) = (&states[body], start.pose.rotation);
            let turned = rigid.angular_velocity_at(rotation, now.angular_momentum - start.angular_momentum);
            Twist {
                linear: now.linear_velocity - start.linear_velocity - kicked.linear,
                angular: turned - kicked.angular,
            }
        };
        bodies.iter().zip(&self.before).zip(&self.changes).map(change).collect()
    }

    /// Takes the kick back.
    pub(super) fn undo(&self, states: &mut [BodyState], bodies: &[usize]) {
        set_states(states, bodies, &self.before);
    }

    /// Whether it depends on the velocities of the bodies, or resists their change.
    pub(super) fn is_resisting(&self) -> bool {
        self.is_resisting
    }

    /// Momentum and work of the fields over the step of `h` (s), in the states after all impulses; moments about the
    /// point of the books.
    pub(super) fn received(
        &self,
        model: &Model,
        states: &[BodyState],
        bodies: &[usize],
        h: f64,
        books: &Books,
    ) -> Received {
        let about = books.ledger.momentum.about;
        let (mut received, mut fields) = (Received::default(), MomentumSum::default());
        for (account, wrenches) in &self.accounts {
            let mut work = 0.0;
            for (&body, start) in bodies.iter().zip(&self.before) {
                let Some(rigid) = &model.bodies[body].rigid else { continue };
                let wrench = wrenches.of(body);
                let velocities = [start, &states[body]].map(|state| rigid.center_of_mass_velocity(state));
                work += h * mean_power(wrench.force, wrench.torque, velocities);
                if model.carries_momentum(body) {
                    let linear = wrench.force * h;
                    let angular = wrench.torque * h + (start.pose.translation - about).cross(linear);
                    fields.add(Momentum { linear, angular });
                }
            }
            received.add_work(*account, work);
        }
        for Difference { account, body, impulse } in &self.differences {
            let (Some(rigid), Ok(place)) = (&model.bodies[*body].rigid, bodies.binary_search(body)) else { continue };
            let start = &self.before[place];
            let velocities = [start, &states[*body]].map(|state| rigid.velocity(state));
            received.add_work(*account, mean_power(impulse.linear, impulse.angular, velocities));
            if model.carries_momentum(*body) {
                let arm = start.pose.translation - about;
                fields.add(Momentum { linear: impulse.linear, angular: impulse.angular + arm.cross(impulse.linear) });
            }
        }
        received.fields = fields.value();
        received
    }
}

/// Power of a force and a torque at the mean of two velocities.
fn mean_power(force: DVec3, torque: DVec3, [before, after]: [Velocity; 2]) -> f64 {
    force.dot((before.linear + after.linear) * 0.5) + torque.dot((before.angular + after.angular) * 0.5)
}

fn wrenches(model: &Model, t: f64, states: &[BodyState], of: (&[usize], &[usize])) -> Vec<(Account, Loads)> {
    let accounts = [Account::Potential, Account::Damping, Account::External];
    accounts.map(|account| (account, model.kick_wrenches_of(account, t, states, of))).to_vec()
}

fn apply(model: &Model, states: &mut [BodyState], bodies: &[usize], loads: &Loads, h: f64) {
    for &body in bodies {
        if let Some(rigid) = &model.bodies[body].rigid {
            let (state, load) = (&mut states[body], loads.of(body));
            state.linear_velocity += load.force * (h * rigid.inverse_mass());
            state.angular_momentum += load.torque * h;
        }
    }
}
