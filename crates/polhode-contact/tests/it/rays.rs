//! Rays: closed forms, and against shapes' own distances along the ray.

use crate::distances::bounded_shapes;
use crate::support::{Random, at, ball, capsule, cone, cuboid, cylinder, floor, ring};
use polhode_contact::{QueryError, Ray, Shape, SurfaceFeature, closest_point, contains, ray_cast};
use polhode_spatial::{DVec3, Pose, Rotation, UnitVector};
use std::f64::consts::TAU;

fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray::new(origin, UnitVector::new(direction.normalize()).expect("a direction")).expect("a finite origin")
}

/// Straight on, from far away, and grazing.
#[test]
fn closed_forms() {
    let down = |x: f64, z: f64| ray(DVec3::new(x, 0.0, z), -DVec3::Z);
    let across = |z: f64| ray(DVec3::new(-9.0, 0.0, z), DVec3::X);
    let (cylinder, cone) = (cylinder(0.5, 2.0), cone(1.0, 2.0));
    let (torus, capsule) = (ring(2.0, 0.5), capsule(0.5, 2.0));
    let ball = ball(0.5);
    let floor = floor();
    let brick = cuboid(2.0, 2.0, 2.0);
    // The cone's base is at -0.5, its apex at 1.5.
    let cases = [
        ("ball", &ball, down(0.0, 3.0), Some((2.5, DVec3::Z))),
        ("ball grazed", &ball, down(0.5, 3.0), Some((3.0, DVec3::X))),
        ("ball missed", &ball, down(0.5000000001, 3.0), None),
        ("ball from afar", &ball, down(0.0, 1e8), Some((1e8 - 0.5, DVec3::Z))),
        ("box", &brick, down(0.3, 3.0), Some((2.0, DVec3::Z))),
        ("box from below", &brick, ray(DVec3::Z * -3.0, DVec3::Z), Some((2.0, -DVec3::Z))),
        ("box missed", &brick, down(1.1, 3.0), None),
        ("box behind", &brick, ray(DVec3::Z * 3.0, DVec3::Z), None),
        ("floor", &floor, down(0.0, 3.0), Some((3.0, DVec3::Z))),
        ("floor left", &floor, ray(DVec3::Z, DVec3::Z), None),
        ("disc", &cylinder, down(0.2, 3.0), Some((2.0, DVec3::Z))),
        ("side", &cylinder, across(0.5), Some((8.5, -DVec3::X))),
        ("side missed", &cylinder, across(1.5), None),
        ("side of a capsule", &capsule, across(0.5), Some((8.5, -DVec3::X))),
        ("end of a capsule", &capsule, down(0.0, 3.0), Some((1.5, DVec3::Z))),
        ("base", &cone, ray(DVec3::new(0.3, 0.0, -3.0), DVec3::Z), Some((2.5, -DVec3::Z))),
        ("flank", &cone, across(0.5), Some((8.5, DVec3::new(-2.0, 0.0, 1.0).normalize()))),
        ("ring", &torus, across(0.0), Some((6.5, -DVec3::X))),
        ("ring from above", &torus, down(2.0, 3.0), Some((2.5, DVec3::Z))),
        ("ring through its hole", &torus, down(0.5, 3.0), None),
        ("ring from its middle", &torus, ray(DVec3::ZERO, DVec3::Y), Some((1.5, -DVec3::Y))),
        ("ring grazed on top", &torus, across(0.5), Some((7.0, DVec3::Z))),
        ("ring missed on top", &torus, across(0.5000001), None),
    ];
    for (name, shape, ray, wanted) in cases {
        let hit = ray_cast(shape, &Pose::IDENTITY, &ray, f64::INFINITY);
        match (hit, wanted) {
            (Some(hit), Some((distance, normal))) => {
                // A double root of a quartic is known to the square root of epsilon.
                let slack = if name.contains("grazed on top") { 1e-7 } else { 1e-14 };
                let relative = (hit.distance - distance).abs() / distance;
                assert!(relative < slack && (hit.normal - normal).length() < slack.max(1e-8), "{name}: {hit:?}");
            }
            (None, None) => {}
            _ => panic!("{name}: {hit:?} for {wanted:?}"),
        }
    }
}

/// Every hit lies on the surface, and no point of the ray before it is inside; no point of a ray that misses is inside.
#[test]
fn hits_are_the_first_points_of_the_surface() {
    let mut random = Random(41);
    let (mut hits, mut misses) = (0, 0);
    for (name, shape) in bounded_shapes().into_iter().filter(|(name, _)| *name != "points") {
        for _ in 0..400 {
            let pose = random.pose(0.2);
            let start = random.direction() * random.between(0.2, 3.0);
            let ray = ray(start, random.vector() * 0.7 - start);
            let hit = ray_cast(&shape, &pose, &ray, 10.0);
            let end = hit.map_or(10.0, |hit| hit.distance);
            for k in 0..200 {
                let place = ray.at(end * (f64::from(k) / 200.0));
                let near = closest_point(&shape, &pose, place).expect("finite").distance;
                assert!(
                    near > -1e-13 || hit.is_some_and(|hit| hit.feature.is_none()),
                    "{name}: {near:e} at {k}, {hit:?}"
                );
            }
            let Some(hit) = hit else {
                misses += 1;
                continue;
            };
            hits += 1;
            let on = closest_point(&shape, &pose, hit.point).expect("finite").distance;
            if hit.feature.is_some() {
                assert!(on.abs() < 2e-14, "{name}: {on:e} off");
                assert!(hit.normal.dot(ray.direction()) <= 1e-14, "{name}: {hit:?}");
                let behind = ray_cast(&shape, &pose, &ray, hit.distance * 0.999);
                assert!(behind.is_none(), "{name}: {behind:?}");
            } else {
                assert!(hit.distance == 0.0 && contains(&shape, &pose, ray.origin()), "{name}");
            }
        }
    }
    assert!(hits > 500 && misses > 500, "{hits} {misses}");
}

/// A ray along the common edge, or through a common corner, of triangles of a closed surface never slips through.
#[test]
fn no_ray_passes_between_triangles() {
    let mut random = Random(8);
    let points: Vec<DVec3> =
        (0..8).map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)) - 0.5).collect();
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    let turn = random.rotation();
    let points: Vec<DVec3> = points.into_iter().map(|p| turn.rotate(p)).collect();
    let mesh = Shape::triangle_mesh(points.clone(), triangles).expect("a box");
    for _ in 0..5000 {
        let (i, j) = ((random.unit() * 8.0) as usize, (random.unit() * 8.0) as usize);
        let target = points[i].lerp(points[j], random.unit());
        // From the middle every edge and every diagonal is inside the surface's outline.
        let hit = ray_cast(&mesh, &Pose::IDENTITY, &ray(random.vector() * 0.01, target), f64::INFINITY);
        assert!(hit.is_some(), "{target}");
    }
}

/// A ray in the plane of a triangle, or within rounding of it (a fuzz finding): the triangle is missed where the signs
/// of its volumes are rounding error, and every hit is on the triangle.
#[test]
fn a_ray_in_the_plane_of_a_triangle_hits_only_the_triangle() {
    let mut random = Random(12);
    for case in 0..20_000 {
        let corners: Vec<DVec3> = (0..3).map(|_| random.vector() * 5.0).collect();
        let within = |random: &mut Random| {
            let [s, t] = [(); 2].map(|()| random.between(-2.0, 3.0));
            corners[0] + (corners[1] - corners[0]) * s + (corners[2] - corners[0]) * t
        };
        // Some past a corner, almost in the plane.
        let corner = corners[0].lerp(0.5 * (corners[1] + corners[2]), 1e-4);
        let target = if case % 2 == 0 { corner } else { within(&mut random) };
        let start = within(&mut random) + random.vector() * libm::exp10(random.between(-16.0, -11.0));
        let Ok(mesh) = Shape::triangle_mesh(corners.clone(), vec![[0, 1, 2]]) else { continue };
        let pose = random.pose(1.0);
        let ray = ray(pose.transform_point(start), pose.rotation.rotate(target - start));
        if let Some(hit) = ray_cast(&mesh, &pose, &ray, f64::INFINITY) {
            let off = closest_point(&mesh, &pose, hit.point).expect("finite").distance;
            assert!(off < 1e-12, "{case}: {off:e} off, {hit:?}");
        }
    }
}

/// A ray along an edge of a triangle, within rounding of its plane (a fuzz finding: the hit was 3.3e-4 m beyond the
/// corner): all corners are on one side of the ray, by rounding.
#[test]
fn a_ray_along_an_edge_ends_on_the_triangle() {
    let (mut random, mut met) = (Random(14), 0);
    for case in 0..50_000 {
        // Half of them along a diagonal, where rounding leaves the corner on the ray itself.
        let side = if case % 2 == 0 { DVec3::ONE * random.unit() } else { random.vector() };
        let start = random.vector() * libm::exp10(random.between(-14.0, -10.0));
        let corners = vec![start, side, random.vector() * 2.0];
        let mesh = Shape::triangle_mesh(corners, vec![[0, 1, 2]]).expect("a triangle");
        let ray = ray(DVec3::ZERO, side);
        if let Some(hit) = ray_cast(&mesh, &Pose::IDENTITY, &ray, f64::INFINITY) {
            let off = closest_point(&mesh, &Pose::IDENTITY, hit.point).expect("finite").distance;
            assert!(off < 1e-14, "{case}: {off:e} off, {hit:?} {mesh:?}");
            met += 1;
        }
    }
    assert!(met > 1000, "{met}");
}

/// A ray through a corner of a triangle whose sides there, projected along the ray, are perpendicular (a fuzz finding:
/// the hit was at the height of the other end of a side, 0.5 m from the triangle).
#[test]
fn a_ray_through_a_corner_ends_there() {
    let (mut random, mut met) = (Random(15), 0);
    for case in 0..50_000 {
        // Projected along the ray the sides are perpendicular, exactly or nearly; half of the rays are along a
        // diagonal.
        let direction = if case % 2 == 0 { DVec3::ONE.normalize() } else { random.direction() };
        let turn = Rotation::from_rotation_vector(direction * random.between(0.0, 6.0));
        let east = turn.rotate(direction.any_orthonormal_vector());
        let aside = direction.cross(east) + east * if case % 4 < 2 { 0.0 } else { random.between(-1e-15, 1e-15) };
        let sides = [east * random.between(0.1, 1.0), aside * random.between(0.1, 6.0)];
        let along = [random.between(1.0, 9.0), random.between(1.0, 9.0), random.between(1.0, 9.0)];
        let corners = [DVec3::ZERO, sides[0], sides[1]].into_iter().zip(along).map(|(side, t)| side + direction * t);
        let mesh = Shape::triangle_mesh(corners.collect(), vec![[0, 1, 2]]).expect("a triangle");
        let ray = ray(DVec3::ZERO, direction);
        if let Some(hit) = ray_cast(&mesh, &Pose::IDENTITY, &ray, f64::INFINITY) {
            let off = closest_point(&mesh, &Pose::IDENTITY, hit.point).expect("finite").distance;
            assert!(off < 1e-13, "{case}: {off:e} off, {hit:?} {mesh:?}");
            met += 1;
        }
    }
    assert!(met > 1000, "{met}");
}

/// A ray from ten million times the triangle's size away hits or misses it correctly when it aims inside or outside by
/// a thousandth.
#[test]
fn a_ray_from_far_away_hits_the_triangle_that_it_aims_at() {
    let mut random = Random(13);
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let mesh = Shape::triangle_mesh(corners.to_vec(), vec![[0, 1, 2]]).expect("a triangle");
    for case in 0..5000 {
        let along = random.unit();
        for (inward, meets) in [(1e-3, true), (-1e-3, false)] {
            // Beside the long side.
            let target = corners[1].lerp(corners[2], 0.1 + 0.8 * along) - DVec3::new(inward, inward, 0.0);
            let toward = (random.direction() + DVec3::Z * 2.0).normalize();
            let ray = ray(target - toward * 1e7, toward);
            let hit = ray_cast(&mesh, &Pose::IDENTITY, &ray, f64::INFINITY);
            assert_eq!(hit.is_some(), meets, "{case}: {hit:?}");
        }
    }
}

/// Rays that deviate from the direction of an axis by any angle down to the smallest number (a fuzz finding: the square
/// of 1e-159 underflowed, and a ray 5 m beside a cylinder hit its disc): they hit the end of the body if they start
/// over it, and otherwise miss it.
#[test]
fn rays_almost_along_an_axis_hit_only_bodies_under_their_origin() {
    let bodies = [cylinder(0.5, 0.3), capsule(0.5, 0.3)];
    let mut random = Random(37);
    for power in 10..324 {
        let lean = libm::exp10(-f64::from(power));
        for (body, turns) in bodies.iter().flat_map(|body| [(body, 0.0), (body, TAU)]) {
            // In the plane in which the ray leans, or anywhere.
            let turn = 0.25 * TAU + turns * random.unit();
            let aside = DVec3::new(libm::cos(turn), libm::sin(turn), 0.0);
            let towards = DVec3::new(0.0, if power % 2 == 0 { lean } else { -lean }, 1.0);
            let from = random.between(0.6, 5.0);
            let beside = ray_cast(body, &Pose::IDENTITY, &ray(aside * from - DVec3::Z * 6.0, towards), 1e9);
            assert_eq!(beside, None, "{power} {from} {body:?}");
            let within = random.between(0.0, 0.4);
            let over = ray_cast(body, &Pose::IDENTITY, &ray(aside * within - DVec3::Z * 6.0, towards), 1e9);
            let round = if matches!(body, Shape::Capsule(_)) { libm::sqrt(0.25 - within * within) } else { 0.0 };
            let off = over.map(|hit| hit.distance - (5.85 - round));
            assert!(off.is_some_and(|off| off.abs() < 1e-8), "{power} {within} {over:?}");
        }
    }
}

/// A ray from inside has a hit at its origin; meshes are surfaces and have no inside.
#[test]
fn rays_from_inside_start_there() {
    for (name, shape) in bounded_shapes() {
        let start = if name == "torus" { DVec3::X * 0.4 } else { DVec3::new(0.01, 0.02, 0.03) };
        let hit = ray_cast(&shape, &Pose::IDENTITY, &ray(start, DVec3::X), 10.0);
        match name {
            "points" | "mesh" => assert!(hit.is_none_or(|hit| hit.distance > 0.0), "{name}"),
            _ => assert!(hit.is_some_and(|hit| hit.distance == 0.0 && hit.feature.is_none()), "{name}: {hit:?}"),
        }
    }
}

/// The same ray and shape far away, scaled and rotated give the same hit.
#[test]
fn hits_do_not_depend_on_place_and_attitude() {
    let mut random = Random(6);
    for (name, shape) in bounded_shapes() {
        for _ in 0..100 {
            let one = ray(random.direction() * 2.0, random.vector());
            let first = ray_cast(&shape, &Pose::IDENTITY, &one, 10.0);
            let all = random.pose(1e6);
            let turned = Ray::new(
                all.transform_point(one.origin()),
                UnitVector::new(all.rotation.rotate(one.direction())).expect("unit"),
            );
            let other = ray_cast(&shape, &all, &turned.expect("finite"), 10.0);
            match (first, other) {
                (Some(p), Some(q)) => assert!((p.distance - q.distance).abs() < 1e-7, "{name}: {p:?} {q:?}"),
                (None, None) => {}
                // Only rays that graze to the rounding of positions a million metres away may differ.
                _ => {
                    let least = (0..4000).map(|k| one.at(f64::from(k) / 400.0));
                    let least =
                        least.map(|p| closest_point(&shape, &Pose::IDENTITY, p).expect("finite").distance.abs());
                    assert!(least.fold(f64::INFINITY, f64::min) < 1e-3, "{name}");
                }
            }
        }
    }
}

/// Numbers that are not finite make no ray, or a ray that hits nothing.
#[test]
fn hostile_rays_hit_nothing() {
    assert!(matches!(Ray::new(DVec3::X * f64::NAN, UnitVector::X), Err(QueryError::NotFinite { .. })));
    let down = ray(DVec3::Z * 3.0, -DVec3::Z);
    for (name, shape) in bounded_shapes() {
        assert!(ray_cast(&shape, &at(f64::NAN, 0.0, 0.0), &down, 10.0).is_none(), "{name}");
        assert!(ray_cast(&shape, &Pose::IDENTITY, &down, f64::NAN).is_none(), "{name}");
        assert!(ray_cast(&shape, &Pose::IDENTITY, &down, -1.0).is_none(), "{name}");
        for far in [1e100, 1e200, 1e300] {
            let _ = ray_cast(&shape, &Pose::new(Rotation::IDENTITY, DVec3::splat(far)), &down, f64::INFINITY);
        }
    }
    let hit = ray_cast(&cuboid(1.0, 1.0, 1.0), &Pose::IDENTITY, &down, f64::INFINITY).expect("a hit");
    assert_eq!(hit.feature.map(|feature| feature.surface), Some(SurfaceFeature::Face(5)));
}
