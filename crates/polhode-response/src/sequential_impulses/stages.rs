//! What happens to contacts before, between and after the sweeps, in lanes: their masses, the start from known impulses, restitution,
//! and the totals of a step.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody};
use super::lanes::{FOUR, Lanes};
use super::patch::{Block, Frame, Wrench, add, find_blocks, place};
use super::works::{FourWorks, LaneWorks, Works, book, numbers};

/// Effective masses of all patches and points, and their rates at the start of the step.
pub(super) fn prepare<L: Lanes>(bodies: &[ImpulseBody], batches: &mut [Batch], points: &mut [PointRows]) {
    for batch in batches {
        let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            prepare_part::<L>(bodies, (batch, part), rows);
        }
    }
}

#[inline(always)]
fn prepare_part<L: Lanes>(bodies: &[ImpulseBody], (batch, part): (&mut Batch, usize), rows: &mut [PointRows]) {
    let a = Gathered::<L>::load(bodies, numbers::<L>(&batch.a, part));
    let b = Gathered::<L>::load(bodies, numbers::<L>(&batch.b, part));
    let frame = Frame::<L>::load(batch, part);
    let (zero, half, one) = (L::splat(0.0), L::splat(0.5), L::splat(1.0));
    find_blocks(&frame, (&a, &b), (&mut batch.blocks, part));
    let pressing = Block::of(&batch.blocks.pressing, part);
    let slipping = Block::of(&batch.blocks.slipping, part);
    let relative = frame.relative(&a.twist(), &b.twist());
    for row in rows {
        let at = place::<L>(&row.place, part);
        let nn = pressing.of_normal(at);
        let [xx, xy, yy] = slipping.of_tangents(at);
        let half_difference = half * (xx - yy);
        let largest = half * (xx + yy) + (half_difference * half_difference + xy * xy).root();
        nn.store(&mut row.stiffness, part);
        L::pick_greater(nn, zero, one / nn, zero).store(&mut row.mass, part);
        L::pick_greater(largest, zero, one / largest, zero).store(&mut row.sliding_mass, part);
        relative.rate(at).store(&mut row.rate, part);
    }
}

/// Gives the impulses that are known from before, at the start of a step.
pub(super) fn warm_start<L: Lanes>(bodies: &mut [ImpulseBody], batches: &[Batch], points: &[PointRows]) {
    for batch in batches {
        let rows = &points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
            let (mut a, mut b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
            let mut wrench = Wrench::none();
            for row in rows {
                let at = place(&row.place, part);
                let [normal, x, y] = [0, 1, 2].map(|k| L::load(&row.impulse[k], part));
                wrench.press(at, normal);
                wrench.rub(at, [x, y]);
            }
            Frame::<L>::load(batch, part).give(&wrench, &mut a, &mut b);
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
    let block = Block::of(&batch.blocks.pressing, part);
    let mut relative = frame.relative(&a.twist(), &b.twist());
    let mut wrench = Wrench::none();
    for row in rows {
        let at = place(&row.place, part);
        let rate = L::load(&row.rate, part);
        let (now, total) = (relative.rate(at), L::load(&row.total[0], part));
        let wanted = L::load(&row.mass, part) * (-(now + restitution * rate));
        // No contact pulls: the impulse of the whole step stays positive.
        let possible = wanted.greater(-total);
        let bounces = L::pick_greater(total, zero, possible, zero);
        let bounces = L::pick_greater(restitution, zero, bounces, zero);
        let given = L::pick_greater(faster, rate, bounces, zero);
        (total + given).store(&mut row.total[0], part);
        works.colliding = works.colliding + given * (now + half * L::load(&row.stiffness, part) * given);
        relative.pressing = add(relative.pressing, block.times(wrench.press(at, given)));
    }
    frame.give(&wrench, &mut a, &mut b);
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
            book::<L>(bodies, (batch, part), rows, (&mut own, colliding));
            works.store(own, part);
        }
    }
    works.sums()
}
