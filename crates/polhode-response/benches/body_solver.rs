//! Contacts in the velocities of bodies: pyramids and walls, cold, from the answer, and the order of elimination alone.
//!
//! Run with `cargo bench -p polhode-response --bench body_solver`.

#![allow(missing_docs, reason = "criterion's macros generate public items")]
#![allow(clippy::unwrap_used, reason = "a scene that cannot be built is a mistake here")]

#[path = "../tests/it/body_scenes.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod body_scenes;

use body_scenes::{BodyScene, pyramid, wall};
use criterion::{Criterion, criterion_group, criterion_main};
use polhode_response::sparse::{BodySettings, BodySolver, Elimination};
use std::hint::black_box;

fn scenes() -> Vec<(String, BodyScene)> {
    let mut scenes: Vec<(String, BodyScene)> =
        [5, 10, 20].map(|rows| (format!("pyramid-{}", rows * (rows + 1) / 2), pyramid(rows, 0.5))).into();
    scenes.push(("wall-400".to_owned(), wall(50, 8, 0.5)));
    for (_, scene) in &mut scenes {
        scene.pull(0.1);
    }
    scenes
}

fn body_solver(criterion: &mut Criterion) {
    let settings = BodySettings::default();
    for (name, scene) in scenes() {
        let problem = scene.problem();
        let mut solver = BodySolver::default();
        let first = solver.solve(&problem, None, &settings).unwrap();
        println!("{name}: {:?}", first.report);
        let mut group = criterion.benchmark_group(&name);
        group.bench_function("elimination", |bench| bench.iter(|| Elimination::of(black_box(&problem))));
        group.bench_function("cold", |bench| bench.iter(|| solver.solve(black_box(&problem), None, &settings).is_ok()));
        let start = Some(&first.reactions[..]);
        group.bench_function("the same", |bench| {
            bench.iter(|| solver.solve(black_box(&problem), start, &settings).is_ok());
        });
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20).warm_up_time(std::time::Duration::from_millis(300))
        .measurement_time(std::time::Duration::from_millis(700));
    targets = body_solver
}
criterion_main!(benches);
