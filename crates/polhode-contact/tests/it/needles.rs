//! Needle triangles of the least height that a mesh admits, 1e-12 of their length. The normal of such a triangle is
//! uncertain, but its distance from a point is not: no point of it moves farther by rounding than its corners do.

use crate::support::{Random, off_segment};
use polhode_contact::{Ray, Shape, closest_point, ray_cast};
use polhode_spatial::{DVec3, Pose, UnitVector};

/// A triangle with its longest side from the origin along x: its length, the position of the tip along it, and its
/// height.
fn flat_triangle(random: &mut Random) -> [DVec3; 3] {
    let length = random.between(0.5, 8.0);
    let height = 0.5 * length * libm::exp10(random.between(-11.6, 0.0));
    [DVec3::ZERO, DVec3::X * length, DVec3::new(random.between(0.0, 1.0) * length, height, 0.0)]
}

/// Distance of a point from a triangle in the plane z = 0.
fn off_triangle([a, b, c]: [DVec3; 3], x: DVec3) -> f64 {
    let inner = |p: DVec3, q: DVec3| (q - p).cross(DVec3::new(x.x, x.y, 0.0) - p).z >= 0.0;
    if inner(a, b) && inner(b, c) && inner(c, a) {
        return x.z.abs();
    }
    off_segment([a, b], x).min(off_segment([b, c], x)).min(off_segment([c, a], x))
}

/// A fuzz finding: a point on a needle of 5.1 m x 4e-11 m was 3.4e-6 m off it, because the normal was computed from the
/// long sides.
#[test]
fn the_distance_from_a_needle_is_that_computed_in_its_plane() {
    let (mut random, mut worst) = (Random(41), 0.0_f64);
    for case in 0..40_000 {
        let corners = flat_triangle(&mut random);
        let [_, end, tip] = corners;
        let (along, across) = (random.between(-0.2, 1.2) * end.x, random.between(-1.0, 2.0) * tip.y);
        let above = random.between(-1.0, 1.0) * libm::exp10(random.between(-14.0, 1.0));
        let beside = if case % 2 == 0 { 0.0 } else { random.between(-1.0, 1.0) };
        let point = DVec3::new(along, across + beside, above);
        let turn = random.pose(1.0);
        let shift = case as usize % 3;
        let turned = [0, 1, 2].map(|k| turn.transform_point(corners[(k + shift) % 3]));
        let Ok(mesh) = Shape::triangle_mesh(turned.to_vec(), vec![[0, 1, 2]]) else { continue };
        let near = closest_point(&mesh, &Pose::IDENTITY, turn.transform_point(point)).expect("a finite point");
        let off = (near.distance - off_triangle(corners, point)).abs();
        let off = off.max(off_triangle(corners, turn.inverse_transform_point(near.point)));
        worst = worst.max(off / (end.x + point.length()));
        assert!(off <= 2e-15 * (end.x + point.length()), "{case}: {off} off: {near:?} {corners:?} {point}");
    }
    println!("worst relative error of a distance from a needle: {worst:e}");
}

/// The normal of a needle is that of its two shortest sides, whichever corner is first.
#[test]
fn a_needle_has_the_normal_of_its_short_sides() {
    let corners = [DVec3::new(4.0, -1.0, -3.0), DVec3::ZERO, DVec3::new(4.2e-11, -1e-12, 0.0)];
    // From the corner at the origin, from which both sides are known exactly.
    let normal = corners[2].cross(corners[0]).normalize();
    for shift in 0..3 {
        let turned = [0, 1, 2].map(|k: usize| corners[(k + shift) % 3]).to_vec();
        let mesh = Shape::triangle_mesh(turned, vec![[0, 1, 2]]).expect("a triangle");
        let place = (corners[0] + corners[1] + corners[2]) / 3.0;
        let near = closest_point(&mesh, &Pose::IDENTITY, place + normal * 1e-3).expect("a finite point");
        assert!((near.distance - 1e-3).abs() < 1e-15 && near.normal.dot(normal) > 0.0, "{near:?}");
        let ray = Ray::new(place + normal, UnitVector::new(-normal).expect("a normal")).expect("a ray");
        let hit = ray_cast(&mesh, &Pose::IDENTITY, &ray, 2.0).expect("it aims at the middle");
        assert!((hit.normal - normal).length() < 1e-15, "{hit:?}");
    }
}
