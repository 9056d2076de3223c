//! Times of impact of round shapes: closed forms, and random spinning shots that are never late and never missed.

use crate::impact_random::{Tally, shoot, shoot_within, shooter};
use crate::support::{Flight, Random, at, ball, capsule, cone, cuboid, cylinder, floor, prism, turned};
use polhode_contact::{ImpactSearch, Shape, find_impact};
use polhode_spatial::{DVec3, Pose, Rotation, Still};
use std::f64::consts::FRAC_PI_2;

fn slab() -> Shape {
    cuboid(20.0, 20.0, 2.0).translated(DVec3::NEG_Z).expect("a slab")
}

/// Time of a free fall from rest through a height.
fn fall_time(height: f64) -> f64 {
    (2.0 * height / 9.81_f64).sqrt()
}

/// Falls of every shape in known attitudes on a floor and on a slab.
#[test]
fn falls() {
    let tilt = 0.4;
    let lowest_of_tilted = 0.5 * libm::cos(tilt) + 0.3 * libm::sin(tilt);
    let falls: [(Shape, Rotation, f64); 9] = [
        (capsule(0.3, 1.0), Rotation::IDENTITY, 0.8),
        (capsule(0.3, 1.0), turned(DVec3::X, FRAC_PI_2, DVec3::ZERO).rotation, 0.3),
        (capsule(0.3, 1.0), turned(DVec3::X, tilt, DVec3::ZERO).rotation, 0.5 * libm::cos(tilt) + 0.3),
        (cylinder(0.3, 1.0), Rotation::IDENTITY, 0.5),
        (cylinder(0.3, 1.0), turned(DVec3::Y, FRAC_PI_2, DVec3::ZERO).rotation, 0.3),
        (cylinder(0.3, 1.0), turned(DVec3::Y, tilt, DVec3::ZERO).rotation, lowest_of_tilted),
        (cone(0.3, 1.0), Rotation::IDENTITY, 0.25),
        (cone(0.3, 1.0), turned(DVec3::X, 2.0 * FRAC_PI_2, DVec3::ZERO).rotation, 0.75),
        (cone(0.3, 1.0), turned(DVec3::X, tilt, DVec3::ZERO).rotation, 0.25 * libm::cos(tilt) + 0.3 * libm::sin(tilt)),
    ];
    for height in [1e-3, 1.0, 50.0] {
        for (shape, rotation, lowest) in &falls {
            for ground in [floor(), slab()] {
                for spin in [0.0, 5.0] {
                    let start = Pose::new(*rotation, DVec3::Z * (lowest + height));
                    let mut flight = Flight::new(start, DVec3::X * 0.3, DVec3::Z * spin);
                    flight.acceleration = DVec3::Z * -9.81;
                    let settings = ImpactSearch::default();
                    let still = Still(Pose::IDENTITY);
                    let report = find_impact(shape, &flight, &ground, &still, 0.0, 20.0, &settings).expect("an answer");
                    let expected = fall_time(height);
                    let found = report.time.expect("an impact");
                    // The search ends when the separation is within rounding, 4 epsilons of the lengths it is computed
                    // from.
                    let slack = 4.0 * f64::EPSILON * (45.0 + height) / (9.81 * expected);
                    let relative = if spin == 0.0 { 2e-14 } else { 1e-13 };
                    assert!(
                        (found - expected).abs() <= slack + relative * expected,
                        "{found} {expected} {shape:?} {spin}"
                    );
                    assert!(report.evaluations <= 16, "{} {shape:?} {spin}", report.evaluations);
                }
            }
        }
    }
}

/// A cylinder that rotates about a horizontal axis above a floor touches it with its rim at a known angle.
#[test]
fn rim_swings_onto_a_floor() {
    let (radius, half, spin) = (0.3, 0.5, 3.0);
    let diagonal = libm::hypot(radius, half);
    for height in [0.51, 0.55, 0.58] {
        let swing = Flight::new(at(0.0, 0.0, height), DVec3::ZERO, DVec3::X * spin);
        // half cos + radius sin = diagonal cos(angle - offset).
        let expected = (libm::atan2(radius, half) - libm::acos(height / diagonal)) / spin;
        for ground in [floor(), slab()] {
            let still = Still(Pose::IDENTITY);
            let report =
                find_impact(&cylinder(radius, 1.0), &swing, &ground, &still, 0.0, 1.0, &ImpactSearch::default());
            let found = report.expect("an answer").time.expect("an impact");
            assert!((found - expected).abs() < 1e-12 * expected, "{found} {expected}");
        }
    }
}

/// Head-on shots of every pair along x: distance over speed.
#[test]
fn head_on() {
    let upright = Rotation::IDENTITY;
    let along = turned(DVec3::Y, FRAC_PI_2, DVec3::ZERO).rotation;
    let point = Shape::points(vec![DVec3::ZERO]).expect("a point");
    let ball = ball(0.5);
    // Shape, attitude, and extent towards the other body: +x of the shooters, -x of the targets.
    let shooters = [
        (capsule(0.2, 1.0), upright, 0.2),
        (capsule(0.2, 1.0), along, 0.7),
        (cylinder(0.2, 1.0), upright, 0.2),
        (cylinder(0.2, 1.0), along, 0.5),
        (cone(0.2, 1.0), along, 0.75),
        (cuboid(1.0, 0.5, 0.5), upright, 0.5),
        (ball, upright, 0.5),
        (point, upright, 0.0),
    ];
    let targets = [
        (capsule(0.3, 1.0), upright, 0.3),
        (cylinder(0.3, 1.0), upright, 0.3),
        (cylinder(0.3, 1.0), along, 0.5),
        (cone(0.3, 1.0), along, 0.25),
    ];
    for (a, turn_a, extent_a) in &shooters {
        for (b, turn_b, extent_b) in &targets {
            for speed in [1e-2, 1.0, 300.0] {
                let flight = Flight::new(Pose::new(*turn_a, DVec3::X * -3.0), DVec3::X * speed, DVec3::ZERO);
                let still = Still(Pose::new(*turn_b, DVec3::ZERO));
                let settings = ImpactSearch::default();
                let time = find_impact(a, &flight, b, &still, 0.0, 1e3, &settings).expect("an answer").time;
                let expected = (3.0 - extent_a - extent_b) / speed;
                let found = time.expect("an impact");
                assert!((found - expected).abs() <= 1e-14 * expected, "{found} {expected} {a:?} {b:?}");
                let swapped = find_impact(b, &still, a, &flight, 0.0, 1e3, &settings).expect("an answer").time;
                assert!((swapped.expect("an impact") - expected).abs() <= 1e-14 * expected);
            }
        }
    }
}

/// Spinning shots of every pair, each against dense samples of the separation.
#[test]
fn spinning_shots() {
    let mut random = Random(515);
    let mut tally = Tally::default();
    let round = [capsule(0.1, 0.4), cylinder(0.2, 0.5), cylinder(0.3, 0.01), cone(0.2, 0.5)];
    let others = [
        cuboid(0.5, 0.3, 0.2),
        prism(6, 0.3, 0.2),
        ball(0.2),
        Shape::points((0..4).map(|_| random.vector() * 0.3).collect()).expect("points"),
        floor(),
        cuboid(2.0, 2.0, 1e-3),
    ];
    for a in &round {
        for b in round.iter().chain(&others) {
            for _ in 0..20 {
                let motion_a = shooter(&mut random, 1.5, 1.5, 12.0);
                let motion_b =
                    Flight::new(Pose::new(random.rotation(), DVec3::ZERO), random.vector(), random.vector() * 4.0);
                shoot(&mut tally, a, &motion_a, b, &motion_b, 150);
                shoot(&mut tally, b, &motion_b, a, &motion_a, 50);
            }
        }
    }
    assert!(tally.hits > 300 && tally.misses > 300, "{tally:?}");
    println!("{tally:?}");
}

/// Bullets of up to 1000 m/s and 1e4 rad/s against spinning discs a millimetre thin.
#[test]
fn through_thin_discs() {
    let mut random = Random(616);
    let mut tally = Tally::default();
    let disc = cylinder(1.0, 1e-3);
    for bullet in [cylinder(0.02, 0.05), cone(0.02, 0.05), capsule(0.01, 0.05), cuboid(0.05, 0.02, 0.03)] {
        for _ in 0..60 {
            let motion = shooter(&mut random, 3.0, 300.0, 1e4);
            let turning = Flight::new(Pose::new(random.rotation(), DVec3::ZERO), DVec3::ZERO, random.vector() * 100.0);
            shoot_within(&mut tally, &bullet, &motion, &disc, &turning, 0.02, 200);
        }
    }
    assert!(tally.hits > 60, "{tally:?}");
    println!("{tally:?}");
}
