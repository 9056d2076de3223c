//! What happens to contacts before, between and after the sweeps, in lanes: their masses, the start from known
//! impulses, restitution, and the totals of a step.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody};
use super::friction;
use super::lanes::{FOUR, Four, Lanes, by_place};
use super::lone_bounce::{self, Bounce};
use super::patch::{Block, Frame, Relative, Wrench, add, coupled, find_blocks, place};
use super::together::{Together, entries};
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
    let squares = rows.iter().fold(zero, |sum, row| {
        let [x, y] = place::<L>(&row.place, part);
        sum + x * x + y * y
    });
    L::pick_greater(squares, zero, one / squares, zero).store(&mut batch.blocks.spread, part);
    let pressing = Block::of(&batch.blocks.pressing, part);
    let slipping = Block::of(&batch.blocks.slipping, part);
    let relative = frame.relative(&a.twist(), &b.twist());
    for i in 0..rows.len() {
        let (before, rest) = rows.split_at_mut(i);
        let row = &mut rest[0];
        let at = place::<L>(&row.place, part);
        let own = pressing.times([one, at[1], -at[0]]);
        for (other, with) in before.iter().zip(&mut row.with) {
            let [x, y] = place::<L>(&other.place, part);
            (own[0] + y * own[1] - x * own[2]).store(with, part);
        }
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

/// Most passes of a sweep, over contacts that collided or over joints, forth and back in turn (8 to 64): friction of a
/// bounce changes the speed at which it parts, and that of its neighbours; where a limit is, joints take as many.
pub(super) const MOST_PASSES: usize = 16;

/// Passes end with one that does less than this part of what the largest has done (no unit, 1e-6 to 1e-2): a part of
/// the energy of a blow.
pub(super) const LAST_BOUNCE: f64 = 1e-4;

/// What patches do in a pass that were struck at one point alone: each bounces once, as an impact of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Alone {
    Bounce,
    HaveBounced,
}

/// Which patches bounce as impacts of their own.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bouncing<'a> {
    /// Whether those that are struck at one point alone have bounced already.
    pub(super) has_begun: bool,
    /// Of each body, whether joints pass on what it is given: it bounces as one of several. None where the list is
    /// empty.
    pub(super) jointed: &'a [bool],
}

impl Bouncing<'_> {
    const fn in_pass(&self, pass: usize) -> Alone {
        if pass == 0 && !self.has_begun { Alone::Bounce } else { Alone::HaveBounced }
    }

    /// Whether joints hold a body of a patch.
    fn are_jointed(&self, batch: &Batch, lane: usize) -> bool {
        let is = |body: u32| self.jointed.get(body as usize).copied().unwrap_or(false);
        is(batch.a[lane]) || is(batch.b[lane])
    }
}

/// Contacts that collided, faster than this (m/s), part again. Returns the changes of energy.
pub(super) fn part_again<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    points: &mut [PointRows],
    (colliding, bouncing): (f64, &Bouncing<'_>),
) -> Works {
    let (mut all, mut largest) = (Works::default(), 0.0_f64);
    let collided: Vec<&Batch> = batches.iter().filter(|batch| may_bounce(batch, points, colliding)).collect();
    for pass in 0..MOST_PASSES {
        let alone = bouncing.in_pass(pass);
        let mut works = FourWorks::default();
        for batch in &collided {
            let rows = &mut points[batch.first as usize..(batch.first + batch.count) as usize];
            for part in 0..FOUR / L::WIDTH {
                let own = works.load::<L>(part);
                works.store(restitute::<L>(bodies, (batch, part), rows, (own, colliding, (alone, bouncing))), part);
            }
        }
        let works = works.sums();
        all += works;
        let done = works.colliding_j.abs() + works.friction_j.abs();
        largest = largest.max(done);
        if done <= LAST_BOUNCE * largest {
            break;
        }
    }
    all
}

/// Whether a point of a batch has collided, faster than this (m/s), whose bounce is not known yet.
pub(super) fn may_bounce(batch: &Batch, points: &[PointRows], colliding: f64) -> bool {
    let rows = &points[batch.first as usize..(batch.first + batch.count) as usize];
    let has_collided = |lane: usize| rows.iter().any(|row| row.rate.0[lane] < -colliding && row.total[0].0[lane] > 0.0);
    (0..FOUR).any(|lane| batch.restitution.0[lane] >= 0.0 && has_collided(lane))
}

#[inline(always)]
fn restitute<L: Lanes>(
    bodies: &mut [ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &mut [PointRows],
    (mut works, faster, alone): (LaneWorks<L>, f64, (Alone, &Bouncing<'_>)),
) -> LaneWorks<L> {
    let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
    let (mut a, mut b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
    let frame = Frame::<L>::load(batch, part);
    let relative = frame.relative(&a.twist(), &b.twist());
    let mut wrench = Wrench::none();
    let of = (batch, part, L::splat(-faster), alone);
    let [colliding, friction] = match rows.len() {
        1 => bounce::<L, 1>(rows, of, relative, &mut wrench),
        2 => bounce::<L, 2>(rows, of, relative, &mut wrench),
        3 => bounce::<L, 3>(rows, of, relative, &mut wrench),
        _ => bounce::<L, 4>(rows, of, relative, &mut wrench),
    };
    works.colliding = works.colliding + colliding;
    works.friction = works.friction + friction;
    frame.give(&wrench, &mut a, &mut b);
    a.store_velocities(bodies, numbers_a);
    b.store_velocities(bodies, numbers_b);
    works
}

/// The points of a patch that collided part again, all at once: `u+ = -e u-` where their impulse of the whole step
/// stays positive, since no contact pulls. Before that their friction in the whole step is brought to its law, under
/// the normal impulses of the whole step: a bounce has friction as the impact before it.
/// Returns the changes of energy, by normal impulses and by friction.
#[inline(always)]
fn bounce<L: Lanes, const N: usize>(
    rows: &mut [PointRows],
    (batch, part, faster, alone): (&Batch, usize, L, (Alone, &Bouncing<'_>)),
    mut relative: Relative<L>,
    wrench: &mut Wrench<L>,
) -> [L; 2] {
    let (zero, half, one) = (L::splat(0.0), L::splat(0.5), L::splat(1.0));
    let Some(rows) = rows.first_chunk_mut::<N>() else { return [zero; 2] };
    let restitution = L::load(&batch.restitution, part);
    let before: [L; N] = by_place(zero, |i| L::load(&rows[i].rate, part));
    let mut may = by_place(zero, |i| {
        let has_pressed = L::pick_greater(L::load(&rows[i].total[0], part), zero, one, zero);
        // Those that have bounced already have a negative restitution.
        let bounces = L::pick_greater(zero, restitution, zero, has_pressed);
        L::pick_greater(faster, before[i], bounces, zero)
    });
    let any = |may: &[L; N]| may.iter().fold(zero, |any, may| any.greater(*may));
    if !L::any_greater(any(&may), zero) {
        return [zero; 2];
    }
    let alone = bounce_alone(rows, (batch, part, &mut may), (&relative, alone), wrench);
    let any = any(&may);
    if !L::any_greater(any, zero) {
        return alone;
    }
    let rubbed = rub::<L, N>(rows, (batch, part, any), &mut relative, wrench);
    let known: [L; N] = by_place(zero, |i| L::load(&rows[i].total[0], part));
    let rates: [L; N] = by_place(zero, |i| relative.rate(place(&rows[i].place, part)));
    let matrix: [[L; N]; N] = by_place([zero; N], |i| entries(&rows[i], i, part));
    let wanted = by_place(zero, |i| rates[i] + restitution * before[i]);
    let given = Together { matrix, known, wanted, give: [zero; N], may }.change();
    let mut work = zero;
    for i in 0..N {
        let others = (0..i).fold(half * matrix[i][i] * given[i], |rate, j| rate + matrix[i][j] * given[j]);
        work = work + given[i] * (rates[i] + others);
        (known[i] + given[i]).store(&mut rows[i].total[0], part);
        wrench.press(place(&rows[i].place, part), given[i]);
    }
    [alone[0] + work, alone[1] + rubbed]
}

/// The same of patches that were struck at one point alone, which then may not bounce any more.
#[inline(always)]
fn bounce_alone<L: Lanes, const N: usize>(
    rows: &mut [PointRows; N],
    (batch, part, may): (&Batch, usize, &mut [L; N]),
    (relative, (alone, bouncing)): (&Relative<L>, (Alone, &Bouncing<'_>)),
    wrench: &mut Wrench<L>,
) -> [L; 2] {
    let zero = L::splat(0.0);
    let mut works = [Four::default(); 2];
    for i in 0..N {
        let place = place(&rows[i].place, part);
        let slip = relative.slip(place);
        let now = [relative.rate(place), slip[0], slip[1]];
        let mut changes = [Four::default(); 3];
        let mut is_alone = Four::default();
        for lane in (0..L::WIDTH).filter(|&lane| may[i].lane(lane) > 0.0) {
            let own = part * L::WIDTH + lane;
            let is_one_of_several = (0..N).any(|j| j != i && rows[j].total[0].0[own] > 0.0);
            if is_one_of_several || bouncing.are_jointed(batch, own) {
                continue;
            }
            is_alone.0[own] = 1.0;
            if alone == Alone::HaveBounced {
                continue;
            }
            let Bounce { change, works: done } =
                lone_bounce::bounce(batch, &rows[i], own, now.map(|rate| rate.lane(lane))).unwrap_or_default();
            changes.iter_mut().zip(change).for_each(|(four, value)| four.0[own] = value);
            works.iter_mut().zip(done).for_each(|(four, value)| four.0[own] = value);
        }
        let [normal, first, second] = [0, 1, 2].map(|k| L::load(&changes[k], part));
        wrench.press(place, normal);
        wrench.rub(place, [first, second]);
        for (total, change) in rows[i].total.iter_mut().zip(&changes) {
            (L::load(total, part) + L::load(change, part)).store(total, part);
        }
        may[i] = L::pick_greater(L::load(&is_alone, part), zero, zero, may[i]);
    }
    works.map(|work| L::load(&work, part))
}

/// Brings the friction of the whole step at a patch to its law, in the lanes of `any`. Returns its work.
#[inline(always)]
fn rub<L: Lanes, const N: usize>(
    rows: &mut [PointRows; N],
    (batch, part, any): (&Batch, usize, L),
    relative: &mut Relative<L>,
    wrench: &mut Wrench<L>,
) -> L {
    let (zero, half) = (L::splat(0.0), L::splat(0.5));
    let coefficient = L::load(&batch.friction, part);
    let mut own = Wrench::none();
    let moved = (&*relative, &mut own);
    let of_lanes = |change| L::pick_greater(any, zero, change, zero);
    friction::rub_together(rows, (batch, part), coefficient, moved, |row| &mut row.total, of_lanes);
    let given = own.slipping;
    wrench.slipping = add(wrench.slipping, given);
    let before = relative.slipping;
    relative.slipping = add(before, Block::of(&batch.blocks.slipping, part).times(given));
    relative.pressing = add(relative.pressing, coupled(&batch.blocks.coupling, part, given));
    (0..3).fold(zero, |work, k| work + given[k] * half * (before[k] + relative.slipping[k]))
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
