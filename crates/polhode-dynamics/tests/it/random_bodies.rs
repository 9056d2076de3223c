//! Random free rotations of every kind that is hard for one method or another, and the survey of errors over them.
//!
//! The numbers come from a counter (SplitMix64), so that the case of a given kind and index is the same everywhere and
//! for any count.

use crate::exact_flow::{Outcome, condition, flow, separatrix_distance};
use glam::DVec3;
use polhode_dynamics::FreeRotation;
use polhode_dynamics::exact_rotation::drift;
use polhode_spatial::{Rotation, SplitMix64};

/// What makes a rotation hard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Physical bodies, moments to a ratio of 100.
    Generic,
    /// One moment down to a thousandth of the others, which are nearly equal.
    Needle,
    /// The largest moment within 1e-1 to 1e-16 of the sum of the others.
    Plate,
    /// Any three moments to a ratio of 1000, the triangle inequality broken by most.
    Unphysical,
    /// Moments that differ by 1e-1 to 1e-15.
    Spherical,
    /// Two moments that differ by 1e-1 to 1e-15, in part near the equator.
    NearSymmetric,
    /// Two equal moments.
    Symmetric,
    /// Next to the separatrix: relative distance 1e-1 to 1e-16, at any place of it.
    Separatrix,
    /// On the separatrix exactly, and beside it by the last bits of one number.
    OnSeparatrix,
    /// Next to the middle axis: other components 1e-1 to 1e-16.
    MiddleAxis,
    /// Next to any axis.
    PrincipalAxis,
    /// Everything at once: moments apart by 1 to 1e-15, or a needle to 1e-3, components of the momentum down to 1e-16.
    Mixed,
}

pub(crate) const KINDS: [Kind; 12] = [
    Kind::Generic,
    Kind::Needle,
    Kind::Plate,
    Kind::Unphysical,
    Kind::Spherical,
    Kind::NearSymmetric,
    Kind::Symmetric,
    Kind::Separatrix,
    Kind::OnSeparatrix,
    Kind::MiddleAxis,
    Kind::PrincipalAxis,
    Kind::Mixed,
];

/// Ranges of `|w| h`, rad, w at the start.
pub(crate) const SHORT: (f64, f64) = (1e-3, 10.0);
pub(crate) const LONG: (f64, f64) = (10.0, 1000.0);

/// One rotation, from the identity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    pub(crate) moments: DVec3,
    pub(crate) momentum: DVec3,
    pub(crate) h: f64,
}

/// A source of numbers.
struct Numbers(SplitMix64);

impl Numbers {
    /// In [0, 1).
    fn unit(&mut self) -> f64 {
        self.0.uniform()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// `10^-a` to `10^-b`, either sign.
    fn tiny(&mut self, a: f64, b: f64) -> f64 {
        let size = 10f64.powf(-self.between(a, b));
        if self.unit() < 0.5 { -size } else { size }
    }

    /// On the unit sphere, or nearly: from the cube by rejection.
    fn direction(&mut self) -> [f64; 3] {
        loop {
            let v = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize().to_array();
            }
        }
    }

    /// Moments of a physical body: sums of two of three positive numbers of ratio up to `10^decades`.
    fn physical(&mut self, decades: f64) -> [f64; 3] {
        let [a, b, c] = [0; 3].map(|_| 10f64.powf(-self.between(0.0, decades)));
        [a + b, a + c, b + c]
    }
}

/// The case of `kind` and `index`, with a time up to `reach/|w|`.
pub(crate) fn case(kind: Kind, index: u64, reach: (f64, f64)) -> Case {
    let mut n = Numbers(SplitMix64::new((kind as u64) << 40 | index << 4));
    let (moments, momentum) = body(kind, &mut n);
    // Any order of axes, and a power of ten that the numbers do not suspect.
    let turn = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]][(6.0 * n.unit()) as usize];
    let order = |v: [f64; 3]| DVec3::new(v[turn[0]], v[turn[1]], v[turn[2]]);
    let (moments, momentum) = (order(moments), order(momentum));
    let speed = (momentum / moments).length();
    let (shortest, longest) = reach;
    // Half of the times are spread evenly, half over all orders of magnitude.
    let even = n.unit() < 0.5;
    let part = n.unit();
    let turns = if even { longest * part } else { longest * (shortest / longest).powf(part) };
    let sign = if n.unit() < 0.5 { -1.0 } else { 1.0 };
    Case { moments, momentum, h: sign * turns.max(shortest) / speed }
}

/// Moments, mostly in ascending order, and momentum.
fn body(kind: Kind, n: &mut Numbers) -> ([f64; 3], [f64; 3]) {
    let sorted = |mut i: [f64; 3]| {
        i.sort_by(f64::total_cmp);
        i
    };
    let generic = sorted(n.physical(2.0));
    let p = n.direction();
    match kind {
        Kind::Generic => (generic, p),
        Kind::Needle => {
            let (thin, wide) = (10f64.powf(-n.between(1.0, 3.0)), n.between(0.5, 2.0));
            let i = [thin, wide, wide + thin * n.unit()];
            let spin = 10f64.powf(-n.between(0.0, 3.0));
            (i, [p[0] * spin, p[1], p[2]])
        }
        Kind::Plate => {
            let (a, b) = (10f64.powf(-n.between(0.0, 3.0)), 1.0);
            (sorted([a, b, (a + b) * (1.0 - n.tiny(1.0, 16.0).abs())]), p)
        }
        Kind::Unphysical => (sorted([0; 3].map(|_| 10f64.powf(-n.between(0.0, 3.0)))), p),
        Kind::Spherical => {
            let size = n.tiny(1.0, 15.0).abs();
            (sorted([0; 3].map(|_| 1.0 + size * n.unit())), p)
        }
        Kind::NearSymmetric => {
            let other = n.between(0.05, 1.99);
            let flat = if n.unit() < 0.3 { n.tiny(0.0, 14.0) } else { 1.0 };
            let i = [1.0, 1.0 + n.tiny(1.0, 15.0).abs(), other];
            (i, [p[0], p[1], p[2] * flat])
        }
        Kind::Symmetric => ([1.0, 1.0, n.between(0.002, 1.999)], p),
        Kind::Separatrix => on_separatrix(generic, n.tiny(1.0, 16.0), n),
        Kind::OnSeparatrix => {
            // (I3-I2) I1 p3^2 = (I2-I1) I3 p1^2 holds in exact arithmetic for each of these.
            let (i, p1, p3) = [
                ([3.0, 4.0, 6.0], 1.0, 1.0),
                ([1.0, 2.0, 4.0], 0.5, 0.5 * std::f64::consts::SQRT_2),
                ([15.0, 16.0, 20.0], 3.0, 1.5),
                ([8.0, 9.0, 12.0], 3.0, 2.1213203435596424),
                ([2.0, 3.0, 6.0], 1.0, 1.0),
                ([6.0, 8.0, 12.0], 1.0, 1.0),
            ][(6.0 * n.unit()) as usize];
            let size = n.tiny(0.0, 6.0);
            let p1 = if n.unit() < 0.5 { p1 } else { -p1 };
            (i, [p1 * size, 3.0 * p[1], p3 * size])
        }
        Kind::MiddleAxis => (generic, [n.tiny(1.0, 16.0), p[1].signum(), n.tiny(1.0, 16.0)]),
        Kind::PrincipalAxis => {
            let mut q = [n.tiny(1.0, 16.0), n.tiny(1.0, 16.0), n.tiny(1.0, 16.0)];
            q[(3.0 * n.unit()) as usize] = p[0].signum();
            (generic, q)
        }
        Kind::Mixed => {
            let (gap, other) = (n.tiny(0.0, 15.0).abs(), n.tiny(0.0, 15.0).abs());
            let thin = n.tiny(0.0, 3.0).abs();
            let moments = if n.unit() < 0.5 { [thin, 1.0, 1.0 + thin * gap] } else { [1.0, 1.0 + gap, 1.0 + other] };
            let decades = if n.unit() < 0.5 { 16.0 } else { 0.5 };
            let momentum = p.map(|p| p * n.tiny(0.0, decades));
            (sorted(moments), momentum)
        }
    }
}

/// A momentum at the relative distance `d` from the separatrix: `(I3-I2) I1 p3^2 = (1+d) (I2-I1) I3 p1^2`.
fn on_separatrix(i: [f64; 3], d: f64, n: &mut Numbers) -> ([f64; 3], [f64; 3]) {
    let slope = ((1.0 + d) * (i[1] - i[0]) * i[2] / ((i[2] - i[1]) * i[0])).sqrt();
    let p1 = n.between(-1.0, 1.0);
    let p3 = if n.unit() < 0.5 { slope * p1 } else { -slope * p1 };
    (i, [p1, n.between(-1.0, 1.0), p3])
}

/// Largest errors over the cases of a kind.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Worst {
    /// rad.
    pub(crate) attitude: f64,
    /// Relative to the momentum's length.
    pub(crate) momentum: f64,
    /// The same, over `2^-53` times the condition number of the flow: attitude and momentum.
    pub(crate) conditioned: [f64; 2],
    /// Index of the case with the worst attitude.
    pub(crate) index: u64,
    /// How many cases were compared.
    pub(crate) count: u64,
}

/// Errors of one rotation against the truth, attitude and momentum.
pub(crate) fn errors(case: &Case, truth: &Outcome, rotation: Rotation) -> [f64; 2] {
    [truth.attitude_error(rotation), truth.momentum_error(rotation.inverse_rotate(case.momentum))]
}

/// Errors of attitude and momentum over `2^-53` times the condition numbers of the flow.
pub(crate) fn per_condition(errors: [f64; 2], condition: [f64; 2]) -> [f64; 2] {
    // The momentum in body axes is seen through the attitude's quaternion, whose own rounding (four components, and the
    // products that turn a vector) is worth a few units whatever the flow forgets.
    const SEEN_THROUGH_ROTATION: f64 = 4.0;
    [0, 1].map(|k| errors[k] / (0.5 * f64::EPSILON * condition[k].max(SEEN_THROUGH_ROTATION)))
}

/// The first `count` cases of `kind` with `|w| h` up to 10, by whichever branch the library takes, and by the elliptic
/// functions where it takes the series.
pub(crate) fn survey(kind: Kind, count: u64) -> Worst {
    let mut worst = Worst::default();
    for index in 0..count {
        let case = case(kind, index, SHORT);
        worst.count += 1;
        let truth = flow(case.moments, case.momentum, case.h);
        let record = FreeRotation::new(case.moments, Rotation::IDENTITY, case.momentum);
        let chosen = drift(case.moments, Rotation::IDENTITY, case.momentum, case.h);
        for rotation in [Some(chosen), record.at_by_elliptic_functions(case.h)].into_iter().flatten() {
            let [attitude, momentum] = errors(&case, &truth, rotation);
            if attitude > worst.attitude {
                worst.index = index;
            }
            worst.attitude = worst.attitude.max(attitude);
            worst.momentum = worst.momentum.max(momentum);
        }
    }
    worst
}

/// As [`survey`], for `|w| h` from 10 to 1000, with the errors over the flow's condition number.
pub(crate) fn long_survey(kind: Kind, count: u64) -> Worst {
    /// Beyond this condition number little can be asked of doubles.
    const HOPELESS: f64 = 1e8;
    /// Nearer to the separatrix, returns to the middle axis take too many of the oracle's 33 digits; the fixture of
    /// tests/it/hard_rotations.rs, of 60 digits, holds such cases.
    const OUT_OF_SIGHT: f64 = 1e-14;
    let mut worst = Worst::default();
    for index in 0..count {
        let case = case(kind, index, LONG);
        if separatrix_distance(case.moments, case.momentum) < OUT_OF_SIGHT {
            continue;
        }
        let condition = condition(case.moments, case.momentum, case.h);
        if condition[0] > HOPELESS {
            continue;
        }
        worst.count += 1;
        let truth = flow(case.moments, case.momentum, case.h);
        let got = errors(&case, &truth, drift(case.moments, Rotation::IDENTITY, case.momentum, case.h));
        let scaled = per_condition(got, condition);
        if scaled[0] > worst.conditioned[0] {
            worst.index = index;
        }
        worst.attitude = worst.attitude.max(got[0]);
        worst.momentum = worst.momentum.max(got[1]);
        worst.conditioned = [0, 1].map(|k| worst.conditioned[k].max(scaled[k]));
    }
    worst
}
