//! What happens to contacts before, between and after the sweeps, in lanes: their masses, the start from known impulses, restitution,
//! and the totals of a step.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody, Twist};
use super::lanes::{FOUR, Lanes, Vectors};
use super::works::{FourWorks, Frame, LaneWorks, Works, book, numbers};

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
        let velocity = a.linear - b.linear + a.angular.cross(arm) - b.angular.cross(arm_b);
        frame.normal.dot(velocity).store(&mut row.rate, part);
    }
}

/// Gives the impulses that are known from before, at the start of a step.
pub(super) fn warm_start<L: Lanes>(bodies: &mut [ImpulseBody], batches: &[Batch], points: &[PointRows]) {
    for batch in batches {
        let rows = &points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
            let (mut a, mut b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
            let frame = Frame::<L>::load(batch, part);
            for row in rows {
                let arm = Vectors::<L>::load(&row.arm, part);
                let [normal, x, y] = [0, 1, 2].map(|k| L::load(&row.impulse[k], part));
                let impulse = frame.vector(normal, x, y);
                a.take(impulse, arm);
                b.give(impulse, arm + frame.between);
            }
            a.store_velocities(bodies, numbers_a);
            b.store_velocities(bodies, numbers_b);
        }
    }
}

/// A pass over all batches in which contacts that collided, faster than this (m/s), part again. Returns the change of energy.
pub(super) fn part_again<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    colliding: f64,
) -> Works {
    let mut works = FourWorks::default();
    for batch in batches {
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let own = works.load::<L>(part);
            works.store(restitute::<L>(bodies, (batch, part), rows, (own, colliding)), part);
        }
    }
    works.sums()
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

/// Ends a substep: adds its impulses to the totals. Returns what they did.
pub(super) fn end<L: Lanes>(
    bodies: &[ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    colliding: f64,
) -> Works {
    let mut works = FourWorks::default();
    for batch in batches {
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let mut own = works.load::<L>(part);
            let frame = Frame::<L>::load(batch, part);
            let [mean_a, mean_b] = [&batch.a, &batch.b].map(|of| Twist::<L>::means(bodies, numbers::<L>(of, part)));
            for row in rows.iter_mut() {
                let arm = Vectors::<L>::load(&row.arm, part);
                let impulse = [0, 1, 2].map(|k| L::load(&row.impulse[k], part));
                let mean = mean_a.at(arm) - mean_b.at(arm + frame.between);
                book(&mut own, (row, part), (&frame, mean, impulse), L::splat(-colliding));
            }
            works.store(own, part);
        }
    }
    works.sums()
}
