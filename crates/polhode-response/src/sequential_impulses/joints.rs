//! Joints among sequential impulses: what holds two bodies by rows of either sign, and limits that push.
//!
//! The rows of a joint (up to six) are solved together, by the factors of their own matrix; joints one after the other. With the rates `u = J v` of its
//! rows (m/s), their gaps `g` (m), and the softness `a`, `b`, `c` of a sweep ([`SweepRule::with_fixed`]),
//!
//! ```text
//! l <- l - a K^-1 (u + b g) - c l       K = J M^-1 J^T (1/kg), l impulses (N s); b g cut to the largest push
//! a limit: l <- max(0, ...), and where it is apart by s > 0: a = 1, b s = s / h, c = 0
//! ```
//!
//! Rows may be given anew whenever the bodies have moved. What the joint has given its bodies in a substep is summed as it was given, and its work is
//! that along the mean velocities. At the start of the next substep its multipliers act again, along the present rows: the impulses of before, along
//! rows of before, would drive a body that turns about the joint. A joint is a handful of rows: it is
//! solved by itself and not in lanes, so that its bits depend on neither lanes nor threads. Sweeps go forth and back in turn, which carries a load
//! along a chain both ways. Sources: Catto 2005, Catto 2024 (soft constraints), Golub and Van Loan 4.1 (the factors), docs/REFERENCES.md.
//!
//! Failure: rows that depend on each other within one joint are left out, one of them; joints that contradict each other share the error.

use super::SequentialImpulses;
use super::sweep::{Softness, SweepRule};
use polhode_spatial::DVec3;

/// Most rows of a joint: it holds all relative motion.
pub const MOST_JOINT_ROWS: usize = 6;

/// A pivot below this part of the diagonal is rounding: its row depends on those before it (no unit, 1e-14 to 1e-8).
const DEPENDENT: f64 = 1e-12;

/// How often a sweep goes over all joints: a load comes along a chain by so many joints more.
const ROUNDS: usize = 4;

/// A row: what a unit of its multiplier does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointRow {
    /// Forces on A and B (no unit).
    pub forces: [DVec3; 2],
    /// Moments about the centres of mass of A and B, m.
    pub moments: [DVec3; 2],
    /// What the row keeps at zero, m; of a limit what is left of the way.
    pub gap: f64,
}

/// What the multipliers of a joint may be.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum JointLaw {
    /// Of either sign: gaps stay zero.
    #[default]
    Hold,
    /// A limit, with one row: not negative.
    Limit,
}

/// A joint in given poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpulseJoint {
    /// Numbers of its bodies in the solver.
    pub bodies: [u32; 2],
    /// Its law.
    pub law: JointLaw,
    /// Its rows.
    pub rows: [JointRow; MOST_JOINT_ROWS],
    /// How many of them there are.
    pub count: usize,
}

/// An impulse on a body: force part (N s), and moment about its centre of mass (N m s).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyImpulse {
    /// N s.
    pub linear: DVec3,
    /// N m s.
    pub angular: DVec3,
}

/// Joints of a step.
#[derive(Debug, Clone, Default)]
pub struct JointImpulses {
    joints: Vec<Solved>,
}

/// A joint with its factors and what it has given.
#[derive(Debug, Clone)]
struct Solved {
    joint: ImpulseJoint,
    /// Of each row: change of the velocities of A and B by a unit.
    effects: [[(DVec3, DVec3); 2]; MOST_JOINT_ROWS],
    /// `K = L D L^T`: `L` below the diagonal, on it the inverse of `D`, zero of a row that depends on others.
    factors: [[f64; MOST_JOINT_ROWS]; MOST_JOINT_ROWS],
    multipliers: [f64; MOST_JOINT_ROWS],
    /// In the present substep.
    given: [BodyImpulse; 2],
    total: [BodyImpulse; 2],
}

impl JointImpulses {
    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// Removes all.
    pub fn clear(&mut self) {
        self.joints.clear();
    }

    /// Gives the joint of a number its rows in the present poses; the next number adds one.
    pub fn set(&mut self, solver: &SequentialImpulses, number: usize, mut joint: ImpulseJoint) {
        joint.count = joint.count.min(MOST_JOINT_ROWS);
        if let Some(known) = self.joints.get_mut(number) {
            known.take(solver, &joint);
            return;
        }
        let zero = [0.0; MOST_JOINT_ROWS];
        let mut new = Solved {
            joint,
            effects: [[(DVec3::ZERO, DVec3::ZERO); 2]; MOST_JOINT_ROWS],
            factors: [zero; MOST_JOINT_ROWS],
            multipliers: zero,
            given: Default::default(),
            total: Default::default(),
        };
        new.take(solver, &joint);
        self.joints.push(new);
    }

    /// Gives the impulses that are known at the start of a step.
    pub fn start(&mut self, solver: &mut SequentialImpulses, number: usize, multipliers: [f64; MOST_JOINT_ROWS]) {
        if let Some(own) = self.joints.get_mut(number) {
            own.multipliers = multipliers;
            own.give(solver, multipliers);
        }
    }

    /// Takes back what the joints gave in the substep before, which has acted on the velocities again, and gives their multipliers along the present
    /// rows.
    pub fn start_again(&mut self, solver: &mut SequentialImpulses) {
        for own in &mut self.joints {
            for (side, given) in std::mem::take(&mut own.given).into_iter().enumerate() {
                let body = solver.body_mut(own.joint.bodies[side]);
                let linear = body.linear() - given.linear * body.inverse_mass();
                let angular = body.angular() - body.inverse_inertia() * given.angular;
                body.set_velocity(linear, angular);
            }
            own.give(solver, own.multipliers);
        }
    }

    /// Brings all joints to their laws, some rounds forth and back.
    pub fn sweep(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) {
        for _ in 0..ROUNDS / 2 {
            self.joints.iter_mut().for_each(|own| own.solve(solver, rule));
            self.joints.iter_mut().rev().for_each(|own| own.solve(solver, rule));
        }
    }

    /// Ends a substep. Returns their work along the mean velocities of the bodies, J.
    pub fn end_substep(&mut self, solver: &SequentialImpulses) -> f64 {
        let mut work = 0.0;
        for own in &mut self.joints {
            for (side, &number) in own.joint.bodies.iter().enumerate() {
                let (linear, angular) = solver.body(number).mean_velocity();
                let given = own.given[side];
                work += given.linear.dot(linear) + given.angular.dot(angular);
                own.total[side].linear += given.linear;
                own.total[side].angular += given.angular;
            }
        }
        work
    }

    /// Takes up what contacts have given besides: after an impact at the end of the step the joints hold again. Returns the work, J.
    pub fn hold_after_impact(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) -> f64 {
        let mut work = 0.0;
        for own in &mut self.joints {
            own.given = Default::default();
        }
        let kept: Vec<_> = self.joints.iter().map(|own| own.multipliers).collect();
        for back in [false, true].repeat(ROUNDS / 2) {
            let count = self.joints.len();
            for k in 0..count {
                let own = &mut self.joints[if back { count - 1 - k } else { k }];
                let before = own.velocities(solver);
                let given = own.given;
                own.solve(solver, rule);
                let after = own.velocities(solver);
                for side in 0..2 {
                    let (linear, angular) =
                        (own.given[side].linear - given[side].linear, own.given[side].angular - given[side].angular);
                    work += 0.5 * linear.dot(before[side].0 + after[side].0);
                    work += 0.5 * angular.dot(before[side].1 + after[side].1);
                }
            }
        }
        for (own, multipliers) in self.joints.iter_mut().zip(kept) {
            own.multipliers = multipliers;
            for side in 0..2 {
                own.total[side].linear += own.given[side].linear;
                own.total[side].angular += own.given[side].angular;
            }
        }
        work
    }

    /// The multipliers of a joint: of the last substep, N s.
    pub fn multipliers(&self, number: usize) -> [f64; MOST_JOINT_ROWS] {
        self.joints.get(number).map_or([0.0; MOST_JOINT_ROWS], |own| own.multipliers)
    }

    /// What a joint gave to A and B in the present substep.
    pub fn given(&self, number: usize) -> [BodyImpulse; 2] {
        self.joints.get(number).map_or_else(Default::default, |own| own.given)
    }

    /// What a joint gave to A and B in the whole step.
    pub fn total(&self, number: usize) -> [BodyImpulse; 2] {
        self.joints.get(number).map_or_else(Default::default, |own| own.total)
    }
}

impl Solved {
    fn take(&mut self, solver: &SequentialImpulses, joint: &ImpulseJoint) {
        self.joint = *joint;
        let bodies = joint.bodies.map(|number| solver.body(number));
        for (row, effects) in joint.rows[..joint.count].iter().zip(&mut self.effects) {
            for side in 0..2 {
                let body = bodies[side];
                effects[side] = (row.forces[side] * body.inverse_mass(), body.inverse_inertia() * row.moments[side]);
            }
        }
        self.factor();
    }

    /// `L D L^T` of `K`, row by row.
    fn factor(&mut self) {
        let rows = &self.joint.rows;
        for i in 0..self.joint.count {
            let entry = |j: usize| -> f64 {
                let of = |side: usize| {
                    let (linear, angular) = self.effects[j][side];
                    rows[i].forces[side].dot(linear) + rows[i].moments[side].dot(angular)
                };
                of(0) + of(1)
            };
            let line: [f64; MOST_JOINT_ROWS] = std::array::from_fn(|j| if j <= i { entry(j) } else { 0.0 });
            let mut pivot = line[i];
            let mut scaled = [0.0; MOST_JOINT_ROWS];
            for j in 0..i {
                // The entry of L D, and of L.
                let mut value = line[j];
                for k in 0..j {
                    value -= scaled[k] * self.factors[j][k];
                }
                scaled[j] = value;
                self.factors[i][j] = value * self.factors[j][j];
                pivot -= value * self.factors[i][j];
            }
            self.factors[i][i] = if pivot > DEPENDENT * line[i] { 1.0 / pivot } else { 0.0 };
        }
    }

    /// `K^-1 x`.
    fn solved(&self, mut x: [f64; MOST_JOINT_ROWS]) -> [f64; MOST_JOINT_ROWS] {
        let count = self.joint.count;
        for i in 0..count {
            for j in 0..i {
                x[i] -= self.factors[i][j] * x[j];
            }
        }
        for i in 0..count {
            x[i] *= self.factors[i][i];
        }
        for i in (0..count).rev() {
            for j in i + 1..count {
                x[i] -= self.factors[j][i] * x[j];
            }
        }
        x
    }

    fn velocities(&self, solver: &SequentialImpulses) -> [(DVec3, DVec3); 2] {
        self.joint.bodies.map(|number| {
            let body = solver.body(number);
            (body.linear(), body.angular())
        })
    }

    fn solve(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) {
        let velocities = self.velocities(solver);
        let count = self.joint.count;
        let gap = self.joint.rows[0].gap;
        let is_apart = self.joint.law == JointLaw::Limit && gap > 0.0;
        let soft = if is_apart { Softness { rate: rule.inverse_step, ..Softness::RIGID } } else { rule.with_fixed };
        let mut wanted = [0.0; MOST_JOINT_ROWS];
        for (row, wanted) in self.joint.rows[..count].iter().zip(&mut wanted) {
            let of = |side: usize| row.forces[side].dot(velocities[side].0) + row.moments[side].dot(velocities[side].1);
            let push = soft.rate * row.gap;
            let push = if is_apart { push } else { push.clamp(-rule.push.abs(), rule.push.abs()) };
            *wanted = of(0) + of(1) + push;
        }
        let mut change = self.solved(wanted);
        for (change, known) in change.iter_mut().zip(&self.multipliers).take(count) {
            *change = -soft.mass * *change - soft.impulse * known;
        }
        if self.joint.law == JointLaw::Limit {
            change[0] = (self.multipliers[0] + change[0]).max(0.0) - self.multipliers[0];
        }
        for (known, change) in self.multipliers.iter_mut().zip(&change).take(count) {
            *known += change;
        }
        self.give(solver, change);
    }

    /// The bodies take these multipliers.
    fn give(&mut self, solver: &mut SequentialImpulses, multipliers: [f64; MOST_JOINT_ROWS]) {
        for side in 0..2 {
            let body = solver.body_mut(self.joint.bodies[side]);
            let (mut linear, mut angular) = (body.linear(), body.angular());
            let given = &mut self.given[side];
            let rows = self.joint.rows.iter().zip(&self.effects).zip(multipliers).take(self.joint.count);
            for ((row, effects), multiplier) in rows {
                linear += effects[side].0 * multiplier;
                angular += effects[side].1 * multiplier;
                given.linear += row.forces[side] * multiplier;
                given.angular += row.moments[side] * multiplier;
            }
            body.set_velocity(linear, angular);
        }
    }
}

#[cfg(test)]
mod tests {
    //! A ball joint and a hinge stop the motion that they hold, at once; a limit pushes and does not pull; the work is the change of energy.
    use super::super::ImpulseBody;
    use super::*;
    use polhode_spatial::DMat3;

    const RIGID: SweepRule = SweepRule {
        between: Softness::RIGID,
        with_fixed: Softness::RIGID,
        push: 1.0,
        inverse_step: 240.0,
        colliding: 1.0,
    };

    /// A body of 2 kg and 0.5 kg m^2 that is held at the world at an arm of 1 m, by these rows.
    fn held(directions: &[DVec3], law: JointLaw, gap: f64) -> (SequentialImpulses, JointImpulses) {
        let mut solver = SequentialImpulses::default();
        let body = solver.add_body(ImpulseBody::new(0.5, DMat3::IDENTITY * 2.0));
        solver.body_mut(body).set_velocity(DVec3::new(1.0, -2.0, 3.0), DVec3::new(0.3, 0.2, -0.1));
        let arm = DVec3::X;
        let mut rows = [JointRow::default(); MOST_JOINT_ROWS];
        for (row, &direction) in rows.iter_mut().zip(directions) {
            let moments = [arm.cross(direction), DVec3::ZERO];
            *row = JointRow { forces: [direction, -direction], moments, gap };
        }
        let bodies = [body, SequentialImpulses::IMMOVABLE];
        let mut joints = JointImpulses::default();
        joints.set(&solver, 0, ImpulseJoint { bodies, law, rows, count: directions.len() });
        (solver, joints)
    }

    #[test]
    fn a_ball_joint_holds_its_point_at_once() {
        let (mut solver, mut joints) = held(&DVec3::AXES, JointLaw::Hold, 0.0);
        let energy = |solver: &SequentialImpulses| {
            let body = solver.body(1);
            0.5 * (2.0 * body.linear().length_squared() + 0.5 * body.angular().length_squared())
        };
        let before = energy(&solver);
        let work = joints.hold_after_impact(&mut solver, &RIGID);
        let body = solver.body(1);
        assert!((body.linear() + body.angular().cross(DVec3::X)).length() < 1e-14, "{body:?}");
        assert!((energy(&solver) - before - work).abs() < 1e-14, "{work}");
    }

    #[test]
    fn a_limit_pushes_and_does_not_pull() {
        for (direction, gap, moves) in [(DVec3::X, 0.0, true), (-DVec3::X, 0.0, false), (-DVec3::X, 1.0, true)] {
            let (mut solver, mut joints) = held(&[direction], JointLaw::Limit, gap);
            let before = solver.body(1).linear().x;
            joints.sweep(&mut solver, &RIGID);
            assert_eq!(solver.body(1).linear().x == before, moves, "{direction} {gap}");
        }
    }

    #[test]
    fn rows_that_depend_on_each_other_are_left_out() {
        let (mut solver, mut joints) = held(&[DVec3::Y, DVec3::Y, DVec3::Z], JointLaw::Hold, 0.0);
        joints.sweep(&mut solver, &RIGID);
        let body = solver.body(1);
        let at_point = body.linear() + body.angular().cross(DVec3::X);
        assert!(at_point.y.abs() < 1e-14 && at_point.z.abs() < 1e-14 && at_point.x == 1.0, "{at_point}");
    }
}
