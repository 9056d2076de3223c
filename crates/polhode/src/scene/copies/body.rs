//! Bodies in a space set otherwise: each in its own frame, mirrored where the space is.

use super::error::CopyError;
use crate::scene::{Body, BodyMass, Geometry};
use polhode_spatial::{Handedness, Isometry};

/// A body in a space set otherwise.
pub(super) fn moved(body: &Body, space: &Isometry) -> Result<Body, CopyError> {
    let Body { name, mass, geometry, pose, velocity, material, pivot, surface_velocity, approximation } = body.clone();
    let handedness = space.handedness();
    let mass = match (mass, handedness) {
        (BodyMass::Kinematic(motion), _) => BodyMass::Kinematic(motion.moved(space)),
        (BodyMass::Movable(properties), Handedness::Mirrored) => BodyMass::Movable(properties.mirrored()),
        (mass, _) => mass,
    };
    let (geometry, material) = match handedness {
        Handedness::Kept => (geometry, material),
        Handedness::Mirrored => (geometry.map(|own| mirrored(&name, &own)).transpose()?, material.mirrored()),
    };
    Ok(Body {
        name,
        mass,
        geometry,
        pose: space.pose(&pose),
        velocity: space.velocity(&velocity),
        material,
        pivot: pivot.map(|pivot| space.point(pivot)),
        surface_velocity: handedness.vector(surface_velocity),
        approximation,
    })
}

/// The mirror image of the shape of the body of this name.
fn mirrored(name: &str, geometry: &Geometry) -> Result<Geometry, CopyError> {
    let body = || name.to_owned();
    match geometry {
        Geometry::Shape(shape) => {
            let image = shape.mirrored().map_err(|source| CopyError::Shape { body: body(), source })?;
            Ok(Geometry::Shape(image))
        }
        Geometry::Mesh(mesh) => {
            let image = mesh.mirrored().map_err(|source| CopyError::Mesh { body: body(), source })?;
            Ok(Geometry::Mesh(image))
        }
    }
}
