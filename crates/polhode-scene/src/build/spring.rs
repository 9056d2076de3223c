//! Springs: between two bodies, or a body and the world.

use super::bodies::Bodies;
use super::fault::{Fault, not_negative, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{Exactly, SpringEntry};
use glam::DVec3;
use polhode::Body;
use polhode::dynamics::field::FieldError;
use polhode::scene::{Attachment, Force};

const BETWEEN_BODIES: &str = "a spring between two bodies";
const TO_THE_WORLD: &str = "a spring between a body and the world";

/// The spring given at `path`.
pub(super) fn build(entry: &SpringEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Force, Fault> {
    let [a, b] = match (&entry.bodies, &entry.body) {
        (Some(_), Some(_)) => return Err((path.key("body"), Refusal::Excludes { key: "body", other: "bodies" })),
        (Some(names), None) => between_bodies(names, entry, bodies, path)?,
        (None, Some(name)) => to_the_world(name, entry, bodies, path)?,
        (None, None) => {
            let needed = "`bodies`, or `body` and `anchor`";
            return Err((path.clone(), Refusal::Needs { what: "a spring", needed }));
        }
    };
    let stiffness = not_negative(entry.stiffness, &path.key("stiffness"))?;
    let damping = not_negative(entry.damping.unwrap_or(0.0), &path.key("damping"))?;
    let rest_length = match entry.rest_length {
        Some(length) => not_negative(length, &path.key("rest_length"))?,
        // Points far from each other may have a distance beyond any number.
        None => not_negative((position(b, bodies) - position(a, bodies)).length(), path)?,
    };
    Ok(Force::Spring { a, b, stiffness, rest_length, damping })
}

fn between_bodies(
    Exactly(names): &Exactly<String, 2>,
    entry: &SpringEntry,
    bodies: &Bodies<'_>,
    path: &KeyPath,
) -> Result<[Attachment; 2], Fault> {
    let misplaced = [(entry.point.is_some(), "point"), (entry.anchor.is_some(), "anchor")];
    if let Some((_, key)) = misplaced.into_iter().find(|(given, _)| *given) {
        return Err((path.key(key), Refusal::Meaningless { key, what: BETWEEN_BODIES }));
    }
    let (path_of_bodies, path_of_points) = (path.key("bodies"), path.key("points"));
    let (a, body_a) = bodies.get(&names[0], &path_of_bodies.index(0))?;
    let (b, body_b) = bodies.get(&names[1], &path_of_bodies.index(1))?;
    if a == b {
        return Err((path_of_bodies, FieldError::SameEnds.into()));
    }
    for (index, body) in [body_a, body_b].into_iter().enumerate() {
        follows_no_motion(body, &path_of_bodies.index(index))?;
    }
    if body_a.is_fixed() && body_b.is_fixed() {
        return Err((path_of_bodies, needs_a_body_that_moves()));
    }
    let [at_a, at_b] = match &entry.points {
        Some(Exactly([a, b])) => [vector(a, &path_of_points.index(0))?, vector(b, &path_of_points.index(1))?],
        None => [DVec3::ZERO; 2],
    };
    Ok([Attachment::Body { body: a, point: at_a }, Attachment::Body { body: b, point: at_b }])
}

fn to_the_world(
    name: &str,
    entry: &SpringEntry,
    bodies: &Bodies<'_>,
    path: &KeyPath,
) -> Result<[Attachment; 2], Fault> {
    if entry.points.is_some() {
        return Err((path.key("points"), Refusal::Meaningless { key: "points", what: TO_THE_WORLD }));
    }
    let Some(anchor) = &entry.anchor else {
        return Err((path.clone(), Refusal::Needs { what: TO_THE_WORLD, needed: "`anchor`" }));
    };
    let (number, body) = bodies.get(name, &path.key("body"))?;
    follows_no_motion(body, &path.key("body"))?;
    if body.is_fixed() {
        return Err((path.key("body"), needs_a_body_that_moves()));
    }
    let point = entry.point.as_ref().map_or(Ok(DVec3::ZERO), |point| vector(point, &path.key("point")))?;
    Ok([Attachment::Body { body: number, point }, Attachment::World(vector(anchor, &path.key("anchor"))?)])
}

/// The end of a spring does not follow a prescribed motion yet.
fn follows_no_motion(body: &Body, path: &KeyPath) -> Result<(), Fault> {
    if body.motion().is_none() {
        return Ok(());
    }
    let what = format!("a spring fastened to a body with a prescribed motion ({})", body.name());
    let instead = "a spring fastened to the world, to a fixed body or to one that forces move".to_owned();
    Err((path.clone(), Refusal::NotYetAvailable { what, instead }))
}

fn needs_a_body_that_moves() -> Refusal {
    Refusal::Needs { what: "a spring", needed: "a body that moves" }
}

/// Where an end is at the start, m, world.
fn position(end: Attachment, bodies: &Bodies<'_>) -> DVec3 {
    match end {
        Attachment::World(point) => point,
        Attachment::Body { body, point } => {
            let pose = bodies.all().get(body.index()).map(Body::initial_pose);
            pose.map_or(point, |pose| pose.transform_point(point))
        }
    }
}
