//! A hinge: a point and an axis of two bodies that stay one.
//!
//! The axis is a unit vector `a` fixed in A; `b_1`, `b_2` are unit vectors fixed in B, across the axis and each other. The axis
//! stays that of B where `c_k = b_k.a` is zero. With `n_k = a x b_k` and a length `l`, which gives the rows the unit of
//! displacements,
//!
//! `gap = l c_k`, `rate = l n_k.(w_A - w_B)`, `bias = l (w_A x a x b_k + a x w_B x b_k).(w_A - w_B)`
//!
//! beside the three rows of the point (`point.rs`). Source: Featherstone 2008, chapter 8; the derivatives of `c_k` by the
//! product rule. Assumption: the axes are within a right angle of each other; projection keeps them within rounding.

use super::end::EndKinematics;
use super::row::{BilateralRow, RowKind};
use polhode_spatial::{DVec3, Rotation};

/// How many rows the axis has, beside those of the point.
pub(super) const ROWS: usize = 2;

/// The axis of a hinge in its bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HingeAxis {
    /// Unit vector in the axes of A.
    axis: DVec3,
    /// Unit vectors across it in the axes of B.
    across: [DVec3; ROWS],
    /// The length of the rows, m.
    length: f64,
}

impl HingeAxis {
    /// An axis of the world (unit vector) between bodies with these attitudes.
    pub(super) fn new(axis: DVec3, (a, b): (Rotation, Rotation), length: f64) -> Self {
        let (first, second) = axis.any_orthonormal_pair();
        let across = [first, second].map(|across| b.inverse_rotate(across));
        Self { axis: a.inverse_rotate(axis), across, length }
    }

    /// The rows that keep the axes together.
    pub(super) fn rows(&self, a: &EndKinematics, b: &EndKinematics) -> impl Iterator<Item = BilateralRow> {
        let (axis, length) = (a.rotation.rotate(self.axis), self.length);
        let (w_a, w_b) = (a.angular, b.angular);
        let relative = w_a - w_b;
        self.across.map(|across| b.rotation.rotate(across)).into_iter().map(move |across| {
            let normal = axis.cross(across);
            let change = w_a.cross(axis).cross(across) + axis.cross(w_b.cross(across));
            BilateralRow {
                kind: RowKind::About(normal * length),
                gap: length * across.dot(axis),
                rate: length * normal.dot(relative),
                bias: length * change.dot(relative),
            }
        })
    }
}
