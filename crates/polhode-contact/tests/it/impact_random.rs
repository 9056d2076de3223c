//! Times of impact of random shots against brute force: never late, never missed, and exact.

use crate::support::{Flight, Random, ball, cuboid, prism};
use polhode_contact::clearance::touch_tolerance;
use polhode_contact::{ImpactSearch, Shape, find_impact, kinematics, manifold, separation};
use polhode_spatial::{DVec3, Motion, Pose, UnitVector};

/// The result of a number of shots: bodies that fly at each other.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) hits: u32,
    pub(crate) misses: u32,
    evaluations: u32,
    most: u32,
}

/// One shot over `[0, 1]` s.
pub(crate) fn shoot(tally: &mut Tally, a: &Shape, motion_a: &Flight, b: &Shape, motion_b: &Flight, samples: u32) {
    shoot_within(tally, a, motion_a, b, motion_b, 1.0, samples);
}

/// One shot over `[0, t1]` s: at the time found the separation is zero, and no sample before it (of `samples`)
/// overlaps; when no impact is found, no sample overlaps at all.
pub(crate) fn shoot_within(
    tally: &mut Tally,
    a: &Shape,
    motion_a: &Flight,
    b: &Shape,
    motion_b: &Flight,
    t1: f64,
    samples: u32,
) {
    let settings = ImpactSearch::default();
    let gap = |t: f64| separation(a, &motion_a.pose(t), b, &motion_b.pose(t));
    if gap(0.0) <= 1e-9 {
        return;
    }
    let report = find_impact(a, motion_a, b, motion_b, 0.0, t1, &settings).expect("an answer");
    let speed = 1.0 + motion_a.velocity.linear.length() + motion_b.velocity.linear.length();
    let end = if let Some(t) = report.time {
        tally.hits += 1;
        assert!(t > 0.0 && t <= t1);
        assert!(gap(t).abs() <= 4e-15 * (4.0 + speed), "{} {}", gap(t), report.separation);
        assert_contact(a, motion_a, b, motion_b, t);
        t
    } else {
        tally.misses += 1;
        assert!(gap(t1) > 0.0);
        t1
    };
    for i in 0..samples {
        let t = end * f64::from(i) / f64::from(samples);
        assert!(gap(t) > 0.0, "overlap {} at {t} s, answer {:?}", gap(t), report);
    }
    tally.evaluations += report.evaluations;
    tally.most = tally.most.max(report.evaluations);
}

/// At the time of impact there are contacts within the touch tolerance, and at one of them the bodies approach.
fn assert_contact(a: &Shape, motion_a: &Flight, b: &Shape, motion_b: &Flight, t: f64) {
    let (pose_a, pose_b) = (motion_a.pose(t), motion_b.pose(t));
    let reach = touch_tolerance(a, &pose_a, b, &pose_b, 1e-11);
    let result = manifold(a, &pose_a, b, &pose_b, reach);
    let (velocity_a, velocity_b) = (motion_a.velocity(t), motion_b.velocity(t));
    let rates: Vec<f64> = result
        .contacts
        .iter()
        .filter_map(|c| kinematics(c.feature, a, &pose_a, &velocity_a, b, &pose_b, &velocity_b))
        .map(|k| k.separation_rate)
        .collect();
    assert!(rates.iter().any(|rate| *rate < 0.0), "{rates:?} {result:?}");
}

/// The motion of a body that starts at a distance (m) from the origin in a random direction and flies past near the
/// origin, after about `1/speed` s; `spin` is the largest angular speed, rad/s.
pub(crate) fn shooter(random: &mut Random, distance: f64, speed: f64, spin: f64) -> Flight {
    let start = random.direction() * distance;
    let aim = random.vector() * 0.8 - start;
    let angular = random.direction() * random.between(0.0, spin);
    let precession = random.direction() * random.between(0.0, 0.3 * spin);
    Flight { precession, ..Flight::new(Pose::new(random.rotation(), start), aim * speed, angular) }
}

/// Boxes that spin fast, shot at each other, both moving and both spinning.
#[test]
fn spinning_boxes() {
    let mut random = Random(2024);
    let mut tally = Tally::default();
    for _ in 0..1500 {
        let a = cuboid(random.between(0.1, 1.0), random.between(0.1, 1.0), random.between(0.1, 1.0));
        let b = cuboid(random.between(0.1, 1.0), random.between(0.1, 1.0), random.between(0.1, 1.0));
        let motion_a = shooter(&mut random, 2.0, 1.5, 10.0);
        let mut motion_b = shooter(&mut random, 1.0, 0.5, 10.0);
        motion_b.velocity.linear = random.vector();
        motion_b.acceleration = random.vector() * 10.0;
        shoot(&mut tally, &a, &motion_a, &b, &motion_b, 200);
    }
    assert!(tally.hits > 200 && tally.misses > 50, "{tally:?}");
    println!("{tally:?}");
}

/// Fast spinning boxes through plates a millimetre thin: a step over the plate would be a miss.
#[test]
fn through_thin_plates() {
    let mut random = Random(77);
    let mut tally = Tally::default();
    let plate = cuboid(2.0, 2.0, 1e-3);
    for _ in 0..1500 {
        let bullet = cuboid(0.05, 0.1, 0.02);
        let motion = shooter(&mut random, 3.0, 2.0, 60.0);
        let mut turning = Flight::new(Pose::new(random.rotation(), DVec3::ZERO), DVec3::ZERO, random.vector() * 3.0);
        turning.acceleration = DVec3::new(0.0, 0.0, -9.81);
        shoot(&mut tally, &bullet, &motion, &plate, &turning, 300);
    }
    assert!(tally.hits > 200, "{tally:?}");
    println!("{tally:?}");
}

/// Every other pair of shapes: spheres, clouds, half-spaces, polyhedra.
#[test]
fn all_kinds() {
    let mut random = Random(5);
    let mut tally = Tally::default();
    let cloud: Vec<DVec3> = (0..5).map(|_| random.vector() * 0.3).collect();
    let shapes = [
        cuboid(0.5, 0.3, 0.2),
        prism(6, 0.3, 0.2),
        ball(0.2),
        ball(0.2).translated(DVec3::new(0.1, 0.2, -0.1)).expect("moved"),
        Shape::points(cloud).expect("points"),
        Shape::half_space(UnitVector::new(DVec3::new(0.1, -0.2, 1.0)).expect("direction")),
    ];
    for (i, a) in shapes.iter().enumerate() {
        for (j, b) in shapes.iter().enumerate() {
            if i == 5 && j == 5 || i == 4 && j == 4 {
                continue;
            }
            for _ in 0..40 {
                let motion_a = shooter(&mut random, 1.5, 1.5, 12.0);
                let motion_b =
                    Flight::new(Pose::new(random.rotation(), DVec3::ZERO), random.vector(), random.vector() * 4.0);
                let (motion_a, motion_b) = if i == 5 { (motion_b, motion_a) } else { (motion_a, motion_b) };
                shoot(&mut tally, a, &motion_a, b, &motion_b, 300);
            }
        }
    }
    assert!(tally.hits > 200 && tally.misses > 100, "{tally:?}");
    println!("{tally:?}");
}

/// Far from the origin the result is as exact as the poses are, and the search ends.
#[test]
fn far_from_the_origin() {
    let mut random = Random(31);
    let far = DVec3::new(1e6, -1e6, 1e6);
    let (a, b) = (cuboid(1.0, 0.5, 0.2), cuboid(0.7, 0.7, 0.7));
    let mut hits = 0;
    for _ in 0..100 {
        let motion_a = shooter(&mut random, 2.0, 1.5, 8.0);
        let motion_b = Flight::new(Pose::new(random.rotation(), DVec3::ZERO), DVec3::ZERO, random.vector());
        let moved = |m: &Flight| Flight { start: Pose::new(m.start.rotation, m.start.translation + far), ..*m };
        let settings = ImpactSearch::default();
        let near = find_impact(&a, &motion_a, &b, &motion_b, 0.0, 1.0, &settings).expect("an answer");
        let away = find_impact(&a, &moved(&motion_a), &b, &moved(&motion_b), 0.0, 1.0, &settings).expect("an answer");
        if let (Some(near), Some(away)) = (near.time, away.time) {
            hits += 1;
            assert!((near - away).abs() < 1e-7, "{near} {away}");
        }
    }
    assert!(hits > 30);
}
