//! Free rotation over any time: Jacobi's elliptic functions and one elliptic integral of the third kind.
//!
//! **Momentum.** In canonical axes (`I1 <= I2 <= I3`, [`super::canonical`]) `N = (I3-I2) I1 p3^2 - (I2-I1) I3 p1^2`
//! tells which axis c the momentum circles: c = 3, a = 1 for N > 0, else c = 1, a = 3. With the amplitudes
//!
//! ```text
//! ac^2 = pc^2 + p2^2 (Ic/I2) |I2-Ia|/(I3-I1)      aa^2 = pa^2 + p2^2 (Ia/I2) |I2-Ic|/(I3-I1)
//! a2^2 = p2^2 + pa^2 (I2/Ia) (I3-I1)/|I2-Ic|       m1  = |N| / (|I2-Ic| Ia ac^2),   m = 1 - m1
//! lambda = (ac/Ic) sqrt(|I2-Ic| (I3-I1)/(Ia I2))   s = sign pc
//! ```
//!
//! it is `pc = s ac dn u, pa = aa cn u, p2 = s a2 sn u` with `u = lambda t + u0`. Every amplitude is a sum of positive
//! terms; N, the only difference, is formed in twice the precision, because the motion amplifies its error by
//! exp(lambda t). The phase u0 is never computed: the functions at `u0 + lambda h` follow from those at u0, which are
//! `s p2/a2, pa/aa, |pc|/ac`, and at `lambda h` by the addition theorems (A&S 16.17), whose denominator is taken in
//! the form without cancellation, `cn0^2 + sn0^2 dn^2`.
//!
//! **Attitude.** With the frame `B(t) = [b1 b2 b3]`, `b3 = p/|L|`, `b2 = b3 x e/|.|`, `b1 = b2 x b3`, e the body axis
//! of c or a with the smaller amplitude (so that b3 never comes near e), `R(h) = R(0) B(0) Rz(psi) B(h)^T`. Let b be
//! the other of c and a. Then `psi' = |L| (pb^2/Ib + p2^2/I2)/(pb^2 + p2^2)`, whose integral is
//!
//! ```text
//! psi = |L| h/Ib + g [sqrt(delta) J(lambda h) + atan2(sqrt(delta) sn0 sn sn1, 1 + n (sn1^2 - sn0 sn cn1 dn1))]
//! J(u) = int_0^u sn^2/(1 + n sn^2) = sn^3/3 RJ(cn^2, dn^2, 1, 1 + n sn^2)
//! delta = n (1+n) (n+m),   g = sign(Ib - I2)
//! n = |I2-Ia| Ic / (|I2-Ic| Ia) when b = a,   aa^2/ac^2 when b = c;   0 <= n <= 1
//! ```
//!
//! by the addition theorem of the integral (Byrd and Friedman 116.03): nothing is divided by lambda and no two
//! integrals are subtracted, so slow motions (near-symmetric, near-equatorial) are as accurate as fast ones, and there
//! is no phase angle whose half turns could be miscounted. For |lambda h| > K the argument is reduced by k half
//! periods 2K: sn and cn change sign with k odd, J grows by 2 k J(K) ([`super::complete_integral`]).
//!
//! Sources: thesis 3.3 (equations of motion; its "no closed form" is erratum E8); docs/REFERENCES.md, Whittaker,
//! Analytical Dynamics, 69; van Zon and Schofield 2007; Byrd and Friedman. Errors: see [`super`]. The problem's own
//! conditioning is another matter: a relative change x of L, R or I at the start (the rounding of `R^T L` is one) shows
//! as x exp(lambda h) near the separatrix. The errors given are beside that, for the moments and momentum as passed.

use super::canonical::Canonical;
use super::complete_integral::complete_integral;
use crate::carlson::rj_lanes;
use crate::jacobi::{JacobiFunctions, JacobiLanes, JacobiValues};
use crate::lanes::Lanes;
use glam::{DMat3, DQuat, DVec3};
use polhode_spatial::DoubleDouble;

/// The middle axis, along which the momentum follows sn.
const MIDDLE: usize = 1;

/// What is constant during a rotation that is not steady, in canonical units.
#[derive(Debug, Clone, Copy, PartialEq)]
// In this order: what an evaluation reads follows its use, and the complete integral, which few evaluations need, comes
// last.
#[repr(C)]
pub(super) struct Elliptic {
    /// Axis whose momentum follows dn: the one that the momentum circles.
    dn_axis: u8,
    /// Axis whose momentum follows cn.
    cn_axis: u8,
    /// Body axis that the attitude's frame is built on.
    frame_axis: u8,
    /// lambda: phase per canonical time.
    rate: f64,
    quarter_period: f64,
    parameter: f64,
    functions: JacobiFunctions,
    start: JacobiValues,
    /// Amplitudes of the momentum along the three axes, those of dn and sn with the sign of the momentum along dn's.
    amplitudes: [f64; 3],
    /// `|L|/Ib`.
    spin: f64,
    /// g: +1, 0 or -1.
    winding: f64,
    characteristic: f64,
    root_delta: f64,
    /// B(0).
    start_frame: DQuat,
    /// J(K).
    complete_integral: f64,
}

impl Elliptic {
    /// Of a motion that is not steady.
    pub(super) fn new(canonical: &Canonical) -> Self {
        let (i, p) = (canonical.moments, canonical.momentum);
        let separatrix = separatrix_distance(i, p);
        // On the separatrix itself either axis serves, unless the body is symmetric about it.
        let circles_third = if separatrix == 0.0 { i[2] - i[1] > i[1] - i[0] } else { separatrix > 0.0 };
        let (c, a): (usize, usize) = if circles_third { (2, 0) } else { (0, 2) };
        let span = i[2] - i[0];
        let (to_c, to_a) = ((i[1] - i[c]).abs(), (i[1] - i[a]).abs());
        let dn_squared = p[c] * p[c] + p[1] * p[1] * (i[c] / i[1]) * (to_a / span);
        let cn_squared = p[a] * p[a] + p[1] * p[1] * (i[a] / i[1]) * (to_c / span);
        let sn_amplitude = (p[1] * p[1] + p[a] * p[a] * (i[1] / i[a]) * (span / to_c)).sqrt();
        let (dn_amplitude, cn_amplitude) = (dn_squared.sqrt(), cn_squared.sqrt());
        let divisor = to_c * i[a] * dn_squared;
        let parameter = (to_a * i[c] * cn_squared / divisor).min(1.0);
        let functions = JacobiFunctions::new((separatrix.abs() / divisor).min(1.0));
        // b is the other axis than the frame's: the one with the larger amplitude.
        let b_is_cn = cn_squared >= dn_squared;
        let (frame_axis, b) = if b_is_cn { (c, a) } else { (a, c) };
        let characteristic = if b_is_cn { to_a * i[c] / (to_c * i[a]) } else { cn_squared / dn_squared };
        let sign = 1.0f64.copysign(p[c]);
        let mut amplitudes = [0.0; 3];
        amplitudes[c] = sign * dn_amplitude;
        amplitudes[a] = cn_amplitude;
        amplitudes[MIDDLE] = sign * sn_amplitude;
        let momentum = DVec3::from_array(p);
        Self {
            dn_axis: c as u8,
            cn_axis: a as u8,
            frame_axis: frame_axis as u8,
            amplitudes,
            rate: dn_amplitude / i[c] * (to_c * span / (i[a] * i[1])).sqrt(),
            parameter,
            functions,
            quarter_period: functions.quarter_period(),
            start: normalized(p[1] / amplitudes[MIDDLE], p[a] / cn_amplitude, p[c].abs() / dn_amplitude),
            spin: momentum.length() / i[b],
            winding: if i[b] == i[1] { 0.0 } else { (i[b] - i[1]).signum() },
            characteristic,
            root_delta: (characteristic * (1.0 + characteristic) * (characteristic + parameter)).sqrt(),
            complete_integral: complete_integral(characteristic, functions.complement()),
            start_frame: frame(momentum, frame_axis),
        }
    }

    /// Rotation from the axes after the canonical time `h` to those at the start.
    pub(super) fn relative(&self, h: f64) -> DQuat {
        let [relative] = Self::relative_lanes([self], [h]);
        relative
    }

    /// [`Elliptic::relative`] in each lane.
    #[inline]
    pub(super) fn relative_lanes<const N: usize>(own: [&Self; N], h: [f64; N]) -> [DQuat; N] {
        let phase = Lanes::of(|i| own[i].rate) * Lanes(h);
        let half_periods = Lanes::of(|i| own[i].half_periods(phase.0[i]));
        let reduced = Lanes::of(|i| match half_periods.0[i] {
            0.0 => phase.0[i],
            count => phase.0[i] - count * (2.0 * own[i].quarter_period),
        });
        let turned = JacobiLanes::at(own.map(|own| &own.functions), reduced);
        let start = JacobiLanes::of(|i| own[i].start);
        let end = add(start, turned, Lanes::of(|i| own[i].parameter));
        let psi = Lanes::of(|i| own[i].spin) * Lanes(h)
            + Lanes::of(|i| own[i].winding) * winding_angle(own, start.sn, turned, end, half_periods);
        std::array::from_fn(|i| own[i].attitude(end.lane(i), half_periods.0[i], psi.0[i]))
    }

    /// Half periods of Jacobi's functions nearest to a phase.
    fn half_periods(&self, phase: f64) -> f64 {
        if self.quarter_period.is_finite() { libm::rint(phase / (2.0 * self.quarter_period)) } else { 0.0 }
    }

    /// The rotation when the momentum's functions have these values and the frame has turned by psi.
    fn attitude(&self, end: JacobiValues, half_periods: f64, psi: f64) -> DQuat {
        // An odd number of half periods turns sn and cn round.
        let flip = if libm::fabs(half_periods) % 2.0 == 1.0 { -1.0 } else { 1.0 };
        let mut momentum = self.amplitudes;
        momentum[usize::from(self.dn_axis)] *= end.dn;
        momentum[usize::from(self.cn_axis)] *= flip * end.cn;
        momentum[MIDDLE] *= flip * end.sn;
        let end_frame = frame(DVec3::from_array(momentum), usize::from(self.frame_axis));
        let (sine, cosine) = libm::sincos(0.5 * psi);
        self.start_frame * DQuat::from_xyzw(0.0, 0.0, sine, cosine) * end_frame.conjugate()
    }

    /// lambda, canonical.
    pub(super) const fn rate(&self) -> f64 {
        self.rate
    }

    /// m.
    pub(super) const fn parameter(&self) -> f64 {
        self.parameter
    }

    /// Period of the momentum in body axes, canonical time; infinite on the separatrix.
    pub(super) fn period(&self) -> f64 {
        4.0 * self.quarter_period / self.rate
    }

    /// Largest angular speed at any time. `|w|^2` is linear in sn^2, so its largest value is where sn^2 is 0 or 1.
    pub(super) fn fastest(&self, canonical: &Canonical) -> f64 {
        let [w1, w2, w3] = self.extreme_rates(canonical);
        let (wc, wa) = if self.dn_axis == 2 { (w3, w1) } else { (w1, w3) };
        let at_zero = wa * wa + wc * wc;
        let at_one = w2 * w2 + self.functions.complement() * wc * wc;
        at_zero.max(at_one).sqrt()
    }

    /// Bound of the angular acceleration: Euler's `w1' = (I2-I3)/I1 w2 w3` and its like with each rate at its largest.
    /// In the world the acceleration is as large, because w x w = 0.
    pub(super) fn acceleration_bound(&self, canonical: &Canonical) -> f64 {
        let [i1, i2, i3] = canonical.moments;
        let [w1, w2, w3] = self.extreme_rates(canonical);
        DVec3::new((i3 - i2) / i1 * w2 * w3, (i3 - i1) / i2 * w3 * w1, (i2 - i1) / i3 * w1 * w2).length()
    }

    /// Largest magnitude of each component of the angular velocity.
    fn extreme_rates(&self, canonical: &Canonical) -> [f64; 3] {
        std::array::from_fn(|k| self.amplitudes[k].abs() / canonical.moments[k])
    }
}

/// `(I3-I2) I1 p3^2 - (I2-I1) I3 p1^2`, correct to the last bits however close to zero.
fn separatrix_distance([i1, i2, i3]: [f64; 3], [p1, _, p3]: [f64; 3]) -> f64 {
    let about_third = DoubleDouble::difference(i3, i2).times(i1).times(p3).times(p3);
    let about_first = DoubleDouble::difference(i2, i1).times(i3).times(p1).times(p1);
    (about_third - about_first).value()
}

/// The three values with `sn^2 + cn^2 = 1` restored, which rounding has left within a few ulp.
fn normalized(sn: f64, cn: f64, dn: f64) -> JacobiValues {
    let length = (sn * sn + cn * cn).sqrt();
    JacobiValues { sn: sn / length, cn: cn / length, dn }
}

/// The bracket in the formula of psi. Signs of sn, sn1, cn1 before the turning round by half periods: they enter in
/// pairs.
#[inline]
fn winding_angle<const N: usize>(
    own: [&Elliptic; N],
    sn0: Lanes<N>,
    turned: JacobiLanes<N>,
    end: JacobiLanes<N>,
    half_periods: Lanes<N>,
) -> Lanes<N> {
    let n = Lanes::of(|i| own[i].characteristic);
    let root_delta = Lanes::of(|i| own[i].root_delta);
    let JacobiLanes { sn, cn, dn } = turned;
    let s2 = sn * sn;
    let incomplete = sn * s2 / 3.0 * rj_lanes(cn * cn, dn * dn, Lanes::splat(1.0), 1.0 + n * s2);
    let integral = Lanes::of(|i| match half_periods.0[i] {
        0.0 => incomplete.0[i],
        count => incomplete.0[i] + 2.0 * count * own[i].complete_integral,
    });
    let opposite = root_delta * sn0 * sn * end.sn;
    let adjacent = 1.0 + n * (end.sn * end.sn - sn0 * sn * end.cn * end.dn);
    root_delta * integral + Lanes::of(|i| libm::atan2(opposite.0[i], adjacent.0[i]))
}

/// The addition theorems of sn, cn, dn (A&S 16.17).
#[inline(never)]
fn add<const N: usize>(u: JacobiLanes<N>, v: JacobiLanes<N>, parameter: Lanes<N>) -> JacobiLanes<N> {
    let denominator = u.cn * u.cn + u.sn * u.sn * v.dn * v.dn;
    JacobiLanes {
        sn: (u.sn * v.cn * v.dn + v.sn * u.cn * u.dn) / denominator,
        cn: (u.cn * v.cn - u.sn * u.dn * v.sn * v.dn) / denominator,
        dn: (u.dn * v.dn - parameter * u.sn * u.cn * v.sn * v.cn) / denominator,
    }
}

/// The frame B: third axis along the momentum, second at right angles to the body axis as well.
fn frame(momentum: DVec3, axis: usize) -> DQuat {
    let b3 = momentum / momentum.length();
    let b2 = b3.cross(DVec3::AXES[axis]);
    let b2 = b2 / b2.length();
    DQuat::from_mat3(&DMat3::from_cols(b2.cross(b3), b2, b3))
}
