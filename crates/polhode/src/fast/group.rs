//! A group of islands and its step: what one task computes.
//!
//! Groups are filled with whole islands until they have [`FULL`] patches and joints, whatever the number of threads, so
//! that sums have one order.

use super::held::{Held, HeldJoint, HeldLimit};
use super::rules::Rules;
use super::turning::turn;
use crate::collision::face_patches::PairPatches;
use crate::model::prescribed_state::{state_at, velocity_of};
use crate::model::{Loads, Model, prescribed};
use crate::report::momentum_ledger::Momentum;
use polhode_contact::tangent_basis;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::sequential_impulses::{
    ImpulseBody, ImpulseManifold, MOST_POINTS, ManifoldPoint, PointImpulse, Residual, SequentialImpulses, SweepOrder,
    SweepStage, Works,
};
use polhode_spatial::{DMat3, DVec3, Velocity};

/// Patches and joints of a group that takes no further island: work for a task that is worth its start.
pub(super) const FULL: usize = 256;

/// A movable body in the step of its group.
#[derive(Debug, Clone, Copy)]
struct Member {
    body: usize,
    state: BodyState,
    /// Angular velocity, rad/s.
    angular: DVec3,
    /// Inertia at the start of the step, world, kg m^2: that of the rows.
    inertia: DMat3,
    /// Where its centre of mass was, m, and how far it has turned, rad.
    start: DVec3,
    turned: DVec3,
    /// Velocity that gravity gives in a substep, m/s.
    kick: DVec3,
    /// Velocities before the kick of the substep.
    before: Velocity,
    /// What impulses have changed in the substep: velocity (m/s), angular velocity (rad/s).
    changed: Velocity,
    /// Energy that impulses gave, J.
    given_j: f64,
}

impl Member {
    /// Takes the velocity that impulses have left.
    fn take_velocity(&mut self, body: &ImpulseBody) {
        let (linear, angular) = (body.linear(), body.angular());
        let turned = angular - self.angular;
        self.changed.linear += linear - self.state.linear_velocity;
        self.changed.angular += turned;
        self.state.angular_momentum += self.inertia * turned;
        self.state.linear_velocity = linear;
        self.angular = angular;
    }
}

/// A kinematic body of a patch. Where the patch is on it moves with the other body: a load that a turntable carries, or
/// that slides over it, is at another place after
/// each substep. The velocity that the solver has is that of the surface there and then, along the rows of the start of
/// the step.
#[derive(Debug, Clone, Copy)]
struct Driver {
    number: u32,
    body: usize,
    /// The member that it touches, and the number of the patch.
    member: usize,
    patch: usize,
    /// 1 where it is body A of the patch, -1 where it is B.
    sign: f64,
    /// From its centre to the patch at the start of the step, m.
    arm: DVec3,
    /// Velocity of its surface in the present substep, as the rows have it.
    velocity: Velocity,
    /// Impulses of its points that have been booked, N s.
    booked: [[f64; 3]; MOST_POINTS],
}

/// A patch of a pair, by their places.
#[derive(Debug, Clone, Copy)]
pub(super) struct PatchPlace {
    pub(super) pair: usize,
    pub(super) patch: usize,
}

/// A group: its input, its buffers, and what its step gives.
#[derive(Debug, Default)]
pub(super) struct Group {
    /// Bodies, and patches between them.
    pub(super) bodies: Vec<usize>,
    pub(super) patches: Vec<PatchPlace>,
    members: Vec<Member>,
    /// Kinematic bodies, each patch with one for itself.
    drivers: Vec<Driver>,
    /// States within the step, where forces depend on them.
    present: Vec<BodyState>,
    pub(super) solver: SequentialImpulses,
    pub(super) held: Held,
    pub(super) report: GroupReport,
}

/// What the step of a group did.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct GroupReport {
    /// By impulses of contacts, summed by contacts.
    pub(super) works: Works,
    /// The same as `works`, summed by bodies, J.
    pub(super) given_j: f64,
    pub(super) residual: Residual,
    /// Momentum from the world through joints, about its origin.
    pub(super) support: Momentum,
    /// Energy that kinematic bodies gave through contacts, J.
    pub(super) driven_j: f64,
    /// The pair that overlaps most at the start, by its place, and how deep, m.
    pub(super) deepest: Option<(usize, f64)>,
}

/// What a group reads.
#[derive(Debug, Clone, Copy)]
pub(super) struct Given<'a> {
    pub(super) model: &'a Model,
    pub(super) states: &'a [BodyState],
    pub(super) pairs: &'a [PairPatches],
    /// Number of each body in the solver of its group.
    pub(super) numbers: &'a [u32],
    /// Joints after the last step, and limits that pressed, ascending.
    pub(super) held: (&'a [HeldJoint], &'a [HeldLimit]),
    /// Start of the step, s.
    pub(super) t: f64,
    /// Factor on impulses of the last step: its length over that of the substeps now (no unit).
    pub(super) warm: f64,
    pub(super) rules: &'a Rules,
}

impl Group {
    /// Empties it.
    pub(super) fn clear(&mut self) {
        self.bodies.clear();
        self.patches.clear();
    }

    /// The step.
    pub(super) fn step(&mut self, given: &Given<'_>) {
        self.report = GroupReport::default();
        self.load(given);
        self.solver.prepare();
        let rules = given.rules;
        if rules.has_loads {
            given.states.clone_into(&mut self.present);
        }
        self.find_rows(given);
        for substep in 0..rules.substeps {
            self.kick(given, f64::from(substep) * rules.h);
            let stage = if substep == 0 { SweepStage::First } else { SweepStage::Next };
            if substep == 0 {
                self.solver.warm_start();
                self.held.start(&mut self.solver, given.held, given.warm);
            } else {
                self.held.start_again(&mut self.solver);
            }
            self.drive(given, substep);
            let [pushed, relaxed] = rules.orders(substep);
            let booked = self.sweep_softly(stage, pushed, rules);
            self.report.works += booked;
            self.move_bodies(given.model, rules.h);
            self.move_drivers(given, substep);
            self.find_rows(given);
            self.relax(relaxed, rules);
            self.book();
            self.book_drivers();
            self.report.works.resting_j += self.held.end_substep(&self.solver, &self.present);
        }
        self.report.works += self.solver.end_substep(&rules.soft);
        self.report.residual = self.solver.residual(&rules.relax);
        self.begin();
        self.report.works += if self.held.is_empty() {
            self.solver.restitute(&rules.soft)
        } else {
            self.held.bounce(&mut self.solver, [&rules.soft, &rules.relax], &self.present)
        };
        self.book_drivers_at_end();
        self.book();
        self.report.support = self.held.support();
        self.report.given_j = self.members.iter().map(|member| member.given_j).sum();
    }

    /// How many joints were solved in the step, each as often as it was.
    pub(super) fn joints_solved(&self) -> usize {
        self.held.solved()
    }

    /// Joints and contacts in turns, while both are pushed softly to where they hold. What a contact gives a body its
    /// joints pass on, and what they then do at the contact it corrects: after one turn a limb that hits the ground
    /// would open its joint by as far as it flies in a substep.
    fn sweep_softly(&mut self, stage: SweepStage, order: SweepOrder, rules: &Rules) -> Works {
        self.held.sweep(&mut self.solver, &rules.soft_joints);
        let booked = self.solver.sweep(stage, order, &rules.soft);
        if !self.held.is_empty() {
            self.held.sweep(&mut self.solver, &rules.soft_joints);
            self.solver.sweep(SweepStage::First, order, &rules.soft);
        }
        booked
    }

    /// The same without the push, after a movement.
    fn relax(&mut self, order: SweepOrder, rules: &Rules) {
        self.held.sweep(&mut self.solver, &rules.relax);
        self.solver.sweep_conjugate(rules.relax_sweeps, order, &rules.relax);
        if !self.held.is_empty() {
            self.held.sweep(&mut self.solver, &rules.relax);
            self.solver.sweep(SweepStage::First, order, &rules.relax);
        }
    }

    /// The rows of joints where the bodies are now.
    fn find_rows(&mut self, given: &Given<'_>) {
        if given.model.joints.has_rows() {
            self.members.iter().for_each(|member| self.present[member.body] = member.state);
            self.held.find_rows(given.model, &self.solver, &self.present);
        }
    }

    /// What impulses change is counted from here.
    fn begin(&mut self) {
        for member in &mut self.members {
            member.before = Velocity::new(member.state.linear_velocity, member.angular);
            member.changed = Velocity::default();
        }
    }

    /// Takes the velocities that impulses have left, and books by bodies what the impulses of the substep did along the
    /// mean of the velocities before the kick and now.
    fn book(&mut self) {
        for (number, member) in (1..).zip(&mut self.members) {
            member.take_velocity(self.solver.body(number));
            let linear = (member.before.linear + member.state.linear_velocity) * 0.5;
            let angular = (member.before.angular + member.angular) * 0.5;
            member.given_j += angular.dot(member.inertia * member.changed.angular);
            let body = self.solver.body_mut(number);
            body.set_mean_velocity(linear, angular);
            // Of a body on a pivot only the rotation takes impulses.
            if member.changed.linear != DVec3::ZERO {
                member.given_j += linear.dot(member.changed.linear) / body.inverse_mass();
            }
        }
    }

    /// States at the end of the step.
    pub(super) fn states(&self) -> impl Iterator<Item = (usize, &BodyState)> {
        self.members.iter().map(|member| (member.body, &member.state))
    }

    fn load(&mut self, given: &Given<'_>) {
        let Given { model, states, .. } = given;
        self.solver.clear();
        self.members.clear();
        self.drivers.clear();
        for place in 0..self.bodies.len() {
            let body = self.bodies[place];
            let Some(rigid) = &model.bodies[body].rigid else { continue };
            self.add_member(rigid, body, &states[body], model.free_acceleration(body) * given.rules.h);
        }
        self.held.load((model, &self.solver), (states, &self.bodies), given.numbers);
        // Kinematic bodies follow: each patch with one has it for itself.
        for number in 0..self.patches.len() {
            let place = self.patches[number];
            let pair = &given.pairs[place.pair];
            let (state_a, state_b) = (&states[pair.a], &states[pair.b]);
            let numbers = [pair.a, pair.b].map(|body| self.number(given, body));
            let is_driven = [pair.a, pair.b].iter().any(|&body| prescribed::trajectory(model, body).is_some());
            let normal = pair.normal(states, &pair.patches[place.patch]);
            let tangent = tangent_basis(normal)[0];
            let second = normal.cross(tangent);
            let mut points = [ManifoldPoint::default(); MOST_POINTS];
            let mut count = 0;
            for (row, point) in points.iter_mut().zip(pair.patches[place.patch].points()) {
                let (on_a, on_b) = (state_a.pose.rotation.rotate(point.on_a), state_b.pose.rotation.rotate(point.on_b));
                let apart = (state_a.pose.translation - state_b.pose.translation) + (on_a - on_b);
                let depth = -normal.dot(apart);
                if depth > self.report.deepest.map_or(0.0, |(_, known)| known) {
                    self.report.deepest = Some((place.pair, depth));
                }
                let friction = point.friction_impulse * given.warm;
                *row = ManifoldPoint {
                    arm: on_a - apart * pair.acting_part(model, -depth),
                    separation: normal.dot(apart),
                    impulse: [point.normal_impulse * given.warm, friction.dot(tangent), friction.dot(second)],
                };
                count += 1;
            }
            if is_driven {
                let middle = points[..count].iter().map(|point| point.arm).sum::<DVec3>() / count.max(1) as f64;
                self.note_driver(given, (pair, number), numbers, state_a.pose.translation + middle);
            }
            self.solver.add(ImpulseManifold {
                bodies: numbers,
                normal,
                tangent,
                between: state_a.pose.translation - state_b.pose.translation,
                friction: pair.friction,
                restitution: pair.restitution,
                points,
                count,
            });
        }
    }

    /// The number of a body in the solver: movable ones have it already, kinematic ones get one, others never move.
    fn number(&mut self, given: &Given<'_>, body: usize) -> u32 {
        let model = given.model;
        if model.bodies[body].moves() {
            return given.numbers[body];
        }
        let Velocity { linear, angular } = model.velocity(body, &given.states[body]);
        if prescribed::trajectory(model, body).is_none() {
            return SequentialImpulses::IMMOVABLE;
        }
        let number = self.solver.add_body(ImpulseBody::immovable());
        self.solver.body_mut(number).set_velocity(linear, angular);
        number
    }

    /// Notes the kinematic body of the last patch, if there is one. `center` is the middle of its points (m).
    fn note_driver(
        &mut self,
        given: &Given<'_>,
        (pair, patch): (&PairPatches, usize),
        numbers: [u32; 2],
        center: DVec3,
    ) {
        let sides = [(pair.a, 0, 1.0), (pair.b, 1, -1.0)];
        for (body, side, sign) in sides {
            if prescribed::trajectory(given.model, body).is_none() || numbers[side] == SequentialImpulses::IMMOVABLE {
                continue;
            }
            self.drivers.push(Driver {
                number: numbers[side],
                body,
                member: (numbers[1 - side] as usize).saturating_sub(1),
                patch,
                sign,
                arm: center - given.states[body].pose.translation,
                velocity: Velocity::default(),
                booked: [[0.0; 3]; MOST_POINTS],
            });
        }
    }

    /// The velocities of kinematic bodies over the coming substep: those of its middle, where the patches then are.
    fn drive(&mut self, given: &Given<'_>, substep: u32) {
        let h = given.rules.h;
        for place in 0..self.drivers.len() {
            let driver = self.drivers[place];
            let velocity = self.surface_velocity(given, &driver, ((f64::from(substep) + 0.5) * h, 0.5 * h));
            self.drivers[place].velocity = velocity;
            let body = self.solver.body_mut(driver.number);
            body.set_velocity(velocity.linear, velocity.angular);
        }
    }

    /// The velocity of the surface of a kinematic body `time` (s) after the start of the step, where the patch is when
    /// the other body has moved on for `ahead` (s).
    fn surface_velocity(&self, given: &Given<'_>, driver: &Driver, (time, ahead): (f64, f64)) -> Velocity {
        let Some(trajectory) = prescribed::trajectory(given.model, driver.body) else { return Velocity::default() };
        let (now, start) = (state_at(trajectory, given.t + time), &given.states[driver.body]);
        let Velocity { linear, angular } = velocity_of(&now);
        let of_patch = self.members.get(driver.member).map_or(DVec3::ZERO, |member| {
            member.state.pose.translation + member.state.linear_velocity * ahead - member.start
        });
        let moved = of_patch - (now.pose.translation - start.pose.translation);
        Velocity::new(linear + angular.cross(moved), angular)
    }

    /// Kinematic bodies after a movement: how far they have come. The rows have
    /// a turn to first order: the rest of it at the patch is
    /// a displacement. Their velocities stay those of the substep: with another one contacts would take or give in the
    /// relax stage what a surface is accelerated by, after friction has been bounded by the impulses of before.
    fn move_drivers(&mut self, given: &Given<'_>, substep: u32) {
        let time = f64::from(substep + 1) * given.rules.h;
        for place in 0..self.drivers.len() {
            let driver = self.drivers[place];
            let Some(trajectory) = prescribed::trajectory(given.model, driver.body) else { continue };
            let (now, start) = (state_at(trajectory, given.t + time).pose, given.states[driver.body].pose);
            let turn = now.rotation * start.rotation.inverse();
            let vector = turn.to_rotation_vector();
            let rest = turn.rotate(driver.arm) - driver.arm - vector.cross(driver.arm);
            let body = self.solver.body_mut(driver.number);
            body.set_displacement(now.translation - start.translation + rest, vector);
            body.set_velocity(driver.velocity.linear, driver.velocity.angular);
        }
    }

    /// Books what kinematic bodies gave through the impulses of a substep.
    fn book_drivers(&mut self) {
        for place in 0..self.drivers.len() {
            let Driver { number, patch, velocity, .. } = self.drivers[place];
            self.solver.body_mut(number).set_mean_velocity(velocity.linear, velocity.angular);
            let mut sums = [[0.0; 3]; MOST_POINTS];
            for (sum, point) in sums.iter_mut().zip(self.solver.impulses(patch)) {
                *sum = point.last;
            }
            let given_j = self.driven(place, velocity, |_, point| point.last);
            let driver = &mut self.drivers[place];
            driver.booked.as_flattened_mut().iter_mut().zip(sums.as_flattened()).for_each(|(known, sum)| *known += sum);
            self.report.driven_j += given_j;
        }
    }

    /// The same of the restitution after the last substep, at the velocities of then.
    fn book_drivers_at_end(&mut self) {
        for place in 0..self.drivers.len() {
            let Driver { number, booked, .. } = self.drivers[place];
            let body = self.solver.body(number);
            let velocity = Velocity::new(body.linear(), body.angular());
            let given_j =
                self.driven(place, velocity, |k, point| std::array::from_fn(|i| point.total[i] - booked[k][i]));
            self.report.driven_j += given_j;
        }
    }

    /// The energy that a kinematic body gives by these impulses at the points of its patch, with this velocity.
    fn driven(&self, place: usize, velocity: Velocity, of: impl Fn(usize, &PointImpulse) -> [f64; 3]) -> f64 {
        let Driver { patch, sign, .. } = self.drivers[place];
        let Some(manifold) = self.solver.manifolds().get(patch) else { return 0.0 };
        let second = manifold.normal.cross(manifold.tangent);
        let points = self.solver.impulses(patch).zip(&manifold.points).enumerate();
        let given = points.map(|(k, (point, own))| {
            let [along, x, y] = of(k, &point);
            let arm = if sign > 0.0 { own.arm } else { own.arm + manifold.between };
            let impulse = manifold.normal * along + manifold.tangent * x + second * y;
            -sign * impulse.dot(velocity.linear + velocity.angular.cross(arm))
        });
        given.sum()
    }

    fn add_member(&mut self, rigid: &RigidBody, body: usize, state: &BodyState, kick: DVec3) {
        let turn = state.pose.rotation.to_matrix();
        let inverse = rigid.inverse_inertia_world(state.pose.rotation);
        let number = self.solver.add_body(ImpulseBody::new(rigid.inverse_mass(), inverse));
        let angular = rigid.angular_velocity(state);
        self.solver.body_mut(number).set_velocity(state.linear_velocity, angular);
        self.members.push(Member {
            body,
            state: *state,
            angular,
            inertia: turn * rigid.inertia() * turn.transpose(),
            start: state.pose.translation,
            turned: DVec3::ZERO,
            kick,
            before: Velocity::default(),
            changed: Velocity::default(),
            given_j: 0.0,
        });
    }

    /// Gravity and other forces act on the velocities, `time` (s) after the start of the step.
    fn kick(&mut self, given: &Given<'_>, time: f64) {
        let (model, h) = (given.model, given.rules.h);
        let mut loads = Loads::default();
        if given.rules.has_loads {
            self.members.iter().for_each(|member| self.present[member.body] = member.state);
            loads = model.loads_on(given.t + time, &self.present, &self.bodies);
        }
        for (number, member) in (1..).zip(&mut self.members) {
            member.before = Velocity::new(member.state.linear_velocity, member.angular);
            member.state.linear_velocity += member.kick;
            if let Some(rigid) = model.bodies[member.body].rigid.as_ref().filter(|_| given.rules.has_loads) {
                let wrench = loads.of(member.body);
                member.state.linear_velocity += wrench.force * (rigid.inverse_mass() * h);
                member.state.angular_momentum += wrench.torque * h;
                let (turn, momentum) = (member.state.pose.rotation, member.state.angular_momentum);
                member.angular = rigid.angular_velocity_at(turn, momentum);
            }
            // The impulses of the substep before act again: by as much as they changed the velocities then.
            let warm = std::mem::take(&mut member.changed);
            let (linear, angular) = (member.state.linear_velocity + warm.linear, member.angular + warm.angular);
            self.solver.body_mut(number).set_velocity(linear, angular);
        }
    }

    /// Takes the velocities that impulses have left, and moves the bodies with them.
    fn move_bodies(&mut self, model: &Model, h: f64) {
        for (number, member) in (1..).zip(&mut self.members) {
            let Some(rigid) = &model.bodies[member.body].rigid else { continue };
            member.take_velocity(self.solver.body(number));
            let pose = &mut member.state.pose;
            pose.translation += member.state.linear_velocity * h;
            let of_turn = (member.state.angular_momentum, member.angular);
            let turned = turn(rigid, pose.rotation, of_turn, h);
            pose.rotation = turned.rotation;
            member.angular = turned.angular;
            member.turned += turned.turn;
            let body = self.solver.body_mut(number);
            body.set_velocity(member.state.linear_velocity, member.angular);
            body.set_displacement(pose.translation - member.start, member.turned);
        }
    }
}
