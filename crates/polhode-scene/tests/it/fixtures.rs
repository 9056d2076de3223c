//! The scenes of the project load, and are what their comments say.

use polhode::Scene;
use polhode_scene::{load, load_with};
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scenes")
}

fn fixture(name: &str) -> Scene {
    load(&folder().join(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// Every scene file loads, begins with a comment, bears the name of its file, and says what it shows.
#[test]
fn all_load() {
    let mut count = 0;
    for entry in std::fs::read_dir(folder()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            let text = std::fs::read_to_string(&path).unwrap();
            assert!(text.starts_with("# "), "{} does not say what it shows", path.display());
            let loaded = load_with(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(path.file_stem().unwrap().to_str(), Some(loaded.scene.name()));
            assert_ne!(loaded.title(), loaded.scene.name());
            assert!(loaded.description().is_some_and(|text| text.ends_with('.')), "{}", path.display());
            count += 1;
        }
    }
    assert!(count >= 15, "{count} scenes");
}

/// The m-diamond has m^2 bricks, and is its own mirror image.
#[test]
fn diamonds() {
    for m in 2..=5 {
        let scene = fixture(&format!("diamond-{m}.toml"));
        let bricks = &scene.bodies()[1..];
        assert_eq!(bricks.len(), m * m);
        let places: Vec<_> = bricks.iter().map(|brick| brick.initial_pose().translation).collect();
        for place in &places {
            assert!(places.iter().any(|other| other.x == -place.x && other.z == place.z));
        }
        assert_eq!(bricks[0].name(), "r1c1");
        let top = places.iter().map(|place| place.z).fold(0.0, f64::max);
        assert_eq!(top, 0.125 + 0.25 * (2 * m - 2) as f64);
    }
}
