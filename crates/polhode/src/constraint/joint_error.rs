//! How far joints are from what they keep: displacements in m, rotations in rad, gears and prescribed motions in the unit of their first
//! coordinate.

use super::ConstraintId;
use super::row::{Action, BilateralRow, RowKind};
use crate::world::World;
use polhode_dynamics::BodyState;

/// The largest errors of joints in given states.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct JointError {
    /// m.
    pub(crate) apart_m: f64,
    /// rad.
    pub(crate) turned_rad: f64,
}

impl World {
    /// The largest errors of the joints, gears and prescribed motions in these states; none of a scene without joints.
    pub(crate) fn joint_error(&self, states: &[BodyState]) -> Option<JointError> {
        if self.joints.is_empty() {
            return None;
        }
        let mut error = JointError::default();
        for own in self.bilaterals(states, &self.movable).filter(|own| !matches!(own.id, ConstraintId::Pivot { .. })) {
            let (mut apart, mut turned) = (0.0_f64, 0.0_f64);
            for BilateralRow { kind, gap, .. } in &own.rows {
                match kind {
                    RowKind::Along(_) | RowKind::Helix { .. } | RowKind::Tied { first: Action::Force { .. }, .. } => {
                        apart = libm::hypot(apart, *gap);
                    }
                    RowKind::About(axis)
                    | RowKind::Turning { about: axis, .. }
                    | RowKind::Tied { first: Action::Moment(axis), .. } => {
                        turned = libm::hypot(turned, gap / axis.length());
                    }
                }
            }
            error = JointError { apart_m: error.apart_m.max(apart), turned_rad: error.turned_rad.max(turned) };
        }
        Some(error)
    }
}
