//! `polhode plan`.

use crate::{FLIGHT, Place};
use polhode::scene::Integrator;

/// The plan as JSON has the effects and the accelerations at t = 0: free fall, and Euler's equations for the spin.
#[test]
fn json() {
    let plan = Place::with_scene(FLIGHT).expect(0, &["plan", "scene.toml", "--json"]).json();
    assert_eq!(plan["tier"], "accurate");
    let effects = plan["effects"].as_array().unwrap();
    assert!(effects.iter().any(|effect| effect["effect"] == "gravity" && effect["decision"] == "on"));
    let acceleration = &plan["accelerations"][0];
    assert_eq!(acceleration["body"], "stone, \"flat\"");
    assert_eq!(acceleration["linear"][2], -9.81);
    assert!(acceleration["angular"].as_array().unwrap().len() == 3);
}

/// The plan for people names every effect with its reason.
#[test]
fn text() {
    let run = Place::with_scene(FLIGHT).expect(0, &["plan", "scene.toml"]);
    for part in ["scene flight", "tier", "effects", "gravity", "accelerations at t = 0", "-9.81"] {
        assert!(run.stdout.contains(part), "{part}\n{}", run.stdout);
    }
}

/// Every integrator can be asked for and is the one that the plan names; absent, the plan says why it chose one.
#[test]
fn integrators() {
    let place = Place::with_scene(FLIGHT);
    for integrator in Integrator::ALL {
        let set = format!("method.integrator={integrator}");
        let plan = place.expect(0, &["plan", "scene.toml", "--json", "--set", &set]).json();
        assert_eq!(plan["integrator"], integrator.name());
        assert_eq!(plan["integrator_reason"], "set by --set");
    }
    let plan = place.expect(0, &["plan", "scene.toml", "--json"]).json();
    assert_eq!(plan["integrator"], "exact");
    assert!(plan["integrator_reason"].as_str().is_some_and(|reason| reason.contains("closed form")));
}

/// The accelerations at t = 0 know the forces: a spring at its length at rest pulls nothing, a stretched one k x/m.
#[test]
fn forces() {
    let spring = "\n[[forces]]\ntype.spring = { body = \"stone, \\\"flat\\\"\", anchor = [0, 3, 0], stiffness = 4, \
                  rest_length = 2 }\n";
    let place = Place::with_scene(&format!("{FLIGHT}{spring}"));
    let plan = place.expect(0, &["plan", "scene.toml", "--json", "--set", "gravity=[0, 0, 0]"]).json();
    assert_eq!(plan["accelerations"][0]["linear"], serde_json::json!([0.0, 2.0, 0.0]));
    assert!(plan["effects"].as_array().unwrap().iter().any(|e| e["effect"] == "force fields" && e["decision"] == "on"));
}

/// How far what rests is from moving: a box of friction 0.5 on a floor bears half its weight as a push, 26.565 degrees
/// as a tilt, and then slides; a report of a run says so in a line.
#[test]
fn stability() {
    let scene = "format = 1\nduration = 0.1\n[materials.wood]\nfriction = 0.5\n[[bodies]]\nname = \"floor\"\n\
        fixed = true\n\
        shape.half_space.normal = [0, 0, 1]\nmaterial = \"wood\"\n[[bodies]]\nname = \"crate\"\n\
        shape.box.size = [1, 1, 0.5]\n\
        mass = 2\nposition = [0, 0, 0.25]\nmaterial = \"wood\"\n";
    let place = Place::with_scene(scene);
    let text = place.expect(0, &["plan", "scene.toml", "--stability"]).stdout;
    for part in ["stability of 1 bodies at rest, 4 contacts", "is not needed", "26.5651", "0.5000", "crate slides"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let plan = place.expect(0, &["plan", "scene.toml", "--stability", "--json"]).json();
    assert_eq!(plan["stability"]["friction_needed"], 0.0);
    let pushes = plan["stability"]["pushes"].as_array().unwrap();
    assert_eq!(pushes.len(), 8);
    for push in pushes {
        assert!((push["of_weight"].as_f64().unwrap() - 0.5).abs() < 1e-8);
        assert_eq!(push["begins"][0]["how"], "slides");
    }
    let report = place.expect(0, &["run", "scene.toml"]).stdout;
    assert!(report.contains("1 at rest; friction is not needed; tilt 26.5651 degrees towards"), "{report}");
    // Where another force acts a push is no tilt.
    let wind = "[[forces]]\ntype.force = { body = \"crate\", force = [1, 0, 0] }\n";
    let text = Place::with_scene(&format!("{scene}{wind}")).expect(0, &["plan", "scene.toml", "--stability"]).stdout;
    assert!(text.contains("a push of 0.4490 of the weight towards (1, 0, 0)"), "{text}");
    // Nothing rests in the air.
    let text = Place::with_scene(FLIGHT).expect(0, &["plan", "scene.toml", "--stability"]).stdout;
    assert!(text.contains("no body at rest touches another one"), "{text}");
}
