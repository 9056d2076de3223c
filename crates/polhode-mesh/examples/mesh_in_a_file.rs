//! The mesh of a file: what is wrong with it, and the mass properties of the solid that it bounds, here a corner of a
//! cube.

use polhode_mesh::{DVec3, Mass, SolidMesh, diagnose, format, solid_mass_properties};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let file = b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    let mesh = format::read_any(file)?;
    println!("{} triangles, {} kinds of defects", mesh.triangles().len(), diagnose(&mesh).defects.len());
    let body = solid_mass_properties(&SolidMesh::new(mesh)?, Mass::new(80.0)?)?;
    println!("centre of mass {} m", body.center_of_mass());
    println!("inertia {} kg m^2", body.inertia().matrix());
    // Of mass m and edges a: a/4 along each axis; moments 3 m a^2/40, products m a^2/80 about the centre of mass.
    assert!((body.center_of_mass() - DVec3::splat(0.25)).length() < 1e-15);
    assert!((body.inertia().matrix().x_axis - DVec3::new(6.0, 1.0, 1.0)).length() < 1e-13);
    Ok(())
}
