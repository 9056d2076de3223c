//! MJCF: bodies, joints, geometries, inertias, equality constraints.
//!
//! Source: docs/REFERENCES.md, MJCF. The world body is the root link; a body with several joints gets a link
//! without mass for each but the last of them, which the assembly makes one joint of where it can.
//!
//! | module | holds |
//! |---|---|
//! | `include` | files that are included |
//! | `compiler` | what the numbers mean |
//! | `defaults` | attributes by class |
//! | `frame` | poses |
//! | `asset` | meshes |
//! | `geom` | geometries |
//! | `inertial` | mass properties |
//! | `joint` | joints |
//! | `body` | the tree of bodies |
//! | `equality` | what closes loops, and joints that follow others |
//! | `actuator` | motors and servos |
//! | `general` | what the ways to write them mean |
//! | `keyframe` | states by name |
//! | `option` | gravity, and what is left out of the rest |

mod actuator;
mod asset;
mod body;
mod compiler;
mod defaults;
mod equality;
mod frame;
mod general;
mod geom;
mod include;
mod inertial;
mod joint;
mod keyframe;
mod option;

use super::element::Element;
use super::finding::RobotDefect;
use super::mesh_path::MeshPaths;
use super::model::{Robot, Root};
use super::reading::Reading;
use body::{Bodies, Parts};
use compiler::Compiler;
use defaults::Defaults;
use equality::Couplings;
use option::{Actuation, Options};

/// Elements of the root that are read, and those that say nothing of motion.
const KNOWN: [&str; 11] = [
    "compiler",
    "default",
    "asset",
    "worldbody",
    "equality",
    "contact",
    "visual",
    "statistic",
    "actuator",
    "keyframe",
    "option",
];

/// Why the rest has no effect.
const OF_OTHERS: &str = "it is for other programs, or not simulated: see the book on robots";

/// The robot that a document describes; `None` when it cannot be used, which is noted.
pub(super) fn read(mut root: Element, paths: &MeshPaths, reading: &mut Reading) -> Option<Robot> {
    let mut files = Vec::new();
    if let Err(fault) = include::expand(&mut root, (paths.files(), paths.folder()), &mut files) {
        let (place, defect) = *fault;
        reading.findings.add(&place, "robot", defect);
        return None;
    }
    let name = root.attribute("model").unwrap_or("robot").to_owned();
    reading.ignore_others(&root, &KNOWN, OF_OTHERS);
    let compiler = Compiler::of(&root, reading);
    let defaults = Defaults::of(&root);
    defaults.check(&root, reading);
    let meshes = asset::meshes(&root, (&compiler, &defaults), paths, reading);
    let mut bodies = Bodies::new((&compiler, &defaults), &meshes, paths.files(), &root.place);
    for world in root.all("worldbody") {
        bodies.world(world, reading);
    }
    if root.first("worldbody").is_none() {
        reading.refuse(&root, format!("robot `{name}`"), RobotDefect::MissingElement("worldbody"));
        return None;
    }
    let Couplings { loops, followers, mut apart } = equality::read(&root, &bodies, &defaults, reading);
    let Options { gravity, contacts, actuation } = Options::of(&root, reading);
    let (mut actuators, actuator_names) = actuator::read(&root, (&bodies, &defaults), reading);
    if actuation == Actuation::Off {
        actuators.clear();
    }
    let Parts { mut links, joints, apart: mut unmet } = bodies.into_parts(contacts);
    apart.append(&mut unmet);
    if let Some(total) = compiler.total_mass {
        let sum: f64 = links.iter().filter_map(|link| link.inertial.as_ref()).map(|own| own.mass).sum();
        for own in links.iter_mut().filter_map(|link| link.inertial.as_mut()).filter(|_| sum > 0.0) {
            own.mass *= total / sum;
            own.inertia *= total / sum;
        }
    }
    let keyframes = keyframe::read(&root, (&joints, actuator_names.len()), reading);
    let place = root.place;
    Some(Robot {
        name,
        place,
        links,
        joints,
        loops,
        followers,
        apart,
        actuators,
        actuator_names,
        keyframes,
        gravity,
        root: Root::World,
        files,
        source: paths.files(),
    })
}
