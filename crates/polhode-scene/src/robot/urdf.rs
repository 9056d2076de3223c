//! URDF: links, joints, inertias, shapes, limits.
//!
//! Source: docs/REFERENCES.md, URDF. Angles are in rad, `rpy` are rotations about the fixed axes x, y, z in
//! this order. What has no effect here is noted, in one list for all formats of what a joint has
//! (`crate::robot::joint_extras`).

use super::element::Element;
use super::finding::RobotDefect;
use super::joint_extras;
use super::mesh_path::MeshPaths;
use super::model::{
    EffortLimit, Follower, Geom, GeomForm, Inertial, Link, Robot, RobotCoordinate, RobotJoint, RobotJointKind, Root,
};
use super::reading::{Reading, turned};
use glam::{DMat3, DVec3};
use polhode::spatial::{Pose, Rotation, UnitVector};
use std::collections::BTreeMap;

/// Names of a root link that stands for the world.
const WORLD: &str = "world";

/// Kinds of joint, for messages.
const KINDS: &str = "revolute, continuous, prismatic, fixed, floating or planar";

/// Words for what no part of a simulation of bodies and joints reads.
const OF_OTHERS: &str = "it is for other programs";

/// Words for what says that a joint has a motor, and not what it exerts.
const OF_TRANSMISSIONS: &str = "it does not say what its motor exerts: `drives` of [[models]] do";

/// The robot that a document describes; `None` when its root or a joint cannot be used, which is noted.
pub(super) fn read(root: &Element, paths: &MeshPaths, reading: &mut Reading) -> Option<Robot> {
    let name = root.attribute("name").unwrap_or("robot").to_owned();
    if let Some((element, text)) = root.xacro() {
        // What else is found depends on what its macros make.
        reading.refuse(element, "robot", RobotDefect::Xacro(text));
        return None;
    }
    reading.ignore_others(root, &["link", "joint", "material", "transmission"], OF_OTHERS);
    for own in root.all("transmission") {
        reading.ignore(own, "<transmission> of <robot>", OF_TRANSMISSIONS);
    }
    let mut links = Vec::new();
    let mut numbers = BTreeMap::new();
    for element in root.all("link") {
        let link = link(element, paths, reading);
        if numbers.insert(link.name.clone(), links.len()).is_some() {
            reading.refuse(element, format!("link `{}`", link.name), RobotDefect::DuplicateName("link"));
        }
        links.push(link);
    }
    if links.is_empty() {
        reading.refuse(root, format!("robot `{name}`"), RobotDefect::Empty);
        return None;
    }
    let mut joints: Vec<RobotJoint> = Vec::new();
    let mut names = std::collections::BTreeSet::new();
    let mut followers = Vec::new();
    for element in root.all("joint") {
        followers.extend(element.first("mimic").and_then(|own| follower(element, own, reading)));
        if let Some(joint) = joint(element, &numbers, reading) {
            if !names.insert(joint.name.clone()) {
                reading.refuse(element, format!("joint `{}`", joint.name), RobotDefect::DuplicateName("joint"));
            }
            joints.push(joint);
        } else {
            reading.has_lost = true;
        }
    }
    let (place, files) = (root.place.clone(), Vec::new());
    let (loops, apart) = (Vec::new(), Vec::new());
    let (actuators, actuator_names, keyframes) = (Vec::new(), Vec::new(), Vec::new());
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
        gravity: None,
        root: Root::Link,
        files,
        source: paths.files(),
    })
}

/// The robot, whose first link is its root, with what the root stands for by its name.
pub(super) fn with_root(robot: Robot) -> Robot {
    let is_world = robot.links.first().is_some_and(|link| link.name == WORLD);
    Robot { root: if is_world { Root::World } else { Root::Link }, ..robot }
}

/// The name of an element, which it must have.
fn name_of(element: &Element, reading: &mut Reading) -> String {
    let name = element.attribute("name").map(str::trim).filter(|name| !name.is_empty());
    if name.is_none() {
        reading.refuse(element, format!("<{}>", element.name), RobotDefect::MissingAttribute("name"));
    }
    name.unwrap_or_default().to_owned()
}

fn link(element: &Element, paths: &MeshPaths, reading: &mut Reading) -> Link {
    let name = name_of(element, reading);
    let subject = format!("link `{name}`");
    reading.ignore_others(element, &["inertial", "visual", "collision", "material"], OF_OTHERS);
    let given = element.first("inertial");
    let inertial = given.and_then(|own| inertial(own, &subject, reading));
    reading.has_guess |= given.is_some() && inertial.is_none();
    let collisions = element.all("collision").filter_map(|own| geom(own, paths, &subject, reading)).collect();
    // What is seen has no effect on the motion: its faults are not told.
    let mut of_visuals = Reading::default();
    let visuals = element.all("visual").filter_map(|own| geom(own, paths, &subject, &mut of_visuals)).collect();
    Link { name, place: element.place.clone(), inertial, collisions, visuals }
}

/// The pose of `<origin>`; the identity without one.
fn origin(element: &Element, subject: &str, reading: &mut Reading) -> Pose {
    let Some(own) = element.first("origin") else { return Pose::IDENTITY };
    let translation = reading.vector(own, "xyz", subject).unwrap_or_default();
    let rpy = reading.vector(own, "rpy", subject).unwrap_or_default();
    Pose::new(of_rpy(rpy), translation)
}

/// Rotations about the fixed axes x, y, z, in this order.
fn of_rpy(rpy: DVec3) -> Rotation {
    if rpy == DVec3::ZERO {
        return Rotation::IDENTITY;
    }
    turned(DVec3::Z, rpy.z) * turned(DVec3::Y, rpy.y) * turned(DVec3::X, rpy.x)
}

fn inertial(element: &Element, subject: &str, reading: &mut Reading) -> Option<Inertial> {
    let frame = origin(element, subject, reading);
    let child = |name: &'static str, reading: &mut Reading| {
        let found = element.first(name);
        if found.is_none() {
            reading.refuse(element, subject, RobotDefect::MissingElement(name));
        }
        found
    };
    let (mass, inertia) = (child("mass", reading), child("inertia", reading));
    let mass = mass.and_then(|own| reading.needed(own, "value", subject));
    let inertia = inertia.and_then(|own| {
        let [xx, xy, xz, yy, yz, zz] =
            ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"].map(|key| reading.needed(own, key, subject));
        let (xx, xy, xz, yy, yz, zz) = (xx?, xy?, xz?, yy?, yz?, zz?);
        Some(DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz)))
    });
    Some(Inertial { place: element.place.clone(), mass: mass?, frame, inertia: inertia? })
}

fn geom(element: &Element, paths: &MeshPaths, subject: &str, reading: &mut Reading) -> Option<Geom> {
    let pose = origin(element, subject, reading);
    let Some(own) = element.first("geometry").and_then(|geometry| geometry.children.first()) else {
        reading.refuse(element, subject, RobotDefect::MissingElement("geometry"));
        return None;
    };
    let mut length = |key: &'static str| {
        let value = reading.needed(own, key, subject)?;
        reading.size(own, key, value, subject)
    };
    let form = match own.name.as_str() {
        "box" => {
            if own.attribute("size").is_none() {
                reading.refuse(own, subject, RobotDefect::MissingAttribute("size"));
            }
            let size = reading.vector(own, "size", subject)?;
            reading.size(own, "size", size.min_element(), subject)?;
            GeomForm::Box { size }
        }
        "sphere" => GeomForm::Sphere { radius: length("radius")? },
        "cylinder" => GeomForm::Cylinder { radius: length("radius")?, height: length("length")? },
        "capsule" => GeomForm::Capsule { radius: length("radius")?, height: length("length")? },
        "mesh" => {
            let Some(name) = own.attribute("filename") else {
                reading.refuse(own, subject, RobotDefect::MissingAttribute("filename"));
                return None;
            };
            let scale = reading.vector(own, "scale", subject).unwrap_or(DVec3::ONE);
            if scale.abs().min_element() == 0.0 {
                reading.refuse(own, subject, RobotDefect::Size { what: "scale", value: 0.0 });
                return None;
            }
            GeomForm::Mesh { name: name.to_owned(), path: paths.find(name), scale }
        }
        other => {
            let accepted = "box, sphere, cylinder, capsule or mesh";
            reading.refuse(
                own,
                subject,
                RobotDefect::Word { attribute: "geometry", value: other.to_owned(), accepted },
            );
            return None;
        }
    };
    Some(Geom { place: own.place.clone(), pose, form })
}

fn joint(element: &Element, numbers: &BTreeMap<String, usize>, reading: &mut Reading) -> Option<RobotJoint> {
    let name = name_of(element, reading);
    let subject = format!("joint `{name}`");
    let known = ["origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "safety_controller", "calibration"];
    reading.ignore_others(element, &known, OF_OTHERS);
    let mut link = |which: &'static str| {
        let Some(own) = element.first(which) else {
            reading.refuse(element, &subject, RobotDefect::MissingElement(which));
            return None;
        };
        let Some(link) = own.attribute("link") else {
            reading.refuse(own, &subject, RobotDefect::MissingAttribute("link"));
            return None;
        };
        let number = numbers.get(link).copied();
        if number.is_none() {
            reading.refuse(own, &subject, RobotDefect::UnknownName { kind: "link", name: link.to_owned() });
        }
        number
    };
    let (parent, child) = (link("parent"), link("child"));
    let origin = origin(element, &subject, reading);
    // What is wrong with its limits is told whatever else is wrong with the joint.
    let made = kind(element, &subject, reading).map(|kind| coordinates(element, kind, &name, reading));
    let (parent, child, (kind, coordinates)) = (parent?, child?, made?);
    let place = element.place.clone();
    Some(RobotJoint { name, place, parent, child, origin, anchor: DVec3::ZERO, kind, coordinates })
}

/// Which joint a joint follows.
fn follower(element: &Element, own: &Element, reading: &mut Reading) -> Option<Follower> {
    let name = element.attribute("name").unwrap_or_default().trim().to_owned();
    let subject = format!("joint `{name}`");
    let Some(leader) = own.attribute("joint") else {
        reading.refuse(own, &subject, RobotDefect::MissingAttribute("joint"));
        return None;
    };
    let multiplier = reading.number(own, "multiplier", &subject).unwrap_or(1.0);
    let offset = reading.number(own, "offset", &subject).unwrap_or(0.0);
    let (place, leader) = (own.place.clone(), leader.trim().to_owned());
    Some(Follower { place, name, leader, multiplier, offset })
}

/// What the joint leaves free.
fn kind(element: &Element, subject: &str, reading: &mut Reading) -> Option<RobotJointKind> {
    let Some(word) = element.attribute("type") else {
        reading.refuse(element, subject, RobotDefect::MissingAttribute("type"));
        return None;
    };
    let axis = |reading: &mut Reading| -> UnitVector {
        let Some(own) = element.first("axis") else { return UnitVector::X };
        if own.attribute("xyz").is_none() {
            reading.refuse(own, subject, RobotDefect::MissingAttribute("xyz"));
        }
        let vector = reading.vector(own, "xyz", subject);
        // One that is no vector is refused as such.
        vector.map_or(UnitVector::X, |vector| reading.axis(own, vector, subject))
    };
    Some(match word {
        "fixed" => RobotJointKind::Fixed,
        "floating" => RobotJointKind::Free,
        "revolute" | "continuous" => RobotJointKind::Hinge { axis: axis(reading) },
        "prismatic" => RobotJointKind::Slider { axis: axis(reading) },
        "planar" => RobotJointKind::Planar { normal: axis(reading) },
        other => {
            let (value, accepted) = (other.to_owned(), KINDS);
            reading.refuse(element, subject, RobotDefect::Word { attribute: "type", value, accepted });
            return None;
        }
    })
}

/// What acts along the coordinate of a joint; one whose limits are one value is fixed.
fn coordinates(
    element: &Element,
    kind: RobotJointKind,
    name: &str,
    reading: &mut Reading,
) -> (RobotJointKind, Vec<RobotCoordinate>) {
    let subject = format!("joint `{name}`");
    extras(element, kind, &subject, reading);
    if !matches!(kind, RobotJointKind::Hinge { .. } | RobotJointKind::Slider { .. }) {
        return (kind, Vec::new());
    }
    let has_limits = matches!(element.attribute("type"), Some("revolute" | "prismatic"));
    let limit = element.first("limit");
    if has_limits && limit.is_none() {
        reading.refuse(element, &subject, RobotDefect::MissingElement("limit"));
    }
    let mut limits = None;
    if let Some(own) = limit.filter(|_| has_limits) {
        let [lower, upper] = ["lower", "upper"].map(|key| reading.number(own, key, &subject).unwrap_or(0.0));
        if lower > upper {
            reading.refuse(own, &subject, RobotDefect::Limits { lower, upper });
        } else if lower == upper {
            reading.refuse(own, &subject, RobotDefect::NoRange(lower));
            if lower == 0.0 {
                return (RobotJointKind::Fixed, Vec::new());
            }
        } else {
            limits = Some([lower, upper]);
        }
    }
    let mut constant = |key: &'static str| {
        let own = element.first("dynamics")?;
        let value = reading.number(own, key, &subject)?;
        joint_extras::not_negative(own, key, value, &subject, reading)
    };
    let [damping, friction] = ["damping", "friction"].map(|key| constant(key).unwrap_or(0.0));
    let effort_limit = limit.and_then(effort_limit);
    let (name, place) = (name.to_owned(), limit.unwrap_or(element).place.clone());
    let coordinate = RobotCoordinate {
        name,
        place,
        reference: 0.0,
        limits,
        damping,
        friction,
        stiffness: 0.0,
        rest: 0.0,
        effort_limit,
    };
    (kind, vec![coordinate])
}

/// The largest effort of the motor of a joint, where it leaves it any.
fn effort_limit(limit: &Element) -> Option<EffortLimit> {
    // What is no number, or none of a motor, is told with the bounds.
    let most = limit.attribute("effort")?.trim().parse().ok().filter(|&most: &f64| most > 0.0)?;
    Some(EffortLimit { place: limit.place.clone(), what: "`effort` of <limit>", most })
}

/// What a joint has that has no effect.
fn extras(element: &Element, kind: RobotJointKind, subject: &str, reading: &mut Reading) {
    for name in ["safety_controller", "calibration"] {
        if let Some(own) = element.first(name) {
            reading.ignore(own, format!("<{name}> of joints"), OF_OTHERS);
        }
    }
    if matches!(kind, RobotJointKind::Fixed) {
        return;
    }
    if let Some(own) = element.first("limit") {
        for key in ["effort", "velocity"] {
            if own.attribute(key).is_none() {
                continue;
            }
            if key == "velocity" {
                reading.ignore(own, format!("`{key}` of <limit>"), joint_extras::OF_SPEEDS);
            }
            let value = reading.number(own, key, subject);
            if let Some(value) = value.filter(|&value| value <= 0.0) {
                reading.refuse(own, subject, RobotDefect::Bound { what: key, value });
            }
        }
    }
}
