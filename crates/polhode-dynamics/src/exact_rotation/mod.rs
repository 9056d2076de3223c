//! Exact free rotation: the attitude after any time, to round-off, in one evaluation.
//!
//! A rigid body without torque conserves its angular momentum L in the world (thesis 3.3, equation 4) and its energy;
//! along its principal axes P the momentum `p = R_WP^T L` obeys Euler's equations `p' = p x I^-1 p`, and the attitude
//! `R' = R [I^-1 p]x`. Both are solved in closed form:
//!
//! | file | what | when |
//! |---|---|---|
//! | `canonical` | axes in order, exact scaling, the test for a steady rotation | always |
//! | `taylor` | Taylor series to round-off | a turn of at most [`TAYLOR_REACH`] |
//! | `elliptic` | Jacobi's functions and an integral of the third kind | any longer time |
//!
//! A rotation that is steady (sphere, principal axis, equator of a symmetric body, no rotation) is turned about its
//! fixed axis. Errors for |w| |h| <= 10: momentum at most 5e-14 of |L|, attitude at most 1e-13 rad (measured
//! against 3200 rotations of 40 digits: 4e-15); for longer times the rounding of the turn itself, some 3e-16 per rad.
//! Moments need not be in order; they must be positive and should obey the triangle inequality. Numbers that are not
//! finite give NaN; nothing loops without bound.

mod canonical;
mod elliptic;
mod taylor;

use canonical::Canonical;
use elliptic::Elliptic;
use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;

/// Largest turn (rad, the time by an upper bound of the angular speed) for which the Taylor series is taken: there it
/// costs as much as the elliptic functions.
pub const TAYLOR_REACH: f64 = 0.4;

/// Relative rounding of a bound's own evaluation and of the velocities it is held against, so that it is never too
/// small: a few dozen operations, each good to 1.1e-16.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Attitude `R_WP` after `h` seconds (negative goes back) of a free rotation with the principal `moments` (kg m^2, in
/// the order of the axes of P), from the attitude `rotation` (`R_WP`) with the angular momentum `L_W` (kg m^2/s, world
/// axes). The same bits as [`FreeRotation::at`], without preparing what only later evaluations would use.
///
/// ```
/// use polhode_dynamics::exact_rotation::drift;
/// use polhode_spatial::{DVec3, Rotation};
/// let (moments, momentum) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, 3.0));
/// let there = drift(moments, Rotation::IDENTITY, momentum, 1000.0);
/// assert!(drift(moments, there, momentum, -1000.0).angle_to(Rotation::IDENTITY) < 1e-11);
/// ```
pub fn drift(moments: DVec3, rotation: Rotation, angular_momentum: DVec3, h: f64) -> Rotation {
    let canonical = Canonical::new(moments, rotation.inverse_rotate(angular_momentum));
    let relative = if canonical.is_steady() {
        steady(&canonical, h)
    } else {
        short(&canonical, canonical.fastest(), h)
            .unwrap_or_else(|| Elliptic::new(&canonical).relative(h * canonical.time_scale))
    };
    rotation * restored(&canonical, relative)
}

/// One free rotation with everything about it that is constant: to be built once per flight and asked at many times.
/// The answer depends on the time alone, not on what was asked before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeRotation {
    start: Rotation,
    canonical: Canonical,
    /// Upper bound of the angular speed, canonical units.
    fastest: f64,
    /// Nothing when the rotation is steady.
    elliptic: Option<Elliptic>,
}

impl FreeRotation {
    /// The rotation that passes `rotation` (`R_WP`) at time zero; arguments as for [`drift`].
    pub fn new(moments: DVec3, rotation: Rotation, angular_momentum: DVec3) -> Self {
        let canonical = Canonical::new(moments, rotation.inverse_rotate(angular_momentum));
        let elliptic = if canonical.is_steady() { None } else { Some(Elliptic::new(&canonical)) };
        Self { start: rotation, canonical, fastest: canonical.fastest(), elliptic }
    }

    /// Attitude `R_WP` after `h` seconds.
    pub fn at(&self, h: f64) -> Rotation {
        self.start * self.relative(h)
    }

    /// Rotation `R_P0P` from the principal axes after `h` seconds to those at time zero; exactly the identity at zero.
    pub fn relative(&self, h: f64) -> Rotation {
        let relative = match &self.elliptic {
            None => steady(&self.canonical, h),
            Some(elliptic) => short(&self.canonical, self.fastest, h)
                .unwrap_or_else(|| elliptic.relative(h * self.canonical.time_scale)),
        };
        restored(&self.canonical, relative)
    }

    /// As [`FreeRotation::at`], by the Taylor series alone: nothing when the rotation is steady or the series does not
    /// reach that far. For comparing the two.
    pub fn at_by_taylor(&self, h: f64) -> Option<Rotation> {
        self.elliptic?;
        let relative = taylor::relative(&self.canonical, h * self.canonical.time_scale)?;
        Some(self.start * restored(&self.canonical, relative))
    }

    /// As [`FreeRotation::at`], by elliptic functions alone: nothing when the rotation is steady. For comparing the two.
    pub fn at_by_elliptic_functions(&self, h: f64) -> Option<Rotation> {
        let relative = self.elliptic?.relative(h * self.canonical.time_scale);
        Some(self.start * restored(&self.canonical, relative))
    }

    /// Whether the angular velocity is constant.
    pub const fn is_steady(&self) -> bool {
        self.elliptic.is_none()
    }

    /// Period of the angular momentum as seen from the body (once round the polhode), s: nothing when the rotation is
    /// steady, infinite on the separatrix.
    pub fn period(&self) -> Option<f64> {
        self.elliptic.map(|elliptic| elliptic.period() / self.canonical.time_scale)
    }

    /// Upper bound of the angular speed at any time, rad/s: exceeded by nothing, reached once per half period up to
    /// rounding.
    pub fn angular_speed_bound(&self) -> f64 {
        let canonical = match &self.elliptic {
            None => self.canonical.angular_velocity().length(),
            Some(elliptic) => elliptic.fastest(&self.canonical),
        };
        // An angular velocity is computed from a momentum that is rounded relative to its whole length, which the
        // smallest moment magnifies: a needle's by its ratio of moments.
        (canonical + ROUNDING * self.canonical.largest_rate()) * self.canonical.time_scale
    }

    /// Upper bound of the angular acceleration at any time, rad/s^2: zero for a steady rotation, else at most twice what
    /// is reached.
    pub fn angular_acceleration_bound(&self) -> f64 {
        let bound = self.elliptic.map_or(0.0, |elliptic| elliptic.acceleration_bound(&self.canonical));
        bound * self.canonical.time_scale * self.canonical.time_scale * (1.0 + ROUNDING)
    }
}

/// The turn about a fixed axis, canonical.
fn steady(canonical: &Canonical, h: f64) -> DQuat {
    Rotation::from_rotation_vector(canonical.angular_velocity() * (h * canonical.time_scale)).quaternion()
}

/// The Taylor series, where it is the faster of the two.
fn short(canonical: &Canonical, fastest: f64, h: f64) -> Option<DQuat> {
    let time = h * canonical.time_scale;
    if fastest * time.abs() <= TAYLOR_REACH { taylor::relative(canonical, time) } else { None }
}

fn restored(canonical: &Canonical, relative: DQuat) -> Rotation {
    Rotation::renormalized(canonical.restore(relative))
}
