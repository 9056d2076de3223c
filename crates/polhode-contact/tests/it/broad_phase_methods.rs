//! Every broad phase finds the same pairs in the same order, whatever its earlier calls.
//!
//! The reference is a comparison of all pairs, written independently here. Boxes are random, clustered, in layers and
//! rows, of sizes from 1e-6 to 1e4 m, up to 1e60 m away, coincident, flat, infinite, and move and change in number from
//! call to call; each method is tested with its history and newly built.

use crate::support::Random;
use polhode_contact::{Aabb, BroadPhase, BroadPhaseMethod};
use polhode_spatial::DVec3;

fn all_pairs(boxes: &[Aabb]) -> Vec<(u32, u32)> {
    let overlap = |i: usize, j: usize| {
        let (a, b) = (&boxes[i], &boxes[j]);
        (0..3).all(|k| a.min()[k] <= b.max()[k] && b.min()[k] <= a.max()[k])
    };
    let indices = |i: usize| (i + 1..boxes.len()).filter(move |&j| overlap(i, j)).map(move |j| (i as u32, j as u32));
    (0..boxes.len()).flat_map(indices).collect()
}

/// A method with its history, and its result.
struct Asked {
    method: BroadPhaseMethod,
    broad_phase: Box<dyn BroadPhase>,
    pairs: Vec<(u32, u32)>,
}

/// All methods.
struct Methods(Vec<Asked>);

impl Methods {
    fn new() -> Self {
        // The first call must replace what the list of pairs holds.
        let asked = |method: BroadPhaseMethod| Asked { method, broad_phase: method.build(), pairs: vec![(7, 3)] };
        Self(BroadPhaseMethod::ALL.into_iter().map(asked).collect())
    }

    fn check(&mut self, what: &str, boxes: &[Aabb]) {
        let expected = all_pairs(boxes);
        for Asked { method, broad_phase, pairs } in &mut self.0 {
            broad_phase.pairs(boxes, pairs).expect("few boxes");
            assert!(*pairs == expected, "{method}, {what}: {} pairs, not {}", pairs.len(), expected.len());
            let mut afresh = Vec::new();
            method.build().pairs(boxes, &mut afresh).expect("few boxes");
            assert!(afresh == expected, "{method} afresh, {what}: {} pairs, not {}", afresh.len(), expected.len());
        }
    }
}

fn aabb(low: DVec3, size: DVec3) -> Aabb {
    Aabb::new(low, low + size).expect("ordered bounds")
}

/// A random box of a kind that is difficult for some method.
fn any_box(random: &mut Random, kind: u32) -> Aabb {
    let decade = |random: &mut Random, low: f64, high: f64| libm::exp10(random.between(low, high));
    let cube = (random.vector() + DVec3::splat(1.5)) * 0.2;
    match kind {
        // A cloud.
        0 => aabb(random.vector() * 4.0, cube),
        // Clusters far apart.
        1 => aabb((random.vector() * 3.0).round() * 1e6 + random.vector(), cube),
        // Sizes from 1e-6 to 1e4 m.
        2 => aabb(random.vector() * decade(random, -3.0, 3.0), cube * decade(random, -6.0, 4.0)),
        // A lattice of cubes that touch, with negative zeros.
        3 => aabb((random.vector() * 3.0).round() * -1.0, DVec3::ONE),
        // An oblique row and a layer.
        4 => aabb(DVec3::new(1.0, 2.0, -1.0) * random.between(-5.0, 5.0), cube),
        5 => aabb(random.vector() * DVec3::new(9.0, 9.0, 0.01), cube),
        // Flat boxes, needles and points.
        6 => aabb((random.vector() * 2.0).round(), (random.vector() * 1.4).round().abs()),
        // Up to 1e60 m away, and beyond.
        7 => aabb(random.vector() * decade(random, 0.0, 62.0), DVec3::splat(decade(random, -6.0, 62.0))),
        // Infinite in some directions.
        _ => {
            let wall = random.between(-1.0, 1.0);
            let low = random.vector().map(|x| if x > 0.0 { f64::NEG_INFINITY } else { wall - 1.0 });
            let high = random.vector().map(|x| if x > 0.0 { f64::INFINITY } else { wall });
            Aabb::new(low, high).expect("ordered bounds")
        }
    }
}

/// Boxes of one kind and of all kinds together, over calls with changing numbers.
#[test]
fn every_method_finds_the_same_pairs() {
    let mut random = Random(20_260_101);
    let mut methods = Methods::new();
    for round in 0..24 {
        for kind in 0..10 {
            let count = [0, 1, 2, 3, 40, 200, 330, 33, 120, 32, 500, 64][(round * 7 + kind) as usize % 12];
            let boxes: Vec<_> = (0..count)
                .map(|k| {
                    let mixed = if k % 50 == 7 { 8 } else { (9.0 * random.unit()) as u32 };
                    any_box(&mut random, if kind == 9 { mixed } else { kind })
                })
                .collect();
            methods.check(&format!("kind {kind}, {count} boxes"), &boxes);
        }
    }
}

/// Boxes that move a little, then jump, while some are removed and some added.
#[test]
fn moving_boxes() {
    let mut random = Random(77);
    let mut methods = Methods::new();
    let mut boxes: Vec<_> = (0..300).map(|_| any_box(&mut random, 0)).collect();
    for step in 0..60 {
        for aabb in &mut boxes {
            let by = random.vector() * if step % 20 == 19 { 10.0 } else { 0.02 };
            *aabb = Aabb::new(aabb.min() + by, aabb.max() + by).expect("ordered bounds");
        }
        match step % 7 {
            3 => boxes.extend((0..20).map(|k| any_box(&mut random, k % 3))),
            5 => boxes.truncate(boxes.len() - 25),
            6 => boxes.swap(0, 17),
            _ => {}
        }
        methods.check(&format!("step {step}"), &boxes);
    }
}

/// Boxes that move slowly, so that earlier candidates are valid for many calls, until they have moved far, one jumps,
/// or their number changes; half of the rounds have infinite boxes, all have some flat ones.
#[test]
fn creeping_boxes() {
    let mut random = Random(78);
    for round in 0..4 {
        let mut methods = Methods::new();
        let mut boxes: Vec<_> = (0..200).map(|k| any_box(&mut random, if k % 40 == 7 { 6 } else { 0 })).collect();
        if round % 2 == 1 {
            boxes.extend((0..3).map(|_| any_box(&mut random, 8)));
        }
        let drift: Vec<_> = boxes.iter().map(|_| random.vector() * [1e-4, 3e-3][round / 2]).collect();
        for step in 0..60 {
            for (aabb, &by) in boxes.iter_mut().zip(&drift) {
                *aabb = Aabb::new(aabb.min() + by, aabb.max() + by).expect("ordered bounds");
            }
            match step {
                20 => boxes[11] = boxes[150],
                30 => boxes.truncate(180),
                40 => boxes.swap(3, 90),
                _ => {}
            }
            methods.check(&format!("round {round}, step {step}"), &boxes);
        }
    }
}

/// Thousands of boxes at one place, of one size or of many, and thousands in which nothing overlaps.
#[test]
fn degenerate_crowds() {
    let mut methods = Methods::new();
    let same = |size: f64| aabb(DVec3::splat(-0.5 * size), DVec3::splat(size));
    let nested: Vec<_> = (0..1500).map(|k| same(1.0 + f64::from(k))).collect();
    methods.check("nested", &nested);
    methods.check("coincident", &vec![same(1.0); 1500]);
    methods.check("coincident points", &vec![same(0.0); 1500]);
    let apart: Vec<_> = (0..3000).map(|k| aabb(DVec3::splat(f64::from(k)), DVec3::splat(0.5))).collect();
    methods.check("apart", &apart);
    let decades: Vec<_> = (0..200).map(|k| same(libm::exp10(f64::from(k - 100) / 2.0))).collect();
    methods.check("decades", &decades);
    let geometric: Vec<_> = (0..1000)
        .map(|k| {
            let x = libm::exp2(f64::from(k - 500) / 3.0);
            aabb(DVec3::splat(x), DVec3::splat(0.1 * x))
        })
        .collect();
    methods.check("geometric", &geometric);
}

/// Boxes that touch are pairs, also with boxes whose sizes would overflow when multiplied.
#[test]
fn touching_boxes() {
    let huge = Aabb::new(DVec3::splat(-1e300), DVec3::splat(1e300)).expect("a box");
    let boxes = [aabb(DVec3::ZERO, DVec3::ONE), aabb(DVec3::X, DVec3::ONE), huge];
    assert_eq!(all_pairs(&boxes), [(0, 1), (0, 2), (1, 2)]);
    Methods::new().check("touching", &boxes);
}

/// Names are parsed to their methods; another name gives an error with the list.
#[test]
fn names() {
    for method in BroadPhaseMethod::ALL {
        assert_eq!(method.to_string().parse(), Ok(method));
    }
    let refused = "grid".parse::<BroadPhaseMethod>().expect_err("no such name").to_string();
    let list = "bvh, voxel-grid, octree, kd-tree, binary-space-partition, sweep-and-prune, none";
    assert!(refused.contains("`grid`") && refused.ends_with(list), "{refused}");
}
