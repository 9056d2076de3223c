//! A simulation that a program advances and reads, and islands with crowded events:
//! `cargo bench -p polhode --bench stepping`.
//!
//! | name | hot path |
//! |---|---|
//! | `step in a loop: 30 boxes slide` | thirty islands that advance by their own steps, the agenda that orders them |
//! | `body of each: 30 boxes slide` | the states of bodies within the steps of their islands |
//! | `snapshot`, `restore`: 30 boxes slide | bodies in motion as plain data, and back |
//! | `crowded bounces` | the time steps of a stretch in which events crowd: balls that bounce in a corner |
//! | `stepped: 5 x 5 stacks, a step` | one step of tier `stepped`, contact search and impulses included |
//! | `stepped: rough pyramid, a step` | the same of 55 cubes with friction that stand, in the velocities of bodies |
//! | `fast: rough pyramid, 16 steps` | the same pyramid in tier `fast`, from its start, before it rests |
//! | `fast: chain of 200, 16 steps` | rods on ball joints that fall from the horizontal: two colours of joints |
//! | `fast: net of 196, 16 steps` | bodies on ball joints in a square net, 378 joints that close loops: more colours |

use criterion::{Criterion, criterion_group, criterion_main};
use polhode::contact::Shape;
use polhode::scene::{Joint, Material, Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, Geometry, Scene, SceneBuilder, Simulation};
use std::error::Error;
use std::hint::black_box;

type Made<T> = Result<T, Box<dyn Error>>;

/// Boxes that slide side by side.
const BOXES: usize = 30;
/// Stacks along each side, boxes in each, and the step of tier `stepped`, s.
const STACKS: usize = 5;
const STACKED: usize = 5;
const STEP_S: f64 = 1e-3;
/// Rows of the rough pyramid, and its step, s.
const ROUGH_ROWS: usize = 10;
const ROUGH_STEP_S: f64 = 1.0 / 60.0;
/// Steps of scenes in tier `fast`.
const FAST_STEPS: f64 = 16.0;
/// Rods of the chain, and bodies along each side of the net.
const RODS: usize = 200;
const NET: usize = 14;

fn floor() -> Body {
    Body::fixed("floor").geometry(Geometry::Shape(Shape::half_space(UnitVector::Z)))
}

/// A cube of 1 kg with edges of 1 m.
fn cube(name: String, place: DVec3) -> Made<Body> {
    let inertia = Inertia::from_diagonal(DVec3::splat(1.0 / 6.0))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia);
    let shape = Geometry::Shape(Shape::cuboid(DVec3::ONE)?);
    Ok(Body::movable(name, properties).geometry(shape).pose(Pose::from_translation(place)))
}

fn ball(name: String, place: DVec3, material: Material) -> Made<Body> {
    let inertia = Inertia::from_diagonal(DVec3::splat(0.1))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia);
    let shape = Geometry::Shape(Shape::sphere(0.5)?);
    Ok(Body::movable(name, properties).geometry(shape).pose(Pose::from_translation(place)).material(material))
}

/// Boxes that slide at different speeds, so that each is an island.
fn sliding() -> Made<Scene> {
    let mut builder = Scene::builder("sliding").duration_s(1.0).body(floor());
    for k in 0..BOXES {
        let speed = Velocity::new(DVec3::X * (1.0 + 0.01 * k as f64), DVec3::ZERO);
        builder = builder.body(cube(format!("box {k}"), DVec3::new(0.0, 1.5 * k as f64, 0.5))?.velocity(speed));
    }
    Ok(builder.build()?)
}

/// Stacks that stand apart from each other.
fn stacks() -> Made<SceneBuilder> {
    let mut builder = Scene::builder("stacks").duration_s(1.0).body(floor());
    for k in 0..STACKS * STACKS * STACKED {
        let (row, column, level) = (k % STACKS, k / STACKS % STACKS, k / STACKS / STACKS);
        let place = DVec3::new(2.0 * row as f64, 2.0 * column as f64, 0.5 + level as f64);
        builder = builder.body(cube(format!("box {k}"), place)?);
    }
    Ok(builder)
}

/// Cubes with friction, ten in the lowest row, one fewer in each above.
fn rough_pyramid() -> Made<SceneBuilder> {
    let rough = Material::new("rough").with_friction(0.5)?;
    let mut builder = Scene::builder("rough pyramid").duration_s(1e3).body(floor().material(rough.clone()));
    for (row, column) in (0..ROUGH_ROWS).flat_map(|row| (0..ROUGH_ROWS - row).map(move |column| (row, column))) {
        let place = DVec3::new(1.1 * (column as f64 + 0.5 * row as f64), 0.0, row as f64 + 0.5);
        builder = builder.body(cube(format!("{row} {column}"), place)?.material(rough.clone()));
    }
    Ok(builder)
}

/// A body of 1 kg without a shape.
fn knot(name: String, inertia: DVec3, place: DVec3) -> Made<Body> {
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(inertia)?);
    Ok(Body::movable(name, properties).pose(Pose::from_translation(place)))
}

/// Rods of 1 m in line, held at one end.
fn chain() -> Made<SceneBuilder> {
    let mut builder = Scene::builder("chain");
    for rod in 0..RODS {
        let place = DVec3::X * rod as f64;
        builder = builder.body(knot(format!("{rod}"), DVec3::new(0.01, 0.0833, 0.0833), place + DVec3::X * 0.5)?);
        let joint = Joint::ball(BodyId::new(rod), place);
        builder = builder.joint(if rod == 0 { joint } else { joint.with(BodyId::new(rod - 1)) });
    }
    Ok(builder)
}

/// A square net, held along one side.
fn net() -> Made<SceneBuilder> {
    let mut builder = Scene::builder("net");
    for (row, column) in (0..NET).flat_map(|row| (0..NET).map(move |column| (row, column))) {
        let place = DVec3::new(row as f64, column as f64, 0.0);
        builder = builder.body(knot(format!("{row} {column}"), DVec3::splat(0.1), place)?);
        let own = NET * row + column;
        let [beside, below] =
            [place - DVec3::X * 0.5, place - DVec3::Y * 0.5].map(|at| Joint::ball(BodyId::new(own), at));
        if row > 0 {
            builder = builder.joint(beside.with(BodyId::new(own - NET)));
        }
        builder = builder.joint(if column == 0 { below } else { below.with(BodyId::new(own - 1)) });
    }
    Ok(builder)
}

/// Three balls that bounce in a V of two planes until they rest.
fn crowded() -> Made<Scene> {
    let rubber = Material::new("rubber").with_restitution(0.5)?;
    let wall = |name: &str, normal: DVec3| -> Made<Body> {
        let shape = Geometry::Shape(Shape::half_space(UnitVector::new(normal)?));
        Ok(Body::fixed(name).geometry(shape).material(rubber.clone()))
    };
    let mut builder = Scene::builder("corner").duration_s(1.5);
    builder = builder.body(wall("left", DVec3::new(1.0, 0.0, 1.0))?).body(wall("right", DVec3::new(-1.0, 0.0, 1.0))?);
    for (k, x) in [-0.6, 0.55, 0.02].into_iter().enumerate() {
        builder = builder.body(ball(format!("ball {k}"), DVec3::new(x, 0.0, 2.0 + k as f64), rubber.clone())?);
    }
    Ok(builder.build()?)
}

/// Steps to the end of the duration. Returns whether it was reached.
fn step_to_the_end(scene: &Scene) -> bool {
    let Ok(mut simulation) = Simulation::new(scene) else { return false };
    while simulation.time() < scene.duration_s() {
        if simulation.step().is_err() {
            return false;
        }
    }
    true
}

/// Reads the positions of the bodies one by one, in the middle of a step.
fn bench_reading(criterion: &mut Criterion, scene: &Scene) -> Made<()> {
    let mut simulation = Simulation::new(scene)?;
    simulation.advance_to(0.505)?;
    let ids: Vec<BodyId> = scene.bodies().iter().filter_map(|body| simulation.body_id(body.name())).collect();
    criterion.bench_function("body of each: 30 boxes slide", |bencher| {
        bencher.iter(|| ids.iter().map(|&id| simulation.body(id).pose.translation.x).sum::<f64>());
    });
    let snapshot = simulation.snapshot();
    criterion.bench_function("snapshot: 30 boxes slide", |bencher| bencher.iter(|| simulation.snapshot()));
    criterion.bench_function("restore: 30 boxes slide", |bencher| {
        bencher.iter(|| black_box(simulation.restore(black_box(&snapshot))).is_ok());
    });
    Ok(())
}

fn bench_all(criterion: &mut Criterion) -> Made<()> {
    let sliding = sliding()?;
    criterion.bench_function("step in a loop: 30 boxes slide", |bencher| {
        bencher.iter(|| step_to_the_end(black_box(&sliding)));
    });
    bench_reading(criterion, &sliding)?;
    let crowded = crowded()?;
    criterion.bench_function("crowded bounces", |bencher| bencher.iter(|| step_to_the_end(black_box(&crowded))));
    let method = Method { tier: Some(Tier::Stepped), step_s: Some(STEP_S), ..Method::default() };
    let scene = stacks()?.method(method).build()?;
    let mut simulation = Simulation::with_effects(&scene, Effects::All)?;
    criterion.bench_function("stepped: 5 x 5 stacks, a step", |bencher| {
        bencher.iter(|| simulation.step().is_ok());
    });
    let method = Method { tier: Some(Tier::Stepped), step_s: Some(ROUGH_STEP_S), ..Method::default() };
    let scene = rough_pyramid()?.method(method).build()?;
    let mut simulation = Simulation::with_effects(&scene, Effects::All)?;
    criterion.bench_function("stepped: rough pyramid, a step", |bencher| {
        bencher.iter(|| simulation.step().is_ok());
    });
    let method = Method { tier: Some(Tier::Fast), step_s: Some(ROUGH_STEP_S), ..Method::default() };
    let scene = rough_pyramid()?.method(method).duration_s(FAST_STEPS * ROUGH_STEP_S).build()?;
    criterion.bench_function("fast: rough pyramid, 16 steps", |bencher| {
        bencher.iter(|| step_to_the_end(black_box(&scene)));
    });
    for (name, builder) in [("fast: chain of 200, 16 steps", chain()?), ("fast: net of 196, 16 steps", net()?)] {
        let method = Method { tier: Some(Tier::Fast), step_s: Some(ROUGH_STEP_S), ..Method::default() };
        let scene = builder.method(method).duration_s(FAST_STEPS * ROUGH_STEP_S).build()?;
        criterion.bench_function(name, |bencher| bencher.iter(|| step_to_the_end(black_box(&scene))));
    }
    Ok(())
}

fn stepping(criterion: &mut Criterion) {
    if let Err(error) = bench_all(criterion) {
        println!("a scene cannot be made or run: {error}");
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = stepping
}
criterion_main!(benches);
