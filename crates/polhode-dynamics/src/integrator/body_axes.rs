//! Small formulae in body axes that several methods share.
//!
//! Within a step attitudes are plain quaternions `q_WB` of length one up to the rounding of a few products; what a step
//! leaves is normalised ([`Rotation::renormalized`]).

use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;

/// Square of an angle (rad^2) up to which [`cos_and_sinc`] sums series: half a radian. There the first terms left out,
/// the ninth, are below `0.25^8/16! = 8e-19`; with more reach they would need more terms than libm takes.
const SERIES_REACH: f64 = 0.25;

/// `R_WB v` of a quaternion of length one (of length l: times l^2).
#[inline]
pub(crate) fn to_world(quaternion: DQuat, vector: DVec3) -> DVec3 {
    quaternion * vector
}

/// `R_WB^T v`, as [`to_world`].
#[inline]
pub(crate) fn to_body(quaternion: DQuat, vector: DVec3) -> DVec3 {
    quaternion.conjugate() * vector
}

/// `q (0, w) / 2`: rate of the quaternion of a body with the angular velocity `w` (rad/s, body axes).
#[inline]
pub(crate) fn quaternion_rate(quaternion: DQuat, angular_velocity: DVec3) -> DQuat {
    let (half, u) = (angular_velocity * 0.5, DVec3::new(quaternion.x, quaternion.y, quaternion.z));
    let v = half * quaternion.w + u.cross(half);
    DQuat::from_xyzw(v.x, v.y, v.z, -u.dot(half))
}

/// Coefficients of the series of cos and of sinc, `sin a/a`, in the square of the angle.
const COS: [f64; 8] = series(0.0);
const SINC: [f64; 8] = series(1.0);

const fn series(first: f64) -> [f64; 8] {
    let mut coefficients = [1.0; 8];
    let mut k = 1;
    while k < 8 {
        let n = 2.0 * k as f64 + first;
        coefficients[k] = -coefficients[k - 1] / (n * (n - 1.0));
        k += 1;
    }
    coefficients
}

/// Sum of a series at x, by pairs of pairs of terms (Estrin's scheme), which do not wait for each other.
#[inline]
fn sum(c: &[f64; 8], x: f64) -> f64 {
    let (x2, x4) = (x * x, (x * x) * (x * x));
    ((c[0] + c[1] * x) + (c[2] + c[3] * x) * x2) + ((c[4] + c[5] * x) + (c[6] + c[7] * x) * x2) * x4
}

/// cos and `sin a/a` of an angle a given by its square, where that is within reach of the series.
#[inline]
fn cos_and_sinc(square: f64) -> Option<(f64, f64)> {
    // NaN is out of reach.
    (square <= SERIES_REACH).then(|| (sum(&COS, square), sum(&SINC, square)))
}

/// Sine and cosine: those of libm, by series for the angles of usual steps.
#[inline]
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    cos_and_sinc(angle * angle).map_or_else(|| libm::sincos(angle), |(cos, sinc)| (angle * sinc, cos))
}

/// The rotation by `|v|` about v: [`Rotation::from_rotation_vector`], by series for the angles of usual steps.
#[inline]
pub(crate) fn exp(v: DVec3) -> DQuat {
    let Some((cos, sinc)) = cos_and_sinc(0.25 * v.length_squared()) else {
        return Rotation::from_rotation_vector(v).quaternion();
    };
    let v = v * (0.5 * sinc);
    DQuat::from_xyzw(v.x, v.y, v.z, cos)
}

/// The rotation of the quaternion `1 + v`: by `2 atan |v|` about v (Cayley's map).
#[inline]
pub(crate) fn cayley(v: DVec3) -> DQuat {
    let scale = 1.0 / (1.0 + v.length_squared()).sqrt();
    DQuat::from_xyzw(v.x * scale, v.y * scale, v.z * scale, scale)
}

/// Solves for x the three equations `columns x = right` by Cramer's rule, and gives the determinant; a singular matrix
/// gives NaN or infinity.
#[inline]
pub(crate) fn solve(columns: [DVec3; 3], right: DVec3) -> (DVec3, f64) {
    let [a, b, c] = columns;
    let (b_c, c_a, a_b) = (b.cross(c), c.cross(a), a.cross(b));
    let determinant = a.dot(b_c);
    let scale = 1.0 / determinant;
    (DVec3::new(b_c.dot(right), c_a.dot(right), a_b.dot(right)) * scale, determinant)
}
