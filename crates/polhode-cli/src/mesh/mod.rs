//! `polhode mesh`: diagnosis, repair and mass properties of a mesh; what other ways to them cost; its convex parts.
//!
//! | module | holds |
//! |---|---|
//! | `studies` | reference points and Monte Carlo, beside the exact result |
//! | `parts` | convex decomposition, exact or approximate |
//! | `output` | meshes written to files |

mod output;
mod parts;
mod studies;

use crate::failure::{self, Failure};
use crate::mesh_args::{MeshArgs, MeshRepairArgs};
use crate::progress::Progress;
use crate::{inputs, stdout, text};
use output::MeshOutput;
use parts::Parts;
use polhode::mesh::{
    Amount, MeshError, RepairOptions, RepairReport, TriangleMesh, in_principal_axes, recentered, repair,
};
use polhode::spatial::{Density, Mass};
use polhode_scene::{Filling, MeshReport, read_mesh, weld_tolerance};
use serde_json::{Value, json};
use studies::Studies;

/// Density when none is given, kg/m^3 or kg/m^2: mass is then volume or area.
const DEFAULT_DENSITY: f64 = 1.0;

/// Reads, repairs if asked to, diagnoses, integrates, decomposes and writes; exit code 1 when the mesh has no mass
/// properties of the kind asked for.
pub(crate) fn mesh(args: &MeshArgs) -> Result<(), Failure> {
    let filling = if args.hollow { Filling::Hollow } else { Filling::Solid };
    let amount: Amount = match (args.mass, args.density) {
        (Some(mass), _) => Mass::new(mass)?.into(),
        (None, density) => Density::new(density.unwrap_or(DEFAULT_DENSITY))?.into(),
    };
    let output = MeshOutput::of(&args.output)?;
    if let Some(path) = &args.output.output {
        inputs::check_output(path, [args.file.as_path()])?;
    }
    let progress = Progress::new("measuring the mesh");
    let mut mesh = read_mesh(&args.file)?;
    if let Some(factor) = args.frame.scale {
        mesh = mesh.scaled(factor)?;
    }
    let (mut mesh, repairs) = mended(mesh, &args.repair)?;
    let mut report = MeshReport::new(mesh.clone(), filling, amount);
    if let (true, Ok(body)) = (args.frame.recentre || args.frame.principal, &report.mass_properties) {
        mesh = if args.frame.principal { in_principal_axes(&mesh, body)? } else { recentered(&mesh, body)? };
        report = MeshReport::new(mesh.clone(), filling, amount);
    }
    let (parts, studies) = if report.mass_properties.is_ok() {
        (Parts::of(&args.studies, &mesh)?, Studies::of(args, &mesh, amount, &progress)?)
    } else {
        (None, Studies::default())
    };
    drop(progress);
    match (&output, &parts) {
        (Some(output), Some(parts)) => output.write_parts(parts.meshes())?,
        // What could not be repaired whole is written all the same: its defects are in the report.
        (Some(output), None) => output.write(&mesh)?,
        (None, _) => {}
    }
    if args.json {
        let mut value = report.to_json();
        if let Some(repairs) = &repairs {
            value["repairs"] = repairs_json(repairs);
        }
        studies.add_to_json(&mut value);
        if let Some(parts) = &parts {
            value["decomposition"] = parts.to_json();
        }
        stdout::json(&value)?;
    } else {
        if let (None, Some(unit)) = (args.frame.scale, text::unit(&report)) {
            failure::remark(&format!("note: {}: {unit}", args.file.display()));
        }
        let repairs = repairs.as_ref().map(text::repairs).unwrap_or_default();
        let parts = parts.as_ref().map(Parts::text).unwrap_or_default();
        stdout::text(&format!("{}{repairs}{}{parts}", text::mesh(&args.file, &report), studies.text(args)))?;
    }
    match report.mass_properties {
        Ok(_) => Ok(()),
        Err(error) => {
            let file = args.file.display();
            let cure = match &error {
                MeshError::Seams { distance_m, .. } => {
                    let within = weld_tolerance(*distance_m);
                    format!("\nhelp: to merge them: `polhode mesh {file} --repair{within} -o MENDED.obj`")
                }
                _ => String::new(),
            };
            Err(Failure::Check(format!("error: {file}: {error}{cure}")))
        }
    }
}

/// The mesh repaired, with what was done, if that is asked for.
fn mended(mesh: TriangleMesh, args: &MeshRepairArgs) -> Result<(TriangleMesh, Option<RepairReport>), Failure> {
    if !args.repair {
        return Ok((mesh, None));
    }
    let options = RepairOptions { weld_tolerance: args.weld_tolerance, largest_hole: args.largest_hole };
    let (mesh, report) = repair(&mesh, &options)?;
    Ok((mesh, Some(report)))
}

fn repairs_json(report: &RepairReport) -> Value {
    let step = |step: &polhode::mesh::RepairStep| {
        json!({
            "repair": step.repair.name(), "count": step.count, "triangles": step.triangles
        })
    };
    json!({
        "steps": report.steps.iter().map(step).collect::<Vec<_>>(),
        "volume_before_m3": report.volume_before,
        "volume_after_m3": report.volume_after,
    })
}
