//! The 64-bit hash FNV-1a, and that of a scene.
//!
//! `h <- (h xor byte) * 1099511628211`. Source: docs/REFERENCES.md, Fowler, Noll and Vo. It tells scenes apart that
//! differ by accident; it is no protection against one made to have the same hash.

use crate::Scene;
use std::fmt::{self, Write};

/// FNV-1a.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fnv1a(u64);

impl Default for Fnv1a {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv1a {
    /// Takes bytes in.
    pub(super) fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The hash of what has been taken in.
    pub(super) const fn value(self) -> u64 {
        self.0
    }
}

impl Write for Fnv1a {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}

/// Hash of everything that a scene says: of its debug text, in which every number stands with all its digits. Of a
/// field of the user's own it knows what that shows of itself.
pub(super) fn of_scene(scene: &Scene) -> u64 {
    let mut hash = Fnv1a::default();
    // Taking bytes in cannot fail.
    let _ = write!(hash, "{scene:?}");
    hash.value()
}

#[cfg(test)]
mod tests {
    use super::Fnv1a;

    /// The values that the authors publish.
    #[test]
    fn hashes_are_those_of_fowler_noll_and_vo() {
        for (text, expected) in
            [("", 0xcbf2_9ce4_8422_2325), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            let mut hash = Fnv1a::default();
            hash.add(text.as_bytes());
            assert_eq!(hash.value(), expected, "{text:?}");
        }
    }
}
