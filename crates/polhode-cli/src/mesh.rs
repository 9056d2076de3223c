//! `polhode mesh`: diagnosis and mass properties of a mesh.

use crate::args::MeshArgs;
use crate::failure::Failure;
use crate::{stdout, text};
use polhode::mesh::Amount;
use polhode::spatial::{Density, Mass};
use polhode_scene::{Filling, MeshReport, read_mesh};

/// Density when none is given, kg/m^3 or kg/m^2: mass is then volume or area.
const DEFAULT_DENSITY: f64 = 1.0;

/// Reads, diagnoses and integrates; exit code 1 when the mesh has no mass properties of the kind asked for.
pub(crate) fn mesh(args: &MeshArgs) -> Result<(), Failure> {
    let filling = if args.hollow { Filling::Hollow } else { Filling::Solid };
    let amount: Amount = match (args.mass, args.density) {
        (Some(mass), _) => Mass::new(mass)?.into(),
        (None, density) => Density::new(density.unwrap_or(DEFAULT_DENSITY))?.into(),
    };
    let report = MeshReport::new(read_mesh(&args.file)?, filling, amount);
    if args.json {
        stdout::json(&report.to_json())?;
    } else {
        stdout::text(&text::mesh(&args.file, &report))?;
    }
    match report.mass_properties {
        Ok(_) => Ok(()),
        Err(error) => Err(Failure::Check(format!("error: {}: {error}", args.file.display()))),
    }
}
