//! Number and positions of the contacts of round shapes that stand, lie, overhang and lean; stacks.

use crate::support::{Random, at, ball, capsule, cone, cuboid, cylinder, floor, ring, turned, yaw};
use polhode_contact::{Contact, ContactFeature, Manifold, Shape, Side, SurfaceFeature, evaluate, manifold};
use polhode_spatial::{DVec3, Pose, Rotation};
use std::f64::consts::FRAC_PI_2;

/// Contacts of A on B within 1e-9; those of the swapped pair must be the same, swapped.
fn touching(a: &Shape, pose_a: &Pose, b: &Shape, pose_b: &Pose) -> Vec<Contact> {
    let result = manifold(a, pose_a, b, pose_b, 1e-9);
    assert_swapped(&result, &manifold(b, pose_b, a, pose_a, 1e-9));
    for pair in result.contacts.windows(2) {
        assert!(pair[0].feature < pair[1].feature, "{pair:?}");
    }
    for contact in &result.contacts {
        assert_eq!(evaluate(contact.feature, a, pose_a, b, pose_b), Some(contact.geometry));
    }
    result.contacts
}

fn assert_swapped(one: &Manifold, other: &Manifold) {
    assert!((one.separation - other.separation).abs() <= 1e-13, "{one:?} {other:?}");
    assert_eq!(one.contacts.len(), other.contacts.len(), "{one:?} {other:?}");
    for contact in &one.contacts {
        let same = |c: &&Contact| (c.geometry.point - contact.geometry.point).length() < 1e-9;
        let twin = other.contacts.iter().find(same).expect("the same place");
        assert!((twin.geometry.normal + contact.geometry.normal).length() < 1e-9);
        assert!((twin.geometry.separation - contact.geometry.separation).abs() < 1e-12);
    }
}

/// Asserts that the contacts are at these points, each once.
fn assert_places(contacts: &[Contact], expected: &[DVec3]) {
    assert_eq!(contacts.len(), expected.len(), "{contacts:?}");
    for place in expected {
        let near = contacts.iter().filter(|c| (c.geometry.point - *place).length() < 1e-9).count();
        assert_eq!(near, 1, "{place} in {contacts:?}");
    }
}

fn assert_normals(contacts: &[Contact], normal: DVec3) {
    for contact in contacts {
        assert!((contact.geometry.normal - normal).length() < 1e-9, "{contact:?}");
    }
}

fn octagon(center: DVec3, radius: f64) -> Vec<DVec3> {
    let angle = |k: i32| 0.25 * std::f64::consts::PI * f64::from(k);
    let place = |k: i32| center + DVec3::new(libm::cos(angle(k)), libm::sin(angle(k)), 0.0) * radius;
    (0..8).map(place).collect()
}

/// On a floor a disc has eight contacts at its sample points, a lying cylinder or capsule two, a cone on its side two,
/// a tilted cylinder and a cone on its tip one.
#[test]
fn on_a_floor() {
    let still = Pose::IDENTITY;
    let standing = touching(&cylinder(0.3, 1.0), &at(0.1, 0.2, 0.5), &floor(), &still);
    assert_places(&standing, &octagon(DVec3::new(0.1, 0.2, 0.0), 0.3));
    let base = touching(&cone(0.3, 1.0), &at(0.1, 0.2, 0.25), &floor(), &still);
    assert_places(&base, &octagon(DVec3::new(0.1, 0.2, 0.0), 0.3));
    let lying = turned(DVec3::Y, FRAC_PI_2, DVec3::Z * 0.3);
    for shape in [cylinder(0.3, 1.0), capsule(0.3, 1.0)] {
        let line = touching(&shape, &lying, &floor(), &still);
        assert_places(&line, &[DVec3::X * 0.5, DVec3::X * -0.5]);
        assert_normals(&line, DVec3::Z);
    }
    let half_angle = libm::atan2(0.3, 1.0);
    // Turned by 90 degrees and the half angle more, the generator towards the floor is horizontal.
    let shape = cone(0.3, 1.0);
    let turn = Rotation::from_rotation_vector(DVec3::Y * (FRAC_PI_2 + half_angle));
    let apex = turn.rotate(DVec3::Z * 0.75);
    let on_side = touching(&shape, &Pose::new(turn, DVec3::Z * -apex.z), &floor(), &still);
    let length = libm::hypot(0.3, 1.0);
    assert_places(&on_side, &[DVec3::new(apex.x, 0.0, 0.0), DVec3::new(apex.x - length, 0.0, 0.0)]);
    let tip = touching(&shape, &turned(DVec3::X, 3.0, DVec3::Z * (-0.75 * libm::cos(3.0))), &floor(), &still);
    assert_eq!(tip.len(), 1);
    assert_eq!(tip[0].feature, ContactFeature::VertexFace { vertex_of: Side::A, vertex: 0, face: 0 });
    let tilt = 0.3;
    let height = 0.5 * libm::cos(tilt) + 0.3 * libm::sin(tilt);
    let edge = touching(&cylinder(0.3, 1.0), &turned(DVec3::X, tilt, DVec3::Z * height), &floor(), &still);
    assert_eq!(edge.len(), 1);
    assert_eq!(edge[0].feature, ContactFeature::Elements { a: SurfaceFeature::Rim(0), b: SurfaceFeature::Face(0) });
}

/// A slightly tilted cylinder has a contact at its exact lowest point, whatever the tilt.
#[test]
fn lowest_point_of_a_tilted_disc() {
    let mut random = Random(11);
    let shape = cylinder(0.3, 1.0);
    for exponent in 1..16 {
        for _ in 0..20 {
            let tilt = libm::exp10(-f64::from(exponent)) * random.between(0.5, 2.0);
            let axis = yaw(random.between(0.0, 7.0)).rotate(DVec3::X);
            let pose = turned(axis, tilt, DVec3::Z * (0.5 * libm::cos(tilt) + 0.3 * libm::sin(tilt)));
            let result = manifold(&shape, &pose, &floor(), &Pose::IDENTITY, 1e-3);
            let least = result.contacts.iter().map(|c| c.geometry.separation).fold(f64::INFINITY, f64::min);
            assert!((least - result.separation).abs() < 1e-12, "{tilt}: {least} {}", result.separation);
        }
    }
}

/// A cylinder that overhangs the edge of a box: the sample points over the box, the two points where the edge enters
/// and leaves the disc, and none beyond.
#[test]
fn overhanging() {
    let block = cuboid(2.0, 2.0, 1.0);
    for (x, inside) in [(1.0, 4), (0.9, 5), (1.15, 3), (1.29, 1), (0.6, 8)] {
        // Turned a little, so that no sample point is exactly on the edge.
        let pose = Pose::new(yaw(0.1), DVec3::new(x, 0.1, 0.6));
        let contacts = touching(&cylinder(0.3, 0.2), &pose, &block, &Pose::IDENTITY);
        let of_points = |c: &&Contact| matches!(c.feature, ContactFeature::VertexFace { .. });
        assert_normals(&contacts, DVec3::Z);
        let half = (0.09 - (1.0 - x) * (1.0 - x)).max(0.0_f64).sqrt();
        let crossings: Vec<Contact> = contacts.iter().filter(|c| !of_points(c)).copied().collect();
        if x > 0.7 {
            assert_places(&crossings, &[DVec3::new(1.0, 0.1 + half, 0.5), DVec3::new(1.0, 0.1 - half, 0.5)]);
        } else {
            assert!(crossings.is_empty());
        }
        let over = octagon(DVec3::ZERO, 0.3).iter().filter(|p| yaw(0.1).rotate(**p).x + x < 1.0).count();
        assert_eq!(contacts.iter().filter(of_points).count(), over, "{x}");
        assert_eq!(over, inside, "{x}");
    }
    // A wide disc over a small box: the box's corners; over a corner of a wide one: that corner too.
    let plate = touching(&cylinder(3.0, 0.2), &at(0.0, 0.0, 0.6), &block, &Pose::IDENTITY);
    assert_eq!(plate.len(), 4);
    let corner = touching(&cylinder(0.3, 0.2), &at(1.05, 1.02, 0.6), &block, &Pose::IDENTITY);
    assert_eq!(corner.iter().filter(|c| (c.geometry.point - DVec3::new(1.0, 1.0, 0.5)).length() < 1e-12).count(), 1);
    assert_eq!(corner.iter().filter(|c| matches!(c.feature, ContactFeature::Elements { .. })).count(), 2);
    // A lying cylinder across the block: where its line runs over the two edges.
    let lying = turned(DVec3::Y, FRAC_PI_2, DVec3::Z * 0.8);
    for shape in [cylinder(0.3, 4.0), capsule(0.3, 4.0)] {
        let line = touching(&shape, &lying, &block, &Pose::IDENTITY);
        assert_places(&line, &[DVec3::new(1.0, 0.0, 0.5), DVec3::new(-1.0, 0.0, 0.5)]);
        assert_normals(&line, DVec3::Z);
    }
}

/// Symmetric stacks and bodies side by side: every normal is right to 1e-9 and every gap exact, at any yaw.
#[test]
fn stackings() {
    let gaps = [0.0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6, 1e-3, -1e-3];
    for size in [1e-4, 1.0, 1e4] {
        for gap in gaps {
            for step in 0..10 {
                let angle = 0.05 + 0.17 * f64::from(step);
                let upper = |z: f64, turn: f64| Pose::new(yaw(turn), DVec3::Z * (size * (z + gap)));
                let disc = cylinder(0.5 * size, size);
                let reach = 2e-3 * size;
                let on_top: [(&Shape, Pose, &Shape, usize); 5] = [
                    (&disc, upper(1.0, angle), &disc, 16),
                    (&cylinder(0.4 * size, size), upper(1.0, angle), &disc, 8),
                    (&cuboid(size, size, size), upper(1.0, angle), &disc, 8),
                    (&cuboid(0.4 * size, 0.4 * size, size), upper(1.0, angle), &disc, 4),
                    (&cone(0.5 * size, size), upper(0.75, angle), &disc, 16),
                ];
                for (shape, pose, other, count) in on_top {
                    let result = manifold(shape, &pose, other, &Pose::IDENTITY, reach);
                    assert!((result.separation - gap * size).abs() < 4e-15 * size, "{result:?}");
                    assert_eq!(result.contacts.len(), count, "{gap} {angle} {size} {shape:?} {result:?}");
                    for contact in &result.contacts {
                        assert!((contact.geometry.normal - DVec3::Z).length() < 1e-9, "{contact:?}");
                        assert!((contact.geometry.separation - gap * size).abs() < 4e-15 * size, "{contact:?}");
                    }
                }
                // Side by side: parallel cylinders and capsules.
                let away = yaw(angle).rotate(DVec3::X);
                let beside = Pose::new(yaw(2.0 * angle), away * (size * (1.0 + gap)) + DVec3::Z * (0.2 * size));
                for shape in [&disc, &capsule(0.5 * size, size)] {
                    let result = manifold(shape, &beside, &disc, &Pose::IDENTITY, reach);
                    assert!((result.separation - gap * size).abs() < 4e-15 * size, "{result:?}");
                    assert_eq!(result.contacts.len(), 2, "{gap} {angle} {size} {result:?}");
                    for contact in &result.contacts {
                        assert!((contact.geometry.normal - away).length() < 1e-9, "{contact:?}");
                    }
                }
            }
        }
    }
}

/// A square whose edges are tangent to the disc under it: the points of tangency are no corners of the contact region,
/// but separate crossings are.
#[test]
fn edges_that_graze_a_disc() {
    for (size, crossings) in [(1.0, 0), (1.0 - 1e-9, 8), (1.0 + 1e-9, 0)] {
        let contacts =
            touching(&cuboid(size, size, 1.0), &Pose::new(yaw(0.1), DVec3::Z), &cylinder(0.5, 1.0), &Pose::IDENTITY);
        let of_points = contacts.iter().filter(|c| matches!(c.feature, ContactFeature::VertexFace { .. })).count();
        assert_eq!(contacts.len() - of_points, crossings, "{size} {contacts:?}");
        assert!(size < 1.0 || of_points == 8, "{size} {contacts:?}");
    }
}

/// The deciding pair of a random touching pose is among the contacts, and no contact is deeper than the separation.
#[test]
fn separation_and_contacts_agree() {
    let mut random = Random(61);
    let shapes =
        [capsule(0.2, 0.7), cylinder(0.4, 0.6), cylinder(0.5, 0.1), cone(0.4, 0.7), ball(0.3), cuboid(0.5, 0.4, 0.7)];
    for a in &shapes {
        for b in &shapes[..4] {
            for _ in 0..40 {
                let pose_b = Pose::new(random.rotation(), DVec3::ZERO);
                let (turn, direction) = (random.rotation(), random.direction());
                let (mut low, mut high) = (0.0, 3.0);
                // Moved to touch along a direction by bisection.
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let pose_a = Pose::new(turn, direction * middle);
                    let gap = polhode_contact::separation(a, &pose_a, b, &pose_b);
                    if gap > 0.0 { high = middle } else { low = middle }
                }
                let pose_a = Pose::new(turn, direction * low);
                let result = manifold(a, &pose_a, b, &pose_b, 1e-9);
                assert!(result.separation.abs() < 1e-14, "{result:?}");
                let least = result.contacts.iter().map(|c| c.geometry.separation).fold(f64::INFINITY, f64::min);
                assert!((least - result.separation).abs() < 2e-12, "{result:?} {a:?} {pose_a:?} {b:?} {pose_b:?}");
                assert_swapped(&result, &manifold(b, &pose_b, a, &pose_a, 1e-9));
                assert!(result.contacts.len() == 1, "{result:?}");
            }
        }
    }
}

/// Poses on a grid, turned by multiples of 45 degrees: faces flush, axes parallel or meeting, rims on edges, centres
/// that coincide. The result does not depend on the order of the bodies, and bodies that touch have a contact.
#[test]
fn aligned_poses() {
    let mut random = Random(808);
    let shapes = [
        capsule(0.5, 1.0),
        cylinder(0.5, 1.0),
        cylinder(1.0, 0.5),
        cone(0.5, 1.0),
        ring(1.0, 0.25),
        ball(0.5),
        cuboid(1.0, 1.0, 1.0),
    ];
    let snap = |v: DVec3, to: f64| (v / to).round() * to;
    for a in &shapes {
        for b in &shapes[..5] {
            for _ in 0..150 {
                let turn = |random: &mut Random| {
                    let axis = [DVec3::X, DVec3::Y, DVec3::Z][(random.unit() * 3.0) as usize];
                    Rotation::from_rotation_vector(axis * (0.5 * FRAC_PI_2 * (random.unit() * 8.0).floor()))
                };
                let pose_a = Pose::new(turn(&mut random), snap(random.vector() * 2.0, 0.25));
                let pose_b = Pose::new(turn(&mut random), DVec3::ZERO);
                let one = manifold(a, &pose_a, b, &pose_b, 1e-9);
                let other = manifold(b, &pose_b, a, &pose_a, 1e-9);
                let case = || format!("{a:?} {pose_a:?} {b:?} {pose_b:?} {one:?} {other:?}");
                // The distance of a torus is that of its centre circle; for two deeply overlapping tori it depends on
                // the order.
                let deep = one.separation < -0.2;
                assert!(deep || (one.separation - other.separation).abs() < 1e-12, "{}", case());
                if one.separation.abs() < 1e-12 {
                    assert!(!one.contacts.is_empty() && !other.contacts.is_empty(), "{}", case());
                    let least = one.contacts.iter().map(|c| c.geometry.separation).fold(f64::INFINITY, f64::min);
                    assert!(least.abs() < 1e-11, "{}", case());
                }
            }
        }
    }
}

/// Cylinders side by side whose axes are almost parallel: the separation is continuous and the normals right, whether
/// the angle is far below or above that at which lines count as parallel.
#[test]
fn almost_parallel() {
    // Depths are right to 4e-15 of the smaller size, 1.4 m.
    let (a, b) = (cylinder(0.3, 2.0), cylinder(0.5, 1.0));
    for exponent in 1..17 {
        for factor in [1.0, 2.0, 5.0] {
            let angle = factor * libm::exp10(-f64::from(exponent));
            for gap in [0.0, 1e-9, -1e-9, 1e-3] {
                // Turned in the plane of the axes: the end of the shorter one comes nearer by sin(angle) times half its
                // height.
                let (sine, cosine) = libm::sincos(angle);
                let lean = turned(DVec3::Y, -angle, DVec3::X * -(0.5 * cosine + 0.5 * sine + 0.3 + gap));
                let lean = Pose::new(lean.rotation.inverse(), lean.translation);
                let result = manifold(&b, &lean, &a, &Pose::IDENTITY, 1e-2);
                assert!((result.separation - gap).abs() < 6e-15, "{angle} {gap}: {result:?}");
                // Turned about the line between them: they touch in the middle.
                let twist = turned(DVec3::X, angle, DVec3::X * (0.8 + gap));
                let result = manifold(&b, &twist, &a, &Pose::IDENTITY, 1e-2);
                assert!((result.separation - gap).abs() < 6e-15, "{angle} {gap}: {result:?}");
                for contact in &result.contacts {
                    assert!((contact.geometry.normal - DVec3::X).length() <= 1.01e-2, "{contact:?}");
                }
            }
        }
    }
}

/// A capsule that is hardly longer than a ball (a fuzz finding: the ends of one of 1e-43 m coincided in the other
/// body's frame, and it had no axis): the normal at its side is perpendicular to the axis of its own frame, at any
/// position.
#[test]
fn the_normal_of_a_short_capsule_is_perpendicular_to_its_own_axis() {
    let mut random = Random(91);
    let post = cylinder(0.4, 1.0);
    for case in 0..2000 {
        let capsule = capsule(0.3, libm::exp10(random.between(-45.0, -3.0)));
        let [post_pose, pose] = [(); 2].map(|()| random.pose(1.0));
        let sides = ContactFeature::Elements { a: SurfaceFeature::Side(0), b: SurfaceFeature::Side(0) };
        let found = evaluate(sides, &post, &post_pose, &capsule, &pose).expect("two lines");
        let swapped = evaluate(sides, &capsule, &pose, &post, &post_pose).expect("two lines");
        let axes = [pose, post_pose].map(|pose| pose.rotation.rotate(DVec3::Z));
        // The normal is less certain for axes that are almost parallel.
        let rounding = 1e-14 / axes[0].cross(axes[1]).length();
        let askew = axes.iter().map(|axis| found.normal.dot(*axis).abs()).fold(0.0, f64::max);
        assert!(askew < rounding, "{case}: {askew} {found:?}");
        assert!((found.normal + swapped.normal).length() < rounding, "{case}: {found:?} {swapped:?}");
    }
}
