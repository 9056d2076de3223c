//! Broad phase against all pairs, and boxes that bound moving shapes.

use crate::support::{Flight, Random, at, cuboid};
use polhode_contact::broad_phase::Bvh;
use polhode_contact::{Aabb, BroadPhase, Shape, swept_aabb};
use polhode_spatial::{DVec3, Motion, Pose, Still, UnitVector};

fn pairs(broad_phase: &mut dyn BroadPhase, boxes: &[Aabb]) -> Vec<(u32, u32)> {
    let mut pairs = vec![(9, 9)];
    broad_phase.pairs(boxes, &mut pairs).expect("few boxes");
    pairs
}

fn all_pairs(boxes: &[Aabb]) -> Vec<(u32, u32)> {
    let mut pairs = Vec::new();
    for i in 0..boxes.len() {
        for j in i + 1..boxes.len() {
            if boxes[i].overlaps(&boxes[j]) {
                pairs.push((i as u32, j as u32));
            }
        }
    }
    pairs
}

/// Random boxes that move from call to call, some unbounded: the pairs are those of the comparison of all with all, and
/// a fresh tree gives the same as one with a history.
#[test]
fn same_as_all_pairs() {
    let mut random = Random(11);
    let mut bvh = Bvh::default();
    for count in [0, 1, 2, 3, 10, 10, 10, 200, 200, 200, 500, 7] {
        let mut boxes: Vec<Aabb> = (0..count)
            .map(|_| {
                let (low, size) = (random.vector() * 5.0, (random.vector() + DVec3::ONE) * 0.4);
                Aabb::new(low, low + size).expect("ordered bounds")
            })
            .collect();
        if count > 5 {
            boxes[3] = Aabb::UNBOUNDED;
            boxes[5] =
                Aabb::new(DVec3::NEG_INFINITY, DVec3::new(f64::INFINITY, f64::INFINITY, 0.0)).expect("a half-space");
            boxes[1] = boxes[0];
        }
        assert_eq!(pairs(&mut bvh, &boxes), all_pairs(&boxes));
        assert_eq!(pairs(&mut Bvh::default(), &boxes), all_pairs(&boxes));
    }
}

/// Touching boxes are pairs; NaN and reversed bounds are refused.
#[test]
fn touching_and_invalid() {
    let unit = Aabb::new(DVec3::ZERO, DVec3::ONE).expect("a box");
    let beside = Aabb::new(DVec3::X, DVec3::new(2.0, 1.0, 1.0)).expect("a box");
    let huge = Aabb::new(DVec3::splat(-1e300), DVec3::splat(1e300)).expect("a box");
    assert_eq!(pairs(&mut Bvh::default(), &[unit, beside, huge]), [(0, 1), (0, 2), (1, 2)]);
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
        Shape::sphere(0.4).expect("radius").translated(DVec3::new(0.5, 0.0, 0.1)).expect("moved"),
        Shape::points(vec![DVec3::ONE, DVec3::X]).expect("points"),
    ];
    for _ in 0..100 {
        let mut flight = Flight::new(
            Pose::new(random.rotation(), random.vector() * 3.0),
            random.vector() * 5.0,
            random.vector() * random.between(0.0, 20.0),
        );
        flight.acceleration = random.vector() * 10.0;
        let (t0, t1) = (random.between(-1.0, 1.0), random.between(1.0, 1.6));
        for shape in &shapes {
            let bounds = swept_aabb(shape, &flight, t0, t1).expect("a box");
            for i in 0..=50 {
                let pose = flight.pose(t0 + (t1 - t0) * f64::from(i) / 50.0);
                let now = swept_aabb(shape, &Still(pose), 0.0, 0.0).expect("a box");
                assert!(now.min().cmpge(bounds.min()).all() && now.max().cmple(bounds.max()).all());
            }
        }
    }
    let still = swept_aabb(&cuboid(1.0, 2.0, 4.0), &Still(Pose::IDENTITY), 0.0, 5.0).expect("a box");
    assert!((still.max() - DVec3::new(0.5, 1.0, 2.0)).length() < 1e-13);
    let floor = Shape::half_space(UnitVector::Z);
    assert_eq!(swept_aabb(&floor, &Still(Pose::IDENTITY), 0.0, 1.0), Ok(Aabb::UNBOUNDED));
}
