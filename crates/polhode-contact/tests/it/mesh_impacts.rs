//! Impacts on triangle meshes: the time of impact on a flat grid is that on the plane, sliding over it is no impact,
//! bodies that slide over the floor hit a ramp, and a fast flight over many triangles tests few of them.

use crate::derivatives::assert_rate;
use crate::meshes::grid;
use crate::support::{Flight, Random, ball, cuboid, floor, prism};
use polhode_contact::{ImpactSearch, Shape, find_impact, manifold, time_of_impact};
use polhode_spatial::{DVec3, Motion, Pose, Still};

#[test]
fn impacts_on_a_flat_grid_are_those_on_the_half_space() {
    let mut random = Random(71);
    let settings = ImpactSearch::default();
    let floor = floor();
    let bodies = [cuboid(0.5, 0.4, 0.3), prism(9, 0.3, 0.5), ball(0.3)];
    for case in 0..90 {
        let mesh = grid(20, 40.0, 0.3, &mut random, |_, _| 0.0);
        let body = &bodies[case % 3];
        let start = Pose::new(random.rotation(), DVec3::new(0.0, 0.0, 1.0));
        let mut flight = Flight::new(start, random.vector() * 3.0, random.vector() * 10.0);
        flight.acceleration = DVec3::Z * -9.81;
        flight.precession = random.vector();
        let ground = Still(Pose::IDENTITY);
        let expected = time_of_impact(body, &flight, &floor, &ground, 0.0, 1.5, &settings).expect("an answer");
        let found = find_impact(body, &flight, &mesh, &ground, 0.0, 1.5, &settings).expect("an answer");
        let (e, f) = (expected.expect("a hit"), found.time.expect("a hit"));
        assert!((e - f).abs() <= 1e-12, "case {case}: {e} and {f}");
    }
}

#[test]
fn sliding_over_a_grid_is_no_impact_and_a_ramp_is_one() {
    let mut random = Random(73);
    let settings = ImpactSearch::default();
    let ground = Still(Pose::IDENTITY);
    for case in 0..10 {
        let body = cuboid(0.4, 0.4, 0.2);
        let slide = Flight::new(Pose::from_translation(DVec3::new(-1.0, 0.03, 0.1)), DVec3::X * 2.0, DVec3::ZERO);
        let flat = grid(20, 4.0, 0.3, &mut random, |_, _| 0.0);
        let found = find_impact(&body, &slide, &flat, &ground, 0.0, 0.9, &settings).expect("an answer");
        assert_eq!(found.time, None, "case {case}");
        // From x = 0.6 the ground rises at 45 degrees: the body's lower front edge meets it.
        let ramp = grid(20, 4.0, 0.0, &mut random, |x, _| (x - 0.6).max(0.0));
        let hit = time_of_impact(&body, &slide, &ramp, &ground, 0.0, 0.9, &settings).expect("an answer");
        assert!((hit.expect("a hit") - 0.7).abs() < 1e-9, "case {case}: {hit:?}");
    }
}

#[test]
fn thin_sheets_stop_fast_bodies_from_both_sides() {
    let mut random = Random(79);
    let settings = ImpactSearch::default();
    let sheet = grid(6, 3.0, 0.3, &mut random, |_, _| 0.0);
    for case in 0..60 {
        let up = if case % 2 == 0 { 1.0 } else { -1.0 };
        let ball = ball(0.01);
        let start = Pose::from_translation(DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 5.0 * up));
        let shot = Flight::new(start, DVec3::Z * (-1000.0 * up), random.vector() * 1e4);
        let hit = time_of_impact(&ball, &shot, &sheet, &Still(Pose::IDENTITY), 0.0, 1.0, &settings).expect("an answer");
        let expected = (5.0 - 0.01) / 1000.0;
        assert!((hit.expect("a hit") - expected).abs() < 1e-15, "case {case}: {hit:?}");
        let splinter = cuboid(0.02, 0.001, 0.3);
        let hit =
            time_of_impact(&splinter, &shot, &sheet, &Still(Pose::IDENTITY), 0.0, 1.0, &settings).expect("an answer");
        assert!(hit.expect("a hit") < 5.0 / 1000.0, "case {case}");
    }
}

/// A ground of 100,352 triangles: a long fast flight low over it tests only the triangles under its path.
#[test]
fn a_flight_over_a_hundred_thousand_triangles_tests_few() {
    let mut random = Random(83);
    let settings = ImpactSearch::default();
    let mesh = grid(224, 224.0, 0.3, &mut random, |x, y| 0.2 * libm::sin(x) * libm::cos(y));
    let body = cuboid(0.5, 0.4, 0.3);
    let mut flight =
        Flight::new(Pose::from_translation(DVec3::new(-80.0, 3.0, 2.0)), DVec3::X * 300.0, DVec3::Y * 20.0);
    flight.acceleration = DVec3::Z * -9.81;
    let found = find_impact(&body, &flight, &mesh, &Still(Pose::IDENTITY), 0.0, 1.0, &settings).expect("an answer");
    let t = found.time.expect("a hit");
    assert!(found.evaluations < 20_000, "{} evaluations", found.evaluations);
    let at = flight.pose(t);
    let touch = manifold(&body, &at, &mesh, &Pose::IDENTITY, 1e-9);
    assert!(touch.separation.abs() < 1e-12 && !touch.contacts.is_empty(), "{touch:#?}");
}

#[test]
fn kinematics_on_a_mesh_are_the_derivatives_of_the_separation() {
    let mut random = Random(89);
    let mesh = grid(6, 3.0, 0.3, &mut random, |x, y| 0.3 * libm::sin(3.0 * x) * libm::cos(2.0 * y));
    let bodies = [cuboid(0.5, 0.4, 0.3), ball(0.2), prism(5, 0.3, 0.3)];
    let mut kinds = std::collections::BTreeSet::new();
    for case in 0..300 {
        let body = &bodies[case % 3];
        let start = Pose::new(random.rotation(), DVec3::new(random.unit(), random.unit(), random.between(0.0, 0.7)));
        let flight = Flight::new(start, random.vector(), random.vector());
        let ground = Flight::new(Pose::IDENTITY, random.vector(), random.vector());
        let poses = [flight.pose(0.0), ground.pose(0.0)];
        for contact in manifold(body, &poses[0], &mesh, &poses[1], 0.2).contacts {
            kinds.insert(format!("{:?}", contact.feature).chars().filter(|c| !c.is_numeric()).collect::<String>());
            assert_rate(contact.feature, [body, &mesh], &[flight, ground]);
        }
    }
    assert!(kinds.len() >= 4, "{kinds:?}");
}

/// Bodies that touch the ground at the start: a body that moves into it has an impact at once, from either side; one
/// that leaves has none; one that slides has an impact where the ramp begins. A point in a sheet is on neither side of
/// it, and may leave on either.
#[test]
fn bodies_that_touch_a_mesh_at_the_start() {
    let mut random = Random(83);
    let settings = ImpactSearch::default();
    let still = Still(Pose::IDENTITY);
    let points = |places: &[DVec3]| Shape::points(places.to_vec()).expect("points");
    let corners = [DVec3::new(0.1, 0.0, 0.0), DVec3::new(-0.1, 0.1, 0.0), DVec3::new(-0.1, -0.1, 0.0)];
    // The shape, its lowest point and its extent forward there.
    let bodies = [
        ("a cube", cuboid(0.2, 0.2, 0.2), 0.1, 0.1),
        ("a point", points(&[DVec3::ZERO]), 1e-15, 0.0),
        ("three points", points(&corners), 1e-15, 0.1),
    ];
    let mut wrong = Vec::new();
    for case in 0..12 {
        let flat = grid(20, 4.0, 0.3, &mut random, |_, _| 0.0);
        let ramp = grid(20, 4.0, 0.0, &mut random, |x, _| (x - 0.6).max(0.0));
        for (name, body, height, front) in &bodies {
            for side in [1.0, -1.0] {
                let start = DVec3::new(random.between(-0.4, 0.0), random.between(-0.3, 0.3), height * side);
                let fly = |velocity: DVec3| Flight::new(Pose::from_translation(start), velocity, DVec3::ZERO);
                let time = |flight: &Flight, mesh: &Shape| {
                    let found = time_of_impact(body, flight, mesh, &still, 0.0, 1.0, &settings).expect("an answer");
                    let back = time_of_impact(mesh, &still, body, flight, 0.0, 1.0, &settings).expect("an answer");
                    assert_eq!(found, back, "{name}");
                    found
                };
                let into = time(&fly(DVec3::new(0.3, 0.1, -side)), &flat);
                let away = time(&fly(DVec3::new(0.3, 0.1, side)), &flat);
                let along = time(&fly(DVec3::new(0.3, 0.1, 0.0)), &flat);
                let struck = if side > 0.0 { time(&fly(DVec3::X), &ramp) } else { None };
                let expected = 0.6 - front - start.x;
                let right = into.is_some_and(|t| t < 1e-9) != matches!(body, Shape::Points(_))
                    && away.is_none()
                    && along.is_none()
                    && (side < 0.0 || struck.is_some_and(|t| (t - expected).abs() < 1e-9));
                if !right {
                    wrong.push(format!("{case} {name} {side}: {into:?} {away:?} {along:?} {struck:?} {expected}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
