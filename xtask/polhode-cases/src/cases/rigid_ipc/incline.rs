//! The incline of Rigid IPC (docs/REFERENCES.md, Ferguson): a block on a slope of 26.565 degrees, whose tangent is
//! 0.5000; friction 0.5 holds it, 0.49 does not. The scene comes in the suite's format through the importer, as meshes,
//! y upwards.
//!
//! Coulomb: at rest if `mu >= tan(alpha)`, else `a = g (sin(alpha) - mu cos(alpha))`.

use super::own_scenes::mesh_files;
use crate::cases::bodies::GRAVITY;
use crate::cases::{CaseResult, Context, Run};
use crate::rigid_ipc::{HeldRotations, import};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::Effects;
use polhode::mesh::obj;
use serde_json::json;
use std::error::Error;
use std::fs;
use std::path::Path;

const CASE: &str = "Rigid IPC incline";

/// The slope, degrees.
const DEGREES: f64 = 26.565;

/// Movement of a block that holds, m: rounding of its coordinates.
const HELD_M: f64 = 1e-12;

/// Tolerance of the acceleration of the block that slides, relative.
const RELATIVE: f64 = 1e-6;

/// Simulated time, s; a cube of edge 1 m then has slid 5 cm, and is still on the slab.
const DURATION_S: f64 = 1.0;

/// The rows.
pub(crate) fn incline(_: &Context) -> CaseResult {
    let folder = tempfile::tempdir()?;
    for (file, mesh) in mesh_files()? {
        fs::write(folder.path().join(file), obj::write(&mesh))?;
    }
    let (_, held) = slid(folder.path(), 0.5)?;
    let (angle, friction) = (DEGREES.to_radians(), 0.49);
    let expected = GRAVITY * (angle.sin() - friction * angle.cos());
    let (acceleration, _) = slid(folder.path(), friction)?;
    let quantity = "friction 0.49: acceleration, m/s^2";
    Ok(vec![
        Row::at_most(CASE, "friction 0.5: movement in 1 s, m", HELD_M, held),
        Row::compared(CASE, quantity, expected, acceleration, Tolerance::Relative(RELATIVE)),
    ])
}

/// Acceleration along the slope (m/s^2) and largest movement (m) of the block.
fn slid(folder: &Path, friction: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let path = folder.join(format!("incline-{friction}.json"));
    fs::write(&path, document(friction).to_string())?;
    let imported = import(&path, None, HeldRotations::Refused)?;
    let file = imported.write(&folder.join("taken-over"))?;
    let scene = polhode_scene::load(&file).map_err(|error| error.to_string())?;
    let run = Run::of(&scene, Effects::Planned)?;
    let block = scene.bodies().iter().find(|body| !body.is_fixed()).ok_or("no block")?;
    let moved = run.last(block.name())?.pose.translation - block.initial_pose().translation;
    Ok((2.0 * moved.length() / (DURATION_S * DURATION_S), run.largest_movement_m()))
}

/// The scene: a block on a slab, both turned about z, with the corners in the block's own frame on the slab's upper
/// face.
fn document(friction: f64) -> serde_json::Value {
    let angle = DEGREES.to_radians();
    // The slab is 1 m thick and the block lies on its middle.
    let above = DVec3::new(-angle.sin(), angle.cos(), 0.0);
    json!({
        "scene_type": "distance_barrier_rb_problem",
        "timestep": 0.01,
        "max_time": DURATION_S,
        "rigid_body_problem": {
            "coefficient_restitution": -1,
            "coefficient_friction": friction,
            "gravity": [0, -GRAVITY, 0],
            "rigid_bodies": [
                { "mesh": "cube.obj", "scale": [10, 1, 4], "rotation": [0, 0, DEGREES], "type": "static" },
                { "mesh": "cube.obj", "position": above.to_array(), "rotation": [0, 0, DEGREES] }
            ]
        }
    })
}
