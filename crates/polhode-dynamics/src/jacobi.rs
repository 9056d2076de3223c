//! Jacobi's elliptic functions sn, cn, dn by descending Landen transformations.
//!
//! `sn^2 + cn^2 = 1`, `dn^2 = m1 + m cn^2` with the parameter m and its complement `m1 = 1 - m`. The complement is what
//! is passed: near the separatrix it is all that matters, and 1 - m would have lost its digits. Means
//! `a' = (a + b)/2, b' = sqrt(a b)` from `(1, sqrt m1)` run until they agree to 1e-8, which makes their mean M exact to
//! round-off; `K = pi/(2 M)` is the quarter period; the functions are carried back from the circular ones of `M u`.
//! Source: docs/REFERENCES.md, Bulirsch 1965; Abramowitz and Stegun 16.4, 16.12, 17.6. The argument should be reduced
//! to `|u| <= K`, where cn and dn keep their relative accuracy. Outside `0 <= m1 <= 1` the results mean nothing; NaN
//! gives NaN; the means end after a fixed number of levels.

use crate::lanes::Lanes;
use polhode_spatial::rounding;
use std::f64::consts::FRAC_PI_2;

/// Levels after which the means agree for every double in (0, 1], the least subnormal included (it takes 13).
const LEVELS: usize = 16;
/// Levels that are kept: enough for a complement of 1e-4 and more. Nearer to the separatrix, where motions seldom are,
/// the ladder is made anew at each evaluation, to the same bits: kept in a record for each of many bodies, its room
/// would drive the rest of them out of the caches.
const KEPT: usize = 6;
/// Below this argument (dimensionless) two terms of the power series are exact to 1e-20, and the ladder would divide by
/// squares that underflow.
const SMALL_ARGUMENT: f64 = 1e-5;

/// Values of the three functions at one argument.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JacobiValues {
    /// Sine amplitude.
    pub sn: f64,
    /// Cosine amplitude.
    pub cn: f64,
    /// Delta amplitude, in [sqrt m1, 1].
    pub dn: f64,
}

/// The functions of one parameter, with their ladder of means.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct JacobiFunctions {
    complement: f64,
    mean: f64,
    used: usize,
    means: [(f64, f64); KEPT],
}

impl JacobiFunctions {
    /// Of the complementary parameter `m1 = 1 - m`, in [0, 1].
    pub fn new(complement: f64) -> Self {
        let (ladder, used, mean) = ladder(complement);
        let mut means = [(0.0, 0.0); KEPT];
        means.copy_from_slice(&ladder[..KEPT]);
        Self { complement, mean, used, means }
    }

    /// The complementary parameter `m1`.
    pub const fn complement(&self) -> f64 {
        self.complement
    }

    /// Quarter period `K(m)`; infinite for `m1 = 0`.
    pub fn quarter_period(&self) -> f64 {
        if self.complement == 0.0 { f64::INFINITY } else { FRAC_PI_2 / self.mean }
    }

    /// The functions at `u`, `|u| <= K`.
    pub fn at(&self, u: f64) -> JacobiValues {
        JacobiLanes::at([self], Lanes([u])).lane(0)
    }

    /// Where the ladder does not serve: at small arguments, and on the separatrix.
    fn at_special(&self, u: f64) -> Option<JacobiValues> {
        if u.abs() < SMALL_ARGUMENT {
            let (u2, m) = (u * u, 1.0 - self.complement);
            let (cn, dn) = (1.0 - 0.5 * u2, 1.0 - 0.5 * m * u2);
            return Some(JacobiValues { sn: u * (1.0 - (1.0 + m) * u2 / 6.0), cn, dn });
        }
        if self.complement == 0.0 {
            let sech = 1.0 / libm::cosh(u);
            return Some(JacobiValues { sn: libm::tanh(u), cn: sech, dn: sech });
        }
        None
    }
}

/// Values of the three functions, one argument and parameter in each lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JacobiLanes<const N: usize> {
    pub(crate) sn: Lanes<N>,
    pub(crate) cn: Lanes<N>,
    pub(crate) dn: Lanes<N>,
}

impl<const N: usize> JacobiLanes<N> {
    /// From the values of each lane.
    #[inline]
    pub(crate) fn of(lane: impl Fn(usize) -> JacobiValues) -> Self {
        Self { sn: Lanes::of(|i| lane(i).sn), cn: Lanes::of(|i| lane(i).cn), dn: Lanes::of(|i| lane(i).dn) }
    }

    /// The values of one lane.
    #[inline]
    pub(crate) fn lane(&self, i: usize) -> JacobiValues {
        JacobiValues { sn: self.sn.0[i], cn: self.cn.0[i], dn: self.dn.0[i] }
    }

    /// [`JacobiFunctions::at`] in each lane.
    #[inline(never)]
    pub(crate) fn at(functions: [&JacobiFunctions; N], u: Lanes<N>) -> Self {
        let angles: [(f64, f64); N] = std::array::from_fn(|i| libm::sincos(functions[i].mean * u.0[i]));
        let sine = Lanes::of(|i| angles[i].0);
        let mut a = Lanes::of(|i| angles[i].1) / sine;
        let mut cotangent = Lanes::of(|i| functions[i].mean) * a;
        let mut dn = Lanes::splat(1.0);
        let most = functions.iter().map(|own| own.used).max().unwrap_or(0);
        // Few lanes need the levels that are not kept; where one does, all are made.
        let made: [Option<[(f64, f64); LEVELS]>; N] = if most > KEPT {
            std::array::from_fn(|i| (functions[i].used > KEPT).then(|| ladder(functions[i].complement).0))
        } else {
            [None; N]
        };
        for level in (0..most).rev() {
            let used: [bool; N] = std::array::from_fn(|i| level < functions[i].used);
            let means: [(f64, f64); N] = std::array::from_fn(|i| match &made[i] {
                Some(made) => made[level],
                None => functions[i].means.get(level).copied().unwrap_or_default(),
            });
            let (first, second) = (Lanes::of(|i| means[i].0), Lanes::of(|i| means[i].1));
            let product = a * cotangent;
            let next = cotangent * dn;
            dn = ((second + product) / (first + product)).where_or(used, dn);
            a = (next / first).where_or(used, a);
            cotangent = next.where_or(used, cotangent);
        }
        let sn = 1.0 / (cotangent * cotangent + 1.0).sqrt();
        let sn = Lanes::of(|i| sn.0[i].copysign(sine.0[i]));
        let mut values = Self { sn, cn: cotangent * sn, dn };
        for i in 0..N {
            if let Some(special) = functions[i].at_special(u.0[i]) {
                (values.sn.0[i], values.cn.0[i], values.dn.0[i]) = (special.sn, special.cn, special.dn);
            }
        }
        values
    }
}

/// The ladder of means, of which so many levels are used, and the mean that they run to.
fn ladder(complement: f64) -> ([(f64, f64); LEVELS], usize, f64) {
    let mut means = [(0.0, 0.0); LEVELS];
    let mut used = 0;
    let (mut a, mut product, mut mean) = (1.0f64, complement, 0.0);
    for level in &mut means {
        let b = product.sqrt();
        *level = (a, b);
        used += 1;
        mean = 0.5 * (a + b);
        if (a - b).abs() <= rounding::HALF_OF_THE_DIGITS * a {
            break;
        }
        product = a * b;
        a = mean;
    }
    (means, used, mean)
}
