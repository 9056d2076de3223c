//! Random pairs of convex polyhedra, from deep overlap to apart: in general poses, and face against face, level or
//! tilted by a little.

use super::feature_numbers::JudgedBody;
use glam::{DQuat, DVec3};
use polhode::spatial::{Pose, Rotation};
use polhode_contact::{Shape, manifold};
use polhode_oracles::random::Random;

/// Two bodies at poses.
pub(super) struct RandomPair {
    pub(super) bodies: [JudgedBody; 2],
    pub(super) poses: [Pose; 2],
    /// Contacts up to this separation are asked for, m.
    pub(super) reach: f64,
}

/// Separations that pairs are brought to, relative to their size; beside these any overlap.
const TARGETS: [f64; 11] = [0.0, 1e-12, -1e-12, 2e-9, -2e-9, 1e-6, -1e-6, 1e-3, -1e-3, -0.05, 0.1];

/// Contacts up to these separations are asked for, relative to the size; none is one of the targets.
const REACHES: [f64; 3] = [1e-8, 1e-4, 0.05];

/// Decimal powers between which sizes lie, m.
const SIZES: [f64; 2] = [-6.0, 4.0];

/// Angles between faces that are laid against each other, rad.
const TILTS: [f64; 8] = [0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 4e-3];

/// Thickness of plates and needles.
const THIN: f64 = 1e-3;

/// Corners of an upright prism with a regular base about the origin.
pub(super) fn prism_points(sides: u32, radius: f64, height: f64) -> Vec<DVec3> {
    let ring = |z: f64| {
        (0..sides).map(move |k| {
            let angle = f64::from(k) / f64::from(sides) * std::f64::consts::TAU;
            DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
        })
    };
    ring(-0.5 * height).chain(ring(0.5 * height)).collect()
}

/// A box, plate, needle, prism, tetrahedron or hull of random points of about this size; nothing when the points
/// happen to be flat, or have faces of which it is a matter of tolerance whether they are one.
fn polyhedron(random: &mut Random, size: f64) -> Option<JudgedBody> {
    let points = match random.below(7) {
        0 => return JudgedBody::cuboid(random.vector(0.2, 1.0) * size),
        1 => return JudgedBody::cuboid(DVec3::new(1.0, random.between(0.2, 1.0), THIN) * size),
        2 => return JudgedBody::cuboid(DVec3::new(1.0, THIN, THIN) * size),
        3 => prism_points(3 + random.below(10) as u32, random.between(0.2, 0.6), random.between(0.1, 1.0)),
        4 => (0..4).map(|_| random.vector(-0.5, 0.5)).collect(),
        5 => (0..5 + random.below(12)).map(|_| random.vector(-0.5, 0.5) * DVec3::new(1.0, THIN, THIN)).collect(),
        _ => (0..5 + random.below(12)).map(|_| random.vector(-0.5, 0.5)).collect::<Vec<_>>(),
    };
    let points: Vec<DVec3> = points.into_iter().map(|p| p * size).collect();
    JudgedBody::hull(&points)
}

/// The second body's rotation, turned so that one of its faces lies against one of the first body's.
fn facing(random: &mut Random, [first, second]: [&Shape; 2], poses: [&Pose; 2]) -> Rotation {
    let mut normal = |shape: &Shape| match shape {
        Shape::Convex(p) => p.face(random.below(p.face_count())).map_or(DVec3::Z, |face| face.normal),
        _ => DVec3::Z,
    };
    let [first, second] = [normal(first), normal(second)];
    let (from, to) = (poses[1].rotation.rotate(second), -poses[0].rotation.rotate(first));
    Rotation::renormalized(DQuat::from_rotation_arc(from, to)) * poses[1].rotation
}

/// The pair with this number. Half of the pairs stand a million metres from the origin, where their poses are rounded
/// and meant as rounded.
pub(super) fn pair(number: u64) -> RandomPair {
    let mut random = Random(number.wrapping_mul(0x9E37_79B9).wrapping_add(number));
    let size = libm::exp10(random.between(SIZES[0], SIZES[1]));
    let ratio = libm::exp10(random.between(-1.0, 0.0));
    let mut body = |size: f64| loop {
        if let Some(body) = polyhedron(&mut random, size) {
            break body;
        }
    };
    let bodies = [body(size), body(size * ratio)];
    let shapes = [&bodies[0].shape, &bodies[1].shape];
    let far = if random.below(2) == 0 { DVec3::ZERO } else { random.vector(-1.0, 1.0) * 1e6 };
    let fixed = Pose::new(random.rotation(), far);
    let distance = random.between(0.0, 0.9) * size;
    let mut moved = Pose::new(random.rotation(), far + random.direction() * distance);
    if random.below(3) == 0 {
        let tilt = random.direction() * random.one_of(&TILTS);
        let spun = facing(&mut random, shapes, [&fixed, &moved]);
        moved.rotation = Rotation::from_rotation_vector(tilt) * spun;
    }
    let target = random.below(TARGETS.len() + 3);
    if let Some(target) = TARGETS.get(target) {
        // Moved along the normal, a pair comes to any separation; where another axis takes over, it is moved again.
        for _ in 0..8 {
            let at = manifold(shapes[0], &fixed, shapes[1], &moved, f64::INFINITY);
            let Some(contact) = at.contacts.first() else { break };
            moved.translation -= contact.geometry.normal * (target * size - at.separation);
        }
    }
    RandomPair { poses: [fixed, moved], reach: random.one_of(&REACHES) * size, bodies }
}
