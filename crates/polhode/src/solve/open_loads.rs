//! Bearings whose load statics leaves open.
//!
//! A mechanism with more supports than it needs (three cranks of a parallelogram) moves in the same way with many loads
//! of its joints. Taken are those of least norm ([`Supports`]): `|force|^2 + |moment / l|^2` over all joints, with the
//! length `l` of each, whatever solver found the motion, and in every orientation of the scene the same. Where a
//! bearing rubs, its friction follows from its load, and the motion from that choice: that has to be told.
//!
//! Method: a load is determined if none of the reactions that do nothing has a force there. Assumption: contacts beside
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
    let supports = Supports::of(&assembly.problem, assembly.joint_rows());
    let multipliers = |bearing: ConstraintId, force: DVec3| -> Vec<f64> {
        let across = Reaction { force, moment: DVec3::ZERO };
        let of = |own: ConstraintId| if own == bearing { across } else { Reaction::default() };
        let rows = assembly.bilaterals().iter();
        rows.flat_map(|own| own.rows.iter().map(move |row| row.multiplier(of(own.id)))).collect()
    };
    for (bearing, axis) in bearings {
        let (first, second) = axis.any_orthonormal_pair();
        for force in [first, second] {
            if supports.leave_open(multipliers(bearing, force))? {
                return Ok(true);
            }
        }
    }
    Ok(false)
}
