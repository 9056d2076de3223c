//! From a robot file to a robot.

use super::assemble::{Placement, assembled};
use super::element::Element;
use super::finding::{Finding, Findings, RobotDefect};
use super::mesh_path::MeshPaths;
use super::model::Robot;
use super::reading::Reading;
use super::text::{RobotFileError, text_of};
use super::weld::Unphysical;
use super::{mjcf, tree, urdf, weld};
use crate::files::Files;
use std::path::{Path, PathBuf};

/// A robot, and what was found in its file.
#[derive(Debug)]
pub struct RobotFile {
    /// The robot.
    pub robot: Robot,
    /// What differs from the file, and what of it is ignored.
    pub findings: Vec<Finding>,
}

/// Reads a robot from a URDF or an MJCF file; the root element says which. `packages` are folders that hold packages of
/// ROS.
///
/// # Errors
/// When the file cannot be read or is refused, with all that was found.
pub fn read_robot(path: &Path, packages: &[PathBuf]) -> Result<RobotFile, RobotFileError> {
    read_robot_of(Files::Disk, path, packages)
}

/// As [`read_robot`], from where the files are.
pub(crate) fn read_robot_of(files: Files, path: &Path, packages: &[PathBuf]) -> Result<RobotFile, RobotFileError> {
    parsed(files, path, &text_of(files, path)?, packages)
}

/// Reads a robot from the text of a file of this name, to which the names of its meshes are relative.
///
/// # Errors
/// As [`read_robot`].
pub fn read_text(path: &Path, text: &str, packages: &[PathBuf]) -> Result<RobotFile, RobotFileError> {
    parsed(Files::Disk, path, text, packages)
}

fn parsed(files: Files, path: &Path, text: &str, packages: &[PathBuf]) -> Result<RobotFile, RobotFileError> {
    let mut findings = Findings::default();
    let refused = |findings: Findings| Err(RobotFileError::Refused(findings.into_sorted()));
    let root = match Element::parse(path, text) {
        Ok(root) => root,
        Err(fault) => {
            let (place, defect) = *fault;
            findings.add(&place, "robot", defect);
            return refused(findings);
        }
    };
    let mut reading = Reading::default();
    let paths = MeshPaths::new(files, path, packages);
    let robot = match root.name.as_str() {
        "robot" => urdf::read(&root, &paths, &mut reading),
        "mujoco" => mjcf::read(root, &paths, &mut reading),
        other => {
            reading.refuse(&root, "robot", RobotDefect::Root(other.to_owned()));
            None
        }
    };
    let (has_lost, has_guess) = (reading.has_lost, reading.has_guess);
    findings.extend(reading.finish());
    let is_urdf = robot.as_ref().is_some_and(|robot| robot.files.is_empty());
    let Some(robot) = robot else { return refused(findings) };
    let links = robot.links.clone();
    // A joint that is refused leaves links that hang at nothing: no fault of their own.
    let robot = if has_lost { None } else { tree::in_order(robot, &mut findings) };
    let robot = robot.map(|robot| if is_urdf { urdf::with_root(robot) } else { robot });
    match robot {
        Some(mut robot) if !findings.refuse() => {
            robot.files.insert(0, path.to_owned());
            Ok(RobotFile { robot, findings: findings.into_sorted() })
        }
        // What would refuse it later is told too, as far as it does not follow from what is refused already.
        Some(robot) if !has_guess => {
            let found = assembled(&robot, &Placement::of_file(Unphysical::Refuse), 0);
            findings.add_all(found.map_or_else(|refusing| refusing, |(_, others)| others));
            refused(findings)
        }
        _ => {
            weld::examine(&links, &mut findings);
            refused(findings)
        }
    }
}
