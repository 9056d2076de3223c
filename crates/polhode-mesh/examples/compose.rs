//! A hammer: a steel head and a wooden handle of different densities as one body, and what a coarse mesh of the handle
//! would cost beside its closed form.

use polhode_mesh::{Cuboid, Cylinder, DVec3, Density, Pose, Refinement, solid_mass_properties};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (steel, wood) = (Density::new(7850.0)?, Density::new(700.0)?);
    let head = Cuboid::new(DVec3::new(0.12, 0.03, 0.03))?.solid(steel)?;
    let handle = Cylinder::new(0.012, 0.30)?;
    // The handle hangs below the head; everything in the frame of the head.
    let below = Pose::from_translation(DVec3::Z * -0.165);
    let exact = head.combined(&handle.solid(wood)?.in_frame(&below))?;
    println!("mass            {:.4} kg", exact.mass());
    println!("centre of mass  {} m", exact.center_of_mass());
    println!("moments         {} kg m^2", exact.principal_axes().moments());
    let masses = (7850.0 * 0.12 * 0.03 * 0.03, 700.0 * std::f64::consts::PI * 0.012 * 0.012 * 0.30);
    assert!((exact.mass() - masses.0 - masses.1).abs() < 1e-15);
    let center = -0.165 * masses.1 / exact.mass();
    assert!((exact.center_of_mass() - DVec3::Z * center).length() < 1e-15);
    for level in 0..5 {
        let mesh = handle.mesh(Refinement::new(level)?)?;
        let meshed = head.combined(&solid_mass_properties(&mesh, wood)?.in_frame(&below))?;
        let error = meshed.inertia().matrix().y_axis.y / exact.inertia().matrix().y_axis.y - 1.0;
        println!("handle as a mesh of {:5} triangles: Iyy {error:+.1e}", mesh.mesh().triangles().len());
    }
    Ok(())
}
