//! Keeping the ledger: every change of energy and momentum is booked where it happens.

use crate::world::World;
use crate::{Energy, Ledger, Momentum};
use polhode_dynamics::field::Account;
use polhode_dynamics::momentum::{angular_momentum_about, linear_momentum};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{CompensatedSum, DVec3};

/// What some bodies have at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balance {
    /// Total energy, J, the potential counted from the start.
    energy_j: f64,
    momentum: Momentum,
}

/// What the outside gave to some bodies over a stretch of time.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Received {
    /// By gravity.
    pub(crate) gravity: Momentum,
    /// By fixed bodies.
    pub(crate) support: Momentum,
    /// By force fields.
    pub(crate) fields: Momentum,
    /// Lost to drag and dampers, J.
    pub(crate) damping_j: f64,
    /// Work of forces from outside the scene, J.
    pub(crate) external_j: f64,
}

impl std::ops::AddAssign for Received {
    fn add_assign(&mut self, other: Self) {
        self.gravity = self.gravity + other.gravity;
        self.support = self.support + other.support;
        self.fields = self.fields + other.fields;
        self.damping_j += other.damping_j;
        self.external_j += other.external_j;
    }
}

/// The ledger of a run in progress.
#[derive(Debug, Clone)]
pub(crate) struct Books {
    pub(crate) ledger: Ledger,
    /// Potential energy at the start, J, zero at the world's origin: what reported energies contain and the ledger does
    /// not.
    pub(super) initial_potential_j: f64,
}

impl Books {
    /// Opens the books at the state given.
    pub(crate) fn open(world: &World, states: &[BodyState]) -> Self {
        let (kinetic, potential) = totals(world, states);
        let initial_j = kinetic + potential;
        let mut books = Self {
            ledger: Ledger { initial_j, current_j: initial_j, ..Ledger::default() },
            initial_potential_j: world.initial_potential(),
        };
        books.note_scale(kinetic, potential);
        let momentum = &mut books.ledger.momentum;
        momentum.about = world.initial_center_of_mass();
        momentum.initial = momentum_of(world, states, 0..states.len(), momentum.about);
        books.note_momentum(world, states);
        books
    }

    /// What the bodies named have now.
    pub(crate) fn balance(&self, world: &World, states: &[BodyState], bodies: &[usize]) -> Balance {
        Balance {
            energy_j: energy_of(world, states, bodies),
            momentum: momentum_of(world, states, bodies.iter().copied(), self.ledger.momentum.about),
        }
    }

    /// Books a smooth stage: what is not explained by what the outside gave is the integrator's.
    pub(crate) fn smooth_stage(&mut self, before: Balance, after: Balance, received: Received) {
        self.ledger.damping.add(received.damping_j);
        self.ledger.external.add(received.external_j);
        let explained = received.external_j - received.damping_j;
        self.ledger.numerical.add(before.energy_j - after.energy_j + explained);
        let momentum = &mut self.ledger.momentum;
        momentum.gravity.add(received.gravity);
        momentum.support.add(received.support);
        momentum.fields.add(received.fields);
        let explained = received.gravity + received.support + received.fields;
        momentum.numerical.add(before.momentum - after.momentum + explained);
    }

    /// Books a projection of positions or velocities.
    pub(crate) fn projection(&mut self, before: Balance, after: Balance) {
        self.ledger.projection.add(before.energy_j - after.energy_j);
        self.ledger.momentum.projection.add(before.momentum - after.momentum);
    }

    /// Books bounces that were summed up and velocities that were set to rest.
    pub(crate) fn rest(&mut self, before: Balance, after: Balance) {
        self.ledger.rest.add(before.energy_j - after.energy_j);
        self.ledger.momentum.rest.add(before.momentum - after.momentum);
    }

    /// Books an impact: the change of energy (J) by its impulses, and the impulses that fixed bodies gave.
    pub(crate) fn impact(&mut self, energy_change_j: f64, support: Momentum) {
        self.ledger.impact.add(-energy_change_j);
        self.ledger.momentum.support.add(support);
    }

    /// Books `dt` seconds of rest in certified equilibrium: the support bears the weight and the forces.
    pub(crate) fn equilibrium(&mut self, world: &World, states: &[BodyState], body: usize, dt: f64) {
        let about = self.ledger.momentum.about;
        let gravity = gravity_at(world, states, body, about, dt);
        let mut fields = Momentum::default();
        if world.has_fields() {
            // Forces on bodies that rest are the same at all times.
            let given = given_by_fields(world, 0.0, states, &[body], about).fields;
            fields = Momentum { linear: given.linear * dt, angular: given.angular * dt };
        }
        self.ledger.momentum.gravity.add(gravity);
        self.ledger.momentum.fields.add(fields);
        self.ledger.momentum.support.add(Momentum::default() - gravity - fields);
    }

    /// Takes note of energies and momenta now: the totals, and the scales that closure is relative to.
    pub(crate) fn observe(&mut self, world: &World, states: &[BodyState]) -> Energy {
        let (kinetic_j, potential) = totals(world, states);
        self.ledger.current_j = kinetic_j + potential;
        self.note_scale(kinetic_j, potential);
        self.note_momentum(world, states);
        let potential_j = self.initial_potential_j + potential;
        let initial_j = self.initial_potential_j + self.ledger.initial_j;
        Energy { initial_j, final_j: kinetic_j + potential_j, kinetic_j, potential_j }
    }

    fn note_scale(&mut self, kinetic: f64, potential: f64) {
        let scale = kinetic + potential.abs();
        // A scene that stays at rest has no energy of its own to be relative to: its potential energy serves.
        let scale = if scale == 0.0 { self.initial_potential_j.abs() } else { scale };
        self.ledger.scale_j = self.ledger.scale_j.max(scale);
    }

    fn note_momentum(&mut self, world: &World, states: &[BodyState]) {
        let ledger = &mut self.ledger.momentum;
        ledger.current = momentum_of(world, states, 0..states.len(), ledger.about);
        let given = ledger.gravity.value();
        let (mut linear, mut angular) = (0.0, 0.0);
        for (body, state) in states.iter().enumerate() {
            if let Some(rigid) = world.bodies[body].rigid.as_ref().filter(|_| world.carries_momentum(body)) {
                let momentum = linear_momentum(rigid, state).length();
                linear += momentum;
                angular +=
                    state.angular_momentum.length() + (state.pose.translation - ledger.about).length() * momentum;
            }
        }
        ledger.scale_linear = ledger.scale_linear.max(linear).max(given.linear.length());
        ledger.scale_angular = ledger.scale_angular.max(angular).max(given.angular.length());
        // Weights of bodies on both sides of the point cancel in their moment, their rounding does not.
        ledger.scale_angular = ledger.scale_angular.max(ledger.scale_linear * world.extent_about(states, ledger.about));
    }
}

/// What gravity gives to a body that stays where it is for `dt` seconds.
pub(crate) fn gravity_at(world: &World, states: &[BodyState], body: usize, about: DVec3, dt: f64) -> Momentum {
    if !world.carries_momentum(body) {
        return Momentum::default();
    }
    let mass = world.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
    let linear = world.gravity() * (mass * dt);
    Momentum { linear, angular: (states[body].pose.translation - about).cross(linear) }
}

/// What force fields give to some bodies per second: momentum (N, N m), what drag takes and the work from outside (W).
pub(crate) fn given_by_fields(world: &World, t: f64, states: &[BodyState], bodies: &[usize], about: DVec3) -> Received {
    let mut sum = crate::MomentumSum::default();
    let mut received = Received::default();
    for account in [Account::Potential, Account::Damping, Account::External] {
        let wrenches = world.wrenches_of(account, t, states);
        let mut power = 0.0;
        for &body in bodies {
            let (Some(slot), Some(rigid)) = (world.slot(body), &world.bodies[body].rigid) else { continue };
            let (wrench, state) = (wrenches[slot], &states[body]);
            let velocity = rigid.center_of_mass_velocity(state);
            power += wrench.force.dot(velocity.linear) + wrench.torque.dot(velocity.angular);
            if world.carries_momentum(body) {
                let arm = state.pose.translation - about;
                sum.add(Momentum { linear: wrench.force, angular: wrench.torque + arm.cross(wrench.force) });
            }
        }
        match account {
            Account::Potential => {}
            Account::Damping => received.damping_j = -power,
            Account::External => received.external_j = power,
        }
    }
    received.fields = sum.value();
    received
}

/// Total energy of the bodies named, and of the force fields on all, J.
fn energy_of(world: &World, states: &[BodyState], bodies: &[usize]) -> f64 {
    let sum: CompensatedSum = bodies
        .iter()
        .flat_map(|&body| {
            let (kinetic, potential) = world.energies(body, &states[body]);
            [kinetic, potential]
        })
        .chain([world.field_energy(states)])
        .collect();
    sum.value()
}

/// Momentum of the bodies named, the angular part about a point.
fn momentum_of(world: &World, states: &[BodyState], bodies: impl Iterator<Item = usize>, about: DVec3) -> Momentum {
    let mut sum = crate::MomentumSum::default();
    for body in bodies.filter(|&body| world.carries_momentum(body)) {
        if let Some(rigid) = &world.bodies[body].rigid {
            sum.add(Momentum {
                linear: linear_momentum(rigid, &states[body]),
                angular: angular_momentum_about(about, rigid, &states[body]),
            });
        }
    }
    sum.value()
}

/// Kinetic energy of the scene, and potential energy against that at the start, J.
fn totals(world: &World, states: &[BodyState]) -> (f64, f64) {
    let mut kinetic = CompensatedSum::ZERO;
    let mut potential = CompensatedSum::ZERO;
    for (index, state) in states.iter().enumerate() {
        let (t, v) = world.energies(index, state);
        kinetic.add(t);
        potential.add(v);
    }
    potential.add(world.field_energy(states));
    (kinetic.value(), potential.value())
}
