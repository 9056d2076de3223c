//! The state of a body and its layout in a flat state.
//!
//! Thirteen numbers: position of the centre of mass p (m), quaternion w x y z (body to world), linear velocity v
//! (m/s), angular momentum L about the centre of mass in world axes (kg m^2/s). Of a pivoted body
//! ([`crate::RigidBody::pivoted`]) p is the pivot's position, v is zero and L is about the pivot. L rather than the
//! angular velocity, because free flight conserves it (thesis 3.3, equation 4). The quaternion is stored whole: three
//! of its numbers and a sign lose half the digits near w = 0 (docs/REFERENCES.md, the thesis's errata).

use glam::{DQuat, DVec3};
use polhode_spatial::{Pose, Rotation, RotationError};
use thiserror::Error;

/// Numbers per body in a flat state.
pub const WIDTH: usize = 13;
/// Where the position of the centre of mass begins.
pub const POSITION: usize = 0;
/// Where the quaternion w, x, y, z begins.
pub const QUATERNION: usize = 3;
/// Where the linear velocity begins.
pub const LINEAR_VELOCITY: usize = 7;
/// Where the angular momentum begins.
pub const ANGULAR_MOMENTUM: usize = 10;

/// State of one body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyState {
    /// `X_WC`: rotation of the body's axes, position of the centre of mass (of the pivot) (m).
    pub pose: Pose,
    /// `v_WBcm`, m/s (of the pivot: zero).
    pub linear_velocity: DVec3,
    /// `L_WBcm`, kg m^2/s, about the centre of mass (about the pivot), in world axes.
    pub angular_momentum: DVec3,
}

/// A slice is too short to hold a body's state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("a body's state takes {WIDTH} numbers, the slice has {0}: pass the slice from the body's offset on")]
pub struct SliceTooShort(pub usize);

impl BodyState {
    /// At rest at `pose`.
    pub const fn at_rest(pose: Pose) -> Self {
        Self { pose, linear_velocity: DVec3::ZERO, angular_momentum: DVec3::ZERO }
    }

    /// From the flat layout; the quaternion is normalised (of length zero or not finite it becomes NaN).
    pub fn from_array(numbers: &[f64; WIDTH]) -> Self {
        let [px, py, pz, qw, qx, qy, qz, vx, vy, vz, lx, ly, lz] = *numbers;
        Self {
            pose: Pose::new(Rotation::renormalized(DQuat::from_xyzw(qx, qy, qz, qw)), DVec3::new(px, py, pz)),
            linear_velocity: DVec3::new(vx, vy, vz),
            angular_momentum: DVec3::new(lx, ly, lz),
        }
    }

    /// The flat layout.
    pub fn to_array(&self) -> [f64; WIDTH] {
        let (p, v, l) = (self.pose.translation, self.linear_velocity, self.angular_momentum);
        let [qw, qx, qy, qz] = self.pose.rotation.to_wxyz();
        [p.x, p.y, p.z, qw, qx, qy, qz, v.x, v.y, v.z, l.x, l.y, l.z]
    }

    /// From the flat layout that [`BodyState::to_array`] has given, with the same bits: the quaternion, of length one
    /// up to rounding, is not normalised once more.
    ///
    /// # Errors
    /// When the quaternion is not finite or its length is not one.
    pub fn from_stored(numbers: &[f64; WIDTH]) -> Result<Self, RotationError> {
        let [px, py, pz, qw, qx, qy, qz, vx, vy, vz, lx, ly, lz] = *numbers;
        Ok(Self {
            pose: Pose::new(Rotation::from_stored_wxyz([qw, qx, qy, qz])?, DVec3::new(px, py, pz)),
            linear_velocity: DVec3::new(vx, vy, vz),
            angular_momentum: DVec3::new(lx, ly, lz),
        })
    }

    /// From the first [`WIDTH`] numbers of a slice, as [`BodyState::from_array`].
    ///
    /// # Errors
    /// When the slice is shorter.
    pub fn from_slice(numbers: &[f64]) -> Result<Self, SliceTooShort> {
        numbers.first_chunk::<WIDTH>().map(Self::from_array).ok_or(SliceTooShort(numbers.len()))
    }

    /// Writes the first [`WIDTH`] numbers of a slice.
    ///
    /// # Errors
    /// When the slice is shorter; nothing is written then.
    pub fn write_to_slice(&self, numbers: &mut [f64]) -> Result<(), SliceTooShort> {
        let length = numbers.len();
        let first = numbers.first_chunk_mut::<WIDTH>().ok_or(SliceTooShort(length))?;
        *first = self.to_array();
        Ok(())
    }

    /// Whether every component is finite.
    pub fn is_finite(&self) -> bool {
        self.pose.is_finite() && self.linear_velocity.is_finite() && self.angular_momentum.is_finite()
    }
}

/// Brings the quaternions of a flat state of bodies, one after the other, back to length one. An integrator moves
/// them off the unit sphere by its truncation error; the direction of the quaternion is kept.
pub fn normalize(state: &mut [f64]) {
    for body in state.as_chunks_mut::<WIDTH>().0 {
        let [w, x, y, z] = [body[QUATERNION], body[QUATERNION + 1], body[QUATERNION + 2], body[QUATERNION + 3]];
        let unit = Rotation::renormalized(DQuat::from_xyzw(x, y, z, w)).to_wxyz();
        body[QUATERNION..QUATERNION + 4].copy_from_slice(&unit);
    }
}

/// Rate of a quaternion (body to world, any length), `(0, w) q / 2`, as w, x, y, z, for the angular velocity `w`
/// (rad/s, world).
pub fn quaternion_rate(quaternion: DQuat, angular_velocity: DVec3) -> [f64; 4] {
    let half = angular_velocity * 0.5;
    let rate = DQuat::from_xyzw(half.x, half.y, half.z, 0.0) * quaternion;
    [rate.w, rate.x, rate.y, rate.z]
}
