//! Separations of capsules, cylinders and cones: closed forms, and random pairs between bounds that share no code with
//! the search for the best axis.

use crate::support::{Random, at, ball, capsule, cone, cuboid, cylinder, floor, hull, prism, ring, turned};
use polhode_contact::{ConvexPolyhedron, Shape, manifold, separation};
use polhode_spatial::{DVec3, Pose, Rotation};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Asserts a known separation: in both orders, at three scales, near and far from the origin, and mirrored.
fn assert_known(build: impl Fn(f64) -> (Shape, Shape), pose_a: Pose, pose_b: Pose, expected: f64) {
    let far = DVec3::new(1e6, -2e6, 5e5);
    for scale in [1e-4, 1.0, 1e4] {
        let (a, b) = build(scale);
        let place = |pose: Pose| Pose::new(pose.rotation, pose.translation * scale);
        let away = |pose: Pose| Pose::new(pose.rotation, (pose.translation + far) * scale);
        let (near_a, near_b) = (place(pose_a), place(pose_b));
        let found = separation(&a, &near_a, &b, &near_b) / scale;
        assert!((found - expected).abs() <= 8e-15, "{found} {expected} at {scale}");
        let swapped = separation(&b, &near_b, &a, &near_a) / scale;
        assert!((swapped - expected).abs() <= 8e-15, "{swapped} {expected} at {scale}, swapped");
        let found = separation(&a, &away(pose_a), &b, &away(pose_b)) / scale;
        assert!((found - expected).abs() <= 1e-9, "{found} {expected} far away at {scale}");
        // The mirror image in the plane x = 0: shapes about z are their own.
        let mirror = |pose: Pose| {
            let [w, x, y, z] = pose.rotation.to_wxyz();
            let rotation = Rotation::from_wxyz([w, x, -y, -z]).expect("a rotation");
            Pose::new(rotation, pose.translation * DVec3::new(-1.0, 1.0, 1.0))
        };
        let found = separation(&a, &mirror(near_a), &b, &mirror(near_b)) / scale;
        assert!((found - expected).abs() <= 8e-15, "{found} {expected} mirrored");
    }
}

/// Gaps and overlaps with closed forms, for every kind of pair of elements.
#[test]
fn closed_forms() {
    let still = Pose::IDENTITY;
    let lying = |place: DVec3| turned(DVec3::X, FRAC_PI_2, place);
    let slope = 0.5_f64;
    for gap in [-0.05, -1e-12, 0.0, 1e-9, 0.3] {
        let up = |z: f64| at(0.1, -0.2, z + gap);
        // Above a floor: standing, lying, tilted.
        assert_known(|s| (cylinder(0.3 * s, 1.2 * s), floor()), up(0.6), still, gap);
        assert_known(|s| (cylinder(0.3 * s, 1.2 * s), floor()), lying(DVec3::Z * (0.3 + gap)), still, gap);
        let lowest = 0.6 * libm::cos(slope) + 0.3 * libm::sin(slope);
        let tilted = turned(DVec3::X, slope, DVec3::Z * (lowest + gap));
        assert_known(|s| (cylinder(0.3 * s, 1.2 * s), floor()), tilted, still, gap);
        assert_known(|s| (cone(0.3 * s, 1.2 * s), floor()), up(0.3), still, gap);
        assert_known(|s| (capsule(0.3 * s, 1.2 * s), floor()), up(0.9), still, gap);
        assert_known(|s| (ring(s, 0.25 * s), floor()), up(0.25), still, gap);
        // On top of each other.
        let z = DVec3::Z;
        assert_known(|s| (cylinder(0.3 * s, s), cylinder(0.7 * s, s)), at(0.1, 0.2, 1.0 + gap), still, gap);
        assert_known(|s| (cylinder(0.3 * s, s), cuboid(s, s, s)), at(0.6, 0.2, 1.0 + gap), still, gap);
        assert_known(|s| (cone(0.3 * s, s), cylinder(0.7 * s, s)), at(0.1, 0.2, 0.75 + gap), still, gap);
        let on_tip = turned(DVec3::X, 2.0 * FRAC_PI_2, z * (1.25 + gap));
        assert_known(|s| (cone(0.3 * s, s), cylinder(0.7 * s, s)), on_tip, still, gap);
        assert_known(|s| (ball(0.3 * s), cylinder(0.7 * s, s)), at(0.1, 0.2, 0.8 + gap), still, gap);
        assert_known(|s| (capsule(0.3 * s, s), cylinder(0.7 * s, s)), at(0.1, 0.2, 1.3 + gap), still, gap);
        // Side by side, parallel and crossed.
        assert_known(|s| (cylinder(0.3 * s, s), cylinder(0.5 * s, s)), at(0.8 + gap, 0.0, 0.9), still, gap);
        assert_known(|s| (cylinder(0.3 * s, s), capsule(0.5 * s, s)), at(0.8 + gap, 0.0, 0.9), still, gap);
        assert_known(|s| (capsule(0.3 * s, s), capsule(0.5 * s, s)), at(0.8 + gap, 0.0, 0.9), still, gap);
        let across = turned(DVec3::X, 1.1, DVec3::new(0.8 + gap, 0.05, 0.1));
        assert_known(|s| (cylinder(0.3 * s, s), cylinder(0.5 * s, s)), across, still, gap);
        assert_known(|s| (cylinder(0.3 * s, s), capsule(0.5 * s, s)), across, still, gap);
        assert_known(|s| (cylinder(0.5 * s, s), cuboid(0.6 * s, s, s)), across, still, gap);
        assert_known(|s| (ball(0.3 * s), capsule(0.5 * s, s)), at(0.8 + gap, 0.0, 0.3), still, gap);
        assert_known(|s| (ball(0.3 * s), cylinder(0.5 * s, s)), at(0.8 + gap, 0.0, 0.3), still, gap);
        // Two cones side by side, one upside down, touch along a generator: half angle alpha, axes at r cos(alpha)
        // apart.
        let alpha = libm::atan2(0.3, 1.0);
        let (c, k) = (libm::cos(alpha), libm::sin(alpha));
        // Apex of the first at the height of the other's base.
        let beside = turned(DVec3::Y, 2.0 * FRAC_PI_2, DVec3::new((0.3 * c + gap) / c, 0.0, 0.5));
        assert_known(|s| (cone(0.3 * s, s), cone(0.3 * s, s)), beside, still, gap);
        // A ball on a cone's side.
        let foot = DVec3::new(0.15, 0.0, 0.25);
        let out = DVec3::new(c, 0.0, k);
        let on_side = Pose::from_translation(foot + out * (0.2 + gap));
        assert_known(|s| (ball(0.2 * s), cone(0.3 * s, s)), on_side, still, gap);
        // A cube's corner at a cylinder's side, its diagonal along x.
        let corner = turned(DVec3::Z, 0.5 * FRAC_PI_2, DVec3::new(0.5 + 0.5 * 2.0_f64.sqrt() + gap, 0.0, 0.2));
        assert_known(|s| (cuboid(s, s, s), cylinder(0.5 * s, s)), corner, still, gap);
    }
    // Distances from rims and points: beyond the region of the side or the disc.
    let rim = Pose::from_translation(DVec3::new(0.5 + 0.3, 0.0, 0.5 + 0.4));
    assert_known(|s| (ball(0.1 * s), cylinder(0.5 * s, s)), rim, still, 0.4);
    assert_known(|s| (capsule(0.1 * s, 0.2 * s), cylinder(0.5 * s, s)), at(0.8, 0.0, 1.0), still, 0.4);
    assert_known(|s| (ball(0.1 * s), cone(0.5 * s, s)), at(0.0, 0.0, 1.25), still, 0.4);
    assert_known(|s| (ball(0.1 * s), capsule(0.5 * s, s)), at(0.0, 0.9, 1.7), still, 0.9);
}

/// A prism or pyramid whose corners lie on a cylinder or cone; circumscribed when `grow` is `1/cos(pi/n)`.
fn faceted(shape: &Shape, sides: u32, grow: f64) -> Option<Shape> {
    let ring = |radius: f64, z: f64| {
        (0..sides).map(move |k| {
            let angle = f64::from(k) / f64::from(sides) * TAU;
            DVec3::new(radius * grow * libm::cos(angle), radius * grow * libm::sin(angle), z)
        })
    };
    let points: Vec<DVec3> = match shape {
        Shape::Cylinder(c) => ring(c.radius(), -0.5 * c.height()).chain(ring(c.radius(), 0.5 * c.height())).collect(),
        // The circumscribed pyramid has its apex in the same place.
        Shape::Cone(c) => ring(c.radius(), c.base().z).chain([c.apex()]).collect(),
        _ => return None,
    };
    ConvexPolyhedron::from_points(&points).ok().map(Shape::convex)
}

/// Distance of two convex bodies by their support functions alone: the largest of `-h_A(-n) - h_B(n)` over directions,
/// searched on a sphere of samples and then in ever smaller circles about the best ones.
fn brute_force(random: &mut Random, a: &Shape, pose_a: &Pose, b: &Shape, pose_b: &Pose) -> f64 {
    let gap = |n: DVec3| -support(a, pose_a, -n) - support(b, pose_b, n);
    let mut samples: Vec<(f64, DVec3)> = Vec::new();
    for _ in 0..3000 {
        let n = random.direction();
        samples.push((gap(n), n));
    }
    samples.sort_by(|p, q| q.0.total_cmp(&p.0));
    let mut best = f64::NEG_INFINITY;
    for &(value, start) in samples.iter().take(12) {
        let (mut value, mut n) = (value, start);
        let mut radius = 0.1;
        while radius > 1e-9 {
            let mut better = false;
            for _ in 0..24 {
                let to = (n + random.vector() * radius).normalize();
                let there = gap(to);
                if there > value {
                    (value, n, better) = (there, to, true);
                }
            }
            radius *= if better { 1.5 } else { 0.85 };
            radius = f64::min(radius, 0.1);
        }
        best = f64::max(best, value);
    }
    best
}

/// Support of a shape about z, from its definition.
fn support(shape: &Shape, pose: &Pose, n: DVec3) -> f64 {
    let local = pose.rotation.inverse_rotate(n);
    let across = libm::hypot(local.x, local.y);
    let own = match shape {
        Shape::Cylinder(c) => 0.5 * c.height() * local.z.abs() + c.radius() * across,
        Shape::Cone(c) => (local.z * c.apex().z).max(local.z * c.base().z + c.radius() * across),
        Shape::Capsule(c) => local.z.abs() * c.ends()[1].z + c.radius(),
        Shape::Sphere(s) => s.radius(),
        Shape::Convex(p) => p.vertices().iter().map(|v| local.dot(*v)).fold(f64::NEG_INFINITY, f64::max),
        _ => f64::NAN,
    };
    own + n.dot(pose.translation)
}

/// Random pairs, apart and overlapping, against the brute force: no random search beats the best axis, and the bodies'
/// supports along the normal of a contact are apart by exactly the separation.
#[test]
fn against_brute_force() {
    let mut random = Random(99);
    let corners: Vec<DVec3> = (0..40).map(|_| random.direction() * DVec3::new(0.5, 0.3, 0.4)).collect();
    let shapes = [
        capsule(0.2, 0.7),
        cylinder(0.4, 0.6),
        cylinder(0.5, 0.1),
        cone(0.4, 0.7),
        cone(0.6, 0.2),
        ball(0.3),
        cuboid(0.5, 0.4, 0.7),
        prism(5, 0.4, 0.3),
        // Many edges, most of which the search must exclude correctly.
        hull(&corners),
    ];
    let mut worst: f64 = 0.0;
    for (i, a) in shapes.iter().enumerate() {
        for b in shapes.iter().take(5).take(i + 1) {
            for k in 0..12 {
                let distance = random.between(0.2, 1.2);
                let pose_a = Pose::new(random.rotation(), random.direction() * distance);
                let pose_b = Pose::new(random.rotation(), DVec3::ZERO);
                let found = separation(a, &pose_a, b, &pose_b);
                let brute = brute_force(&mut random, a, &pose_a, b, &pose_b);
                assert!(
                    brute <= found + 1e-13,
                    "{k}: {found} is less than {brute} for {a:?} {pose_a:?} {b:?} {pose_b:?}"
                );
                let result = manifold(a, &pose_a, b, &pose_b, 10.0);
                let apart = |n: DVec3| -support(a, &pose_a, -n) - support(b, &pose_b, n);
                // Bodies that overlap by more than their radii have no single place where they touch.
                let deep = found < -0.1;
                let attained = deep || result.contacts.iter().any(|c| (apart(c.geometry.normal) - found).abs() < 1e-13);
                assert!(attained, "{k}: {found} {result:?} for {a:?} {pose_a:?} {b:?} {pose_b:?}");
                worst = worst.max(found - brute);
                let swapped = separation(b, &pose_b, a, &pose_a);
                assert!((swapped - found).abs() < 1e-13, "{found} {swapped}");
            }
        }
    }
    println!("largest difference {worst:e} m");
}

/// The separation lies between those of an inscribed and a circumscribed prism or pyramid, which come from the search
/// over faces and edges.
#[test]
fn between_prisms() {
    let mut random = Random(17);
    let sides = 64;
    let grow = 1.0 / libm::cos(std::f64::consts::PI / f64::from(sides));
    let cube = cuboid(0.5, 0.4, 0.7);
    for shape in [cylinder(0.4, 0.6), cylinder(0.5, 0.1), cone(0.4, 0.7), cone(0.6, 0.2)] {
        let inside = faceted(&shape, sides, 1.0).expect("a prism");
        let outside = faceted(&shape, sides, grow).expect("a prism");
        for _ in 0..60 {
            let distance = random.between(0.3, 1.0);
            let pose = Pose::new(random.rotation(), random.direction() * distance);
            let pose_cube = Pose::new(random.rotation(), DVec3::ZERO);
            let found = separation(&shape, &pose, &cube, &pose_cube);
            let (most, least) =
                (separation(&inside, &pose, &cube, &pose_cube), separation(&outside, &pose, &cube, &pose_cube));
            // The separation of polyhedra that are apart is over faces and pairs of edges only: a lower bound.
            if found < 0.0 {
                assert!(found <= most + 1e-13, "{found} {most}");
            }
            assert!(least <= found + 1e-13, "{least} {found}");
        }
    }
}
