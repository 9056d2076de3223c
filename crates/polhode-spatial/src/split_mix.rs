//! Pseudo-random numbers, for estimates and for tests: SplitMix64.
//!
//! A counter whose bits are mixed; period 2^64, equally distributed, the same on every platform. Source:
//! docs/REFERENCES.md, Steele, Lea and Flood 2014. Not for cryptography.

/// A sequence of pseudo-random numbers that its seed determines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SplitMix64(u64);

impl SplitMix64 {
    /// The sequence of a seed; any number is one.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The seed of the numbers that are still to come.
    pub const fn seed(self) -> u64 {
        self.0
    }

    /// The next number, uniform over all of 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// The next number, uniform in [0, 1): one of 2^53 equidistant numbers.
    pub const fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::SplitMix64;

    /// The first numbers of the sequence of 1234567, as implementations in other languages give them.
    #[test]
    fn the_sequence_is_the_published_one() {
        let mut random = SplitMix64::new(1_234_567);
        let first = [0; 3].map(|_| random.bits());
        assert_eq!(first, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }
}
