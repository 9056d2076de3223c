//! Exact free rotation: the attitude after any time, to round-off, in one evaluation.
//!
//! A rigid body without torque conserves its angular momentum L in the world (thesis 3.3, equation 4) and its energy;
//! along its principal axes P the momentum `p = R_WP^T L` obeys Euler's equations `p' = p x I^-1 p`, and the attitude
//! `R' = R [I^-1 p]x`. Both are solved in closed form:
//!
//! | file | what | when |
//! |---|---|---|
//! | `canonical` | axes in order, exact scaling, the test for a steady rotation | always |
//! | `taylor` | one power series to round-off, then algebra | a phase of at most [`TAYLOR_REACH`] |
//! | `elliptic` | Jacobi's functions and an integral of the third kind | any longer time |
//! | `complete_integral` | that integral over a quarter period | more than a half period |
//!
//! A rotation that is steady (sphere, principal axis, equator of a symmetric body, no rotation) is turned about its
//! fixed axis. Errors for |w| |h| <= 10: momentum at most 5e-14 of |L|, attitude at most 1e-13 rad (measured over
//! 120,000 rotations of every difficult kind: 7e-15); for longer times, to 1000, at most 4 x 2^-53 times the condition
//! number of the flow (measured: 1.4). The errors are for the numbers as they are passed: the rounding of `R^T L` is
//! one of the perturbations that the condition number speaks of. Moments need not be in order; they must be positive,
//! and bodies that break the triangle inequality are as exact as others up to a ratio of 1000. Numbers that are not
//! finite give NaN; nothing loops without bound.
//!
//! Cost in instructions, a step of RK4 on (q, L) being 436: a drift of |w| h = 0.1 takes 950, one of any length 2700,
//! the record of a flight 1650, a sample from it 720 to 1700 (examples/free_rotation_cost.rs).

mod canonical;
mod complete_integral;
mod elliptic;
mod taylor;

use polhode_spatial::rounding;
pub use taylor::TAYLOR_REACH;

use canonical::Canonical;
use elliptic::Elliptic;
use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;
use taylor::Taylor;

/// Attitude `R_WP` after `h` seconds (negative goes back) of a free rotation with the principal `moments` (kg m^2, in
/// the order of the axes of P), from the attitude `rotation` (`R_WP`) with the angular momentum `L_W` (kg m^2/s, world
/// axes). The same bits as [`FreeRotation::at`], without preparing what only later evaluations would use.
///
/// ```
/// use polhode_dynamics::exact_rotation::drift;
/// use polhode_dynamics::{DVec3, Rotation};
/// let (moments, momentum) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, 3.0));
/// let there = drift(moments, Rotation::IDENTITY, momentum, 1000.0);
/// assert!(drift(moments, there, momentum, -1000.0).angle_to(Rotation::IDENTITY) < 1e-11);
/// ```
pub fn drift(moments: DVec3, rotation: Rotation, angular_momentum: DVec3, h: f64) -> Rotation {
    let canonical = Canonical::new(moments, rotation.inverse_rotate(angular_momentum));
    let relative = if canonical.is_steady() {
        steady(&canonical, h)
    } else {
        let time = h * canonical.time_scale;
        let taylor = Taylor::new(&canonical);
        if taylor.reaches(time) { taylor.relative(time) } else { Elliptic::new(&canonical).relative(time) }
    };
    rotation * restored(&canonical, relative)
}

/// One free rotation with everything about it that is constant: to be built once per flight and asked at many times.
/// The answer depends on the time alone, not on what was asked before.
#[derive(Debug, Clone, Copy, PartialEq)]
// In this order: what an evaluation reads first stands at the front.
#[repr(C)]
pub struct FreeRotation {
    canonical: Canonical,
    taylor: Taylor,
    /// Nothing when the rotation is steady.
    elliptic: Option<Elliptic>,
    start: Rotation,
    /// Upper bounds of the angular speed, rad/s, and of the angular acceleration, rad/s^2.
    angular_speed_bound: f64,
    angular_acceleration_bound: f64,
}

impl FreeRotation {
    /// The rotation that passes `rotation` (`R_WP`) at time zero; arguments as for [`drift`].
    pub fn new(moments: DVec3, rotation: Rotation, angular_momentum: DVec3) -> Self {
        let canonical = Canonical::new(moments, rotation.inverse_rotate(angular_momentum));
        let elliptic = if canonical.is_steady() { None } else { Some(Elliptic::new(&canonical)) };
        Self::of(rotation, canonical, elliptic.as_ref())
    }

    /// The steady rotation about the principal axis nearest the angular momentum, which is along it but for rounding:
    /// for motions that are known to be planar. Left to itself the rounding grows about the middle axis.
    pub fn steady(moments: DVec3, rotation: Rotation, angular_momentum: DVec3) -> Self {
        let in_body = rotation.inverse_rotate(angular_momentum);
        let along = in_body.abs();
        let axis = if along.x >= along.y && along.x >= along.z {
            DVec3::X
        } else if along.y >= along.z {
            DVec3::Y
        } else {
            DVec3::Z
        };
        let canonical = Canonical::new(moments, axis * axis.dot(in_body));
        Self::of(rotation, canonical, None)
    }

    fn of(start: Rotation, canonical: Canonical, elliptic: Option<&Elliptic>) -> Self {
        let fastest = match elliptic {
            None => canonical.angular_velocity().length(),
            Some(elliptic) => elliptic.fastest(&canonical),
        };
        let acceleration = elliptic.map_or(0.0, |elliptic| elliptic.acceleration_bound(&canonical));
        Self {
            canonical,
            taylor: Taylor::new(&canonical),
            elliptic: elliptic.copied(),
            start,
            // An angular velocity is computed from a momentum that is rounded relative to its whole length, which the
            // smallest moment magnifies: a needle's by its ratio of moments.
            angular_speed_bound: (fastest + rounding::DOZENS_OF_TERMS * canonical.largest_rate())
                * canonical.time_scale,
            angular_acceleration_bound: acceleration
                * canonical.time_scale
                * canonical.time_scale
                * (1.0 + rounding::DOZENS_OF_TERMS),
        }
    }

    /// Attitude `R_WP` after `h` seconds.
    pub fn at(&self, h: f64) -> Rotation {
        self.start * self.relative(h)
    }

    /// Rotation `R_P0P` from the principal axes after `h` seconds to those at time zero; exactly the identity at zero.
    pub fn relative(&self, h: f64) -> Rotation {
        let relative = match &self.elliptic {
            None => steady(&self.canonical, h),
            Some(elliptic) => {
                let time = h * self.canonical.time_scale;
                if self.taylor.reaches(time) { self.taylor.relative(time) } else { elliptic.relative(time) }
            }
        };
        restored(&self.canonical, relative)
    }

    /// How the rotation after `h` seconds is evaluated.
    pub(crate) fn path(&self, h: f64) -> Path {
        match &self.elliptic {
            None => Path::Steady,
            Some(_) if self.taylor.reaches(h * self.canonical.time_scale) => Path::Series,
            Some(_) => Path::Elliptic,
        }
    }

    /// [`FreeRotation::relative`] of several rotations, with the same bits: together where all go the path given.
    pub(crate) fn relative_of<const N: usize>(rotations: [&Self; N], h: [f64; N], path: Path) -> [Rotation; N] {
        let times = std::array::from_fn(|i| h[i] * rotations[i].canonical.time_scale);
        let elliptic = rotations.each_ref().map(|rotation| rotation.elliptic.as_ref());
        let relative = match (path, all(elliptic)) {
            (Path::Series, Some(_)) => Taylor::relative_lanes(rotations.map(|rotation| &rotation.taylor), times),
            (Path::Elliptic, Some(elliptic)) => Elliptic::relative_lanes(elliptic, times),
            _ => return std::array::from_fn(|i| rotations[i].relative(h[i])),
        };
        std::array::from_fn(|i| restored(&rotations[i].canonical, relative[i]))
    }

    /// As [`FreeRotation::at`], by the Taylor series alone: nothing when the rotation is steady or the series does not
    /// reach that far. For comparing the two.
    pub fn at_by_taylor(&self, h: f64) -> Option<Rotation> {
        self.elliptic.as_ref()?;
        let time = h * self.canonical.time_scale;
        self.taylor.reaches(time).then(|| self.start * restored(&self.canonical, self.taylor.relative(time)))
    }

    /// As [`FreeRotation::at`], by elliptic functions alone: nothing when the rotation is steady. For comparing the
    /// two.
    pub fn at_by_elliptic_functions(&self, h: f64) -> Option<Rotation> {
        let relative = self.elliptic.as_ref()?.relative(h * self.canonical.time_scale);
        Some(self.start * restored(&self.canonical, relative))
    }

    /// Whether the angular velocity is constant.
    pub const fn is_steady(&self) -> bool {
        self.elliptic.is_none()
    }

    /// Period of the angular momentum as seen from the body (once round the polhode), s: nothing when the rotation is
    /// steady, infinite on the separatrix.
    pub fn period(&self) -> Option<f64> {
        self.elliptic.as_ref().map(|elliptic| elliptic.period() / self.canonical.time_scale)
    }

    /// Rate lambda of the phase of Jacobi's functions that the momentum follows in body axes, rad/s: near the middle
    /// axis the rate at which a deviation grows. Nothing when the rotation is steady.
    pub fn phase_rate(&self) -> Option<f64> {
        self.elliptic.as_ref().map(|elliptic| elliptic.rate() * self.canonical.time_scale)
    }

    /// Parameter m of those functions, in [0, 1]; one on the separatrix. Nothing when the rotation is steady.
    pub fn parameter(&self) -> Option<f64> {
        self.elliptic.as_ref().map(Elliptic::parameter)
    }

    /// Upper bound of the angular speed at any time, rad/s: exceeded by nothing, reached once per half period up to
    /// rounding.
    pub const fn angular_speed_bound(&self) -> f64 {
        self.angular_speed_bound
    }

    /// Upper bound of the angular acceleration at any time, rad/s^2: zero for a steady rotation, else at most twice
    /// what is reached.
    pub const fn angular_acceleration_bound(&self) -> f64 {
        self.angular_acceleration_bound
    }
}

/// How a rotation is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Path {
    /// About a fixed axis.
    Steady,
    /// By the power series.
    Series,
    /// By elliptic functions.
    Elliptic,
}

/// All of them, if there are all.
fn all<T: Copy, const N: usize>(values: [Option<T>; N]) -> Option<[T; N]> {
    let first = values.first().copied().flatten()?;
    let mut out = [first; N];
    for (out, value) in out.iter_mut().zip(values) {
        *out = value?;
    }
    Some(out)
}

/// The turn about a fixed axis, canonical.
fn steady(canonical: &Canonical, h: f64) -> DQuat {
    Rotation::from_rotation_vector(canonical.angular_velocity() * (h * canonical.time_scale)).quaternion()
}

fn restored(canonical: &Canonical, relative: DQuat) -> Rotation {
    Rotation::renormalized(canonical.restore(relative))
}
