//! The strict hash of a run: a change of a single bit shows.
//!
//! FNV-1a (64 bits) over the bits of all samples, and then of all events. Two programs that make the same hash of a
//! scene have computed the same motion to the last bit, on whatever platform.

use crate::report::body_sample::BodySample;
use crate::report::event::Event;
use crate::report::observer::Observer;
use polhode_spatial::DVec3;

/// Takes the strict hash of a run while it goes on.
///
/// ```
/// use polhode::spatial::{DVec3, Inertia, Mass, MassProperties};
/// use polhode::{Body, RunHash, Scene, Simulation};
/// let stone = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::ONE)?);
/// let scene = Scene::builder("fall").duration_s(0.1).body(Body::movable("stone", stone)).build()?;
/// let mut hashes = [RunHash::default(), RunHash::default()];
/// for hash in &mut hashes {
///     Simulation::new(&scene)?.run_observed(hash)?;
/// }
/// assert_eq!(hashes[0].value(), hashes[1].value());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct RunHash {
    samples: Fnv,
    count: u64,
    events: Vec<Event>,
}

/// Up to where a hash had been taken: it goes on from there again.
#[derive(Debug, Clone, Copy)]
pub struct RunHashPlace {
    samples: Fnv,
    count: u64,
    events: usize,
}

impl RunHash {
    /// The hash of all samples and events so far.
    pub fn value(&self) -> u64 {
        let mut hash = self.samples;
        for event in &self.events {
            event.kind.word().bytes().for_each(|byte| hash.byte(byte));
            let scalars = [event.t_s, event.impulse, event.energy_change_j];
            let vectors = event.point.to_array().into_iter().chain(event.normal.to_array());
            scalars.into_iter().chain(vectors).for_each(|x| hash.number(x));
        }
        hash.0
    }

    /// How many samples it is of.
    pub const fn samples(&self) -> u64 {
        self.count
    }

    /// The events that it is of, in order of time.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Up to where it has been taken.
    pub fn place(&self) -> RunHashPlace {
        RunHashPlace { samples: self.samples, count: self.count, events: self.events.len() }
    }

    /// Goes back to where it was, and on from there.
    pub fn return_to(&mut self, place: RunHashPlace) {
        (self.samples, self.count) = (place.samples, place.count);
        self.events.truncate(place.events);
    }
}

impl Observer for RunHash {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.count += 1;
        self.samples.number(t_s);
        for sample in bodies {
            let q = sample.pose.rotation.to_wxyz();
            let vectors = [sample.pose.translation, sample.velocity.linear, sample.velocity.angular];
            vectors.iter().flat_map(DVec3::to_array).chain(q).for_each(|x| self.samples.number(x));
        }
    }

    fn event(&mut self, event: &Event) {
        self.events.push(*event);
    }
}

/// The 64-bit FNV-1a hash.
#[derive(Debug, Clone, Copy)]
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
    //! The hash is the published one, and goes on from where it was.
    use super::*;

    #[test]
    fn the_hash_is_fnv_1a() {
        let mut hash = Fnv::default();
        b"foobar".iter().for_each(|&byte| hash.byte(byte));
        assert_eq!(hash.0, 0x8594_4171_f739_67e8);
    }

    #[test]
    fn what_is_taken_again_from_a_place_has_the_same_value() {
        let mut hash = RunHash::default();
        hash.sample(0.0, &[]);
        let place = hash.place();
        hash.sample(1.0, &[]);
        let value = hash.value();
        hash.return_to(place);
        assert_ne!(hash.value(), value);
        hash.sample(1.0, &[]);
        assert_eq!((hash.value(), hash.samples()), (value, 2));
    }
}
