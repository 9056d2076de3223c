//! Gears, and joints by name.

use super::fault::{Fault, Faults};
use super::model::PlacedRobot;
use crate::document::KeyPath;
use crate::error::{Refusal, nearest};
use crate::format::{CoordinateName, Exactly, GearEntry, SceneFile};
use polhode::JointId;
use polhode::scene::{Coordinate, Gear};
use std::collections::BTreeMap;

/// The joints that names of the scene stand for; of robots the coordinate too, since several of their joints may be
/// one.
struct Joints {
    named: BTreeMap<String, (JointId, Option<Coordinate>)>,
}

impl Joints {
    /// Those of the file and of robots, whose joints follow them.
    fn of(file: &SceneFile, robots: &[PlacedRobot], faults: &mut Faults) -> Self {
        let mut named = BTreeMap::new();
        for (index, entry) in file.joints.iter().enumerate() {
            let Some(name) = &entry.name else { continue };
            if named.insert(name.clone(), (JointId::new(index), None)).is_some() {
                faults.add((KeyPath::element("joints", index).key("name"), Refusal::Repeated(name.clone())));
            }
        }
        let mut first = file.joints.len();
        for robot in robots {
            for own in &robot.joint_names {
                named.entry(own.name.clone()).or_insert((JointId::new(first + own.joint), own.coordinate));
            }
            first += robot.joints.len();
        }
        Self { named }
    }

    fn get(&self, name: &str, path: &KeyPath) -> Result<(JointId, Option<Coordinate>), Fault> {
        self.named.get(name).copied().ok_or_else(|| {
            let names: Vec<&str> = self.named.keys().map(String::as_str).collect();
            let known = nearest(name, &names, "none, no joint has a `name`");
            (path.clone(), Refusal::UnknownName { kind: "joint", name: name.to_owned(), known })
        })
    }
}

/// The gears of the file, and those of robots.
pub(super) fn build(file: &SceneFile, robots: &[PlacedRobot], faults: &mut Faults) -> Vec<Gear> {
    let joints = Joints::of(file, robots, faults);
    let mut gears = Vec::new();
    for (index, entry) in file.gears.iter().enumerate() {
        gears.extend(faults.note(gear(entry, &joints, &KeyPath::element("gears", index))));
    }
    let mut first = file.joints.len();
    for robot in robots {
        for follower in &robot.gears {
            let [own, other] = [follower.joint, follower.leader].map(|joint| JointId::new(first + joint));
            let gear = Gear::new(own, other, follower.ratio).map(|gear| {
                let [own, other] = follower.coordinates;
                gear.between(own, other)
            });
            let path = KeyPath::element("models", robot.index);
            gears.extend(faults.note(gear.map_err(|error| (path, error.into()))));
        }
        first += robot.joints.len();
    }
    gears
}

fn gear(entry: &GearEntry, joints: &Joints, path: &KeyPath) -> Result<Gear, Fault> {
    let Exactly([first, second]) = &entry.joints;
    let of_names = path.key("joints");
    let (first, second) = (joints.get(first, &of_names.index(0))?, joints.get(second, &of_names.index(1))?);
    let gear = Gear::new(first.0, second.0, entry.ratio).map_err(|error| (path.key("ratio"), error.into()))?;
    let named = entry.coordinates.as_ref().map(|Exactly(names)| names.map(coordinate));
    Ok(match (named, first.1, second.1) {
        (Some([first, second]), _, _) | (None, Some(first), Some(second)) => gear.between(first, second),
        _ => gear,
    })
}

const fn coordinate(name: CoordinateName) -> Coordinate {
    match name {
        CoordinateName::Angle => Coordinate::Angle,
        CoordinateName::Displacement => Coordinate::Displacement,
        CoordinateName::Distance => Coordinate::Distance,
    }
}
