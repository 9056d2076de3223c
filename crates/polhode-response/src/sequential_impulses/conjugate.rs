//! Nonsmooth nonlinear conjugate gradients over sweeps: several sweeps of a relax stage, each followed by a step along
//! the way of the last ones.
//!
//! With `p_k` (N s) the impulses before a sweep, `S` the sweep, and `g_k = S(p_k) - p_k`,
//!
//! ```text
//! p_(k+1) = S(p_k) + b d_(k-1)      b = |g_k|^2 / |g_(k-1)|^2,   d_k = g_k + b d_(k-1)
//! b > 1:  p_(k+1) = S(p_k),  d_k = 0    (start again: the law is not smooth there)
//! ```
//!
//! The last sweep has no step after it, so that impulses obey the law at their points. The velocities of the bodies
//! take what the steps add. Sums of squares are by lanes and then in order, so that bits do not depend on the width.
//! Source: Silcowitz, Niebe and Erleben 2010, docs/REFERENCES.md. Assumption: impulses of one scene have one scale.
//! Failure: none: where steps do not help, `b > 1` leaves the plain sweeps.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody};
use super::lanes::{FOUR, Four, Lanes};
use super::patch::{Frame, Wrench, place};
use super::works::numbers;

/// What the method remembers of a point.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Memory {
    /// Impulses before the sweep, N s.
    before: [Four; 3],
    /// `d`, N s.
    direction: [Four; 3],
}

/// Impulses before a sweep are remembered.
pub(super) fn remember(points: &[PointRows], memory: &mut [Memory]) {
    for (row, own) in points.iter().zip(memory) {
        own.before = row.impulse;
    }
}

/// `|g|^2` of the last sweep.
pub(super) fn square_of_change(points: &[PointRows], memory: &[Memory]) -> f64 {
    let mut sums = [0.0; FOUR];
    for (row, own) in points.iter().zip(memory) {
        for (now, before) in row.impulse.iter().zip(&own.before) {
            for (sum, (now, before)) in sums.iter_mut().zip(now.0.iter().zip(&before.0)) {
                *sum += (now - before) * (now - before);
            }
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// No step: `d = 0`.
pub(super) fn start_again(memory: &mut [Memory]) {
    for own in memory {
        own.direction = Default::default();
    }
}

/// A step: the impulses and the velocities of the bodies take `b d`, and `d` becomes `g + b d`.
pub(super) fn step<L: Lanes>(
    bodies: &mut [ImpulseBody],
    batches: &[Batch],
    (points, memory): (&mut [PointRows], &mut [Memory]),
    b: f64,
) {
    let b = L::splat(b);
    for batch in batches {
        let range = batch.first as usize..(batch.first + batch.count) as usize;
        let (rows, memory) = (&mut points[range.clone()], &mut memory[range]);
        for part in 0..FOUR / L::WIDTH {
            let (numbers_a, numbers_b) = (numbers::<L>(&batch.a, part), numbers::<L>(&batch.b, part));
            let (mut of_a, mut of_b) = (Gathered::<L>::load(bodies, numbers_a), Gathered::<L>::load(bodies, numbers_b));
            let mut wrench = Wrench::none();
            for (row, own) in rows.iter_mut().zip(memory.iter_mut()) {
                let mut added = [L::splat(0.0); 3];
                for k in 0..3 {
                    let now = L::load(&row.impulse[k], part);
                    added[k] = b * L::load(&own.direction[k], part);
                    let change = now - L::load(&own.before[k], part);
                    (change + added[k]).store(&mut own.direction[k], part);
                    (now + added[k]).store(&mut row.impulse[k], part);
                }
                let at = place(&row.place, part);
                wrench.press(at, added[0]);
                wrench.rub(at, [added[1], added[2]]);
            }
            Frame::<L>::load(batch, part).give(&wrench, &mut of_a, &mut of_b);
            of_a.store_velocities(bodies, numbers_a);
            of_b.store_velocities(bodies, numbers_b);
        }
    }
}
