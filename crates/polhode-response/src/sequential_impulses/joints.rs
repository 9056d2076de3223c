//! Joints among sequential impulses: what holds two bodies by rows of either sign, and limits that push.
//!
//! Joints that close no loop are solved at once, as trees (`joint_trees`). Of limits, and of joints that close loops,
//! the rows of each (up to six) are solved together,
//! by the factors of their own matrix. With the rates `u = J v` of its rows (m/s), their gaps `g`
//! (m), and the softness `a`, `b`, `c` of a sweep ([`SweepRule::with_fixed`]),
//!
//! ```text
//! l <- l - a K^-1 (u + b g) - c l       K = J M^-1 J^T (1/kg), l impulses (N s); b g cut to the largest push
//! a limit: l <- max(0, ...), and where it is apart by s > 0: a = 1, b s = s / h, c = 0
//! ```
//!
//! Joints that move no body together have one colour, and four of a colour with as many rows are solved side by side
//! (`joint_batch`). Batches and sums do not depend on the width of the lanes, so that the bits do not.
//!
//! Rows are given anew whenever the bodies have moved. What a joint has given its bodies in a substep is summed as it
//! was given, and its work is that along the mean velocities. At the start of the next substep its multipliers act
//! again, along the present rows: the impulses of before, along rows of before, would drive a body that turns about the
//! joint. Sources: Catto 2005, Catto 2024 (soft constraints), docs/REFERENCES.md.
//!
//! Failure: rows that depend on each other within one joint are left out, one of them; joints that contradict each
//! other share the error; loops and limits with large ratios
//! of masses need more rounds than there are.

use super::body::ImpulseBody;
use super::colours::{Colours, GROUPS, NO_COLOUR};
use super::joint::{ImpulseJoint, JointLaw, JointRow};
use super::joint_batch::{self, JointBatch, LaneImpulse, LaneRow};
use super::joint_trees::JointTrees;
use super::lanes::{FOUR, Four, Fours};
use super::stages::{LAST_BOUNCE, MOST_PASSES};
use super::sweep::SweepRule;
use super::{LaneWidth, SequentialImpulses};
use crate::law::MOST_ROWS;
use polhode_spatial::DVec3;
use wide::f64x2;

/// Kinds of batches of one colour: limits, and joints by their number of rows, those that close loops and those of
/// trees.
const KINDS: usize = 1 + 2 * MOST_ROWS;

/// An impulse on a body: force part (N s), and moment about its centre of mass (N m s).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyImpulse {
    /// N s.
    pub linear: DVec3,
    /// N m s.
    pub angular: DVec3,
}

/// Joints of a step, with the buffers from which their batches are made.
#[derive(Debug, Clone, Default)]
pub struct JointImpulses {
    pub(super) joints: Vec<ImpulseJoint>,
    batches: Vec<JointBatch>,
    rows: Vec<LaneRow>,
    /// Where each joint has gone: its batch and lane.
    places: Vec<Place>,
    colours: Colours,
    keys: Vec<u32>,
    order: Vec<u32>,
    kept: Vec<Four>,
    pub(super) trees: JointTrees,
    /// Rounds of all joints since they were put into batches.
    rounds: usize,
}

/// Where a joint has gone.
#[derive(Debug, Clone, Copy, Default)]
struct Place {
    batch: u32,
    lane: u32,
}

/// Calls a kernel with lanes of the width of a solver.
macro_rules! in_lanes {
    ($width:expr, $($kernel:ident)::+, $($argument:expr),+) => {
        match $width {
            LaneWidth::Two => $($kernel)::+::<f64x2>($($argument),+),
            LaneWidth::Four => $($kernel)::+::<Fours>($($argument),+),
        }
    };
}

impl JointImpulses {
    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// Removes all.
    pub fn clear(&mut self) {
        self.joints.clear();
        self.batches.clear();
        self.places.clear();
        self.trees.clear();
    }

    /// Adds a joint of bodies that the solver has. Returns its number.
    pub fn add(&mut self, joint: ImpulseJoint) -> usize {
        let rows = if joint.law == JointLaw::Limit { 1 } else { joint.rows.clamp(1, MOST_ROWS) };
        self.joints.push(ImpulseJoint { rows, ..joint });
        self.joints.len() - 1
    }

    /// How many joints have been solved since they were put into batches, each as often as it was.
    pub fn solved(&self) -> usize {
        self.rounds * self.joints.len()
    }

    /// Puts the joints into batches, without rows and impulses.
    pub fn prepare(&mut self, solver: &SequentialImpulses) {
        self.rounds = 0;
        let moves = |body: u32| solver.body(body).is_moved();
        for joint in &mut self.joints {
            joint.bodies = joint.bodies.map(|body| if (body as usize) < solver.bodies.len() { body } else { 0 });
        }
        self.trees.prepare(&self.joints, &solver.bodies);
        self.sort(solver.bodies.len(), moves);
        self.batches.clear();
        self.rows.clear();
        self.places.clear();
        self.places.resize(self.joints.len(), Place::default());
        let (mut open, mut used) = (u32::MAX, FOUR);
        for &number in &self.order {
            let (joint, key) = (self.joints[number as usize], self.keys[number as usize]);
            let is_alone = key / KINDS as u32 == NO_COLOUR;
            if used == FOUR || key != open || is_alone {
                (open, used) = (key, 0);
                let first = self.rows.len();
                self.rows.resize(first + joint.rows, LaneRow::default());
                let (first, count) = (first as u32, joint.rows as u32);
                let in_tree = self.trees.has(number as usize);
                self.batches.push(JointBatch { law: joint.law, in_tree, first, count, ..JointBatch::default() });
            }
            let batch = self.batches.len() - 1;
            [self.batches[batch].a[used], self.batches[batch].b[used]] = joint.bodies;
            self.places[number as usize] = Place { batch: batch as u32, lane: used as u32 };
            used += 1;
        }
    }

    /// Sorts the joints by colour and kind, those of one kind as they are given.
    fn sort(&mut self, bodies: usize, moves: impl Fn(u32) -> bool) {
        self.colours.begin(bodies);
        self.keys.clear();
        let mut counts = [0_u32; GROUPS * KINDS + 1];
        for (number, joint) in self.joints.iter().enumerate() {
            let colour = self.colours.next(joint.bodies, joint.bodies.map(&moves));
            let of_tree = if self.trees.has(number) { MOST_ROWS as u32 } else { 0 };
            let kind = if joint.law == JointLaw::Limit { 0 } else { joint.rows as u32 + of_tree };
            let key = colour * KINDS as u32 + kind;
            counts[key as usize + 1] += 1;
            self.keys.push(key);
        }
        for k in 1..counts.len() {
            counts[k] += counts[k - 1];
        }
        self.order.clear();
        self.order.resize(self.joints.len(), 0);
        for (number, &key) in self.keys.iter().enumerate() {
            let place = &mut counts[key as usize];
            self.order[*place as usize] = number as u32;
            *place += 1;
        }
    }

    /// Gives a joint its rows in the present poses. Rows that it has beside those given hold nothing. [`Self::factor`]
    /// follows.
    pub fn set_rows(&mut self, number: usize, rows: &[JointRow]) {
        let Some(Place { batch, lane }) = self.places.get(number).copied() else { return };
        let JointBatch { first, count, .. } = self.batches[batch as usize];
        let none = JointRow::default();
        let own = &mut self.rows[first as usize..(first + count) as usize];
        for (to, row) in own.iter_mut().zip(rows.iter().chain(std::iter::repeat(&none))) {
            to.put(lane as usize, row);
        }
        self.trees.set_rows(&self.joints[number], number, rows);
    }

    /// Finds the factors of the rows that have been given.
    pub fn factor(&mut self, solver: &SequentialImpulses) {
        for batch in self.batches.iter_mut().filter(|batch| !batch.in_tree) {
            let rows = &mut self.rows[batch.first as usize..(batch.first + batch.count) as usize];
            in_lanes!(solver.width, joint_batch::factor, &solver.bodies, (batch, rows));
        }
        self.trees.factor(&solver.bodies);
    }

    /// Gives a joint the multipliers that are known at the start of a step, N s. [`Self::start`] follows.
    pub fn set_multipliers(&mut self, number: usize, multipliers: [f64; MOST_ROWS]) {
        let Some(Place { batch, lane }) = self.places.get(number).copied() else { return };
        let JointBatch { first, count, .. } = self.batches[batch as usize];
        let own = &mut self.rows[first as usize..(first + count) as usize];
        own.iter_mut().zip(multipliers).for_each(|(row, own)| row.multiplier.0[lane as usize] = own);
    }

    /// Starts a substep: takes back what the joints gave in the one before, which has acted on the velocities again,
    /// and gives their multipliers along the present rows.
    pub fn start(&mut self, solver: &mut SequentialImpulses) {
        for batch in &mut self.batches {
            let rows = &mut self.rows[batch.first as usize..(batch.first + batch.count) as usize];
            in_lanes!(solver.width, joint_batch::start, &mut solver.bodies, (batch, rows));
        }
    }

    /// Brings all joints to their laws: limits and joints that close loops in rounds forth and back, each followed by
    /// the trees, until a round does little of what the largest has done. Where nothing has been struck two rounds or
    /// three do, since the impulses of the substep before are those of the present one but for the order of its length.
    pub fn sweep(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) {
        self.sweep_by_rounds(solver, rule, |_, _| 0.0);
    }

    /// The same, with the work of the trees in a round by `of_trees`. Returns the work, J.
    fn sweep_by_rounds(
        &mut self,
        solver: &mut SequentialImpulses,
        rule: &SweepRule,
        of_trees: impl Fn(&JointTrees, &[ImpulseBody]) -> f64,
    ) -> f64 {
        let (mut all, mut largest) = (0.0, 0.0_f64);
        for round in 0..MOST_PASSES {
            self.rounds += 1;
            let mut work = Four::default();
            for place in rounds_of(round, self.batches.len()) {
                let batch = &mut self.batches[place];
                if !batch.in_tree {
                    let rows = &mut self.rows[batch.first as usize..(batch.first + batch.count) as usize];
                    let of = (rule, &mut work);
                    in_lanes!(solver.width, joint_batch::solve, &mut solver.bodies, (batch, rows), of);
                }
            }
            // Trees alone are exact after one round, but for the softness of their factors.
            self.solve_trees(solver, rule);
            let done = sum(&work) + of_trees(&self.trees, &solver.bodies);
            all += done;
            largest = largest.max(done.abs());
            if done.abs() <= LAST_BOUNCE * largest {
                break;
            }
        }
        all
    }

    /// The trees at once. Gaps close as the softness of the rule says, and no further than its push.
    fn solve_trees(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) {
        let (rate, push) = (rule.with_fixed.rate, rule.push.abs());
        let closing = |gap: f64| (rate * gap).clamp(-push, push);
        for given in self.trees.solve(&mut solver.bodies, closing) {
            let Place { batch, lane } = self.places[given.joint];
            let batch = &mut self.batches[batch as usize];
            let rows = &mut self.rows[batch.first as usize..(batch.first + batch.count) as usize];
            for (row, change) in rows.iter_mut().zip(given.change) {
                row.multiplier.0[lane as usize] += change;
                batch.given.take(lane as usize, row, change);
            }
        }
    }

    /// Ends a substep. Returns their work along the mean velocities of the bodies, J.
    pub fn end_substep(&mut self, solver: &SequentialImpulses) -> f64 {
        let mut work = Four::default();
        for batch in &mut self.batches {
            in_lanes!(solver.width, joint_batch::end, &solver.bodies, batch, &mut work);
        }
        sum(&work)
    }

    /// What is given from here on is that of an impact.
    pub(super) fn begin_impact(&mut self) {
        self.kept.clear();
        self.kept.extend(self.rows.iter().map(|row| row.multiplier));
        self.batches.iter_mut().for_each(|batch| batch.given = LaneImpulse::default());
    }

    /// Multipliers are again those of the last substep, with which the next one begins.
    pub(super) fn end_impact(&mut self) {
        self.rows.iter_mut().zip(&self.kept).for_each(|(row, kept)| row.multiplier = *kept);
        self.batches.iter_mut().for_each(JointBatch::add_up);
    }

    /// Brings the joints to their laws within an impact. Returns the work, J.
    pub(super) fn hold(&mut self, solver: &mut SequentialImpulses, rule: &SweepRule) -> f64 {
        self.sweep_by_rounds(solver, rule, JointTrees::work)
    }

    /// The multipliers of a joint: of the last substep, N s.
    pub fn multipliers(&self, number: usize) -> [f64; MOST_ROWS] {
        let mut multipliers = [0.0; MOST_ROWS];
        if let Some(Place { batch, lane }) = self.places.get(number).copied() {
            let JointBatch { first, count, .. } = self.batches[batch as usize];
            let own = &self.rows[first as usize..(first + count) as usize];
            multipliers.iter_mut().zip(own).for_each(|(to, row)| *to = row.multiplier.0[lane as usize]);
        }
        multipliers
    }

    /// What a joint gave to A and B in the present substep.
    pub fn given(&self, number: usize) -> [BodyImpulse; 2] {
        self.impulse(number, |batch| &batch.given)
    }

    /// What a joint gave to A and B in the whole step.
    pub fn total(&self, number: usize) -> [BodyImpulse; 2] {
        self.impulse(number, |batch| &batch.total)
    }

    fn impulse(&self, number: usize, of: impl Fn(&JointBatch) -> &LaneImpulse) -> [BodyImpulse; 2] {
        let Some(Place { batch, lane }) = self.places.get(number).copied() else { return Default::default() };
        let LaneImpulse { force, moments } = of(&self.batches[batch as usize]);
        let vector = |from: &[Four; 3]| DVec3::from_array(from.map(|four| four.0[lane as usize]));
        let linear = vector(force);
        let [on_a, on_b] = [&moments[0], &moments[1]].map(vector);
        [BodyImpulse { linear, angular: on_a }, BodyImpulse { linear: -linear, angular: on_b }]
    }
}

/// The sum of the lanes, in order.
fn sum(four: &Four) -> f64 {
    (four.0[0] + four.0[1]) + (four.0[2] + four.0[3])
}

/// The places of so many batches in a round: forth in one, back in the next.
fn rounds_of(round: usize, batches: usize) -> impl Iterator<Item = usize> {
    (0..batches).map(move |k| if round.is_multiple_of(2) { k } else { batches - 1 - k })
}

#[cfg(test)]
mod tests {
    //! A ball joint and a hinge stop the motion that they hold, at once; a limit pushes and does not pull; the work is
    //! the change of energy. Joints of all numbers of rows side by side obey their laws, with the same bits for two and
    //! four lanes.
    use super::super::sweep::Softness;
    use super::*;
    use polhode_spatial::{DMat3, SplitMix64};

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
        let mut rows = [JointRow::default(); MOST_ROWS];
        for (row, &direction) in rows.iter_mut().zip(directions) {
            let moments = [arm.cross(direction), DVec3::ZERO];
            *row = JointRow { force: direction, moments, gap };
        }
        let bodies = [body, SequentialImpulses::IMMOVABLE];
        let mut joints = JointImpulses::default();
        let number = joints.add(ImpulseJoint { bodies, law, rows: directions.len() });
        joints.prepare(&solver);
        joints.set_rows(number, &rows[..directions.len()]);
        joints.factor(&solver);
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
        joints.begin_impact();
        let work = joints.hold(&mut solver, &RIGID);
        joints.end_impact();
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
        // One elimination of rows that yield by 1e-8 of their inverse mass: the next sweep takes what is left.
        assert!(at_point.y.abs() < 1e-7 && at_point.z.abs() < 1e-7 && at_point.x == 1.0, "{at_point}");
    }
    type Given = (ImpulseJoint, Vec<JointRow>);

    /// A crowd of joints, more of them at one body than there are colours.
    fn crowd(width: LaneWidth) -> (SequentialImpulses, JointImpulses, Vec<Given>) {
        let mut random = SplitMix64::new(11);
        let mut vector = || DVec3::new(random.uniform(), random.uniform(), random.uniform()) - DVec3::splat(0.5);
        let mut solver = SequentialImpulses::with_lanes(width);
        for _ in 0..150 {
            let body = solver.add_body(ImpulseBody::new(1.5, DMat3::IDENTITY * 2.0));
            let (linear, angular) = (vector(), vector());
            solver.body_mut(body).set_velocity(linear, angular);
        }
        let (mut joints, mut all) = (JointImpulses::default(), Vec::new());
        for k in 0..220_u32 {
            let law = if k % 8 == 7 { JointLaw::Limit } else { JointLaw::Hold };
            // Bodies 2 to 150 in four chains, the world among their ends; body 1 with all others.
            let bodies = if k < 150 { [1 + k, (k + 4) % 151] } else { [1, 2 + k - 150] };
            let joint = ImpulseJoint { bodies, law, rows: if k % 8 == 7 { 1 } else { 1 + k as usize % 6 } };
            let mut row = || JointRow { force: vector(), moments: [vector(), vector()], gap: 0.01 * vector().x };
            let rows: Vec<JointRow> = (0..joint.rows).map(|_| row()).collect();
            all.push((joint, rows));
            joints.add(joint);
        }
        joints.prepare(&solver);
        all.iter().enumerate().for_each(|(number, (_, rows))| joints.set_rows(number, rows));
        joints.factor(&solver);
        (solver, joints, all)
    }

    const SOFT: SweepRule = SweepRule { with_fixed: Softness { rate: 20.0, mass: 0.9, impulse: 0.1 }, ..RIGID };

    #[test]
    fn two_and_four_lanes_give_the_same_bits() {
        let of = |width: LaneWidth| {
            let (mut solver, mut joints, all) = crowd(width);
            joints.set_multipliers(3, [0.1; MOST_ROWS]);
            let mut works = Vec::new();
            for _ in 0..2 {
                joints.start(&mut solver);
                joints.sweep(&mut solver, &SOFT);
                joints.sweep(&mut solver, &RIGID);
                works.push(joints.end_substep(&solver).to_bits());
            }
            joints.begin_impact();
            works.push(joints.hold(&mut solver, &RIGID).to_bits());
            joints.end_impact();
            let velocities: Vec<_> = (0..=150).map(|n| (solver.body(n).linear(), solver.body(n).angular())).collect();
            let impulses: Vec<_> = (0..all.len()).map(|n| (joints.multipliers(n), joints.total(n))).collect();
            (works, velocities, impulses)
        };
        assert!(of(LaneWidth::Two) == of(LaneWidth::Four));
    }

    /// After many sweeps every joint holds, those of a body with more joints than colours too; what the joints gave is
    /// what changed the bodies.
    #[test]
    fn joints_side_by_side_obey_their_laws() {
        for width in [LaneWidth::Two, LaneWidth::Four] {
            let (mut solver, mut joints, all) = crowd(width);
            let before: Vec<_> = (0..=150).map(|n| (solver.body(n).linear(), solver.body(n).angular())).collect();
            let rule = SweepRule { inverse_step: 1.0, ..RIGID };
            for _ in 0..8000 {
                joints.sweep(&mut solver, &rule);
            }
            let rate = |joint: &ImpulseJoint, row: &JointRow| {
                let [a, b] = joint.bodies.map(|body| solver.body(body));
                let turns = row.moments[0].dot(a.angular()) + row.moments[1].dot(b.angular());
                row.force.dot(a.linear() - b.linear()) + turns
            };
            let mut changes = vec![(DVec3::ZERO, DVec3::ZERO); 151];
            for (number, (joint, rows)) in all.iter().enumerate() {
                match joint.law {
                    JointLaw::Hold => {
                        let most = rows.iter().fold(0.0, |most: f64, row| most.max(rate(joint, row).abs()));
                        assert!(most < 1e-6, "{number} {most} {joint:?}");
                    }
                    JointLaw::Limit => {
                        let (multiplier, allowed) = (joints.multipliers(number)[0], rows[0].gap.max(0.0));
                        let slack = rate(joint, &rows[0]) + allowed;
                        assert!(multiplier >= 0.0 && slack > -1e-6 && (multiplier * slack).abs() < 1e-6, "{number}");
                    }
                }
                for (body, given) in joint.bodies.into_iter().zip(joints.given(number)) {
                    changes[body as usize].0 += given.linear * solver.body(body).inverse_mass();
                    changes[body as usize].1 += solver.body(body).inverse_inertia() * given.angular;
                }
            }
            for (number, (before, change)) in (0..).zip(before.iter().zip(&changes)) {
                let body = solver.body(number);
                assert!((body.linear() - before.0 - change.0).length() < 1e-9, "{number}");
                assert!((body.angular() - before.1 - change.1).length() < 1e-9, "{number}");
            }
        }
    }
}
