//! Two directions that stay perpendicular, one fixed in each of two bodies: a row of rotation.
//!
//! With unit vectors `a` of A and `b` of B, `c = a.b` is zero, and with a length `l`, which gives the row the unit of
//! displacements, and `n = a x b`,
//!
//! `gap = l c`, `rate = l n.(w_A - w_B)`, `bias = l (w_A x a x b + a x w_B x b).(w_A - w_B)`
//!
//! Source: Featherstone 2008, chapter 8; the derivatives of `c` by the product rule. Joints keep an axis by two such
//! rows, and an attitude by three. Assumption: the directions are within a right angle of being perpendicular;
//! projection keeps them within rounding.

use super::end::EndKinematics;
use super::row::{BilateralRow, RowKind};
use polhode_spatial::{DVec3, Rotation};

/// A direction of each body, perpendicular to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Perpendicular {
    /// Unit vector in the axes of A.
    a: DVec3,
    /// Unit vector in the axes of B.
    b: DVec3,
}

impl Perpendicular {
    /// These directions of the world (unit vectors), fixed in bodies with these attitudes.
    pub(crate) fn new((a, b): (DVec3, DVec3), attitudes: (Rotation, Rotation)) -> Self {
        Self { a: attitudes.0.inverse_rotate(a), b: attitudes.1.inverse_rotate(b) }
    }

    /// The row; `length` is that of the joint, m.
    pub(crate) fn row(&self, a: &EndKinematics, b: &EndKinematics, length: f64) -> BilateralRow {
        let (of_a, of_b) = (a.rotation.rotate(self.a), b.rotation.rotate(self.b));
        let (w_a, w_b) = (a.angular, b.angular);
        let relative = w_a - w_b;
        let normal = of_a.cross(of_b);
        let change = w_a.cross(of_a).cross(of_b) + of_a.cross(w_b.cross(of_b));
        BilateralRow {
            kind: RowKind::About(normal * length),
            gap: length * of_b.dot(of_a),
            rate: length * normal.dot(relative),
            bias: length * change.dot(relative),
        }
    }
}
