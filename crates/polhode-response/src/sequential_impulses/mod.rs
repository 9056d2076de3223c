//! Sequential impulses over contacts of many bodies, four side by side: the hot part of a step in real time.
//!
//! A step is divided into substeps. In each of them impulses are known to begin with (those of the substep before), and
//! one sweep over all contacts brings each point to its law while overlaps are pushed apart softly; then whoever calls
//! moves the bodies, and another sweep without the push takes its velocity out again ([`SweepRule`]). Restitution
//! follows once at the end.
//!
//! Contacts of one normal are a manifold ([`ImpulseManifold`]); manifolds that move no body together have a colour and
//! are solved side by side. Batches, colours and sums do not depend on the width of the lanes, so that the bits do not.
//!
//! Sources: Catto 2024 (soft steps, wide contacts), Catto 2005 (sequential impulses), docs/REFERENCES.md. Symbols: `p`
//! impulse, N s; `u` relative velocity of A to B at a point, m/s; `K` inverse mass of a point, 1/kg; `mu` friction; `h`
//! length of a substep, s. Assumption: rows do not change within a step, displacements are small against the arms.
//! Failure: nothing is refused; numbers that are not finite stay so.
//!
//! | module | holds |
//! |---|---|
//! | `lanes` | numbers, vectors and matrices side by side |
//! | `body` | [`ImpulseBody`]: velocity, inverse masses and displacement |
//! | `lone_bounce` | the bounce of one point, by the law of a single impact |
//! | `manifold` | [`ImpulseManifold`]: what is given; [`PointImpulse`]: what comes back |
//! | `colours` | which manifolds are solved side by side |
//! | `batch` | manifolds in batches of four |
//! | `patch` | a patch in coordinates of its own |
//! | `friction` | Coulomb's law, of sweeps and of bounces |
//! | `conjugate` | steps of conjugate gradients between sweeps |
//! | `joints` | [`JointImpulses`]: joints and their limits |
//! | `joint` | [`ImpulseJoint`]: what is given of a joint |
//! | `joint_batch` | joints in batches of four, and what the lanes do with them |
//! | `joint_trees` | joints that close no loop, all at once |
//! | `jointed_bounce` | bounces of bodies that joints hold |
//! | `works` | what impulses do |
//! | `together` | the normal impulses of a patch, all at once |
//! | `sweep` | one sweep: the law |
//! | `stages` | masses, known impulses, restitution, totals |
//! | `residual` | how far the impulses are from the law |
//!
//! ```
//! use polhode_response::sequential_impulses::{ImpulseBody, ImpulseManifold, ManifoldPoint, SequentialImpulses};
//! use polhode_response::sequential_impulses::{Softness, SweepOrder, SweepRule, SweepStage};
//! use polhode_response::spatial::{DMat3, DVec3};
//! // A point mass of 2 kg that falls onto the ground at 3 m/s.
//! let mut solver = SequentialImpulses::default();
//! let body = solver.add_body(ImpulseBody::new(0.5, DMat3::ZERO));
//! solver.body_mut(body).set_velocity(DVec3::Z * -3.0, DVec3::ZERO);
//! let mut points = [ManifoldPoint::default(); 4];
//! points[0].arm = DVec3::ZERO;
//! let frame = (DVec3::Z, DVec3::X, DVec3::ZERO);
//! let bodies = [body, SequentialImpulses::IMMOVABLE];
//! let (normal, tangent, between) = frame;
//! solver.add(ImpulseManifold { bodies, normal, tangent, between, friction: 0.5, restitution: 0.0, points, count: 1 });
//! solver.prepare();
//! let rule = SweepRule {
//!     between: Softness::RIGID, with_fixed: Softness::RIGID, push: 0.0, inverse_step: 240.0, colliding: 1.0,
//! };
//! solver.sweep(SweepStage::First, SweepOrder::Onward, &rule);
//! assert_eq!(solver.body(body).linear(), DVec3::ZERO);
//! // The mean of its velocities before and after.
//! solver.body_mut(body).set_mean_velocity(DVec3::Z * -1.5, DVec3::ZERO);
//! let works = solver.end_substep(&rule);
//! assert_eq!(works.colliding_j, -9.0);
//! ```
#![expect(
    clippy::inline_always,
    reason = "lanes are worth something only where they stay in registers, across every call of a sweep"
)]

mod batch;
mod body;
mod colours;
mod conjugate;
mod friction;
mod joint;
mod joint_batch;
mod joint_trees;
mod jointed_bounce;
mod joints;
mod lanes;
mod lone_bounce;
mod manifold;
mod patch;
mod residual;
mod stages;
mod sweep;
mod together;
mod works;

pub use body::ImpulseBody;
pub use joint::{ImpulseJoint, JointLaw, JointRow};
pub use joints::{BodyImpulse, JointImpulses};
pub use manifold::{ImpulseManifold, MOST_POINTS, ManifoldPoint, PointImpulse};
pub use residual::Residual;
pub use sweep::{Softness, SweepOrder, SweepRule, SweepStage};
pub use works::Works;

use batch::Batches;
use lanes::Fours;
use stages::Bouncing;
use sweep::Sweep;
use wide::f64x2;

/// How many contacts an instruction works on. It changes the time, and no bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LaneWidth {
    /// Two: as many as a register holds on every processor.
    #[default]
    Two,
    /// Four.
    Four,
}

/// Bodies and contacts of a step, with the buffers from the step before.
#[derive(Debug, Clone)]
pub struct SequentialImpulses {
    width: LaneWidth,
    bodies: Vec<ImpulseBody>,
    manifolds: Vec<ImpulseManifold>,
    batches: Batches,
    memory: Vec<conjugate::Memory>,
}

impl Default for SequentialImpulses {
    fn default() -> Self {
        Self::with_lanes(LaneWidth::default())
    }
}

impl SequentialImpulses {
    /// The body that no impulse moves, and that is at rest.
    pub const IMMOVABLE: u32 = 0;

    /// Nothing yet, to be solved with lanes of this width.
    pub fn with_lanes(width: LaneWidth) -> Self {
        let bodies = vec![ImpulseBody::immovable()];
        Self { width, bodies, manifolds: Vec::new(), batches: Batches::default(), memory: Vec::new() }
    }

    /// Removes all bodies and contacts.
    pub fn clear(&mut self) {
        self.bodies.truncate(1);
        self.manifolds.clear();
    }

    /// Adds a body. Returns its number.
    pub fn add_body(&mut self, body: ImpulseBody) -> u32 {
        self.bodies.push(body);
        (self.bodies.len() - 1) as u32
    }

    /// The body of this number; the immovable one where there is none.
    pub fn body(&self, number: u32) -> &ImpulseBody {
        self.bodies.get(number as usize).unwrap_or(&self.bodies[0])
    }

    /// The same, to be changed.
    pub fn body_mut(&mut self, number: u32) -> &mut ImpulseBody {
        let place = if (number as usize) < self.bodies.len() { number as usize } else { 0 };
        &mut self.bodies[place]
    }

    /// Adds a manifold of bodies that have been added. Returns its number.
    pub fn add(&mut self, mut manifold: ImpulseManifold) -> usize {
        let most = self.bodies.len() as u32 - 1;
        manifold.bodies = manifold.bodies.map(|body| if body <= most { body } else { Self::IMMOVABLE });
        manifold.count = manifold.count.min(MOST_POINTS);
        self.manifolds.push(manifold);
        self.manifolds.len() - 1
    }

    /// The manifolds, as they were added.
    pub fn manifolds(&self) -> &[ImpulseManifold] {
        &self.manifolds
    }

    /// Puts the manifolds into batches and finds their masses, at the velocities of the start of the step.
    pub fn prepare(&mut self) {
        let bodies = &self.bodies;
        self.batches.fill(bodies.len(), &self.manifolds, |body| bodies[body as usize].is_moved());
        let Batches { list: batches, points, .. } = &mut self.batches;
        match self.width {
            LaneWidth::Two => stages::prepare::<f64x2>(bodies, batches, points),
            LaneWidth::Four => stages::prepare::<Fours>(bodies, batches, points),
        }
    }

    /// Gives the impulses that are known, at the start of a step. Those of its later substeps are known by bodies: as
    /// long as rows do not change, they change the velocities by as much as in the substep before.
    pub fn warm_start(&mut self) {
        let Batches { list: batches, points, .. } = &self.batches;
        match self.width {
            LaneWidth::Two => stages::warm_start::<f64x2>(&mut self.bodies, batches, points),
            LaneWidth::Four => stages::warm_start::<Fours>(&mut self.bodies, batches, points),
        }
    }

    /// Gives colliding contacts the impulses by which they part again, at the end of a step whose totals are complete;
    /// where they have no restitution, those of the path of their slip. Where there are joints,
    /// [`JointImpulses::bounce`] takes its place.
    pub fn restitute(&mut self, rule: &SweepRule) -> Works {
        self.part_again(rule.colliding, &[], false)
    }

    /// The same where joints hold some of the bodies, and where those that are struck at one point alone may have
    /// bounced already.
    fn part_again(&mut self, colliding: f64, jointed: &[bool], has_begun: bool) -> Works {
        if !self.has_collided(colliding) {
            return Works::default();
        }
        let bouncing = Bouncing { has_begun, jointed };
        let Batches { list: batches, points, .. } = &mut self.batches;
        let by = (colliding, &bouncing);
        match self.width {
            LaneWidth::Two => stages::part_again::<f64x2>(&mut self.bodies, batches, points, by),
            LaneWidth::Four => stages::part_again::<Fours>(&mut self.bodies, batches, points, by),
        }
    }

    /// Whether a point has collided, faster than this (m/s), whose impulse is not known yet.
    fn has_collided(&self, colliding: f64) -> bool {
        let Batches { list: batches, points, .. } = &self.batches;
        batches.iter().any(|batch| stages::may_bounce(batch, points, colliding))
    }

    /// One sweep over all contacts. Returns the works that it has booked: those of the substep before where it begins a
    /// later one.
    pub fn sweep(&mut self, stage: SweepStage, order: SweepOrder, rule: &SweepRule) -> Works {
        let sweep = Sweep { stage, order, rule, between: self.batches.between };
        let Batches { list: batches, points, .. } = &mut self.batches;
        match self.width {
            LaneWidth::Two => sweep::sweep::<f64x2>(&mut self.bodies, batches, points, sweep),
            LaneWidth::Four => sweep::sweep::<Fours>(&mut self.bodies, batches, points, sweep),
        }
    }

    /// So many sweeps after a movement of the bodies, with steps of conjugate gradients between them (`conjugate`); one
    /// sweep is [`Self::sweep`].
    pub fn sweep_conjugate(&mut self, sweeps: u32, order: SweepOrder, rule: &SweepRule) {
        if sweeps <= 1 {
            self.sweep(SweepStage::Moved, order, rule);
            return;
        }
        self.memory.clear();
        self.memory.resize(self.batches.points.len(), conjugate::Memory::default());
        let mut last = 0.0;
        for sweep in 0..sweeps {
            conjugate::remember(&self.batches.points, &mut self.memory);
            self.sweep(if sweep == 0 { SweepStage::Moved } else { SweepStage::First }, order, rule);
            if sweep + 1 == sweeps {
                break;
            }
            let square = conjugate::square_of_change(&self.batches.points, &self.memory);
            let b = if last > 0.0 { square / last } else { 0.0 };
            last = square;
            if b <= 1.0 {
                let Batches { list: batches, points, .. } = &mut self.batches;
                let parts = (&mut points[..], &mut self.memory[..]);
                match self.width {
                    LaneWidth::Two => conjugate::step::<f64x2>(&mut self.bodies, batches, parts, b),
                    LaneWidth::Four => conjugate::step::<Fours>(&mut self.bodies, batches, parts, b),
                }
            } else {
                conjugate::start_again(&mut self.memory);
            }
        }
    }

    /// Ends the last substep: its impulses are added to those of the step. Returns what they did along the mean
    /// velocities of the bodies.
    pub fn end_substep(&mut self, rule: &SweepRule) -> Works {
        let Batches { list: batches, points, .. } = &mut self.batches;
        match self.width {
            LaneWidth::Two => stages::end::<f64x2>(&self.bodies, batches, points, rule.colliding),
            LaneWidth::Four => stages::end::<Fours>(&self.bodies, batches, points, rule.colliding),
        }
    }

    /// How far impulses and velocities are from the law.
    pub fn residual(&self, rule: &SweepRule) -> Residual {
        let Batches { list: batches, points, .. } = &self.batches;
        match self.width {
            LaneWidth::Two => residual::residual::<f64x2>(&self.bodies, batches, points, rule),
            LaneWidth::Four => residual::residual::<Fours>(&self.bodies, batches, points, rule),
        }
    }

    /// What became of the points of a manifold; nothing where there is none.
    #[inline]
    pub fn impulses(&self, manifold: usize) -> impl Iterator<Item = PointImpulse> {
        let place = self.batches.places.get(manifold).copied();
        let batch = place.and_then(|place| self.batches.list.get(place.batch as usize));
        let range = batch.map_or(0..0, |batch| batch.first as usize..(batch.first + batch.count) as usize);
        let lane = place.map_or(0, |place| place.lane as usize);
        self.batches.points[range].iter().map(move |row| PointImpulse {
            last: std::array::from_fn(|k| row.impulse[k].0[lane]),
            total: std::array::from_fn(|k| row.total[k].0[lane]),
            rate: row.rate.0[lane],
            separation: row.present.0[lane],
        })
    }
}

#[cfg(test)]
mod tests {
    //! Two and four lanes give the same bits; four bodies side by side, and many contacts of one body, obey the law;
    //! the works are the change of energy.
    use super::*;
    use polhode_spatial::{DMat3, DVec3, SplitMix64};

    const RULE: SweepRule = SweepRule {
        between: Softness { rate: 20.0, mass: 0.9, impulse: 0.1 },
        with_fixed: Softness { rate: 40.0, mass: 0.95, impulse: 0.05 },
        push: 3.0,
        inverse_step: 240.0,
        colliding: 0.3,
    };

    const ONWARD: SweepOrder = SweepOrder::Onward;

    fn energy(solver: &SequentialImpulses) -> f64 {
        let of = |number: u32| {
            let body = solver.body(number);
            if body.inverse_mass() > 0.0 {
                0.5 * (body.linear().length_squared() / body.inverse_mass() + body.angular().length_squared() / 2.0)
            } else {
                0.0
            }
        };
        (1..=20).map(of).sum()
    }

    fn heap(width: LaneWidth) -> SequentialImpulses {
        let mut random = SplitMix64::new(5);
        let mut solver = SequentialImpulses::with_lanes(width);
        for _ in 0..20 {
            let body = solver.add_body(ImpulseBody::new(1.0 + random.uniform(), DMat3::IDENTITY * 2.0));
            let mut vector = || DVec3::new(random.uniform(), random.uniform(), random.uniform()) - DVec3::splat(0.6);
            let (linear, angular) = (vector(), vector());
            solver.body_mut(body).set_velocity(linear, angular);
        }
        for k in 0..60_u32 {
            let count = 1 + k as usize % MOST_POINTS;
            let mut points = [ManifoldPoint::default(); MOST_POINTS];
            for point in &mut points {
                point.arm = DVec3::new(random.uniform(), random.uniform(), -0.5);
                point.separation = 0.02 * (random.uniform() - 0.5);
                point.impulse = [0.1 * random.uniform(), 0.01, -0.01];
            }
            let bodies = [1 + k % 20, if k % 4 == 0 { 0 } else { 1 + (k * 7 + 3) % 20 }];
            if bodies[0] == bodies[1] {
                continue;
            }
            let (normal, tangent, between) = (DVec3::Z, DVec3::X, DVec3::new(0.1, 0.0, 1.0));
            solver.add(ImpulseManifold {
                bodies,
                normal,
                tangent,
                between,
                friction: 0.5,
                restitution: 0.4,
                points,
                count,
            });
        }
        solver
    }

    /// The velocities of all bodies.
    fn velocities(solver: &SequentialImpulses) -> Vec<(DVec3, DVec3)> {
        (1..=20).map(|number| (solver.body(number).linear(), solver.body(number).angular())).collect()
    }

    fn step(solver: &mut SequentialImpulses) -> Works {
        let mut works = Works::default();
        let mut before = velocities(solver);
        solver.prepare();
        solver.warm_start();
        for (stage, relax) in [(SweepStage::First, SweepStage::Moved), (SweepStage::Next, SweepStage::Moved)] {
            works += solver.sweep(stage, ONWARD, &RULE);
            works += solver.sweep(relax, SweepOrder::Back, &RULE);
            let after = velocities(solver);
            for ((number, (v0, w0)), (v1, w1)) in (1..).zip(&before).zip(&after) {
                let body = solver.body_mut(number);
                body.set_mean_velocity((*v0 + *v1) * 0.5, (*w0 + *w1) * 0.5);
                if stage == SweepStage::First {
                    // Warm start of the next substep, by bodies.
                    body.set_velocity(*v1 + (*v1 - *v0), *w1 + (*w1 - *w0));
                }
            }
            before = after;
        }
        works += solver.end_substep(&RULE);
        works += solver.restitute(&RULE);
        works
    }

    #[test]
    fn widths_give_the_same_bits() {
        let [mut two, mut four] = [heap(LaneWidth::Two), heap(LaneWidth::Four)];
        assert_eq!(step(&mut two), step(&mut four));
        assert_eq!(two.bodies, four.bodies);
        assert_eq!(two.residual(&RULE), four.residual(&RULE));
    }

    #[test]
    fn works_are_the_change_of_energy() {
        let mut solver = heap(LaneWidth::Two);
        let before = energy(&solver);
        let works = step(&mut solver);
        let change = energy(&solver) - before;
        let sum = works.colliding_j + works.resting_j + works.friction_j;
        // The moments of all bodies are 1/2 kg m^2 about every axis.
        assert!((change - sum).abs() < 1e-12 * before.max(1.0), "{change} {sum}");
    }

    /// A stack of cubes of 1 kg and 1 m edges that fall at 1 m/s with the ground at rest.
    fn stack(width: LaneWidth, cubes: u32) -> SequentialImpulses {
        let mut solver = SequentialImpulses::with_lanes(width);
        for cube in 0..cubes {
            let body = solver.add_body(ImpulseBody::new(1.0, DMat3::IDENTITY * 6.0));
            solver.body_mut(body).set_velocity(DVec3::Z * -1.0, DVec3::ZERO);
            let mut points = [ManifoldPoint::default(); MOST_POINTS];
            for (point, (x, y)) in points.iter_mut().zip([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]) {
                point.arm = DVec3::new(x, y, -0.5);
            }
            let bodies = [body, cube];
            let (normal, tangent, between) = (DVec3::Z, DVec3::X, DVec3::Z);
            let (friction, restitution, count) = (0.5, 0.0, MOST_POINTS);
            solver.add(ImpulseManifold { bodies, normal, tangent, between, friction, restitution, points, count });
        }
        solver.prepare();
        solver
    }

    /// On a tall stack, at equal sweeps, conjugate gradients leave a smaller residual than plain sweeps; with one sweep
    /// they are one, and the width changes no bit.
    #[test]
    fn conjugate_gradients_come_nearer_to_the_law_than_plain_sweeps() {
        let rule = SweepRule { between: Softness::RIGID, with_fixed: Softness::RIGID, ..RULE };
        for (cubes, sweeps) in [(10, 20), (20, 40), (20, 80), (40, 80)] {
            let [mut plain, mut conjugate] = [stack(LaneWidth::Two, cubes), stack(LaneWidth::Two, cubes)];
            (0..sweeps).for_each(|_| {
                plain.sweep(SweepStage::Moved, ONWARD, &rule);
            });
            conjugate.sweep_conjugate(sweeps, ONWARD, &rule);
            let [plain, left] = [plain, conjugate].map(|solver| solver.residual(&rule).map);
            assert!(left < 0.5 * plain, "{cubes} cubes, {sweeps} sweeps: {left} for {plain}");
            let mut wide = stack(LaneWidth::Four, cubes);
            wide.sweep_conjugate(sweeps, ONWARD, &rule);
            assert_eq!(wide.residual(&rule).map, left);
        }
        let [mut one, mut other] = [stack(LaneWidth::Two, 5), stack(LaneWidth::Two, 5)];
        one.sweep(SweepStage::Moved, ONWARD, &rule);
        other.sweep_conjugate(1, ONWARD, &rule);
        assert_eq!(one.bodies, other.bodies);
    }

    /// In both orders a falling chain of points stands on the ground after a sweep: contacts with what does not move
    /// are the last ones. The contacts between points change places: onward the lower one is solved first, back the
    /// upper one.
    #[test]
    fn a_sweep_back_turns_the_order_of_contacts_between_bodies_that_move() {
        let rule = SweepRule { between: Softness::RIGID, with_fixed: Softness::RIGID, ..RULE };
        let of = |order: SweepOrder| {
            let mut solver = SequentialImpulses::default();
            for below in 0..3 {
                let body = solver.add_body(ImpulseBody::new(1.0, DMat3::ZERO));
                solver.body_mut(body).set_velocity(DVec3::Z * -f64::from(1 << below), DVec3::ZERO);
                solver.add(ImpulseManifold {
                    bodies: [body, below],
                    normal: DVec3::Z,
                    tangent: DVec3::X,
                    between: DVec3::ZERO,
                    friction: 0.0,
                    restitution: 0.0,
                    points: Default::default(),
                    count: 1,
                });
            }
            solver.prepare();
            solver.sweep(SweepStage::First, order, &rule);
            [1, 2, 3].map(|body| solver.body(body).linear().z)
        };
        // At -1, -2 and -4 m/s: the lower pair comes to -1.5, then the upper one to -2.75; or the upper one to -3, then
        // the lower one to -2.
        assert_eq!(of(ONWARD), [0.0, -2.75, -2.75]);
        assert_eq!(of(SweepOrder::Back), [0.0, -2.0, -3.0]);
    }

    #[test]
    fn many_sweeps_come_to_the_law() {
        let rule = SweepRule { between: Softness::RIGID, with_fixed: Softness::RIGID, ..RULE };
        for orders in [[ONWARD; 2], [SweepOrder::Back; 2], [ONWARD, SweepOrder::Back]] {
            let mut solver = heap(LaneWidth::Two);
            solver.prepare();
            for _ in 0..10_000 {
                for order in orders {
                    solver.sweep(SweepStage::First, order, &rule);
                }
            }
            let residual = solver.residual(&rule);
            assert!(residual.map < 1e-9, "{orders:?}: {residual:?}");
        }
    }
}
