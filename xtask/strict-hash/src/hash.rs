//! The strict hash of a run: a change of a single bit shows.

use glam::DVec3;
use polhode::Recorder;

/// FNV-1a over all bits of all samples and events.
pub fn strict_hash(record: &Recorder) -> u64 {
    let mut hash = Fnv::default();
    for (time, bodies) in record.times_s.iter().zip(&record.samples) {
        hash.number(*time);
        for sample in bodies {
            let q = sample.pose.rotation.to_wxyz();
            let vectors = [sample.pose.translation, sample.velocity.linear, sample.velocity.angular];
            vectors.iter().flat_map(DVec3::to_array).chain(q).for_each(|x| hash.number(x));
        }
    }
    for event in &record.events {
        event.kind.word().bytes().for_each(|byte| hash.byte(byte));
        let scalars = [event.t_s, event.impulse, event.energy_change_j];
        let vectors = event.point.to_array().into_iter().chain(event.normal.to_array());
        scalars.into_iter().chain(vectors).for_each(|x| hash.number(x));
    }
    hash.0
}

/// A strict hash as it is written: 16 hexadecimal digits.
pub fn hash_words(hash: u64) -> String {
    format!("{hash:016x}")
}

/// The 64-bit FNV-1a hash.
#[derive(Debug)]
struct Fnv(u64);

impl Default for Fnv {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }

    fn number(&mut self, number: f64) {
        number.to_bits().to_le_bytes().into_iter().for_each(|byte| self.byte(byte));
    }
}

#[cfg(test)]
mod tests {
    //! The hash is the published one.
    use super::*;

    #[test]
    fn the_hash_is_fnv_1a() {
        let mut hash = Fnv::default();
        b"foobar".iter().for_each(|&byte| hash.byte(byte));
        assert_eq!(hash.0, 0x8594_4171_f739_67e8);
    }
}
