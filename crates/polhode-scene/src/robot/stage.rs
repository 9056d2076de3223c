//! The scene that a robot file stands for: the robot for two seconds, above a floor unless the world holds all of it.

use super::assemble::{Placement, assembled};
use super::read::{RobotFile, read_robot_of};
use super::text::RobotFileError;
use super::weld::Unphysical;
use crate::files::Files;
use polhode::contact::{Shape, aabb_of};
use polhode::{Body, BodyId, Geometry};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

/// Endings of the names of robot files.
const ENDINGS: [&str; 4] = ["urdf", "xml", "mjcf", "xacro"];

/// Whether the name of a file is that of a robot file.
pub(crate) fn is_robot_file(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
}

/// The text of the scene.
///
/// # Errors
/// When the robot file is refused.
pub(crate) fn scene_of(files: Files, path: &Path) -> Result<String, RobotFileError> {
    let RobotFile { robot, .. } = read_robot_of(files, path, &[])?;
    // An inertia that is refused is told when the scene is built, which may repair it; where others refuse the file it
    // is told with them.
    let repaired = assembled(&robot, &Placement::of_file(Unphysical::Repair), 0);
    let (assembly, _) = repaired.map_err(|found| {
        let told = assembled(&robot, &Placement::of_file(Unphysical::Refuse), 0).err();
        RobotFileError::Refused(told.unwrap_or(found))
    })?;
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    // A text of TOML: Rust's escapes of strings are those of TOML for what names of files hold.
    let mut text = format!(
        "format = 1\nname = {name:?}\nduration = 2.0\n\n[materials.rubber]\nfriction = 0.8\n\n[[models]]\n\
         file = {file:?}\nmaterial = \"rubber\"\n",
        name = robot.name
    );
    if let Some(own) = robot.gravity {
        // Before the tables of the text.
        let line = format!("gravity = [{:?}, {:?}, {:?}]\n\n[materials", own.x, own.y, own.z);
        text = text.replacen("[materials", &line, 1);
    }
    let joined: BTreeSet<usize> = assembly
        .joints
        .iter()
        .flat_map(|joint| [Some(joint.body()), joint.other()])
        .flatten()
        .map(BodyId::index)
        .collect();
    let is_ground = |body: &Body| body.is_fixed() && matches!(body.shape(), Some(Geometry::Shape(Shape::HalfSpace(_))));
    let has_ground = assembly.bodies.iter().any(is_ground);
    let is_held = assembly.bodies.iter().enumerate().any(|(number, body)| body.is_fixed() && joined.contains(&number))
        || assembly.joints.iter().any(|joint| joint.other().is_none());
    let lowest = assembly.bodies.iter().filter_map(lowest).reduce(f64::min);
    if !is_held {
        // Bodies that fall to the ground and stay there: real time before digits.
        text.push_str("\n[method]\ntier = \"stepped\"\nstep = 0.001\n");
    }
    if let Some(lowest) = lowest.filter(|_| !has_ground && !is_held) {
        let _ = write!(
            text,
            "\n[[bodies]]\nname = \"floor\"\nfixed = true\nshape.half_space.normal = [0, 0, 1]\n\
             position = [0, 0, {lowest:?}]\nmaterial = \"rubber\"\n"
        );
    }
    Ok(text)
}

/// The height of the lowest point of a body, m.
fn lowest(body: &Body) -> Option<f64> {
    let Some(Geometry::Shape(shape)) = body.shape() else { return None };
    aabb_of(shape, body.initial_pose()).ok().map(|around| around.min().z).filter(|z| z.is_finite())
}
