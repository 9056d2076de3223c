//! Contact forces: own active set, cold and warm, on towers in space (4 contacts a box), the 4-diamond with 136 rows,
//! and piles; beside it the choice of least forces and the interior point in lifted form.
//!
//! Run with `cargo bench -p polhode-response`.

#![allow(missing_docs, reason = "criterion's macros generate public items")]

#[path = "../tests/it/scenes.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod scenes;

#[path = "../tests/it/oracle.rs"]
mod oracle;

use criterion::{Criterion, criterion_group, criterion_main};
use polhode_response::{ComplementaritySolver, SolverSettings, minimum_norm, solve_complementarity};
use scenes::{Noise, Scene, diamond_in_space, pile, tower};
use std::hint::black_box;

fn scenes_to_solve() -> Vec<(String, Scene)> {
    let mut noise = Noise::new(42);
    let mut list = Vec::new();
    for boxes in [1, 3, 13] {
        let scene = tower(&vec![1.0; boxes], 0.1, &mut noise);
        list.push((format!("tower-{}", scene.problem.len()), scene));
    }
    let scene = pile(17, 3, 10.0, &mut noise);
    list.push((format!("pile-{}", scene.problem.len()), scene));
    let scene = diamond_in_space();
    list.push((format!("diamond-{}", scene.problem.len()), scene));
    list
}

fn contact_forces(criterion: &mut Criterion) {
    let settings = SolverSettings::default();
    for (name, scene) in scenes_to_solve() {
        let delassus = scene.problem.delassus();
        let mut solver = ComplementaritySolver::new(settings);
        let Ok(first) = solve_complementarity(&scene.problem, &delassus, &scene.b, None, &settings) else { continue };
        println!("{name}: {:?}", first.report);
        let mut group = criterion.benchmark_group(&name);
        group.bench_function("delassus", |bench| bench.iter(|| black_box(scene.problem.delassus())));
        group.bench_function("cold", |bench| {
            bench.iter(|| solver.solve(&scene.problem, &delassus, black_box(&scene.b), None).is_ok());
        });
        group.bench_function("warm", |bench| {
            bench
                .iter(|| solver.solve(&scene.problem, &delassus, black_box(&scene.b), Some(&first.warm_start)).is_ok());
        });
        group.bench_function("least norm", |bench| {
            bench.iter(|| minimum_norm(&scene.problem, black_box(&first), &settings).is_ok());
        });
        group.bench_function("clarabel lifted", |bench| bench.iter(|| oracle::lifted(black_box(&scene))));
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20).warm_up_time(std::time::Duration::from_millis(300))
        .measurement_time(std::time::Duration::from_millis(700));
    targets = contact_forces
}
criterion_main!(benches);
