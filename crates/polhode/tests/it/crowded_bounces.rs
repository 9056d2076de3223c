//! Stretches of crowded events with restitution: bounces that are too low to be seen are not followed.

use crate::support::{accurate, floor};
use polhode::scene::Material;
use polhode::spatial::{DVec3, Density, Pose, Velocity};
use polhode::{Body, ErrorEstimation, Geometry, Outcome, Scene, Simulation, contact::Shape, mesh};

/// Thickness, width and height of a domino, m, and the distance of two of them.
const SIZE_M: DVec3 = DVec3::new(0.0075, 0.024, 0.048);
const APART_M: f64 = 0.02;

/// A domino whose centre is lower has fallen, m: an upright one is at 0.024 m.
const HEIGHT_OF_FALLEN_M: f64 = 0.015;

/// Some twice as many time steps as there are.
const MOST_STEPS: u64 = 15_000;

/// A row of dominoes with restitution 0.5, of which the first one is pushed.
fn dominoes(count: usize) -> Scene {
    let material = Material::new("m").with_friction(0.2).unwrap().with_restitution(0.5).unwrap();
    let mut scene = Scene::builder("dominoes").body(floor().material(material.clone()));
    for k in 0..count {
        let density = Density::new(0.01 / (SIZE_M.x * SIZE_M.y * SIZE_M.z)).unwrap();
        let properties = mesh::primitives::solid_box(SIZE_M, density).unwrap();
        let place = DVec3::new(APART_M * k as f64, 0.0, 0.5 * SIZE_M.z);
        let pushed = if k == 0 { Velocity::new(DVec3::new(0.096, 0.0, 0.015), DVec3::Y * 4.0) } else { Velocity::ZERO };
        let shape = Geometry::Shape(Shape::cuboid(SIZE_M).unwrap());
        let domino = Body::movable(format!("d{k}"), properties).geometry(shape).material(material.clone());
        scene = scene.body(domino.pose(Pose::from_translation(place)).velocity(pushed));
    }
    scene.duration_s(1.5).method(accurate()).build().unwrap()
}

/// Dominoes that lean on each other strike each other again and again, ever more weakly. While time steps followed each
/// bounce that their length could resolve, shorter steps found more bounces, each of which made the next step shorter
/// still: ten dominoes and the run beside them took 76,000 steps, and a minute. They all fall, and come to rest.
#[test]
fn dominoes_that_bounce_make_the_steps_of_their_crowd_ever_shorter() {
    let scene = dominoes(10);
    let report = Simulation::new(&scene).unwrap().estimating(ErrorEstimation::Off).run().unwrap();
    let steps: u64 = report.crowded.iter().map(|stretch| stretch.steps).sum();
    assert_eq!(report.outcome, Outcome::Completed, "{:?}", report.warnings);
    assert!(steps < MOST_STEPS, "{steps} time steps");
    for body in report.bodies.iter().skip(1) {
        let (height, speed) = (body.state.pose.translation.z, body.state.velocity.linear.length());
        assert!(height < HEIGHT_OF_FALLEN_M && speed == 0.0, "{} at {height} m, {speed} m/s", body.name);
    }
}
