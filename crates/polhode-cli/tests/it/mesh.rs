//! `polhode mesh`.

use crate::{Place, fixture};

/// The L-shape of the thesis's section 3.2 (case MP-04) at density 1 and by mass.
#[test]
fn solid() {
    let place = Place::new();
    let file = fixture("meshes/l-shape.obj");
    let json = place.expect(0, &["mesh", &file, "--json"]).json();
    for key in [
        "volume_m3",
        "area_m2",
        "mass_kg",
        "center_of_mass_m",
        "inertia_kg_m2",
        "principal_moments_kg_m2",
        "principal_axes",
        "defects",
    ] {
        assert!(!json[key].is_null(), "{key} is missing");
    }
    assert!((json["volume_m3"].as_f64().unwrap() - 4.0).abs() < 1e-14);
    assert!((json["mass_kg"].as_f64().unwrap() - 4.0).abs() < 1e-14);
    let heavy = place.expect(0, &["mesh", &file, "--json", "--solid", "--mass", "8"]).json();
    assert_eq!(heavy["mass_kg"], 8.0);
    let hollow = place.expect(0, &["mesh", &file, "--json", "--hollow", "--density", "0.5"]).json();
    assert!((hollow["mass_kg"].as_f64().unwrap() - 9.0).abs() < 1e-13);
    let text = place.expect(0, &["mesh", &file]).stdout;
    for part in ["volume", "centre of mass", "(0.75, 1.25, 0.5) m", "no defects"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

/// A mesh with a hole has no mass as a solid: the check fails, and the defects are printed all the same.
#[test]
fn open() {
    let place = Place::new();
    place.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let run = place.expect(1, &["mesh", "sheet.obj", "--json"]);
    assert_eq!(run.json()["defects"][0]["kind"], "open_edge");
    assert!(run.stderr.contains("bounds no solid"), "{}", run.stderr);
    let text = place.expect(1, &["mesh", "sheet.obj"]).stdout;
    assert!(text.contains("3 open edges"), "{text}");
    place.expect(0, &["mesh", "sheet.obj", "--hollow"]);
}

/// Bad numbers and bad files.
#[test]
fn mistakes() {
    let place = Place::new();
    place.write("bad.obj", "v 0 0 zero\n");
    place.write("mesh.stl", "solid\n");
    let file = fixture("meshes/l-shape.obj");
    for args in [
        &["mesh", &file, "--mass", "-1"][..],
        &["mesh", &file, "--mass", "nan"],
        &["mesh", &file, "--density", "0"],
        &["mesh", &file, "--density", "heavy"],
        &["mesh", "bad.obj"],
        &["mesh", "mesh.stl"],
    ] {
        place.expect(2, args);
    }
    place.expect(3, &["mesh", "missing.obj"]);
}
