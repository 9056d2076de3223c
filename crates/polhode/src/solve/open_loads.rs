//! Bearings whose load statics leaves open.
//!
//! A mechanism with more supports than it needs (three cranks of a parallelogram) moves in the same way with many loads
//! of its joints. Where a bearing rubs, its friction follows from its load, and the motion from the choice among them:
//! that has to be told. The choice itself is of least norm in the rows, whose scales follow the directions of the
//! world.
//!
//! Method: `x` is a force across the axis of the bearing, and `y` the least reactions of all joints that do what `x`
//! does. If the load is determined, all reactions that do the same have the same force there, so that `x.y = x.x`.
//! Source: the row space projection of Golub and Van Loan 2013, 5.5 (docs/REFERENCES.md). Assumption: contacts beside
//! the joints bear nothing of it.

use crate::constraint::ConstraintId;
use crate::joints::bilateral::Reaction;
use crate::joints::{held, joint_friction};
use crate::model::Model;
use crate::rows::assembly::Assembly;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_response::solve::held::Supports;
use polhode_spatial::DVec3;

/// The part of a force that other joints may bear as well from which on the load counts as open (no unit, 1e-5 to
/// 1e-2): rounding gives some 1e-6.
const OPEN_PART: f64 = 1e-4;

/// Whether the load of a bearing with friction among the joints of these bodies (movable, ascending) is not determined.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn leave_open(model: &Model, states: &[BodyState], bodies: &[usize]) -> Result<bool, ResponseError> {
    let bearings = joint_friction::bearings_among(model, states, bodies);
    if bearings.is_empty() || !held::has_loops_among(model, bodies) {
        return Ok(false);
    }
    let assembly = Assembly::new(model, states, bodies, std::iter::empty())?;
    let supports = Supports::of(&assembly.problem)?;
    let multipliers = |bearing: ConstraintId, force: DVec3| -> Vec<f64> {
        let across = Reaction { force, moment: DVec3::ZERO };
        let of = |own: ConstraintId| if own == bearing { across } else { Reaction::default() };
        let rows = assembly.bilaterals().iter();
        rows.flat_map(|own| own.rows.iter().map(move |row| row.multiplier(of(own.id)))).collect()
    };
    for (bearing, axis) in bearings {
        let (first, second) = axis.any_orthonormal_pair();
        for force in [first, second] {
            if supports.open_part(multipliers(bearing, force))? > OPEN_PART {
                return Ok(true);
            }
        }
    }
    Ok(false)
}
