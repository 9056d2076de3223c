//! Broad phases on moving boxes, against parry3d's hierarchy driven directly.
//!
//! All boxes move before every call, which must find all pairs. `parry3d driven directly` does what rapier3d's broad
//! phase does when everything moves: it updates the leaves, optimises a part of the tree, refits and traverses it, and
//! lists the pairs in the order of traversal. The methods of this crate also sort their pairs.
//!
//! On a shared machine, times measured minutes apart cannot be compared. So the library and this crate's hierarchy are
//! first timed alternately, frame by frame, and for every frame the least time of each is taken: once with boxes that
//! move by about 1 % of their size between calls, as bodies do between steps, and once so fast that no earlier result
//! is useful.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use parry3d::bounding_volume::Aabb as ParryAabb;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use polhode_contact::{Aabb, BroadPhaseMethod};
use polhode_spatial::{DVec3, SplitMix64};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Frames after which the motion begins again, backwards.
const FRAMES: usize = 64;

/// In the cube [-1, 1]^3.
fn vector(random: &mut SplitMix64) -> DVec3 {
    DVec3::new(random.uniform(), random.uniform(), random.uniform()) * 2.0 - 1.0
}

/// Largest motion along each axis from frame to frame, m.
const SPEED: f64 = 0.02;

/// Boxes of about unit size, one for every 2.5 m^3 of a cube, each with its own velocity.
fn frames(count: usize, speed: f64) -> Vec<Vec<Aabb>> {
    let mut random = SplitMix64::new(5);
    let half_width = 0.5 * libm::cbrt(2.5 * count as f64);
    let movers: Vec<_> = (0..count)
        .map(|_| (vector(&mut random) * half_width, vector(&mut random) * speed, (vector(&mut random) + 2.0) * 0.25))
        .collect();
    let frame = |k: usize| {
        let place = |&(center, velocity, half): &(DVec3, DVec3, DVec3)| {
            let center = center + velocity * k as f64;
            Aabb::new(center - half, center + half)
        };
        movers.iter().filter_map(|mover| place(mover).ok()).collect()
    };
    (0..FRAMES).chain((0..FRAMES).rev()).map(frame).collect()
}

/// parry3d's hierarchy, driven directly.
struct Parry {
    tree: Bvh,
    workspace: BvhWorkspace,
    pairs: Vec<(u32, u32)>,
}

impl Parry {
    fn new(boxes: &[Aabb]) -> Self {
        let leaves: Vec<_> = boxes.iter().map(Self::convert).collect();
        let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &leaves);
        Self { tree, workspace: BvhWorkspace::default(), pairs: Vec::new() }
    }

    fn convert(aabb: &Aabb) -> ParryAabb {
        ParryAabb::new(aabb.min(), aabb.max())
    }

    fn pairs(&mut self, boxes: &[Aabb]) -> usize {
        let Self { tree, workspace, pairs } = self;
        for (leaf, aabb) in boxes.iter().enumerate() {
            tree.insert_or_update_partially(Self::convert(aabb), leaf as u32, 0.0);
        }
        tree.optimize_incremental(workspace);
        tree.refit(workspace);
        pairs.clear();
        tree.traverse_bvtt_single_tree::<false>(workspace, &mut |i, j| pairs.push((i, j)));
        pairs.len()
    }
}

/// Timed rounds of all frames; one more round before them is not timed.
const ROUNDS: usize = 10;

/// Prints the mean time of a call of the library and of this crate's hierarchy, called alternately.
fn alternately(count: usize, speed: f64) {
    let frames = frames(count, speed);
    let (mut parry, mut bvh, mut found) = (Parry::new(&frames[0]), BroadPhaseMethod::Bvh.build(), Vec::new());
    let mut least = vec![[f64::INFINITY; 2]; frames.len()];
    for round in 0..=ROUNDS {
        for (k, (boxes, least)) in frames.iter().zip(&mut least).enumerate() {
            let mut counts = [0; 2];
            // The order alternates, because the second one finds the boxes in the cache.
            for who in [(k + round) % 2, (k + round + 1) % 2] {
                let start = Instant::now();
                counts[who] = match who {
                    0 => parry.pairs(boxes),
                    _ => bvh.pairs(boxes, &mut found).map_or(0, |()| found.len()),
                };
                if round > 0 {
                    least[who] = start.elapsed().as_secs_f64().min(least[who]);
                }
            }
            assert_eq!(counts[0], counts[1], "both must find the same pairs");
        }
    }
    let mean = |who: usize| least.iter().map(|times| times[who]).sum::<f64>() / frames.len() as f64 * 1e6;
    let (theirs, ours) = (mean(0), mean(1));
    println!(
        "{count} boxes, {speed} m a call, alternately: parry3d {theirs:.0} us, bvh {ours:.0} us: {:.2}",
        ours / theirs
    );
}

fn broad_phases(c: &mut Criterion) {
    for count in [1000, 10_000] {
        alternately(count, SPEED);
        alternately(count, 10.0 * SPEED);
        let frames = frames(count, SPEED);
        let mut group = c.benchmark_group(format!("{count} moving boxes"));
        group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
        group.bench_function("parry3d driven directly", |bench| {
            let (mut parry, mut turn) = (Parry::new(&frames[0]), frames.iter().cycle());
            bench.iter(|| black_box(parry.pairs(turn.next().map_or(&[], Vec::as_slice))));
        });
        for method in BroadPhaseMethod::ALL {
            group.bench_function(BenchmarkId::from_parameter(method), |bench| {
                let (mut broad_phase, mut pairs) = (method.build(), Vec::new());
                let mut turn = frames.iter().cycle();
                bench.iter(|| {
                    let found = broad_phase.pairs(turn.next().map_or(&[], Vec::as_slice), &mut pairs);
                    black_box((found.is_ok(), pairs.len()))
                });
            });
        }
        group.finish();
    }
}

criterion_group!(benches, broad_phases);
criterion_main!(benches);
