//! An untouched run has the strict hash of any other run. Going back and on again repeats all bits, with actions too.
//! A hand lifts a body by a spring; friction that is changed acts as friction that was there from the start. Forces add
//! up to `m a`.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use super::playground::Playground;
use polhode::spatial::DVec3;
use polhode::{RunHash, Simulation};
use polhode_scene::{Override, load_text};

fn shipped(name: &str) -> String {
    let file = format!("{}/../../fixtures/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(file).unwrap()
}

fn playing(text: &str, changes: &[(&str, &str)]) -> Playground {
    let changes: Vec<Override> = changes.iter().map(|(key, value)| Override::new("test", *key, *value)).collect();
    Playground::new("scene", text, &[], &changes).unwrap()
}

fn to_end(own: &mut Playground) {
    while !own.has_ended() {
        own.step().unwrap();
    }
}

/// A brick that slides on a floor.
const SLIDING: &str = r#"
    format = 1
    duration = 1.0
    [materials.wood]
    friction = 0.3
    [[bodies]]
    name = "floor"
    fixed = true
    shape.half_space.normal = [0, 0, 1]
    material = "wood"
    [[bodies]]
    name = "brick"
    shape.box.size = [0.2, 0.1, 0.1]
    mass = 2.0
    position = [0, 0, 0.05]
    velocity = [2, 0, 0]
    material = "wood"
"#;

#[test]
fn an_untouched_run_has_the_strict_hash_of_the_scene() {
    for name in ["bouncing-ball", "box-drop", "newtons-cradle", "double-pendulum", "fast-pyramid"] {
        let text = shipped(name);
        let mut hash = RunHash::default();
        Simulation::new(&load_text("scene", &text, &[]).unwrap().scene).unwrap().run_observed(&mut hash).unwrap();
        let mut own = playing(&text, &[]);
        to_end(&mut own);
        assert_eq!(own.hash().value(), hash.value(), "{name}");
        assert!(own.is_untouched());
    }
}

#[test]
fn going_back_and_on_repeats_all_bits() {
    for tier in ["accurate", "stepped", "fast"] {
        let mut own = playing(&shipped("box-drop"), &[("method.tier", tier), ("duration", "1.0")]);
        to_end(&mut own);
        let (hash, bodies) = (own.hash().value(), own.bodies());
        for t_s in [0.7, 0.3, 0.0] {
            own.rewind(t_s).unwrap();
            assert!(own.time() <= t_s, "{tier}");
            to_end(&mut own);
            assert_eq!((own.hash().value(), own.bodies()), (hash, bodies.clone()), "{tier} from {t_s}");
        }
        assert!(own.is_untouched());
    }
}

#[test]
fn actions_are_repeated_when_going_back() {
    for tier in ["accurate", "stepped", "fast"] {
        let mut own = playing(SLIDING, &[("method.tier", tier)]);
        while own.time() < 0.2 {
            own.step().unwrap();
        }
        own.push(1, DVec3::new(0.3, 0.0, 0.05), DVec3::X).unwrap();
        own.set_friction(0.1).unwrap();
        own.grab(1, own.bodies()[1].pose.translation).unwrap();
        own.pull(own.bodies()[1].pose.translation + DVec3::Z * 0.2);
        while own.time() < 0.5 {
            own.step().unwrap();
        }
        own.release().unwrap();
        let mut passed = Vec::new();
        while !own.has_ended() {
            own.step().unwrap();
            passed.push((own.time(), own.bodies()));
        }
        for t_s in [0.8, 0.6] {
            let reached_s = own.rewind(t_s).unwrap();
            let (_, bodies) = passed.iter().rfind(|(own_s, _)| *own_s <= t_s).unwrap();
            assert_eq!(&own.bodies(), bodies, "{tier} at {reached_s}");
            assert!(!own.is_untouched());
        }
        own.rewind(0.4).unwrap();
        assert!(own.held().is_none() && own.time() > 0.3, "{tier}");
        own.rewind(0.1).unwrap();
        assert!(own.is_untouched(), "{tier}");
        assert!((own.materials()[0].friction() - 0.3).abs() < 1e-15, "{tier}");
    }
}

#[test]
fn a_hand_lifts_a_body_and_holds_its_weight() {
    for tier in ["accurate", "stepped", "fast"] {
        let mut own =
            playing(SLIDING, &[("method.tier", tier), ("duration", "4.0"), ("bodies.brick.velocity", "[0,0,0]")]);
        let start = own.bodies()[1].pose.translation;
        own.grab(1, start + DVec3::Z * 0.05).unwrap();
        own.pull(start + DVec3::Z * 0.55);
        to_end(&mut own);
        // The spring, whose force is taken at the end of a step, is stretched by g / w^2 (1 + w h)^2.
        let rate = 2.0 * std::f64::consts::TAU;
        let low = 9.81 * (rate.recip() + 1.0 / 120.0).powi(2);
        let rise = own.bodies()[1].pose.translation.z - start.z;
        assert!((rise - (0.5 - low)).abs() < 1e-3, "{tier}: {rise}");
        let (_, force) = own.held().unwrap();
        assert!((force - DVec3::Z * 2.0 * 9.81).length() < 0.05, "{tier}: {force}");
    }
}

#[test]
fn friction_that_is_changed_acts_as_friction_that_was_there() {
    for tier in ["accurate", "stepped", "fast"] {
        let mut changed = playing(SLIDING, &[("method.tier", tier)]);
        changed.set_friction(0.1).unwrap();
        let mut given = playing(SLIDING, &[("method.tier", tier), ("materials.wood.friction", "0.1")]);
        to_end(&mut changed);
        to_end(&mut given);
        let slid = |own: &Playground| own.bodies()[1].pose.translation.x;
        assert!((slid(&changed) - slid(&given)).abs() < 1e-6, "{tier}: {} {}", slid(&changed), slid(&given));
        assert!(slid(&changed) > 1.4, "{tier}");
    }
}

#[test]
fn restitution_that_is_changed_acts_at_the_next_impact() {
    for tier in ["accurate", "stepped", "fast"] {
        let mut own = playing(&shipped("bouncing-ball"), &[("method.tier", tier)]);
        own.set_restitution(0.0).unwrap();
        to_end(&mut own);
        let energy = own.told_json().unwrap();
        assert!(energy["kinetic_j"].as_f64().unwrap() < 1e-9, "{tier}: {energy}");
    }
}

#[test]
fn forces_on_a_body_add_up() {
    let mut own = playing(SLIDING, &[("method.tier", "accurate")]);
    own.step().unwrap();
    let (forces, total) = own.forces_on(1).unwrap();
    let sum: DVec3 = forces.iter().map(|force| force.force_n).sum();
    assert!((sum - total).length() < 1e-9, "{sum} {total}");
    assert!((total - DVec3::X * (-0.3 * 2.0 * 9.81)).length() < 1e-9);
    assert!(forces.iter().filter_map(|force| force.cone).all(|cone| cone.is_used_up()));
}

#[test]
fn what_cannot_be_done_says_why_and_changes_nothing() {
    let mut own = playing(SLIDING, &[]);
    let words = |result: Result<(), super::PlayError>| result.unwrap_err().to_string();
    assert!(words(own.grab(0, DVec3::ZERO)).contains("forces do not move it"));
    assert!(words(own.grab(7, DVec3::ZERO)).contains("the scene has 2 bodies"));
    assert!(words(own.set_friction(-1.0)).contains("friction"));
    assert!(words(own.set_restitution(1.5)).contains("restitution"));
    assert!(words(own.rewind(3.0).map(|_| ())).contains("has reached 0 s"));
    assert!(own.is_untouched());
}
