//! A box on a turntable runs into a wall: the time of impact on its exact path, a constant screw about the table's
//! axis.
//!
//! The cube's outer corner is at the distance r from the axis, at an angle b ahead of the cube's centre. It reaches a
//! wall at y = h when the table has turned by `asin(h/r) - b`.

use polhode_contact::{ConstantScrew, DVec3, ImpactSearch, Pose, Shape, Still, UnitVector, Velocity, find_impact};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (cube, wall) = (Shape::cuboid(DVec3::ONE)?, Shape::half_space(-UnitVector::Y));
    let (place, spin, far) = (DVec3::X * 2.0, DVec3::Z * 0.5, 1.5);
    let turning = ConstantScrew::new(0.0, Pose::from_translation(place), Velocity::new(spin.cross(place), spin))?;
    let standing = Still(Pose::from_translation(DVec3::Y * far));
    let found = find_impact(&cube, &turning, &wall, &standing, 0.0, 10.0, &ImpactSearch::default())?;
    println!("impact at {:?} s, after {} evaluations", found.time, found.evaluations);
    let corner = DVec3::new(2.5, 0.5, 0.0);
    let angle = (far / corner.length()).asin() - (corner.y / corner.x).atan();
    assert!((found.time.ok_or("it passes the wall")? - angle / spin.z).abs() < 1e-14);
    Ok(())
}
