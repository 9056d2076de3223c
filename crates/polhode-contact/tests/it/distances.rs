//! Distances: closed forms, brute force over all pairs of features, agreement with separations, and invariance.

use crate::support::{Random, at, ball, capsule, cone, cuboid, cylinder, floor, hull, off_segment, prism, ring};
use polhode_contact::{
    ConvexPolyhedron, QueryError, Shape, SurfaceFeature, closest_point, contains, distance, overlap, separation,
};
use polhode_spatial::{DQuat, DVec3, Pose, Rotation};
use std::f64::consts::TAU;

/// One shape of every kind but the half-space, of size about one, with its name.
pub(crate) fn bounded_shapes() -> Vec<(&'static str, Shape)> {
    let mesh = Shape::triangle_mesh(
        vec![
            DVec3::new(-0.5, -0.4, 0.0),
            DVec3::new(0.6, -0.4, 0.1),
            DVec3::new(0.0, 0.5, -0.1),
            DVec3::new(0.8, 0.7, 0.2),
        ],
        vec![[0, 1, 2], [1, 3, 2]],
    );
    let parts = vec![cuboid(0.6, 0.3, 0.2), ball(0.2).translated(DVec3::X * 0.5).expect("moved")];
    vec![
        ("cuboid", cuboid(0.7, 0.5, 0.9)),
        ("prism", prism(7, 0.5, 0.6)),
        ("sphere", ball(0.4)),
        ("points", Shape::points(vec![DVec3::X * 0.3, DVec3::Y * 0.4, DVec3::Z * -0.2]).expect("points")),
        ("capsule", capsule(0.2, 0.7)),
        ("cylinder", cylinder(0.35, 0.8)),
        ("cone", cone(0.4, 0.8)),
        ("torus", ring(0.4, 0.1)),
        ("mesh", mesh.expect("a mesh")),
        ("compound", Shape::compound(parts).expect("a compound")),
    ]
}

/// A polyhedron of random points.
pub(crate) fn random_polyhedron(random: &mut Random, size: f64) -> ConvexPolyhedron {
    loop {
        let count = 4 + (random.unit() * 12.0) as usize;
        let points: Vec<DVec3> = (0..count).map(|_| random.vector() * (0.5 * size)).collect();
        if let Ok(polyhedron) = ConvexPolyhedron::from_points(&points) {
            return polyhedron;
        }
    }
}

/// Distance of two segments by the extremes of a quadratic, in the plain textbook form.
fn segments(p: [DVec3; 2], q: [DVec3; 2]) -> f64 {
    let ends = [off_segment(p, q[0]), off_segment(p, q[1]), off_segment(q, p[0]), off_segment(q, p[1])];
    let mut least = ends.into_iter().fold(f64::INFINITY, f64::min);
    let (d, e, r) = (p[1] - p[0], q[1] - q[0], p[0] - q[0]);
    let (a, b, c) = (d.dot(d), d.dot(e), e.dot(e));
    let determinant = a * c - b * b;
    let s = (b * e.dot(r) - c * d.dot(r)) / determinant;
    let t = (a * e.dot(r) - b * d.dot(r)) / determinant;
    if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
        least = least.min((r + d * s - e * t).length());
    }
    least
}

/// Distance of a point from a convex polygon, infinite where it does not project onto it.
fn over_polygon(corners: &[DVec3], normal: DVec3, x: DVec3) -> f64 {
    let inside = (0..corners.len()).all(|i| {
        let (p, q) = (corners[i], corners[(i + 1) % corners.len()]);
        (q - p).cross(x - p).dot(normal) >= 0.0
    });
    if inside { normal.dot(x - corners[0]).abs() } else { f64::INFINITY }
}

/// Distance of two polyhedra that are apart, by every pair of edges and every vertex over every face.
fn brute_force(a: &ConvexPolyhedron, pose_a: &Pose, b: &ConvexPolyhedron, pose_b: &Pose) -> f64 {
    let place = |p: &ConvexPolyhedron, pose: &Pose| -> Vec<DVec3> {
        p.vertices().iter().map(|&v| pose.transform_point(v)).collect()
    };
    let (points_a, points_b) = (place(a, pose_a), place(b, pose_b));
    let mut least = f64::INFINITY;
    for e in a.edges() {
        for f in b.edges() {
            let p = e.vertices.map(|v| points_a[v as usize]);
            let q = f.vertices.map(|v| points_b[v as usize]);
            least = least.min(segments(p, q));
        }
    }
    for (polyhedron, pose, own, others) in [(a, pose_a, &points_a, &points_b), (b, pose_b, &points_b, &points_a)] {
        for face in polyhedron.faces() {
            let corners: Vec<DVec3> = face.vertices.iter().map(|&v| own[v as usize]).collect();
            for &x in others {
                least = least.min(over_polygon(&corners, pose.rotation.rotate(face.normal), x));
            }
        }
    }
    least
}

/// Distance of a point from a shape's surface. The planes of needle-shaped faces of random hulls are 2e-14 off their
/// own edges, so that a point on an edge counts as on the surface.
fn off_surface(shape: &Shape, pose: &Pose, place: DVec3) -> f64 {
    let off = closest_point(shape, pose, place).expect("finite").distance.abs();
    let Shape::Convex(polyhedron) = shape else { return off };
    let ends = |v: u32| pose.transform_point(polyhedron.vertices()[v as usize]);
    let edges = polyhedron.edges().iter().map(|e| off_segment(e.vertices.map(ends), place));
    edges.fold(off, f64::min)
}

/// Checks every result: a unit normal, witness points that lie on their surfaces at the stated distance.
fn check_consistent(name: &str, a: &Shape, pose_a: &Pose, b: &Shape, pose_b: &Pose, tolerance: f64) -> f64 {
    let found = distance(a, pose_a, b, pose_b).expect("finite poses");
    assert!((found.normal.length() - 1.0).abs() < 1e-14, "{name}: {found:?}");
    let gap = found.point_a - found.point_b - found.normal * found.distance;
    assert!(gap.length() <= tolerance, "{name}: {:e} {found:?}", gap.length());
    if found.distance > 0.0 {
        for (shape, pose, point) in [(a, pose_a, found.point_a), (b, pose_b, found.point_b)] {
            let off = off_surface(shape, pose, point);
            assert!(off <= tolerance, "{name}: {off:e} off the surface, {found:?}");
        }
    }
    found.distance
}

/// Gaps from below rounding to a thousandth of the size, and large ones: the features found by GJK must give the result
/// of all pairs. The tolerance is a few epsilon of the coordinates, which reach 2.
#[test]
fn the_distance_of_polyhedra_is_that_of_their_nearest_features() {
    let mut random = Random(11);
    let mut worst: f64 = 0.0;
    let mut apart = 0;
    for round in 0..3000 {
        let (a, b) = (random_polyhedron(&mut random, 1.0), random_polyhedron(&mut random, 1.0));
        let (mut pose_a, pose_b) = (random.pose(1.0), random.pose(0.1));
        let (sa, sb) = (Shape::convex(a.clone()), Shape::convex(b.clone()));
        let first = distance(&sa, &pose_a, &sb, &pose_b).expect("finite");
        if round % 2 == 0 {
            // Moved along the normal to the wanted gap.
            let gap = libm::pow(10.0, -random.between(0.0, 16.0));
            pose_a.translation += first.normal * (gap - first.distance);
        }
        let found = check_consistent("polyhedra", &sa, &pose_a, &sb, &pose_b, 4e-15);
        if found > 0.0 {
            apart += 1;
            worst = worst.max((found - brute_force(&a, &pose_a, &b, &pose_b)).abs());
        }
    }
    println!("polyhedra: {apart} apart, worst error {worst:e}");
    assert!(apart > 1500 && worst < 4e-15, "{apart} {worst:e}");
}

/// The depth is the least over all directions; the reference is the separating-axis search of the narrow phase, which
/// is independent code.
#[test]
fn overlapping_polyhedra_have_the_depth_of_their_separation() {
    let mut random = Random(5);
    let mut worst: f64 = 0.0;
    for _ in 0..1500 {
        let a = Shape::convex(random_polyhedron(&mut random, 1.0));
        let b = Shape::convex(random_polyhedron(&mut random, 1.0));
        let (pose_a, pose_b) = (random.pose(0.2), random.pose(0.2));
        let found = check_consistent("overlap", &a, &pose_a, &b, &pose_b, 4e-15);
        let along_axes = separation(&a, &pose_a, &b, &pose_b);
        assert_eq!(found < -1e-14, along_axes < -1e-14);
        if found < 0.0 {
            worst = worst.max((found - along_axes).abs());
        }
    }
    println!("depth: worst difference {worst:e}");
    // The narrow phase prefers faces up to a difference of 1e-12 of the size.
    assert!(worst < 2e-12, "{worst:e}");
}

/// Where a face normal is the best axis, distance and separation are equal; elsewhere the separation is less.
#[test]
fn separation_is_a_lower_bound_and_exact_for_faces() {
    let mut random = Random(3);
    let mut met = 0;
    for _ in 0..2000 {
        let a = Shape::convex(random_polyhedron(&mut random, 1.0));
        let b = Shape::convex(random_polyhedron(&mut random, 1.0));
        let (pose_a, pose_b) = (random.pose(1.0), Pose::IDENTITY);
        let found = distance(&a, &pose_a, &b, &pose_b).expect("finite");
        let along_axes = separation(&a, &pose_a, &b, &pose_b);
        assert!(along_axes <= found.distance + 4e-15, "{along_axes} {found:?}");
        let face = |kind| matches!(kind, SurfaceFeature::Face(_));
        if found.distance > 0.0 && (face(found.feature_a.surface) || face(found.feature_b.surface)) {
            met += 1;
            assert!((along_axes - found.distance).abs() < 4e-15, "{along_axes} {found:?}");
        }
    }
    assert!(met > 100, "{met}");
}

/// Pairs whose distance has a closed form. Both poses are rotated and moved together, so that no axis is special.
#[test]
fn closed_forms_of_curved_shapes() {
    let shape = |made: Result<Shape, _>| made.expect("positive lengths");
    let tilt = |angle: f64| Rotation::from_rotation_vector(DVec3::X * angle);
    let turned = |angle: f64, p: DVec3| Pose::new(tilt(angle), p);
    let right = std::f64::consts::FRAC_PI_2;
    let cylinder = shape(Shape::cylinder(0.5, 2.0));
    let cone = shape(Shape::cone(0.3, 0.4));
    let torus = shape(Shape::torus(2.0, 0.5));
    let capsule = shape(Shape::capsule(0.25, 1.0));
    let ball = shape(Shape::sphere(0.125));
    let floor = floor();
    let h = 0.4 * 0.25;
    let cases = vec![
        ("cylinders side by side", cylinder.clone(), at(2.0, 0.0, 0.3), cylinder.clone(), Pose::IDENTITY, 1.0),
        ("cylinders end to end", cylinder.clone(), at(0.3, 0.2, 2.5), cylinder.clone(), Pose::IDENTITY, 0.5),
        ("cylinders crossed", cylinder.clone(), turned(right, DVec3::X * 1.25), cylinder.clone(), Pose::IDENTITY, 0.25),
        ("rim over rim", cylinder.clone(), at(1.3, 0.0, 2.4), cylinder.clone(), Pose::IDENTITY, 0.5),
        ("cylinder standing", cylinder.clone(), at(0.0, 0.0, 1.5), floor.clone(), Pose::IDENTITY, 0.5),
        ("cylinder lying", cylinder.clone(), turned(right, DVec3::Z * 0.75), floor.clone(), Pose::IDENTITY, 0.25),
        ("apex under a disc", cylinder.clone(), at(0.1, 0.0, 2.0), cone.clone(), Pose::IDENTITY, 1.0 - 0.3),
        ("cone on its base", cone.clone(), at(0.0, 0.0, h + 0.5), floor.clone(), Pose::IDENTITY, 0.5),
        ("cone over a disc", cone.clone(), at(0.2, 0.0, 1.0 + h + 0.25), cylinder.clone(), Pose::IDENTITY, 0.25),
        ("ball over a rim", ball.clone(), at(0.8, 0.0, 1.4), cylinder.clone(), Pose::IDENTITY, 0.5 - 0.125),
        ("ball in a ring", ball.clone(), Pose::IDENTITY, torus.clone(), Pose::IDENTITY, 2.0 - 0.5 - 0.125),
        ("rings coaxial", torus.clone(), at(0.0, 0.0, 2.0), torus.clone(), Pose::IDENTITY, 1.0),
        ("rings linked", torus.clone(), turned(right, DVec3::X * 2.0), torus.clone(), Pose::IDENTITY, 1.0),
        ("ring on the floor", torus.clone(), turned(right, DVec3::Z * 3.0), floor.clone(), Pose::IDENTITY, 0.5),
        ("capsule through a ring", capsule.clone(), Pose::IDENTITY, torus.clone(), Pose::IDENTITY, 2.0 - 0.5 - 0.25),
        ("capsules crossed", capsule.clone(), turned(right, DVec3::X), capsule.clone(), Pose::IDENTITY, 0.5),
        ("capsules parallel", capsule.clone(), at(0.75, 0.0, 0.5), capsule.clone(), Pose::IDENTITY, 0.25),
        ("capsule beside a cylinder", capsule.clone(), at(0.0, 1.0, 0.2), cylinder.clone(), Pose::IDENTITY, 0.25),
        ("box over a disc", cuboid(1.0, 1.0, 1.0), at(0.7, 0.1, 1.75), cylinder.clone(), Pose::IDENTITY, 0.25),
        ("box beside a cylinder", cuboid(1.0, 1.0, 1.0), at(1.25, 0.1, 0.2), cylinder.clone(), Pose::IDENTITY, 0.25),
        ("deep in a disc", cylinder.clone(), at(0.3, 0.2, 1.75), cylinder.clone(), Pose::IDENTITY, -0.25),
        ("deep in a side", cylinder.clone(), at(0.75, 0.0, 0.1), cylinder.clone(), Pose::IDENTITY, -0.25),
        ("deep crossed", cylinder.clone(), turned(right, DVec3::X * 0.75), cylinder.clone(), Pose::IDENTITY, -0.25),
        ("capsules deep", capsule.clone(), turned(right, DVec3::X * 0.375), capsule.clone(), Pose::IDENTITY, -0.125),
        ("capsule in a disc", capsule, at(0.1, 0.0, 1.5), cylinder, Pose::IDENTITY, -0.25),
        ("rings deep", torus.clone(), at(0.0, 0.0, 0.75), torus, Pose::IDENTITY, -0.25),
    ];
    let mut random = Random(9);
    let mut worst: f64 = 0.0;
    for (name, a, pose_a, b, pose_b, wanted) in &cases {
        for round in 0..6 {
            let all = if round == 0 { Pose::IDENTITY } else { random.pose(1.0) };
            let (pose_a, pose_b) = (all * *pose_a, all * *pose_b);
            let found = check_consistent(name, a, &pose_a, b, &pose_b, 1e-12);
            let back = check_consistent(name, b, &pose_b, a, &pose_a, 1e-12);
            let error = (found - wanted).abs().max((back - wanted).abs());
            if error > 1e-13 {
                println!("{name}: {found} {back} for {wanted}: {error:e}");
            }
            worst = worst.max(error);
        }
    }
    println!("closed forms: worst {worst:e}");
    assert!(worst < 4e-12, "{worst:e}");
}

/// Round bodies that touch overlap, at any position and whatever the error of the iteration for their distance; a
/// millionth of their size apart they do not.
#[test]
fn round_bodies_that_touch_overlap() {
    let shape = |made: Result<Shape, _>| made.expect("positive lengths");
    let cylinder = shape(Shape::cylinder(0.5, 2.0));
    let (cone, torus) = (shape(Shape::cone(0.3, 0.4)), shape(Shape::torus(2.0, 0.5)));
    let (cube, ball) = (cuboid(1.0, 1.0, 1.0), shape(Shape::sphere(0.125)));
    let across = Rotation::from_rotation_vector(DVec3::X * std::f64::consts::FRAC_PI_2);
    let touching: [(&Shape, &Shape, Pose, DVec3); 9] = [
        (&cylinder, &cylinder, Pose::IDENTITY, DVec3::X),
        (&cylinder, &cylinder, Pose::new(across, DVec3::ZERO), DVec3::X),
        (&cylinder, &cylinder, Pose::IDENTITY, DVec3::Z * 2.0),
        (&cylinder, &cube, Pose::IDENTITY, DVec3::X),
        (&cylinder, &cube, Pose::new(across, DVec3::ZERO), DVec3::Z),
        (&cylinder, &ball, Pose::IDENTITY, DVec3::X * 0.625),
        (&cone, &cube, Pose::IDENTITY, DVec3::Z * 0.6),
        (&torus, &ball, Pose::IDENTITY, DVec3::X * 2.625),
        (&torus, &torus, Pose::IDENTITY, DVec3::Z),
    ];
    let mut random = Random(77);
    for (number, (a, b, turn, offset)) in touching.into_iter().enumerate() {
        for _ in 0..50 {
            let all = random.pose(3.0);
            let at = |reach: f64| all * Pose::new(turn.rotation, offset * reach);
            assert!(overlap(a, &at(1.0), b, &all) && overlap(b, &all, a, &at(1.0)), "pair {number}");
            assert!(!overlap(a, &at(1.0 + 1e-6), b, &all), "pair {number} apart");
        }
    }
}

/// Bodies on one axis, after a half turn that made an axis longer or shorter than one by rounding (fuzz findings: the
/// remainder of a direction along the axis was taken for one perpendicular to it, so that a cylinder extended beyond
/// its disc and a torus had its centre circle on its axis): the distances are those of the closed forms.
#[test]
fn axes_of_unit_length_to_rounding_have_no_component_perpendicular_to_themselves() {
    let ball = ball(0.1);
    let (cylinder, cone) = (cylinder(3.2, 3.2), cone(3.2, 3.2));
    let ring = ring(2.7, 1.1);
    let mut random = Random(73);
    for case in 0..400 {
        let turn = random.between(0.0, TAU);
        let half = Rotation::renormalized(DQuat::from_xyzw(libm::cos(turn), libm::sin(turn), 0.0, 0.0));
        let (gap, aside) = (random.between(0.5, 3.0), random.between(-0.5, 0.5));
        // Each rotated by half a turn, below the other; the distance of their centres minus the gap.
        let off_ring = libm::hypot(2.7, gap) - 1.2;
        let stacks = [
            (&ball, &ring, gap, 0.0, off_ring),
            (&ring, &ball, gap, 0.0, off_ring),
            (&cylinder, &ball, gap + 1.7, 0.0, gap),
            (&ball, &cylinder, gap + 1.7, 0.0, gap),
            (&cylinder, &cone, gap + 2.4, aside, gap),
            (&cylinder, &cylinder, gap + 3.2, aside, gap),
            (&ring, &cylinder, gap + 2.7, aside, gap),
            (&ring, &ring, gap + 2.2, 0.0, gap),
        ];
        for (index, (below, above, height, aside, expected)) in stacks.into_iter().enumerate() {
            let (pose, over) = (Pose::new(half, DVec3::ZERO), at(aside, 0.0, height));
            let found = distance(below, &pose, above, &over).expect("a distance").distance;
            let apart = [separation(below, &pose, above, &over), separation(above, &over, below, &pose)];
            assert!((found - expected).abs() < 1e-9, "{case}, {index}: {found} of {expected}");
            assert!(apart.iter().all(|s| (s - expected).abs() < 1e-12), "{case}, {index}: {apart:?} of {expected}");
        }
    }
}

/// The distance changes by no more than the length of a motion, and does not depend on the order of the bodies.
#[test]
fn distances_are_lipschitz_and_symmetric() {
    let mut random = Random(21);
    let shapes = bounded_shapes();
    let mut worst: f64 = 0.0;
    for (name_a, a) in &shapes {
        for (name_b, b) in &shapes {
            for _ in 0..6 {
                let (mut pose_a, pose_b) = (random.pose(1.0), random.pose(0.3));
                let name = format!("{name_a} {name_b}");
                let found = check_consistent(&name, a, &pose_a, b, &pose_b, 1e-11);
                let back = distance(b, &pose_b, a, &pose_a).expect("finite").distance;
                if (found - back).abs() > 1e-12 {
                    println!("{name}: {found} {back} {:e}", found - back);
                }
                worst = worst.max((found - back).abs());
                let step = random.vector() * 0.05;
                pose_a.translation += step;
                let moved = distance(a, &pose_a, b, &pose_b).expect("finite").distance;
                assert!((moved - found).abs() <= step.length() + 1e-11, "{name}: {found} to {moved}");
                assert!(moved > 1e-14 || overlap(a, &pose_a, b, &pose_b), "{name}: {moved}");
            }
        }
    }
    println!("swap: worst {worst:e}");
    assert!(worst < 1e-11, "{worst:e}");
}

/// Moving A along the normal by the depth of penetration leaves the bodies touching.
#[test]
fn moving_out_by_the_depth_leaves_touch() {
    let mut random = Random(33);
    let solid: Vec<_> = bounded_shapes()
        .into_iter()
        .filter(|(name, _)| !["points", "mesh", "compound", "torus"].contains(name))
        .collect();
    let mut worst: f64 = 0.0;
    for (name_a, a) in &solid {
        for (name_b, b) in &solid {
            for _ in 0..10 {
                let (mut pose_a, pose_b) = (random.pose(0.2), random.pose(0.1));
                let found = distance(a, &pose_a, b, &pose_b).expect("finite");
                if found.distance >= 0.0 {
                    continue;
                }
                pose_a.translation += found.normal * (1e-6 - found.distance);
                let left = distance(a, &pose_a, b, &pose_b).expect("finite").distance;
                let error = (left - 1e-6).abs();
                if error > 1e-12 {
                    println!("{name_a} {name_b}: {left:e} left, depth {}", found.distance);
                }
                worst = worst.max(error);
            }
        }
    }
    println!("moved out: worst {worst:e}");
    assert!(worst < 1e-11, "{worst:e}");
}

/// Far from the origin, rotated, scaled and mirrored, the distance is the same.
#[test]
fn distances_do_not_depend_on_place_attitude_and_units() {
    let mut random = Random(77);
    for _ in 0..200 {
        let (a, b) = (random_polyhedron(&mut random, 1.0), random_polyhedron(&mut random, 1.0));
        let (pose_a, pose_b) = (random.pose(1.0), random.pose(0.3));
        let scaled = |scale: f64, mirror: DVec3| {
            let make = |p: &ConvexPolyhedron, pose: &Pose| {
                let points: Vec<DVec3> =
                    p.vertices().iter().map(|&v| pose.transform_point(v) * mirror * scale).collect();
                hull(&points)
            };
            let far = Pose::from_translation(DVec3::new(1e6, -1e6, 1e6) * scale);
            distance(&make(&a, &pose_a), &far, &make(&b, &pose_b), &far).expect("finite").distance / scale
        };
        let first = distance(&Shape::convex(a.clone()), &pose_a, &Shape::convex(b.clone()), &pose_b).expect("finite");
        for scale in [1e-4, 1.0, 1e4] {
            for mirror in [DVec3::ONE, DVec3::new(-1.0, 1.0, 1.0)] {
                let other = scaled(scale, mirror);
                assert!((other - first.distance).abs() < 1e-14, "{other} {first:?}");
            }
        }
        let turn = random.rotation();
        let all = Pose::new(turn, DVec3::ZERO);
        let turned = distance(&Shape::convex(a), &(all * pose_a), &Shape::convex(b), &(all * pose_b)).expect("finite");
        assert!((turned.distance - first.distance).abs() < 1e-14);
    }
}

/// The nearest point of every shape's surface lies on it, at the stated distance.
#[test]
fn closest_points_lie_on_surfaces() {
    let mut random = Random(15);
    for (name, shape) in bounded_shapes() {
        let pose = random.pose(1.0);
        for _ in 0..300 {
            let point = pose.translation + random.vector() * 1.2;
            let near = closest_point(&shape, &pose, point).expect("finite");
            assert_eq!(near.distance <= 0.0, contains(&shape, &pose, point), "{name}");
            assert!((point - near.point - near.normal * near.distance).length() < 2e-15, "{name}");
            if near.distance > 0.0 {
                let on = closest_point(&shape, &pose, near.point).expect("finite").distance;
                assert!(on.abs() < 2e-15, "{name}: {on:e}");
                // A ball of that radius touches.
                let ball = Shape::points(vec![point]).expect("a point");
                let found = distance(&ball, &Pose::IDENTITY, &shape, &pose).expect("finite").distance;
                assert!((found - near.distance).abs() < 2e-15, "{name}");
            }
        }
    }
}

/// Input that is not finite gives an error, never a panic.
#[test]
fn hostile_poses_give_errors() {
    let brick = cuboid(1.0, 1.0, 1.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let pose = at(bad, 0.0, 0.0);
        for (_, shape) in bounded_shapes() {
            assert!(matches!(distance(&brick, &pose, &shape, &Pose::IDENTITY), Err(QueryError::NotFinite { .. })));
            assert!(matches!(
                closest_point(&shape, &Pose::IDENTITY, DVec3::X * bad),
                Err(QueryError::NotFinite { .. })
            ));
            assert!(!overlap(&shape, &pose, &brick, &Pose::IDENTITY) && !contains(&shape, &pose, DVec3::ZERO));
        }
    }
    let floor = floor();
    assert_eq!(distance(&floor, &Pose::IDENTITY, &floor, &Pose::IDENTITY), Err(QueryError::Unbounded));
    for (_, shape) in bounded_shapes() {
        for extreme in [1e-300, 1e150, 1e300] {
            let _ = distance(&shape, &at(extreme, 0.0, extreme), &brick, &Pose::IDENTITY);
            let _ = distance(&shape, &Pose::IDENTITY, &shape, &Pose::IDENTITY);
        }
    }
}
