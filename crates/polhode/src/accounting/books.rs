//! The books of a run: every change of energy and momentum is entered into the ledger where it happens.

use crate::model::Model;
use crate::report::energy::Energy;
use crate::report::ledger::Ledger;
use crate::report::momentum_ledger::Momentum;
use polhode_dynamics::field::Account;
use polhode_dynamics::momentum::{angular_momentum_about, linear_momentum};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{CompensatedSum, DVec3};

/// Energy and momentum of some bodies at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balance {
    /// Total energy, J, the potential counted from the start.
    energy_j: f64,
    momentum: Momentum,
}

/// Momentum and energy that external agents gave to some bodies over an interval of time.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Received {
    /// By gravity.
    pub(crate) gravity: Momentum,
    /// By fixed and kinematic bodies.
    pub(crate) support: Momentum,
    /// By force fields.
    pub(crate) fields: Momentum,
    /// Lost to drag and dampers, J.
    pub(crate) damping_j: f64,
    /// Lost to friction, J.
    pub(crate) friction_j: f64,
    /// Work of forces from outside the scene and of prescribed motions, J.
    pub(crate) external_j: f64,
}

impl Received {
    /// Adds the work (J) of fields of an account. What fields with a potential do is in the potential energy.
    pub(crate) fn add_work(&mut self, account: Account, work_j: f64) {
        match account {
            Account::Potential => {}
            Account::Damping => self.damping_j -= work_j,
            Account::External => self.external_j += work_j,
        }
    }
}

impl std::ops::AddAssign for Received {
    fn add_assign(&mut self, other: Self) {
        self.gravity = self.gravity + other.gravity;
        self.support = self.support + other.support;
        self.fields = self.fields + other.fields;
        self.damping_j += other.damping_j;
        self.friction_j += other.friction_j;
        self.external_j += other.external_j;
    }
}

/// What the impulses of soft contacts took in a step, and what they gave.
#[derive(Debug, Clone, Copy, Default)]
#[expect(clippy::struct_field_names, reason = "all are works in joules, as every unit in a name")]
pub(crate) struct SoftStep {
    /// Taken by normal impulses of contacts that collided, J.
    pub(crate) impact_j: f64,
    /// Taken by friction, J.
    pub(crate) friction_j: f64,
    /// Taken by normal impulses of contacts at rest, which push overlaps apart, J.
    pub(crate) projection_j: f64,
    /// Given to bodies by all impulses, summed by bodies and not by contacts, J.
    pub(crate) given_j: f64,
    /// The part of the external work that prescribed motions did through contacts, J.
    pub(crate) driven_j: f64,
}

/// The ledger of a run in progress.
#[derive(Debug, Clone)]
pub(crate) struct Books {
    pub(crate) ledger: Ledger,
    /// Potential energy at the start of the run, J, zero at the world's origin. The reported energy of the start
    /// contains it, the ledger does not.
    pub(super) initial_potential_j: f64,
    /// Elastic energy of contacts at present, J: of a tier that stores some there, which states it here.
    pub(crate) contact_energy_j: f64,
}

impl Balance {
    /// Energy that is lost until a later balance, in between which prescribed motions do work (J), J.
    pub(crate) fn lost_until(self, later: Self, work_j: f64) -> f64 {
        self.energy_j - later.energy_j + work_j
    }

    /// The same with more energy (J), of what is no body and no field: springs at contacts.
    pub(crate) fn with_energy(self, more_j: f64) -> Self {
        Self { energy_j: self.energy_j + more_j, ..self }
    }
}

impl Books {
    /// Opens the books at the state given.
    pub(crate) fn open(model: &Model, states: &[BodyState]) -> Self {
        let about = model.initial_center_of_mass();
        let totals = Totals::of(model, states, about, 0.0);
        let (kinetic, potential) = (totals.kinetic.value(), totals.potential.value());
        let initial_j = kinetic + potential;
        let mut books = Self {
            ledger: Ledger { initial_j, current_j: initial_j, ..Ledger::default() },
            initial_potential_j: model.forces.start_potential(),
            contact_energy_j: 0.0,
        };
        books.note_scale(model, kinetic, potential);
        books.ledger.momentum.about = about;
        books.ledger.momentum.initial = totals.momentum.value();
        books.note_momentum(&totals);
        books
    }

    /// Empty books, moments about a point (m): for steps that may be rejected.
    pub(crate) fn blank(about: DVec3) -> Self {
        let mut books = Self { ledger: Ledger::default(), initial_potential_j: 0.0, contact_energy_j: 0.0 };
        books.ledger.momentum.about = about;
        books
    }

    /// Enters all entries of other books, as one sum for each account.
    pub(crate) fn enter(&mut self, others: &Self) {
        let (own, other) = (&mut self.ledger, &others.ledger);
        own.impact.add(other.impact.value());
        own.friction.add(other.friction.value());
        own.rest.add(other.rest.value());
        own.damping.add(other.damping.value());
        own.external.add(other.external.value());
        own.projection.add(other.projection.value());
        own.numerical.add(other.numerical.value());
        let (own, other) = (&mut own.momentum, &other.momentum);
        own.gravity.add(other.gravity.value());
        own.support.add(other.support.value());
        own.fields.add(other.fields.value());
        own.rest.add(other.rest.value());
        own.projection.add(other.projection.value());
        own.numerical.add(other.numerical.value());
    }

    /// Energy and momentum of these bodies now.
    pub(crate) fn balance(&self, model: &Model, states: &[BodyState], bodies: &[usize]) -> Balance {
        Balance {
            energy_j: energy_of(model, states, bodies),
            momentum: momentum_of(model, states, bodies.iter().copied(), self.ledger.momentum.about),
        }
    }

    /// Books a smooth motion: changes that external agents do not explain are the error of the integrator.
    pub(crate) fn smooth_stage(&mut self, before: Balance, after: Balance, received: Received) {
        self.ledger.damping.add(received.damping_j);
        self.ledger.friction.add(received.friction_j);
        self.ledger.external.add(received.external_j);
        let explained = received.external_j - received.damping_j - received.friction_j;
        self.ledger.numerical.add(before.energy_j - after.energy_j + explained);
        let momentum = &mut self.ledger.momentum;
        momentum.gravity.add(received.gravity);
        momentum.support.add(received.support);
        momentum.fields.add(received.fields);
        let explained = received.gravity + received.support + received.fields;
        momentum.numerical.add(before.momentum - after.momentum + explained);
    }

    /// Books a step of soft contacts: what their impulses took, and the change of energy that these do not explain.
    pub(crate) fn soft_step(&mut self, [before, after]: [Balance; 2], received: Received, soft: SoftStep) {
        self.ledger.impact.add(soft.impact_j);
        self.ledger.friction.add(soft.friction_j);
        self.ledger.projection.add(soft.projection_j);
        self.ledger.damping.add(received.damping_j);
        self.ledger.external.add(received.external_j);
        let of_fields = received.external_j - received.damping_j - soft.driven_j;
        self.ledger.numerical.add(before.energy_j - after.energy_j + soft.given_j + of_fields);
        let momentum = &mut self.ledger.momentum;
        momentum.gravity.add(received.gravity);
        momentum.support.add(received.support);
        momentum.fields.add(received.fields);
        let explained = received.gravity + received.support + received.fields;
        momentum.numerical.add(before.momentum - after.momentum + explained);
    }

    /// Books a projection of positions or velocities, in which prescribed motions did work (J). Returns the energy it
    /// removed, J.
    pub(crate) fn projection(&mut self, before: Balance, after: Balance, work_j: f64) -> f64 {
        let taken = before.energy_j - after.energy_j + work_j;
        self.ledger.external.add(work_j);
        self.ledger.projection.add(taken);
        self.ledger.momentum.projection.add(before.momentum - after.momentum);
        taken
    }

    /// Books the end of bounces and velocities that were set to zero, in which prescribed motions did work (J). Returns
    /// the energy that was taken, J.
    pub(crate) fn rest(&mut self, before: Balance, after: Balance, work_j: f64) -> f64 {
        let taken = before.lost_until(after, work_j);
        self.ledger.external.add(work_j);
        self.ledger.rest.add(taken);
        self.ledger.momentum.rest.add(before.momentum - after.momentum);
        taken
    }

    /// Books the part of what the end of bounces took (J) that friction took; negative where friction gives it back.
    pub(crate) fn friction_at_rest(&mut self, friction_j: f64) {
        self.ledger.rest.add(-friction_j);
        self.ledger.friction.add(friction_j);
    }

    /// Books the changes that a program made to bodies: external work and impulse.
    pub(crate) fn program(&mut self, before: Balance, after: Balance) {
        self.ledger.external.add(after.energy_j - before.energy_j);
        self.ledger.momentum.program.add(after.momentum - before.momentum);
    }

    /// Books a body that a program has added, with its energy and momentum. Its present position counts as its initial
    /// one.
    pub(crate) fn added(&mut self, model: &Model, states: &[BodyState], body: usize) {
        let own = self.balance_of(model, states, body);
        self.ledger.external.add(own.energy_j);
        self.ledger.momentum.program.add(own.momentum);
    }

    /// Books a change of the potential energy of the force fields (J), when a program adds or removes a body on which
    /// they act.
    pub(crate) fn fields_changed(&mut self, before_j: f64, after_j: f64) {
        self.ledger.external.add(after_j - before_j);
    }

    /// Books a body that a program removes, with its energy and momentum.
    pub(crate) fn removed(&mut self, model: &Model, states: &[BodyState], body: usize) {
        let own = self.balance_of(model, states, body);
        self.ledger.external.add(-own.energy_j);
        self.ledger.momentum.program.add(Momentum::default() - own.momentum);
    }

    /// Energy and momentum of one body, without the energy of fields.
    fn balance_of(&self, model: &Model, states: &[BodyState], body: usize) -> Balance {
        let (kinetic, potential) = model.energies(body, &states[body]);
        let momentum = momentum_of(model, states, [body].into_iter(), self.ledger.momentum.about);
        Balance { energy_j: kinetic + potential, momentum }
    }

    /// Books an impact: the change of energy (J) by its impulses along normals in relative velocities, the energy lost
    /// to friction (J), the impulses that fixed and kinematic bodies gave, and the work of prescribed motions (J) by
    /// them.
    ///
    /// Friction gives no energy. Contacts that share an impact are booked along the straight way from the velocities
    /// before to those afterwards, on which the impulse of a slip that reverses may seem to: what it seems to give
    /// belongs to the normal impulses that reversed the slip.
    pub(crate) fn impact(&mut self, (energy_change_j, friction_j): (f64, f64), support: Momentum, work_j: f64) {
        let taken_j = friction_j.max(0.0);
        self.ledger.impact.add(-energy_change_j - (taken_j - friction_j));
        self.ledger.friction.add(taken_j);
        self.ledger.external.add(work_j);
        self.ledger.momentum.support.add(support);
    }

    /// Books momentum that an integrator has given to bodies where no agent has.
    pub(crate) fn stray(&mut self, given: Momentum) {
        self.ledger.momentum.numerical.add(Momentum::default() - given);
    }

    /// Books `dt` seconds of rest in equilibrium: the support balances the weight and the forces.
    pub(crate) fn equilibrium(&mut self, model: &Model, states: &[BodyState], body: usize, dt: f64) {
        let about = self.ledger.momentum.about;
        let gravity = gravity_at(model, states, body, about, dt);
        let mut fields = Momentum::default();
        if model.forces.has_fields() {
            // Forces on bodies that rest are the same at all times.
            let given = given_by_fields(model, 0.0, states, &[body], about).fields;
            fields = Momentum { linear: given.linear * dt, angular: given.angular * dt };
        }
        self.ledger.momentum.gravity.add(gravity);
        self.ledger.momentum.fields.add(fields);
        self.ledger.momentum.support.add(Momentum::default() - gravity - fields);
    }

    /// The weight of bodies that rest, with its moment, N and N m.
    pub(crate) fn weight_of(
        &self,
        model: &Model,
        states: &[BodyState],
        bodies: impl Iterator<Item = usize>,
    ) -> Momentum {
        let about = self.ledger.momentum.about;
        let mut sum = crate::report::momentum_ledger::MomentumSum::default();
        bodies.for_each(|body| sum.add(gravity_at(model, states, body, about, 1.0)));
        sum.value()
    }

    /// Books `dt` seconds in which supports bear a weight (N, N m).
    pub(crate) fn borne(&mut self, weight: Momentum, dt: f64) {
        let given = Momentum { linear: weight.linear * dt, angular: weight.angular * dt };
        self.ledger.momentum.gravity.add(given);
        self.ledger.momentum.support.add(Momentum::default() - given);
    }

    /// Records energies and momenta now: the totals, and the scales for the closure of the ledger.
    pub(crate) fn observe(&mut self, model: &Model, states: &[BodyState]) -> Energy {
        let totals = Totals::of(model, states, self.ledger.momentum.about, self.contact_energy_j);
        let (kinetic_j, potential) = (totals.kinetic.value(), totals.potential.value());
        self.ledger.current_j = kinetic_j + potential;
        self.note_scale(model, kinetic_j, potential);
        self.note_momentum(&totals);
        let potential_j = model.forces.start_potential() + potential;
        let initial_j = self.initial_potential_j + self.ledger.initial_j;
        Energy { initial_j, final_j: kinetic_j + potential_j, kinetic_j, potential_j }
    }

    fn note_scale(&mut self, model: &Model, kinetic: f64, potential: f64) {
        let scale = kinetic + potential.abs();
        // In a scene at rest this scale is zero; its potential energy is used instead.
        let scale = if scale == 0.0 { model.forces.start_potential().abs() } else { scale };
        self.ledger.scale_j = self.ledger.scale_j.max(scale).max(model.joints.friction_energy_j());
    }

    fn note_momentum(&mut self, totals: &Totals) {
        let ledger = &mut self.ledger.momentum;
        ledger.current = totals.momentum.value();
        ledger.scale_linear = ledger.scale_linear.max(totals.linear);
        ledger.scale_angular = ledger.scale_angular.max(totals.angular);
        for given in [ledger.gravity.value(), ledger.fields.value()] {
            ledger.scale_linear = ledger.scale_linear.max(given.linear.length());
            ledger.scale_angular = ledger.scale_angular.max(given.angular.length());
        }
        // The moments of weights on both sides of the point cancel, but their rounding errors do not.
        ledger.scale_angular = ledger.scale_angular.max(ledger.scale_linear * totals.extent);
    }
}

/// Sums over all bodies at one time, in one pass, because the bodies of a large scene do not fit into the processor
/// caches.
#[derive(Debug, Default)]
struct Totals {
    /// J.
    kinetic: CompensatedSum,
    /// Relative to that at the start, J.
    potential: CompensatedSum,
    /// Angular part about the point.
    momentum: crate::report::momentum_ledger::MomentumSum,
    /// Magnitudes of linear (N s) and angular momentum (N m s) of all bodies added up.
    linear: f64,
    angular: f64,
    /// Largest distance of a point of a movable body from the point, m.
    extent: f64,
}

impl Totals {
    /// Of these states, with energy (J) that contacts store; angular momenta and distances are about a point (m).
    fn of(model: &Model, states: &[BodyState], about: DVec3, contact_energy_j: f64) -> Self {
        let mut totals = Self::default();
        for (index, state) in states.iter().enumerate() {
            let (kinetic, potential) = model.energies(index, state);
            totals.kinetic.add(kinetic);
            totals.potential.add(potential);
            let body = &model.bodies[index];
            let distance = (state.pose.translation - about).length();
            if body.moves() {
                totals.extent = totals.extent.max(distance + body.size);
            }
            if let Some(rigid) = body.rigid.as_ref().filter(|_| model.carries_momentum(index)) {
                let linear = linear_momentum(rigid, state);
                let angular = angular_momentum_about(about, rigid, state);
                totals.momentum.add(Momentum { linear, angular });
                let magnitude = linear.length();
                totals.linear += magnitude;
                totals.angular += state.angular_momentum.length() + distance * magnitude;
            }
        }
        totals.potential.add(model.field_energy(states));
        if contact_energy_j != 0.0 {
            totals.potential.add(contact_energy_j);
        }
        totals
    }
}

/// Momentum from gravity to a body at rest over `dt` seconds.
pub(crate) fn gravity_at(model: &Model, states: &[BodyState], body: usize, about: DVec3, dt: f64) -> Momentum {
    if !model.carries_momentum(body) {
        return Momentum::default();
    }
    let mass = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::mass);
    let linear = model.gravity() * (mass * dt);
    Momentum { linear, angular: (states[body].pose.translation - about).cross(linear) }
}

/// Rates at which force fields act on some bodies: momentum (N, N m), dissipation by drag and external work (W).
pub(crate) fn given_by_fields(model: &Model, t: f64, states: &[BodyState], bodies: &[usize], about: DVec3) -> Received {
    let mut sum = crate::report::momentum_ledger::MomentumSum::default();
    let mut received = Received::default();
    for account in [Account::Potential, Account::Damping, Account::External] {
        if !model.forces.has_fields_of(account) {
            continue;
        }
        let wrenches = model.wrenches_of(account, t, states, bodies);
        let mut power = 0.0;
        for &body in bodies {
            let Some(rigid) = &model.bodies[body].rigid else { continue };
            let (wrench, state) = (wrenches.of(body), &states[body]);
            let velocity = rigid.center_of_mass_velocity(state);
            power += wrench.force.dot(velocity.linear) + wrench.torque.dot(velocity.angular);
            if model.carries_momentum(body) {
                let arm = state.pose.translation - about;
                sum.add(Momentum { linear: wrench.force, angular: wrench.torque + arm.cross(wrench.force) });
            }
        }
        received.add_work(account, power);
    }
    received.fields = sum.value();
    received
}

/// Total energy of these bodies, and of the force fields on all bodies, J.
fn energy_of(model: &Model, states: &[BodyState], bodies: &[usize]) -> f64 {
    let sum: CompensatedSum = bodies
        .iter()
        .flat_map(|&body| {
            let (kinetic, potential) = model.energies(body, &states[body]);
            [kinetic, potential]
        })
        .chain([model.field_energy(states)])
        .collect();
    sum.value()
}

/// Momentum of these bodies, the angular part about a point.
pub(crate) fn momentum_of(
    model: &Model,
    states: &[BodyState],
    bodies: impl Iterator<Item = usize>,
    about: DVec3,
) -> Momentum {
    let mut sum = crate::report::momentum_ledger::MomentumSum::default();
    for body in bodies.filter(|&body| model.carries_momentum(body)) {
        if let Some(rigid) = &model.bodies[body].rigid {
            sum.add(Momentum {
                linear: linear_momentum(rigid, &states[body]),
                angular: angular_momentum_about(about, rigid, &states[body]),
            });
        }
    }
    sum.value()
}
