//! Robots from files of their own.

use super::fault::{Fault, Faults, finite};
use super::materials::Materials;
use super::{drives, placement};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::files::SceneFolder;
use crate::format::{BaseName, ModelEntry, SceneFile, UnphysicalName};
use crate::robot::{
    self, Assembly, Base, Finding, NamedJoint, Placement, Robot, RobotDefect, RobotFile, RobotFileError, RobotGear,
    SelfCollision, Unphysical, assembled,
};
use polhode::scene::{Coordinate, CoordinateMotion, DEFAULT_GRAVITY, Joint, Material};
use polhode::spatial::DVec3;
use polhode::{Body, BodyId};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

/// A robot of a scene, as it was read and placed.
#[derive(Debug, Clone)]
pub(crate) struct PlacedRobot {
    /// Number of its model in the file.
    pub(crate) index: usize,
    /// The robot.
    pub(crate) robot: Robot,
    /// Where and how it stands.
    pub(crate) placement: Placement,
    /// What was found.
    pub(crate) findings: Arc<Vec<Finding>>,
    /// How many of its bodies forces move.
    pub(crate) movable: usize,
    /// The names of its bodies.
    pub(crate) names: Vec<String>,
    /// Its joints.
    pub(crate) joints: Vec<Joint>,
    /// Groups of its bodies that do not collide.
    pub(crate) no_contact: Vec<Vec<BodyId>>,
    /// The names of its joints in the scene.
    pub(crate) joint_names: Vec<NamedJoint>,
    /// Its coordinates that follow others.
    pub(crate) gears: Vec<RobotGear>,
    /// Its coordinates whose motion is prescribed: the place of the joint, which it is, and how it moves.
    pub(crate) motions: Vec<(usize, Coordinate, CoordinateMotion)>,
}

/// The robots of all models, whose bodies are added to the list, and what they are made of.
pub(super) fn build(
    file: &SceneFile,
    (materials, folder): (&Materials, &SceneFolder),
    bodies: &mut Vec<Body>,
    faults: &mut Faults,
) -> Vec<PlacedRobot> {
    let mut robots = Vec::new();
    for (index, entry) in file.models.iter().enumerate() {
        let path = KeyPath::element("models", index);
        let made = read(entry, (materials, folder), &path).and_then(|(robot, mut placement)| {
            drives::add(entry, &robot.robot, &mut placement, &path)?;
            assemble((robot, placement), (file, index), bodies, &path)
        });
        robots.extend(faults.note(made));
    }
    robots
}

/// The robot of an entry, and where and how it stands.
fn read(
    entry: &ModelEntry,
    (materials, folder): (&Materials, &SceneFolder),
    path: &KeyPath,
) -> Result<(RobotFile, Placement), Fault> {
    let placement = placed(entry, materials, path)?;
    let refused = |error: RobotFileError| (path.key("file"), Refusal::Robot(error));
    let packages: Vec<PathBuf> = entry.packages.iter().map(|package| folder.path(package)).collect();
    Ok((robot::read_robot_of(folder.files, &folder.path(&entry.file), &packages).map_err(refused)?, placement))
}

/// The robot in the scene; its bodies are added to the list.
fn assemble(
    (read, placement): (RobotFile, Placement),
    (scene, index): (&SceneFile, usize),
    bodies: &mut Vec<Body>,
    path: &KeyPath,
) -> Result<PlacedRobot, Fault> {
    let RobotFile { robot, mut findings } = read;
    let made = assembled(&robot, &placement, bodies.len());
    let (assembly, found) = made.map_err(|found| (path.key("file"), Refusal::Robot(RobotFileError::Refused(found))))?;
    findings.extend(found);
    findings.extend(gravity(scene, &robot));
    let Assembly { bodies: mut own, joints, no_contact, joint_names, gears, motions } = assembly;
    drives::check(&placement, &joint_names, path)?;
    let names = own.iter().map(|body| body.name().to_owned()).collect();
    let movable = own.iter().filter(|body| !body.is_fixed()).count();
    bodies.append(&mut own);
    let findings = Arc::new(findings);
    Ok(PlacedRobot {
        index,
        robot,
        placement,
        findings,
        movable,
        names,
        joints,
        no_contact,
        joint_names,
        gears,
        motions,
    })
}

/// What is told of the gravity of a robot file that is not that of the scene.
fn gravity(scene: &SceneFile, robot: &Robot) -> Option<Finding> {
    let own = robot.gravity?;
    let used = scene.gravity.as_ref().map_or(DEFAULT_GRAVITY, |gravity| DVec3::from_array(gravity.0));
    let defect = if used == own {
        RobotDefect::Read(format!("gravity {own} m/s^2"))
    } else {
        let what = format!("gravity {own} m/s^2 of <option>");
        RobotDefect::Ignored { what, count: 1, why: "that of the scene counts: `gravity`" }
    };
    Some(Finding { place: robot.place.clone(), subject: "robot".to_owned(), defect })
}

/// Where and how the robot of an entry stands.
fn placed(entry: &ModelEntry, materials: &Materials, path: &KeyPath) -> Result<Placement, Fault> {
    let (position, orientation) = (entry.position.as_ref(), entry.orientation.as_ref());
    let pose = placement::pose(position, orientation, entry.rotation_vector.as_ref(), path)?;
    for (name, &value) in &entry.configuration {
        finite(value, &path.key("configuration").key(name.clone()))?;
    }
    for (name, &value) in &entry.controls {
        finite(value, &path.key("controls").key(name.clone()))?;
    }
    let material = entry.material.as_ref().map(|name| materials.get(name, &path.key("material")));
    Ok(Placement {
        prefix: entry.name.clone().unwrap_or_default(),
        pose,
        base: entry.base.map(|base| match base {
            BaseName::Free => Base::Free,
            BaseName::Fixed => Base::Fixed,
        }),
        configuration: entry.configuration.clone(),
        keyframe: entry.keyframe.clone(),
        controls: entry.controls.clone(),
        drives: BTreeMap::new(),
        self_collision: if entry.self_collision { SelfCollision::On } else { SelfCollision::Off },
        unphysical: match entry.unphysical {
            UnphysicalName::Refuse => Unphysical::Refuse,
            UnphysicalName::Repair => Unphysical::Repair,
        },
        material: material.transpose()?.unwrap_or_else(Material::default),
    })
}

/// The number of the first model that a body of this name is of.
pub(super) fn of_body(name: &str, robots: &[PlacedRobot]) -> Option<usize> {
    robots.iter().find(|robot| robot.names.iter().any(|own| own == name)).map(|robot| robot.index)
}

/// The number of the last model that a body of this name is of.
pub(super) fn last_of_body(name: &str, robots: &[PlacedRobot]) -> Option<usize> {
    robots.iter().rev().find(|robot| robot.names.iter().any(|own| own == name)).map(|robot| robot.index)
}

/// The model that a joint of robots is of, counted over all of them, and the name of the joint.
pub(super) fn path_of_joint(number: usize, robots: &[PlacedRobot]) -> Option<KeyPath> {
    let mut first = 0;
    for robot in robots {
        if number < first + robot.joints.len() {
            let model = KeyPath::element("models", robot.index);
            let named = robot.joint_names.iter().find(|own| own.joint == number - first);
            return Some(named.map_or_else(|| model.clone(), |own| model.key("joints").key(own.name.clone())));
        }
        first += robot.joints.len();
    }
    None
}
