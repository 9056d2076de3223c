//! `polhode plan`.

use crate::{FLIGHT, Place};

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
