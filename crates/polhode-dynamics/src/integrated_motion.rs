//! One body's motion over a step of an integrator, as collision detection takes it: poses with rigorous bounds.
//!
//! Pose and velocity come from the step's polynomials ([`crate::DenseStep`]): `X_WC` from position p and quaternion q,
//! which is normalised, the velocity from v and L, `w = R I^-1 R^T L`. The rate of change of the pose
//! ([`IntegratedMotion::pose_rate`]) differs from that velocity by the error of the interpolation.
//!
//! **Bounds.** On a part of the step with middle m and half width r (both in units of the step), each component is
//! expanded about m, `y = sum c_k s^k` with `|s| <= r`; then `|y| <= sum |c_k| r^k` and `|y'| <= sum k |c_k| r^(k-1)`,
//! with vector norms for vectors. For the rotation, with `n = |q|^2` and the quaternion product `q' q* = n'/2 + S`, S
//! its vector part, both polynomials:
//!
//! ```text
//! w = 2 S/n,     w' = 2 S'/n - 2 S n'/n^2,     n >= n_0 - sum_(k>0) |n_k| r^k
//! ```
//!
//! The cancellation in S' (nothing for a steady spin) happens in the coefficients, before absolute values are taken.
//! That `R I^-1 R^T L` may be another angular velocity than w is covered by the defect `D = 2 I vec(q* q') - q* L q`, a
//! polynomial of degree 21, bounded once over the whole step: `|R I^-1 R^T L - w| <= max |I^-1 D| / min n`. So `speed`
//! and `angular_speed` hold for the rate of the pose and for the velocity, `acceleration` for the rates of both,
//! `angular_acceleration` for the motion of the pose. The bounds shrink to the true values as the interval does.
//!
//! The bounds are infinite when the interval leaves the step by more than [`OVERHANG`] of it, or when the quaternion
//! may pass through zero within it, which no accepted step comes near.

use crate::dense_polynomial::{self, COEFFICIENTS, expand, fraction};
use crate::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH};
use crate::{BodyState, RigidBody};
use glam::{DQuat, DVec3};
use polhode_spatial::{Motion, MotionBounds, Pose, Velocity};

/// By how much an interval may reach beyond the step, as a part of the step: room for the rounding of times.
pub const OVERHANG: f64 = 1.0 / 64.0;

/// Rounding error of a coefficient of an expansion or of a product of two, relative to the sum of the polynomial's
/// coefficients: seven products with (m + s) or (1 - m - s), each of which at most doubles that sum, at a handful of
/// roundings each, then sums of eight products: below 2^7 * 2^7 * 2^-53, taken with a margin of two.
const ROUNDING: f64 = 1.0 / (1u64 << 38) as f64;

/// Motion of a body over a step.
#[derive(Debug, Clone, PartialEq)]
pub struct IntegratedMotion {
    t0: f64,
    h: f64,
    components: [[f64; COEFFICIENTS]; WIDTH],
    body: RigidBody,
    /// Sum of the quaternion's coefficients but the first: how far it may move during the step.
    quaternion_path: f64,
    /// Bound of `|R I^-1 R^T L - w|` over the step with its overhang, rad/s.
    rate_defect: f64,
}

impl IntegratedMotion {
    pub(crate) fn new(t0: f64, h: f64, components: &[[f64; COEFFICIENTS]; WIDTH], body: &RigidBody) -> Self {
        let mut motion = Self { t0, h, components: *components, body: *body, quaternion_path: 0.0, rate_defect: 0.0 };
        motion.quaternion_path = motion.path::<4>(QUATERNION);
        motion.rate_defect = motion.bound_of_rate_defect();
        motion
    }

    /// Start of the step, s.
    pub const fn t0(&self) -> f64 {
        self.t0
    }

    /// Length of the step, s.
    pub const fn h(&self) -> f64 {
        self.h
    }

    /// State at `t` (s), with the quaternion normalised.
    pub fn state(&self, t: f64) -> BodyState {
        let x = fraction(self.t0, self.h, t);
        BodyState::from_array(&self.components.map(|f| dense_polynomial::evaluate(&f, x)))
    }

    /// Rate of change of the pose at `t` (s): what the interpolated position and attitude really do.
    pub fn pose_rate(&self, t: f64) -> Velocity {
        let x = fraction(self.t0, self.h, t);
        let q = self.quaternions(x);
        let spin = vector(q[1] * q[0].conjugate());
        Velocity::new(self.vectors(POSITION, x)[1] / self.h, spin * (2.0 / (q[0].length_squared() * self.h)))
    }

    /// Coefficients of the three components from `first` on, about `x`.
    fn vectors(&self, first: usize, x: f64) -> [DVec3; COEFFICIENTS] {
        let [a, b, c] = [0, 1, 2].map(|k| expand(&self.components[first + k], x));
        std::array::from_fn(|k| DVec3::new(a[k], b[k], c[k]))
    }

    /// Coefficients of the quaternion about `x`.
    fn quaternions(&self, x: f64) -> [DQuat; COEFFICIENTS] {
        let [w, i, j, k] = [0, 1, 2, 3].map(|k| expand(&self.components[QUATERNION + k], x));
        std::array::from_fn(|n| DQuat::from_xyzw(i[n], j[n], k[n], w[n]))
    }

    /// Sum of the sizes of all coefficients but the constant of N components from `first` on.
    fn path<const N: usize>(&self, first: usize) -> f64 {
        self.components[first..first + N].iter().flat_map(|f| &f[1..]).map(|f| f.abs()).sum()
    }

    /// Bounds of speed and acceleration from position and velocity.
    fn linear_bounds(&self, middle: f64, radius: f64) -> (f64, f64) {
        let position = self.vectors(POSITION, middle).map(DVec3::length);
        let velocity = self.vectors(LINEAR_VELOCITY, middle).map(DVec3::length);
        let h = self.h.abs();
        let (position_path, velocity_path) = (self.path::<3>(POSITION), self.path::<3>(LINEAR_VELOCITY));
        let slack = ROUNDING * position_path / h;
        let by_position = largest_rate(&position, radius) / h + slack;
        let by_velocity = largest(&velocity, radius) + ROUNDING * (velocity[0] + velocity_path);
        let bend = largest_second_rate(&position, radius) / (h * h) + slack / h;
        let gain = largest_rate(&velocity, radius) / h + ROUNDING * velocity_path / h;
        (by_position.max(by_velocity), bend.max(gain))
    }

    /// Bounds of angular speed and acceleration from the quaternion, without the defect.
    fn angular_bounds(&self, middle: f64, radius: f64) -> (f64, f64) {
        let q = self.quaternions(middle);
        let turn: [DQuat; 2 * COEFFICIENTS - 2] = product(&derivative(&q), &q.map(DQuat::conjugate));
        let slack = ROUNDING * self.quaternion_path * (1.0 + self.quaternion_path);
        let s = turn.map(|c| vector(c).length());
        let stretch = turn.map(|c| 2.0 * c.w.abs());
        let (spin, spin_rate) = (largest(&s, radius) + slack, largest_rate(&s, radius) + slack);
        let norm_rate = largest(&stretch, radius) + slack;
        let norm = q[0].length_squared() - radius * norm_rate - ROUNDING;
        // Also refuses NaN.
        if norm > 0.0 {
            let h = self.h.abs();
            let acceleration = 2.0 * (spin_rate + spin * norm_rate / norm) / (norm * h * h);
            (2.0 * spin / (norm * h), acceleration)
        } else {
            (f64::INFINITY, f64::INFINITY)
        }
    }

    /// The bound of `|R I^-1 R^T L - w|` over the step with its overhang.
    fn bound_of_rate_defect(&self) -> f64 {
        let (middle, radius) = (0.5, 0.5 + OVERHANG);
        let q = self.quaternions(middle);
        let conjugate = q.map(DQuat::conjugate);
        let momentum = self.vectors(ANGULAR_MOMENTUM, middle).map(|l| DQuat::from_xyzw(l.x, l.y, l.z, 0.0));
        let turn: [DQuat; 2 * COEFFICIENTS - 2] = product(&conjugate, &derivative(&q));
        let right: [DQuat; 2 * COEFFICIENTS - 1] = product(&momentum, &q);
        let in_body: [DQuat; 3 * COEFFICIENTS - 2] = product(&conjugate, &right);
        let axes = self.body.axes();
        let moments = self.body.moments();
        let defect: [DVec3; 3 * COEFFICIENTS - 2] = std::array::from_fn(|k| {
            let spin = turn.get(k).map_or(DVec3::ZERO, |c| vector(*c) * (2.0 / self.h));
            axes.inverse_rotate(spin) - axes.inverse_rotate(vector(in_body[k])) / moments
        });
        let norm_rate = largest(&turn.map(|c| 2.0 * c.w.abs()), radius) + ROUNDING * (1.0 + self.quaternion_path);
        let norm = q[0].length_squared() - radius * norm_rate;
        let sizes = (momentum[0].length() + self.path::<3>(ANGULAR_MOMENTUM)) / moments.min_element()
            + self.quaternion_path / self.h.abs();
        let slack = ROUNDING * sizes * (1.0 + self.quaternion_path);
        let bound = (largest(&defect.map(DVec3::length), radius) + slack) / norm;
        // A quaternion that may vanish bounds nothing; also NaN.
        if norm > 0.0 && bound >= 0.0 { bound } else { f64::INFINITY }
    }
}

impl Motion for IntegratedMotion {
    fn pose(&self, t: f64) -> Pose {
        self.state(t).pose
    }

    fn velocity(&self, t: f64) -> Velocity {
        self.body.velocity(&self.state(t))
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        let (x0, x1) = (fraction(self.t0, self.h, t0), fraction(self.t0, self.h, t1));
        // Written so that NaN is outside.
        let inside = [x0, x1].iter().all(|x| (-OVERHANG..=1.0 + OVERHANG).contains(x)) && self.h != 0.0;
        if !inside {
            let infinite = f64::INFINITY;
            return MotionBounds {
                speed: infinite,
                acceleration: infinite,
                angular_speed: infinite,
                angular_acceleration: infinite,
            };
        }
        let (middle, radius) = (0.5 * (x0 + x1), 0.5 * (x1 - x0).abs() + ROUNDING);
        let (speed, acceleration) = self.linear_bounds(middle, radius);
        let (angular_speed, angular_acceleration) = self.angular_bounds(middle, radius);
        MotionBounds { speed, acceleration, angular_speed: angular_speed + self.rate_defect, angular_acceleration }
    }
}

/// `sum c_k r^k`.
fn largest(sizes: &[f64], radius: f64) -> f64 {
    sizes.iter().rev().fold(0.0, |sum, c| sum * radius + c)
}

/// `sum k c_k r^(k-1)`.
fn largest_rate(sizes: &[f64], radius: f64) -> f64 {
    sizes.iter().enumerate().skip(1).rev().fold(0.0, |sum, (k, c)| sum * radius + k as f64 * c)
}

/// `sum k (k-1) c_k r^(k-2)`.
fn largest_second_rate(sizes: &[f64], radius: f64) -> f64 {
    sizes.iter().enumerate().skip(2).rev().fold(0.0, |sum, (k, c)| sum * radius + (k * (k - 1)) as f64 * c)
}

/// Vector part.
fn vector(q: DQuat) -> DVec3 {
    DVec3::new(q.x, q.y, q.z)
}

/// Coefficients of the derivative.
fn derivative(q: &[DQuat; COEFFICIENTS]) -> [DQuat; COEFFICIENTS - 1] {
    std::array::from_fn(|k| q[k + 1] * (k + 1) as f64)
}

/// Product of two polynomials with quaternion coefficients, of C = A + B - 1 coefficients.
fn product<const A: usize, const B: usize, const C: usize>(a: &[DQuat; A], b: &[DQuat; B]) -> [DQuat; C] {
    let mut c = [DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0); C];
    for (i, a) in a.iter().enumerate() {
        for (c, b) in c[i..].iter_mut().zip(b) {
            *c += *a * *b;
        }
    }
    c
}
