//! Bounces of bodies that joints hold: what a contact gives one of them the joints pass on, so that it parts more
//! slowly than it would alone, and the law of its impact is that of all of them together.
//!
//! The bodies that joints connect are an assembly. Where a single point presses on it, its impact is resolved as that
//! of one contact (`lone_bounce`), with the matrix `K` (1/kg) of what an impulse at the point does to its velocity
//! while the joints hold: three unit impulses, each followed by the joints. Where several points press, contacts and
//! joints come to their laws in turns, until neither does much any more.
//!
//! Assumption: of joints that close loops, and of limits, `K` knows nothing; assemblies with such a joint take turns.
//! Failure: large ratios of masses need more turns than there are, where an assembly is struck at several points.

use super::SequentialImpulses;
use super::batch::{Batch, Batches, PointRows};
use super::body::ImpulseBody;
use super::joint::JointLaw;
use super::joints::JointImpulses;
use super::lanes::{FOUR, Four};
use super::lone_bounce::{self, Bounce};
use super::stages::{LAST_BOUNCE, MOST_PASSES};
use super::sweep::SweepRule;
use super::works::Works;
use crate::impact::friction::CollisionMatrix;
use polhode_spatial::{DVec3, DisjointSets};

/// Marks a patch whose bounce is done (no unit).
const HAS_BOUNCED: f64 = -1.0;

/// A point that alone presses on its assemblies: its batch, lane and row.
#[derive(Debug, Clone, Copy)]
struct Point {
    batch: usize,
    lane: usize,
    row: usize,
}

/// Where a point acts: its bodies, its arms from their centres of mass (m), and its axes.
#[derive(Debug, Clone, Copy)]
struct Site {
    bodies: [u32; 2],
    arms: [DVec3; 2],
    axes: [DVec3; 3],
}

impl Site {
    fn of(batch: &Batch, row: &PointRows, lane: usize) -> Self {
        let vector = |of: &[Four; 3]| DVec3::from_array(of.map(|four| four.0[lane]));
        let (normal, first) = (vector(&batch.normal), vector(&batch.tangent));
        let second = normal.cross(first);
        let arm = vector(&batch.arm) + first * row.place[0].0[lane] + second * row.place[1].0[lane];
        let bodies = [batch.a[lane], batch.b[lane]];
        Self { bodies, arms: [arm, arm + vector(&batch.between)], axes: [normal, first, second] }
    }

    /// The velocity of A relative to B there, along the axes.
    fn velocity(&self, bodies: &[ImpulseBody]) -> [f64; 3] {
        let [a, b] = [0, 1].map(|side| {
            let body = &bodies[self.bodies[side] as usize];
            body.linear() + body.angular().cross(self.arms[side])
        });
        self.axes.map(|axis| axis.dot(a - b))
    }

    /// A takes an impulse there, B the opposite.
    fn give(&self, bodies: &mut [ImpulseBody], impulse: [f64; 3]) {
        let along: DVec3 = self.axes.iter().zip(impulse).map(|(axis, part)| *axis * part).sum();
        for (side, impulse) in [(0, along), (1, -along)] {
            let body = &mut bodies[self.bodies[side] as usize];
            let linear = body.linear() + impulse * body.inverse_mass();
            let angular = body.angular() + body.inverse_inertia() * self.arms[side].cross(impulse);
            body.set_velocity(linear, angular);
        }
    }
}

impl JointImpulses {
    /// Gives colliding contacts the impulses by which they part again, at the end of a step whose totals are complete,
    /// while the joints hold. By the first rule contacts collide, by the second one the joints hold. Returns the works
    /// of all; those of joints are of the collision.
    pub fn bounce(&mut self, solver: &mut SequentialImpulses, [soft, relax]: [&SweepRule; 2]) -> Works {
        let mut all = Works::default();
        let colliding = soft.colliding;
        if !solver.has_collided(colliding) {
            return all;
        }
        let jointed = self.jointed(solver);
        self.begin_impact();
        all.colliding_j += self.hold(solver, relax);
        all += self.bounce_single(solver, colliding, &jointed);
        all.colliding_j += self.hold(solver, relax);
        let mut largest = 0.0_f64;
        for turn in 0..MOST_PASSES {
            let bounced = solver.part_again(colliding, &jointed, turn > 0);
            all += bounced;
            all.colliding_j += self.hold(solver, relax);
            let done = bounced.colliding_j.abs() + bounced.friction_j.abs();
            largest = largest.max(done);
            if done <= LAST_BOUNCE * largest {
                break;
            }
        }
        self.end_impact();
        all
    }

    /// Of each body, whether a joint holds it.
    fn jointed(&self, solver: &SequentialImpulses) -> Vec<bool> {
        let mut jointed = vec![false; solver.bodies.len()];
        for body in self.joints.iter().flat_map(|joint| joint.bodies) {
            jointed[body as usize] = solver.bodies[body as usize].is_moved();
        }
        jointed
    }

    /// The assemblies of a single point bounce.
    fn bounce_single(&mut self, solver: &mut SequentialImpulses, colliding: f64, jointed: &[bool]) -> Works {
        let points = self.single_points(solver, colliding, jointed);
        let mut works = Works::default();
        if points.is_empty() {
            return works;
        }
        let matrices = self.matrices(solver, &points);
        for (point, matrix) in points.iter().zip(matrices) {
            let Batches { list, points: rows, .. } = &mut solver.batches;
            let batch = &mut list[point.batch];
            let row = &mut rows[batch.first as usize + point.row];
            let site = Site::of(batch, row, point.lane);
            let now = site.velocity(&solver.bodies);
            let Ok(collision) = CollisionMatrix::new(matrix) else { continue };
            let Some(Bounce { change, .. }) = lone_bounce::bounce_with(collision, (batch, row, point.lane), now) else {
                continue;
            };
            site.give(&mut solver.bodies, change);
            let after = site.velocity(&solver.bodies);
            let work = |k: usize| 0.5 * change[k] * (now[k] + after[k]);
            works.colliding_j += work(0);
            works.friction_j += work(1) + work(2);
            row.total.iter_mut().zip(change).for_each(|(total, change)| total.0[point.lane] += change);
            batch.restitution.0[point.lane] = HAS_BOUNCED;
        }
        works
    }

    /// The points that have collided and alone press on their assemblies, of which trees hold at least one.
    fn single_points(&self, solver: &SequentialImpulses, colliding: f64, jointed: &[bool]) -> Vec<Point> {
        let mut sets = DisjointSets::new(solver.bodies.len());
        for [a, b] in self.joints.iter().map(|joint| joint.bodies.map(|body| body as usize)) {
            if jointed[a] && jointed[b] {
                sets.join(a, b);
            }
        }
        // Points that press on each assembly, at its first body; more than one where a joint closes a loop.
        let mut counts = vec![0_usize; solver.bodies.len()];
        let mut pressing = Vec::new();
        for (place, batch) in solver.batches.list.iter().enumerate() {
            let rows = &solver.batches.points[batch.first as usize..(batch.first + batch.count) as usize];
            for (number, row) in rows.iter().enumerate() {
                for lane in (0..FOUR).filter(|&lane| row.total[0].0[lane] > 0.0) {
                    let bodies = [batch.a[lane], batch.b[lane]].map(|body| body as usize);
                    let moved = bodies.into_iter().filter(|&body| solver.bodies[body].is_moved());
                    moved.for_each(|body| counts[sets.smallest(body)] += 1);
                    if row.rate.0[lane] < -colliding && bodies.iter().any(|&body| jointed[body]) {
                        pressing.push((Point { batch: place, lane, row: number }, bodies));
                    }
                }
            }
        }
        for (number, joint) in self.joints.iter().enumerate() {
            if joint.law == JointLaw::Hold && !self.trees.has(number) {
                joint.bodies.iter().for_each(|&body| counts[sets.smallest(body as usize)] = usize::MAX);
            }
        }
        let mut is_free = |body: usize| !solver.bodies[body].is_moved() || counts[sets.smallest(body)] == 1;
        pressing.retain(|(_, bodies)| bodies.iter().all(|&body| is_free(body)));
        pressing.into_iter().map(|(point, _)| point).collect()
    }

    /// What unit impulses along the axes of each point do to its velocity while the joints hold, 1/kg. No two points
    /// are of one assembly.
    fn matrices(&mut self, solver: &SequentialImpulses, points: &[Point]) -> Vec<[[f64; 3]; 3]> {
        let mut still = solver.bodies.clone();
        for body in &mut still {
            body.set_velocity(DVec3::ZERO, DVec3::ZERO);
        }
        let site = |point: &Point| {
            let batch = &solver.batches.list[point.batch];
            Site::of(batch, &solver.batches.points[batch.first as usize + point.row], point.lane)
        };
        let sites: Vec<Site> = points.iter().map(site).collect();
        let mut matrices = vec![[[0.0; 3]; 3]; points.len()];
        for axis in 0..3 {
            let mut bodies = still.clone();
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            for site in &sites {
                site.give(&mut bodies, unit);
            }
            self.trees.solve(&mut bodies, |_| 0.0);
            for (site, matrix) in sites.iter().zip(&mut matrices) {
                matrix[axis] = site.velocity(&bodies);
            }
        }
        // Trees yield a little where their rows depend on each other.
        let mean = |matrix: &[[f64; 3]; 3]| [0, 1, 2].map(|i| [0, 1, 2].map(|j| 0.5 * (matrix[i][j] + matrix[j][i])));
        matrices.iter().map(mean).collect()
    }
}
