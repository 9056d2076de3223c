//! A point of A that does not move along a direction of B: a row of displacement.
//!
//! With the direction `d` (unit vector fixed in B), the points `p_A`, `p_B` and the slip `u = v_A - v_B` of the bodies
//! at `p_A`, where the force acts,
//!
//! `gap = d.(p_A - p_B)`, `rate = d.u`, `bias = d.(w_A x (w_A x r_A) - w_B x (w_B x r_B)) + 2 (w_B x d).u`
//!
//! with arms `r` to `p_A`. The last term is Coriolis's: the direction turns with B while the point slides over it. Two
//! such rows keep a point on a line, one keeps it in a plane. Source: Featherstone 2008, chapter 8.

use super::end::EndKinematics;
use super::row::{BilateralRow, RowKind};
use polhode_spatial::DVec3;

/// The row of a direction in the axes of B (unit vector). `gap` is the way from the point of B to that of A (m); both
/// ends are taken at the latter.
pub(crate) fn row(direction: DVec3, gap: DVec3, a: &EndKinematics, b: &EndKinematics) -> BilateralRow {
    let direction = b.rotation.rotate(direction);
    let slip = a.velocity - b.velocity;
    BilateralRow {
        kind: RowKind::Along(direction),
        gap: direction.dot(gap),
        rate: direction.dot(slip),
        bias: bias(direction, a, b),
    }
}

/// The bias of the row of a direction (unit vector, world) that is fixed in B, m/s^2.
pub(crate) fn bias(direction: DVec3, a: &EndKinematics, b: &EndKinematics) -> f64 {
    let slip = a.velocity - b.velocity;
    direction.dot(a.acceleration - b.acceleration) + 2.0 * b.angular.cross(direction).dot(slip)
}
