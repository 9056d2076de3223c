//! `polhode compare`: exit code 1 when trajectories differ beyond the tolerance.

use crate::{FLIGHT, Place};

/// A run agrees with itself; with another velocity it does not, and the largest difference is found.
#[test]
fn trajectories() {
    let place = Place::with_scene(FLIGHT);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    place.expect(0, &["run", "scene.toml", "-o", "same.csv"]);
    place.expect(0, &["run", "scene.toml", "-o", "b.csv", "--set", "bodies.0.velocity=[3, 0, 5]"]);
    assert_eq!(place.read("a.csv"), place.read("same.csv"));
    let same = place.expect(0, &["compare", "a.csv", "same.csv"]);
    assert!(same.stdout.contains("5 rows") && same.stdout.contains("agree within the tolerance"), "{}", same.stdout);
    let differ = place.expect(1, &["compare", "a.csv", "b.csv", "--atol", "1e-9", "--rtol", "1e-9"]);
    assert!(differ.stdout.contains("differ beyond the tolerance"), "{}", differ.stdout);
    place.expect(0, &["compare", "a.csv", "b.csv", "--atol", "1.01"]);
    place.expect(0, &["run", "scene.toml", "-o", "short.csv", "--duration", "0.25"]);
    let short = place.expect(1, &["compare", "a.csv", "short.csv"]);
    assert!(short.stdout.contains("not about the same samples"), "{}", short.stdout);
    place.expect(2, &["compare", "a.csv", "scene.toml"]);
    place.expect(2, &["compare", "a.csv", "b.csv", "--atol", "-1"]);
    place.expect(3, &["compare", "a.csv", "missing.csv"]);
}

/// Trajectories of which no row is about the same sample are told so, without a table of zeros.
#[test]
fn unrelated_trajectories_have_no_table() {
    let place = Place::with_scene(FLIGHT);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    place.write("other.toml", &FLIGHT.replace("stone", "pebble"));
    place.expect(0, &["run", "other.toml", "-o", "b.csv"]);
    let told = place.expect(1, &["compare", "a.csv", "b.csv"]).stdout;
    assert!(told.contains("not about the same samples") && told.contains("no row was compared"), "{told}");
    assert!(told.contains("stone") && told.contains("pebble") && !told.contains("largest difference"), "{told}");
}
