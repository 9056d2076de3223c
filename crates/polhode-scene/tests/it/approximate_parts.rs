//! A mesh that stands in collisions for few convex parts: its mass stays that of the mesh, the error of the parts'
//! volume is known, and a larger one than allowed is refused with what to do.

use polhode::Geometry;
use polhode::contact::Shape;
use polhode::mesh::{Encoding, MeshFormat, Refinement, Torus, format};
use polhode_scene::load;

/// A scene with a torus from a file and these words for its approximation.
fn with_torus(approximate: &str) -> Result<polhode::Scene, String> {
    let folder = tempfile::tempdir().unwrap();
    let torus = Torus::new(1.0, 0.3).unwrap().mesh(Refinement::new(1).unwrap()).unwrap();
    let bytes = format::write(torus.mesh(), MeshFormat::Obj, Encoding::Text).unwrap();
    std::fs::write(folder.path().join("torus.obj"), bytes).unwrap();
    let path = folder.path().join("scene.toml");
    let text = format!(
        "format = 1\n[[bodies]]\nname = \"ring\"\ndensity = 1000\n\
         shape.mesh = {{ file = \"torus.obj\"{approximate} }}\n"
    );
    std::fs::write(&path, text).unwrap();
    load(&path).map_err(|error| error.to_string())
}

#[test]
fn few_parts_stand_for_a_mesh_and_their_error_is_known() {
    let exact = with_torus("").unwrap();
    let few = with_torus(", approximate = { parts = 8 }").unwrap();
    let (exact, few) = (&exact.bodies()[0], &few.bodies()[0]);
    assert_eq!(exact.approximation(), None);
    let found = few.approximation().expect("an approximation");
    let Some(Geometry::Shape(Shape::Compound(compound))) = few.shape() else { panic!("parts") };
    assert!(found.parts <= 16 && compound.parts().len() == found.parts, "{found:?}");
    assert!(found.volume_error != 0.0 && found.volume_error.abs() < 1.0, "{found:?}");
    assert_eq!(exact.mass_properties(), few.mass_properties());
}

#[test]
fn a_larger_error_than_allowed_is_refused() {
    let refusal = with_torus(", approximate = { parts = 2, error = 1e-6 }").unwrap_err();
    assert!(refusal.contains("volume") && refusal.contains("parts"), "{refusal}");
    assert!(with_torus(", approximate = { parts = 0 }").is_err());
    assert!(with_torus(", approximate = { error = -1 }").is_err());
}
