//! The bounce of a patch that was struck at one point: the impact with friction of its bodies alone, followed along its
//! normal impulse (Routh, Stronge), so that slip stops, turns and reverses as in the other tiers.
//!
//! What the sweeps of the step have done at the point is what stops it, inelastically and all at once. So the velocity
//! without it is `u_0 = u - K p` with the impulse `p` of the whole step, along the normal that at the start of the
//! step; the impact from `u_0` is resolved (`crate::impact::friction`), and the impulses become those which leave its
//! velocity. Other contacts of the bodies are as they are: of several that are struck at once each bounces in its turn.
//! Failure: an impact that is not resolved leaves the impulses as they are.

use super::batch::{Batch, PointRows};
use crate::impact::friction::{CollisionMatrix, RestitutionLaw, SingleFrictionalImpact};

/// What changes at a point.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Bounce {
    /// Its impulses along the normal and both tangents, N s.
    pub(super) change: [f64; 3],
    /// What these do along the normal, and by friction, J.
    pub(super) works: [f64; 2],
}

/// The bounce of a point whose bodies move like this (m/s, along the normal and both tangents). None where it does not
/// part again.
pub(super) fn bounce(batch: &Batch, row: &PointRows, lane: usize, now: [f64; 3]) -> Option<Bounce> {
    bounce_with(collision_matrix(batch, row, lane)?, (batch, row, lane), now)
}

/// The same where an impulse at the point does this to its velocity.
pub(super) fn bounce_with(
    collision: CollisionMatrix,
    (batch, row, lane): (&Batch, &PointRows, usize),
    now: [f64; 3],
) -> Option<Bounce> {
    let known = row.total.map(|four| four.0[lane]);
    let given = collision.times(known);
    let before = row.rate.0[lane];
    let impact = SingleFrictionalImpact {
        collision,
        velocity_before: [before, now[1] - given[1], now[2] - given[2]],
        friction: batch.friction.0[lane],
        restitution: batch.restitution.0[lane],
        law: RestitutionLaw::Stronge,
    };
    let impulse = impact.resolve().ok()?.impulse;
    // What forces have done along the normal since the start of the step is taken by the contact, too.
    let held = (before - (now[0] - given[0])) / collision.entries()[0][0];
    let change = [impulse[0] + held - known[0], impulse[1] - known[1], impulse[2] - known[2]];
    let added = collision.times(change);
    let work = |k: usize| change[k] * (now[k] + 0.5 * added[k]);
    (known[0] + change[0] >= 0.0).then(|| Bounce { change, works: [work(0), work(1) + work(2)] })
}

/// `K` at a point of a patch, along the normal and both tangents, 1/kg.
fn collision_matrix(batch: &Batch, row: &PointRows, lane: usize) -> Option<CollisionMatrix> {
    let [x, y] = row.place.map(|four| four.0[lane]);
    let [k11, k12, k1n, k22, k2n, knn] = batch.blocks.slipping.map(|four| four.0[lane]);
    let tangents = [[1.0, 0.0, -y], [0.0, 1.0, x]];
    let of_slip = [[k11, k12, k1n], [k12, k22, k2n], [k1n, k2n, knn]];
    let dot = |left: [f64; 3], right: [f64; 3]| left[0] * right[0] + left[1] * right[1] + left[2] * right[2];
    let along = |i: usize, j: usize| dot(tangents[i], of_slip.map(|line| dot(line, tangents[j])));
    let of_normal = batch.blocks.coupling.map(|line| dot(line.map(|four| four.0[lane]), [1.0, y, -x]));
    let coupled = tangents.map(|tangent| dot(tangent, of_normal));
    let normal = row.stiffness.0[lane];
    CollisionMatrix::new([
        [normal, coupled[0], coupled[1]],
        [coupled[0], along(0, 0), along(0, 1)],
        [coupled[1], along(1, 0), along(1, 1)],
    ])
    .ok()
}
