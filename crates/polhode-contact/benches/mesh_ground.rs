//! A body on a ground of 100,352 triangles: manifold, separation, one contact, and the time of impact of a long flight.

use criterion::{Criterion, criterion_group, criterion_main};
use polhode_contact::{
    ImpactSearch, Manifold, Shape, Workspace, evaluate, find_impact, manifold, manifold_into, separation_with,
};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, Still, Velocity};
use std::hint::black_box;

/// Cells along a side: two triangles each.
const CELLS: u32 = 224;

fn ground(height: impl Fn(f64, f64) -> f64) -> Shape {
    let at = |i: u32, j: u32| i * (CELLS + 1) + j;
    let place = |k: u32| f64::from(k) - 0.5 * f64::from(CELLS);
    let vertices = (0..=CELLS).flat_map(|i| (0..=CELLS).map(move |j| (place(i), place(j))));
    let vertices = vertices.map(|(x, y)| DVec3::new(x, y, height(x, y))).collect();
    let cells = (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Shape::triangle_mesh(vertices, triangles.collect()).expect("a grid")
}

/// A flight at 300 m/s, low over the ground, with a spin of 20 rad/s.
struct LowFlight;

impl Motion for LowFlight {
    fn pose(&self, t: f64) -> Pose {
        let turn = Rotation::from_rotation_vector(DVec3::Y * (20.0 * t));
        Pose::new(turn, DVec3::new(-80.0 + 300.0 * t, 3.0, 2.0 - 4.905 * t * t))
    }
    fn velocity(&self, t: f64) -> Velocity {
        Velocity::new(DVec3::new(300.0, 0.0, -9.81 * t), DVec3::Y * 20.0)
    }
    fn bounds(&self, _: f64, t1: f64) -> MotionBounds {
        let speed = self.velocity(t1).linear.length();
        MotionBounds { speed, acceleration: 9.81, angular_speed: 20.0, angular_acceleration: 0.0 }
    }
}

fn mesh_ground(criterion: &mut Criterion) {
    let (mut workspace, mut found) = (Workspace::default(), Manifold::default());
    let flat = ground(|_, _| 0.0);
    let hills = ground(|x, y| 0.2 * x.sin() * y.cos());
    let brick = Shape::cuboid(DVec3::new(1.0, 0.8, 0.5)).expect("a box");
    let ball = Shape::sphere(0.5).expect("a ball");
    let still = Pose::IDENTITY;
    let turned = Rotation::from_rotation_vector(DVec3::Z * 0.3);
    for (name, body, ground, height) in [
        ("box on flat", &brick, &flat, 0.25),
        ("ball on flat", &ball, &flat, 0.5),
        ("box on hills", &brick, &hills, 0.25),
        ("ball on hills", &ball, &hills, 0.5),
    ] {
        let pose = Pose::new(turned, DVec3::new(10.3, -7.2, height));
        criterion.bench_function(&format!("mesh manifold/{name}"), |bencher| {
            bencher.iter(|| manifold_into(&mut workspace, body, black_box(&pose), ground, &still, 0.01, &mut found));
        });
        criterion.bench_function(&format!("mesh separation/{name}"), |bencher| {
            bencher.iter(|| separation_with(&mut workspace, body, black_box(&pose), ground, &still));
        });
    }
    let pose = Pose::new(turned, DVec3::new(10.3, -7.2, 0.25));
    if let Some(contact) = manifold(&brick, &pose, &flat, &still, 0.01).contacts.first() {
        criterion.bench_function("mesh evaluate/box on flat", |bencher| {
            bencher.iter(|| evaluate(contact.feature, &brick, black_box(&pose), &flat, &still));
        });
    }
    let settings = ImpactSearch::default();
    let rest = Still(Pose::IDENTITY);
    criterion.bench_function("mesh impact/fast low flight over hills", |bencher| {
        bencher.iter(|| find_impact(&brick, &LowFlight, &hills, &rest, 0.0, black_box(1.0), &settings));
    });
}

criterion_group!(benches, mesh_ground);
criterion_main!(benches);
