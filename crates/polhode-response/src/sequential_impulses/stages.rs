//! What happens to contacts before, between and after the sweeps, in lanes: their masses, the start from known impulses, restitution,
//! and the totals of a step.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody};
use super::lanes::{FOUR, Lanes, Vectors};
use super::sweep::{FourWorks, Frame, LaneWorks, Works, numbers};
use polhode_spatial::DVec3;

/// Effective masses of all points, and their rates at the start of the step.
///
/// `K = (1/m_A + 1/m_B) 1 + (r_A x .)^T I_A^-1 (r_A x .) + (r_B x .)^T I_B^-1 (r_B x .)`, 1/kg.
pub(super) fn prepare<L: Lanes>(bodies: &[ImpulseBody], batches: &[Batch], points: &mut [PointRows]) {
    for batch in batches {
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            prepare_part::<L>(bodies, (batch, part), rows);
        }
    }
}

#[inline(always)]
fn prepare_part<L: Lanes>(bodies: &[ImpulseBody], (batch, part): (&Batch, usize), rows: &mut [PointRows]) {
    let a = Gathered::<L>::load(bodies, numbers::<L>(&batch.a, part));
    let b = Gathered::<L>::load(bodies, numbers::<L>(&batch.b, part));
    let frame = Frame::<L>::load(batch, part);
    let (zero, half, one) = (L::splat(0.0), L::splat(0.5), L::splat(1.0));
    let inverse_masses = a.inverse_mass + b.inverse_mass;
    for row in rows {
        let arm = Vectors::<L>::load(&row.arm, part);
        let arm_b = arm + frame.between;
        let axes = [frame.normal, frame.first, frame.second];
        let (at_a, at_b) = (axes.map(|axis| arm.cross(axis)), axes.map(|axis| arm_b.cross(axis)));
        let (of_a, of_b) =
            (at_a.map(|moment| a.inverse_inertia.times(moment)), at_b.map(|moment| b.inverse_inertia.times(moment)));
        let k = |i: usize, j: usize| of_a[i].dot(at_a[j]) + of_b[i].dot(at_b[j]);
        let nn = inverse_masses + k(0, 0);
        let (xx, xy, yy) = (inverse_masses + k(1, 1), k(1, 2), inverse_masses + k(2, 2));
        let half_difference = half * (xx - yy);
        let largest = half * (xx + yy) + (half_difference * half_difference + xy * xy).root();
        nn.store(&mut row.stiffness, part);
        L::pick_greater(nn, zero, one / nn, zero).store(&mut row.mass, part);
        L::pick_greater(largest, zero, one / largest, zero).store(&mut row.sliding_mass, part);
        k(0, 1).store(&mut row.coupling[0], part);
        k(0, 2).store(&mut row.coupling[1], part);
        xx.store(&mut row.tangential[0], part);
        xy.store(&mut row.tangential[1], part);
        yy.store(&mut row.tangential[2], part);
        let velocity = a.linear - b.linear + a.angular.cross(arm) - b.angular.cross(arm_b);
        frame.normal.dot(velocity).store(&mut row.rate, part);
    }
}

/// Which impulses a pass over all points gives.
#[derive(Debug, Clone, Copy)]
pub(super) enum Pass {
    /// Those that are known from before, at the start of a substep.
    WarmStart,
    /// Those by which colliding contacts, faster than this (m/s), part again.
    Restitution(f64),
}

/// A pass over all batches that gives impulses. Returns the change of energy.
pub(super) fn give<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    (pass, colliding): (Pass, f64),
) -> Works {
    let mut works = FourWorks::default();
    for batch in batches {
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let own = works.load::<L>(part);
            let given = match pass {
                Pass::WarmStart => warm_start::<L>(bodies, (batch, part), rows, (own, colliding)),
                Pass::Restitution(faster) => restitute::<L>(bodies, (batch, part), rows, (own, faster)),
            };
            works.store(given, part);
        }
    }
    works.sums()
}

#[inline(always)]
fn warm_start<L: Lanes>(
    bodies: &mut [ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &[PointRows],
    (mut works, colliding): (LaneWorks<L>, f64),
) -> LaneWorks<L> {
    let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
    let (mut a, mut b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
    let frame = Frame::<L>::load(batch, part);
    let (zero, half, colliding) = (L::splat(0.0), L::splat(0.5), L::splat(-colliding));
    for row in rows {
        let arm = Vectors::<L>::load(&row.arm, part);
        let arm_b = arm + frame.between;
        let velocity = a.linear - b.linear + a.angular.cross(arm) - b.angular.cross(arm_b);
        let [normal, x, y] = [0, 1, 2].map(|k| L::load(&row.impulse[k], part));
        let [k_x, k_y] = [0, 1].map(|k| L::load(&row.coupling[k], part));
        let [xx, xy, yy] = [0, 1, 2].map(|k| L::load(&row.tangential[k], part));
        let work = normal * (frame.normal.dot(velocity) + half * L::load(&row.stiffness, part) * normal);
        let rate = L::load(&row.rate, part);
        works.colliding = works.colliding + L::pick_greater(colliding, rate, work, zero);
        works.resting = works.resting + L::pick_greater(colliding, rate, zero, work);
        let (slip_x, slip_y) = (frame.first.dot(velocity) + k_x * normal, frame.second.dot(velocity) + k_y * normal);
        let change = x * (xx * x + xy * y) + y * (xy * x + yy * y);
        works.friction = works.friction + x * slip_x + y * slip_y + half * change;
        let impulse = frame.vector(normal, x, y);
        a.take(impulse, arm);
        b.give(impulse, arm_b);
    }
    a.store_velocities(bodies, numbers_a);
    b.store_velocities(bodies, numbers_b);
    works
}

#[inline(always)]
fn restitute<L: Lanes>(
    bodies: &mut [ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &mut [PointRows],
    (mut works, faster): (LaneWorks<L>, f64),
) -> LaneWorks<L> {
    let restitution = L::load(&batch.restitution, part);
    let (zero, half, faster) = (L::splat(0.0), L::splat(0.5), L::splat(-faster));
    let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
    let (mut a, mut b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
    let frame = Frame::<L>::load(batch, part);
    for row in rows {
        let arm = Vectors::<L>::load(&row.arm, part);
        let arm_b = arm + frame.between;
        let velocity = a.linear - b.linear + a.angular.cross(arm) - b.angular.cross(arm_b);
        let rate = L::load(&row.rate, part);
        let (now, total) = (frame.normal.dot(velocity), L::load(&row.total[0], part));
        let wanted = L::load(&row.mass, part) * (-(now + restitution * rate));
        // No contact pulls: the impulse of the whole step stays positive.
        let possible = wanted.greater(-total);
        let bounces = L::pick_greater(total, zero, possible, zero);
        let bounces = L::pick_greater(restitution, zero, bounces, zero);
        let given = L::pick_greater(faster, rate, bounces, zero);
        (total + given).store(&mut row.total[0], part);
        works.colliding = works.colliding + given * (now + half * L::load(&row.stiffness, part) * given);
        let impulse = frame.normal.times(given);
        a.take(impulse, arm);
        b.give(impulse, arm_b);
    }
    a.store_velocities(bodies, numbers_a);
    b.store_velocities(bodies, numbers_b);
    works
}

/// Adds the impulses of a substep to the totals.
pub(super) fn add_to_totals<L: Lanes>(points: &mut [PointRows]) {
    for row in points {
        for k in 0..row.total.len() {
            for part in 0..FOUR / L::WIDTH {
                let sum = L::load(&row.total[k], part) + L::load(&row.impulse[k], part);
                sum.store(&mut row.total[k], part);
            }
        }
    }
}

/// What the totals of contacts with immovable bodies did along a change of velocity (m/s) that all movable bodies had at the
/// start of each substep (a kick by gravity): its half is the part of the works that belongs to the kick, since over a substep an impulse
/// acts along the mean of the velocities before the kick and at the end.
pub(super) fn works_of_kick<L: Lanes>(batches: &[Batch], points: &[PointRows], kick: DVec3, colliding: f64) -> Works {
    let mut works = FourWorks::default();
    let kick = Vectors { x: L::splat(kick.x), y: L::splat(kick.y), z: L::splat(kick.z) };
    let (zero, half, colliding) = (L::splat(0.0), L::splat(0.5), L::splat(-colliding));
    for batch in batches {
        let rows = &points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let mut own = works.load::<L>(part);
            let frame = Frame::<L>::load(batch, part);
            let side = half * L::load(&batch.side, part);
            let [n, x, y] = [frame.normal, frame.first, frame.second].map(|axis| side * axis.dot(kick));
            for row in rows {
                let work = n * L::load(&row.total[0], part);
                let rate = L::load(&row.rate, part);
                own.colliding = own.colliding + L::pick_greater(colliding, rate, work, zero);
                own.resting = own.resting + L::pick_greater(colliding, rate, zero, work);
                own.friction = own.friction + x * L::load(&row.total[1], part) + y * L::load(&row.total[2], part);
            }
            works.store(own, part);
        }
    }
    works.sums()
}
