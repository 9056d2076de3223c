//! Scene files in, trajectories out: what is accepted, what is refused and how, and what is written.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod approximate_parts;
mod arrays;
mod comparison;
mod documentation;
mod fixtures;
mod forces;
mod format;
mod landing_at_a_stop;
mod looks;
mod loop_hits_its_stop;
mod mass;
mod mesh_report;
mod motions;
mod outputs;
mod overrides;
mod pivots;
mod refusals;
mod robots;
mod robots_bad;
mod robots_doctor;
mod robots_drives;
mod robots_mjcf;
mod robots_real;
mod robustness;
mod ropes_that_go_taut;
mod schema;
mod slips_that_stop;
mod steps_of_heaps;
mod trajectories;

use polhode::Scene;
use polhode_scene::{Refused, SceneFileError, load_text};

/// A scene of a floor and a brick that every test changes a little.
pub(crate) const BASE: &str = r#"
format = 1
name = "base"

[materials.ice]
restitution = 0.5

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]

[[bodies]]
name = "brick"
shape.box.size = [1.0, 2.0, 3.0]
mass = 6.0
position = [0, 0, 10]
material = "ice"
"#;

/// The scene that `text` describes.
pub(crate) fn scene(text: &str) -> Scene {
    load_text("test.toml", text, &[]).unwrap_or_else(|error| panic!("{error}")).scene
}

/// What is refused of `text`.
pub(crate) fn refused(text: &str) -> Box<Refused> {
    match load_text("test.toml", text, &[]) {
        Ok(_) => panic!("accepted:\n{text}"),
        Err(SceneFileError::Refused(refused)) => refused,
        Err(error) => panic!("{error}"),
    }
}

/// Checks that `text` is refused at `key`, on the line that holds `shown`, with a message that holds `message`.
#[track_caller]
pub(crate) fn check(text: &str, key: &str, shown: &str, message: &str) {
    let refused = refused(text);
    let rendered = refused.to_string();
    assert_eq!(refused.place.key, key, "{rendered}");
    let line = text.lines().nth(refused.place.line - 1).unwrap();
    assert!(line.contains(shown), "line {}: {line}\n{rendered}", refused.place.line);
    assert!(rendered.contains(message), "{rendered}");
    assert!(rendered.contains(&format!("test.toml:{}:{}", refused.place.line, refused.place.column)), "{rendered}");
}
