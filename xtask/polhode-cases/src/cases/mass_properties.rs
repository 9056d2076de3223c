//! Mass properties of polyhedra: boxes, the thesis's pyramid, a published tetrahedron, an L-shaped prism near the
//! origin and far from it, slivers, a needle and a plate; each by the library and by the program.

use super::mesh_program::{Reported, report};
use super::{CaseResult, Context};
use crate::row::{Row, Value};
use glam::{DMat3, DVec3};
use polhode::mesh::{
    SolidMesh, TriangleMesh, VolumeIntegrals, box_mesh, hollow_box, hollow_mass_properties, obj, solid_box,
    solid_mass_properties,
};
use polhode::spatial::{Density, Mass, MassProperties};
use std::error::Error;

/// Box of edges 1, 2, 3 m and 6 kg, solid and hollow, in closed form and as a mesh.
pub(super) fn mp_01(context: &Context) -> CaseResult {
    let (size, mass) = (DVec3::new(1.0, 2.0, 3.0), Mass::new(6.0)?);
    let mesh = box_mesh(size)?;
    let reference = &context.reference;
    let solid = "solid: moments, kg m^2";
    let hollow = "hollow: moments, kg m^2";
    let mut rows = vec![
        reference.row("MP-01", solid, diagonal(&solid_box(size, mass)?))?,
        reference.row("MP-01", solid, diagonal(&solid_mass_properties(&mesh, mass)?))?,
        reference.row("MP-01", hollow, diagonal(&hollow_box(size, mass)?))?,
        reference.row("MP-01", hollow, diagonal(&hollow_mass_properties(mesh.mesh(), mass)?))?,
    ];
    for (row, how) in rows.iter_mut().zip(["formula", "mesh", "formula", "mesh"]) {
        row.quantity = format!("{} ({how})", row.quantity);
    }
    let moments = |reported: &Reported| Ok::<_, Box<dyn Error>>(reported.six("inertia_kg_m2")?[..3].to_vec());
    for (quantity, filling) in [(solid, "--solid"), (hollow, "--hollow")] {
        let reported = report(context, "MP-01", mesh.mesh(), &["--mass", "6", filling])?;
        rows.push(by_program(reference.row("MP-01", quantity, Value::Numbers(moments(&reported)?))?));
    }
    // A shell of 1 kg/m^2 weighs its area.
    let shell = hollow_mass_properties(mesh.mesh(), Density::new(1.0)?)?;
    rows.push(reference.row("MP-01", "hollow: area, m^2", shell.mass())?);
    Ok(rows)
}

/// The pyramid of the thesis's Figure 8 (with its erratum E4).
pub(super) fn mp_02(context: &Context) -> CaseResult {
    let corners = [[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 5.0, 0.0], [0.0, 5.0, 0.0], [2.5, 2.5, 4.0]];
    let triangles = vec![[0, 2, 1], [0, 3, 2], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let solid = SolidMesh::new(TriangleMesh::new(corners.map(DVec3::from_array).to_vec(), triangles)?)?;
    let density = Density::new(1.0)?;
    let mut rows = solid_rows(context, "MP-02", &solid, DVec3::ZERO)?;
    let shell = hollow_mass_properties(solid.mesh(), density)?;
    let inertia = shell.inertia().matrix() * shell.mass().recip();
    let reference = &context.reference;
    rows.push(reference.row("MP-02", "hollow: area, m^2", shell.mass())?);
    rows.push(reference.row("MP-02", "hollow: height of the centre of mass, m", shell.center_of_mass().z)?);
    rows.push(reference.row("MP-02", "hollow: inertia / mass xx zz, m^2", [inertia.x_axis.x, inertia.z_axis.z])?);
    Ok(rows)
}

/// An L-shaped prism, which is not convex.
pub(super) fn mp_04(context: &Context) -> CaseResult {
    solid_rows(context, "MP-04", &l_prism(DVec3::ZERO)?, DVec3::ZERO)
}

/// The same prism four thousand kilometres away: nothing may cancel.
pub(super) fn mp_05(context: &Context) -> CaseResult {
    /// Exactly representable, and so are the prism's corners beside it.
    const OFFSET: DVec3 = DVec3::new(1e6, -2e6, 3e6);
    solid_rows(context, "MP-05", &l_prism(OFFSET)?, OFFSET)
}

/// The published worked example of Tonon 2004.
pub(super) fn mp_03(context: &Context) -> CaseResult {
    let corners = [[8.3322, -11.86875, 0.93355], [0.75523, 5.0, 16.37072], [52.61236, 5.0, -5.3858], [2.0, 5.0, 3.0]];
    let triangles = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let mesh = TriangleMesh::new(corners.map(DVec3::from_array).to_vec(), triangles)?;
    let outward = if VolumeIntegrals::of(&mesh).volume > 0.0 { mesh } else { mesh.flipped() };
    solid_rows(context, "MP-03", &SolidMesh::new(outward)?, DVec3::ZERO)
}

/// A cube whose top is cut into slivers of aspect 1e9.
pub(super) fn mp_06(context: &Context) -> CaseResult {
    const FILE: &[u8] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 1e-9 0 1\n\
        v 0.999999999 0 1\nf 1 4 3 2\nf 8 5 9 10 6 7\nf 1 2 6 10 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let solid = SolidMesh::new(obj::read(FILE)?)?;
    let properties = solid_mass_properties(&solid, Density::new(1.0)?)?;
    let reported = report(context, "MP-06", solid.mesh(), &[])?;
    let reference = &context.reference;
    let (volume, moments) = ("solid: volume, m^3", "solid: moments, kg m^2");
    Ok(vec![
        reference.row("MP-06", volume, properties.mass())?,
        reference.row("MP-06", moments, diagonal(&properties))?,
        by_program(reference.row("MP-06", volume, reported.number("volume_m3")?)?),
        by_program(reference.row("MP-06", moments, Value::Numbers(reported.six("inertia_kg_m2")?[..3].to_vec()))?),
    ])
}

/// Boxes of edges in the ratio of a million: the small moment keeps its digits beside one 5e11 times larger.
pub(super) fn mp_12(context: &Context) -> CaseResult {
    /// Edges, m.
    const THIN: f64 = 1e-6;
    let mass = Mass::new(1.0)?;
    let mut rows = Vec::new();
    for (quantity, size) in [
        ("needle: moments, kg m^2", DVec3::new(1.0, THIN, THIN)),
        ("plate: moments, kg m^2", DVec3::new(1.0, 1.0, THIN)),
    ] {
        let mesh = box_mesh(size)?;
        let moments = |body: MassProperties| body.principal_axes().moments().to_array();
        let reported = report(context, "MP-12", mesh.mesh(), &["--mass", "1"])?;
        let row = |measured: [f64; 3]| context.reference.row("MP-12", quantity, measured);
        let mut three = [
            row(moments(solid_box(size, mass)?))?,
            row(moments(solid_mass_properties(&mesh, mass)?))?,
            row(reported.vector("principal_moments_kg_m2")?)?,
        ];
        for (row, how) in three.iter_mut().zip(["formula", "mesh", "program"]) {
            row.quantity = format!("{} ({how})", row.quantity);
        }
        rows.extend(three);
    }
    Ok(rows)
}

/// The row, marked as what the program printed.
fn by_program(mut row: Row) -> Row {
    row.quantity.push_str(" (program)");
    row
}

/// Volume, centre of mass and inertia of a solid of density 1, by the library and by the program.
fn solid_rows(context: &Context, case: &str, solid: &SolidMesh, offset: DVec3) -> CaseResult {
    let properties = solid_mass_properties(solid, Density::new(1.0)?)?;
    let center_name =
        if offset == DVec3::ZERO { "solid: centre of mass, m" } else { "solid: centre of mass - offset, m" };
    let (volume, inertia) = ("solid: volume, m^3", "solid: inertia xx yy zz xy xz yz, kg m^2");
    let reported = report(context, case, solid.mesh(), &[])?;
    let center = |center: DVec3| (center - offset).to_array();
    let reference = &context.reference;
    Ok(vec![
        reference.row(case, volume, properties.mass())?,
        reference.row(case, center_name, center(properties.center_of_mass()))?,
        reference.row(case, inertia, six(&properties.inertia().matrix()))?,
        by_program(reference.row(case, volume, reported.number("volume_m3")?)?),
        by_program(reference.row(
            case,
            center_name,
            center(DVec3::from_array(reported.vector("center_of_mass_m")?)),
        )?),
        by_program(reference.row(case, inertia, reported.six("inertia_kg_m2")?)?),
    ])
}

/// The prism over the outline of an L, one metre high, as one mesh.
pub(super) fn l_prism(offset: DVec3) -> Result<SolidMesh, Box<dyn Error>> {
    const OUTLINE: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    /// The outline's triangles, anticlockwise from above.
    const CAP: [[u32; 3]; 4] = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
    let corner = |[x, y]: [f64; 2], z: f64| offset + DVec3::new(x, y, z);
    let mut vertices: Vec<DVec3> = OUTLINE.iter().map(|&at| corner(at, 0.0)).collect();
    vertices.extend(OUTLINE.iter().map(|&at| corner(at, 1.0)));
    let mut triangles: Vec<[u32; 3]> = CAP.iter().map(|&[a, b, c]| [a, c, b]).collect();
    triangles.extend(CAP.iter().map(|&[a, b, c]| [a + 6, b + 6, c + 6]));
    for i in 0..6 {
        let j = (i + 1) % 6;
        triangles.extend([[i, j, j + 6], [i, j + 6, i + 6]]);
    }
    Ok(SolidMesh::new(TriangleMesh::new(vertices, triangles)?)?)
}

fn diagonal(properties: &MassProperties) -> [f64; 3] {
    let inertia = properties.inertia().matrix();
    [inertia.x_axis.x, inertia.y_axis.y, inertia.z_axis.z]
}

/// Elements xx, yy, zz, xy, xz, yz of the matrix.
fn six(m: &DMat3) -> [f64; 6] {
    [m.x_axis.x, m.y_axis.y, m.z_axis.z, m.x_axis.y, m.x_axis.z, m.y_axis.z]
}
