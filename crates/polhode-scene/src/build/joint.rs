//! Joints.

use super::bodies::Bodies;
use super::fault::{Fault, Faults, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{JointEntry, JointKindEntry, SceneFile, Vector};
use polhode::BodyId;
use polhode::scene::{Joint, JointKind};
use polhode::spatial::UnitVector;

/// The joints of the file.
pub(super) fn build(file: &SceneFile, bodies: &Bodies<'_>, faults: &mut Faults) -> Vec<Joint> {
    let of_entry = |(index, entry): (usize, &JointEntry)| {
        faults.note(joint(&entry.kind, bodies, &KeyPath::element("joints", index).key("type")))
    };
    file.joints.iter().enumerate().filter_map(of_entry).collect()
}

/// What an entry gives beside its kind: the names of its bodies, its anchor, and its path.
struct Held<'a> {
    names: &'a [String],
    anchor: &'a Vector,
    path: KeyPath,
}

fn joint(kind: &JointKindEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Joint, Fault> {
    let at = |key: &'static str, names, anchor| Held { names, anchor, path: path.key(key) };
    let along = |held: &Held<'_>, key: &'static str, vector| direction(vector, &held.path.key(key));
    let (held, kind) = match kind {
        JointKindEntry::Ball(entry) => (at("ball", &entry.bodies, &entry.anchor), JointKind::Ball),
        JointKindEntry::Fixed(entry) => (at("fixed", &entry.bodies, &entry.anchor), JointKind::Fixed),
        JointKindEntry::Hinge(entry) => {
            let held = at("hinge", &entry.bodies, &entry.anchor);
            let axis = along(&held, "axis", &entry.axis)?;
            (held, JointKind::Hinge { axis })
        }
        JointKindEntry::Slider(entry) => {
            let held = at("slider", &entry.bodies, &entry.anchor);
            let axis = along(&held, "axis", &entry.axis)?;
            (held, JointKind::Slider { axis })
        }
        JointKindEntry::Cylindrical(entry) => {
            let held = at("cylindrical", &entry.bodies, &entry.anchor);
            let axis = along(&held, "axis", &entry.axis)?;
            (held, JointKind::Cylindrical { axis })
        }
        JointKindEntry::Planar(entry) => {
            let held = at("planar", &entry.bodies, &entry.anchor);
            let normal = along(&held, "normal", &entry.normal)?;
            (held, JointKind::Planar { normal })
        }
        JointKindEntry::Universal(entry) => {
            let held = at("universal", &entry.bodies, &entry.anchor);
            let path = held.path.key("axes");
            let [first, second] = &entry.axes.0;
            let axes = [direction(first, &path.index(0))?, direction(second, &path.index(1))?];
            (held, JointKind::Universal { axes })
        }
    };
    let anchor = vector(held.anchor, &held.path.key("anchor"))?;
    let (body, other) = pair(held.names, bodies, &held.path.key("bodies"))?;
    let joint = Joint::new(kind, body, anchor);
    Ok(other.map_or(joint, |other| joint.with(other)))
}

/// A direction of any length but zero.
fn direction(entry: &Vector, path: &KeyPath) -> Result<UnitVector, Fault> {
    UnitVector::new(vector(entry, path)?).map_err(|error| (path.clone(), error.into()))
}

/// The numbers of the bodies of a joint: one, and another or the world.
fn pair(names: &[String], bodies: &Bodies<'_>, path: &KeyPath) -> Result<(BodyId, Option<BodyId>), Fault> {
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
