//! How far impulses and velocities are from Coulomb's law with Signorini's condition: the natural map that all solvers
//! of this crate are judged by (`friction/coulomb_cone.rs`), in lanes.
//!
//! `|p - P_K(p - rho u')| / rho` with `u' = u + (max(s, 0) / h + mu |u_t|) n`: a contact that is apart may close by as
//! much as its separation. In units of velocity.

use super::batch::{Batch, PointRows};
use super::body::{Gathered, ImpulseBody};
use super::lanes::{FOUR, Four, Lanes};
use super::patch::{Frame, place};
use super::sweep::SweepRule;
use super::works::numbers;

/// The largest natural map of all points, and the largest speed of a point, m/s.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Residual {
    /// Of the natural map.
    pub map: f64,
    /// Of the relative velocities of the points at the start of the step.
    pub speed: f64,
    /// The deepest overlap, m.
    pub overlap: f64,
}

pub(super) fn residual<L: Lanes>(
    bodies: &[ImpulseBody],
    batches: &[Batch],
    points: &[PointRows],
    rule: &SweepRule,
) -> Residual {
    let mut worst = [Four::default(); 3];
    for batch in batches {
        let rows = &points[batch.first as usize..(batch.first + batch.count) as usize];
        for part in 0..FOUR / L::WIDTH {
            let mut own = [0, 1, 2].map(|k| L::load(&worst[k], part));
            largest_of::<L>(bodies, (batch, part), rows, (rule, &mut own));
            own.into_iter().zip(&mut worst).for_each(|(value, to)| value.store(to, part));
        }
    }
    let [map, speed, overlap] = worst.map(|four| four.0.into_iter().fold(0.0, f64::max));
    // The map is summed as a square.
    Residual { map: map.sqrt(), speed, overlap }
}

#[inline(always)]
fn largest_of<L: Lanes>(
    bodies: &[ImpulseBody],
    (batch, part): (&Batch, usize),
    rows: &[PointRows],
    (rule, worst): (&SweepRule, &mut [L; 3]),
) {
    let a = Gathered::<L>::load(bodies, numbers::<L>(&batch.a, part));
    let b = Gathered::<L>::load(bodies, numbers::<L>(&batch.b, part));
    let frame = Frame::<L>::load(batch, part);
    let friction = L::load(&batch.friction, part);
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let relative = frame.relative(&a.twist(), &b.twist());
    for row in rows {
        let at = place(&row.place, part);
        let separation = L::load(&row.present, part);
        let inverse_mass = L::load(&row.stiffness, part);
        let [x, y] = relative.slip(at);
        let slip = (x * x + y * y).root();
        let closing = separation.greater(zero) * L::splat(rule.inverse_step);
        let corrected = relative.rate(at) + closing + friction * slip;
        let scaled = [0, 1, 2].map(|k| L::load(&row.impulse[k], part) * inverse_mass);
        let wanted = [scaled[0] - corrected, scaled[1] - x, scaled[2] - y];
        let length = (wanted[1] * wanted[1] + wanted[2] * wanted[2]).root();
        let on_edge = ((wanted[0] + friction * length) / (one + friction * friction)).greater(zero);
        let is_outside = length - friction * wanted[0];
        let normal = L::pick_greater(is_outside, zero, on_edge, wanted[0].greater(zero));
        let edge = L::pick_greater(length, zero, friction * on_edge / length, zero);
        let share = L::pick_greater(is_outside, zero, edge, one);
        let left = [scaled[0] - normal, scaled[1] - wanted[1] * share, scaled[2] - wanted[2] * share];
        let square = left[0] * left[0] + left[1] * left[1] + left[2] * left[2];
        // Lanes without a point have no inverse mass.
        worst[0] = worst[0].greater(L::pick_greater(inverse_mass, zero, square, zero));
        let rate = L::load(&row.rate, part);
        worst[1] = worst[1].greater(L::pick_greater(rate, zero, rate, -rate)).greater(slip);
        worst[2] = worst[2].greater(L::pick_greater(inverse_mass, zero, -separation, zero));
    }
}
