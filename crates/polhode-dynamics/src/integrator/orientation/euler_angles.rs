//! Euler angles (phi, theta, psi) about z, x, z: `R = Rz(phi) Rx(theta) Rz(psi)` (thesis 3.3, Figure 12).
//!
//! R turns body into world; the matrix that the thesis prints is its transpose, with one entry misprinted
//! (docs/REFERENCES.md, E9). For w in body axes
//!
//! ```text
//! theta' = w_x cos psi - w_y sin psi
//! phi'   = (w_x sin psi + w_y cos psi)/sin theta
//! psi'   = w_z - phi' cos theta
//! ```
//!
//! (docs/REFERENCES.md, Goldstein, 4.9). At theta = 0 and pi the first and the last axis coincide and the rates are
//! infinite. Since `|theta'| <= |w|`, a step that starts farther from there than `h |w|` cannot reach it; a stage
//! nearer than that is refused, before the angles turn by a radian or more in one step and the order is lost.

use super::super::one_step::Span;
use super::Representation;
use crate::integrator::IntegrationError;
use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;

/// Three angles.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EulerAngles;

impl Representation for EulerAngles {
    /// phi, theta, psi in rad.
    type Coordinates = DVec3;
    type Frame = Rotation;

    fn of(rotation: Rotation) -> DVec3 {
        // q = (cos(theta/2) cos s, sin(theta/2) cos d, sin(theta/2) sin d, cos(theta/2) sin s) with half the sum s and
        // half the difference d of phi and psi; all digits of theta are there, near its singularities too.
        let [w, x, y, z] = rotation.to_wxyz();
        let (sum, difference) = (libm::atan2(z, w), libm::atan2(y, x));
        let theta = 2.0 * libm::atan2((x * x + y * y).sqrt(), (w * w + z * z).sqrt());
        DVec3::new(sum + difference, theta, sum - difference)
    }

    fn rotation(angles: &DVec3) -> Rotation {
        let [(sin_sum, cos_sum), (sin_difference, cos_difference), (sin_theta, cos_theta)] =
            [angles.x + angles.z, angles.x - angles.z, angles.y].map(|angle| libm::sincos(0.5 * angle));
        Rotation::renormalized(DQuat::from_xyzw(
            sin_theta * cos_difference,
            sin_theta * sin_difference,
            cos_theta * sin_sum,
            cos_theta * cos_sum,
        ))
    }

    fn frame(angles: &DVec3) -> Rotation {
        Self::rotation(angles)
    }

    fn rate(angles: &DVec3, w: DVec3, span: Span) -> Result<DVec3, IntegrationError> {
        let (sin_theta, cos_theta) = libm::sincos(angles.y);
        // Below a right angle's sine the distance is at most pi/2 of it; both compare on the safe side.
        let distance = libm::asin(sin_theta.abs().min(1.0));
        let limit = span.h.abs() * w.length();
        if distance < limit {
            return Err(IntegrationError::SingularAttitude { t: span.t, distance, limit });
        }
        if w == DVec3::ZERO {
            return Ok(DVec3::ZERO);
        }
        let (sin_psi, cos_psi) = libm::sincos(angles.z);
        let phi = (w.x * sin_psi + w.y * cos_psi) / sin_theta;
        Ok(DVec3::new(phi, w.x * cos_psi - w.y * sin_psi, w.z - phi * cos_theta))
    }

    fn is_finite(angles: &DVec3) -> bool {
        angles.is_finite()
    }
}
