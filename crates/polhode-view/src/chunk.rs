//! Frames packed into chunks: integers, their second differences, and gzip.
//!
//! A body has 13 numbers a frame: position (quanta), orientation (quaternion, 1/32767), velocity and angular velocity
//! (quanta). Of each number the second differences over the frames of a chunk are stored, so that smooth motion leaves
//! small numbers, zigzag (`(d << 1) ^ (d >> 31)`) and in four planes of bytes, so that gzip finds the zeros. After them
//! stand, if asked for, how each body moves, its island, the number of contacts of each frame, and the contacts in
//! columns, which are in planes of bytes too: a contact differs little from that of the frame before. The load of a
//! joint stands among them as a contact without a first body: the number of the joint, the place, the direction of its
//! force, and how large that is. `viewer/` has the reader of this.

use crate::quanta::Quanta;
use flate2::{Compression, GzBuilder};
use polhode::BodySample;
use polhode::spatial::DVec3;
use std::io::{self, Write};

/// Numbers of a body in a frame.
pub const CHANNELS: usize = 13;
/// What stands in place of the first body of a contact where it is the load of a joint.
const JOINT_LOAD: u32 = u32::MAX;
/// Numbers of a contact: its two bodies, and eight numbers.
const CONTACT_COLUMNS: usize = 10;
/// What a component of a quaternion is multiplied by.
pub const QUATERNION_STEPS: f64 = 32767.0;
/// The island of a body that is in none.
pub const NO_ISLAND: u16 = u16::MAX;
/// Frames of a chunk at the most: more compress no better.
const MOST_FRAMES: usize = 256;
/// Frames of a chunk at the least, so that the first frame, which is stored whole, costs little.
const FEWEST_FRAMES: usize = 32;
/// Bodies times frames of a chunk, about: 13 numbers of 4 bytes each are 3.4 MB.
const BODY_FRAMES: usize = 65_536;
/// Position quanta of the grid that places of contacts are rounded to: a thousandth of the smallest body.
const PLACE_QUANTA: f64 = 1000.0;
/// Bits that are kept of the 24 of a normal's components: its direction is right to a quarter of a degree.
const NORMAL_BITS: u32 = 9;
/// Bits that are kept of separations.
const SEPARATION_BITS: u32 = 6;
/// Bits that are kept of forces: they are right to 0.4 %.
const FORCE_BITS: u32 = 8;

/// A contact of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChunkContact {
    /// Numbers of the bodies A and B.
    pub bodies: [u32; 2],
    /// Place (m), normal from B to A, separation (m), force (N; NaN if unknown).
    pub numbers: [f32; 8],
}

impl ChunkContact {
    /// With as many digits as drawing needs.
    pub fn new(
        bodies: [usize; 2],
        place: DVec3,
        normal: DVec3,
        separation_m: f64,
        force_n: f64,
        quanta: Quanta,
    ) -> Self {
        // A power of two, so that the lowest bits of the rounded numbers are zero.
        let grid = power_of_two_above(PLACE_QUANTA * quanta.position_m);
        let [x, y, z] = place.to_array().map(|number| ((number / grid).round() * grid) as f32);
        let [a, b, c] = normal.to_array().map(|number| shortened(number, NORMAL_BITS));
        let (separation, force) = (shortened(separation_m, SEPARATION_BITS), shortened(force_n, FORCE_BITS));
        Self { bodies: bodies.map(|body| body as u32), numbers: [x, y, z, a, b, c, separation, force] }
    }
}

impl ChunkContact {
    /// The force (N, world) of a joint on its first body, at a place (m); NaN if unknown.
    pub fn of_joint(joint: usize, place: DVec3, force_n: DVec3, quanta: Quanta) -> Self {
        let size = force_n.length();
        let direction = if size > 0.0 { force_n / size } else { DVec3::ZERO };
        let load = Self::new([0, joint], place, direction, f64::NAN, size, quanta);
        Self { bodies: [JOINT_LOAD, load.bodies[1]], ..load }
    }

    /// Its columns in a chunk: the bodies, and the bits of its numbers.
    fn words(&self) -> [u32; CONTACT_COLUMNS] {
        let ([a, b], numbers) = (self.bodies, self.numbers.map(f32::to_bits));
        std::array::from_fn(|column| match column {
            0 => a,
            1 => b,
            _ => numbers[column - 2],
        })
    }
}

/// The smallest power of two that is not below a positive number.
fn power_of_two_above(number: f64) -> f64 {
    let (mantissa, exponent) = libm::frexp(number);
    libm::ldexp(1.0, if mantissa > 0.5 { exponent } else { exponent - 1 })
}

/// A number with so many bits of its mantissa, rounded.
fn shortened(number: f64, bits: u32) -> f32 {
    let number = number as f32;
    if !number.is_finite() {
        return number;
    }
    let dropped = f32::MANTISSA_DIGITS - bits;
    f32::from_bits((number.to_bits() + (1 << (dropped - 1))) & !((1 << dropped) - 1))
}

/// What a frame has besides poses and velocities, for the bodies of the chunk in their order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChunkDetails {
    /// How each body moves: 0 given, 1 flight, 2 integrated, 3 rest.
    pub motions: Vec<u8>,
    /// Island of each body, [`NO_ISLAND`] for none.
    pub islands: Vec<u16>,
    /// Contacts.
    pub contacts: Vec<ChunkContact>,
}

/// Frames that are being collected.
#[derive(Debug)]
pub struct Chunk {
    bodies: usize,
    quanta: Quanta,
    /// Frame by frame, body by body, number by number.
    numbers: Vec<[i32; CHANNELS]>,
    details: Vec<ChunkDetails>,
    frames: usize,
    /// The last orientation of each body: signs go on continuously, also from chunk to chunk.
    last: Vec<[f64; 4]>,
}

impl Chunk {
    /// For so many bodies.
    pub fn new(bodies: usize, quanta: Quanta) -> Self {
        Self { bodies, quanta, numbers: Vec::new(), details: Vec::new(), frames: 0, last: Vec::new() }
    }

    /// Frames collected.
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// Whether it should be written.
    pub fn is_full(&self) -> bool {
        self.frames >= (BODY_FRAMES / self.bodies.max(1)).clamp(FEWEST_FRAMES, MOST_FRAMES)
    }

    /// Adds a frame of the chunk's bodies.
    pub fn add<'a>(&mut self, bodies: impl Iterator<Item = &'a BodySample>, details: Option<ChunkDetails>) {
        for (place, sample) in bodies.enumerate() {
            let mut q = sample.pose.rotation.to_wxyz();
            match self.last.get_mut(place) {
                Some(last) => {
                    if last.iter().zip(q).map(|(a, b)| a * b).sum::<f64>() < 0.0 {
                        q = q.map(|component| -component);
                    }
                    *last = q;
                }
                None => self.last.push(q),
            }
            let (p, v, w) = (sample.pose.translation, sample.velocity.linear, sample.velocity.angular);
            let Quanta { position_m, velocity_m_s, spin_rad_s } = self.quanta;
            let steps = |vector: DVec3, quantum: f64| vector.to_array().map(|number| whole(number / quantum));
            let ([px, py, pz], [vx, vy, vz]) = (steps(p, position_m), steps(v, velocity_m_s));
            let ([wx, wy, wz], [qw, qx, qy, qz]) = (steps(w, spin_rad_s), q.map(|c| whole(c * QUATERNION_STEPS)));
            self.numbers.push([px, py, pz, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz]);
        }
        self.details.extend(details);
        self.frames += 1;
    }

    /// The collected frames, packed and compressed; the chunk is empty then.
    ///
    /// # Errors
    /// None but those of writing to memory.
    pub fn take(&mut self) -> io::Result<Vec<u8>> {
        let mut bytes = self.planes();
        self.add_details(&mut bytes);
        self.numbers.clear();
        self.details.clear();
        self.frames = 0;
        let mut gzip = GzBuilder::new().write(Vec::new(), Compression::best());
        gzip.write_all(&bytes)?;
        gzip.finish()
    }

    /// Second differences in planes of bytes.
    fn planes(&self) -> Vec<u8> {
        let (bodies, frames) = (self.bodies, self.frames);
        let count = CHANNELS * bodies * frames;
        let mut bytes = vec![0; 4 * count];
        let mut place = 0;
        for channel in 0..CHANNELS {
            for body in 0..bodies {
                let (mut before, mut last) = (0_i32, 0_i32);
                for frame in 0..frames {
                    let x = self.numbers[frame * bodies + body][channel];
                    let d = match frame {
                        0 => x,
                        1 => x.wrapping_sub(last),
                        _ => x.wrapping_sub(last).wrapping_sub(last).wrapping_add(before),
                    };
                    (before, last) = (last, x);
                    let zigzag = ((d << 1) ^ (d >> 31)).cast_unsigned();
                    for (plane, byte) in zigzag.to_le_bytes().into_iter().enumerate() {
                        bytes[plane * count + place] = byte;
                    }
                    place += 1;
                }
            }
        }
        bytes
    }

    fn add_details(&self, bytes: &mut Vec<u8>) {
        if self.details.is_empty() {
            return;
        }
        for body in 0..self.bodies {
            bytes.extend(self.details.iter().map(|frame| frame.motions[body]));
        }
        for body in 0..self.bodies {
            bytes.extend(self.details.iter().flat_map(|frame| frame.islands[body].to_le_bytes()));
        }
        bytes.extend(self.details.iter().flat_map(|frame| (frame.contacts.len() as u32).to_le_bytes()));
        let contacts: Vec<[u32; CONTACT_COLUMNS]> =
            self.details.iter().flat_map(|frame| &frame.contacts).map(ChunkContact::words).collect();
        for plane in 0..4 {
            for column in 0..CONTACT_COLUMNS {
                bytes.extend(contacts.iter().map(|words| words[column].to_le_bytes()[plane]));
            }
        }
    }
}

/// The nearest whole number that fits.
fn whole(number: f64) -> i32 {
    // The conversion saturates, and makes zero of NaN.
    number.round() as i32
}
