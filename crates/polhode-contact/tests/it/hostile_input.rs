//! NaN, infinity, huge and tiny numbers: answers without meaning are marked as such, and nothing panics or hangs.

use crate::support::{Random, at, cuboid, prism};
use polhode_contact::{Shape, Workspace, kinematics, manifold, manifold_with, separation};
use polhode_spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use proptest::prelude::*;

fn shapes() -> Vec<Shape> {
    vec![
        cuboid(1.0, 1e-3, 7.0),
        prism(5, 1.0, 1.0),
        Shape::sphere(1e-6).expect("radius"),
        Shape::points(vec![DVec3::ZERO, DVec3::ONE]).expect("points"),
        Shape::half_space(UnitVector::Y),
        Shape::capsule(0.5, 1.0).expect("a capsule"),
        Shape::cylinder(1.0, 1e-3).expect("a cylinder"),
        Shape::cone(0.5, 1.0).expect("a cone"),
        Shape::torus(1.0, 0.25).expect("a ring"),
    ]
}

/// Poses that are not finite give no contact and a separation that is not a number.
#[test]
fn poses_that_are_not_finite() {
    for a in shapes() {
        for b in shapes() {
            for x in [f64::NAN, f64::INFINITY] {
                let result = manifold(&a, &at(x, 0.0, 0.0), &b, &Pose::IDENTITY, 1.0);
                assert!(result.contacts.is_empty() && result.separation.is_nan());
                assert!(separation(&a, &Pose::IDENTITY, &b, &at(0.0, x, 0.0)).is_nan());
            }
            assert!(manifold(&a, &Pose::IDENTITY, &b, &Pose::IDENTITY, f64::NAN).contacts.is_empty());
        }
    }
}

/// A workspace that has served other pairs gives the same bits as a fresh one.
#[test]
fn workspaces_carry_nothing_over() {
    let mut random = Random(23);
    let mut workspace = Workspace::default();
    let shapes = shapes();
    for _ in 0..500 {
        let (i, j) = ((random.unit() * 9.0) as usize, (random.unit() * 9.0) as usize);
        let (pose_a, pose_b) =
            (Pose::new(random.rotation(), random.vector()), Pose::new(random.rotation(), random.vector()));
        let kept = manifold_with(&mut workspace, &shapes[i], &pose_a, &shapes[j], &pose_b, 0.5);
        assert_eq!(kept, manifold(&shapes[i], &pose_a, &shapes[j], &pose_b, 0.5));
    }
}

/// Bodies in one place: a deep overlap with a finite depth and at least one contact of unit normal, or nothing to touch
/// (two clouds, two half-spaces, concentric spheres have no direction); never NaN.
#[test]
fn coincident_bodies() {
    for shape in shapes() {
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.1, 0.2, 0.3)), DVec3::ONE);
        let result = manifold(&shape, &pose, &shape, &pose, 1.0);
        assert!(!result.separation.is_nan(), "{shape:?}");
        let contacts = result.contacts.iter();
        assert!(contacts.clone().all(|c| c.geometry.point.is_finite() && c.geometry.normal.is_normalized()));
        if matches!(shape, Shape::Convex(_)) {
            assert!(result.separation < 0.0 && !result.contacts.is_empty(), "{result:?}");
        }
    }
    let ball = Shape::sphere(1.0).expect("radius");
    let concentric = manifold(&ball, &Pose::IDENTITY, &ball, &Pose::IDENTITY, 1.0);
    assert_eq!((concentric.separation, concentric.contacts.len()), (-2.0, 0));
}

/// Balls and points so far apart that the square of their distance overflows have no contact, whatever the reach.
#[test]
fn distances_that_overflow_give_no_contact() {
    let ball = Shape::sphere(1.0).expect("radius");
    let points = Shape::points(vec![DVec3::ZERO]).expect("a point");
    for other in [&ball, &points] {
        let far = manifold(&ball, &at(1e200, 0.0, 0.0), other, &Pose::IDENTITY, f64::INFINITY);
        assert!(far.contacts.is_empty() && far.separation == f64::INFINITY, "{far:?}");
    }
}

/// A cone deep in a polyhedron (a fuzz finding): of the two normals that an edge and the cone's side have in common one leads
/// through the polyhedron, and is no contact: none is farther apart than the bodies, which are as deep as the search says.
#[test]
fn a_cone_deep_in_a_polyhedron_touches_no_edge_from_inside() {
    let mut random = Random(71);
    let cone = Shape::cone(0.7, 1.4).expect("a cone");
    for case in 0..3000 {
        let corners: Vec<DVec3> = (0..6).map(|_| random.vector() * 4.0).collect();
        let Ok(body) = polhode_contact::ConvexPolyhedron::from_points(&corners) else { continue };
        let (body, pose) = (Shape::convex(body), Pose::new(random.rotation(), random.vector()));
        let found = manifold(&body, &Pose::IDENTITY, &cone, &pose, 0.0);
        if found.separation <= 0.0 {
            assert!(!found.contacts.is_empty(), "{case}");
        }
        for contact in &found.contacts {
            assert!(contact.geometry.separation <= 1e-9, "{case}: {contact:?} of {}", found.separation);
        }
    }
}

/// A ball whose centre lies on the axis of a capsule, or on the middle line of a ring's tube, to rounding or exactly (a
/// fuzz finding): the shortest way out is across the axis, whatever direction the rounding of the difference has, and is the
/// same when the bodies change names.
#[test]
fn a_ball_on_an_axis_leaves_across_it() {
    let (ball, mut random) = (Shape::sphere(3.2).expect("a ball"), Random(5));
    let capsule = Shape::capsule(2.3, 0.9).expect("a capsule");
    let ring = Shape::torus(9.0, 2.3).expect("a ring");
    for _ in 0..2000 {
        let (middle, turn) = (random.vector() * 4.5, random.rotation());
        let pose = Pose::new(turn, middle);
        let along = random.between(-0.4, 0.4);
        let on_axis = Pose::new(random.rotation(), middle + turn.rotate(DVec3::Z * along));
        let angle = random.between(0.0, 6.0);
        let on_tube =
            Pose::new(random.rotation(), middle + turn.rotate(DVec3::new(angle.cos(), angle.sin(), 0.0) * 9.0));
        for (shape, place) in [(&capsule, on_axis), (&capsule, pose), (&ring, on_tube)] {
            let both = [separation(&ball, &place, shape, &pose), separation(shape, &pose, &ball, &place)];
            assert!(both.iter().all(|s| (s + 5.5).abs() < 1e-13), "{both:?} {shape:?} {pose:?} {place:?}");
        }
    }
}

/// A rim that is tiny beside its distance from a plane (a fuzz finding: 10^27 m deep) moves as its lowest point does: the
/// rate of its separation is finite, whatever the ratio of the two lengths.
#[test]
fn a_rim_far_below_a_plane_has_kinematics() {
    let (rim, ground) = (Shape::cylinder(0.5, 1.0).expect("a cylinder"), Shape::half_space(UnitVector::Z));
    for depth in [0.0, 1e3, 1e9, 1e16, 1e27, 1e100] {
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, 0.5, 0.1)), -DVec3::Z * depth);
        let falling = Velocity::new(DVec3::new(0.2, 0.3, -1.0), DVec3::new(1.0, -2.0, 0.5));
        let found = manifold(&rim, &pose, &ground, &Pose::IDENTITY, 0.0).contacts;
        assert!(!found.is_empty());
        for contact in found {
            let moving = kinematics(contact.feature, &rim, &pose, &falling, &ground, &Pose::IDENTITY, &Velocity::ZERO);
            let arm = contact.geometry.point - pose.translation;
            let arm = arm + DVec3::Z * (contact.geometry.separation * 0.5);
            let moving = moving.unwrap_or_else(|| panic!("no kinematics at {depth}: {contact:?}"));
            assert_eq!(moving.geometry, contact.geometry);
            let rate = (falling.linear + falling.angular.cross(arm)).z;
            // The arm is read from places of the size of the depth.
            let rounding = 1e-12 * (1.0 + depth);
            assert!((moving.separation_rate - rate).abs() <= rounding && moving.acceleration_bias.is_finite());
        }
    }
}

/// Nothing, points in one place, on a line, in a plane, or not finite make no shape, and the error says why.
#[test]
fn empty_and_degenerate_shapes() {
    use polhode_contact::{ConvexPolyhedron, ShapeError};
    let line: Vec<DVec3> = (0..6).map(|i| DVec3::ONE * f64::from(i)).collect();
    let plane: Vec<DVec3> = (0..6).map(|i| DVec3::new(f64::from(i * i), f64::from(i), 2.0)).collect();
    for points in [vec![DVec3::ONE; 7], line, plane] {
        let refused = ConvexPolyhedron::from_points(&points);
        assert!(matches!(refused, Err(ShapeError::Flat { .. })), "{refused:?}");
    }
    assert!(matches!(ConvexPolyhedron::from_points(&[]), Err(ShapeError::TooFewPoints { count: 0, limit: 4 })));
    assert!(ConvexPolyhedron::from_faces(vec![], vec![]).is_err());
    assert!(matches!(Shape::points(vec![]), Err(ShapeError::TooFewPoints { .. })));
    assert!(matches!(Shape::points(vec![DVec3::NAN]), Err(ShapeError::NotFinite { .. })));
    assert!(Shape::compound(vec![]).is_err() && Shape::triangle_mesh(vec![], vec![]).is_err());
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        assert!(Shape::sphere(bad).is_err() && Shape::cuboid(DVec3::new(1.0, bad, 1.0)).is_err());
        assert!(Shape::capsule(bad, 1.0).is_err() && Shape::cylinder(bad, 1.0).is_err());
        assert!(Shape::cone(bad, 1.0).is_err() && Shape::torus(1.0, bad).is_err());
    }
    let moved = Shape::cuboid(DVec3::ONE).expect("a cube").translated(DVec3::new(f64::NAN, 0.0, 0.0));
    assert!(matches!(moved, Err(ShapeError::NotFinite { .. })), "{moved:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    /// Any finite poses and reach: every contact is finite, within reach, of unit normal, and the features are unique.
    #[test]
    fn any_poses(place in prop::array::uniform3(-3.0..3.0_f64), turn in prop::array::uniform3(-4.0..4.0_f64),
        snap in 0..3, exponent in -12..12_i32, reach in -1.0..2.0_f64, kinds in (0..9_usize, 0..9_usize)) {
        // Snapped poses give touching, aligned and coincident features.
        let snapped = |v: [f64; 3], to: f64| DVec3::from_array(v.map(|c| if snap > 0 { (c / to).round() * to } else { c }));
        let turn = Rotation::from_rotation_vector(
            if snap == 2 { DVec3::ZERO } else { snapped(turn, std::f64::consts::FRAC_PI_4) });
        let place = snapped(place, 0.5) * 10_f64.powi(exponent.max(0));
        let shapes = shapes();
        let result = manifold(&shapes[kinds.0], &Pose::new(turn, place), &shapes[kinds.1], &Pose::IDENTITY, reach);
        for pair in result.contacts.windows(2) {
            prop_assert!(pair[0].feature < pair[1].feature);
        }
        for contact in &result.contacts {
            prop_assert!(contact.geometry.point.is_finite());
            prop_assert!((contact.geometry.normal.length() - 1.0).abs() < 1e-12);
            prop_assert!(contact.geometry.separation <= reach.max(1e-9));
        }
    }
}
