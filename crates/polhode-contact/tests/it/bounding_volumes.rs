//! Bounding boxes contain every point of their shapes at random poses.

use crate::support::{Random, cuboid, prism};
use polhode_contact::{Aabb, Shape, aabb_of};
use polhode_spatial::{DVec3, Pose, UnitVector};

/// Shapes of every bounded kind, each with points on its surface.
fn shapes(random: &mut Random) -> Vec<(Shape, Vec<DVec3>)> {
    let around = |random: &mut Random, radius: f64, z: f64| {
        let angle = random.between(0.0, std::f64::consts::TAU);
        DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
    };
    let cloud: Vec<_> = (0..12).map(|_| random.vector()).collect();
    let brick = cuboid(1.0, 0.4, 0.2);
    let disc: Vec<_> = (0..40).map(|_| around(random, 0.5, 0.3)).collect();
    let mut cone: Vec<_> = (0..40).map(|_| around(random, 0.7, -0.3)).collect();
    cone.push(DVec3::Z * 0.9);
    let ring: Vec<_> = (0..40).map(|_| around(random, 1.0, 0.0)).collect();
    let tube = ring.into_iter().map(|p| p + random.direction() * 0.2).collect();
    let capsule = (0..40).map(|k| DVec3::Z * (f64::from(k % 2) - 0.5) + random.direction() * 0.2).collect();
    let corners = |shape: &Shape| match shape {
        Shape::Convex(polyhedron) => polyhedron.vertices().to_vec(),
        _ => Vec::new(),
    };
    let far = brick.translated(DVec3::splat(2.0)).expect("moved");
    let ball = Shape::sphere(0.3).expect("a radius");
    let compound = Shape::compound(vec![far.clone(), ball.clone()]).expect("parts");
    let mut of_compound = corners(&far);
    of_compound.extend((0..40).map(|_| random.direction() * 0.3));
    vec![
        (brick.clone(), corners(&brick)),
        (prism(7, 0.5, 0.1), corners(&prism(7, 0.5, 0.1))),
        (Shape::points(cloud.clone()).expect("points"), cloud),
        (Shape::points(vec![DVec3::ONE]).expect("a point"), vec![DVec3::ONE]),
        (ball, (0..40).map(|_| random.direction() * 0.3).collect()),
        (Shape::cylinder(0.5, 0.6).expect("lengths"), disc),
        (Shape::cone(0.7, 1.2).expect("lengths"), cone),
        (Shape::torus(1.0, 0.2).expect("radii"), tube),
        (Shape::capsule(0.2, 1.0).expect("lengths"), capsule),
        (compound, of_compound),
    ]
}

fn any_pose(random: &mut Random, reach: f64) -> Pose {
    Pose::new(random.rotation(), random.vector() * reach)
}

/// Every box contains every point, at poses near and far.
#[test]
fn they_contain_every_point() {
    let mut random = Random(41);
    for round in 0..40 {
        for (shape, points) in &shapes(&mut random) {
            let pose = any_pose(&mut random, if round % 2 == 0 { 1.0 } else { 1e6 });
            let aabb = aabb_of(shape, &pose).expect("finite");
            assert!(points.iter().all(|&point| aabb.contains(pose.transform_point(point))), "{shape:?}");
        }
    }
}

/// A half-space has no bounds, and a pose that is not finite no box.
#[test]
fn unbounded_shapes_and_poses_that_are_not_finite() {
    let nowhere = Pose::from_translation(DVec3::splat(f64::NAN));
    let floor = Shape::half_space(UnitVector::Z);
    assert_eq!(aabb_of(&floor, &Pose::IDENTITY), Ok(Aabb::UNBOUNDED));
    assert!(aabb_of(&floor, &nowhere).is_err() && aabb_of(&cuboid(1.0, 1.0, 1.0), &nowhere).is_err());
}
