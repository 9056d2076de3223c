//! The 64-bit hash FNV-1a, and the hash of a scene.
//!
//! `h <- (h xor byte) * 1099511628211`. Source: docs/REFERENCES.md, Fowler, Noll and Vo. It distinguishes scenes that
//! differ by accident; it does not protect against a scene that is made to have a given hash.

use crate::constraint::joint::AddedJoint;
use crate::scene::Scene;
use std::fmt::{self, Write};

/// A hash FNV-1a in progress.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fnv1a(u64);

impl Default for Fnv1a {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv1a {
    /// Adds bytes to the hash.
    pub(super) fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The hash of all bytes added so far.
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

/// Hash of a whole scene but for its duration: of its debug text, which has every number with all its digits. A field
/// that the program defines is hashed by its own debug text. How long a run is changes nothing before its end. Joints
/// that a program has added depend on where their bodies were.
pub(super) fn of_scene(scene: &Scene, added: &[AddedJoint]) -> u64 {
    let mut hash = Fnv1a::default();
    let mut scene = Scene { duration_s: 0.0, ..scene.clone() };
    scene.method.error = None;
    // Adding bytes to the hash cannot fail.
    let _ = write!(hash, "{scene:?}");
    for joint in added {
        let _ = write!(hash, "{joint:?}");
    }
    hash.value()
}

#[cfg(test)]
mod tests {
    use super::Fnv1a;

    /// Hashes published by the authors.
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
