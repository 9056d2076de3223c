//! Bodies that several cases are built from.

use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::{solid_box, solid_sphere};
use polhode::scene::Material;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, Geometry};
use std::error::Error;

/// A brick of the stacks: length, depth, height, m.
pub(super) const BRICK: DVec3 = DVec3::new(1.0, 0.5, 0.25);

/// Gravity of the cases, m/s^2.
pub(crate) const GRAVITY: f64 = 9.81;

/// A material of this restitution without friction. Two materials combine to the larger restitution, so that giving
/// it to one of two bodies is enough.
pub(crate) fn bouncy(restitution: f64) -> Result<Material, Box<dyn Error>> {
    Ok(Material::new(format!("e = {restitution}")).with_restitution(restitution)?)
}

/// A solid box that moves.
pub(super) fn cuboid(name: &str, size: DVec3, mass_kg: f64, center: DVec3) -> Result<Body, Box<dyn Error>> {
    let properties = solid_box(size, Mass::new(mass_kg)?)?;
    let shape = Geometry::from(Shape::cuboid(size)?);
    Ok(Body::movable(name, properties).geometry(shape).pose(Pose::from_translation(center)))
}

/// A solid sphere that moves along x.
pub(crate) fn ball_on_x(name: &str, radius: f64, mass_kg: f64, x: f64, speed: f64) -> Result<Body, Box<dyn Error>> {
    let properties = solid_sphere(radius, Mass::new(mass_kg)?)?;
    let shape = Geometry::from(Shape::sphere(radius)?);
    let velocity = Velocity::new(DVec3::X * speed, DVec3::ZERO);
    let pose = Pose::from_translation(DVec3::X * x);
    Ok(Body::movable(name, properties).geometry(shape).pose(pose).velocity(velocity))
}

/// A box that does not move.
pub(super) fn fixed_cuboid(name: &str, size: DVec3, center: DVec3) -> Result<Body, Box<dyn Error>> {
    Ok(Body::fixed(name).geometry(Shape::cuboid(size)?.into()).pose(Pose::from_translation(center)))
}

/// A floor, or a wall, through the origin.
pub(super) fn half_space(name: &str, normal: UnitVector) -> Body {
    Body::fixed(name).geometry(Shape::half_space(normal).into())
}

/// A body without a shape, of 1 kg and these principal moments, kg m^2.
pub(crate) fn rotor(name: &str, moments: DVec3, angular_velocity: DVec3) -> Result<Body, Box<dyn Error>> {
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(moments)?);
    Ok(Body::movable(name, properties).velocity(Velocity::new(DVec3::ZERO, angular_velocity)))
}
