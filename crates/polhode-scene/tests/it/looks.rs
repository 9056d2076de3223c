//! How a scene is shown: what its file says is what pictures get, and nothing of it is part of the scene that is
//! simulated.

use crate::BASE;
use polhode::BodyId;
use polhode::scene::{BodyLook, Standpoint};
use polhode::spatial::DVec3;
use polhode_scene::load_text;

/// The scene with lines at its top and in its brick.
fn with(top: &str, brick: &str) -> String {
    let text = BASE.replace("name = \"base\"", &format!("name = \"base\"\n{top}"));
    text.replace("name = \"brick\"", &format!("name = \"brick\"\n{brick}"))
}

#[test]
fn views_and_looks() {
    let top = "view = { from = [0, -2, 0], look_at = [0, 0, 1], frame = [[1, 1, 1], [-1, -1, -1]] }";
    let text = with(top, "colour = \"#0a0B0c\"\nlabel = \"this one\"\nopacity = 0.5");
    let loaded = load_text("looks.toml", &text, &[]).unwrap();
    let appearance = loaded.appearance();
    assert_eq!(appearance.standpoint, Some(Standpoint::Direction(-DVec3::Y)));
    assert_eq!(appearance.look_at, Some(DVec3::Z));
    assert_eq!(appearance.frame, Some([-DVec3::ONE, DVec3::ONE]));
    let brick = loaded.scene.body_id("brick").unwrap();
    let look = BodyLook { color: Some([10, 11, 12]), label: Some("this one".to_owned()), opacity: 0.5 };
    assert_eq!(appearance.bodies.get(&brick), Some(&look));
    assert_eq!(appearance.bodies.len(), 1);
    // The scene that is simulated is the same, to the last digit of its text.
    let plain = load_text("looks.toml", BASE, &[]).unwrap();
    assert_eq!(format!("{:?}", loaded.scene), format!("{:?}", plain.scene));
    assert_eq!(*plain.appearance(), polhode::scene::Appearance::default());
}

#[test]
fn named_views_and_places() {
    let standpoint = |line: &str| load_text("v.toml", &with(line, ""), &[]).unwrap().appearance().standpoint;
    assert_eq!(standpoint("view.camera = \"side\""), Standpoint::named("side"));
    assert_eq!(standpoint("view.camera = [3, -4, 2.5]"), Some(Standpoint::Eye(DVec3::new(3.0, -4.0, 2.5))));
    assert_eq!(standpoint(""), None);
}

/// All bodies of an array look alike, and those of another one as they do without it.
#[test]
fn arrays_and_hidden_bodies() {
    let array = |name: &str, look: &str| {
        format!(
            "[[arrays]]\nname = \"{name}\"\n{look}\nshape.sphere.radius = 0.1\nmass = 1\nposition = [9, 0, 9]\n\
             layout.grid = {{ counts = [2, 1, 1], spacing = [1, 1, 1] }}\n"
        )
    };
    let text = format!("format = 1\n{}", array("gone", "hidden = true") + &array("plain", "").replace("9, 0", "9, 5"));
    let loaded = load_text("a.toml", &text, &[]).unwrap();
    let bodies = &loaded.appearance().bodies;
    assert_eq!(bodies.keys().copied().collect::<Vec<_>>(), [BodyId::new(0), BodyId::new(1)]);
    assert!(bodies.values().all(|look| look.opacity == 0.0));
}
