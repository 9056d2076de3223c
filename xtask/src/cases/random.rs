//! Random numbers with a fixed seed, so that a failing case can be found again.

use glam::DVec3;
use polhode::spatial::Rotation;

/// SplitMix64 (docs/REFERENCES.md, Steele, Lea and Flood 2014).
pub(super) struct Random(pub(super) u64);

impl Random {
    /// Uniform between two numbers.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A whole number from 0 to `count - 1`.
    pub(super) fn below(&mut self, count: usize) -> usize {
        (self.between(0.0, count as f64) as usize).min(count.saturating_sub(1))
    }

    /// One of some values.
    pub(super) fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    pub(super) fn vector(&mut self, low: f64, high: f64) -> DVec3 {
        DVec3::new(self.between(low, high), self.between(low, high), self.between(low, high))
    }

    /// Uniform on the unit sphere.
    pub(super) fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector(-1.0, 1.0);
            if (0.1..=1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    /// Any rotation.
    pub(super) fn rotation(&mut self) -> Rotation {
        Rotation::from_rotation_vector(self.direction() * self.between(0.0, std::f64::consts::PI))
    }
}
