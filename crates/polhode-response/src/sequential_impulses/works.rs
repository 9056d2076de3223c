//! What impulses do: their work by kinds.
//!
//! The impulses `p` (N s) of a substep at a point do the work `p . u` (J), with `u` (m/s) the mean of the relative
//! velocities of the point before and after all impulses of the substep. Assumption: rows do not change within a step.
//! Source: algebra of kinetic energy.

use super::batch::{Batch, PointRows};
use super::body::{ImpulseBody, Twist};
use super::lanes::{FOUR, Four, Lanes};
use super::patch::{Frame, place};

/// Changes of energy by impulses, J.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Works {
    /// By normal impulses of contacts that collide.
    pub colliding_j: f64,
    /// By normal impulses of other contacts.
    pub resting_j: f64,
    /// By friction.
    pub friction_j: f64,
}

impl std::ops::AddAssign for Works {
    fn add_assign(&mut self, other: Self) {
        self.colliding_j += other.colliding_j;
        self.resting_j += other.resting_j;
        self.friction_j += other.friction_j;
    }
}

/// The same in lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct LaneWorks<L> {
    pub(super) colliding: L,
    pub(super) resting: L,
    pub(super) friction: L,
}

/// The works of all lanes: each lane's sum, then these in order.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FourWorks {
    colliding: Four,
    resting: Four,
    friction: Four,
}

impl FourWorks {
    pub(super) fn load<L: Lanes>(&self, part: usize) -> LaneWorks<L> {
        LaneWorks {
            colliding: L::load(&self.colliding, part),
            resting: L::load(&self.resting, part),
            friction: L::load(&self.friction, part),
        }
    }

    pub(super) fn store<L: Lanes>(&mut self, works: LaneWorks<L>, part: usize) {
        works.colliding.store(&mut self.colliding, part);
        works.resting.store(&mut self.resting, part);
        works.friction.store(&mut self.friction, part);
    }

    pub(super) fn sums(&self) -> Works {
        let sum = |four: &Four| (four.0[0] + four.0[1]) + (four.0[2] + four.0[3]);
        Works { colliding_j: sum(&self.colliding), resting_j: sum(&self.resting), friction_j: sum(&self.friction) }
    }
}

/// The part of the bodies' numbers of a batch that a kernel works on.
#[inline(always)]
pub(super) fn numbers<L: Lanes>(of: &[u32; FOUR], part: usize) -> &[u32] {
    &of[part * L::WIDTH..(part + 1) * L::WIDTH]
}

/// Books the impulses of a substep at a patch, along its mean velocity: `p . u` is exactly the change of the kinetic
/// energy (by algebra), with `u` the mean of the velocities before and after all impulses. Contacts that approached
/// faster than `colliding` (m/s) collide.
#[inline(always)]
pub(super) fn book<L: Lanes>(
    bodies: &[ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &mut [PointRows],
    (works, colliding): (&mut LaneWorks<L>, f64),
) {
    let (zero, faster) = (L::splat(0.0), L::splat(-colliding));
    let [mean_a, mean_b] = [&batch.a, &batch.b].map(|of| Twist::<L>::means(bodies, numbers::<L>(of, part)));
    let mean = Frame::<L>::load(batch, part).relative(&mean_a, &mean_b);
    for row in rows {
        let at = place::<L>(&row.place, part);
        let impulse = [0, 1, 2].map(|k| L::load(&row.impulse[k], part));
        let work = impulse[0] * mean.rate(at);
        let slip = mean.slip(at);
        let rate = L::load(&row.rate, part);
        works.colliding = works.colliding + L::pick_greater(faster, rate, work, zero);
        works.resting = works.resting + L::pick_greater(faster, rate, zero, work);
        works.friction = works.friction + impulse[1] * slip[0] + impulse[2] * slip[1];
        for (total, impulse) in row.total.iter_mut().zip(impulse) {
            (L::load(total, part) + impulse).store(total, part);
        }
    }
}
