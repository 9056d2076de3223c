//! Frames come back from their chunks within half a quantum.

use flate2::read::GzDecoder;
use polhode::BodySample;
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode_view::chunk::{CHANNELS, Chunk, ChunkContact, ChunkDetails, QUATERNION_STEPS};
use polhode_view::quanta::Quanta;
use proptest::prelude::*;
use std::io::Read;

const QUANTA: Quanta = Quanta { position_m: 1e-6, velocity_m_s: 1e-5, spin_rad_s: 1e-5 };

/// The numbers of a chunk as whole numbers: `[channel][body][frame]`, and what stands after them.
pub(crate) fn unpack(packed: &[u8], bodies: usize, frames: usize) -> (Vec<Vec<Vec<i32>>>, Vec<u8>) {
    let mut bytes = Vec::new();
    GzDecoder::new(packed).read_to_end(&mut bytes).unwrap();
    let count = CHANNELS * bodies * frames;
    let zigzag = |i: usize| u32::from_le_bytes([0, 1, 2, 3].map(|plane| bytes[plane * count + i]));
    let mut channels = vec![vec![Vec::new(); bodies]; CHANNELS];
    for (place, i) in (0..CHANNELS * bodies).zip((0..count).step_by(frames)) {
        let numbers = &mut channels[place / bodies][place % bodies];
        for frame in 0..frames {
            let zigzag = zigzag(i + frame);
            let d = (zigzag >> 1) as i32 ^ -((zigzag & 1) as i32);
            let back = |k: usize| if frame >= k { numbers[frame - k] } else { 0 };
            numbers.push(match frame {
                0 => d,
                1 => d.wrapping_add(back(1)),
                _ => d.wrapping_add(back(1)).wrapping_add(back(1)).wrapping_sub(back(2)),
            });
        }
    }
    (channels, bytes.split_off(4 * count))
}

fn sample(numbers: [f64; 12]) -> BodySample {
    let vector = |i: usize| DVec3::new(numbers[i], numbers[i + 1], numbers[i + 2]);
    BodySample {
        pose: Pose::new(Rotation::from_rotation_vector(vector(3)), vector(0)),
        velocity: Velocity { linear: vector(6), angular: vector(9) },
    }
}

proptest! {
    #[test]
    fn numbers_come_back(
        frames in 1..20_usize,
        numbers in prop::collection::vec(prop::array::uniform12(-50.0..50.0_f64), 60),
    ) {
        let samples: Vec<BodySample> = numbers.into_iter().map(sample).collect();
        let mut chunk = Chunk::new(3, QUANTA);
        for frame in 0..frames {
            chunk.add(samples[3 * frame..3 * frame + 3].iter(), None);
        }
        let (channels, rest) = unpack(&chunk.take().unwrap(), 3, frames);
        prop_assert!(rest.is_empty());
        for (i, sample) in samples[..3 * frames].iter().enumerate() {
            let number = |channel: usize| f64::from(channels[channel][i % 3][i / 3]);
            let vector = |channel: usize, unit: f64| {
                DVec3::from_array([0, 1, 2].map(|axis| number(channel + axis))) * unit
            };
            let half = |unit: f64| 0.5 * unit * (1.0 + 1e-6);
            let apart = |a: DVec3, b: DVec3| (a - b).abs().max_element();
            prop_assert!(apart(vector(0, QUANTA.position_m), sample.pose.translation) <= half(QUANTA.position_m));
            prop_assert!(apart(vector(7, QUANTA.velocity_m_s), sample.velocity.linear) <= half(QUANTA.velocity_m_s));
            prop_assert!(apart(vector(10, QUANTA.spin_rad_s), sample.velocity.angular) <= half(QUANTA.spin_rad_s));
            let q = [3, 4, 5, 6].map(|channel| number(channel) / QUATERNION_STEPS);
            let wxyz = sample.pose.rotation.to_wxyz();
            let sign: f64 = q.iter().zip(wxyz).map(|(a, b)| a * b).sum::<f64>().signum();
            prop_assert!(q.iter().zip(wxyz).all(|(a, b)| (a - sign * b).abs() <= half(1.0 / QUATERNION_STEPS)));
        }
    }
}

/// A body that turns through several turns: no component jumps, from chunk to chunk either.
#[test]
fn signs_of_quaternions_go_on() {
    let mut chunk = Chunk::new(1, QUANTA);
    let mut last: Option<[i32; 4]> = None;
    for part in 0..4 {
        for i in 0..50 {
            let angle = 0.1 * f64::from(50 * part + i);
            let turned = Rotation::from_rotation_vector(DVec3::new(0.0, 0.6, 0.8) * angle);
            // The same rotation with either sign.
            let q = turned.to_wxyz().map(|component| if i % 3 == 0 { -component } else { component });
            let pose = Pose::new(Rotation::from_wxyz(q).unwrap(), DVec3::ZERO);
            let still = Velocity { linear: DVec3::ZERO, angular: DVec3::ZERO };
            chunk.add([BodySample { pose, velocity: still }].iter(), None);
        }
        let (channels, _) = unpack(&chunk.take().unwrap(), 1, 50);
        for frame in 0..50 {
            let q = [3, 4, 5, 6].map(|channel| channels[channel][0][frame]);
            if let Some(last) = last.replace(q) {
                assert!(q.iter().zip(last).all(|(a, b)| (a - b).abs() < 2000), "{q:?} {last:?}");
            }
        }
    }
}

/// What lies beyond the range of 32 bits stays at its border.
#[test]
fn far_away() {
    let mut chunk = Chunk::new(1, QUANTA);
    for x in [0.0, 1e9, -1e9, 1.0] {
        chunk.add([sample([x, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])].iter(), None);
    }
    let (channels, _) = unpack(&chunk.take().unwrap(), 1, 4);
    assert_eq!(channels[0][0], [0, i32::MAX, i32::MIN, 1_000_000]);
}

/// How bodies move, their islands, and contacts.
#[test]
fn details_come_back() {
    let mut chunk = Chunk::new(2, QUANTA);
    let contact = ChunkContact::new([1, 0], DVec3::new(0.5, -2.0, 0.0), DVec3::Z, -1e-9, f64::NAN, QUANTA);
    for frame in 0..3_u8 {
        let contacts = vec![contact; usize::from(frame)];
        let details = ChunkDetails { motions: vec![frame, 3], islands: vec![u16::MAX, 7], contacts };
        chunk.add([sample([0.0; 12]), sample([1.0; 12])].iter(), Some(details));
    }
    let (_, rest) = unpack(&chunk.take().unwrap(), 2, 3);
    assert_eq!(rest[..6], [0, 1, 2, 3, 3, 3]);
    assert_eq!(rest[6..18], [255, 255, 255, 255, 255, 255, 7, 0, 7, 0, 7, 0]);
    assert_eq!(rest[18..30], [0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
    assert_eq!(rest.len(), 30 + 3 * 40);
    // Three contacts in ten columns, the columns in four planes of bytes.
    let word = |column: usize| u32::from_le_bytes([0, 1, 2, 3].map(|plane| rest[30 + (plane * 10 + column) * 3 + 2]));
    assert_eq!([word(0), word(1)], [1, 0]);
    let numbers: Vec<f32> = (2..10).map(|column| f32::from_bits(word(column))).collect();
    assert_eq!(numbers[..6], [0.5, -2.0, 0.0, 0.0, 0.0, 1.0]);
    let rounded = ChunkContact::new([1, 0], DVec3::splat(1.2345), DVec3::X, 0.0, 981.0, QUANTA);
    assert!((rounded.numbers[0] - 1.2345).abs() < 1e-3 && (rounded.numbers[7] / 981.0 - 1.0).abs() < 0.004);
    assert!((numbers[6] / -1e-9 - 1.0).abs() < 0.02 && numbers[7].is_nan());
}

/// The load of a joint is told from contacts by its first body, and has its direction and size.
#[test]
fn loads_of_joints_stand_among_contacts() {
    let load = ChunkContact::of_joint(5, DVec3::new(0.5, 0.0, 1.0), DVec3::new(0.0, -3.0, 4.0), QUANTA);
    assert_eq!(load.bodies, [u32::MAX, 5]);
    let [.., x, y, z, separation, force] = load.numbers;
    assert!(separation.is_nan() && (force / 5.0 - 1.0).abs() < 0.004);
    assert!(x == 0.0 && (y + 0.6).abs() < 2e-3 && (z - 0.8).abs() < 2e-3);
    let unknown = ChunkContact::of_joint(5, DVec3::ZERO, DVec3::NAN, QUANTA);
    assert!(unknown.numbers[7].is_nan());
}
