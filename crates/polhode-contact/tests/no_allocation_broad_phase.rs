//! After one round of a motion, no broad phase allocates in the next ones, also when the number of boxes changes.
//!
//! It is a separate binary, because the counting allocator of `allocation-counter` replaces that of the whole program.

use polhode_contact::{Aabb, BroadPhaseMethod};
use polhode_spatial::DVec3;

/// Frames after which the motion begins again.
const PERIOD: usize = 40;

/// Boxes on circles, among them a wide and an infinite one; their number goes from 300 to 339 and back.
fn frames() -> Vec<Vec<Aabb>> {
    let aabb = |low: DVec3, size: DVec3| Aabb::new(low, low + size).expect("ordered bounds");
    let frame = |k: usize| {
        let phase = k as f64 / PERIOD as f64 * std::f64::consts::TAU;
        let place = |n: usize| {
            let cell = DVec3::new((n % 7) as f64, (n / 7 % 7) as f64, (n / 49) as f64);
            let own = phase + n as f64;
            aabb(cell + DVec3::new(libm::cos(own), libm::sin(own), 0.0) * 0.3, DVec3::splat(0.9))
        };
        let mut boxes = vec![Aabb::UNBOUNDED, aabb(DVec3::splat(-50.0), DVec3::new(100.0, 100.0, 50.1))];
        boxes.extend((0..298 + 2 * k.min(PERIOD - k)).map(place));
        boxes
    };
    (0..PERIOD).map(frame).collect()
}

#[test]
fn moving_boxes_of_changing_number_allocate_nothing() {
    let counts_at_all = allocation_counter::measure(|| drop(std::hint::black_box(vec![1.0; 10])));
    assert_eq!(counts_at_all.count_total, 1);
    let frames = frames();
    for method in BroadPhaseMethod::ALL {
        let (mut broad_phase, mut pairs) = (method.build(), Vec::new());
        let mut counts = Vec::new();
        let mut round = || {
            for boxes in &frames {
                broad_phase.pairs(boxes, &mut pairs).expect("few boxes");
                counts.push(pairs.len());
            }
        };
        // The hierarchy's structure, and with it the length of its queues, needs some rounds until it repeats.
        (0..4).for_each(|_| round());
        let info = allocation_counter::measure(&mut round);
        // The list of counts is the test's own.
        assert!(info.count_total <= 1, "{method}: {} allocations", info.count_total);
        assert!(counts.iter().min() < counts.iter().max());
    }
}
