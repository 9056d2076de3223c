//! Symmetric stacks, where many features coincide and several axes separate equally well: exact touch, every gap, every
//! size.

use crate::support::{Random, at, cuboid, prism, yaw};
use polhode_contact::{ContactFeature, Shape, manifold, separation};
use polhode_spatial::{DVec3, Pose, Rotation};

const GAPS: [f64; 9] = [1e-3, 1e-6, 1e-9, 1e-12, 0.0, -1e-12, -1e-9, -1e-6, -1e-3];

/// A prism on a box four times as wide: the normal is exact, every corner of the prism is one contact on the box's top
/// face, and its depth is the gap to rounding.
#[test]
fn prism_on_a_wide_box() {
    for sides in [3, 4, 5, 6, 8, 12, 32] {
        for size in [1e-6, 1e-4, 1.0, 1e4] {
            let (lower, upper) = (cuboid(4.0 * size, 4.0 * size, 4.0 * size), prism(sides, 0.5 * size, size));
            for gap in GAPS {
                for turn in 0..30 {
                    let pose = Pose::new(yaw(f64::from(turn) * 0.1), DVec3::Z * (2.5 + gap) * size);
                    let result = manifold(&upper, &pose, &lower, &Pose::IDENTITY, 0.01 * size);
                    assert_eq!(result.contacts.len(), sides as usize, "{sides} {size} {gap} {turn}");
                    for contact in &result.contacts {
                        assert!(matches!(contact.feature, ContactFeature::VertexFace { .. }));
                        assert!((contact.geometry.normal - DVec3::Z).length() < 1e-15);
                        assert!((contact.geometry.separation - gap * size).abs() <= 4e-15 * size);
                    }
                    assert!((result.separation - gap * size).abs() <= 4e-15 * size);
                }
            }
        }
    }
}

/// A prism on another one with a different number of sides, rotated together. Edges of the two that are far apart and
/// almost parallel have a common perpendicular with a large rounding error. It must not separate better than the faces:
/// the separation is the gap.
#[test]
fn an_axis_of_edges_far_apart_does_not_change_the_separation() {
    let tilt = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, -1.1, 0.7)), DVec3::ZERO);
    let mut worst: f64 = 0.0;
    for size in [1e-2, 1.0, 1e4] {
        for sides in 3..=64 {
            let (lower, upper) = (prism(67 - sides, 0.45 * size, 0.7 * size), prism(sides, 0.5 * size, size));
            for gap in [-1e-4, 0.0] {
                for degrees in 0..90 {
                    let height = DVec3::Z * (0.5 * size + 0.5 * (0.7 * size) + gap * size);
                    let above = Pose::new(yaw(f64::from(degrees).to_radians()), height);
                    let place = tilt * above;
                    let measured = manifold(&upper, &place, &lower, &tilt, 0.01 * size).separation;
                    for found in [measured, separation(&upper, &place, &lower, &tilt)] {
                        worst = worst.max((found - gap * size).abs() / size);
                    }
                }
            }
        }
    }
    // The poses and normals of the tilted bodies have a rounding of about 1e-15 of their size.
    assert!(worst < 5e-15, "{worst}");
}

/// Equal cubes on each other, turned: four contacts when aligned, else the eight crossings of an octagon.
#[test]
fn turned_cubes() {
    for size in [1e-6, 0.5, 0.8, 1.0, 1e4] {
        let cube = cuboid(size, size, size);
        for gap in GAPS {
            for degrees in 0..90 {
                let turn = yaw(f64::from(degrees).to_radians());
                let result = manifold(
                    &cube,
                    &Pose::new(turn, DVec3::Z * (1.0 + gap) * size),
                    &cube,
                    &Pose::IDENTITY,
                    0.01 * size,
                );
                let expected = if degrees == 0 { 4 } else { 8 };
                assert_eq!(result.contacts.len(), expected, "{size} {gap} {degrees}");
                for contact in &result.contacts {
                    assert!((contact.geometry.normal - DVec3::Z).length() < 1e-13, "{degrees} {contact:?}");
                    assert!((contact.geometry.separation - gap * size).abs() <= 4e-15 * size);
                    assert!(contact.geometry.margin >= -1e-15 * size);
                }
            }
        }
    }
}

/// Equal prisms on each other, turned by any angle: 2n crossings, or n vertices when the corners coincide; the
/// contacts' hull is the overlap of the two polygons.
#[test]
fn turned_prisms() {
    let mut random = Random(7);
    for sides in [3, 4, 5, 6, 7, 8, 12, 16, 32] {
        let shape = prism(sides, 0.5, 1.0);
        let step = std::f64::consts::TAU / f64::from(sides);
        for _ in 0..40 {
            let fraction = random.between(0.02, 0.98);
            let pose = Pose::new(yaw(fraction * step), DVec3::Z);
            let result = manifold(&shape, &pose, &shape, &Pose::IDENTITY, 1e-9);
            assert_eq!(result.contacts.len(), 2 * sides as usize);
            assert!(result.contacts.iter().all(|c| matches!(c.feature, ContactFeature::EdgeEdge { .. })));
        }
        for turns in 0..3 {
            let pose = Pose::new(yaw(f64::from(turns) * step), DVec3::Z);
            let result = manifold(&shape, &pose, &shape, &Pose::IDENTITY, 1e-9);
            assert_eq!(result.contacts.len(), sides as usize, "{sides} {turns}");
        }
    }
}

/// Turned by an angle between rounding and anything visible, equal cubes keep at least their four corners, and every
/// normal is right.
#[test]
fn tiny_turns_and_tilts() {
    let cube = cuboid(1.0, 1.0, 1.0);
    for exponent in 3..17 {
        let angle = 10_f64.powi(-exponent);
        let turned = manifold(&cube, &Pose::new(yaw(angle), DVec3::Z), &cube, &Pose::IDENTITY, 1e-9);
        assert!([4, 8].contains(&turned.contacts.len()), "{exponent}: {}", turned.contacts.len());
        assert!(turned.contacts.iter().all(|c| (c.geometry.normal - DVec3::Z).length() < 1e-8), "{turned:?}");
        // Tilted by the angle about an edge, it keeps the contacts within reach and drops the others.
        let tilt = Rotation::from_rotation_vector(DVec3::Y * angle);
        let pose = Pose::new(tilt, DVec3::new(0.5, 0.0, 0.5) + tilt.rotate(DVec3::new(-0.5, 0.0, 0.5)));
        let tilted = manifold(&cube, &pose, &cube, &Pose::IDENTITY, 3e-8);
        let expected = if angle < 3e-8 { 4 } else { 2 };
        assert_eq!(tilted.contacts.len(), expected, "{exponent} {tilted:?}");
    }
}

/// Bodies of very different sizes and proportions on each other (a cube on a wide thin plate, two long crossed beams, a
/// grain on a huge box) have four contacts.
#[test]
fn extreme_aspect_ratios() {
    let plate = cuboid(500.0, 500.0, 1e-3);
    let cube = cuboid(0.5, 0.5, 0.5);
    let on_plate = manifold(&cube, &at(3.0, 4.0, 0.25 + 5e-4), &plate, &Pose::IDENTITY, 1e-9);
    assert_eq!(on_plate.contacts.len(), 4);
    let beam = cuboid(1000.0, 1.0, 1.0);
    let across = Pose::new(yaw(std::f64::consts::FRAC_PI_2), DVec3::Z);
    assert_eq!(manifold(&beam, &across, &beam, &Pose::IDENTITY, 1e-9).contacts.len(), 4);
    let floor: Shape = cuboid(1e4, 1e4, 1e4);
    let grain = cuboid(1e-2, 1e-2, 1e-2);
    let on_floor = manifold(&grain, &at(123.0, -45.0, 5000.0 + 5e-3), &floor, &Pose::IDENTITY, 1e-9);
    assert_eq!(on_floor.contacts.len(), 4);
}
