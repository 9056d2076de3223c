//! Random numbers with a fixed seed, so that a failing case can be found again: the one generator of this program.
//!
//! SplitMix64 (docs/REFERENCES.md, Steele, Lea and Flood 2014). It is not that of the crates, whose draws are judged
//! here.

use glam::DVec3;
use polhode_spatial::Rotation;

/// The generator; the number is its seed, and then its state.
#[derive(Debug)]
pub struct Random(pub u64);

impl Random {
    /// Uniform from 0 to below 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number from 0 to `count - 1`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.between(0.0, count as f64) as usize).min(count.saturating_sub(1))
    }

    /// One of some values.
    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// Three numbers between two numbers.
    pub fn vector(&mut self, low: f64, high: f64) -> DVec3 {
        DVec3::new(self.between(low, high), self.between(low, high), self.between(low, high))
    }

    /// Uniform on the unit sphere.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector(-1.0, 1.0);
            if (0.1..=1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    /// Any rotation.
    pub fn rotation(&mut self) -> Rotation {
        Rotation::from_rotation_vector(self.direction() * self.between(0.0, std::f64::consts::PI))
    }
}

#[cfg(test)]
mod tests {
    //! The sequence is that of the published generator.
    use super::*;

    #[test]
    fn the_sequence_is_that_of_splitmix64() {
        // The first outputs for the seed 0, as published with the generator: 0xE220A8397B1DCDAF, 0x6E789E6AA1B965F4.
        let mut random = Random(0);
        let upper = |number: u64| (number >> 11) as f64 / (1_u64 << 53) as f64;
        assert_eq!(random.unit(), upper(0xE220_A839_7B1D_CDAF));
        assert_eq!(random.unit(), upper(0x6E78_9E6A_A1B9_65F4));
    }
}
