//! Cost of free rotation: the exact drift, the same from a prepared record, and a step of RK4, over several turns h
//! |w|. `cargo bench -p polhode-dynamics`. The yardstick is RK4 on (q, L) written by hand; the library's step, which
//! serves any system, moves the centre of mass as well. Instruction counts: examples/free_rotation_cost.rs.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::DVec3;
use polhode_dynamics::exact_rotation::drift;
use polhode_dynamics::{BodyState, Dop853, Flight, FreeMotion, FreeRotation, RigidBody, Rk4};
use polhode_spatial::{Inertia, Mass, MassProperties, Motion, Rotation};
use std::hint::black_box;

#[path = "support/rk4_of_one_body.rs"]
mod rk4_of_one_body;

/// Turns in rad: the first four are within the reach of the power series.
const TURNS: [f64; 7] = [0.002, 0.1, 0.3, 1.0, 3.0, 50.0, 1000.0];

fn free_motion(criterion: &mut Criterion) {
    let moments = DVec3::new(1.0, 2.0, 3.0);
    let momentum = DVec3::new(0.4, 1.6, 1.2);
    let Ok(inertia) = Inertia::from_diagonal(moments) else { return };
    let Ok(mass) = Mass::new(1.0) else { return };
    let body = RigidBody::new(&MassProperties::new(mass, DVec3::ZERO, inertia));
    let start = BodyState { angular_momentum: momentum, ..BodyState::default() };
    let mut group = criterion.benchmark_group("free_motion");
    for turn in TURNS {
        let h = turn / (momentum / moments).length();
        group.bench_with_input(BenchmarkId::new("drift", turn), &h, |bencher, &h| {
            bencher.iter(|| drift(moments, Rotation::IDENTITY, black_box(momentum), black_box(h)));
        });
        let record = FreeRotation::new(moments, Rotation::IDENTITY, momentum);
        group.bench_with_input(BenchmarkId::new("record", turn), &h, |bencher, &h| {
            bencher.iter(|| record.at(black_box(h)));
        });
        group.bench_with_input(BenchmarkId::new("record by elliptic functions", turn), &h, |bencher, &h| {
            bencher.iter(|| record.at_by_elliptic_functions(black_box(h)));
        });
    }
    let inverse_moments = moments.recip();
    group.bench_function("step of rk4 by hand", |bencher| {
        let attitude = black_box(glam::DQuat::IDENTITY);
        bencher.iter(|| rk4_of_one_body::step(inverse_moments, attitude, black_box(momentum), black_box(0.1)));
    });
    group.bench_function("prepare a flight", |bencher| {
        bencher.iter(|| Flight::new(&body, 0.0, black_box(&start), DVec3::NEG_Z));
    });
    let bodies = [body];
    let mut system = FreeMotion::new(&bodies, DVec3::NEG_Z, &[]);
    group.bench_function("step of rk4", |bencher| {
        let (mut method, mut state) = (Rk4::new(13), start.to_array());
        bencher.iter(|| method.step(&mut system, 0.0, black_box(1e-3), &mut state));
    });
    group.bench_function("step of dop853", |bencher| {
        let (mut method, state) = (Dop853::new(13), start.to_array());
        bencher.iter(|| method.attempt(&mut system, 0.0, black_box(&state), black_box(1e-3), &[1e-12; 13]));
    });
    let mut method = Dop853::new(13);
    let motion = method
        .attempt(&mut system, 0.0, &start.to_array(), 0.1, &[1e-12; 13])
        .and_then(|_| method.dense(&mut system))
        .map(|dense| dense.body_motion(0, &body));
    if let Ok(Some(motion)) = motion {
        group.bench_function("pose within a step", |bencher| bencher.iter(|| motion.pose(black_box(0.03))));
        group.bench_function("bounds within a step", |bencher| {
            bencher.iter(|| motion.bounds(black_box(0.03), black_box(0.04)));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default();
    targets = free_motion
}
criterion_main!(benches);
