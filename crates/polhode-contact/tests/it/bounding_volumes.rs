//! Bounding boxes contain every point of their shapes, at poses and in motion.

use crate::support::{Flight, Random, at, ball, capsule, cone, cuboid, cylinder, floor, prism, ring};
use polhode_contact::{Aabb, Shape, aabb_of, swept_aabb};
use polhode_spatial::{DVec3, Motion, Pose, Still};

/// Shapes of every bounded kind, each with points on its surface.
fn shapes(random: &mut Random) -> Vec<(Shape, Vec<DVec3>)> {
    let around = |random: &mut Random, radius: f64, z: f64| {
        let angle = random.between(0.0, std::f64::consts::TAU);
        DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
    };
    let cloud: Vec<_> = (0..12).map(|_| random.vector()).collect();
    let brick = cuboid(1.0, 0.4, 0.2);
    let disc: Vec<_> = (0..40).map(|_| around(random, 0.5, 0.3)).collect();
    let mut of_cone: Vec<_> = (0..40).map(|_| around(random, 0.7, -0.3)).collect();
    of_cone.push(DVec3::Z * 0.9);
    let circle: Vec<_> = (0..40).map(|_| around(random, 1.0, 0.0)).collect();
    let tube = circle.into_iter().map(|p| p + random.direction() * 0.2).collect();
    let of_capsule = (0..40).map(|k| DVec3::Z * (f64::from(k % 2) - 0.5) + random.direction() * 0.2).collect();
    let corners = |shape: &Shape| match shape {
        Shape::Convex(polyhedron) => polyhedron.vertices().to_vec(),
        _ => Vec::new(),
    };
    let far = brick.translated(DVec3::splat(2.0)).expect("moved");
    let ball = ball(0.3);
    let compound = Shape::compound(vec![far.clone(), ball.clone()]).expect("parts");
    let mut of_compound = corners(&far);
    of_compound.extend((0..40).map(|_| random.direction() * 0.3));
    vec![
        (brick.clone(), corners(&brick)),
        (prism(7, 0.5, 0.1), corners(&prism(7, 0.5, 0.1))),
        (Shape::points(cloud.clone()).expect("points"), cloud),
        (Shape::points(vec![DVec3::ONE]).expect("a point"), vec![DVec3::ONE]),
        (ball, (0..40).map(|_| random.direction() * 0.3).collect()),
        (cylinder(0.5, 0.6), disc),
        (cone(0.7, 1.2), of_cone),
        (ring(1.0, 0.2), tube),
        (capsule(0.2, 1.0), of_capsule),
        (compound, of_compound),
    ]
}

/// Every box contains every point, at poses near and far.
#[test]
fn boxes_contain_every_point() {
    let mut random = Random(41);
    for round in 0..40 {
        for (shape, points) in &shapes(&mut random) {
            let pose = random.pose(if round % 2 == 0 { 1.0 } else { 1e6 });
            let aabb = aabb_of(shape, &pose).expect("finite");
            assert!(points.iter().all(|&point| aabb.contains(pose.transform_point(point))), "{shape:?}");
        }
    }
}

/// A half-space has no bounds, and a pose that is not finite no box.
#[test]
fn unbounded_shapes_and_poses_that_are_not_finite() {
    let nowhere = Pose::from_translation(DVec3::splat(f64::NAN));
    let floor = floor();
    assert_eq!(aabb_of(&floor, &Pose::IDENTITY), Ok(Aabb::UNBOUNDED));
    assert!(aabb_of(&floor, &nowhere).is_err() && aabb_of(&cuboid(1.0, 1.0, 1.0), &nowhere).is_err());
}

/// NaN and reversed bounds and intervals are refused.
#[test]
fn invalid_boxes_and_motions() {
    let unit = Aabb::new(DVec3::ZERO, DVec3::ONE).expect("a box");
    assert!(Aabb::new(DVec3::splat(f64::NAN), DVec3::ONE).is_err());
    assert!(Aabb::new(DVec3::ONE, DVec3::ZERO).is_err());
    assert!(unit.inflated(f64::NAN).is_err());
    assert!(swept_aabb(&cuboid(1.0, 1.0, 1.0), &Still(at(f64::NAN, 0.0, 0.0)), 0.0, 1.0).is_err());
    assert!(swept_aabb(&cuboid(1.0, 1.0, 1.0), &Still(at(0.0, 0.0, 0.0)), 1.0, 0.0).is_err());
}

/// The box of a flight contains every point of the body at every time, and is tight for a body at rest.
#[test]
fn swept_boxes_contain_the_motion() {
    let mut random = Random(3);
    let shapes = [
        cuboid(1.0, 0.3, 0.2),
        ball(0.4).translated(DVec3::new(0.5, 0.0, 0.1)).expect("moved"),
        Shape::points(vec![DVec3::ONE, DVec3::X]).expect("points"),
    ];
    for _ in 0..100 {
        let start = random.pose(3.0);
        let mut flight = Flight::new(start, random.vector() * 5.0, random.vector() * random.between(0.0, 20.0));
        flight.acceleration = random.vector() * 10.0;
        let (t0, t1) = (random.between(-1.0, 1.0), random.between(1.0, 1.6));
        for shape in &shapes {
            let bounds = swept_aabb(shape, &flight, t0, t1).expect("a box");
            for i in 0..=50 {
                let pose = flight.pose(t0 + (t1 - t0) * f64::from(i) / 50.0);
                let now = swept_aabb(shape, &Still(pose), 0.0, 0.0).expect("a box");
                assert!(bounds.encloses(&now));
            }
        }
    }
    let still = swept_aabb(&cuboid(1.0, 2.0, 4.0), &Still(Pose::IDENTITY), 0.0, 5.0).expect("a box");
    assert!((still.max() - DVec3::new(0.5, 1.0, 2.0)).length() < 1e-13);
    assert_eq!(swept_aabb(&floor(), &Still(Pose::IDENTITY), 0.0, 1.0), Ok(Aabb::UNBOUNDED));
}
