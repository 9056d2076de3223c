//! Broad phases on moving boxes, against parry3d's hierarchy driven directly.
//!
//! Every call gets all boxes, all of which have moved, and must find all pairs. `parry3d driven directly` does what
//! rapier3d's broad phase does when everything moves: it updates the leaves, optimises a part of the tree, fits the
//! tree and walks it, and pushes the pairs as they come. The methods of this crate also sort their pairs.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use parry3d::bounding_volume::Aabb as ParryAabb;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use polhode_contact::{Aabb, BroadPhaseMethod};
use polhode_spatial::DVec3;
use std::hint::black_box;
use std::time::Duration;

/// Frames after which the motion begins again, backwards.
const FRAMES: usize = 64;

struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
}

/// Boxes of about unit size in a cube with a box for every 2.5 cubic metres, each on its own way.
fn frames(count: usize) -> Vec<Vec<Aabb>> {
    let mut random = Random(5);
    let half_width = 0.5 * libm::cbrt(2.5 * count as f64);
    let movers: Vec<_> = (0..count)
        .map(|_| (random.vector() * half_width, random.vector() * 0.02, (random.vector() + 2.0) * 0.25))
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

fn broad_phases(c: &mut Criterion) {
    for count in [1000, 10_000] {
        let frames = frames(count);
        let mut group = c.benchmark_group(format!("{count} moving boxes"));
        group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
        group.bench_function("parry3d driven directly", |bench| {
            let convert = |aabb: &Aabb| ParryAabb::new(aabb.min(), aabb.max());
            let leaves: Vec<_> = frames[0].iter().map(convert).collect();
            let mut tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &leaves);
            let (mut workspace, mut pairs) = (BvhWorkspace::default(), Vec::new());
            let mut turn = frames.iter().cycle();
            bench.iter(|| {
                for (leaf, aabb) in turn.next().into_iter().flatten().enumerate() {
                    tree.insert_or_update_partially(convert(aabb), leaf as u32, 0.0);
                }
                tree.optimize_incremental(&mut workspace);
                tree.refit(&mut workspace);
                pairs.clear();
                tree.traverse_bvtt_single_tree::<false>(&mut workspace, &mut |i, j| pairs.push((i, j)));
                black_box(pairs.len())
            });
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
