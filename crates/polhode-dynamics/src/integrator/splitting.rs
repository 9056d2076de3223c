//! Symmetric splitting of free rotation into turns about principal axes, and its compositions.
//!
//! The kinetic energy is the sum of `p_k^2/(2 I_k)`; under one term alone the body turns about axis k at the constant
//! rate `p_k/I_k`. Five such turns, about the axes a, b, c, b, a by `h/2, h/2, h, h/2, h/2`, make a symmetric,
//! symplectic map of order 2 that keeps `|L|` exactly and whose energy error stays bounded: the largest moment stands
//! in the middle, which of the three choices errs least (3.3 times less than the smallest). Explicit, needs no solver,
//! and never fails; but it errs for a sphere too, whose exact rotation is the simplest of all. Source:
//! docs/REFERENCES.md, Dullweber, Leimkuhler and McLachlan 1997.

use super::IntegrationError;
use super::body_axes::sin_cos;
use super::composition::{STRANG, STRANG_SUZUKI_4, STRANG_YOSHIDA_4, STRANG_YOSHIDA_6, SUZUKI_4, YOSHIDA_4, YOSHIDA_6};
use super::one_step::{OneStep, integrator_by_driver};
use super::split_step::{SplitStep, Turn};
use glam::{DQuat, DVec3};

/// How splittings of order 2 are composed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Splitting4 {
    /// Five stages (Suzuki): the better per cost.
    #[default]
    Suzuki,
    /// Three stages (Yoshida).
    Yoshida,
}

/// The method, of order 2, 4 or 6.
#[derive(Debug)]
pub struct Splitting(OneStep<SplitStep<FiveTurns>>);

impl Splitting {
    /// Order 2.
    pub fn new() -> Self {
        Self(OneStep::new(SplitStep::new("splitting", 2, &[1.0], STRANG)))
    }

    /// Order 4.
    pub fn of_order_4(composition: Splitting4) -> Self {
        let (fractions, loaded): (&'static [f64], _) = match composition {
            Splitting4::Suzuki => (&SUZUKI_4, STRANG_SUZUKI_4),
            Splitting4::Yoshida => (&YOSHIDA_4, STRANG_YOSHIDA_4),
        };
        Self(OneStep::new(SplitStep::new("splitting-4", 4, fractions, loaded)))
    }

    /// Order 6, by Yoshida's seven stages.
    pub fn of_order_6() -> Self {
        Self(OneStep::new(SplitStep::new("splitting-6", 6, &YOSHIDA_6, STRANG_YOSHIDA_6)))
    }
}

impl Default for Splitting {
    fn default() -> Self {
        Self::new()
    }
}

integrator_by_driver!(Splitting);

#[derive(Debug)]
struct FiveTurns;

impl Turn for FiveTurns {
    #[inline]
    fn turn(moments: DVec3, p: DVec3, h: f64) -> Result<DQuat, IntegrationError> {
        // Axes in ascending order of their moments, right-handed: an odd permutation turns the third axis round.
        let mut order = [0, 1, 2];
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if moments[order[i]] > moments[order[j]] {
                order.swap(i, j);
            }
        }
        let third = if (order[0] + 1) % 3 == order[1] { 1.0 } else { -1.0 };
        let [i, j, k] = order;
        let (mut a, mut b, mut c) = (p[i], p[j], p[k] * third);
        let quarter = 0.25 * h;
        let [rate_a, rate_b, rate_c] = [quarter / moments[i], quarter / moments[j], 2.0 * quarter / moments[k]];
        // Each turn: half angle, its sine and cosine, the momentum seen from the turned axes, the quaternion.
        let first = HalfAngle::new(a * rate_a);
        (b, c) = first.turned(b, c);
        let second = HalfAngle::new(b * rate_b);
        (c, a) = second.turned(c, a);
        let middle = HalfAngle::new(c * rate_c);
        (a, b) = middle.turned(a, b);
        let fourth = HalfAngle::new(b * rate_b);
        (_, a) = fourth.turned(c, a);
        let last = HalfAngle::new(a * rate_a);
        let (q, r) = (about_first_then_second(first, second), about_first_then_second(last, fourth));
        // The second half of the row is the first half in reverse: r with its product the other way round.
        let r = DQuat::from_xyzw(r.x, r.y, -r.z, r.w);
        let s = DQuat::from_xyzw(
            q.x * middle.cos + q.y * middle.sin,
            q.y * middle.cos - q.x * middle.sin,
            q.z * middle.cos + q.w * middle.sin,
            q.w * middle.cos - q.z * middle.sin,
        ) * r;
        let mut v = [0.0; 3];
        (v[i], v[j], v[k]) = (s.x, s.y, s.z * third);
        Ok(DQuat::from_xyzw(v[0], v[1], v[2], s.w))
    }
}

/// Sine and cosine of half the angle of a turn.
#[derive(Debug, Clone, Copy)]
struct HalfAngle {
    sin: f64,
    cos: f64,
}

impl HalfAngle {
    #[inline]
    fn new(half_angle: f64) -> Self {
        let (sin, cos) = sin_cos(half_angle);
        Self { sin, cos }
    }

    /// Components along the two axes after the axis of the turn, seen from the turned axes.
    #[inline]
    fn turned(self, y: f64, z: f64) -> (f64, f64) {
        let (sin, cos) = (2.0 * self.sin * self.cos, 1.0 - 2.0 * self.sin * self.sin);
        (cos * y + sin * z, cos * z - sin * y)
    }
}

/// `exp(x a) exp(y b)` about the first two axes.
#[inline]
fn about_first_then_second(x: HalfAngle, y: HalfAngle) -> DQuat {
    DQuat::from_xyzw(x.sin * y.cos, x.cos * y.sin, x.sin * y.sin, x.cos * y.cos)
}
