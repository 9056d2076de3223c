//! The free rotation of a body to 30 digits: the oracle that the exact rotation is held against.
//!
//! Euler's equations `p' = p x I^-1 p`, `q' = q (0, I^-1 p)/2` by their Taylor series in integers of 112 binary places
//! ([`crate::fixed_point`]), in as many substeps as the series likes. No elliptic function, no ordering of axes and no
//! floating point is shared with the code under test. Its own error is shown by halving the substep.

use crate::fixed_point::Fixed;
use glam::DVec3;
use polhode_spatial::Rotation;

/// Largest turn of a substep (rad), and largest phase of the momentum's elliptic functions.
const SUBSTEP: (f64, f64) = (2.0, 0.3);
/// The series ends after two terms in a row below `2^-SMALLEST`.
const SMALLEST: i32 = 110;
/// Terms of a series at most; 25 to 50 are used.
const TERMS: usize = 80;

type State = ([Fixed; 3], [Fixed; 4]);

/// Momentum in body axes and attitude after the time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Outcome {
    momentum: [Fixed; 3],
    attitude: [Fixed; 4],
    /// By which power of two the momentum was divided.
    scale: f64,
}

/// From the identity with the momentum `p` (body axes), all numbers taken as exact.
pub(crate) fn flow(moments: DVec3, momentum: DVec3, h: f64) -> Outcome {
    flow_by(moments, momentum, h, 1.0, SMALLEST)
}

/// In substeps of `part` of the usual length; terms of the series below `2^-smallest` are left out.
fn flow_by(moments: DVec3, momentum: DVec3, h: f64, part: f64, smallest: i32) -> Outcome {
    // Powers of two bring moments and momentum near one without rounding.
    let (moment_scale, scale) = (binary_size(moments.max_element()), binary_size(momentum.abs().max_element()));
    let (i, p, h) = (moments / moment_scale, momentum / scale, h * scale / moment_scale);
    let pace = rate(i, p) / part;
    // A power of two, by which the time is divided exactly.
    let steps = ((pace * h.abs()).ceil().max(1.0) as usize).next_power_of_two();
    let half = [0, 1, 2].map(|k| Fixed::ratio(h / steps as f64, 2.0 * i[k]));
    let [a, b, c] = half;
    let rates = [c - b, a - c, b - a].map(|rate| rate + rate);
    let mut momentum = [0, 1, 2].map(|k| Fixed::new(p[k]));
    let mut attitude = [Fixed::ONE, Fixed::ZERO, Fixed::ZERO, Fixed::ZERO];
    for _ in 0..steps {
        (momentum, attitude) = advance(rates, half, (momentum, attitude), smallest);
    }
    Outcome { momentum, attitude, scale }
}

/// Substeps per unit of time. Only the pace depends on it.
fn rate(moments: DVec3, momentum: DVec3) -> f64 {
    let mut axes = [0, 1, 2].map(|k| (moments[k], momentum[k] * momentum[k]));
    axes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [(i1, x), (i2, y), (i3, z)] = axes;
    let (r1, r2, r3) = (1.0 / i3 - 1.0 / i2, 1.0 / i1 - 1.0 / i3, 1.0 / i2 - 1.0 / i1);
    let speed = ((x / i1 + y / i2 + z / i3) / i1).sqrt().min((x + y + z).sqrt() / i1);
    let squared_phase_rate = (-r1 * (r2 * z - r3 * y)).max(-r3 * (r2 * x - r1 * y));
    (speed / SUBSTEP.0).max(squared_phase_rate.sqrt() / SUBSTEP.1)
}

/// One substep: sums of the Taylor series.
fn advance(rates: [Fixed; 3], half: [Fixed; 3], (p0, q0): State, smallest: i32) -> State {
    let (mut p, mut z, mut q) = ([[Fixed::ZERO; 3]; TERMS], [[Fixed::ZERO; 3]; TERMS], [[Fixed::ZERO; 4]; TERMS]);
    (p[0], q[0]) = (p0, q0);
    let (mut p_sum, mut q_sum, mut small) = (p0, q0, 0);
    for k in 0..TERMS - 1 {
        z[k] = [0, 1, 2].map(|c| half[c] * p[k][c]);
        let (mut x, mut w) = ([Fixed::ZERO; 3], [Fixed::ZERO; 4]);
        for j in 0..=k {
            let (a, b, t, z) = (p[j], p[k - j], q[k - j], z[j]);
            let cross = [a[1] * b[2], a[2] * b[0], a[0] * b[1]];
            x = [0, 1, 2].map(|c| x[c] + cross[c]);
            w[0] = w[0] - t[1] * z[0] - t[2] * z[1] - t[3] * z[2];
            w[1] = w[1] + t[0] * z[0] + t[2] * z[2] - t[3] * z[1];
            w[2] = w[2] + t[0] * z[1] - t[1] * z[2] + t[3] * z[0];
            w[3] = w[3] + t[0] * z[2] + t[1] * z[1] - t[2] * z[0];
        }
        p[k + 1] = [0, 1, 2].map(|c| (rates[c] * x[c]).over(k + 1));
        q[k + 1] = w.map(|w| w.over(k + 1));
        p_sum = [0, 1, 2].map(|c| p_sum[c] + p[k + 1][c]);
        q_sum = [0, 1, 2, 3].map(|c| q_sum[c] + q[k + 1][c]);
        let is_small = p[k + 1].iter().chain(&q[k + 1]).all(|term| term.abs() < Fixed::binary(smallest));
        small = if is_small { small + 1 } else { 0 };
        if small == 2 {
            return (p_sum, q_sum);
        }
    }
    panic!("the series of the oracle does not converge: make its substep shorter");
}

impl Outcome {
    /// Of decimal numbers: momentum and attitude of a rotation whose momentum began as `start`.
    pub(crate) fn from_decimals(start: DVec3, attitude: [&str; 4], momentum: [&str; 3]) -> Self {
        let scale = binary_size(start.abs().max_element());
        let momentum = momentum.map(|p| Fixed::from_decimal(p, scale));
        Self { momentum, attitude: attitude.map(|q| Fixed::from_decimal(q, 1.0)), scale }
    }

    /// Angle of `rotation` to the true attitude, rad; 2 when it is further.
    pub(crate) fn attitude_error(&self, rotation: Rotation) -> f64 {
        self.vector_to(&rotation.to_wxyz().map(Fixed::new)).length()
    }

    /// Twice the vector part of the rotation from here to `other`.
    fn vector_to(&self, other: &[Fixed; 4]) -> DVec3 {
        let (t, [w, x, y, z]) = (self.attitude, *other);
        let vector = [
            t[0] * x - t[1] * w - t[2] * z + t[3] * y,
            t[0] * y - t[2] * w - t[3] * x + t[1] * z,
            t[0] * z - t[3] * w - t[1] * y + t[2] * x,
        ];
        2.0 * DVec3::from_array(vector.map(Fixed::to_f64))
    }

    /// Distance of `momentum` (body axes) to the true one, relative to its length.
    pub(crate) fn momentum_error(&self, momentum: DVec3) -> f64 {
        let p = momentum / self.scale;
        let difference = [0, 1, 2].map(|k| (Fixed::new(p[k]) - self.momentum[k]).to_f64());
        DVec3::from_array(difference).length() / p.length()
    }

    /// Difference of the momenta, relative to their length.
    fn momentum_to(&self, other: &Self) -> DVec3 {
        let length = DVec3::from_array(self.momentum.map(Fixed::to_f64)).length();
        let other_length = self.scale / other.scale;
        DVec3::from_array([0, 1, 2].map(|k| (other.momentum[k] - self.momentum[k]).to_f64())) / (length * other_length)
    }

    /// How far two outcomes are apart: attitude (twice the quaternions' distance, which for small angles is the angle),
    /// relative momentum.
    pub(crate) fn distance(&self, other: &Self) -> (f64, f64) {
        let q = [0, 1, 2, 3].map(|k| (self.attitude[k] - other.attitude[k]).to_f64());
        let p = [0, 1, 2].map(|k| (self.momentum[k] - other.momentum[k]).to_f64());
        let size = DVec3::from_array(self.momentum.map(Fixed::to_f64)).length();
        (2.0 * q.iter().map(|c| c * c).sum::<f64>().sqrt(), DVec3::from_array(p).length() / size)
    }
}

/// Condition numbers of the flow, attitude (rad) and momentum (relative): by how much the result moves, at most, per
/// relative perturbation of the moments, the components of the momentum and the time, each within the same bound. By
/// differences of the oracle.
pub(crate) fn condition(moments: DVec3, momentum: DVec3, h: f64) -> [f64; 2] {
    /// Relative perturbation: far above the rounding of the perturbed numbers, far below what bends the flow.
    const PERTURBATION: f64 = 1.0 / (1u64 << 36) as f64;
    /// Places for three digits of the differences.
    const PLACES: f64 = 60.0;
    // Returns to an unstable axis take as many places more as the distance from the separatrix has.
    let places = (PLACES - separatrix_distance(moments, momentum).log2()).clamp(PLACES, f64::from(SMALLEST)) as i32;
    let truth = flow_by(moments, momentum, h, 1.0, places);
    let mut columns = [[0.0; 6]; 7];
    for (k, column) in columns.iter_mut().enumerate() {
        let (mut i, mut p, mut time) = (moments, momentum, h);
        match k {
            0..3 => i[k] *= 1.0 + PERTURBATION,
            3..6 => p[k - 3] *= 1.0 + PERTURBATION,
            _ => time *= 1.0 + PERTURBATION,
        }
        let moved = flow_by(i, p, time, 1.0, places);
        let (rotation, momentum) = (truth.vector_to(&moved.attitude), truth.momentum_to(&moved));
        *column = std::array::from_fn(|c| if c < 3 { rotation[c] } else { momentum[c - 3] } / PERTURBATION);
    }
    // A convex function has its largest value at a corner of the cube of perturbations.
    let mut largest = [0.0f64; 2];
    for signs in 0..64u32 {
        let mut sum = [0.0; 6];
        for (k, column) in columns.iter().enumerate() {
            let sign = if signs >> k & 1 == 1 { -1.0 } else { 1.0 };
            for (s, c) in sum.iter_mut().zip(column) {
                *s += sign * c;
            }
        }
        let length = |v: &[f64]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
        largest = [largest[0].max(length(&sum[..3])), largest[1].max(length(&sum[3..]))];
    }
    largest
}

/// Relative distance from the separatrix: the energy's excess over that of a turn about the middle axis, over the
/// largest possible.
pub(crate) fn separatrix_distance(moments: DVec3, momentum: DVec3) -> f64 {
    let (i, p) = (moments, momentum);
    let middle = i.element_sum() - i.min_element() - i.max_element();
    let excess = (p * p * (i - middle) / i).element_sum().abs() / p.length_squared();
    excess * middle / (i.max_element() - i.min_element())
}

/// The power of two at or below `x`.
fn binary_size(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (0x7ff << 52))
}

/// The oracle's own error: half the substep changes nothing in 25 digits, over ten and a hundred
/// turns and off an unstable axis.
#[test]
fn halving_the_substep_changes_nothing() {
    for (moments, momentum, h) in [
        (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.4, 1.6, 1.2), 10.0),
        (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1e-9, 1.6, 1e-12), 30.0),
        (DVec3::new(1e-3, 1.0, 1.0005), DVec3::new(0.01, 1.0, 0.3), 3.0),
        (DVec3::new(5.0, 1.0, 3.0), DVec3::new(-0.4, 1.6, 1.2), -150.0),
    ] {
        let (angle, distance) = flow(moments, momentum, h).distance(&flow_by(moments, momentum, h, 0.5, SMALLEST));
        assert!(angle < 1e-25 && distance < 1e-25, "{angle:e} {distance:e}");
    }
}
