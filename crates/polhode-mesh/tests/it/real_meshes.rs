//! Files that other people made, against exact rational arithmetic over their decimal coordinates.
//!
//! The files are not part of the project. The test reads them from the folder `meshes` in the folder that the
//! environment variable `POLHODE_DATA` names (common 3D test models: spot, cow, fandisk, suzanne, teapot,
//! stanford-bunny), and passes with a message where it is not set.

use crate::shapes::{assert_matrix, assert_relative, assert_vector, symmetric, unit_density};
use polhode_mesh::{
    DefectKind, RepairOptions, SolidMesh, TriangleMesh, diagnose, hollow_mass_properties, obj, repair,
    solid_mass_properties,
};
use polhode_spatial::DVec3;
use std::path::PathBuf;

/// A mesh from the data folder, if there is one.
pub(crate) fn real_mesh(name: &str) -> Option<TriangleMesh> {
    let Some(folder) = std::env::var_os("POLHODE_DATA") else {
        eprintln!("POLHODE_DATA is not set: {name} is not checked");
        return None;
    };
    let path = PathBuf::from(folder).join("meshes").join(format!("{name}.obj"));
    let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    Some(obj::read(&bytes).unwrap_or_else(|error| panic!("{name}: {error}")))
}

/// A sum of n terms that are right to a few roundings each; the meshes have thin triangles and 6 digits, and the exact
/// values are themselves given to 16 digits.
const TOLERANCE: f64 = 1e-13;

#[track_caller]
fn check(name: &str, counts: (usize, usize), volume: f64, center: [f64; 3], inertia: [f64; 6]) {
    let Some(mesh) = real_mesh(name) else { return };
    assert_eq!((mesh.vertices().len(), mesh.triangles().len()), counts);
    let size = mesh.bounds().diagonal();
    let solid = SolidMesh::new(mesh).unwrap();
    let body = solid_mass_properties(&solid, unit_density()).unwrap();
    let expected = symmetric(inertia);
    let element_error = body.inertia().matrix() - expected;
    println!(
        "{name}: volume {:e} relative, centre {:e} m, inertia {:e} of {:e} kg m^2",
        (body.mass() / volume - 1.0).abs(),
        body.center_of_mass().distance(DVec3::from_array(center)),
        element_error.to_cols_array().into_iter().fold(0.0f64, |l, x| l.max(x.abs())),
        expected.x_axis.x,
    );
    assert_relative(body.mass(), volume, TOLERANCE);
    assert_vector(body.center_of_mass(), DVec3::from_array(center), size, TOLERANCE);
    // The data list products with the minus that the inertia matrix holds.
    assert_matrix(body.inertia().matrix(), expected, TOLERANCE);
}

#[test]
fn spot() {
    check(
        "spot",
        (2930, 5856),
        0.7182587880998647,
        [-1.2181140881323191e-06, -0.01034409944505179, 0.18827705913637519],
        [
            0.2093238290204056,
            0.14524430573026872,
            0.11351533611844758,
            7.417581546667056e-08,
            -8.981526288056477e-07,
            0.062303686433824654,
        ],
    );
}

#[test]
fn cow() {
    check(
        "cow",
        (2903, 5804),
        53.567445842479465,
        [-0.1333631443359454, 0.011348952559827721, -0.00013920765176156824],
        [
            80.17232633437972,
            273.60540943371944,
            305.4275204198969,
            -28.397104708674807,
            -0.03268458990259311,
            -0.005113611370883119,
        ],
    );
}

#[test]
fn fandisk() {
    check(
        "fandisk",
        (6475, 12946),
        20.243374882839458,
        [2.349991377640997, 14.776965377268759, -0.9699008236360911],
        [
            31.059486507867238,
            35.22522148278589,
            44.95313324987346,
            -6.275131365198495,
            -6.388144128396545,
            -5.011284781685568,
        ],
    );
}

/// Real files with holes: as many open edges as a count by hand gives, no solid, but hollow bodies.
#[test]
fn open_files() {
    for (name, open_edges) in [("suzanne", 42), ("teapot", 1036), ("stanford-bunny", 223)] {
        let Some(mesh) = real_mesh(name) else { continue };
        let diagnosis = diagnose(&mesh);
        println!("{name}: {:?}", diagnosis.defects.iter().map(ToString::to_string).collect::<Vec<_>>());
        assert_eq!(diagnosis.get(DefectKind::OpenEdge).map(|defect| defect.count), Some(open_edges));
        assert!(SolidMesh::new(mesh.clone()).is_err());
        assert!(hollow_mass_properties(&mesh, unit_density()).is_ok());
    }
}

/// What repair makes of them: the closed ones stay as they are, bit by bit; of the others it is printed what was done
/// and what is left.
#[test]
fn repair_of_real_files() {
    for name in ["spot", "cow", "fandisk", "suzanne", "teapot", "stanford-bunny"] {
        let Some(mesh) = real_mesh(name) else { continue };
        for largest_hole in [0.25, 1.0] {
            let (mended, report) = repair(&mesh, &RepairOptions { largest_hole, ..RepairOptions::default() }).unwrap();
            println!("{name}, holes up to {largest_hole}:");
            report.before.defects.iter().for_each(|defect| println!("  found: {defect}"));
            report.steps.iter().for_each(|step| println!("  {step}"));
            report.after.defects.iter().for_each(|defect| println!("  left: {defect}"));
            println!("  volume {:?} -> {:?}", report.volume_before, report.volume_after);
            if report.before.is_solid() {
                assert_eq!(mended, mesh);
            }
            // The holes of the scan are small; a pot is open at its lid and spout, which only a larger size fills; an
            // edge of more than two triangles in the monkey's head cannot be mended and is left, its holes are filled.
            let is_left = matches!((name, largest_hole), ("suzanne", _) | ("teapot", 0.25));
            assert_eq!(report.after.is_solid(), !is_left, "{name}");
            if name == "suzanne" {
                assert!(report.after.get(DefectKind::OpenEdge).is_none());
                assert_eq!(report.after.get(DefectKind::NonManifoldEdge).map(|defect| defect.count), Some(1));
            }
        }
    }
}
