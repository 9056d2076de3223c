//! Mass properties of boxes, the thesis's pyramid and an L-shaped prism, near the origin and far from it.

use super::{CaseResult, Context};
use glam::{DMat3, DVec3};
use polhode::mesh::{
    SolidMesh, TriangleMesh, box_mesh, hollow_box, hollow_mass_properties, solid_box, solid_mass_properties,
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

/// Volume, centre of mass and inertia of a solid of density 1.
fn solid_rows(context: &Context, case: &str, solid: &SolidMesh, offset: DVec3) -> CaseResult {
    let properties = solid_mass_properties(solid, Density::new(1.0)?)?;
    let center = (properties.center_of_mass() - offset).to_array();
    let center_name =
        if offset == DVec3::ZERO { "solid: centre of mass, m" } else { "solid: centre of mass - offset, m" };
    let inertia = properties.inertia().matrix();
    Ok(vec![
        context.reference.row(case, "solid: volume, m^3", properties.mass())?,
        context.reference.row(case, center_name, center)?,
        context.reference.row(case, "solid: inertia xx yy zz xy xz yz, kg m^2", six(&inertia))?,
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
