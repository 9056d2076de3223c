//! MJCF: not read yet.

use super::element::Element;
use super::finding::RobotDefect;
use super::mesh_path::MeshPaths;
use super::model::Robot;
use super::reading::Reading;

pub(super) fn read(root: Element, _paths: &MeshPaths, reading: &mut Reading) -> Option<Robot> {
    reading.refuse(&root, "robot", RobotDefect::Root("mujoco".to_owned()));
    None
}
