//! The bounce at a patch of one point: the impact with friction of its bodies alone, followed along its normal impulse (Routh, Stronge), so that slip
//! stops, turns and reverses as in the other tiers.
//!
//! What the sweeps of the step have done at the point is what stops it, inelastically and all at once. So the velocity without it is
//! `u_0 = u - K p` with the impulse `p` of the whole step, along the normal that at the start of the step; the impact from `u_0` is resolved
//! (`crate::impact::friction`), and the impulses become those which leave its velocity. Other contacts of the bodies are as they are: several that bounce at once are
//! passed through again. Failure: an impact that is not resolved leaves the impulses as they are.

use super::batch::{Batch, PointRows};
use crate::impact::friction::{CollisionMatrix, RestitutionLaw, SingleFrictionalImpact};

/// By what the impulses of a point (N s) change whose bodies move like this (m/s): along the normal and both tangents. None where it does not bounce.
pub(super) fn change(batch: &Batch, row: &PointRows, lane: usize, now: [f64; 3]) -> Option<[f64; 3]> {
    let of = |k: usize| batch.blocks.slipping[k].0[lane];
    let [first, second] = [batch.blocks.coupling[0][0].0[lane], batch.blocks.coupling[1][0].0[lane]];
    let normal = row.stiffness.0[lane];
    let entries = [[normal, first, second], [first, of(0), of(1)], [second, of(1), of(3)]];
    let collision = CollisionMatrix::new(entries).ok()?;
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
    let held = (before - (now[0] - given[0])) / normal;
    let change = [impulse[0] + held - known[0], impulse[1] - known[1], impulse[2] - known[2]];
    (known[0] + change[0] >= 0.0).then_some(change)
}
