//! A mesh.

use super::table::{Table, number, vector};
use polhode::mesh::RepairReport;
use polhode_scene::MeshReport;
use std::fmt::Write as _;
use std::path::Path;

/// Diagnosis and mass properties.
pub(crate) fn mesh(file: &Path, report: &MeshReport) -> String {
    let mut table = Table::default();
    table.row(["vertices", &report.vertices.to_string()]);
    table.row(["triangles", &report.triangles.to_string()]);
    table.row(["size", &format!("{} m", vector(report.size_m))]);
    table.row(["area", &format!("{} m^2", number(report.area_m2))]);
    if let Some(volume) = report.volume_m3 {
        table.row(["volume", &format!("{} m^3", number(volume))]);
    }
    if let Ok(properties) = &report.mass_properties {
        let axes = properties.principal_axes();
        let (inertia, rotation) = (properties.inertia().matrix(), axes.rotation().to_matrix());
        table.row(["mass", &format!("{} kg", number(properties.mass()))]);
        table.row(["centre of mass", &format!("{} m", vector(properties.center_of_mass()))]);
        table.row(["inertia about it", &format!("{} kg m^2", vector(inertia.row(0)))]);
        table.row(["", &vector(inertia.row(1))]);
        table.row(["", &vector(inertia.row(2))]);
        table.row(["principal moments", &format!("{} kg m^2", vector(axes.moments()))]);
        for (name, axis) in ["first axis", "second axis", "third axis"].into_iter().zip(0..) {
            table.row([name, &vector(rotation.col(axis))]);
        }
    }
    let mut page = format!("mesh {}\n{}\n", file.display(), table.print());
    if report.diagnosis.defects.is_empty() {
        page.push_str("no defects\n");
    } else {
        page.push_str("defects\n");
    }
    for defect in &report.diagnosis.defects {
        let harm = if defect.kind.prevents_solid() { "prevents a solid" } else { "harmless" };
        let offer = defect.repair().map(|repair| format!("; --repair offers {repair}")).unwrap_or_default();
        let _ = writeln!(page, "  {defect} ({harm}{offer})");
    }
    page
}

/// Size from which on a part is taken for one in millimetres, m: mesh files bear no unit, CAD programs mostly write
/// millimetres, and of the bodies that are simulated few are larger than this.
const LARGE_PART_M: f64 = 10.0;

/// What is to be said of a mesh whose unit looks like millimetres, read without a factor.
pub(crate) fn unit(report: &MeshReport) -> Option<String> {
    let size_m = report.size_m.max_element();
    (size_m >= LARGE_PART_M).then(|| {
        let mass = report
            .mass_properties
            .as_ref()
            .map_or_else(|_| String::new(), |properties| format!(" and has {} kg", number(properties.mass())));
        format!(
            "the part is {} m large{mass}: is the file in millimetres? a mesh file has no unit, and is read as metres; \
             --scale 0.001 reads it as millimetres, in a scene `scale = 0.001` beside `file`",
            number(size_m)
        )
    })
}

/// What a repair did.
pub(crate) fn repairs(report: &RepairReport) -> String {
    let mut page = "\nrepairs\n".to_owned();
    if report.steps.is_empty() {
        page.push_str("  none was needed or safe\n");
    }
    for step in &report.steps {
        let _ = writeln!(page, "  {step}");
    }
    if let (Some(before), Some(after)) = (report.volume_before, report.volume_after) {
        let _ = writeln!(page, "  volume {} m^3 before, {} m^3 after", number(before), number(after));
    }
    page
}
