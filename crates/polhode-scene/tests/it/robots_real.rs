//! Robots that people use: each loads, its bodies have the mass properties that another reader finds, and it stands or
//! falls for two seconds with a ledger that closes.
//!
//! The files are not part of the project. The tests read them from the folder `robots` in the folder that the
//! environment variable `POLHODE_DATA` names, and pass with a message where there is none. It holds what three Python
//! packages hold: `pip download --no-deps example-robot-data==6.0.0 gymnasium==1.4.0 robosuite==1.5.2`, each unzipped,
//! and of the first one the folder `cmeel.prefix/share/example-robot-data`. The numbers of the other readers, Pinocchio
//! and MuJoCo, are in `fixtures/robots/mass-properties.json`.

use polhode::{Body, Simulation};
use polhode_scene::{Override, load_with};
use serde_json::Value;
use std::path::PathBuf;

/// Error of mass properties relative to the mass, the largest distance and the largest moment of a body: sums of some
/// parts, each turned by a few rotations, from numbers of two readers.
const TOLERANCE: f64 = 1e-12;

/// The folder of the robots, if there is one.
fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("POLHODE_DATA").map(|folder| PathBuf::from(folder).join("robots"));
    let found = folder.filter(|folder| folder.is_dir());
    if found.is_none() {
        eprintln!("POLHODE_DATA names no folder with `robots`: no robot is checked");
    }
    found
}

fn references() -> serde_json::Map<String, Value> {
    let text = include_str!("../../../../fixtures/robots/mass-properties.json");
    let all: Value = serde_json::from_str(text).unwrap();
    all["robots"].as_object().unwrap().clone()
}

/// The root is free, so that it is a body too where the file lets it.
fn free_root(file: &str) -> Vec<Override> {
    let held = ["gymnasium", "robosuite"].iter().any(|of_world| file.starts_with(of_world));
    let own = |key: &str, value: &str| Override::new("test", key, value);
    if held { Vec::new() } else { vec![own("models.0.base", "free")] }
}

#[test]
fn mass_properties() {
    let Some(folder) = folder() else { return };
    for (file, expected) in references() {
        let free = load_with(&folder.join(&file), &free_root(&file));
        // A root without mass cannot be free: it is the world.
        let loaded = free.or_else(|_| load_with(&folder.join(&file), &[])).unwrap_or_else(|error| panic!("{error}"));
        let (mut checked, mut worst) = (0, 0.0_f64);
        for body in loaded.scene.bodies() {
            let Some(own) = body.mass_properties() else { continue };
            let numbers: Vec<f64> = expected[body.name()]
                .as_array()
                .unwrap_or_else(|| panic!("{file}: the other reader has no body {}", body.name()))
                .iter()
                .map(|number| number.as_f64().unwrap())
                .collect();
            let [c, m] = [own.center_of_mass(), own.inertia().matrix().x_axis];
            let matrix = own.inertia().matrix();
            let found = [own.mass(), c.x, c.y, c.z, m.x, m.y, m.z, matrix.y_axis.y, matrix.y_axis.z, matrix.z_axis.z];
            let largest = |range: std::ops::Range<usize>| numbers[range].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            // Centres of mass are sums of positions in the frame of the body: of at least a centimetre.
            let scales = [largest(0..1), largest(1..4).max(1e-2), largest(4..10)];
            for (index, (found, expected)) in found.iter().zip(&numbers).enumerate() {
                let scale = scales[[0, 1, 1, 1, 2, 2, 2, 2, 2, 2][index]];
                let error = (found - expected).abs() / scale;
                worst = worst.max(error);
                assert!(error <= TOLERANCE, "{file}: {}: number {index}: {found} for {expected}", body.name());
            }
            checked += 1;
        }
        println!("{file}: {checked} bodies, largest error {worst:e}");
        assert!(checked + 1 >= expected.as_object().unwrap().len(), "{file}: {checked} bodies");
    }
}

/// Each stands or falls by time steps of 2 ms for two seconds.
#[test]
fn two_seconds() {
    let Some(folder) = folder() else { return };
    for file in references().keys() {
        let settings = [Override::new("test", "method.tier", "stepped"), Override::new("test", "method.step", "0.002")];
        let loaded = load_with(&folder.join(file), &settings).unwrap_or_else(|error| panic!("{error}"));
        let mut simulation = Simulation::new(&loaded.scene).unwrap_or_else(|error| panic!("{file}: {error}"));
        let report = simulation.run().unwrap_or_else(|error| panic!("{file}: {error}"));
        let closure = report.ledger.closure_relative();
        let moving = loaded.scene.bodies().iter().filter(|body: &&Body| !body.is_fixed()).count();
        println!("{file}: {moving} bodies, closure {closure:e}, {:?}", report.outcome);
        assert!(closure.abs() <= 1e-12, "{file}: {closure:e}");
    }
}
