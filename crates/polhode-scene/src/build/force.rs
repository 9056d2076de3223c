//! Forces.
//!
//! One entry makes one force of the engine, except drag, which makes one for each of its bodies.

use super::bodies::Bodies;
use super::fault::{Fault, Faults, not_negative, vector};
use super::{array, signal, spring};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{DragEntry, DragLawName, Exactly, ForceKind, FrameName, SceneFile};
use glam::DVec3;
use polhode::dynamics::field::point_gravity::GRAVITATION;
use polhode::scene::{DragLaw, Force, Frame};
use polhode::{Body, BodyId};

/// Forces of the engine that a scene makes at the most: drag on every body, given many times over, must not fill the
/// memory.
const MOST_FORCES: usize = 1_000_000;

/// The forces of the file.
pub(super) fn build(file: &SceneFile, bodies: &Bodies<'_>, faults: &mut Faults) -> Vec<Force> {
    let mut forces = Vec::new();
    for (index, entry) in file.forces.iter().enumerate() {
        let path = KeyPath::element("forces", index);
        if forces.len() + count(&entry.kind, bodies.all()) > MOST_FORCES {
            let found = format!("a scene of more than {MOST_FORCES} forces (drag counts once for each body)");
            faults.add((path, Refusal::Type { found, accepted: "fewer forces".to_owned() }));
            break;
        }
        forces.extend(faults.note(of_entry(&entry.kind, bodies, &path.key("type"))).unwrap_or_default());
    }
    forces
}

/// The entry of the file that force `number` of the engine comes from; so many bodies of robots are moved by forces.
pub(super) fn entry_of(number: usize, file: &SceneFile, of_robots: usize) -> Option<usize> {
    let movable = file.bodies.iter().filter(|body| !body.fixed && body.motion.is_none()).count();
    let movable = movable.saturating_add(array::movable(file)).saturating_add(of_robots);
    let mut end = 0;
    file.forces.iter().position(|entry| {
        end += match &entry.kind {
            ForceKind::Drag(drag) => drag_count(drag, movable),
            _ => 1,
        };
        number < end
    })
}

/// How many forces of the engine an entry makes.
fn count(kind: &ForceKind, bodies: &[Body]) -> usize {
    match kind {
        ForceKind::Drag(drag) => drag_count(drag, bodies.iter().filter(|body| !body.is_fixed()).count()),
        _ => 1,
    }
}

fn drag_count(drag: &DragEntry, movable: usize) -> usize {
    match (&drag.body, &drag.bodies) {
        (Some(_), _) => 1,
        (None, Some(names)) => names.len(),
        (None, None) => movable,
    }
}

fn of_entry(kind: &ForceKind, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Vec<Force>, Fault> {
    Ok(match kind {
        ForceKind::PointGravity(entry) => {
            let path = path.key("point_gravity");
            let center = optional(entry.center.as_ref(), &path.key("center"))?;
            vec![Force::PointGravity { center, mu: not_negative(entry.mu, &path.key("mu"))? }]
        }
        ForceKind::MutualGravity(entry) => {
            let path = path.key("mutual_gravity").key("constant");
            vec![Force::MutualGravity { constant: not_negative(entry.constant.unwrap_or(GRAVITATION), &path)? }]
        }
        ForceKind::Force(entry) => {
            let path = path.key("force");
            vec![Force::Applied {
                body: bodies.movable(&entry.body, "force", &path.key("body"))?,
                force: vector(&entry.force, &path.key("force"))?,
                torque: DVec3::ZERO,
                frame: frame(entry.frame),
                point: entry.point.as_ref().map(|point| vector(point, &path.key("point"))).transpose()?,
                signal: signal::build(entry.signal.as_ref(), &path.key("signal"))?,
            }]
        }
        ForceKind::Torque(entry) => {
            let path = path.key("torque");
            vec![Force::Applied {
                body: bodies.movable(&entry.body, "torque", &path.key("body"))?,
                force: DVec3::ZERO,
                torque: vector(&entry.torque, &path.key("torque"))?,
                frame: frame(entry.frame),
                point: None,
                signal: signal::build(entry.signal.as_ref(), &path.key("signal"))?,
            }]
        }
        ForceKind::Drag(entry) => drag(entry, bodies, &path.key("drag"))?,
        ForceKind::Spring(entry) => vec![spring::build(entry, bodies, &path.key("spring"))?],
    })
}

fn frame(name: Option<FrameName>) -> Frame {
    match name {
        None | Some(FrameName::World) => Frame::World,
        Some(FrameName::Body) => Frame::Body,
    }
}

/// One force for each body that is dragged.
fn drag(entry: &DragEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Vec<Force>, Fault> {
    if entry.translational.is_none() && entry.rotational.is_none() {
        return Err((path.clone(), Refusal::Needs { what: "drag", needed: "`translational` or `rotational`" }));
    }
    let law = match entry.law {
        DragLawName::Linear => DragLaw::Linear,
        DragLawName::Quadratic => DragLaw::Quadratic,
    };
    let translational = not_negative(entry.translational.unwrap_or(0.0), &path.key("translational"))?;
    let rotational = not_negative(entry.rotational.unwrap_or(0.0), &path.key("rotational"))?;
    let wind = optional(entry.wind.as_ref(), &path.key("wind"))?;
    let dragged = dragged(entry, bodies, path)?;
    Ok(dragged.into_iter().map(|body| Force::Drag { body, law, translational, rotational, wind }).collect())
}

/// Numbers of the bodies that a drag names, or of all that move.
fn dragged(entry: &DragEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Vec<BodyId>, Fault> {
    match (&entry.body, &entry.bodies) {
        (Some(_), Some(_)) => Err((path.key("bodies"), Refusal::Excludes { key: "bodies", other: "body" })),
        (Some(name), None) => Ok(vec![bodies.movable(name, "drag", &path.key("body"))?]),
        (None, Some(names)) => {
            let path = path.key("bodies");
            if names.is_empty() {
                let accepted = "names of one or more bodies; every body that moves when absent".to_owned();
                return Err((path, Refusal::Type { found: "length 0".to_owned(), accepted }));
            }
            let mut numbers = Vec::with_capacity(names.len());
            let mut seen = std::collections::BTreeSet::new();
            for (index, name) in names.iter().enumerate() {
                let number = bodies.movable(name, "drag", &path.index(index))?;
                if !seen.insert(number) {
                    // Twice the drag is a larger coefficient; a name twice in one list is a slip of the pen.
                    return Err((path.index(index), Refusal::Repeated(name.clone())));
                }
                numbers.push(number);
            }
            Ok(numbers)
        }
        (None, None) => {
            let movable = bodies.all().iter().enumerate().filter(|(_, body)| !body.is_fixed());
            Ok(movable.map(|(number, _)| BodyId::new(number)).collect())
        }
    }
}

/// A vector that is zero when absent.
fn optional(value: Option<&Exactly<f64, 3>>, path: &KeyPath) -> Result<DVec3, Fault> {
    value.map_or(Ok(DVec3::ZERO), |value| vector(value, path))
}
