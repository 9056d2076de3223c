//! A box stands on another one, rotated by an eighth of a turn: the contact region is a regular octagon.

use polhode_contact::{DVec3, Pose, Rotation, Shape, manifold};
use std::error::Error;
use std::f64::consts::{FRAC_PI_4, SQRT_2};

fn main() -> Result<(), Box<dyn Error>> {
    let cube = Shape::cuboid(DVec3::ONE)?;
    let lower = Pose::IDENTITY;
    let upper = Pose::new(Rotation::from_rotation_vector(DVec3::Z * FRAC_PI_4), DVec3::Z);
    let touching = manifold(&cube, &upper, &cube, &lower, 1e-9);
    // Each corner of the octagon is at half a side of the square along one axis and at half a side of the octagon along
    // the other.
    let from_middle = DVec3::new(0.5, 0.5 * (SQRT_2 - 1.0), 0.5).length();
    for contact in &touching.contacts {
        let geometry = &contact.geometry;
        println!("at {:.6} m along {}, {:.0e} m apart", geometry.point, geometry.normal, geometry.separation);
        assert!((geometry.point.length() - from_middle).abs() < 1e-15);
        assert!((geometry.normal - DVec3::Z).length() < 1e-15);
    }
    assert_eq!(touching.contacts.len(), 8);
    Ok(())
}
