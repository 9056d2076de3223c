//! A body: its pose, motion, shape and mass.

use super::fault::{Fault, vector};
use super::materials::Materials;
use super::matter::Matter;
use super::shape::{self, Form, Mobility};
use super::{mass, motion, pivot, placement};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::files::SceneFolder;
use crate::format::{BodyEntry, Exactly};
use glam::DVec3;
use polhode::spatial::{Inertia, Mass, MassProperties, Velocity};
use polhode::{Body, SceneError};

/// The body given at `path`.
pub(super) fn build(
    entry: &BodyEntry,
    materials: &Materials,
    folder: &SceneFolder,
    path: &KeyPath,
) -> Result<Body, Fault> {
    let mobility = if entry.fixed || entry.motion.is_some() { Mobility::Fixed } else { Mobility::Moves };
    let form =
        entry.shape.as_ref().map(|shape| shape::build(shape, mobility, folder, &path.key("shape"))).transpose()?;
    let (position, orientation) = (entry.position.as_ref(), entry.orientation.as_ref());
    let pose = placement::pose(position, orientation, entry.rotation_vector.as_ref(), path)?;
    let mut body = if let Some(motion) = &entry.motion {
        motion::body(entry, motion, pose, path)?
    } else if entry.fixed {
        fixed(entry, path)?.pose(pose)
    } else {
        if matches!(form, Some(Form { matter: Matter::HalfSpace, .. })) {
            return Err((path.key("shape"), SceneError::MovingHalfSpace(entry.name.clone()).into()));
        }
        Body::movable(&entry.name, mass::build(entry, form.as_ref().map(|form| &form.matter), path)?).pose(pose)
    };
    let velocity = optional(entry.velocity.as_ref(), path, "velocity")?;
    let angular_velocity = optional(entry.angular_velocity.as_ref(), path, "angular_velocity")?;
    if let Some(pivot) = &entry.pivot {
        let pivot = vector(pivot, &path.key("pivot"))?;
        body = body.velocity(Velocity::new(DVec3::ZERO, angular_velocity)).pivot(pivot);
        if entry.velocity.is_some() {
            pivot::check_velocity(&body, pivot, velocity, &path.key("velocity"))?;
        }
    } else {
        body = body.velocity(Velocity::new(velocity, angular_velocity));
    }
    body = body.surface_velocity(optional(entry.surface_velocity.as_ref(), path, "surface_velocity")?);
    if let Some(material) = &entry.material {
        body = body.material(materials.get(material, &path.key("material"))?);
    }
    if let Some(form) = form {
        if let Some(approximation) = form.approximation {
            body = body.approximated(approximation);
        }
        body = body.geometry(form.geometry);
    }
    Ok(body)
}

/// A body in the place of one that is refused, so that what names it can be looked at.
pub(super) fn stand_in(entry: &BodyEntry) -> Body {
    let unit = Mass::new(1.0).ok().zip(Inertia::from_diagonal(DVec3::ONE).ok());
    match unit {
        Some((mass, inertia)) if !entry.fixed => {
            Body::movable(&entry.name, MassProperties::new(mass, DVec3::ZERO, inertia))
        }
        _ => Body::fixed(&entry.name),
    }
}

/// A fixed body has no mass, no velocity and no pivot.
fn fixed(entry: &BodyEntry, path: &KeyPath) -> Result<Body, Fault> {
    let moves = |velocity: &Option<Exactly<f64, 3>>| velocity.as_ref().is_some_and(|v| v.0 != [0.0; 3]);
    let meaningless = [
        (entry.mass.is_some(), "mass"),
        (entry.density.is_some(), "density"),
        (entry.inertia.is_some(), "inertia"),
        (entry.center_of_mass.is_some(), "center_of_mass"),
        (entry.hollow, "hollow"),
        (entry.pivot.is_some(), "pivot"),
        (moves(&entry.velocity), "velocity"),
        (moves(&entry.angular_velocity), "angular_velocity"),
    ];
    match meaningless.into_iter().find(|(given, _)| *given) {
        Some((_, key)) => Err((path.key(key), Refusal::Meaningless { key, what: "a fixed body" })),
        None => Ok(Body::fixed(&entry.name)),
    }
}

/// A vector that is zero when absent.
fn optional(value: Option<&Exactly<f64, 3>>, path: &KeyPath, key: &'static str) -> Result<DVec3, Fault> {
    value.map_or(Ok(DVec3::ZERO), |value| vector(value, &path.key(key)))
}
