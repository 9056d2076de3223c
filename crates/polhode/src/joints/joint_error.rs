//! How far joints are from what they keep: displacements in m, rotations in rad, gears and prescribed motions in the
//! unit of their first coordinate.

use crate::constraint::ConstraintId;
use crate::constraint::row::{Action, BilateralRow, RowKind};
use crate::joints::bilateral::Bilateral;
use crate::joints::held;
use crate::model::Model;
use polhode_dynamics::BodyState;

/// How far a joint is from what it keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct JointError {
    /// Its bodies; one twice where it holds a body to the world.
    pub(crate) pair: (usize, usize),
    /// m.
    pub(crate) apart_m: f64,
    /// rad.
    pub(crate) turned_rad: f64,
}

/// The errors of all joints, gears and prescribed motions in these states.
pub(crate) fn joint_errors<'a>(model: &'a Model, states: &'a [BodyState]) -> impl Iterator<Item = JointError> + 'a {
    let all = held::bilaterals(model, states, &model.movable);
    all.filter(|own| !matches!(own.id, ConstraintId::Pivot { .. })).map(|own| {
        let (apart_m, turned_rad) = error_of(&own);
        JointError { pair: own.id.bodies(), apart_m, turned_rad }
    })
}

/// How far the bodies of a constraint are from what it keeps, m and rad.
pub(crate) fn error_of(own: &Bilateral) -> (f64, f64) {
    let (mut apart_m, mut turned_rad) = (0.0_f64, 0.0_f64);
    for BilateralRow { kind, gap, .. } in &own.rows {
        match kind {
            RowKind::Along(_) | RowKind::Helix { .. } | RowKind::Tied { first: Action::Force { .. }, .. } => {
                apart_m = libm::hypot(apart_m, *gap);
            }
            RowKind::About(axis)
            | RowKind::Turning { about: axis, .. }
            | RowKind::Tied { first: Action::Moment(axis), .. } => {
                turned_rad = libm::hypot(turned_rad, gap / axis.length());
            }
        }
    }
    (apart_m, turned_rad)
}
