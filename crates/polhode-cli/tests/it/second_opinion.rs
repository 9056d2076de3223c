//! `polhode run --second-opinion`.

use crate::{FLIGHT, Place};
use serde_json::Value;

/// A box that falls onto a floor and slides.
const SLIDE: &str = r#"
format = 1
name = "slide"
duration = 0.4

[method]
tier = "stepped"
step = 1e-3

[materials.wood]
friction = 0.3

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "wood"

[[bodies]]
name = "block"
mass = 2.0
shape.box.size = [0.4, 0.2, 0.1]
material = "wood"
position = [0, 0, 0.1]
velocity = [1, 0.3, 0]
angular_velocity = [0, 0, 2]
"#;

#[track_caller]
fn opinion(report: &Value) -> &Value {
    let opinion = &report["second_opinion"];
    assert!(opinion.is_object(), "{report}");
    opinion
}

/// A run by steps is repeated by the most accurate tier, and differs by what its steps cost.
#[test]
fn steps_are_held_against_the_most_accurate_tier() {
    let place = Place::with_scene(SLIDE);
    let report = place.expect(0, &["run", "scene.toml", "--second-opinion", "--json"]).json();
    let opinion = opinion(&report);
    assert_eq!((opinion["method"].as_str(), opinion["agrees"].as_bool()), (Some("tier accurate"), Some(true)));
    let largest = opinion["largest"]["of_size"].as_f64().unwrap();
    assert!(largest > 1e-9 && largest < 1e-2, "{opinion}");
    assert_eq!(opinion["bodies"].as_array().unwrap().len(), 1);
    assert_eq!(opinion["compared_until_s"].as_f64(), Some(0.4));
    let text = place.expect(0, &["run", "scene.toml", "--second-opinion"]).stdout;
    let section = text.split("\nsecond opinion\n").nth(1).unwrap();
    assert!(section.starts_with("  it agrees with the run: the largest difference is "), "{section}");
    assert!(section.contains("\n  by tier accurate\n") && section.contains("\n  block "), "{section}");
}

/// Whoever does not ask is told nothing.
#[test]
fn without_the_option_there_is_none() {
    let place = Place::with_scene(FLIGHT);
    assert!(place.expect(0, &["run", "scene.toml", "--json"]).json()["second_opinion"].is_null());
    assert!(!place.expect(0, &["run", "scene.toml"]).stdout.contains("second opinion"));
}

/// Coarse steps of the tier for real time, which says nothing of its error, are contradicted: exit code 1, which body
/// and when.
#[test]
fn coarse_steps_are_contradicted() {
    let place = Place::with_scene(&SLIDE.replace("\"stepped\"\nstep = 1e-3", "\"fast\"\nstep = 0.05"));
    let run = place.expect(1, &["run", "scene.toml", "--second-opinion"]);
    assert!(run.stdout.contains("it contradicts the run"), "{}", run.stdout);
    assert!(run.stderr.contains("a second opinion contradicts the run: 0.1"), "{}", run.stderr);
    assert!(run.stderr.contains("of the size of block"), "{}", run.stderr);
    let json = place.expect(1, &["run", "scene.toml", "--second-opinion", "--json"]).json();
    assert_eq!(opinion(&json)["agrees"].as_bool(), Some(false));
}

/// A run of the most accurate tier is repeated in the mirrored scene by another integrator.
#[test]
fn accurate_runs_are_repeated_in_a_mirror() {
    for (scene, integrator) in [(FLIGHT.to_owned(), "dop853"), (SLIDE.replace("stepped", "accurate"), "dop853")] {
        let report = Place::with_scene(&scene).expect(0, &["run", "scene.toml", "--second-opinion", "--json"]).json();
        let opinion = opinion(&report);
        let method = opinion["method"].as_str().unwrap();
        assert!(method.contains("turned, mirrored") && method.contains(integrator), "{method}");
        assert!(opinion["largest"]["of_size"].as_f64().unwrap() < 1e-9, "{opinion}");
        assert_eq!(opinion["notes"].as_array().unwrap().len(), 0, "{opinion}");
    }
}

/// Springs are repeated with the same springs, by another integrator.
#[test]
fn springs_are_repeated_with_the_same_springs() {
    let scene = SLIDE.replace("\"stepped\"\nstep = 1e-3", "\"penalty\"").replace("duration = 0.4", "duration = 0.2");
    let report = Place::with_scene(&scene).expect(0, &["run", "scene.toml", "--second-opinion", "--json"]).json();
    let method = opinion(&report)["method"].as_str().unwrap();
    assert!(method.starts_with("tier penalty") && method.contains("rk4 in the place of dop853"), "{method}");
}

/// Where impacts follow the numbers of the bodies, these stay, and the report says why.
#[test]
fn order_stays_where_impacts_follow_it() {
    let scene = SLIDE.replace("tier = \"stepped\"\nstep = 1e-3", "tier = \"accurate\"\nimpact = \"propagation\"");
    let place = Place::with_scene(&scene);
    let report = place.run(&["run", "scene.toml", "--second-opinion", "--json"]).json();
    let opinion = opinion(&report);
    let method = opinion["method"].as_str().unwrap();
    assert!(method.contains("turned, mirrored") && !method.contains("order"), "{method}");
    let notes = opinion["notes"].as_array().unwrap();
    assert!(notes.len() == 1 && notes[0].as_str().unwrap().contains("in the order of the numbers"), "{notes:?}");
}

/// A scene that no other method takes is told with the reason, and the run stands.
#[test]
fn a_run_that_nothing_repeats_keeps_its_exit_code() {
    let drawn = "tier = \"accurate\"\nimpact = \"propagation\"\npropagation_order = { random = 7 }";
    let scene = SLIDE.replace("tier = \"stepped\"\nstep = 1e-3", drawn);
    let place = Place::with_scene(&scene);
    let alone = place.run(&["run", "scene.toml", "--json"]);
    let asked = place.run(&["run", "scene.toml", "--second-opinion", "--json"]);
    assert_eq!(alone.code, asked.code);
    let json = asked.json();
    assert!(opinion(&json)["method"].is_null() && opinion(&json)["agrees"].is_null(), "{json}");
    let text = place.run(&["run", "scene.toml", "--second-opinion"]).stdout;
    assert!(text.contains("none could be had") && text.contains("draws the order"), "{text}");
}
