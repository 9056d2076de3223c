//! Joints.

use super::bodies::Bodies;
use super::fault::{Fault, Faults, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{JointKindEntry, SceneFile};
use glam::DVec3;
use polhode::scene::Joint;
use polhode::spatial::UnitVector;

/// The joints of the file.
pub(super) fn build(file: &SceneFile, bodies: &Bodies<'_>, faults: &mut Faults) -> Vec<Joint> {
    let of_entry = |(index, entry)| {
        let entry: &crate::format::JointEntry = entry;
        let path = KeyPath::element("joints", index).key("type");
        faults.note(joint(&entry.kind, bodies, &path))
    };
    file.joints.iter().enumerate().filter_map(of_entry).collect()
}

fn joint(kind: &JointKindEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Joint, Fault> {
    match kind {
        JointKindEntry::Ball(entry) => {
            let path = path.key("ball");
            let (body, other) = held(&entry.bodies, bodies, &path.key("bodies"))?;
            Ok(between(Joint::ball(body, vector(&entry.anchor, &path.key("anchor"))?), other))
        }
        JointKindEntry::Hinge(entry) => {
            let path = path.key("hinge");
            let (body, other) = held(&entry.bodies, bodies, &path.key("bodies"))?;
            let anchor = vector(&entry.anchor, &path.key("anchor"))?;
            let path = path.key("axis");
            let axis: DVec3 = vector(&entry.axis, &path)?;
            let axis = UnitVector::new(axis).map_err(|error| (path, error.into()))?;
            Ok(between(Joint::hinge(body, anchor, axis), other))
        }
    }
}

fn between(joint: Joint, other: Option<usize>) -> Joint {
    other.map_or(joint, |other| joint.with(other))
}

/// The numbers of the bodies of a joint: one, and another or the world.
fn held(names: &[String], bodies: &Bodies<'_>, path: &KeyPath) -> Result<(usize, Option<usize>), Fault> {
    let number = |index: usize, name: &String| Ok(bodies.get(name, &path.index(index))?.0);
    match names {
        [one] => Ok((number(0, one)?, None)),
        [one, other] if one == other => Err((path.index(1), Refusal::Repeated(other.clone()))),
        [one, other] => Ok((number(0, one)?, Some(number(1, other)?))),
        _ => {
            let accepted = "the names of two bodies, or of one that the world holds".to_owned();
            Err((path.clone(), Refusal::Type { found: format!("length {}", names.len()), accepted }))
        }
    }
}
