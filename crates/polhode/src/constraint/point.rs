//! A point of two bodies that stays one: three rows along the axes of the world.
//!
//! `gap = p_A - p_B`, `rate = v_A + w_A x r_A - v_B - w_B x r_B`, `bias = w_A x (w_A x r_A) - w_B x (w_B x r_B)`
//! (thesis 3.2, equations 2 and 3; Featherstone 2008, chapter 8).

use super::end::EndKinematics;
use super::row::{BilateralRow, RowKind};
use polhode_spatial::DVec3;

/// How many rows.
pub(crate) const ROWS: usize = 3;

/// The rows of a point of `a` that stays at one of `b`, from which it is this far away (m).
pub(crate) fn rows(gap: DVec3, a: &EndKinematics, b: &EndKinematics) -> impl Iterator<Item = BilateralRow> {
    let gap = gap.to_array();
    let rate = (a.velocity - b.velocity).to_array();
    let bias = (a.acceleration - b.acceleration).to_array();
    (0..ROWS).map(move |axis| BilateralRow {
        kind: RowKind::Along(DVec3::AXES[axis]),
        gap: gap[axis],
        rate: rate[axis],
        bias: bias[axis],
    })
}
