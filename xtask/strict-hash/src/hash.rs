//! The strict hash of a record: [`polhode::RunHash`] of what was recorded.

use polhode::{Observer as _, Recorder, RunHash};

/// The strict hash of all samples and events.
pub fn strict_hash(record: &Recorder) -> u64 {
    let mut hash = RunHash::default();
    record.times_s.iter().zip(&record.samples).for_each(|(&t_s, bodies)| hash.sample(t_s, bodies));
    record.events.iter().for_each(|event| hash.event(event));
    hash.value()
}

/// A strict hash as it is written: 16 hexadecimal digits.
pub fn hash_words(hash: u64) -> String {
    format!("{hash:016x}")
}
