//! What the plan reduces: motion in a plane and steady rotation are found where they are, and not where they are missed
//! by 1e-9.

use super::bodies::{cuboid, half_space, rotor};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Decision, Effect, Scene, SceneBuilder, Simulation};
use std::error::Error;

/// By how much a scene misses what is looked for (rad, or relative).
const MISSED: f64 = 1e-9;

/// Planes and axes.
pub(super) fn found_where_they_are(_context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (name, expected, scene) in planar_scenes()? {
        rows.push(row(Effect::PlanarMotion, name, expected, scene)?);
    }
    for (name, expected, body) in spins()? {
        let scene = Scene::builder("spin").gravity(DVec3::Z * -9.81).body(body);
        rows.push(row(Effect::SteadyRotation, name, expected, scene)?);
    }
    Ok(rows)
}

fn row(effect: Effect, name: &str, expected: bool, scene: SceneBuilder) -> Result<Row, Box<dyn Error>> {
    let simulation = Simulation::new(&scene.build()?)?;
    let found = simulation.plan().effects.iter().find(|decision| decision.effect == effect);
    let found = found.ok_or("the plan does not decide about it")?.decision == Decision::On;
    let words = |on: bool| if on { "found" } else { "not found" };
    Ok(Row::exact("reductions", &format!("{}: {name}", effect.name()), words(expected), words(found)))
}

/// A named scene and whether the plan is to find the effect.
type Expected<T> = Vec<(&'static str, bool, T)>;

/// A box that falls turning about y, by itself or on a floor.
fn planar_scenes() -> Result<Expected<SceneBuilder>, Box<dyn Error>> {
    let size = DVec3::new(1.0, 0.5, 0.25);
    let base = |turn: DVec3, velocity: DVec3, spin: DVec3| -> Result<Body, Box<dyn Error>> {
        let pose = Pose::new(Rotation::from_rotation_vector(turn), DVec3::new(0.3, 0.0, 2.0));
        Ok(cuboid("box", size, 2.0, DVec3::ZERO)?.pose(pose).velocity(Velocity::new(velocity, spin)))
    };
    let (turn, velocity, spin) = (DVec3::Y * 0.4, DVec3::new(1.0, 0.0, 0.5), DVec3::Y * 2.0);
    let floor = |normal: DVec3| -> Result<Body, Box<dyn Error>> { Ok(half_space("floor", UnitVector::new(normal)?)) };
    let scene = |body: Body, floor: Option<Body>| {
        let scene = Scene::builder("plane").body(body);
        floor.into_iter().fold(scene, SceneBuilder::body)
    };
    // How far below the box's centre a floor passes that rises to one side and touches its lowest corner there.
    let reach = 0.5 * (size.x * turn.y.sin() + size.y * MISSED + size.z * turn.y.cos());
    let leaning = |height: f64| -> Result<Body, Box<dyn Error>> {
        let floor = floor(DVec3::new(0.0, MISSED, 1.0))?;
        Ok(floor.pose(Pose::from_translation(DVec3::Z * height)))
    };
    let gravity_off = DVec3::new(0.0, 9.81 * MISSED, -9.81);
    Ok(vec![
        ("a box turning about y", true, scene(base(turn, velocity, spin)?, None)),
        ("a box turning about y above a floor", true, scene(base(turn, velocity, spin)?, Some(floor(DVec3::Z)?))),
        ("a box at rest above a floor", true, scene(base(turn, DVec3::ZERO, DVec3::ZERO)?, Some(floor(DVec3::Z)?))),
        ("spin off by 1e-9", false, scene(base(turn, velocity, spin + DVec3::X * (2.0 * MISSED))?, None)),
        ("velocity off by 1e-9", false, scene(base(turn, velocity + DVec3::Y * MISSED, spin)?, None)),
        ("attitude off by 1e-9", false, scene(base(turn + DVec3::X * MISSED, velocity, spin)?, None)),
        ("gravity off by 1e-9", false, scene(base(turn, velocity, spin)?, None).gravity(gravity_off)),
        // What leans elsewhere decides nothing until it is met.
        ("above a floor off by 1e-9", true, scene(base(turn, velocity, spin)?, Some(leaning(0.0)?))),
        ("on a floor off by 1e-9", false, scene(base(turn, velocity, spin)?, Some(leaning(2.0 - reach)?))),
    ])
}

/// Spins about principal axes and beside them.
fn spins() -> Result<Expected<Body>, Box<dyn Error>> {
    let moments = DVec3::new(1.0, 2.0, 3.0);
    let symmetric = DVec3::new(2.0, 2.0, 1.0);
    let sphere = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(0.4))?);
    let beside = |axis: DVec3, other: DVec3| (axis + other * MISSED) * 2.0;
    let oblique = DVec3::new(0.3, -0.7, 1.1);
    Ok(vec![
        ("about the smallest moment's axis", true, rotor("a", moments, DVec3::X * 2.0)?),
        ("about the middle moment's axis", true, rotor("a", moments, DVec3::Y * 2.0)?),
        ("about the largest moment's axis", true, rotor("a", moments, DVec3::Z * 2.0)?),
        ("about a symmetry axis", true, rotor("a", symmetric, DVec3::Z * 2.0)?),
        ("on the equator of a symmetric body", true, rotor("a", symmetric, DVec3::new(1.5, 2.0, 0.0))?),
        ("of a sphere", true, Body::movable("a", sphere).velocity(Velocity::new(DVec3::ZERO, oblique))),
        ("1e-9 beside the smallest moment's axis", false, rotor("a", moments, beside(DVec3::X, DVec3::Y))?),
        ("1e-9 beside the middle moment's axis", false, rotor("a", moments, beside(DVec3::Y, DVec3::Z))?),
        ("1e-9 beside the largest moment's axis", false, rotor("a", moments, beside(DVec3::Z, DVec3::X))?),
        ("1e-9 beside a symmetry axis", false, rotor("a", symmetric, beside(DVec3::Z, DVec3::X))?),
        ("1e-9 above the equator of a symmetric body", false, rotor("a", symmetric, beside(DVec3::X, DVec3::Z))?),
    ])
}
