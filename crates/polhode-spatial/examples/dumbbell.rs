//! A dumbbell: two balls put together as one body, whose moments are those of the balls and of Steiner's theorem.

use polhode_spatial::{DVec3, Inertia, Mass, MassProperties, Pose};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (mass, radius, apart) = (2.0, 0.1, 0.6);
    let own = 0.4 * mass * radius * radius;
    let ball = MassProperties::new(Mass::new(mass)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(own))?);
    let at = |z: f64| ball.in_frame(&Pose::from_translation(DVec3::Z * z));
    let dumbbell = at(0.0).combined(&at(apart))?;
    println!("centre of mass {} m, moments {} kg m^2", dumbbell.center_of_mass(), dumbbell.principal_axes().moments());
    assert_eq!(dumbbell.center_of_mass(), DVec3::Z * (0.5 * apart));
    let across = 2.0 * (own + mass * 0.25 * apart * apart);
    let expected = DVec3::new(2.0 * own, across, across);
    assert!((dumbbell.principal_axes().moments() - expected).length() < 1e-15);
    Ok(())
}
