//! Bounding volumes contain every point of their shapes at random poses, are tight where closed forms are known, and
//! never miss an overlap.

use crate::support::{Random, cuboid, prism};
use polhode_contact::{Aabb, BoundingSphere, OrientedBox, Shape, aabb_of};
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

/// Every volume contains every point, at poses near and far, and so do those merged from two and those turned again.
#[test]
fn they_contain_every_point() {
    let mut random = Random(41);
    for round in 0..40 {
        let shapes = shapes(&mut random);
        for (shape, points) in &shapes {
            let pose = any_pose(&mut random, if round % 2 == 0 { 1.0 } else { 1e6 });
            let sphere = BoundingSphere::of(shape).expect("bounded");
            let oriented = OrientedBox::of(shape).expect("bounded");
            let other = OrientedBox::of(&shapes[0].0).expect("bounded").transformed(&any_pose(&mut random, 3.0));
            let merged = oriented.merged(&other);
            let wide = sphere.merged(&BoundingSphere::of(&shapes[2].0).expect("bounded").transformed(&pose));
            let aabb = aabb_of(shape, &pose).expect("finite");
            let (moved_sphere, moved_box) = (sphere.transformed(&pose), oriented.transformed(&pose));
            for &point in points {
                let place = pose.transform_point(point);
                assert!(sphere.contains(point) && moved_sphere.contains(place) && wide.contains(point), "{shape:?}");
                assert!(oriented.contains(point) && moved_box.contains(place) && merged.contains(point), "{shape:?}");
                assert!(aabb.contains(place), "{shape:?}");
                assert!(moved_sphere.aabb().expect("finite").contains(place));
            }
            assert!(other.corners().iter().all(|&corner| merged.contains(corner)));
        }
    }
}

/// Closed forms: the balls of a box, a regular tetrahedron, a cone and a capsule; a turned box finds its own box again.
#[test]
fn they_are_tight() {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-13 * b;
    let radius = |shape: &Shape| BoundingSphere::of(shape).expect("bounded").radius();
    assert!(near(radius(&cuboid(2.0, 3.0, 6.0)), 3.5));
    let tetrahedron =
        [DVec3::ONE, DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::new(-1.0, -1.0, 1.0)];
    assert!(near(radius(&Shape::points(tetrahedron.to_vec()).expect("points")), 3f64.sqrt()));
    // An obtuse triangle: the ball about its longest side.
    let obtuse = vec![DVec3::ZERO, DVec3::X * 4.0, DVec3::new(2.0, 0.5, 0.0)];
    assert!(near(radius(&Shape::points(obtuse).expect("points")), 2.0));
    assert!(near(radius(&Shape::cone(1.0, 2.0).expect("lengths")), 1.25));
    assert!(near(radius(&Shape::cone(2.0, 1.0).expect("lengths")), 2.0));
    assert!(near(radius(&Shape::capsule(0.5, 2.0).expect("lengths")), 1.5));
    let mut random = Random(9);
    for _ in 0..50 {
        let turned = cuboid(1.0, 2.0, 4.0).placed(&any_pose(&mut random, 1.0)).expect("placed");
        assert!(near(OrientedBox::of(&turned).expect("bounded").volume(), 8.0));
        for (shape, _) in shapes(&mut random) {
            let along_axes = aabb_of(&shape, &Pose::IDENTITY).expect("finite");
            let size = along_axes.max() - along_axes.min();
            let oriented = OrientedBox::of(&shape).expect("bounded");
            assert!(oriented.volume() <= size.x * size.y * size.z * (1.0 + 1e-13) + 1e-40, "{shape:?}");
        }
    }
    let floor = Shape::half_space(UnitVector::Z);
    assert!(BoundingSphere::of(&floor).is_none() && OrientedBox::of(&floor).is_none());
    assert_eq!(aabb_of(&floor, &Pose::IDENTITY), Ok(Aabb::UNBOUNDED));
    assert!(aabb_of(&floor, &Pose::from_translation(DVec3::splat(f64::NAN))).is_err());
    assert!(aabb_of(&cuboid(1.0, 1.0, 1.0), &Pose::from_translation(DVec3::splat(f64::NAN))).is_err());
}

/// A point common to two boxes proves their overlap; boxes on two sides of a plane that is none of theirs do not.
#[test]
fn no_overlap_is_missed() {
    let mut random = Random(123);
    let mut apart = 0;
    for _ in 0..20_000 {
        let brick = |random: &mut Random| {
            let size = (random.vector() + DVec3::splat(1.1)) * 0.5;
            OrientedBox::of(&cuboid(size.x, size.y, size.z)).expect("bounded").transformed(&any_pose(random, 1.0))
        };
        let (a, b) = (brick(&mut random), brick(&mut random));
        let inside = |o: &OrientedBox, p: DVec3| {
            (o.rotation().inverse_rotate(p - o.center()).abs() - o.half_size()).max_element()
        };
        // Alternating projections approach a common point when there is one, else the gap.
        let nearest = |o: &OrientedBox, p: DVec3| {
            let local = o.rotation().inverse_rotate(p - o.center()).clamp(-o.half_size(), o.half_size());
            o.center() + o.rotation().rotate(local)
        };
        let mut point = a.center();
        for _ in 0..200 {
            point = nearest(&a, nearest(&b, point));
        }
        let gap = inside(&b, point);
        if gap <= 0.0 {
            assert!(a.overlaps(&b) && b.overlaps(&a), "{a:?} {b:?}");
        } else if gap > 0.01 {
            assert!(!a.overlaps(&b), "{a:?} {b:?}, gap {gap}");
            apart += 1;
        }
    }
    assert!(apart > 1000);
}

/// Boxes that touch exactly, face to face with parallel axes, at any orientation and place, overlap.
#[test]
fn touch_is_overlap() {
    let mut random = Random(5);
    for _ in 0..2000 {
        let pose = any_pose(&mut random, 1e4);
        let cube = OrientedBox::of(&cuboid(1.0, 1.0, 1.0)).expect("bounded");
        let beside = Pose::from_translation(DVec3::new(1.0, random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
        assert!(cube.transformed(&pose).overlaps(&cube.transformed(&(pose * beside))));
        let ball = BoundingSphere::of(&Shape::sphere(0.5).expect("a radius")).expect("bounded");
        let along = Pose::from_translation(random.direction());
        assert!(ball.transformed(&pose).overlaps(&ball.transformed(&(pose * along))));
    }
}
