//! The tier `fast` on motions with closed forms: a slide that stops and is not lifted by its friction, a flight, and a
//! stack that stands.

use super::bodies::BRICK;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::primitives::solid_box;
use polhode::scene::{Material, Method, Tier};
use polhode::spatial::{Density, Pose, UnitVector, Velocity};
use polhode::{Body, ErrorEstimation, Geometry, Scene, SceneBuilder, Simulation};
use std::error::Error;
use std::fmt::Write as _;

/// Density of the bricks, kg/m^3.
const DENSITY: f64 = 1000.0;
/// Coefficient of friction.
const FRICTION: f64 = 0.5;
/// m/s^2.
const GRAVITY: f64 = 9.81;
/// How far a soft contact may sag or be lifted, m: that of a spring of 60 Hz under the weight of a body, with its
/// margin.
const SAG_M: f64 = 1e-3;
/// How far the top of a stack of eight may sink, m: each contact gives way by the weight above it, 2.5 cm in all.
const STACK_SAG_M: f64 = 0.03;
/// How far a slide of 3 m/s may differ from its closed form, m: what it moves in a substep, and a half.
const SLIDE_M: f64 = 0.02;
/// How far bodies of 15 to 30 cm that fall on each other may overlap, m.
const HEAP_OVERLAP_M: f64 = 0.05;
/// Rounding of a flight of a few metres, m.
const ROUNDING_M: f64 = 1e-12;

/// The largest overlap of boxes and balls that fall into five heaps, m.
fn overlap_of_heaps() -> Result<f64, Box<dyn Error>> {
    let mut text =
        "format = 1\nduration = 1.0\n[method]\ntier = \"fast\"\n[materials.m]\nfriction = 0.4\nrestitution = 0.3\n\
                    [[bodies]]\nname = \"floor\"\nfixed = true\nmaterial = \"m\"\nshape.half_space.normal = [0, 0, 1]\n"
            .to_owned();
    for k in 0..60 {
        let (group, level) = (f64::from(k / 12), k % 12);
        let place =
            [3.0 * group + 0.05 * f64::from(level % 3), 0.04 * f64::from(level % 4), 0.3 + 0.45 * f64::from(level)];
        let turn = [0.1, 0.2, 0.3].map(|part| part * f64::from(level));
        let shape = match k % 3 {
            0 => "shape.sphere.radius = 0.15".to_owned(),
            _ => format!("shape.box.size = [0.3, 0.25, 0.2]\nrotation_vector = {turn:?}"),
        };
        write!(text, "[[bodies]]\nname = \"b{k}\"\nmass = 1.0\nmaterial = \"m\"\nposition = {place:?}\n{shape}\n")?;
    }
    let mut simulation =
        Simulation::new(&polhode_scene::load_text("heaps.toml", &text, &[])?.scene)?.estimating(ErrorEstimation::Off);
    simulation.advance_to(1.0)?;
    Ok(simulation.frame().certificate.max_penetration_m)
}

/// The rows.
pub(super) fn closed_forms(_context: &Context) -> CaseResult {
    let case = "tier fast";
    let speed = 3.0;
    let mut sliding =
        simulation(scene("slide")?.body(brick("brick", 0.0)?.velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO))))?;
    sliding.advance_to(0.3)?;
    let lifted = sliding.bodies()[1].pose.translation.z - 0.5 * BRICK.z;
    sliding.advance_to(1.0)?;
    let way = sliding.bodies()[1].pose.translation.x;
    let exact = speed * speed / (2.0 * FRICTION * GRAVITY);
    let mut flying = simulation(
        Scene::builder("flight")
            .duration_s(1.0)
            .method(fast())
            .body(brick("brick", 5.0)?.velocity(Velocity::new(DVec3::new(1.0, 2.0, 3.0), DVec3::ZERO))),
    )?;
    let start = flying.bodies()[0].pose.translation;
    flying.advance_to(1.0)?;
    let flown = flying.bodies()[0].pose.translation - start - DVec3::new(1.0, 2.0, 3.0 - 0.5 * GRAVITY);
    let mut stack = scene("stack")?;
    for level in 0..8 {
        stack = stack.body(brick(&format!("brick {level}"), f64::from(level) * BRICK.z)?);
    }
    let mut stack = simulation(stack)?;
    let before = stack.bodies();
    stack.advance_to(5.0)?;
    let moved = before.iter().zip(stack.bodies()).map(|(x, y)| (y.pose.translation - x.pose.translation).length());
    let sag = moved.fold(0.0, f64::max);
    Ok(vec![
        Row::at_most(case, "five heaps of balls and bricks: largest overlap, m", HEAP_OVERLAP_M, overlap_of_heaps()?),
        Row::compared(case, "way of a slide from 3 m/s, m", exact, way, Tolerance::Absolute(SLIDE_M)),
        Row::at_most(case, "height of the same at 1.5 m/s: friction does not lift, m", SAG_M, lifted),
        Row::at_most(case, "flight of 1 s, m", ROUNDING_M, flown.length()),
        Row::at_most(case, "stack of eight bricks: largest movement in 5 s, m", STACK_SAG_M, sag),
    ])
}

fn fast() -> Method {
    Method { tier: Some(Tier::Fast), ..Method::default() }
}

fn material() -> Result<Material, Box<dyn Error>> {
    Ok(Material::new("rough").with_friction(FRICTION)?)
}

/// A floor.
fn scene(name: &str) -> Result<SceneBuilder, Box<dyn Error>> {
    let floor = Body::fixed("floor").geometry(Geometry::Shape(Shape::half_space(UnitVector::Z)));
    Ok(Scene::builder(name).duration_s(10.0).output_interval_s(10.0).method(fast()).body(floor.material(material()?)))
}

/// A brick whose lower face is at this height, m.
fn brick(name: &str, height: f64) -> Result<Body, Box<dyn Error>> {
    let body = Body::movable(name, solid_box(BRICK, Density::new(DENSITY)?)?);
    let body = body.geometry(Geometry::Shape(Shape::cuboid(BRICK)?)).material(material()?);
    Ok(body.pose(Pose::from_translation(DVec3::Z * (height + 0.5 * BRICK.z))))
}

fn simulation(scene: SceneBuilder) -> Result<Simulation, Box<dyn Error>> {
    Ok(Simulation::new(&scene.build()?)?)
}
