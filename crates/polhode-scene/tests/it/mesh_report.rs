//! Diagnosis and mass properties of a mesh as JSON.

use polhode::mesh::{Amount, obj};
use polhode::spatial::{Density, Mass};
use polhode_scene::{Filling, MeshReport};

const L_SHAPE: &[u8] = include_bytes!("../../../../fixtures/meshes/l-shape.obj");
const SHEET: &[u8] = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn report(bytes: &[u8], filling: Filling, amount: impl Into<Amount>) -> MeshReport {
    MeshReport::new(obj::read(bytes).unwrap(), filling, amount.into())
}

/// The L-shape (case MP-04): volume 4, centre of mass (3/4, 5/4, 1/2), products of inertia with their sign; the columns
/// of `principal_axes` diagonalise the inertia.
#[test]
fn solid() {
    let json = report(L_SHAPE, Filling::Solid, Density::new(1.0).unwrap()).to_json();
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    assert!((number(&json["volume_m3"]) - 4.0).abs() < 1e-14);
    assert!((number(&json["area_m2"]) - 18.0).abs() < 1e-13);
    assert!((number(&json["mass_kg"]) - 4.0).abs() < 1e-14);
    assert!((number(&json["center_of_mass_m"][1]) - 1.25).abs() < 1e-14);
    assert!((number(&json["inertia_kg_m2"][0][1]) - 0.75).abs() < 1e-13);
    assert_eq!(json["defects"], serde_json::json!([]));
    let inertia = |i: usize, j: usize| number(&json["inertia_kg_m2"][i][j]);
    for axis in 0..3 {
        let moment = number(&json["principal_moments_kg_m2"][axis]);
        for row in 0..3 {
            let product: f64 = (0..3).map(|k| inertia(row, k) * number(&json["principal_axes"][k][axis])).sum();
            assert!((product - moment * number(&json["principal_axes"][row][axis])).abs() < 1e-13);
        }
    }
}

/// A sheet has no volume: no mass properties as a solid, but as a hollow body; its open edges are named.
#[test]
fn open() {
    let mass = Mass::new(2.0).unwrap();
    let solid = report(SHEET, Filling::Solid, mass);
    assert!(solid.mass_properties.is_err());
    let json = solid.to_json();
    assert!(json["volume_m3"].is_null() && json["mass_kg"].is_null());
    assert_eq!(
        (json["defects"][0]["kind"].as_str(), json["defects"][0]["count"].as_u64()),
        (Some("open_edge"), Some(3))
    );
    assert!(json["defects"][0]["where"].as_str().unwrap().contains("triangle 0"));
    let hollow = report(SHEET, Filling::Hollow, mass).to_json();
    assert_eq!((hollow["mass_kg"].as_f64(), hollow["area_m2"].as_f64()), (Some(2.0), Some(0.5)));
}
