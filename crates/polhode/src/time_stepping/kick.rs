//! Force fields as one kick: the wrenches in the middle of the step, over its whole length.
//!
//! Springs that are stiff in the step, and drag and dampers, act by `implicit_kick.rs`. Other fields that depend on
//! velocities are evaluated twice, at the velocity before the kick and at that with half the kick, so that the kick is of
//! order 2. Its energy is exact: at one pose the kinetic energy is quadratic in the
//! momenta, so that a wrench (F, T) over h does the work `h (F.v + T.w)` at the mean of the velocities before and
//! after.

use super::implicit_kick::{Difference, ImplicitKick, Twist, change_velocities};
use crate::accounting::books::{Books, Received};
use crate::states_of::{set_states, states_of};
use crate::world::{Loads, World};
use crate::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Account, Dependence, Wrench};
use polhode_spatial::{DVec3, Velocity};

/// A kick that was given.
#[derive(Debug, Default)]
pub(super) struct Kick {
    /// Momentum and energy from the fields, moments about the point of the books.
    pub(super) received: Received,
    /// How the forces with a potential have changed the velocities of the bodies; empty where no field acts.
    pub(super) stored: Vec<Twist>,
    /// The forces at joints that were part of it, by number; the others are soft rows.
    pub(super) of_joints: Vec<usize>,
}

/// Kicks `bodies` by the fields at `t`, the middle of a step of `h` (s).
pub(super) fn kick(world: &World, states: &mut [BodyState], bodies: &[usize], t: f64, h: f64, books: &Books) -> Kick {
    if !bodies.iter().any(|&body| world.is_loaded(body)) {
        return Kick::default();
    }
    let before = states_of(states, bodies);
    let of_joints = world.kicks_of_joints(states, bodies);
    let kicks = &of_joints[..];
    let responses = world.responses_on(states, bodies, kicks);
    if responses.are_known
        && let Some(kick) = ImplicitKick::new(world, states, bodies, responses.of_fields, h)
    {
        let loads = world.kick_loads_on(t, states, bodies, kicks);
        let accounts = wrenches(world, t, states, (bodies, kicks));
        let forces = |&body: &usize| Twist { linear: loads.of(body).force * h, angular: loads.of(body).torque * h };
        let changes = kick.solve(&bodies.iter().map(forces).collect::<Vec<_>>());
        let differences = kick.differences(&changes);
        change_velocities(world, states, bodies, &changes);
        let mut given = received(world, states, bodies, &before, &accounts, h, books);
        add_differences(world, (states, bodies, &before), &differences, books, &mut given);
        let stored = stored(world, states, bodies, &accounts, &differences, h);
        return Kick { received: given, stored, of_joints };
    }
    let mut accounts = None;
    if world.free_motion().dependence() == Dependence::Velocities {
        push(world, states, (bodies, kicks), t, 0.5 * h);
        let loads = world.kick_loads_on(t, states, bodies, kicks);
        accounts = Some(wrenches(world, t, states, (bodies, kicks)));
        set_states(states, bodies, &before);
        apply(world, states, bodies, &loads, h);
    } else {
        push(world, states, (bodies, kicks), t, h);
    }
    let accounts = accounts.unwrap_or_else(|| wrenches(world, t, states, (bodies, kicks)));
    let stored = stored(world, states, bodies, &accounts, &[], h);
    Kick { received: received(world, states, bodies, &before, &accounts, h, books), stored, of_joints }
}

/// How the forces with a potential, weights of bodies on pivots among them, change the velocities of bodies over `h`, with
/// the impulses by which an implicit kick differs from that of constant forces.
fn stored(
    world: &World,
    states: &[BodyState],
    bodies: &[usize],
    accounts: &[(Account, Loads)],
    differences: &[Difference],
    h: f64,
) -> Vec<Twist> {
    let change = |&body: &usize| {
        let mut impulse = Twist::default();
        for (_, wrenches) in accounts.iter().filter(|(account, _)| *account == Account::Potential) {
            impulse.linear += wrenches.of(body).force * h;
            impulse.angular += wrenches.of(body).torque * h;
        }
        for own in differences.iter().filter(|own| own.account == Account::Potential && own.body == body) {
            impulse.linear += own.impulse.linear;
            impulse.angular += own.impulse.angular;
        }
        let Some(rigid) = &world.bodies[body].rigid else { return Twist::default() };
        // Forces on a body on a pivot turn it about that, its weight included, which is no field.
        let mut swing = Wrench { force: impulse.linear / h, torque: DVec3::ZERO };
        world.free_motion().add_swing(rigid, &states[body], &mut swing);
        impulse.angular += swing.torque * h;
        let inverse_inertia = rigid.inverse_inertia_world(states[body].pose.rotation);
        Twist { linear: impulse.linear * rigid.inverse_mass(), angular: inverse_inertia * impulse.angular }
    };
    bodies.iter().map(change).collect()
}

fn wrenches(world: &World, t: f64, states: &[BodyState], of: (&[usize], &[usize])) -> [(Account, Loads); 3] {
    [Account::Potential, Account::Damping, Account::External]
        .map(|account| (account, world.kick_wrenches_of(account, t, states, of)))
}

fn push(world: &World, states: &mut [BodyState], (bodies, kicks): (&[usize], &[usize]), t: f64, h: f64) {
    let loads = world.kick_loads_on(t, states, bodies, kicks);
    apply(world, states, bodies, &loads, h);
}

fn apply(world: &World, states: &mut [BodyState], bodies: &[usize], loads: &Loads, h: f64) {
    for &body in bodies {
        if let Some(rigid) = &world.bodies[body].rigid {
            let (state, load) = (&mut states[body], loads.of(body));
            state.linear_velocity += load.force * (h * rigid.inverse_mass());
            state.angular_momentum += load.torque * h;
        }
    }
}

/// Adds momentum and work of the impulses by which an implicit kick differs from that of constant forces.
fn add_differences(
    world: &World,
    (states, bodies, before): (&[BodyState], &[usize], &[BodyState]),
    differences: &[Difference],
    books: &Books,
    received: &mut Received,
) {
    let mut fields = MomentumSum::default();
    for Difference { account, body, impulse } in differences {
        let (Some(rigid), Ok(place)) = (&world.bodies[*body].rigid, bodies.binary_search(body)) else { continue };
        let (start, end) = (&before[place], &states[*body]);
        let mean = |a: DVec3, b: DVec3| (a + b) * 0.5;
        let (from, to) = (rigid.velocity(start), rigid.velocity(end));
        let work =
            impulse.linear.dot(mean(from.linear, to.linear)) + impulse.angular.dot(mean(from.angular, to.angular));
        match account {
            Account::Potential => {}
            Account::Damping => received.damping_j -= work,
            Account::External => received.external_j += work,
        }
        if world.carries_momentum(*body) {
            let arm = start.pose.translation - books.ledger.momentum.about;
            fields.add(Momentum { linear: impulse.linear, angular: impulse.angular + arm.cross(impulse.linear) });
        }
    }
    received.fields = received.fields + fields.value();
}

/// Momentum and work of the wrenches of each account (torques about the centres of mass) over `h`.
fn received(
    world: &World,
    states: &[BodyState],
    bodies: &[usize],
    before: &[BodyState],
    accounts: &[(Account, Loads)],
    h: f64,
    books: &Books,
) -> Received {
    let about = books.ledger.momentum.about;
    let (mut received, mut fields) = (Received::default(), MomentumSum::default());
    for (account, wrenches) in accounts {
        let mut work = 0.0;
        for (&body, start) in bodies.iter().zip(before) {
            let Some(rigid) = &world.bodies[body].rigid else { continue };
            let wrench = wrenches.of(body);
            let ends = [start, &states[body]].map(|state| rigid.center_of_mass_velocity(state));
            let mean =
                Velocity::new((ends[0].linear + ends[1].linear) * 0.5, (ends[0].angular + ends[1].angular) * 0.5);
            work += h * (wrench.force.dot(mean.linear) + wrench.torque.dot(mean.angular));
            if world.carries_momentum(body) {
                let linear = wrench.force * h;
                let angular = wrench.torque * h + (start.pose.translation - about).cross(linear);
                fields.add(Momentum { linear, angular });
            }
        }
        match account {
            Account::Potential => {}
            Account::Damping => received.damping_j -= work,
            Account::External => received.external_j += work,
        }
    }
    received.fields = fields.value();
    received
}
