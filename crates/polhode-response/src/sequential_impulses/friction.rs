//! Coulomb's friction at the points of a patch: one law for sweeps and bounces, which reads the impulses that it is
//! asked for.
//!
//! A sweep bounds the friction of its substep by the normal impulses of the substep, a bounce that of the whole step by
//! those of the whole step. `known` gives the three impulses of a point (along the normal and both tangents, N s) in
//! its rows. What the law is stands in `sweep`.

use super::batch::{Batch, PointRows};
use super::lanes::{Four, Lanes, by_place};
use super::patch::{Block, Relative, Wrench, place};

/// Brings the impulses of friction at all points of a patch to the law whose bodies move like this; the wrench takes
/// what they change by. First those of least norm under which no point
/// slips; of a patch where one of them is beyond its disc, a step of each point against its own slip, by its share.
/// `of_lanes` keeps the changes of the lanes that may change.
#[inline(always)]
pub(super) fn rub_together<L: Lanes, const N: usize>(
    rows: &mut [PointRows; N],
    (batch, part): (&Batch, usize),
    coefficient: L,
    (relative, wrench): (&Relative<L>, &mut Wrench<L>),
    known: impl Fn(&mut PointRows) -> &mut [Four; 3],
    of_lanes: impl Fn(L) -> L,
) {
    let (zero, one, share) = (L::splat(0.0), L::splat(1.0), L::splat(1.0 / N as f64));
    let places: [[L; 2]; N] = by_place([zero; 2], |i| place(&rows[i].place, part));
    let [x, y, about] = Block::of(&batch.blocks.sticking, part).times(relative.slipping);
    let (along_x, along_y, about) = (x * share, y * share, about * L::load(&batch.blocks.spread, part));
    let mut changes: [[L; 2]; N] =
        by_place([zero; 2], |i| [places[i][1] * about - along_x, -(places[i][0] * about) - along_y]);
    let mut slides = zero;
    for i in 0..N {
        let own = known(&mut rows[i]);
        let [x, y] = [1, 2].map(|k| L::load(&own[k], part) + changes[i][k - 1]);
        let limit = coefficient * L::load(&own[0], part);
        slides = L::pick_greater(x * x + y * y, limit * limit, one, slides);
    }
    if L::any_greater(slides, zero) {
        for i in 0..N {
            let rho = L::load(&rows[i].sliding_mass, part) * share;
            let sliding = rubbed(known(&mut rows[i]), part, (coefficient, rho), relative.slip(places[i]));
            for k in 0..2 {
                changes[i][k] = L::pick_greater(slides, zero, sliding[k], changes[i][k]);
            }
        }
    }
    for i in 0..N {
        let own = known(&mut rows[i]);
        for k in 0..2 {
            changes[i][k] = of_lanes(changes[i][k]);
            let impulse = L::load(&own[k + 1], part) + changes[i][k];
            impulse.store(&mut own[k + 1], part);
        }
        wrench.rub(places[i], changes[i]);
    }
}

/// The impulse of friction of the substep at the point of a patch of one, with this slip; what it changes by.
#[inline(always)]
pub(super) fn rub<L: Lanes>(row: &mut PointRows, part: usize, coefficient: L, slip: [L; 2]) -> [L; 2] {
    let change = rubbed(&row.impulse, part, (coefficient, L::load(&row.sliding_mass, part)), slip);
    for k in 0..2 {
        (L::load(&row.impulse[k + 1], part) + change[k]).store(&mut row.impulse[k + 1], part);
    }
    change
}

/// By what the impulse of friction at a point with these impulses and this slip changes, under that along the normal
/// and by `rho`.
#[inline(always)]
fn rubbed<L: Lanes>(known: &[Four; 3], part: usize, (coefficient, rho): (L, L), [slip_x, slip_y]: [L; 2]) -> [L; 2] {
    let (before_x, before_y) = (L::load(&known[1], part), L::load(&known[2], part));
    let (mut x, mut y) = (before_x - rho * slip_x, before_y - rho * slip_y);
    let limit = coefficient * L::load(&known[0], part);
    let square = x * x + y * y;
    let largest = limit * limit;
    // Most points stick: the root is taken where one of them does not.
    if L::any_greater(square, largest) {
        let scale = L::pick_greater(square, largest, limit / square.root(), L::splat(1.0));
        (x, y) = (x * scale, y * scale);
    }
    [x - before_x, y - before_y]
}
