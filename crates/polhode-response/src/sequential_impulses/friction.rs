//! Coulomb's friction at the points of a patch: one law for sweeps and bounces, which reads the impulses that it is asked for.
//!
//! A sweep bounds the friction of its substep by the normal impulses of the substep, a bounce that of the whole step by those of the whole
//! step. `known` gives the three impulses of a point (along the normal and both tangents, N s) from its rows. What the law is stands in `sweep`.

use super::batch::{Batch, PointRows};
use super::lanes::{Four, Lanes, by_place};
use super::patch::{Block, Relative, place};

/// By what the impulses of friction at all points of a patch change whose bodies move like this. First those of least norm under which no point
/// slips; of a patch where one of them is beyond its disc, a step of each point against its own slip, by its share.
#[inline(always)]
pub(super) fn of_patch<L: Lanes, const N: usize>(
    rows: &[PointRows; N],
    (batch, part): (&Batch, usize),
    coefficient: L,
    relative: &Relative<L>,
    known: impl Fn(&PointRows) -> &[Four; 3],
) -> [[L; 2]; N] {
    let (zero, one, share) = (L::splat(0.0), L::splat(1.0), L::splat(1.0 / N as f64));
    let places: [[L; 2]; N] = by_place([zero; 2], |i| place(&rows[i].place, part));
    let [x, y, about] = Block::of(&batch.blocks.sticking, part).times(relative.slipping);
    let (along_x, along_y, about) = (x * share, y * share, about * L::load(&batch.blocks.spread, part));
    let mut changes: [[L; 2]; N] =
        by_place([zero; 2], |i| [places[i][1] * about - along_x, -(places[i][0] * about) - along_y]);
    let mut slides = zero;
    for i in 0..N {
        let [normal, first, second] = known(&rows[i]);
        let [x, y] = [L::load(first, part) + changes[i][0], L::load(second, part) + changes[i][1]];
        let limit = coefficient * L::load(normal, part);
        slides = L::pick_greater(x * x + y * y, limit * limit, one, slides);
    }
    if L::any_greater(slides, zero) {
        for i in 0..N {
            let sliding = of_point(&rows[i], part, (coefficient, share), relative.slip(places[i]), &known);
            for k in 0..2 {
                changes[i][k] = L::pick_greater(slides, zero, sliding[k], changes[i][k]);
            }
        }
    }
    changes
}

/// By what the impulse of friction at a point with this slip changes, under its impulse along the normal and by a
/// share of its own mass.
#[inline(always)]
pub(super) fn of_point<L: Lanes>(
    row: &PointRows,
    part: usize,
    (coefficient, share): (L, L),
    [slip_x, slip_y]: [L; 2],
    known: impl Fn(&PointRows) -> &[Four; 3],
) -> [L; 2] {
    let [normal, first, second] = known(row);
    let (before_x, before_y) = (L::load(first, part), L::load(second, part));
    let rho = L::load(&row.sliding_mass, part) * share;
    let (mut x, mut y) = (before_x - rho * slip_x, before_y - rho * slip_y);
    let limit = coefficient * L::load(normal, part);
    let square = x * x + y * y;
    let largest = limit * limit;
    // Most points stick: the root is taken where one of them does not.
    if L::any_greater(square, largest) {
        let scale = L::pick_greater(square, largest, limit / square.root(), L::splat(1.0));
        (x, y) = (x * scale, y * scale);
    }
    [x - before_x, y - before_y]
}
