//! NaN, infinity, huge and tiny numbers: results without meaning are marked as such, and nothing panics or hangs.

use crate::support::{Flight, Random, at, ball, capsule, cone, cuboid, cylinder, floor, prism, ring, tangential};
use polhode_contact::{
    ImpactSearch, Manifold, Shape, Workspace, find_impact, kinematics, manifold, manifold_into, separation,
};
use polhode_spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use proptest::prelude::*;

fn shapes() -> Vec<Shape> {
    vec![
        cuboid(1.0, 1e-3, 7.0),
        prism(5, 1.0, 1.0),
        ball(1e-6),
        Shape::points(vec![DVec3::ZERO, DVec3::ONE]).expect("points"),
        Shape::half_space(UnitVector::Y),
        capsule(0.5, 1.0),
        cylinder(1.0, 1e-3),
        cone(0.5, 1.0),
        ring(1.0, 0.25),
    ]
}

/// Poses that are not finite give no contact and a NaN separation.
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

/// A workspace that was used for other pairs gives the same bits as a new one.
#[test]
fn results_do_not_depend_on_earlier_use_of_a_workspace() {
    let mut random = Random(23);
    let (mut workspace, mut kept) = (Workspace::default(), Manifold::default());
    let shapes = shapes();
    for _ in 0..500 {
        let (i, j) = ((random.unit() * 9.0) as usize, (random.unit() * 9.0) as usize);
        let (pose_a, pose_b) = (random.pose(1.0), random.pose(1.0));
        manifold_into(&mut workspace, &shapes[i], &pose_a, &shapes[j], &pose_b, 0.5, &mut kept);
        assert_eq!(kept, manifold(&shapes[i], &pose_a, &shapes[j], &pose_b, 0.5));
    }
}

/// Bodies at the same pose: a deep overlap with a finite depth and at least one contact with a unit normal, or no
/// contact (two clouds, two half-spaces, concentric spheres have no direction); never NaN.
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
    let ball = ball(1.0);
    let concentric = manifold(&ball, &Pose::IDENTITY, &ball, &Pose::IDENTITY, 1.0);
    assert_eq!((concentric.separation, concentric.contacts.len()), (-2.0, 0));
}

/// Balls and points so far apart that the square of their distance overflows have no contact, whatever the reach.
#[test]
fn distances_that_overflow_give_no_contact() {
    let ball = ball(1.0);
    let points = Shape::points(vec![DVec3::ZERO]).expect("a point");
    for other in [&ball, &points] {
        let far = manifold(&ball, &at(1e200, 0.0, 0.0), other, &Pose::IDENTITY, f64::INFINITY);
        assert!(far.contacts.is_empty() && far.separation == f64::INFINITY, "{far:?}");
    }
}

/// A cone deep in a polyhedron (a fuzz finding): an edge and the cone's side have two common normals, one of which
/// passes through the polyhedron and is no contact. No contact has a separation above that of the bodies.
#[test]
fn a_cone_deep_in_a_polyhedron_touches_no_edge_from_inside() {
    let mut random = Random(71);
    let cone = cone(0.7, 1.4);
    for case in 0..3000 {
        let corners: Vec<DVec3> = (0..6).map(|_| random.vector() * 4.0).collect();
        let Ok(body) = polhode_contact::ConvexPolyhedron::from_points(&corners) else { continue };
        let (body, pose) = (Shape::convex(body), random.pose(1.0));
        let found = manifold(&body, &Pose::IDENTITY, &cone, &pose, 0.0);
        if found.separation <= 0.0 {
            assert!(!found.contacts.is_empty(), "{case}");
        }
        for contact in &found.contacts {
            assert!(contact.geometry.separation <= 1e-9, "{case}: {contact:?} of {}", found.separation);
        }
    }
}

/// Points at just the reach over a triangle or a box of a compound (a fuzz finding): within it in the frame of the
/// part, and beyond it by rounding in the world. The separation of the listed contact itself decides.
#[test]
fn a_contact_beyond_reach_by_rounding_is_not_listed() {
    let mut random = Random(41);
    let corners = vec![DVec3::new(-9.0, -9.0, 0.0), DVec3::new(9.0, -9.0, 0.0), DVec3::new(0.0, 9.0, 0.0)];
    let mesh = Shape::triangle_mesh(corners, vec![[0, 1, 2]]).expect("a triangle");
    let slab = cuboid(9.0, 9.0, 2.0).translated(-DVec3::Z).expect("a slab");
    let compound = Shape::compound(vec![slab]).expect("a compound");
    let points: Vec<DVec3> = (0..8).map(|k| DVec3::new(0.1 * f64::from(k), 0.0, 5.5 * f64::from(k % 2))).collect();
    let points = Shape::points(points).expect("points");
    let mut listed = 0;
    for case in 0..500 {
        let (ground, pose) = (if case % 2 == 0 { &mesh } else { &compound }, random.vector() * 9.0);
        let pose = Pose::new(random.rotation(), pose);
        for contact in manifold(ground, &pose, &points, &pose, 5.5).contacts {
            assert!(contact.geometry.separation <= 5.5, "{case}: {contact:?}");
            listed += 1;
        }
    }
    assert!(listed >= 4 * 500, "those that touch are: {listed}");
}

/// A ring deep in a body (a fuzz finding): its deepest point may be equally near to two elements of the body, and is
/// then no common normal. A common normal of these elements elsewhere with a positive separation is no contact.
#[test]
fn a_ring_deep_in_a_body_has_no_contact_beyond_reach() {
    let mut random = Random(83);
    let ring = ring(2.3, 2.2);
    let bodies = [cone(2.8, 2.4), cylinder(2.8, 2.4), capsule(2.0, 2.4), prism(5, 2.8, 2.4)];
    for case in 0..4000 {
        let (body, reach) = (&bodies[case % 4], -random.between(0.0, 3.0));
        let pose = random.pose(2.0);
        for contact in manifold(&ring, &pose, body, &Pose::IDENTITY, reach).contacts {
            assert!(contact.geometry.separation <= 1e-9, "{case}: {contact:?}");
        }
    }
}

/// A ball whose centre lies on the axis of a capsule, or on the centre circle of a ring's tube, to rounding or exactly
/// (a fuzz finding): the direction of least penetration is perpendicular to the axis, whatever the rounding of the
/// difference, and is the same with A and B swapped.
#[test]
fn a_ball_on_an_axis_is_pushed_out_perpendicular_to_it() {
    let (ball, mut random) = (ball(3.2), Random(5));
    let capsule = capsule(2.3, 0.9);
    let ring = ring(9.0, 2.3);
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

/// A ball whose centre lies on the axis of a cone, exactly or to rounding (a fuzz finding), has the smaller of the
/// depths through its side and its disc: `R + s sin(alpha)` deep at the distance s from the apex, or `R + h - s`,
/// whichever is less.
#[test]
fn a_ball_on_the_axis_of_a_cone_is_pushed_out_through_side_or_disc() {
    let (ball, mut random) = (ball(1.5), Random(29));
    for _ in 0..2000 {
        let (radius, height) = (random.between(0.1, 2.0), random.between(0.5, 3.0));
        let sine = radius / libm::hypot(radius, height);
        let cone = cone(radius, height);
        let from_apex = random.between(0.1, 0.9) * height;
        let own = DVec3::Z * (0.75 * height - from_apex);
        let deep = 1.5 + (from_apex * sine).min(height - from_apex);
        let turned = random.pose(4.0);
        // Exactly on the axis, which rounding does not move.
        let level = Pose::from_translation(random.vector());
        for pose in [turned, level, Pose::IDENTITY] {
            let place = Pose::new(random.rotation(), pose.transform_point(own));
            let both = [separation(&ball, &place, &cone, &pose), separation(&cone, &pose, &ball, &place)];
            assert!(both.iter().all(|s| (s + deep).abs() < 1e-13), "{both:?} of {deep}: {pose:?} {place:?}");
        }
    }
}

/// A point within rounding of an axis or of the centre circle of a ring's tube (a fuzz finding) has no normal, whatever
/// the rounding; a little farther off it has one. Every listed contact can be evaluated, with its rates.
#[test]
fn a_point_almost_on_an_axis_has_a_contact_with_rates_or_none() {
    let mut random = Random(17);
    for size in [1e-3, 1.0, 40.0] {
        let ring = ring(size, 0.3 * size);
        let rod = capsule(0.3 * size, size);
        let points = [
            Shape::points(vec![DVec3::ZERO, DVec3::ONE]).expect("points"),
            cone(0.7, 1.3).translated(-DVec3::Z * 0.65).expect("its apex at the origin"),
            capsule(0.5, 1.0),
            ball(0.5),
        ];
        for case in 0..4000 {
            let off = random.direction() * size * libm::exp10(random.between(-18.0, -8.0));
            let angle = random.between(0.0, 6.0);
            let pose = random.pose(10.0);
            let (thin, place) = if case % 2 == 0 {
                (&ring, DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * size)
            } else {
                (&rod, DVec3::Z * random.between(-0.5, 0.5) * size)
            };
            let place = Pose::new(random.rotation(), pose.transform_point(place + off));
            let moving = [(); 2].map(|()| Velocity::new(random.vector(), random.vector()));
            for point in &points {
                for [(a, pose_a), (b, pose_b)] in [[(thin, &pose), (point, &place)], [(point, &place), (thin, &pose)]] {
                    for contact in manifold(a, pose_a, b, pose_b, 0.1).contacts {
                        let moves = kinematics(contact.feature, a, pose_a, &moving[0], b, pose_b, &moving[1]);
                        let moves = moves.unwrap_or_else(|| panic!("{case}: {contact:?} {a:?} {b:?}"));
                        assert_eq!(moves.geometry, contact.geometry, "{case}: {contact:?}");
                        assert!(moves.acceleration_bias.abs() < 1e18 / size, "{case}: {moves:?}");
                        let slips = tangential(contact.feature, a, pose_a, &moving[0], b, pose_b, &moving[1]);
                        let slips = slips.unwrap_or_else(|| panic!("{case}: {contact:?} {a:?} {b:?}"));
                        assert!(slips.acceleration_bias.length() < 1e18 / size, "{case}: {slips:?}");
                    }
                }
            }
        }
    }
}

/// A rim much smaller than its distance from a plane (a fuzz finding: 10^27 m deep) has the rates of its lowest point,
/// finite for any ratio of the two lengths.
#[test]
fn a_rim_far_below_a_plane_has_kinematics() {
    let (rim, floor) = (cylinder(0.5, 1.0), floor());
    for depth in [0.0, 1e3, 1e9, 1e16, 1e27, 1e100] {
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, 0.5, 0.1)), -DVec3::Z * depth);
        let falling = Velocity::new(DVec3::new(0.2, 0.3, -1.0), DVec3::new(1.0, -2.0, 0.5));
        let found = manifold(&rim, &pose, &floor, &Pose::IDENTITY, 0.0).contacts;
        assert!(!found.is_empty());
        for contact in found {
            let moving = kinematics(contact.feature, &rim, &pose, &falling, &floor, &Pose::IDENTITY, &Velocity::ZERO);
            let arm = contact.geometry.point - pose.translation;
            let arm = arm + DVec3::Z * (contact.geometry.separation * 0.5);
            let moving = moving.unwrap_or_else(|| panic!("no kinematics at {depth}: {contact:?}"));
            assert_eq!(moving.geometry, contact.geometry);
            let rate = (falling.linear + falling.angular.cross(arm)).z;
            // The arm is computed from positions of the size of the depth.
            let rounding = 1e-12 * (1.0 + depth);
            assert!((moving.separation_rate - rate).abs() <= rounding && moving.acceleration_bias.is_finite());
            let slips = tangential(contact.feature, &rim, &pose, &falling, &floor, &Pose::IDENTITY, &Velocity::ZERO);
            let slips = slips.unwrap_or_else(|| panic!("no slip at {depth}: {contact:?}"));
            assert!(slips.slip_velocity.is_finite() && slips.acceleration_bias.is_finite(), "{slips:?}");
        }
    }
}

/// No points, coincident, collinear, coplanar or not finite ones give no shape, and an error with the reason.
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
        let snap_to = |c: f64, to: f64| if snap > 0 { (c / to).round() * to } else { c };
        let snapped = |v: [f64; 3], to: f64| DVec3::from_array(v.map(|c| snap_to(c, to)));
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

/// A bar of astronomic length and almost the largest finite spin sweeps over a ball that moves away from it. The bounds
/// of its corners' accelerations overflow, which proves nothing (before the fix, it was taken for a proof that the pair
/// stays clear): within a turn it hits.
#[test]
fn accelerations_that_overflow_are_no_proof_of_clearance() {
    let (bar, ball) = (cuboid(2e10, 1e9, 1e9), ball(1.0));
    let away = Flight::new(at(0.0, 5e9, 0.0), DVec3::Y, DVec3::ZERO);
    for spin in [1e100, 1e150, 1e153] {
        let turning = Flight::new(Pose::IDENTITY, DVec3::ZERO, DVec3::Z * spin);
        let found = find_impact(&bar, &turning, &ball, &away, 0.0, 1.0, &ImpactSearch::default());
        let time = found.as_ref().ok().and_then(|report| report.time);
        assert!(time.is_some_and(|time| time < 2.0 / spin), "{spin:e}: {found:?}");
    }
}
