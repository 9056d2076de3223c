//! Compositions: methods of higher order from symmetric ones of lower order, by substeps of fixed fractions.
//!
//! A composition is a symmetric row of kicks (momenta change by the loads, poses stay) and drifts (poses change, the
//! motion is without loads), each over a fraction of the step. Substeps of a symmetric method of order 2 over the
//! symmetric row of fractions give
//!
//! | fractions | order | source in docs/REFERENCES.md |
//! |---|---|---|
//! | [`SUZUKI_4`]: p, p, 1 - 4p, p, p with `p = 1/(4 - 4^(1/3))` | 4 | Suzuki 1990 |
//! | [`YOSHIDA_4`]: w, 1 - 2w, w with `w = 1/(2 - 2^(1/3))` | 4 | Yoshida 1990 |
//! | [`YOSHIDA_6`]: seven, his solution A | 6 | Yoshida 1990 |
//!
//! Yoshida's three stages cost less than Suzuki's five and err more by a factor of sixty to seventy (measured on free
//! rotation), which is a factor of three in steps: Suzuki's are the better per cost. All have negative substeps, so
//! they are for forces that may run backwards: not for friction or drag.

use super::drift_kick::Stages;

/// Suzuki's five fractions.
pub(crate) const SUZUKI_4: [f64; 5] = {
    let p = 0.414_490_771_794_375_74;
    [p, p, 1.0 - 4.0 * p, p, p]
};

/// Yoshida's three fractions of order 4.
pub(crate) const YOSHIDA_4: [f64; 3] = {
    let w = 1.351_207_191_959_657_6;
    [w, 1.0 - 2.0 * w, w]
};

/// Yoshida's seven fractions of order 6, solution A (digits: Hairer, Lubich and Wanner, V.3.2).
pub(crate) const YOSHIDA_6: [f64; 7] = {
    let (a, b, c) = (0.784_513_610_477_557_3, 0.235_573_213_359_358_13, -1.177_679_984_178_871);
    [a, b, c, 1.0 - 2.0 * (a + b + c), c, b, a]
};

/// Kick, drift, kick (Strang 1968): order 2.
pub(crate) const STRANG: &Stages = &kick_drift_kick::<1, 2>([1.0]);

/// Of kick-drift-kick by [`SUZUKI_4`].
pub(crate) const STRANG_SUZUKI_4: &Stages = &kick_drift_kick::<5, 6>(SUZUKI_4);

/// Of kick-drift-kick by [`YOSHIDA_4`].
pub(crate) const STRANG_YOSHIDA_4: &Stages = &kick_drift_kick::<3, 4>(YOSHIDA_4);

/// Of kick-drift-kick by [`YOSHIDA_6`].
pub(crate) const STRANG_YOSHIDA_6: &Stages = &kick_drift_kick::<7, 8>(YOSHIDA_6);

/// Kick-drift-kick over each fraction, the half kicks of neighbours joined into one; M = N + 1. The first stage is a
/// kick alone.
const fn kick_drift_kick<const N: usize, const M: usize>(fractions: [f64; N]) -> [(f64, f64); M] {
    let mut stages = [(0.0, 0.0); M];
    let mut i = 0;
    while i < N {
        stages[i].1 += 0.5 * fractions[i];
        stages[i + 1].0 = fractions[i];
        stages[i + 1].1 = 0.5 * fractions[i];
        i += 1;
    }
    stages
}
