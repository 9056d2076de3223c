//! Whether a scene moves in a vertical plane, or without gravity in any: it is seen square on then.
//!
//! Along one axis of the world, and along that one alone, all bodies that move stand at one place, have no velocity,
//! turn about it only, and have it as a principal axis of inertia; gravity does not point along it, axes of hinges do,
//! and what stands has a side square to it.

use polhode::contact::Shape;
use polhode::scene::{Joint, JointKind, Standpoint};
use polhode::spatial::DVec3;
use polhode::{Body, Geometry, Scene};

/// How far numbers may be off, as a fraction of the largest of their kind.
const OFF: f64 = 1e-4;

/// Direction from which the plane is seen square on, or nearly: the view from the front leans, so that the ground is
/// seen. None of a scene that is not plane.
pub(crate) fn square_on(scene: &Scene) -> Option<DVec3> {
    let moving = || scene.bodies().iter().filter(|body| !body.is_fixed());
    moving().next()?;
    let views = [("front", DVec3::Y), ("side", DVec3::X), ("top", DVec3::Z)];
    let mut plane = views.iter().filter(|(_, normal)| is_plane(scene, *normal));
    let (name, _) = plane.next()?;
    let is_only = plane.next().is_none();
    match Standpoint::named(name) {
        Some(Standpoint::Direction(from)) if is_only => Some(from),
        _ => None,
    }
}

fn is_plane(scene: &Scene, normal: DVec3) -> bool {
    let along = |vector: DVec3| vector.dot(normal).abs() <= OFF * vector.length();
    let across = |vector: DVec3| vector.cross(normal).length() <= OFF * vector.length();
    let moving: Vec<&Body> = scene.bodies().iter().filter(|body| !body.is_fixed()).collect();
    let places: Vec<DVec3> = moving.iter().map(|body| place(body)).collect();
    let (low, high) = places.iter().fold((places[0], places[0]), |(low, high), &p| (low.min(p), high.max(p)));
    let spread = high - low;
    let is_at_one_place = spread.dot(normal).abs() <= OFF * spread.length();
    let keeps = |body: &&Body| {
        let velocity = body.initial_velocity();
        let is_principal = body.mass_properties().is_none_or(|mass| {
            let own = body.initial_pose().rotation.inverse().rotate(normal);
            let axes = mass.principal_axes();
            let seen = axes.rotation().inverse().rotate(own);
            across_by(axes.rotation().rotate(seen * axes.moments()), own)
        });
        along(velocity.linear) && across(velocity.angular) && is_principal
    };
    let stands = |body: &Body| match body.shape() {
        Some(Geometry::Shape(Shape::HalfSpace(half_space))) => {
            along(body.initial_pose().rotation.rotate(half_space.normal()))
        }
        Some(_) => {
            let own = body.initial_pose().rotation.inverse().rotate(normal);
            own.abs().max_element() >= 1.0 - OFF
        }
        None => true,
    };
    along(scene.gravity())
        && is_at_one_place
        && moving.iter().all(keeps)
        && scene.bodies().iter().filter(|body| body.is_fixed()).all(stands)
        && scene.joints().iter().all(|joint| turns_in_it(joint, normal))
}

/// Whether two vectors are parallel.
fn across_by(vector: DVec3, other: DVec3) -> bool {
    vector.cross(other).length() <= OFF * vector.length()
}

/// The centre of mass of a body in the world at the start, m.
fn place(body: &Body) -> DVec3 {
    let center = body.mass_properties().map_or(DVec3::ZERO, polhode::spatial::MassProperties::center_of_mass);
    body.initial_pose().transform_point(center)
}

fn turns_in_it(joint: &Joint, normal: DVec3) -> bool {
    match joint.kind() {
        JointKind::Hinge { axis } => across_by(axis.get(), normal),
        JointKind::Slider { axis } => axis.get().dot(normal).abs() <= OFF,
        JointKind::Universal { .. } | JointKind::Screw { .. } => false,
        _ => true,
    }
}
