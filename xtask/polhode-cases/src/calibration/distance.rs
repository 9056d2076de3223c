//! How far two poses of a body are apart, of its size.

use super::known::Place;
use polhode::spatial::Pose;
use polhode::{Body, Geometry, Scene};

/// The bodies that forces move, with their sizes, m; by their numbers in the scene.
#[derive(Debug, Clone)]
pub(super) struct Sizes(Vec<Option<f64>>);

impl Sizes {
    /// Of a scene.
    pub(super) fn of(scene: &Scene) -> Self {
        Self(scene.bodies().iter().map(size).collect())
    }

    /// How far a body is from its place, of its size: what its origin is off and what its turn moves its far points.
    pub(super) fn apart(&self, place: &Place, pose: &Pose) -> f64 {
        let Some(size) = self.0.get(place.body).copied().flatten() else { return 0.0 };
        let moved = place.position.map_or(0.0, |position| (pose.translation - position).length() / size);
        let turned = place.attitude.map_or(0.0, |attitude| 0.5 * attitude.angle_to(pose.rotation));
        let apart = moved + turned;
        // What is not a number is infinitely far.
        if apart.is_nan() { f64::INFINITY } else { apart }
    }

    /// The largest distance of bodies from their places.
    pub(super) fn largest(&self, places: &[Place], row: &[Pose]) -> f64 {
        let apart = |place: &Place| row.get(place.body).map_or(f64::INFINITY, |pose| self.apart(place, pose));
        places.iter().map(apart).fold(0.0, f64::max)
    }

    /// The largest distance of bodies in two rows of poses.
    pub(super) fn between(&self, a: &[Pose], b: &[Pose]) -> f64 {
        self.largest(&places(a), b)
    }
}

/// The places of bodies in a row of poses.
pub(super) fn places(row: &[Pose]) -> Vec<Place> {
    row.iter().enumerate().map(|(body, pose)| Place::pose(body, *pose)).collect()
}

/// The size of a body that forces move, m: of its shape, or twice its largest radius of gyration.
fn size(body: &Body) -> Option<f64> {
    let properties = body.mass_properties().filter(|_| !body.is_fixed())?;
    let of_shape = match body.shape() {
        Some(Geometry::Shape(shape)) => shape.size(),
        Some(Geometry::Mesh(mesh)) => {
            let vertices = mesh.mesh().vertices();
            let low = vertices.iter().copied().reduce(glam::DVec3::min).unwrap_or_default();
            let high = vertices.iter().copied().reduce(glam::DVec3::max).unwrap_or_default();
            (high - low).length()
        }
        None => 0.0,
    };
    let of_mass = 2.0 * (properties.principal_axes().moments().z / properties.mass()).sqrt();
    Some(if of_shape > 0.0 { of_shape } else { of_mass })
}
