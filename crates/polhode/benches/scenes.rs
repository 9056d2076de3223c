//! Whole runs of small scenes, for the cost of changes to hot paths of the facade: `cargo bench -p polhode --bench
//! scenes`.
//!
//! | name | hot path |
//! |---|---|
//! | `4-diamond at rest, all effects, 1 s` | contact detection and contact forces of a resting group at every step |
//! | `5-diamond falls, first 0.1 s` | constrained integration with many contacts, contact changes, impacts |
//! | `bouncing ball until rest` | impact search, impacts, flights |
//! | `box off a table` | sliding, tipping about an edge, falling off |
//! | `chain of 30 hinges swings, 0.1 s` | rows of joints at every stage |
//! | `wall pushes a rough box, 0.1 s` | forces within the cones of contacts that stick while others slide |

use criterion::{Criterion, criterion_group, criterion_main};
use polhode::contact::Shape;
use polhode::scene::{Joint, Material, PrescribedMotion};
use polhode::spatial::{DVec3, Density, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, Geometry, Scene, SceneBuilder, Simulation, mesh};
use std::hint::black_box;

fn floor() -> Body {
    Body::fixed("floor").geometry(Geometry::Shape(Shape::half_space(UnitVector::Z)))
}

/// A box of uniform density and mass 1 kg.
fn brick(name: &str, size: DVec3, center: DVec3) -> Option<Body> {
    let density = Density::new(1.0 / (size.x * size.y * size.z)).ok()?;
    let properties = mesh::primitives::solid_box(size, density).ok()?;
    let shape = Geometry::Shape(Shape::cuboid(size).ok()?);
    Some(Body::movable(name, properties).geometry(shape).pose(Pose::from_translation(center)))
}

/// The m-diamond of the thesis (Videos 12-15): rows of 1, 2, .. m, .. 2, 1 bricks on a floor.
fn diamond(m: usize) -> Option<SceneBuilder> {
    let size = DVec3::new(1.0, 0.5, 0.25);
    let mut builder = Scene::builder("diamond").body(floor());
    for row in 1..2 * m {
        let count = if row <= m { row } else { 2 * m - row };
        for column in 0..count {
            let x = column as f64 - 0.5 * (count as f64 - 1.0);
            let center = DVec3::new(x, 0.0, 0.25 * (row as f64 - 0.5));
            builder = builder.body(brick(&format!("r{row}c{column}"), size, center)?);
        }
    }
    Some(builder)
}

/// A ball dropped from 1 m with restitution 0.8: infinitely many bounces in 4.06 s.
fn bouncing_ball() -> Option<Scene> {
    let rubber = Material::new("rubber").with_restitution(0.8).ok()?;
    let inertia = Inertia::from_diagonal(DVec3::splat(0.1)).ok()?;
    let ball = Body::movable("ball", MassProperties::new(Mass::new(1.0).ok()?, DVec3::ZERO, inertia))
        .geometry(Geometry::Shape(Shape::sphere(0.5).ok()?))
        .pose(Pose::from_translation(DVec3::new(0.0, 0.0, 1.5)))
        .material(rubber);
    Scene::builder("bouncing-ball").duration_s(5.0).body(floor()).body(ball).build().ok()
}

/// A box slides over the edge of a table (thesis 3.5, Video 10).
fn box_off_table() -> Option<Scene> {
    let table = Body::fixed("table")
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 2.0, 1.0)).ok()?))
        .pose(Pose::from_translation(DVec3::new(-2.0, 0.0, -0.5)));
    let slider = brick("box", DVec3::new(1.0, 0.5, 0.5), DVec3::new(-0.5, 0.0, 0.25))?
        .velocity(Velocity::new(DVec3::X, DVec3::ZERO));
    Scene::builder("box-off-table").duration_s(1.2).body(table).body(slider).build().ok()
}

/// A chain of rods on hinges, let go at 1 rad from the vertical.
fn swinging_chain() -> Option<Scene> {
    let (length, down) = (0.1, DVec3::new(0.841_470_984_807_896_5, 0.0, -0.540_302_305_868_139_8));
    let mut builder = Scene::builder("chain").duration_s(0.1);
    for link in 0..30_usize {
        let top = down * (length * link as f64);
        let rod = brick(&format!("link {link}"), DVec3::new(0.02, 0.02, length), top + down * (0.5 * length))?;
        let joint = Joint::hinge(BodyId::new(link), top, UnitVector::Y);
        builder = builder.body(rod).joint(if link > 0 { joint.with(BodyId::new(link - 1)) } else { joint });
    }
    builder.build().ok()
}

/// A box on a rough floor that a rough wall pushes at constant speed.
fn pushed_box() -> Option<Scene> {
    let rough = Material::new("rough").with_friction(0.5).ok()?;
    let motion = PrescribedMotion::constant_velocity(Velocity::new(DVec3::X * 0.5, DVec3::ZERO)).ok()?;
    let wall = Body::kinematic("wall", motion)
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::splat(0.1)).ok()?))
        .pose(Pose::from_translation(DVec3::new(-0.1, 0.0, 0.051)));
    let pushed = brick("box", DVec3::splat(0.1), DVec3::Z * 0.05)?;
    let bodies = [wall, pushed, floor()].map(|body| body.material(rough.clone()));
    bodies.into_iter().fold(Scene::builder("pushed box").duration_s(0.1), SceneBuilder::body).build().ok()
}

/// Prepares and runs a scene. Returns whether the run reached its end.
fn run(scene: &Scene, effects: Effects) -> bool {
    Simulation::with_effects(scene, effects).and_then(|mut simulation| simulation.run()).is_ok()
}

fn scenes(criterion: &mut Criterion) {
    let standing = diamond(4).and_then(|scene| scene.duration_s(1.0).build().ok());
    let falling = diamond(5).and_then(|scene| scene.duration_s(0.1).build().ok());
    let all = [
        ("4-diamond at rest, all effects, 1 s", standing, Effects::All),
        ("5-diamond falls, first 0.1 s", falling, Effects::Planned),
        ("bouncing ball until rest", bouncing_ball(), Effects::Planned),
        ("box off a table", box_off_table(), Effects::Planned),
        ("chain of 30 hinges swings, 0.1 s", swinging_chain(), Effects::Planned),
        ("wall pushes a rough box, 0.1 s", pushed_box(), Effects::Planned),
    ];
    let mut group = criterion.benchmark_group("scenes");
    for (name, scene, effects) in all {
        let Some(scene) = scene.filter(|scene| run(scene, effects)) else {
            println!("{name}: the scene does not run");
            continue;
        };
        group.bench_function(name, |bencher| bencher.iter(|| run(black_box(&scene), effects)));
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = scenes
}
criterion_main!(benches);
