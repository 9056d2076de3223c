//! Scenes that the tests share.

use polhode::contact::Shape;
use polhode::scene::{Material, Method, Tier};
use polhode::spatial::{DVec3, Density, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{
    Body, BodyId, Effects, ErrorEstimation, Geometry, Outcome, Recorder, RunReport, Scene, SceneBuilder, Simulation,
    mesh,
};

/// Runs a scene, which must keep what its method promises, and keeps everything. Its error is not estimated: the tests
/// that call this measure it themselves, some with steps that leave more of it than is promised.
#[track_caller]
pub(crate) fn run(scene: &Scene, effects: Effects) -> (RunReport, Recorder) {
    let (report, recorder) = run_estimating(scene, effects, ErrorEstimation::Off);
    assert_ne!(report.outcome, Outcome::Degraded, "{:?} {:?}", report.warnings, report.certificate);
    (report, recorder)
}

/// The same, whether the scene keeps its promise or not.
pub(crate) fn run_even_degraded(scene: &Scene, effects: Effects) -> (RunReport, Recorder) {
    run_estimating(scene, effects, ErrorEstimation::Quick)
}

/// The same, with its error estimated so.
pub(crate) fn run_estimating(scene: &Scene, effects: Effects, estimation: ErrorEstimation) -> (RunReport, Recorder) {
    let mut recorder = Recorder::default();
    let simulation = Simulation::with_effects(scene, effects).unwrap();
    let report = simulation.estimating(estimation).run_observed(&mut recorder).unwrap();
    (report, recorder)
}

pub(crate) fn accurate() -> Method {
    Method { tier: Some(Tier::Accurate), ..Method::default() }
}

/// A material of this restitution without friction.
pub(crate) fn elastic(restitution: f64) -> Material {
    Material::new("elastic").with_restitution(restitution).unwrap()
}

/// The floor: the half-space below z = 0.
pub(crate) fn floor() -> Body {
    Body::fixed("floor").geometry(Geometry::Shape(Shape::half_space(UnitVector::Z)))
}

/// A box of uniform density and mass one.
pub(crate) fn brick(name: &str, size: DVec3, center: DVec3) -> Body {
    let properties =
        mesh::primitives::solid_box(size, Density::new(1.0 / (size.x * size.y * size.z)).unwrap()).unwrap();
    Body::movable(name, properties)
        .geometry(Geometry::Shape(Shape::cuboid(size).unwrap()))
        .pose(Pose::from_translation(center))
}

/// A solid sphere of mass `mass`.
pub(crate) fn ball(name: &str, mass: f64, radius: f64, center: DVec3, velocity: DVec3) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::splat(0.4 * mass * radius * radius)).unwrap();
    Body::movable(name, MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia))
        .geometry(Geometry::Shape(Shape::sphere(radius).unwrap()))
        .pose(Pose::from_translation(center))
        .velocity(Velocity::new(velocity, DVec3::ZERO))
}

/// Whether bricks of one row of a diamond may touch.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Sides {
    Touch,
    Ignore,
}

/// The m-diamond of Videos 12-15: rows of 1, 2, .. m, .. 2, 1 bricks 1 x 0.5 x 0.25 m on a floor.
pub(crate) fn diamond(m: usize, sides: Sides) -> SceneBuilder {
    let size = DVec3::new(1.0, 0.5, 0.25);
    let mut builder = Scene::builder(format!("diamond-{m}")).method(accurate()).body(floor());
    let mut number = 1;
    for row in 1..2 * m {
        let count = if row <= m { row } else { 2 * m - row };
        let members: Vec<usize> = (number..number + count).collect();
        for column in 0..count {
            let center = DVec3::new(column as f64 - 0.5 * (count as f64 - 1.0), 0.0, 0.25 * (row as f64 - 0.5));
            builder = builder.body(brick(&format!("r{row}c{}", column + 1), size, center));
        }
        number += count;
        if sides == Sides::Ignore {
            builder = builder.no_contact(members.into_iter().map(BodyId::new));
        }
    }
    builder
}
